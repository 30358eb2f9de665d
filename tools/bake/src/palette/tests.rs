use fixel_scene::{Ramp as Asked, Shading, Texturing};
use glam::{DVec2, DVec3};

use super::light::{Point, lit};
use super::nearest::COLOURS;
use super::*;
use crate::oklab::{distance2, from_rgb};

/// A sphere under a red light from the left and a blue one from the right, with a
/// white highlight.
fn scene() -> Scene {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/tiny_128x64.toml");
    let mut scene = fixel_scene::load(path.as_ref()).unwrap();
    let mesh = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenes/meshes/sphere.obj"
    );
    scene.meshes = vec![fixel_scene::load_mesh(mesh.as_ref()).unwrap()];
    scene.actors.truncate(1);
    scene.actors[0].mesh = 0;
    scene.actors[0].material = 0;
    scene.materials.truncate(1);
    scene.materials[0] = Material {
        specular: 0.5,
        specular_power: 20.0,
        shading: Shading::Phong,
        ..Material::default()
    };
    scene.lights = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        .into_iter()
        .zip([[1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]])
        .map(|(colour, direction)| Light {
            kind: LightKind::Directional { direction },
            colour,
            intensity: 1.0,
            edges: None,
        })
        .collect();
    scene.display.background = Background::Solid([0.0, 0.25, 0.0]);
    scene
}

/// The same in grey.
fn grey() -> Scene {
    let mut scene = scene();
    scene.materials[0].specular = 0.0;
    for light in &mut scene.lights {
        light.colour = [0.5; 3];
    }
    scene
}

fn way(change: impl Fn(&mut Scene)) -> Way {
    let mut scene = grey();
    change(&mut scene);
    Way::of(&scene, 0)
}

#[test]
fn what_lies_on_one_line_goes_by_level() {
    let red = [1.0, 0.0, 0.0];
    assert_eq!(way(|_| ()), Way::Level);
    assert_eq!(way(|scene| scene.ambient = red), Way::Level);
    assert_eq!(
        way(|scene| scene.materials[0].diffuse_colour = red),
        Way::Level
    );
    assert_eq!(way(|scene| scene.lights[1].colour = red), Way::Colour);
    assert_eq!(
        way(|scene| {
            scene.lights[1].colour = red;
            scene.lights[1].intensity = 0.0;
        }),
        Way::Level
    );
    assert_eq!(way(|scene| scene.materials[0].specular = 0.1), Way::Level);
    let shiny = |scene: &mut Scene| {
        scene.materials[0].specular = 0.1;
        scene.materials[0].diffuse_colour = red;
    };
    assert_eq!(way(shiny), Way::Colour);
    // Two lights of a half, as bright together as one from between them.
    let brown = |scene: &mut Scene| scene.materials[0].diffuse_colour = [0.5, 0.3, 0.0];
    assert_eq!(way(brown), Way::Level);
    let bright = |scene: &mut Scene| scene.lights[0].intensity = 2.5;
    assert_eq!(way(bright), Way::Level);
    assert_eq!(
        way(|scene| {
            brown(scene);
            bright(scene);
        }),
        Way::Colour
    );
    let paint = |scene: &mut Scene| {
        scene.meshes[0].colours = vec![red; scene.meshes[0].positions.len()];
    };
    assert_eq!(way(paint), Way::Colour);
    // On another's mesh they do not matter.
    assert_eq!(
        way(|scene| {
            paint(scene);
            scene.materials.push(Material::default());
            scene.actors[0].material = 1;
        }),
        Way::Level
    );
}

