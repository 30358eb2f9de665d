//! What is read.

use super::{ACTOR, parse_at, path, read, refused};
use crate::Space;
use crate::description::{
    Background, ColourFormat, Cull, Dithering, Light, LightKind, Lod, Material, Palette, Primitive,
    Projection, Ramp, Ray, Shading, Transparency,
};
use crate::texture::{Filter, Texturing, Wrap};
use crate::{mesh, picture};

#[test]
fn neutral_values_of_later_keys_are_accepted() {
    let scene = read(
        "[[actor]]\nmesh = \"meshes/cube.obj\"\nshear = [0, 0.0, 0]\n\
         representation = \"surface\"\n[camera]\nroll = 0",
    );
    scene.unwrap();
}

#[test]
fn defaults_are_vtks() {
    let scene = read(ACTOR).unwrap();
    assert_eq!((scene.display.width, scene.display.height), (320, 240));
    assert_eq!(scene.display.background, Background::Solid([0.0; 3]));
    assert_eq!(scene.palette, Palette::default());
    assert_eq!(scene.animation.turntable, None);
    assert_eq!(scene.ambient, [1.0; 3]);
    let [material] = &scene.materials[..] else {
        panic!("one default material");
    };
    assert_eq!((material.ambient, material.diffuse), (0.0, 1.0));
    assert_eq!((material.specular, material.specular_power), (0.0, 1.0));
    assert_eq!(material.emission, 0.0);
    assert_eq!(material.ambient_colour, [1.0; 3]);
    assert_eq!(material.diffuse_colour, [1.0; 3]);
    assert_eq!(material.specular_colour, [1.0; 3]);
    assert_eq!(
        (material.shading, material.cull),
        (Shading::Gouraud, Cull::Back)
    );
    // The unit cube's sphere has half its diagonal for radius.
    let distance = 0.75_f64.sqrt() / 15_f64.to_radians().sin();
    let camera = scene.camera;
    assert!((camera.position[2] - distance).abs() < 1e-12);
    assert_eq!(camera.position[..2], [0.0, 0.0]);
    assert_eq!(
        camera.projection,
        Projection::Perspective { view_angle: 30.0 }
    );
    let direction = [0.0, 0.0, -camera.position[2]];
    let headlight = Light {
        kind: LightKind::Directional { direction },
        colour: [1.0; 3],
        intensity: 1.0,
        edges: None,
    };
    assert_eq!(scene.lights, [headlight]);
}

#[test]
fn a_narrow_display_is_framed_by_its_width() {
    let text = format!("[display]\npanel = \"st7789-135x240\"\n{ACTOR}");
    let camera = read(&text).unwrap().camera;
    let half = (15_f64.to_radians().tan() * 135.0 / 240.0).atan();
    assert!((camera.position[2] - 0.75_f64.sqrt() / half.sin()).abs() < 1e-12);
}

#[test]
fn a_light_but_no_ambient_one_leaves_ambient_white() {
    let text = "[[light]]\nkind = \"directional\"\ndirection = [0, -1, 0]\nintensity = 2";
    let scene = read(&format!("{text}\n{ACTOR}")).unwrap();
    assert_eq!((scene.ambient, scene.lights.len()), ([1.0; 3], 1));
    let text = "[[light]]\nkind = \"ambient\"\ncolour = \"#333333\"\nintensity = 2";
    let scene = read(&format!("{text}\n{ACTOR}")).unwrap();
    assert_eq!((scene.ambient, scene.lights.len()), ([0.4; 3], 0));
}

