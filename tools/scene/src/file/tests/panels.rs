//! Scenes on other panels than their own.

use super::{ACTOR, parse_at, path, read};
use crate::description::{ColourFormat, PanelDithering, Projection, Scene};
use crate::panel::{Panel, Screen};

fn on(panel: &str, dithering: Option<PanelDithering>, text: &str) -> Scene {
    let panel = *Panel::named(panel).unwrap();
    let screen = Screen { panel, dithering };
    parse_at(&path(), &format!("{text}\n{ACTOR}"), Some(screen)).unwrap()
}

fn view_angle(scene: &Scene) -> f64 {
    match scene.camera.projection {
        Projection::Perspective { view_angle } => view_angle,
        Projection::Parallel { parallel_scale } => parallel_scale,
    }
}

#[test]
fn size_and_colour_are_the_panels() {
    let text = "[display]\nwidth = 100\nheight = 50\nbackground = \"#102030\"\n\
                colour = \"mono\"\ndithering = \"bayer8\"";
    let scene = on("ssd1327-128x128", None, text);
    assert_eq!((scene.display.width, scene.display.height), (128, 128));
    assert_eq!(scene.display.colour, ColourFormat::Gray4);
    assert_eq!(scene.display.dithering, PanelDithering::Bayer8);
    let own = read(&format!("{text}\n{ACTOR}")).unwrap();
    assert_eq!(scene.display.background, own.display.background);
    let asked = Some(PanelDithering::BlueNoise);
    let scene = on("ssd1327-128x128", asked, text);
    assert_eq!(scene.display.dithering, PanelDithering::BlueNoise);
    // In colour there is nothing to mix.
    let scene = on("st7789-240x240", asked, text);
    assert_eq!(scene.display.dithering, PanelDithering::None);
}

#[test]
fn a_scene_without_a_palette_gets_one_on_a_grey_panel() {
    let text = "[palette]\ndirect = true";
    assert!(on("st7789-240x240", None, text).palette.direct);
    assert!(!on("ssd1306-128x64", None, text).palette.direct);
}

#[test]
fn nothing_is_lost_in_width() {
    let placed = "[camera]\nposition = [0, 0, 9]\nview_angle = 40";
    let half = |scene: &Scene| (view_angle(scene) / 2.0).to_radians().tan();
    let own = read(&format!("{placed}\n{ACTOR}")).unwrap();
    let square = on("st7789-240x240", None, placed);
    assert!((half(&square) / half(&own) - 4.0 / 3.0).abs() < 1e-12);
    let wide = on("ssd1306-128x64", None, placed);
    assert_eq!(view_angle(&wide), view_angle(&own));
    let parallel = "[camera]\nprojection = \"parallel\"\nparallel_scale = 3";
    assert_eq!(view_angle(&on("st7789-240x240", None, parallel)), 4.0);
    // What frames itself does so for the panel.
    let framed = on("st7789-240x320", None, "[camera]\nview_angle = 40");
    assert_eq!(view_angle(&framed), 40.0);
    let display = "[display]\nwidth = 240\nheight = 320\n[camera]\nview_angle = 40";
    let same = read(&format!("{display}\n{ACTOR}")).unwrap();
    assert_eq!(framed.camera, same.camera);
}