#[test]
fn light_is_as_the_material_says() {
    let mut scene = scene();
    let material = Material {
        ambient_colour: [0.0, 1.0, 0.0],
        diffuse_colour: [1.0, 0.5, 0.0],
        specular_colour: [0.0, 0.0, 1.0],
        ambient: 0.25,
        diffuse: 0.5,
        specular: 0.5,
        specular_power: 2.0,
        emission: 0.125,
        ..Material::default()
    };
    let point = Point {
        place: DVec3::ZERO,
        normal: DVec3::Z,
        tint: DVec3::new(1.0, 1.0, 0.5),
        coordinates: DVec2::ZERO,
    };
    scene.ambient = [1.0, 0.5, 1.0];
    let spot = |cone_angle| Light {
        // 2 away, 60 degrees off the normal; its axis 60 degrees off the way here.
        kind: LightKind::Spot {
            position: [3f64.sqrt(), 0.0, 1.0],
            direction: [0.0, 0.0, -1.0],
            attenuation: [0.0, 0.25, 0.125],
            cone_angle,
            exponent: 2.0,
        },
        colour: [1.0, 1.0, 0.5],
        intensity: 4.0,
        edges: None,
    };
    let without = DVec3::new(0.125, 0.0625 + 0.125, 0.0);
    for (cone_angle, beam) in [(59.9, 0.0), (60.1, 0.25)] {
        scene.lights = vec![spot(cone_angle)];
        // The mirror image is 60 degrees off the eye: a quarter to the power of 2.
        let light = DVec3::new(4.0, 4.0, 2.0) * beam;
        let wanted = light * DVec3::new(0.25, 0.125, 0.5 * 0.25) + without;
        let lit = lit(&scene, &material, &point, DVec3::Z);
        let found = lit.own + lit.gloss;
        assert!(found.distance(wanted) < 1e-9, "{found} {wanted}");
    }
}

#[test]
fn samples_are_what_is_seen() {
    let samples = surface::samples(&scene());
    assert!((1500..=4200).contains(&samples.len()), "{}", samples.len());
    let sum: f64 = samples.iter().map(|sample| sample.weight).sum();
    assert!((sum - 1.0).abs() < 1e-9);
    let some = |test: fn(Rgb) -> bool| samples.iter().any(|sample| test(sample.colour));
    assert!(some(|[r, _, b]| r > 0.95 && b < 0.6));
    assert!(some(|[r, _, b]| b > 0.95 && r < 0.6));
    assert!(!some(|[_, g, _]| g > 0.0));
    // From behind, where neither light gets to.
    let mut behind = scene();
    let [eye, focus] = [behind.camera.position, behind.camera.focal_point];
    behind.camera.position = [0, 1, 2].map(|i| 2.0 * focus[i] - eye[i]);
    let dark = surface::samples(&behind);
    let unlit = dark
        .iter()
        .filter(|sample| sample.colour == [0.0; 3])
        .count();
    assert!(unlit * 4 > dark.len(), "{unlit} of {}", dark.len());
}

#[test]
fn a_coloured_scene_finds_its_colours_in_the_palette() {
    let scene = scene();
    for (most, limit) in [(256, 0.04), (32, 0.09), (8, 0.3)] {
        let mut scene = scene.clone();
        scene.palette.colours = most;
        let tables = tables(&scene, &[], false, &[]);
        assert!(tables.palette.len() <= most as usize);
        assert!(tables.palette.len() * 10 >= most as usize * 9);
        assert_eq!(tables.paths, [Path::Colour]);
        assert!(tables.shades.is_empty());
        assert_eq!(tables.colours.len(), COLOURS);
        // The background has an entry (nearly) of its own.
        let entry = |index: u8| to_unit(tables.palette[usize::from(index)]);
        let off = distance2(
            from_rgb(entry(tables.background[0])),
            from_rgb([0.0, 0.25, 0.0]),
        );
        assert!(off.sqrt() < limit / 2.0, "{most}: {off}");
        let nearest = Nearest::new(&tables.palette);
        for sample in surface::samples(&scene) {
            let entry = entry(nearest.index(sample.colour));
            let off = distance2(from_rgb(entry), from_rgb(sample.colour)).sqrt();
            assert!(off < limit, "{most}: {:?} {entry:?} {off}", sample.colour);
        }
    }
}

