//! Textures on surfaces, against values worked out by hand.

mod common;

use common::*;
use fixel_reference::{Frame, Hit, Lookup, Path, compare};
use fixel_scene::{
    Cull, Filter, LightKind, Mesh, Projection, Scene, Shading, Texture, Texturing, Wrap,
};

/// A texture of `width` columns in which the red of a texel is its number by rows.
fn numbered(width: u32, height: u32) -> Texture {
    Texture {
        name: "numbered".into(),
        width,
        height,
        texels: (0..width * height)
            .map(|i| [i as u8, 100, 255 - i as u8, 255])
            .collect(),
    }
}

/// Nearest texels of the picture itself, repeated.
fn nearest() -> Texturing {
    Texturing {
        filter: Filter::Nearest,
        mipmaps: false,
        ..Texturing::new(0)
    }
}

/// Emission alone: what is seen is the texture's colour.
fn shining(mut scene: Scene, texture: Texture, how: Texturing) -> Scene {
    scene.textures = vec![texture];
    scene.materials[0].texture = Some(how);
    scene.materials[0].diffuse = 0.0;
    scene.materials[0].emission = 1.0;
    scene
}

fn with_places(mut mesh: Mesh, place: impl Fn([f64; 3]) -> [f64; 2]) -> Mesh {
    mesh.texture_coordinates = mesh.positions.iter().map(|p| place(*p)).collect();
    mesh
}

fn bytes(hit: &Hit) -> [i32; 3] {
    hit.colour.map(|c| (c * 255.0).round() as i32)
}

/// Pixels 0..4 by 0..2 show texels 0..4 by 0..2, one each.
fn pixel_for_pixel(how: Texturing) -> Scene {
    let mut scene = shining(parallel(4, 2), numbered(4, 2), how);
    let rect = screen_rect([0.0, 0.0], [4.0, 2.0], 0.0);
    add(
        &mut scene,
        with_places(rect, |[x, y, _]| [x / 4.0, 1.0 + y / 2.0]),
    );
    scene
}

#[test]
fn a_picture_is_upright() {
    for filter in [Filter::Nearest, Filter::Bilinear] {
        for (shading, mipmaps) in [
            (Shading::Flat, true),
            (Shading::Gouraud, false),
            (Shading::Phong, true),
        ] {
            let mut scene = pixel_for_pixel(Texturing {
                filter,
                mipmaps,
                ..nearest()
            });
            scene.materials[0].shading = shading;
            let truth = truth(&scene);
            for number in 0..8 {
                let hit = truth.hit(number % 4, number / 4).unwrap();
                let number = number as i32;
                assert_eq!(bytes(hit), [number, 100, 255 - number]);
                let [x, y] = hit.texture_place.unwrap();
                let wanted = [f64::from(number % 4) + 0.5, f64::from(number / 4) + 0.5];
                assert!((x - wanted[0]).abs() < 1e-6 && (y - wanted[1]).abs() < 1e-6);
                assert_eq!(hit.texel, Some(hit.colour));
            }
        }
    }
}

#[test]
fn a_texture_multiplies_ambient_and_diffuse_colour_but_no_highlight() {
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let mut scene = pixel_for_pixel(nearest());
        scene.textures[0].texels = vec![[51, 102, 255, 255]; 8];
        let material = &mut scene.materials[0];
        material.shading = shading;
        material.emission = 0.0;
        material.ambient = 0.25;
        material.diffuse = 0.5;
        material.specular = 0.125;
        material.diffuse_colour = [1.0, 0.5, 1.0];
        material.ambient_colour = [0.0, 1.0, 1.0];
        let hit = *truth(&scene).hit(1, 1).unwrap();
        let wanted = [0.2 * 0.5 + 0.125, 0.4 * 0.5 + 0.125, 0.75 + 0.125];
        for (found, wanted) in hit.colour.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-9, "{:?} {wanted}", hit.colour);
        }
        // Each part is clamped by itself, then the sum.
        scene.lights[0].intensity = 16.0;
        let hit = *truth(&scene).hit(1, 1).unwrap();
        assert_eq!(hit.colour, [1.0, 1.0, 1.0]);
        scene.materials[0].specular = 0.0;
        let hit = *truth(&scene).hit(1, 1).unwrap();
        assert!((hit.colour[0] - 0.2).abs() < 1e-9 && (hit.colour[1] - 0.4).abs() < 1e-9);
    }
}

