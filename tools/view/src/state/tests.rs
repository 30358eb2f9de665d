use super::*;
use crate::keys::named;
use fixel_scene::{Projection, Representation};

fn state(scene: &str) -> State {
    let path = format!("{}/../../scenes/{scene}.toml", env!("CARGO_MANIFEST_DIR"));
    let scene = fixel_scene::load(path.as_ref()).expect("a scene");
    State::new(Arc::new(Source { scene, baked: None }))
}

fn press(state: &mut State, name: &str) -> Option<Effect> {
    state.handle(Event::Key(named(name).expect("a key"), false))
}

#[test]
fn keys_change_what_is_wanted() {
    let mut state = state("cube");
    let plain = state.job();
    for (name, representation) in [
        ("w", Representation::Wireframe),
        ("h", Representation::HiddenLine),
        ("p", Representation::Points),
        ("s", Representation::Surface),
    ] {
        assert_eq!(press(&mut state, name), None);
        assert_eq!(state.job().variant.representation, Some(representation));
        let scene = state.job().scene();
        assert_eq!(scene.actors[0].look.representation, representation);
    }
    press(&mut state, "v");
    assert_eq!(state.job().renderer, Renderer::Ray);
    for _ in 0..3 {
        press(&mut state, "v");
    }
    assert_eq!(state.job().renderer, Renderer::Raster);
    press(&mut state, "d");
    assert_eq!(state.job().show, Show::Depth);
    press(&mut state, "o");
    assert_eq!(state.job().show, Show::Overdraw);
    press(&mut state, "o");
    assert_eq!(state.job().show, Show::Picture);
    press(&mut state, "3");
    let stereo = state.job().scene().display.stereo;
    assert_eq!(stereo, Stereo::Anaglyph { eye_angle: 2.0 });
    press(&mut state, "3");
    assert_eq!(state.job().scene().display.stereo, Stereo::None);
    assert_ne!(state.job(), plain);
    assert_eq!(press(&mut state, "y"), None);
    assert_eq!(press(&mut state, "x"), Some(Effect::Screenshot));
    press(&mut state, "?");
    assert!(state.help());
    // The first closes the help.
    assert_eq!(press(&mut state, "Esc"), None);
    assert_eq!(press(&mut state, "q"), Some(Effect::Quit));
}

#[test]
fn panels_go_round_with_the_scenes_own() {
    let mut state = state("cube");
    let own = state.size();
    press(&mut state, "N");
    assert_eq!(state.size(), [240, 160], "the last");
    assert!(
        state
            .headline()
            .starts_with("gba-240x160, rgb565, by raster")
    );
    press(&mut state, "n");
    assert_eq!(state.size(), own);
    for panel in PANELS {
        press(&mut state, "n");
        let display = state.job().scene().display;
        let found = (display.width, display.height, display.colour);
        let name = panel.name;
        assert_eq!(found, (panel.width, panel.height, panel.colour), "{name}");
        assert_eq!(state.size(), [panel.width, panel.height]);
        let dithered = display.dithering != PanelDithering::None;
        assert_eq!(dithered, panel.colour.is_dithered(), "{name}");
    }
    let panel = *fixel_scene::Panel::named("ssd1306-128x64").expect("known");
    let dithering = Some(PanelDithering::Bayer4);
    state.choose_screen(Screen { panel, dithering });
    assert!(
        state
            .headline()
            .starts_with("ssd1306-128x64, mono, bayer4, ")
    );
    let before = state.job().scene().display.dithering;
    press(&mut state, "t");
    assert_ne!(state.job().scene().display.dithering, before);
    for _ in 0..4 {
        press(&mut state, "t");
    }
    assert_eq!(state.job().scene().display.dithering, before);
}

#[test]
fn the_camera_moves_and_is_reset_and_printed() {
    let mut state = state("cube");
    let own = state.scene().camera;
    assert_eq!(state.job().camera, None);
    let moves: [fn(&mut State); 6] = [
        |state| drop(press(state, "Left")),
        |state| drop(press(state, "+")),
        |state| drop(state.handle(Event::Wheel(-1.0))),
        |state| drop(state.handle(Event::Drag(Button::Left, [0.1, 0.2], false))),
        |state| drop(state.handle(Event::Drag(Button::Right, [0.0, 0.1], false))),
        |state| drop(state.handle(Event::Drag(Button::Left, [0.1, 0.2], true))),
    ];
    let mut last = own;
    for change in moves {
        change(&mut state);
        let now = state.job().camera.expect("moved");
        assert_ne!(now, last);
        // Whatever is in the scene stays between the planes.
        let [near, far] = now.clipping_range;
        assert!(0.0 < near && near < far);
        last = now;
    }
    // Panning moves what is looked at, turning does not.
    assert_ne!(last.focal_point, own.focal_point);
    let Some(Effect::Print(text)) = press(&mut state, "c") else {
        panic!("the camera is printed");
    };
    assert!(text.starts_with("[camera]\nposition = ["), "{text}");
    press(&mut state, "r");
    assert_eq!(state.job().camera, None);
}