#[test]
fn the_table_of_colours_names_the_nearest_entry() {
    let mut scene = scene();
    scene.palette.fixed = vec![[0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 0, 200]];
    let tables = tables(&scene, &[], false, &[]);
    assert_eq!(tables.palette, scene.palette.fixed);
    let at = |r: usize, g: usize, b: usize| tables.colours[r << 8 | g << 4 | b];
    assert_eq!([at(0, 0, 0), at(15, 15, 15), at(15, 0, 0)], [0, 1, 2]);
    assert_eq!([at(0, 0, 12), at(14, 2, 1), at(13, 14, 15)], [3, 2, 1]);
    assert_eq!(at(1, 1, 1), 0);
}

#[test]
fn asked_for_entries_come_first() {
    let ramp = Asked {
        from: [0.0; 3],
        to: [1.0; 3],
        steps: 5,
    };
    for mut scene in [scene(), grey()] {
        scene.palette.colours = 20;
        scene.palette.ramps = vec![ramp];
        let palette = tables(&scene, &[], false, &[]).palette;
        assert!((15..=20).contains(&palette.len()), "{}", palette.len());
        assert_eq!((palette[0], palette[4]), ([0; 3], [255; 3]));
        // Even steps of lightness, hence of its cube root.
        for (entry, lightness) in palette[..5].iter().zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
            let [l, a, b] = from_rgb(to_unit(*entry));
            assert!((l - lightness).abs() < 0.01 && a.abs() < 0.01 && b.abs() < 0.01);
        }
        scene.palette.colours = 5;
        assert_eq!(tables(&scene, &[], false, &[]).palette, palette[..5]);
    }
}

#[test]
fn a_light_without_bound_takes_all_levels() {
    let mut scene = grey();
    let kind = LightKind::Point {
        position: [0.0; 3],
        attenuation: [0.0, 1.0, 0.0],
    };
    scene.lights[0].kind = kind;
    assert_eq!(reachable_levels(&scene.materials[0], &scene), (0, 255));
    scene.materials[0].diffuse = 0.0;
    scene.materials[0].emission = 0.5;
    assert_eq!(reachable_levels(&scene.materials[0], &scene), (127, 128));
    assert_eq!(tables(&scene, &[], false, &[]).paths, [Path::Level(0)]);
}

/// The sphere in grey light, the upper half of it red, the lower half blue.
fn textured() -> Scene {
    let mut scene = grey();
    scene.textures = vec![fixel_scene::Texture {
        name: "two".into(),
        width: 1,
        height: 2,
        texels: vec![[255, 0, 0, 255], [0, 0, 255, 255]],
    }];
    scene.materials[0].texture = Some(Texturing {
        mipmaps: false,
        ..Texturing::new(0)
    });
    scene.materials[0].ambient = 0.25;
    let mesh = &mut scene.meshes[0];
    let v = |p: &[f64; 3]| [0.0, 0.5 + 0.4 * p[1]];
    mesh.texture_coordinates = mesh.positions.iter().map(v).collect();
    scene
}

#[test]
fn textures_go_by_level_if_each_texel_starts_at_black() {
    let way = |change: fn(&mut Scene)| {
        let mut scene = textured();
        change(&mut scene);
        Way::of(&scene, 0)
    };
    assert_eq!(way(|_| ()), Way::Level);
    assert_eq!(way(|scene| scene.ambient = [1.0, 0.0, 0.0]), Way::Colour);
    assert_eq!(
        way(|scene| scene.materials[0].ambient_colour = [0.5; 3]),
        Way::Colour
    );
    assert_eq!(way(|scene| scene.materials[0].specular = 0.5), Way::Colour);
    assert_eq!(
        way(|scene| scene.lights[0].colour = [1.0, 0.0, 0.0]),
        Way::Colour
    );
    assert_eq!(
        way(|scene| {
            scene.ambient = [1.0, 0.0, 0.0];
            scene.materials[0].ambient = 0.0;
        }),
        Way::Level
    );
}

