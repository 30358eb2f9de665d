use super::*;
use crate::event::{Button, Event};
use crate::keys::Key;
use crate::source::Source;
use crate::state::State;

fn source(scene: &str) -> Arc<Source> {
    let path = format!("{}/../../scenes/{scene}.toml", env!("CARGO_MANIFEST_DIR"));
    let scene = fixel_scene::load(path.as_ref()).expect("a scene");
    Arc::new(Source { scene, baked: None })
}

fn job(scene: &str) -> Job {
    State::new(source(scene)).job()
}

fn draw(job: &Job) -> Picture {
    Drawer::default().draw(job, 1).expect("drawn")
}

/// Greatest share of pixels that may differ visibly between two renderers.
fn close(a: &Picture, b: &Picture, what: &str) {
    let far = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).any(|c| a[c].abs_diff(b[c]) > 40);
    let count = a.rgb.iter().zip(&b.rgb).filter(|pair| far(*pair)).count();
    assert!(
        count * 50 < a.rgb.len(),
        "{what}: {count} of {}",
        a.rgb.len()
    );
}

#[test]
fn a_picture_is_what_the_panel_shows() {
    let job = job("cube");
    let picture = draw(&job);
    let baked = fixel_bake::bake(&job.source.scene).expect("baked");
    let core = baked.scene().expect("whole");
    let planes = fixel_host::render(&core, &Options::of(&core));
    assert_eq!(picture.rgb, fixel_host::picture(&core, &planes).0);
    assert!(picture.whole);
    assert!(
        picture.figures[0].starts_with("12 triangles"),
        "{:?}",
        picture.figures
    );
}

/// What is reckoned for a board follows the eye, and the panel that is shown.
#[test]
fn a_frame_is_reckoned_for_the_chosen_board() {
    let reckoned = |state: &State| draw(&state.job()).figures.pop().expect("a figure");
    let mut state = State::new(source("teapot"));
    let far = reckoned(&state);
    assert!(far.starts_with("rp2040-st7789: about "), "{far}");
    state.handle(Event::Wheel(2.0));
    let near = reckoned(&state);
    assert_ne!(near, far);
    state.handle(Event::Key(Key::Char('K'), false));
    let other = reckoned(&state);
    assert!(other.starts_with("gba: about "), "{other}");
    let small = fixel_scene::Panel::named("ssd1306-128x64").expect("a panel");
    state.choose_screen(fixel_scene::Screen {
        panel: *small,
        dithering: None,
    });
    assert_ne!(reckoned(&state), other);
}

/// A camera that is moved by hand shows in all renderers the same.
#[test]
fn renderers_agree_from_where_the_user_looks() {
    let mut state = State::new(source("cube"));
    state.handle(Event::Drag(Button::Left, [0.2, 0.1], false));
    state.handle(Event::Drag(Button::Middle, [0.1, 0.1], false));
    state.handle(Event::Wheel(1.0));
    let mut job = state.job();
    let raster = draw(&job);
    for renderer in [Renderer::Ray, Renderer::Reference, Renderer::RayReference] {
        job.renderer = renderer;
        close(&raster, &draw(&job), renderer.name());
    }
    // As it would be from a file with this camera, whose palette is another.
    let scene = job.scene();
    let baked = fixel_bake::bake(&scene).expect("baked");
    let core = baked.scene().expect("whole");
    let planes = fixel_host::render(&core, &Options::of(&core));
    let rgb = fixel_host::picture(&core, &planes).0;
    close(
        &raster,
        &Picture {
            rgb,
            ..raster.clone()
        },
        "from a file",
    );
}

#[test]
fn a_moved_camera_shows_without_a_palette_too() {
    let mut state = State::new(source("direct"));
    let still = draw(&state.job());
    state.handle(Event::Drag(Button::Left, [0.3, 0.0], false));
    let moved = draw(&state.job());
    assert_ne!(still.rgb, moved.rgb);
}

#[test]
fn depth_ids_meshlets_and_overdraw_cover_what_the_picture_does() {
    let mut job = job("cube");
    let mut seen = Vec::new();
    for show in [Show::Depth, Show::Actors, Show::Meshlets, Show::Overdraw] {
        job.show = show;
        let picture = draw(&job);
        let nothing = picture.rgb[0];
        let covered = picture.rgb.iter().filter(|c| **c != nothing).count();
        assert!(covered > 1000, "{show:?}");
        seen.push(covered);
    }
    assert!(seen.iter().all(|covered| *covered == seen[0]), "{seen:?}");
    job.renderer = Renderer::Ray;
    assert!(Drawer::default().draw(&job, 1).is_err());
    job.show = Show::Actors;
    close(
        &draw(&job),
        &draw(&Job {
            renderer: Renderer::Raster,
            ..job.clone()
        }),
        "ids by rays",
    );
    job.renderer = Renderer::Reference;
    close(
        &draw(&job),
        &draw(&Job {
            renderer: Renderer::Raster,
            ..job.clone()
        }),
        "ids of the truth",
    );
}

/// A convex body is drawn once; two behind each other up to twice.
#[test]
fn overdraw_counts() {
    let mut job = job("cube");
    job.show = Show::Overdraw;
    let figures = draw(&job).figures;
    assert!(
        figures
            .iter()
            .any(|line| line.starts_with("drawn 1.00 times")),
        "{figures:?}"
    );
    job.source = source("crossing");
    let figures = draw(&job).figures;
    assert!(
        !figures
            .iter()
            .any(|line| line.starts_with("drawn 1.00 times")),
        "{figures:?}"
    );
}

#[test]
fn a_coarse_picture_is_as_large() {
    let mut job = job("cube");
    job.renderer = Renderer::Reference;
    let fine = draw(&job);
    let coarse = Drawer::default().draw(&job, 4).expect("drawn");
    assert!(!coarse.whole && fine.whole);
    assert_eq!(coarse.rgb.len(), fine.rgb.len());
    let row = coarse.width as usize;
    assert_eq!(coarse.rgb[..row], coarse.rgb[3 * row..4 * row]);
}

/// Every variant that keys lead to can be drawn, anti-aliased scenes and viewports too.
#[test]
fn other_panels_and_representations() {
    use fixel_scene::Representation::{HiddenLine, Points, Wireframe};
    let mut drawer = Drawer::default();
    for scene in ["cube", "antialiased", "viewports"] {
        let mut job = job(scene);
        let own = drawer.draw(&job, 1).expect("drawn").rgb;
        for representation in [Wireframe, HiddenLine, Points] {
            job.variant.representation = Some(representation);
            let other = drawer.draw(&job, 1).expect("drawn").rgb;
            assert_ne!(other, own, "{scene}, {representation:?}");
        }
        job.variant.representation = None;
        job.variant.stereo = Some(true);
        drawer.draw(&job, 1).expect("two eyes");
        job.show = Show::Depth;
        drawer.draw(&job, 1).expect("two eyes' depth");
        job.show = Show::Picture;
        job.variant.stereo = None;
        let found = fixel_scene::PANELS
            .iter()
            .position(|panel| panel.name == "ssd1306-128x64");
        job.variant.panel = found;
        let mono = drawer.draw(&job, 1).expect("drawn");
        assert_eq!((mono.width, mono.height), (128, 64));
        let two = |c: &[u8; 3]| [[0; 3], [255; 3]].contains(c);
        assert!(mono.rgb.iter().all(two), "{scene}");
    }
}