/// Where the file's key frames have the camera, the hand takes it from.
#[test]
fn a_moving_camera_stops_where_it_is_touched() {
    let mut state = state("keyframes");
    let tracks = |scene: &Scene| {
        let tracks = scene.animation.tracks.iter();
        tracks
            .filter(|track| track.target == fixel_scene::Target::Camera)
            .count()
    };
    let scene = state.scene().clone();
    assert!(tracks(&scene) > 0);
    for _ in 0..3 {
        press(&mut state, ".");
    }
    let at = camera_at(&scene, 3);
    state.handle(Event::Drag(Button::Left, [0.0, 0.0], false));
    let touched = state.job();
    let off =
        glam::DVec3::from(touched.camera.expect("touched").position).distance(at.position.into());
    assert!(off < 1e-9, "{off}");
    assert_eq!(tracks(&touched.scene()), 0);
}

#[test]
fn parallel_cameras_zoom_too() {
    let mut state = state("cube");
    let source = Arc::get_mut(&mut state.source).expect("ours alone");
    source.scene.camera.projection = Projection::Parallel {
        parallel_scale: 2.0,
    };
    press(&mut state, "+");
    let zoomed = state.job().camera.expect("moved").projection;
    let Projection::Parallel { parallel_scale } = zoomed else {
        panic!("it stays parallel");
    };
    assert!((parallel_scale - 2.0 / 1.1).abs() < 1e-12);
}

#[test]
fn time_goes_on_when_pictures_come() {
    let mut state = state("cube");
    let length = state.scene().animation.length().expect("it turns");
    assert!(state.is_moving());
    state.handle(Event::Tick(0.1, false));
    assert_eq!(state.job().frame, 0, "the last picture is not there");
    state.handle(Event::Tick(0.0, true));
    assert_eq!(state.job().frame, 1);
    press(&mut state, "Space");
    state.handle(Event::Tick(1.0, true));
    assert_eq!((state.job().frame, state.is_moving()), (1, false));
    press(&mut state, ",");
    press(&mut state, ",");
    assert_eq!(state.job().frame, length - 1);
    press(&mut state, ".");
    assert_eq!(state.job().frame, 0);
}

#[test]
fn bands_come_one_by_one() {
    let mut state = state("cube");
    assert_eq!(state.bands(), None);
    press(&mut state, "b");
    assert_eq!(state.bands(), Some(0));
    state.handle(Event::Tick(0.2, true));
    assert_eq!(state.bands(), Some(2));
    let bands = state.size()[1].div_ceil(BAND_ROWS);
    for _ in 0..bands + 1 {
        state.handle(Event::Tick(1.0 / BANDS_A_SECOND, true));
    }
    assert_eq!(
        (state.bands(), state.job().frame),
        (Some(0), 1),
        "the next frame"
    );
    press(&mut state, "b");
    assert_eq!(state.bands(), None);
}

#[test]
fn an_error_goes_when_the_file_is_right_again() {
    let mut state = state("cube");
    let before = state.job();
    state.handle(Event::Loaded(Err("a.toml:3: wrong".into())));
    assert_eq!(state.error(), Some("a.toml:3: wrong"));
    assert_eq!(state.job(), before, "the last picture stays");
    state.handle(Event::Failed("too large".into()));
    let scene = state.scene().clone();
    press(&mut state, "Left");
    let camera = state.job().camera;
    state.handle(Event::Loaded(Ok(Arc::new(Source { scene, baked: None }))));
    assert_eq!(state.error(), None);
    assert_ne!(state.job(), before);
    assert_eq!(state.job().camera, camera, "the view stays");
    state.handle(Event::Failed("too large".into()));
    assert_eq!(state.error(), Some("too large"));
    state.handle(Event::Drawn);
    assert_eq!(state.error(), None);
}