#[test]
fn lights_have_vtks_meanings_and_defaults() {
    let text = "[[light]]\nkind = \"point\"\nposition = [1, 2, 3]\ncolour = \"#ff0000\"\n\
                attenuation = [0, 0.5, 2]\nintensity = 3\n\
                [[light]]\nkind = \"spot\"\nposition = [0, 4, 0]\ndirection = [0, -1, 0]\n\
                [[light]]\nkind = \"spot\"\nposition = [0, 4, 0]\ndirection = [0, -1, 0]\n\
                cone_angle = 12.5\nexponent = 0";
    let lights = read(&format!("{text}\n{ACTOR}")).unwrap().lights;
    let point = LightKind::Point {
        position: [1.0, 2.0, 3.0],
        attenuation: [0.0, 0.5, 2.0],
    };
    let spot = |cone_angle, exponent| LightKind::Spot {
        position: [0.0, 4.0, 0.0],
        direction: [0.0, -1.0, 0.0],
        attenuation: [1.0, 0.0, 0.0],
        cone_angle,
        exponent,
    };
    let kinds: Vec<LightKind> = lights.iter().map(|light| light.kind).collect();
    assert_eq!(kinds, [point, spot(30.0, 1.0), spot(12.5, 0.0)]);
    assert_eq!(lights[0].colour, [1.0, 0.0, 0.0]);
    assert_eq!((lights[0].intensity, lights[1].intensity), (3.0, 1.0));
}

#[test]
fn a_colour_is_all_three_unless_said_otherwise() {
    let text = "[[material]]\ncolour = \"#ff0000\"\nspecular = 0.5\nspecular_power = 20\n\
                shading = \"phong\"\n[[material]]\nspecular_colour = \"#ffffff\"\n\
                colour = \"#0000ff\"";
    let materials = read(&format!("{text}\n{ACTOR}")).unwrap().materials;
    let (red, blue) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let colours = |m: &Material| [m.ambient_colour, m.diffuse_colour, m.specular_colour];
    assert_eq!(colours(&materials[0]), [red; 3]);
    assert_eq!(colours(&materials[1]), [blue, blue, [1.0; 3]]);
    let shiny = &materials[0];
    assert_eq!((shiny.specular, shiny.specular_power), (0.5, 20.0));
    assert_eq!(shiny.shading, Shading::Phong);
}

#[test]
fn transparency_is_blended_unless_said_otherwise() {
    let text = "[[material]]\nopacity = 0.25\n\
                [[material]]\nopacity = 1\ntransparency = \"screen_door\"";
    let materials = read(&format!("{text}\n{ACTOR}")).unwrap().materials;
    let how = |m: &Material| (m.opacity, m.transparency);
    assert_eq!(how(&materials[0]), (0.25, Transparency::Blend));
    assert_eq!(how(&materials[1]), (1.0, Transparency::ScreenDoor));
}

#[test]
fn a_palette_has_ramps_and_dithering() {
    let text = "[palette]\ncolours = 16\ndithering = \"bayer8\"\nramps = [\n\
                { from = \"#000000\", to = \"#ff0000\", steps = 12 },\n\
                { from = \"#0000ff\", to = \"#00ff00\", steps = 4 }]";
    let palette = read(&format!("{text}\n{ACTOR}")).unwrap().palette;
    assert_eq!(palette.dithering, Dithering::Bayer8);
    let ramp = |from, to, steps| Ramp { from, to, steps };
    let ramps = [
        ramp([0.0; 3], [1.0, 0.0, 0.0], 12),
        ramp([0.0, 0.0, 1.0], [0.0, 1.0, 0.0], 4),
    ];
    assert_eq!(palette.ramps, ramps);
    assert_eq!(read(ACTOR).unwrap().palette.dithering, Dithering::Bayer4);
}

#[test]
fn panels_give_way_to_single_keys() {
    let text = "[display]\npanel = \"ssd1306-128x64\"\ncolour = \"gray4\"";
    let display = read(&format!("{text}\n{ACTOR}")).unwrap().display;
    assert_eq!((display.width, display.height), (128, 64));
    assert_eq!(display.colour, ColourFormat::Gray4);
}

#[test]
fn a_mesh_is_read_once() {
    let scene = read(&format!("{ACTOR}{ACTOR}scale = -2\n")).unwrap();
    assert_eq!((scene.meshes.len(), scene.actors.len()), (1, 2));
    assert_eq!(scene.actors[1].scale, [-2.0; 3]);
}

#[test]
fn clipping_holds_every_frame_of_a_turntable() {
    let text = "[camera]\nposition = [0, 0, 10]\n[animation]\nturntable = 8\n[[actor]]\n\
                mesh = \"meshes/cube.obj\"\nposition = [3, 0, 0]\norigin = [-3, 0, 0]";
    let [near, far] = read(text).unwrap().camera.clipping_range;
    // The cube's middle goes round the world's y axis at a distance of 3.
    let reach = (3.5_f64 * 3.5 + 0.5).sqrt();
    assert!(near < 10.0 - reach && near > 9.0 - reach);
    assert!(far > 10.0 + reach && far < 11.0 + reach);
}

