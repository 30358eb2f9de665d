//! Material libraries of OBJ files.

use std::path::Path;

use image::ColorType;

use crate::description::{Material, Scene};
use crate::files::InMemory;
use crate::picture::tests::png;
use crate::texture::Wrap;
use crate::{Fenced, Loader};

/// Two squares side by side, then one more.
const CORNERS: &str = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n\
                       v 3 0 0\nv 3 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const ONE: &str = "f 1/1 2/2 3/3 4/4\n";
const TWO: &str = "f 2/1 5/2 6/3 3/4\n";
const THREE: &str = "f 5/1 7/2 8/3 6/4\n";

fn files(library: &str, faces: &str) -> InMemory {
    let mut files = InMemory::default();
    files.insert(Path::new("a.mtl"), library.into());
    files.insert(Path::new("a.obj"), (CORNERS.to_owned() + faces).into());
    let texels = [[9, 8, 7, 255], [0, 0, 0, 0]];
    let picture = png(2, 1, texels.as_flattened(), ColorType::Rgba8);
    files.insert(Path::new("textures/wood.png"), picture);
    files
}

fn load(library: &str, faces: &str) -> Result<(Scene, Vec<String>), String> {
    let files = files(library, faces);
    let loaded = Loader::new(&files).load(Path::new("a.obj"));
    loaded.map_err(|error| error.to_string())
}

#[test]
fn everything_that_a_material_has_is_there() {
    let library = "# from a modeller\nnewmtl red metal\nKa 1 1 1\nKd 0.8 0.2 0\nKs 0.5 0.5 0.4\n\
                   Ns 40\nKe 0 0.25 0\nd 0.5\nillum 2\nmap_Kd -s 1 2 1 -clamp on textures\\wood.png\n";
    let (scene, notes) = load(library, &format!("usemtl red metal\n{ONE}{TWO}")).unwrap();
    let texture = scene.materials[0].texture.unwrap();
    assert_eq!((texture.texture, texture.wrap), (0, Wrap::Clamp));
    assert_eq!(texture.alpha_test, 0.0);
    assert_eq!(scene.textures[0].name, "textures/wood.png");
    let wanted = Material {
        name: "a.obj".to_owned(),
        ambient: 0.15,
        diffuse: 0.85,
        ambient_colour: [0.8, 0.2, 0.0],
        diffuse_colour: [0.8, 0.2, 0.0],
        specular_colour: [0.5, 0.5, 0.4],
        specular: 1.0,
        specular_power: 10.0,
        emission: 0.25,
        opacity: 0.5,
        texture: Some(texture),
        ..Material::default()
    };
    assert_eq!(scene.materials, [wanted]);
    assert_eq!(scene.meshes.len(), 1);
    assert_eq!(scene.meshes[0].texture_coordinates.len(), 8);
    assert_eq!(
        notes,
        ["a.obj: where and how brightly a texture lies (-o, -s, -t, -mm) is left out"]
    );
}

#[test]
fn an_actor_without_a_material_has_the_files() {
    let mut files = files("newmtl x\nKd 0 1 0\n", &format!("usemtl x\n{ONE}"));
    let mut actor = |more: &str| {
        let text = format!("[[actor]]\nmesh = \"a.obj\"\n{more}");
        files.insert(Path::new("s.toml"), text.into());
        let (scene, _) = Loader::new(&files).load(Path::new("s.toml")).unwrap();
        let material = &scene.materials[scene.actors[0].material];
        (material.name.clone(), material.diffuse_colour)
    };
    assert_eq!(actor(""), ("a.obj".to_owned(), [0.0, 1.0, 0.0]));
    let own = "material = \"clay\"\n[[material]]\nname = \"clay\"\n";
    assert_eq!(actor(own), ("clay".to_owned(), [1.0; 3]));
}

#[test]
fn colours_alone_are_those_of_vertices() {
    let library = "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0.5 0\nnewmtl c\nKd 1 0 0\nmap_Kd wood.png\n";
    let faces = format!("{ONE}usemtl b\n{TWO}usemtl c\n{THREE}");
    let (scene, notes) = load(library, &faces).unwrap();
    assert_eq!(notes, [""; 0]);
    // White, then green; with a texture there is another surface.
    assert_eq!(scene.meshes.len(), 2);
    let colours = &scene.meshes[0].colours;
    assert_eq!(colours.len(), 8);
    assert_eq!(colours[..4], [[1.0; 3]; 4]);
    assert_eq!(colours[4..], [[0.0, 0.5, 0.0]; 4]);
    assert!(scene.materials[0].texture.is_none());
    assert_eq!(scene.materials[1].diffuse_colour, [1.0, 0.0, 0.0]);
    assert_eq!(scene.materials[1].name, "a.obj, surface 2");
    assert!(scene.materials[1].texture.is_some() && scene.meshes[1].colours.is_empty());
    // A name that is there twice is the first.
    let (scene, _) = load(&format!("{library}newmtl b\nKd 0 0 1\n"), &faces).unwrap();
    assert_eq!(scene.meshes[0].colours[4], [0.0, 0.5, 0.0]);
}

