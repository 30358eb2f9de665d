#![no_std]
#![no_main]

mod board;

use embedded_graphics::prelude::*;
use fixel::{DrawTargetDisplay, Renderer, Scene};

static SCENE: &[u8] = fixel::include_scene!(OUT_DIR, "scene.fxl");

#[cortex_m_rt::entry]
fn main() -> ! {
    static mut RENDERER: Renderer<{ board::WIDTH }, 16> = Renderer::new();
    let scene = Scene::embedded(SCENE).unwrap();
    let mut panel = DrawTargetDisplay::new(board::display(), Point::zero());
    let mut frame = 0;
    loop {
        RENDERER.draw(&scene, &scene.pose(frame), &mut panel).unwrap();
        frame += 1;
    }
}
