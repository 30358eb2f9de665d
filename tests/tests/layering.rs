//! Data flows one way: a module of the core imports only those before it.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What each module may import. `render` is the one place that knows all.
const ALLOWED: [(&str, &[&str]); 16] = [
    ("math", &[]),
    ("frame", &["math"]),
    ("scene", &["math"]),
    ("view", &["math", "scene"]),
    ("cull", &["math", "scene", "view"]),
    ("light", &["math", "scene", "view"]),
    ("vertex", &["light", "math", "scene", "view"]),
    ("line", &["frame", "math", "raster", "vertex"]),
    ("clip", &["math", "vertex", "view"]),
    ("raster", &["frame", "math", "vertex"]),
    ("fog", &["frame", "math", "scene", "view"]),
    ("shade", &["light", "math", "raster", "scene"]),
    ("palette", &[]),
    ("display", &["frame", "math", "palette", "scene"]),
    (
        "immediate",
        &[
            "clip", "frame", "light", "line", "math", "raster", "scene", "shade", "vertex", "view",
        ],
    ),
    (
        "ray",
        &[
            "display", "fog", "frame", "light", "math", "palette", "scene", "shade", "view",
        ],
    ),
];

/// Knows all stages.
const TOP: &str = "render";

/// Modules that a source text names by `crate::`, tests and docs aside.
fn imports(text: &str) -> Vec<String> {
    let code = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.starts_with("//"));
    let named = code.flat_map(|line| line.split("crate::").skip(1).map(str::to_owned));
    named
        .map(|rest| {
            rest.chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect()
        })
        .filter(|name: &String| !name.is_empty() && name.chars().all(|c| c.is_lowercase()))
        .collect()
}

fn sources(folder: &Path, into: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("a folder of the core") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, into);
        } else if path.extension().is_some_and(|e| e == "rs")
            && !path.ends_with("tests.rs")
            && !folder.ends_with("tests")
        {
            let text = fs::read_to_string(&path).expect("a source file");
            into.push((path.display().to_string(), text));
        }
    }
}

#[test]
fn modules_import_only_those_before_them() {
    let allowed: BTreeMap<_, _> = ALLOWED.into_iter().collect();
    let src = fixel_tests::root().join("src");
    let mut wrong = Vec::new();
    for (module, allowed) in &allowed {
        let mut files = Vec::new();
        sources(&src.join(module), &mut files);
        assert!(!files.is_empty(), "src/{module} is empty");
        let used: Vec<String> = files.iter().flat_map(|(_, text)| imports(text)).collect();
        let unused = allowed
            .iter()
            .filter(|name| !used.iter().any(|u| u == *name));
        wrong.extend(unused.map(|name| format!("{module} no longer imports {name}")));
        for (path, text) in files {
            let outside = imports(&text)
                .into_iter()
                .filter(|name| name != module && !allowed.contains(&name.as_str()));
            wrong.extend(outside.map(|name| format!("{path} imports {name}")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_module_is_listed() {
    let entries = fs::read_dir(fixel_tests::root().join("src")).expect("the core");
    let folders = entries.map(|entry| entry.expect("an entry").path());
    let mut names: Vec<String> = folders
        .filter(|path| path.is_dir())
        .filter_map(|path| Some(path.file_name()?.to_str()?.to_owned()))
        .collect();
    names.sort();
    let mut listed: Vec<&str> = ALLOWED.iter().map(|(module, _)| *module).collect();
    listed.push(TOP);
    listed.sort_unstable();
    assert_eq!(names, listed);
}

#[test]
fn a_wrong_import_is_seen() {
    assert_eq!(imports("use crate::render::Scratch;"), ["render"]);
    assert_eq!(
        imports("// use crate::render;\nlet x = crate::view::Lens;"),
        ["view"]
    );
}
