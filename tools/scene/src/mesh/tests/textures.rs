//! Texture coordinates, and textures that come with a mesh.

use image::ColorType;

use super::samples::{self, OBJ, PLY};
use super::{load, mesh, refused};
use crate::description::Cull;
use crate::mesh::forget_texture_coordinates;
use crate::picture::tests::png;
use crate::texture::{Filter, Texture, Wrap};

#[test]
fn obj_coordinates_are_the_files() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0.5\nvt 2 -1 7\nvt 0.25\n\
                f 1/1 2/-2 3/3\nf 1/2 2/2 3/3\nf 1 2 3\n";
    let mesh = mesh("a.obj", text.as_bytes());
    let (a, b, c) = ([0.0, 0.5], [2.0, -1.0], [0.25, 0.0]);
    assert_eq!(mesh.triangles[..2], [[0, 1, 2], [3, 1, 2]]);
    assert_eq!(mesh.texture_coordinates[..4], [a, b, c, b]);
    assert_eq!(mesh.texture_coordinates[4..], [[0.0; 2]; 3]);
    let wrong = |from, to| refused("a.obj", text.replacen(from, to, 1).as_bytes());
    let message = "vt: is not two numbers within 10000; expected e.g. vt 0.5 1";
    for line in ["vt", "vt x", "vt 0 x", "vt 1e9 0", "vt nan"] {
        assert_eq!(wrong("vt 0 0.5", line), format!("a.obj:4: {message}"));
    }
    assert!(wrong("1/1", "1/4").contains("texture index 4 is out of range (the file has 3)"));
}

#[test]
fn ply_coordinates_are_the_files() {
    for names in [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]] {
        let property = format!(
            "float z\nproperty float {}\nproperty double {}",
            names[0], names[1]
        );
        let text = PLY
            .replace("float z", &property)
            .replace("0 0 0\n", "0 0 0 0.5 1\n")
            .replace("\n1 0 0\n", "\n1 0 0 -1 0\n")
            .replace("\n1 1 0\n", "\n1 1 0 2 3\n")
            .replace("\n0 1 0\n", "\n0 1 0 0 0\n");
        let mesh = mesh("a.ply", text.as_bytes());
        assert_eq!(
            mesh.texture_coordinates,
            [[0.5, 1.0], [-1.0, 0.0], [2.0, 3.0], [0.0, 0.0]]
        );
        assert_eq!(
            refused("a.ply", text.replace("2 3\n", "2 1e9\n").as_bytes()),
            "a.ply:15: vertex 2: has texture coordinates that are not within 10000"
        );
    }
}

