//! What comes from elsewhere: licences that go with ours, one version of each package where
//! that can be had, nothing that is not used, a reason for each (docs/dependencies.md), and
//! no known vulnerability, where what is known of them can be had.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::Value;
use spdx::{Expression, LicenseReq, ParseMode};

use crate::problem::{Problem, Result};
use crate::report::Tally;
use crate::{child, paths, test};

/// Folders with a lock file of their own.
const WORKSPACES: [&str; 14] = [
    "",
    "examples",
    "fuzz",
    "tools/hostbench",
    "targets/cortex-m",
    "targets/demo",
    "targets/gba",
    "targets/host",
    "targets/libretro",
    "targets/riscv",
    "targets/rp2040",
    "targets/runner",
    "targets/wasm",
    "targets/web",
];
/// Licences of others' code that MIT or Apache-2.0 programs may hold without a condition
/// beyond naming it.
const LICENCES: [&str; 9] = [
    "0BSD",
    "Apache-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "ISC",
    "MIT",
    "NCSA",
    "Unicode-3.0",
    "Zlib",
];
/// Packages of the workspace that there are two versions of, since others want an older one.
const TWICE: [&str; 6] = [
    "base64",
    "getrandom",
    "linux-raw-sys",
    "miniz_oxide",
    "rustix",
    "syn",
];
/// How long the database of advisories may take to come.
const FETCH_LIMIT: Duration = Duration::from_secs(300);
/// The page that has a reason for each package.
const PAGE: &str = "docs/dependencies.md";

/// Checks all of it.
pub fn run(tally: &mut Tally) {
    let mut direct = BTreeSet::new();
    let known = tally.need("advisories", has_database()).is_some();
    for folder in WORKSPACES {
        let name = if folder.is_empty() {
            "the workspace"
        } else {
            folder
        };
        if known {
            tally.check(&format!("advisories of {name}"), advisories(folder));
        }
        let described = Described::of(&paths::root().join(folder));
        let Some(described) = tally.need(&format!("packages of {name}"), described) else {
            continue;
        };
        tally.check(&format!("licences of {name}"), described.licences());
        tally.check(&format!("what {name} uses"), described.unused());
        if folder.is_empty() {
            tally.check("one version of each package", described.versions());
        }
        direct.extend(described.direct());
    }
    let page = paths::root().join(PAGE);
    let text = fs::read_to_string(&page).map_err(|error| format!("{PAGE}: {error}").into());
    let result = text.and_then(|text: String| reasons(&text, &direct));
    tally.check("a reason for each package", result);
}

/// `cargo deny` in a workspace, and what it says if it fails.
fn deny(folder: &str, words: &[&str]) -> std::result::Result<(), String> {
    let manifest = paths::root().join(folder).join("Cargo.toml");
    // Of all its members, not only of the one at its root.
    let mut command = test::cargo(&["deny", "--workspace", "--manifest-path"]);
    command.arg(manifest).args(words);
    match child::bounded(&mut command, FETCH_LIMIT) {
        Ok(run) if run.success => Ok(()),
        Ok(run) => Err(run.stderr + &run.stdout),
        Err(problem) => Err(problem.to_string()),
    }
}

/// Whether `cargo deny` and the database of advisories can be had: it is on GitHub alone.
fn has_database() -> Result<()> {
    if child::output(&mut test::cargo(&["deny", "--version"])).is_none() {
        let missing = "no `cargo deny`: `cargo install cargo-deny` would bring it";
        return Err(Problem::Missing(missing.into()));
    }
    deny("", &["fetch", "db"]).map_err(|said| {
        let line = |word: &str| said.lines().find(|line| line.contains(word));
        let error = line("fatal: ").or_else(|| line("ERROR"));
        let error = error.unwrap_or("it does not say why").trim();
        Problem::Missing(format!("`cargo deny fetch db` got no database: {error}"))
    })
}

/// Fails if one is known of a package that a workspace builds.
fn advisories(folder: &str) -> Result<()> {
    Ok(deny(folder, &["check", "advisories"])?)
}

/// What cargo says of a workspace and all that it is built from.
struct Described {
    packages: Vec<Package>,
}

struct Package {
    name: String,
    licence: Option<String>,
    /// Whether it is ours.
    own: bool,
    folder: PathBuf,
    /// Name and, in code, name of what it depends on from elsewhere.
    dependencies: Vec<(String, String)>,
}

impl Described {
    fn of(folder: &Path) -> Result<Self> {
        let mut command = test::cargo(&["metadata", "--format-version", "1", "--locked"]);
        command
            .args(["--filter-platform", "x86_64-unknown-linux-gnu"])
            .arg("--manifest-path")
            .arg(folder.join("Cargo.toml"));
        let text = child::output(&mut command)
            .ok_or("cargo metadata failed; is Cargo.lock there and current?")?;
        let value: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
        let packages = value["packages"].as_array().into_iter().flatten();
        Ok(Self {
            packages: packages.map(Package::of).collect(),
        })
    }

    fn others(&self) -> impl Iterator<Item = &Package> {
        self.packages.iter().filter(|package| !package.own)
    }

    fn licences(&self) -> Result<()> {
        let wrong = |package: &Package| {
            let licence = package.licence.as_deref().unwrap_or("none");
            (!is_allowed(licence)).then(|| format!("{} ({licence})", package.name))
        };
        none(self.others().filter_map(wrong), "licence not among ours")
    }

