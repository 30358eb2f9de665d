//! A frame whose palette changes: what is seen is another picture, without anything being
//! drawn again.

use fixel::Scene;
use fixel::palette::{Palette, Rgb565Table, cross_fade, fade, rgb565};
use fixel_host::{Options, render};
use fixel_tests::{load, root};

/// What a panel shows of a frame's indices through a palette.
fn panel(indices: &[u8], palette: &Palette<'_>) -> Vec<u16> {
    let mut table = Rgb565Table::new();
    table.set(palette);
    let mut pixels = vec![0; indices.len()];
    table.resolve(indices, &mut pixels);
    pixels.into_iter().map(u16::from_be).collect()
}

fn at(scene: &Scene<'_>, frame: u32) -> (Vec<u8>, Vec<u16>) {
    let options = Options {
        frame,
        ..Options::of(scene)
    };
    let indices = render(scene, &options).index;
    let pose = scene.pose(frame);
    let shown = panel(&indices, &fixel::render::palette(scene, &pose));
    (indices, shown)
}

#[test]
fn entries_that_go_round_need_no_drawing() {
    let (_, baked) = load(&root().join("scenes/palette_cycle.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let (first, shown) = at(&scene, 0);
    let mut moving = Vec::new();
    for frame in 1..8 {
        let mut pose = scene.pose(0);
        pose.palette_shift = scene.pose(frame).palette_shift;
        moving.push(panel(&first, &fixel::render::palette(&scene, &pose)));
    }
    assert!(moving.iter().any(|other| *other != shown), "it moves");
    // Once round is the picture as it was.
    let (_, count) = scene.header().cycle;
    let mut pose = scene.pose(0);
    pose.palette_shift = count;
    let round = panel(&first, &fixel::render::palette(&scene, &pose));
    assert!(round == shown);
    // The scene stands still: a frame drawn anew is the same bytes.
    assert!(at(&scene, 7) == (first, moving[6].clone()));
}

#[test]
fn a_frame_fades_and_changes_its_colours() {
    let (_, baked) = load(&root().join("scenes/teapot.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let (indices, shown) = at(&scene, 0);
    let colours = scene.palette();
    let through = |colours: &[[u8; 3]]| panel(&indices, &Palette::new(colours));
    let each = |change: &dyn Fn([u8; 3]) -> [u8; 3]| {
        let changed: Vec<[u8; 3]> = colours.iter().map(|c| change(*c)).collect();
        let pixels = indices.iter().map(|i| rgb565(changed[usize::from(*i)]));
        (through(&changed), pixels.collect::<Vec<_>>())
    };
    assert!(through(colours) == shown);

    // Another palette altogether.
    let (swapped, expected) = each(&|[r, g, b]| [b, 255 - g, r]);
    assert!(swapped == expected && swapped != shown);

    // To a colour, by steps: the first is none of it, the last all.
    let mut faded = vec![[0; 3]; colours.len()];
    fade(colours, [255, 0, 0], 0, &mut faded);
    assert!(through(&faded) == shown);
    fade(colours, [255, 0, 0], 256, &mut faded);
    assert!(through(&faded).iter().all(|pixel| *pixel == 0xF800));

    // From one palette to another.
    let other: Vec<[u8; 3]> = colours.iter().map(|[r, g, b]| [*g, *b, *r]).collect();
    cross_fade(colours, &other, 256, &mut faded);
    assert!(through(&faded) == through(&other));
}