#[test]
fn texels_have_their_shades() {
    let scene = textured();
    let samples = surface::samples(&scene);
    let of = |channel: usize| {
        let other = 2 - channel;
        let only = |s: &&Sample| s.colour[channel] > 0.2 && s.colour[other] == 0.0;
        samples.iter().filter(only).count()
    };
    assert_eq!(of(0) + of(2), samples.len());
    assert!(of(0).min(of(2)) * 8 > samples.len());

    let bases = [[0, 0, 255], [255, 0, 0]];
    let tables = tables(&scene, &bases, false, &[]);
    assert_eq!(tables.paths, [Path::Textured(0)]);
    assert!(tables.colours.is_empty() && tables.shades.is_empty());
    let [shades] = &tables.texture_shades[..] else {
        panic!("one table");
    };
    assert_eq!(shades.len(), TEXTURE_LEVELS * 2);
    // The camera sees nothing that is darker or lighter. A row is up to 2 levels off, an entry 2.
    for level in 140..244 {
        let row = level * TEXTURE_LEVELS / 256;
        let shown = [0, 1].map(|base| tables.palette[usize::from(shades[2 * row + base])]);
        for (shown, base) in shown.iter().zip(bases) {
            let wanted = base.map(|c| f64::from(c) / 255.0 * level as f64);
            let off = [0, 1, 2].map(|c| (f64::from(shown[c]) - wanted[c]).abs());
            assert!(
                off.iter().all(|off| *off <= 4.0),
                "{level} {shown:?} {wanted:?}"
            );
        }
    }
}

#[test]
fn lines_have_their_colours_too() {
    let mut scene = scene();
    let green = [0.0, 1.0, 0.0];
    scene.materials.push(Material {
        diffuse_colour: green,
        diffuse: 0.0,
        emission: 1.0,
        ..Material::default()
    });
    let mut lines = scene.actors[0].clone();
    lines.material = 1;
    lines.look.representation = fixel_scene::Representation::Wireframe;
    scene.actors.push(lines);
    assert!(surface::samples(&scene).iter().any(|s| s.colour == green));
    assert!(
        tables(&scene, &[], false, &[])
            .palette
            .contains(&[0, 255, 0])
    );
}

#[test]
fn samples_of_a_texture_are_of_the_copies_that_are_seen() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenes/textured_often.toml"
    );
    let mut scene = fixel_scene::load(path.as_ref()).unwrap();
    // One texel black, one white: far away, or between two, nothing but grey.
    scene.textures[0].width = 2;
    scene.textures[0].height = 2;
    scene.textures[0].texels = [0, 255, 255, 0].map(|v| [v, v, v, 255]).to_vec();
    let greys = |scene: &Scene| {
        let samples = surface::samples(scene);
        let brightest = samples.iter().map(|s| s.colour[0]).fold(0.0, f64::max);
        let grey = |colour: &Rgb| (0.4..0.6).contains(&(colour[0] / brightest));
        let grey = samples.iter().filter(|s| grey(&s.colour));
        grey.map(|sample| sample.weight).sum::<f64>()
    };
    let mut how = scene.materials[0].texture.unwrap();
    assert!(greys(&scene) > 0.3, "{}", greys(&scene));
    how.filter = fixel_scene::Filter::Nearest;
    scene.materials[0].texture = Some(how);
    assert!((0.1..0.9).contains(&greys(&scene)), "{}", greys(&scene));
    how.mipmaps = false;
    scene.materials[0].texture = Some(how);
    assert_eq!(greys(&scene), 0.0);
}

/// A picture has about as many samples however small a part of a surface it shows.
#[test]
fn a_close_parallel_camera_takes_no_more_samples() {
    let count = |parallel_scale: f64| {
        let mut scene = scene();
        scene.camera.projection = fixel_scene::Projection::Parallel { parallel_scale };
        surface::samples(&scene).len()
    };
    let (all, part) = (count(1.0), count(0.001));
    assert!(all > 1000 && part < 4 * all, "{all}, {part}");
}
