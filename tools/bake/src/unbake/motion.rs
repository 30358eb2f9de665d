//! Where things are, and their key frames.

use fixel::Scene as Blob;
use fixel::scene::{self as core_scene, Quantity as Core, layout};
use fixel_scene::{Actor, Animation, Key, PaletteCycle, Quantity, Target, Track};
use glam::{DMat4, DVec3};

/// World lengths to scene units.
pub(super) struct Places {
    unit: f64,
    centre: DVec3,
}

impl Places {
    pub fn of(blob: &Blob<'_>) -> Self {
        let header = blob.header();
        let centre = DVec3::from(header.world_centre.map(f64::from));
        Self {
            unit: f64::exp2(-f64::from(header.world_exponent)),
            centre: centre * f64::exp2(f64::from(header.centre_exponent)),
        }
    }

    pub fn length(&self, bits: i32) -> f64 {
        f64::from(bits) * self.unit / 65536.0
    }

    pub fn vector(&self, bits: [i32; 3]) -> DVec3 {
        DVec3::from(bits.map(|b| self.length(b)))
    }

    pub fn point(&self, bits: [i32; 3]) -> DVec3 {
        self.centre + self.vector(bits)
    }

    /// A place in the space that an actor is in.
    fn within(&self, actor: &core_scene::Actor, bits: [i32; 3]) -> DVec3 {
        match actor.parent {
            None => self.point(bits),
            Some(_) => self.vector(bits),
        }
    }

    /// Scene units a grid step.
    fn step(&self, actor: &core_scene::Actor) -> f64 {
        f64::from(actor.step_mantissa) * f64::exp2(f64::from(actor.step_exponent - 31)) * self.unit
    }

    /// A grid point q goes to position + R (offset + step q): scaled about the
    /// point whose distance to the grid's centre that is.
    fn origin(&self, actor: &core_scene::Actor) -> DVec3 {
        self.vector(actor.offset) / -self.step(actor)
    }

    /// The matrix before which a parent's own scale must come again undone, as a
    /// blob's does not hold for its children.
    fn undone(&self, parent: &core_scene::Actor) -> [[f64; 4]; 4] {
        let back = DMat4::from_translation(self.origin(parent))
            * DMat4::from_scale(DVec3::splat(1.0 / self.step(parent)));
        back.transpose().to_cols_array_2d()
    }
}

pub(super) fn actors(blob: &Blob<'_>, places: &Places) -> Vec<Actor> {
    let actor = |index: u16| {
        let actor = blob.actor(index);
        let origin = places.origin(&actor);
        let parent = actor.parent.map(|parent| blob.actor(parent));
        let place = places.within(&actor, actor.position);
        let turns = |a: u32| f64::from(a) * 360.0 / f64::exp2(32.0);
        Actor {
            name: format!("actor {}", index + 1),
            mesh: actor.mesh.into(),
            material: actor.material.into(),
            origin: origin.to_array(),
            position: (place - origin).to_array(),
            orientation: actor.orientation.map(turns),
            scale: [places.step(&actor); 3],
            matrix: parent.map_or(fixel_scene::IDENTITY, |parent| places.undone(&parent)),
            parent: actor.parent.map(usize::from),
            still: actor.still,
            part: actor.part,
            ..Actor::default()
        }
    };
    (0..blob.actor_count()).map(actor).collect()
}

pub(super) fn animation(blob: &Blob<'_>, places: &Places) -> Animation {
    let header = blob.header();
    let some = |frames: u32| (frames != 0).then_some(frames);
    Animation {
        turntable: some(header.turntable),
        frames: some(header.frames),
        tracks: blob.tracks().map(|t| track(blob, places, &t)).collect(),
        palette_cycle: match header.cycle {
            (_, 0) => None,
            (first, count) => Some(PaletteCycle {
                first: first.into(),
                last: u32::from(first) + u32::from(count) - 1,
                frames: header.cycle_frames,
            }),
        },
    }
}

fn track(blob: &Blob<'_>, places: &Places, track: &core_scene::Track) -> Track {
    let camera = track.target == layout::CAMERA;
    let value = |values: [i32; 3]| -> [f64; 3] {
        let fixed = values.map(|v| f64::from(v) / f64::exp2(24.0));
        match track.quantity {
            Core::Position if !camera => {
                let actor = blob.actor(track.target);
                let place = places.within(&actor, values);
                (place - places.origin(&actor)).to_array()
            }
            Core::Position | Core::FocalPoint => places.point(values).to_array(),
            Core::Pan => places.vector(values).to_array(),
            Core::Orientation | Core::Azimuth | Core::Elevation | Core::Roll => {
                fixed.map(|turns| turns * 360.0)
            }
            Core::Scale | Core::Dolly | Core::Zoom => fixed,
        }
    };
    Track {
        target: match track.viewport {
            Some(number) => Target::Viewport(number.into()),
            None if camera => Target::Camera,
            None => Target::Actor(track.target.into()),
        },
        quantity: quantity(track.quantity),
        keys: blob
            .keys(track)
            .map(|key| Key {
                frame: key.frame,
                value: value(key.values),
            })
            .collect(),
    }
}

fn quantity(quantity: Core) -> Quantity {
    match quantity {
        Core::Position => Quantity::Position,
        Core::FocalPoint => Quantity::FocalPoint,
        Core::Orientation => Quantity::Orientation,
        Core::Scale => Quantity::Scale,
        Core::Azimuth => Quantity::Azimuth,
        Core::Elevation => Quantity::Elevation,
        Core::Roll => Quantity::Roll,
        Core::Dolly => Quantity::Dolly,
        Core::Zoom => Quantity::Zoom,
        Core::Pan => Quantity::Pan,
    }
}