/// A floor that runs off from the eye, 2 above it: at row `y` of 16 below the middle
/// it is `2 * 16 / (y + 0.5)` away, looked at along -z.
fn floor(how: Texturing) -> Scene {
    let mut scene = shining(perspective(16, 32), numbered(16, 16), how);
    scene.camera.position = [0.0, 2.0, 0.0];
    scene.camera.focal_point = [0.0, 2.0, -1.0];
    scene.camera.projection = Projection::Perspective { view_angle: 90.0 };
    scene.camera.clipping_range = [1.0, 1000.0];
    let corners = [
        [-500.0, 0.0, -1.5],
        [500.0, 0.0, -1.5],
        [500.0, 0.0, -900.0],
        [-500.0, 0.0, -900.0],
    ];
    let floor = with_places(quad(corners), |[x, _, z]| [x / 16.0, -z / 16.0]);
    add(&mut scene, floor);
    scene
}

#[test]
fn in_perspective_places_are_those_of_the_surface() {
    let truth = truth(&floor(nearest()));
    for y in 17..31 {
        let away = 2.0 * 16.0 / (f64::from(y) - 16.0 + 0.5);
        for x in 0..16 {
            let hit = truth.hit(x, y).unwrap();
            let [tx, ty] = hit.texture_place.unwrap();
            let side = (f64::from(x) - 7.5) / 16.0 * away;
            assert!((tx - side).abs() < 1e-4, "{tx} {side}");
            assert!((ty - (16.0 - away)).abs() < 1e-4, "{ty} {away}");
            let texel = [tx, ty].map(|place| (place.floor() as i32).rem_euclid(16));
            assert_eq!(bytes(hit)[0], texel[1] * 16 + texel[0]);
        }
    }
}

#[test]
fn far_away_smaller_copies_stand_in() {
    let how = Texturing {
        mipmaps: true,
        ..nearest()
    };
    let truth = truth(&floor(how));
    // A pixel in row y is d/16 texels across and d/(y + 0.5) down at a distance of d.
    for (y, copy) in [(31, 0), (22, 0), (20, 1), (19, 1), (18, 2), (17, 4)] {
        let row = f64::from(y) - 16.0 + 0.5;
        let texels = 2.0 * 16.0 / row / row;
        assert_eq!((texels.log2() + 0.5).floor().max(0.0) as i32, copy, "{y}");
        let hit = truth.hit(3, y).unwrap();
        let [tx, ty] = hit.texture_place.unwrap();
        let size = 1 << copy;
        let first = [tx, ty].map(|p| ((p / f64::from(size)).floor() as i32 * size).rem_euclid(16));
        let mean = f64::from(first[1] * 16 + first[0]) + f64::from(size - 1) * 17.0 / 2.0;
        assert!((hit.colour[0] * 255.0 - mean).abs() < 1e-6, "{y}");
    }
}

#[test]
fn affine_places_are_linear_over_the_screen() {
    let how = Texturing {
        perspective: false,
        ..nearest()
    };
    // Height z rises by half a pixel along x, as in the tests of depth.
    let mut scene = shining(perspective(8, 4), numbered(16, 16), how);
    let corners = [[-4.0, -6.0], [12.0, -6.0], [12.0, 2.0], [-4.0, 2.0]];
    let plane = quad(corners.map(|[x, y]| [x, y, x / 2.0 - 2.0]));
    let plane = with_places(plane, |[x, y, _]| [x / 16.0, y / 16.0]);
    add(&mut scene, plane);
    let seen = truth(&scene);
    // The lower triangle's corners on the screen; the eye is at (4, -2, 10).
    let screen = |[x, y]: [f64; 2]| {
        let shrink = EYE / (EYE - (x / 2.0 - 2.0));
        [4.0 + (x - 4.0) * shrink, 2.0 - (y + 2.0) * shrink]
    };
    let [a, b, c] = [corners[0], corners[1], corners[2]].map(screen);
    let mut checked = 0;
    for y in 0..4 {
        for x in 0..8 {
            let hit = seen.hit(x, y).unwrap();
            if hit.triangle != 0 {
                continue;
            }
            checked += 1;
            // a and b have the same v, b and c the same u.
            let p = [f64::from(x) + 0.5, f64::from(y) + 0.5];
            let cross = |o: [f64; 2], p: [f64; 2], q: [f64; 2]| {
                (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0])
            };
            let all = cross(a, b, c);
            let [u, v] = [cross(b, c, p) / all, cross(a, b, p) / all];
            let wanted = [-4.0 * u + 12.0 * (1.0 - u), 16.0 - (-6.0 + 8.0 * v)];
            let found = hit.texture_place.unwrap();
            for axis in 0..2 {
                assert!((found[axis] - wanted[axis]).abs() < 1e-4, "{x} {y}");
            }
        }
    }
    assert!(checked > 8);
    // Cut by the near plane, they are the surface's after all.
    scene.camera.clipping_range[0] = 6.5;
    let cut = truth(&scene);
    scene.materials[0].texture = Some(nearest());
    let straight = truth(&scene);
    for (a, b) in cut.pixels().iter().zip(straight.pixels()) {
        let place = |hit: &Option<Hit>| hit.and_then(|hit| hit.texture_place);
        assert_eq!(place(a), place(b));
    }
}

