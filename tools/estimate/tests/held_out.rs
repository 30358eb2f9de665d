//! Estimates against counts of scenes that nothing was fitted to.

use std::collections::BTreeMap;
use std::path::Path;

use fixel_estimate::{BOARDS, Board, Estimate, Layout, Lists, Model, Parts, Wire};

/// How far off an estimate may be, in percent.
const MOST_PERCENT: f64 = 15.0;

fn baked(name: &str) -> fixel_bake::Baked {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut places = ["", "bench", "small"].map(|folder| scenes.join(folder));
    for place in &mut places {
        place.push(format!("{name}.toml"));
    }
    let place = places.iter().find(|place| place.exists());
    let place = place.unwrap_or_else(|| panic!("no scene is called {name}"));
    fixel_bake::bake(&fixel_scene::load(place).unwrap()).unwrap()
}

#[test]
fn estimates_are_near_counts_that_nothing_was_fitted_to() {
    let model = Model::fitted().unwrap();
    let mut by_scene: BTreeMap<&str, Vec<_>> = BTreeMap::new();
    for count in &model.held_out {
        by_scene.entry(&count.scene).or_default().push(count);
    }
    assert!(by_scene.len() >= 10, "{:?}", by_scene.keys());
    let mut wrong = Vec::new();
    for (name, counts) in by_scene {
        let baked = baked(name);
        let scene = baked.scene().unwrap();
        let mut works = BTreeMap::new();
        for count in counts {
            let key = (count.frame, count.band_rows);
            let work = works
                .entry(key)
                .or_insert_with(|| fixel_estimate::work(&scene, &scene.pose(key.0), key.1));
            let estimate = model.instructions(&count.target, work).unwrap();
            let off = 100.0 * (estimate / count.instructions as f64 - 1.0);
            if off.abs() > MOST_PERCENT {
                wrong.push(format!("{count:?}: {estimate:.0}, {off:+.1} %"));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "after a change of speed, `cargo xtask fit` makes the coefficients anew:\n{}",
        wrong.join("\n")
    );
}

#[test]
fn every_board_can_be_estimated() {
    let model = Model::fitted().unwrap();
    let baked = baked("w1_teapot_flat");
    let scene = baked.scene().unwrap();
    let pose = scene.pose(0);
    for board in &BOARDS {
        let bytes = baked.bytes().len() as u64;
        let layout = Layout::ROOMY;
        let estimate = Estimate::new(&model, board, &scene, (&pose, layout), bytes).unwrap();
        assert_eq!(estimate.parts, Parts::Flat, "{}", board.name);
        assert!(estimate.frames_a_second > 0.5, "{}", board.name);
        assert!(estimate.flash_bytes() > bytes && estimate.ram_bytes() > 10_000);
        // Where both bands fit, the slower of drawing and sending decides, and a part of the
        // other.
        let slower = estimate.drawing_s.max(estimate.sending_s);
        assert!(1.0 / estimate.frames_a_second >= slower);
    }
    let unknown = Board::find("pico").unwrap_err();
    assert!(unknown.contains("rp2040-st7789"), "{unknown}");
}

/// Demos of this repository that run in so little.
#[test]
fn a_small_board_gets_what_its_ram_holds() {
    let model = Model::fitted().unwrap();
    let fitted = |board: &str, scene: &str, panel: &str, rows| {
        let board = Board::find(board).unwrap();
        let panel = *fixel_scene::Panel::named(panel).unwrap();
        let screen = fixel_scene::Screen {
            panel,
            dithering: None,
        };
        let baked = baked(scene).on(&screen).unwrap();
        let scene = baked.scene().unwrap();
        let (pose, bytes) = (scene.pose(0), baked.bytes().len() as u64);
        let estimate = Estimate::fitting(&model, board, &scene, (&pose, rows), bytes).unwrap();
        let fits = estimate.ram_bytes() <= board.ram_bytes;
        (fits, estimate)
    };
    let (fits, roomy) = fitted("rp2040-st7789", "teapot", "st7789-320x240", None);
    assert!(fits && roomy.layout == Layout::ROOMY, "{roomy:?}");
    let (fits, microbit) = fitted("microbit", "teapot_128x64", "ssd1306-128x64", None);
    assert!(fits && microbit.ram_bytes() > 8 << 10, "{microbit:?}");
    let (fits, pill) = fitted("stm32f103c8", "teapot", "st7789-320x240", None);
    assert!(fits && pill.layout.wire == Wire::Rows, "{pill:?}");
    // Less room is not faster.
    let (_, same) = fitted("stm32f405", "teapot", "st7789-320x240", None);
    assert!(pill.instructions > same.instructions);
    // Rows that were asked for stay, though they do not fit.
    let (fits, tall) = fitted("microbit", "teapot", "st7789-320x240", Some(60));
    assert!(!fits && tall.layout.band_rows == 60, "{tall:?}");
    assert_eq!(tall.layout.lists, Lists::Shortest);
}