#[test]
fn what_is_cut_out_is_the_pictures_alpha() {
    let library = "newmtl a\nmap_Kd wood.png\nmap_d wood.png\nTr 0.25\nillum 1\nKs 1 1 1\n";
    let (scene, notes) = load(library, &format!("usemtl a\n{ONE}")).unwrap();
    assert_eq!(notes, [""; 0]);
    let material = &scene.materials[0];
    assert_eq!((material.opacity, material.specular), (0.75, 0.0));
    assert_eq!(material.texture.unwrap().alpha_test, 0.5);
}

#[test]
fn what_cannot_be_had_is_left_out_with_a_note() {
    let face = format!("usemtl a\n{ONE}");
    let notes = |library: &str, faces: &str| load(library, faces).unwrap().1;
    let missing = "is not among the files; expected it together with them";
    assert_eq!(
        notes("newmtl a\nmap_Kd stone.png\n", &face),
        [format!(
            "a.obj: a texture is left out, as \"stone.png\" {missing}"
        )]
    );
    assert_eq!(
        notes("newmtl b\n", &face),
        ["a.obj: no material is called \"a\": white instead"]
    );
    assert_eq!(
        notes("newmtl a\n", &format!("mtllib my own.mtl a.mtl\n{face}")),
        [
            format!("a.obj: materials are left out, as \"my\" {missing}"),
            format!("a.obj: materials are left out, as \"own.mtl\" {missing}"),
        ]
    );
    let all = "newmtl a\nmap_Bump wood.png\nmap_d other.png\nKd xyz 1 1 1\n";
    assert_eq!(notes(all, &face).len(), 3);
    let without = face.replace("/1", "").replace("/2", "").replace("/3", "");
    let bare = CORNERS.replace("vt", "#") + &without.replace("/4", "");
    let mut files = files("newmtl a\nmap_Kd wood.png\n", "");
    files.insert(Path::new("a.obj"), bare.into());
    let (_, notes) = Loader::new(&files).load(Path::new("a.obj")).unwrap();
    assert_eq!(
        notes,
        ["a.obj: a texture is left out, as there are no texture coordinates"]
    );
}

#[test]
fn mistakes_are_told_with_the_librarys_lines() {
    let refused = |library: &str| load(library, ONE).unwrap_err();
    assert_eq!(
        refused("newmtl a\nKd 0 0\n"),
        "a.mtl:2: Kd: has 2 numbers where 3 belong; expected e.g. Kd 0.8 0.4 0"
    );
    assert_eq!(
        refused("\nnewmtl a\nNs nan\n"),
        "a.mtl:3: Ns: \"nan\" is not a number; expected e.g. Ns 0.5"
    );
    assert_eq!(
        refused("newmtl a\nmap_Kd -o 1\n"),
        "a.mtl:2: map_Kd: names no picture; expected e.g. map_Kd wood.png"
    );
    assert_eq!(
        refused("newmtl a\nd\n"),
        "a.mtl:2: d: \"\" is not a number; expected e.g. d 0.5"
    );
    // Numbers beyond their range are at its end.
    let (scene, _) = load(
        "newmtl a\nKd 7\nKs 1 1 1\nNs 1000\nd -halo 9\n",
        &format!("usemtl a\n{ONE}"),
    )
    .unwrap();
    let material = &scene.materials[0];
    assert_eq!(material.diffuse_colour, [1.0; 3]);
    assert_eq!((material.specular_power, material.opacity), (128.0, 1.0));
    let many: String = (0..300)
        .map(|n| format!("newmtl m{n}\nKe 0 0 {}\n", f64::from(n) / 300.0))
        .collect();
    let faces: String = (0..300).map(|n| format!("usemtl m{n}\n{ONE}")).collect();
    let refused = load(&many, &faces).unwrap_err();
    assert!(
        refused.starts_with("a.obj: has more than 255 materials"),
        "{refused}"
    );
    let libraries: String = (0..80).map(|n| format!("mtllib {n}.mtl\n")).collect();
    let refused = load("", &(libraries + ONE)).unwrap_err();
    assert!(
        refused.starts_with("a.obj: names more than 64"),
        "{refused}"
    );
}

#[test]
fn libraries_and_pictures_elsewhere_are_not_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("room");
        std::fs::write(path, bytes).expect("room");
    };
    write("secret.mtl", b"newmtl a\nsecret\n");
    write("secret.png", &png(1, 1, &[1, 2, 3, 255], ColorType::Rgba8));
    write("scenes/a.mtl", b"newmtl b\nmap_Kd ../secret.png\n");
    let faces = format!("mtllib ../secret.mtl\n{CORNERS}usemtl a\n{ONE}usemtl b\n{TWO}");
    write("scenes/a.obj", faces.as_bytes());
    let path = folder.path().join("scenes/a.obj");
    let files = Fenced::around(&path, &[]).expect("folders");
    let (scene, notes) = Loader::new(&files).load(&path).expect("a mesh");
    assert!(scene.textures.is_empty());
    let outside = |note: &&String| note.contains("is outside of the folders");
    assert_eq!(notes.iter().filter(outside).count(), 2, "{notes:?}");
}
