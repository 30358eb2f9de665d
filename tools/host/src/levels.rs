//! Which level of detail each actor is drawn with.

use fixel::Scene;
use fixel::scene::Pose;
use fixel::view::{ActorView, ViewFrame};

/// For each viewport the level of each actor in a picture of this width and height: 0 is the
/// mesh itself, 1 the first coarser one.
pub fn levels(scene: &Scene<'_>, pose: &Pose<'_>, size: (u16, u16)) -> Vec<Vec<u32>> {
    let (width, height) = scene.output().frame_size(size);
    let in_viewport = |number| {
        let viewport = scene.place_viewport(number, pose, width, height);
        let view = ViewFrame::of(&viewport);
        let level = |index| {
            let actor = scene.actor(index);
            if scene.look(index).is_some() {
                return 0;
            }
            let place = pose.place(scene, index, &actor);
            let drawn = ActorView::new(&view, scene, &actor, &place).mesh;
            let (first, count) = scene.mesh(actor.mesh).levels;
            let mut levels = first..first + u16::from(count);
            let found = levels.position(|number| scene.mesh(number) == drawn);
            found.map_or(0, |level| level as u32 + 1)
        };
        (0..scene.actor_count()).map(level).collect()
    };
    (0..scene.viewport_count()).map(in_viewport).collect()
}