#[test]
fn a_texture_in_a_glb_comes_in_by_itself() {
    let texels = [[9, 8, 7, 255], [0, 0, 0, 0]];
    let file = png(2, 1, texels.as_flattened(), ColorType::Rgba8);
    let loaded = load("a.glb", &samples::textured_glb(&file, "", "")).unwrap();
    // The file's second coordinate goes down.
    let places = &loaded.mesh.texture_coordinates;
    assert_eq!(places[..3], [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
    assert!((places[3][1] - 0.8).abs() < 1e-7);
    assert!(loaded.notes.is_empty(), "{:?}", loaded.notes);
    let surface = loaded.surfaces[0].clone();
    assert_eq!(surface.colour[..2], [1.0, 0.0]);
    let (texture, how) = surface.texture.clone().unwrap();
    assert_eq!((texture.width, texture.height), (2, 1));
    assert_eq!(texture.texels, texels);
    assert_eq!(texture.name, "a.glb, images[0]");
    assert_eq!((how.filter, how.wrap), (Filter::Nearest, Wrap::Repeat));
    assert!(how.mipmaps && how.perspective && how.alpha_test == 0.0);
    let other = Texture {
        name: "another".to_owned(),
        ..texture.clone()
    };
    let mut textures = vec![other];
    for _ in 0..2 {
        let material = surface.material(&mut textures);
        assert_eq!(material.texture.unwrap().texture, 1);
    }
    assert_eq!(textures[1..], [texture]);
    let material = surface.material(&mut textures);
    assert_eq!(material.diffuse_colour, surface.colour);

    let material = r#", "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true"#;
    let sampler = r#""magFilter": 9728, "minFilter": 9729, "wrapS": 33071, "wrapT": 33648"#;
    let loaded = load("a.glb", &samples::textured_glb(&file, material, sampler)).unwrap();
    let surface = loaded.surfaces[0].clone();
    assert_eq!(surface.material(&mut Vec::new()).cull, Cull::None);
    let (_, how) = surface.texture.unwrap();
    assert_eq!((how.filter, how.wrap), (Filter::Nearest, Wrap::Clamp));
    assert_eq!((how.mipmaps, how.alpha_test), (false, 0.25));
    assert_eq!(
        loaded.notes,
        ["a.glb: a texture that wraps in two ways wraps down as it does across"]
    );
    assert!(
        refused("a.glb", &samples::textured_glb(b"GIF", "", ""))
            .starts_with("a.glb: images[0]: is not a kind of picture")
    );
}

#[test]
fn several_base_colours_become_vertex_colours() {
    let primitive = r#"{"attributes": {"POSITION": 1, "NORMAL": 2}, "material": 1, "indices": 0}"#;
    let text = samples::gltf("", samples::INDICES)
        .replace(
            "\"indices\": 0}]",
            &format!("\"indices\": 0}}, {primitive}]"),
        )
        .replace("0.5, 1]}}]", "0.5, 1]}}, {}]");
    let loaded = load("a.gltf", text.as_bytes()).unwrap();
    assert_eq!(loaded.mesh.triangles.len(), 4);
    assert_eq!(loaded.surfaces[0].colour, [1.0; 3]);
    let colours = &loaded.mesh.colours;
    assert!(
        colours[..4]
            .iter()
            .all(|c| c[..2] == [1.0, 0.0] && c[2] > 0.7)
    );
    assert_eq!(colours[4..], [[1.0; 3]; 4]);
}

#[test]
fn without_a_texture_vertices_on_seams_are_one() {
    let text = OBJ.replace(
        "f 1/1/1 2/1/1 3/1/1 4/1/1",
        "vt 1 1\nf 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/2/1 4/1/1",
    );
    let mut seamed = mesh("a.obj", text.as_bytes());
    assert_eq!(seamed.positions.len(), 6);
    forget_texture_coordinates(&mut seamed);
    let mut plain = mesh("a.obj", OBJ.as_bytes());
    forget_texture_coordinates(&mut plain);
    assert_eq!(plain.texture_coordinates, [[0.0; 2]; 0]);
    assert_eq!(seamed.positions, plain.positions);
    assert_eq!(seamed.triangles, plain.triangles);
    assert_eq!(seamed.edges.len(), 5);
    assert!(seamed.edges.as_flattened().iter().all(|index| *index < 4));
}

#[test]
fn each_texture_of_a_gltf_is_a_surface_of_its_own() {
    let house = "../../scenes/meshes/house.gltf";
    let loaded = load(house, &std::fs::read(house).unwrap()).unwrap();
    assert!(loaded.notes.is_empty(), "{:?}", loaded.notes);
    // Walls, roof; door and path, whose base colours become vertex colours.
    let textures: Vec<_> = loaded
        .surfaces
        .iter()
        .map(|surface| {
            surface
                .texture
                .as_ref()
                .map(|(texture, _)| texture.name.as_str())
        })
        .collect();
    let [bricks, tiles] = ["house.gltf, images[0]", "house.gltf, images[1]"];
    assert_eq!(textures, [Some(bricks), Some(tiles), None]);
    let sides: Vec<_> = loaded.surfaces.iter().map(|s| s.both_sides).collect();
    assert_eq!(sides, [false, true, false]);
    let parts = loaded.parts();
    let triangles: Vec<_> = parts.iter().map(|part| part.triangles.len()).collect();
    assert_eq!(triangles, [10, 4, 4]);
    let corners: Vec<_> = parts.iter().map(|part| part.positions.len()).collect();
    assert_eq!(corners, [18, 8, 8]);
    let coloured: Vec<_> = parts.iter().map(|part| part.colours.len()).collect();
    assert_eq!(coloured, [0, 0, 8]);
    // Each edge once: outlines and diagonals.
    let edges: usize = parts.iter().map(|part| part.edges.len()).sum();
    assert_eq!(edges, loaded.mesh.edges.len());
    let whole: f64 = loaded.mesh.positions.as_flattened().iter().sum();
    let all: f64 = parts.iter().flat_map(|p| p.positions.as_flattened()).sum();
    assert!((whole - all).abs() < 1e-9);
}