#[test]
fn a_texel_that_fails_the_test_is_a_hole() {
    let mut scene = pixel_for_pixel(Texturing {
        alpha_test: 0.5,
        ..nearest()
    });
    scene.textures[0].texels[5][3] = 127;
    scene.textures[0].texels[6][3] = 128;
    // A second surface without texture behind it.
    scene.materials.push(material());
    add(&mut scene, screen_rect([0.0, 0.0], [2.0, 2.0], -1.0)).material = 1;
    let seen = truth(&scene);
    assert_eq!(seen.hit(1, 1).unwrap().actor, 1);
    assert_eq!(seen.hit(1, 1).unwrap().texture_place, None);
    assert_eq!(seen.hit(2, 1).unwrap().actor, 0);
    scene.textures[0].texels[3][3] = 0;
    assert!(truth(&scene).hit(3, 0).is_none());
    // The next surface behind a hole is not one too many.
    let margin = seen.hit(0, 0).unwrap().margin_lsb;
    assert!((margin - 65535.0 / 20.0).abs() < 1e-3 && seen.hit(1, 1).unwrap().margin_lsb > 1e9);
}

#[test]
fn a_reflected_actor_keeps_its_places() {
    let mut scene = pixel_for_pixel(nearest());
    scene.actors[0].origin = [2.0, 0.0, 0.0];
    scene.actors[0].scale = [-1.0, 1.0, 1.0];
    scene.materials[0].cull = Cull::Back;
    let truth = truth(&scene);
    for x in 0..4 {
        assert_eq!(bytes(truth.hit(x, 0).unwrap())[0], 3 - x as i32);
    }
}

#[test]
fn a_frame_is_held_against_the_bases_and_their_shades() {
    let mut scene = pixel_for_pixel(Texturing {
        wrap: Wrap::Clamp,
        ..nearest()
    });
    scene.textures[0].texels[2] = [250, 5, 5, 255];
    scene.materials[0].diffuse = 1.0;
    scene.materials[0].emission = 0.0;
    scene.lights[0].kind = LightKind::Directional {
        direction: [3f64.sqrt(), 0.0, -1.0],
    };
    let seen = truth(&scene);
    // Two bases; at level 128 (127.5, rounded) they are entries 2 and 3.
    let mut shade = vec![0; 512];
    shade[2 * 128..2 * 128 + 2].copy_from_slice(&[2, 3]);
    let lookup = Lookup {
        direct: false,
        palette: vec![[0; 3], [1; 3], [0, 50, 128], [125, 3, 3]],
        paths: vec![Path::Textured {
            bases: vec![[0, 100, 255], [255, 0, 0]],
            shade,
        }],
        colours: Vec::new(),
        fog: Vec::new(),
        background: vec![0; 8],
    };
    let mut frame = Frame::from_truth(&seen, lookup);
    assert_eq!(frame.index, [2, 2, 3, 2, 2, 2, 2, 2]);
    assert_eq!(frame.light[0], [128; 3]);
    let report = compare(&seen, &frame).unwrap();
    assert_eq!((report.texel_max, report.index_equal_percent), (0.0, 100.0));
    frame.texture_place[3][1] += 0.25;
    frame.index[0] = 3;
    let report = compare(&seen, &frame).unwrap();
    assert_eq!((report.texel_max, report.texel_mean), (0.25, 0.03125));
    assert_eq!(report.index_equal_percent, 87.5);
    frame.texture_place.clear();
    assert_eq!(compare(&seen, &frame).unwrap().texel_max, 0.0);
    frame.lookup.paths[0] = Path::Textured {
        bases: vec![[0; 3]],
        shade: vec![0; 255],
    };
    let error = compare(&seen, &frame).unwrap_err().to_string();
    assert_eq!(error, "the frame's shade has 255 elements instead of 256");
}
