use super::*;
use crate::draw::Drawer;
use crate::event::Event;
use crate::keys::named;
use crate::source::Source;
use std::sync::Arc;

fn state() -> State {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cube.toml");
    let scene = fixel_scene::load(path.as_ref()).expect("a scene");
    State::new(Arc::new(Source { scene, baked: None }))
}

fn look(size: [u32; 2], zoom: Option<u32>) -> Look {
    Look {
        size,
        scale: 1,
        zoom,
    }
}

#[test]
fn the_panel_is_enlarged_pixel_for_pixel() {
    let state = state();
    let picture = Drawer::default().draw(&state.job(), 1).expect("drawn");
    for scale in [1, 2] {
        let panel = state.size();
        let size = wanted(panel, scale, 2);
        assert_eq!(fitting(panel, scale, size, true), 2);
        let look = Look {
            size,
            scale,
            zoom: None,
        };
        let PanelPlace { rect, zoom } = place(&state, &look);
        let canvas = draw(&state, Some(&picture), &look);
        for (i, pixel) in picture.rgb.iter().enumerate() {
            let (x, y) = (i as u32 % picture.width, i as u32 / picture.width);
            for (dx, dy) in [(0, 0), (zoom - 1, zoom - 1)] {
                let column = rect.x as u32 + x * zoom + dx;
                let row = rect.y as u32 + y * zoom + dy;
                let found = canvas.pixels[(row * canvas.width + column) as usize];
                assert_eq!(found, crate::canvas::colour(*pixel), "{x}, {y}");
            }
        }
    }
}

#[test]
fn every_size_of_window_is_drawn() {
    let mut state = state();
    let picture = Drawer::default().draw(&state.job(), 1).expect("drawn");
    state.handle(Event::Failed("a long error ".repeat(30)));
    state.handle(Event::Key(named("F1").expect("a key"), false));
    state.handle(Event::Key(named("b").expect("a key"), false));
    for size in [[1, 1], [10, 700], [300, 200], [1000, 900]] {
        for zoom in [None, Some(1), Some(16)] {
            let canvas = draw(&state, Some(&picture), &look(size, zoom));
            assert_eq!(canvas.pixels.len(), (size[0] * size[1]) as usize);
        }
    }
}

#[test]
fn errors_help_and_bands_are_seen() {
    let mut state = state();
    let picture = Drawer::default().draw(&state.job(), 1).expect("drawn");
    let look = look(wanted(state.size(), 1, 2), None);
    let plain = draw(&state, Some(&picture), &look);
    let differs = |state: &State| draw(state, Some(&picture), &look) != plain;
    assert!(!differs(&state));
    for name in ["F1", "b", "Tab"] {
        let key = Event::Key(named(name).expect("a key"), false);
        state.handle(key.clone());
        assert!(differs(&state), "{name}");
        state.handle(key);
        assert!(!differs(&state), "{name}");
    }
    state.handle(Event::Failed("wrong: ".repeat(30)));
    assert!(differs(&state));
    // It leaves the panel alone.
    let with_error = draw(&state, Some(&picture), &look);
    let PanelPlace { rect, .. } = place(&state, &look);
    let above = ((rect.y as u32 + rect.height) * look.size[0]) as usize;
    assert_eq!(with_error.pixels[..above], plain.pixels[..above]);
    // Without a picture there is the panel, dark.
    let dark = draw(&state, None, &look);
    let PanelPlace { rect, .. } = place(&state, &look);
    let middle = (rect.y as u32 + rect.height / 2) * dark.width + rect.x as u32 + 5;
    assert_eq!(dark.pixels[middle as usize], SCREEN);
}

/// All rows of the help fit the smallest window that the program opens.
#[test]
fn the_help_fits() {
    let size = wanted([128, 64], 1, 6);
    assert!(letters(&look(size, None)) >= HELP_COLUMN);
    assert!(HELP.len() as u32 / 2 * LINE < size[1]);
    for row in HELP {
        assert!(row.keys.len() < HELP_KEYS, "{}", row.keys);
        assert!(HELP_KEYS + row.what.len() < HELP_COLUMN, "{}", row.what);
    }
}