#[test]
fn an_eye_inside_the_scene_has_a_sensible_near_plane() {
    let text = format!("[camera]\nposition = [0, 0, 0.1]\n{ACTOR}");
    let [near, far] = read(&text).unwrap().camera.clipping_range;
    assert_eq!(near, far * 0.01);
}

#[test]
fn cut_anywhere_a_file_never_panics() {
    let file = path().with_file_name("many_actors.toml");
    let text = std::fs::read_to_string(file).unwrap();
    let head = &text[..text.find("[[actor]]").unwrap()];
    for end in 0..head.len() {
        let _ = read(&head[..end]);
        let _ = read(&format!("{}\"\n{ACTOR}", &head[..end]));
    }
}

#[test]
fn annotations_are_actors_that_stay_where_they_are() {
    let scene = read(
        "[animation]\nturntable = 8\n[[line]]\npoints = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\n\
         closed = true\ncolour = \"#ff0000\"\n[[marker]]\nspace = \"screen\"\npoints = [[3, 4]]\n\
         [[text]]\ntext = \"a\"\nposition = [0, 0, 9]\ncolour = \"#ff0000\"",
    );
    let scene = scene.unwrap();
    assert_eq!(scene.meshes[0].edges, [[0, 1], [1, 2], [2, 0]]);
    assert_eq!(scene.meshes[1].positions, [[3.0, 4.0, 0.0]]);
    assert!(scene.actors.iter().all(|actor| actor.still));
    let materials: Vec<usize> = scene.actors.iter().map(|actor| actor.material).collect();
    assert_eq!(materials, [1, 2, 1]);
    assert_eq!(scene.materials[1].name, "unlit #ff0000");
    assert_eq!(scene.actors[1].look.space, Space::Screen);
    // The marker on the screen is not in the world, whose middle is this one.
    assert_eq!(scene.camera.focal_point, [0.5, 0.5, 4.5]);
}

#[test]
fn viewports_have_defaults() {
    let viewports = "[[viewport]]\n[[viewport]]\nrectangle = [0.7, 0.7, 0.3, 0.3]\n\
                     [viewport.camera]\nprojection = \"parallel\"\n";
    let scene = read(&format!("{viewports}{ACTOR}")).unwrap();
    let [whole, inset] = scene.viewports.as_slice() else {
        panic!("two viewports");
    };
    assert_eq!(whole.rectangle, [0.0, 0.0, 1.0, 1.0]);
    assert!(whole.camera.is_none() && whole.background.is_none());
    let camera = inset.camera.unwrap();
    assert!(matches!(camera.projection, Projection::Parallel { .. }));
    let many = "[[viewport]]\n".repeat(9);
    assert_eq!(
        refused(&many),
        "t.toml:9: viewport: is one too many; expected at most 8 [[viewport]]"
    );
}

#[test]
fn a_texture_is_a_file_or_a_table() {
    let actor = "[[actor]]\nmesh = \"meshes/cube_textured.obj\"\n";
    let text = "[[material]]\ntexture = \"textures/tiles.png\"\n[[material]]\n\
                texture = { file = \"textures/tiles.png\", filter = \"nearest\", \
                wrap = \"mirror\", perspective = false, mipmaps = false, alpha_test = 0.5 }";
    let scene = read(&format!("{text}\n{actor}")).unwrap();
    let [texture] = &scene.textures[..] else {
        panic!("one texture");
    };
    assert_eq!((texture.width, texture.height), (64, 64));
    assert_eq!(texture.name, "textures/tiles.png");
    assert_eq!(scene.materials[0].texture, Some(Texturing::new(0)));
    let other = Texturing {
        texture: 0,
        filter: Filter::Nearest,
        wrap: Wrap::Mirror,
        perspective: false,
        mipmaps: false,
        alpha_test: 0.5,
    };
    assert_eq!(scene.materials[1].texture, Some(other));
    assert_eq!(scene.meshes[0].texture_coordinates.len(), 24);
    // Nobody needs the coordinates of a plain one.
    let plain = read(actor).unwrap();
    assert!(plain.meshes[0].texture_coordinates.is_empty());
    assert_eq!(
        read(&format!("{text}\n{ACTOR}")).unwrap_err(),
        "t.toml:5: actor.material: has a texture, but the mesh has no texture coordinates; \
         expected one with them, e.g. vt of an OBJ file"
    );
}

