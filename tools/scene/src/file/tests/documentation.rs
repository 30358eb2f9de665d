//! `docs/scene-format.md`.

use super::read;

#[test]
fn the_examples_on_the_format_are_scenes() {
    let page = include_str!("../../../../../docs/scene-format.md");
    let blocks: Vec<_> = page.split("```toml\n").skip(1).collect();
    assert!(blocks.len() >= 3);
    for block in blocks {
        let block = block.split("```").next().unwrap();
        let table = if block.starts_with('[') {
            ""
        } else {
            "[[material]]\n"
        };
        let actor = "[[actor]]\nmesh = \"meshes/cube_textured.obj\"\n";
        let scene = read(&format!("{table}{block}\n{actor}"));
        assert!(scene.is_ok(), "{block}: {scene:?}");
    }
}

/// A stranger can write a scene from `docs/scene-format.md` alone: each table has a
/// section, and each of its keys stands there.
#[test]
fn the_documentation_has_every_key() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/scene-format.md");
    let text = std::fs::read_to_string(path).unwrap();
    let section = |heading: &str| {
        let mut sections = text.split("\n## ");
        sections.find(|section| section.lines().next().unwrap().contains(heading))
    };
    let annotations = "[[line]]";
    for (heading, keys) in [
        ("[display]", &super::super::display::DISPLAY),
        ("[camera]", &super::super::camera::CAMERA),
        ("[[viewport]]", &super::super::viewport::VIEWPORT),
        ("[[light]]", &super::super::light::LIGHT),
        ("[[material]]", &super::super::material::MATERIAL),
        ("[[material]]", &super::super::texture::TEXTURE),
        ("[[actor]]", &super::super::actor::ACTOR),
        (annotations, &super::super::annotation::LINE),
        (annotations, &super::super::annotation::MARKER),
        (annotations, &super::super::annotation::TEXT),
        ("[fog]", &super::super::fog::FOG),
        ("[lod]", &super::super::lod::LOD),
        ("[ray]", &super::super::ray::RAY),
        ("[palette]", &super::super::palette::PALETTE),
        ("[palette]", &super::super::palette::RAMP),
        ("[animation]", &super::super::animation::ANIMATION),
        ("[animation]", &super::super::animation::KEY),
        ("[animation]", &super::super::animation::CYCLE),
    ] {
        let section = section(heading).unwrap_or_else(|| panic!("no section {heading}"));
        for key in keys.known {
            assert!(section.contains(&format!("`{key}`")), "{heading}: {key}");
        }
    }
    for table in super::super::ROOT.known {
        let found = section(&format!("[{table}]"));
        assert!(found.is_some(), "no section [{table}]");
    }
}