    /// Packages that there are two versions of, beyond those known.
    fn versions(&self) -> Result<()> {
        let mut counts = BTreeMap::new();
        for package in self.others() {
            *counts.entry(package.name.as_str()).or_insert(0) += 1;
        }
        let twice = counts.iter().filter(|(_, count)| **count > 1);
        let twice: BTreeSet<&str> = twice.map(|(name, _)| *name).collect();
        let known = BTreeSet::from(TWICE);
        none(
            twice.symmetric_difference(&known),
            "several versions, or no longer",
        )
    }

    /// Dependencies that no file of their package names.
    fn unused(&self) -> Result<()> {
        let mut unused = Vec::new();
        for package in self.packages.iter().filter(|package| package.own) {
            let mut text = String::new();
            sources(&package.folder, &mut text)?;
            let missing = |(_, in_code): &&(String, String)| !names(&text, in_code);
            let missing = package.dependencies.iter().filter(missing);
            unused.extend(missing.map(|(name, _)| format!("{name} in {}", package.name)));
        }
        none(unused, "not used")
    }

    /// What ours depend on from elsewhere.
    fn direct(&self) -> impl Iterator<Item = String> {
        let own = self.packages.iter().filter(|package| package.own);
        own.flat_map(|package| &package.dependencies)
            .map(|(name, _)| name.clone())
    }
}

impl Package {
    fn of(value: &Value) -> Self {
        let text = |value: &Value| value.as_str().map(str::to_owned);
        let manifest = PathBuf::from(text(&value["manifest_path"]).unwrap_or_default());
        let all = value["dependencies"].as_array().into_iter().flatten();
        let elsewhere = all.filter(|dependency| dependency["path"].is_null());
        // As `cargo machete` has it: what is there for its features or a linker script.
        let ignored = value["metadata"]["cargo-machete"]["ignored"].as_array();
        let dependencies = elsewhere.filter_map(|dependency| {
            let name = text(&dependency["name"])?;
            if ignored.is_some_and(|all| all.contains(&dependency["name"])) {
                return None;
            }
            let in_code = text(&dependency["rename"]).unwrap_or_else(|| name.clone());
            Some((name, in_code.replace('-', "_")))
        });
        Self {
            name: text(&value["name"]).unwrap_or_default(),
            licence: text(&value["license"]),
            own: value["source"].is_null(),
            folder: manifest.parent().map(Path::to_owned).unwrap_or_default(),
            dependencies: dependencies.collect(),
        }
    }
}

/// Fails if there are any.
fn none(found: impl IntoIterator<Item = impl ToString>, what: &str) -> Result<()> {
    let found: Vec<String> = found.into_iter().map(|one| one.to_string()).collect();
    match found.is_empty() {
        true => Ok(()),
        false => Err(format!("{what}: {}", found.join(", ")).into()),
    }
}

/// Whether one can choose only licences of ours from it.
fn is_allowed(licence: &str) -> bool {
    // Older manifests have slashes for OR.
    let expression = Expression::parse_mode(licence, ParseMode::LAX);
    let ours = |wanted: &LicenseReq| {
        let id = wanted.license.id();
        id.is_some_and(|id| LICENCES.contains(&id.name))
    };
    expression.is_ok_and(|expression| expression.evaluate(ours))
}

/// The text of a package's sources, packages below it left out.
fn sources(folder: &Path, text: &mut String) -> Result<()> {
    let fail = |error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(fail)? {
        let path = entry.map_err(fail)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() {
            if name != "target" && !name.starts_with('.') && !path.join("Cargo.toml").exists() {
                sources(&path, text)?;
            }
        } else if name.ends_with(".rs") {
            let read = fs::read_to_string(&path);
            text.push_str(&read.map_err(|error| format!("{}: {error}", path.display()))?);
        }
    }
    Ok(())
}

/// Whether a word is in code, as a word of its own.
fn names(text: &str, word: &str) -> bool {
    let part = |letter: Option<char>| letter.is_some_and(|c| c.is_alphanumeric() || c == '_');
    text.match_indices(word).any(|(at, _)| {
        let before = text.get(..at).and_then(|text| text.chars().next_back());
        let after = text.get(at + word.len()..).and_then(|t| t.chars().next());
        !part(before) && !part(after)
    })
}

/// The page's table has a row for each package, and for no other.
fn reasons(page: &str, direct: &BTreeSet<String>) -> Result<()> {
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `"));
    let listed: BTreeSet<String> = rows
        .filter_map(|row| row.split_once('`'))
        .map(|(name, _)| name.to_owned())
        .collect();
    none(
        listed.symmetric_difference(direct),
        "not in the page's table, or there without need",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn licences_are_those_that_go_with_ours() {
        for fine in [
            "MIT OR Apache-2.0",
            "MIT/Apache-2.0",
            "(MIT OR Apache-2.0) AND Unicode-3.0",
            "Unlicense OR MIT",
            "GPL-3.0-only OR MIT",
        ] {
            assert!(is_allowed(fine), "{fine}");
        }
        for wrong in ["GPL-3.0-only", "MIT AND MPL-2.0", "none", "Ours"] {
            assert!(!is_allowed(wrong), "{wrong}");
        }
    }

    #[test]
    fn a_package_is_named_as_a_word() {
        assert!(names("use png::Encoder;", "png"));
        assert!(!names("use png_parts; let apng = 1;", "png"));
    }

    #[test]
    fn the_page_has_what_is_used() {
        let page = "| package | why |\n|---|---|\n| `png` | pictures |\n";
        let used = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        assert!(reasons(page, &used(&["png"])).is_ok());
        assert!(reasons(page, &used(&["png", "gif"])).is_err());
        assert!(reasons(page, &used(&[])).is_err());
    }
}