#[test]
fn a_gltf_file_brings_its_own_material() {
    let folder = std::env::temp_dir().join(format!("fixel-scene-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let picture = picture::tests::png(1, 1, &[9, 8, 7], image::ColorType::Rgb8);
    let file = mesh::tests::samples::textured_glb(&picture, "", "");
    std::fs::write(folder.join("a.glb"), file).unwrap();
    let read = |text: &str| parse_at(&folder.join("t.toml"), text, None).unwrap();
    let text = "[[material]]\nname = \"clay\"\n[[actor]]\nmesh = \"a.glb\"\n\
                [[actor]]\nmesh = \"a.glb\"\nmaterial = \"clay\"\n[[actor]]\nmesh = \"a.glb\"\n";
    let scene = read(text);
    let materials: Vec<_> = scene.actors.iter().map(|actor| actor.material).collect();
    assert_eq!(materials, [1, 0, 1]);
    let own = &scene.materials[1];
    assert_eq!((own.name.as_str(), own.diffuse_colour[0]), ("a.glb", 1.0));
    assert_eq!(own.texture, Some(Texturing::new(0)));
    assert_eq!(scene.textures[0].texels, [[9, 8, 7, 255]]);
    assert_eq!(scene.meshes[0].texture_coordinates.len(), 4);

    let bare = crate::load(&folder.join("a.glb")).unwrap();
    assert_eq!(bare.materials[0].texture, Some(Texturing::new(0)));
    assert_eq!(bare.materials[0].ambient, 0.15);
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn rays_and_what_they_meet() {
    let text = "[ray]\nshadows = false\ndepth = 6\nsamples = 8\nthreshold = 0.25\nlight_samples = 9\n\
                [[light]]\nkind = \"point\"\nposition = [0, 3, 0]\nedges = [[1, 0, 0], [0, 0, 2]]\n\
                [[material]]\nreflectivity = 0.5\nrefractive_index = 1.5\n\
                texture = \"textures/tiles.png\"\n\
                [[actor]]\nplane = [4, 2]\ndetail = 1\n";
    let scene = read(text).unwrap();
    let expected = Ray {
        shadows: false,
        depth: 6,
        samples: 8,
        threshold: 0.25,
        light_samples: 9,
    };
    assert_eq!(scene.ray, expected);
    assert_eq!(
        scene.lights[0].edges,
        Some([[1.0, 0.0, 0.0], [0.0, 0.0, 2.0]])
    );
    let material = &scene.materials[0];
    assert_eq!(
        (material.reflectivity, material.refractive_index),
        (0.5, 1.5)
    );
    let mesh = &scene.meshes[0];
    let (width, depth) = (4.0, 2.0);
    assert_eq!(mesh.primitive, Some(Primitive::Rectangle { width, depth }));
    assert_eq!((mesh.positions.len(), mesh.triangles.len()), (9, 8));
    assert_eq!(
        (mesh.positions[0], mesh.texture_coordinates[0]),
        ([-2.0, 0.0, 1.0], [0.0, 0.0])
    );
    assert_eq!(
        (mesh.positions[8], mesh.texture_coordinates[8]),
        ([2.0, 0.0, -1.0], [1.0, 1.0])
    );
    // Counter-clockwise seen from above.
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| glam::DVec3::from(mesh.positions[i as usize]));
        assert!((b - a).cross(c - a).y > 0.0);
    }
    assert_eq!(read(ACTOR).unwrap().ray, Ray::default());
}

#[test]
fn level_of_detail_is_asked_for_by_its_table() {
    let lod = |text: &str| read(&format!("{text}\n{ACTOR}")).unwrap().lod;
    assert_eq!(lod(""), None);
    assert_eq!(lod("[lod]"), Some(Lod { error: 1.0 }));
    assert_eq!(lod("[lod]\nerror = 2"), Some(Lod { error: 2.0 }));
}
