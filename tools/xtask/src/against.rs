//! What a change did: fresh figures of the bench beside those of another revision, or of a
//! file that `bench --json` wrote.

use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::{Map, Value, json};

use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{bench, child, paths};

/// Changes below this, in percent, are not coloured.
const SMALL_PERCENT: f64 = 0.1;

/// Figures of both. Gives `{"scene": {"target": {"instructions": {"before": n, "after": n,
/// "percent": x}, ...}}}`; one of the two is null where only the other was measured.
pub fn run(tally: &mut Tally, base: &str, names: &[String]) -> Result<Value> {
    let before = if Path::new(base).is_file() {
        read(Path::new(base))?
    } else {
        of_revision(base, names)?
    };
    let after = bench::run(tally, names)?;
    Ok(beside(&before, &after))
}

fn read(path: &Path) -> Result<Value> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let text = fs::read_to_string(path).map_err(|error| fail(&error))?;
    Ok(serde_json::from_str(&text).map_err(|error| fail(&error))?)
}

/// Lets a revision measure itself: its own baker, firmware and bench, in a checkout that is
/// kept, so that the next revision builds in less time.
fn of_revision(revision: &str, names: &[String]) -> Result<Value> {
    let mut command = git(&paths::root(), &["rev-parse", "--verify", "--quiet"]);
    let commit = child::output(command.arg(format!("{revision}^{{commit}}")))
        .ok_or_else(|| format!("{revision} is neither a file nor a revision"))?;
    let folder = checkout(commit.trim())?;
    let file = paths::work("against")?.join("figures.json");
    let _ = fs::remove_file(&file);
    let mut command = Command::new("cargo");
    child::without_outer_package(&mut command);
    command
        .args(["xtask", "bench", "--json"])
        .arg(&file)
        .args(names)
        .current_dir(&folder)
        .env("CARGO_TARGET_DIR", folder.join("target"));
    eprintln!("{revision}: {}", child::shown(&command));
    // Where it lacks a scene that is asked for, the others' figures are there all the same.
    let ended = child::visibly(&mut command);
    read(&file).map_err(|problem| ended.err().unwrap_or(problem))
}

/// The checkout, at a commit.
fn checkout(commit: &str) -> Result<PathBuf> {
    let folder = paths::work("against")?.join("checkout");
    if folder.join(".git").exists() {
        let mut command = git(&folder, &["checkout", "--quiet", "--force", "--detach"]);
        child::visibly(command.arg(commit))?;
    } else {
        // It may be on git's list still, though a `cargo clean` took it away.
        let mut command = git(
            &paths::root(),
            &["worktree", "add", "--quiet", "--force", "--detach"],
        );
        child::visibly(command.arg(&folder).arg(commit))?;
    }
    Ok(folder)
}

fn git(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new("git");
    command.args(arguments).current_dir(folder);
    command
}

/// Two sets of figures, each pair side by side.
fn beside(before: &Value, after: &Value) -> Value {
    let empty = Map::new();
    let entries = |value: &Value| value.as_object().unwrap_or(&empty).clone();
    let mut scenes = Map::new();
    for (scene, after) in entries(after) {
        let mut targets = Map::new();
        for (target, after) in entries(&after) {
            let mut figures = Map::new();
            for (figure, after) in entries(&after) {
                let before = &before[&scene][&target][&figure];
                let percent = percent(before.as_f64(), after.as_f64());
                figures.insert(
                    figure,
                    json!({ "before": before, "after": after, "percent": percent }),
                );
            }
            targets.insert(target, figures.into());
        }
        scenes.insert(scene, targets.into());
    }
    scenes.into()
}

/// By how much more `after` is.
fn percent(before: Option<f64>, after: Option<f64>) -> Option<f64> {
    let (before, after) = (before?, after?);
    (before != 0.0).then(|| 100.0 * (after - before) / before)
}

/// A row a figure; on a terminal with losses in red and gains in green.
pub fn shown(figures: &Value) -> String {
    let coloured = std::io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    text(figures, coloured)
}

fn text(figures: &Value, coloured: bool) -> String {
    let empty = Map::new();
    let entries = |value: &'_ Value| value.as_object().unwrap_or(&empty).clone();
    let (mut rows, mut changes) = (Vec::new(), Vec::new());
    for (scene, targets) in entries(figures) {
        for (target, figures) in entries(&targets) {
            for (figure, pair) in entries(&figures) {
                let number = |value: &Value| match value.as_u64() {
                    Some(count) => count.to_string(),
                    None => value.as_f64().map_or("-".into(), |v| format!("{v:.1}")),
                };
                let change = pair["percent"].as_f64();
                rows.push(vec![
                    format!("{scene}, {target}, {figure}"),
                    number(&pair["before"]),
                    number(&pair["after"]),
                    change.map_or("-".into(), |change| format!("{change:+.2} %")),
                ]);
                // More pixels are no loss.
                changes.push(change.filter(|_| figure != "covered_px").unwrap_or(0.0));
            }
        }
    }
    let plain = table(
        &["scene, target, figure", "before", "after", "change"],
        &rows,
    );
    if !coloured {
        return plain;
    }
    const HEAD: usize = 2;
    let mut text = String::new();
    for (number, line) in plain.lines().enumerate() {
        let change = number.checked_sub(HEAD).and_then(|row| changes.get(row));
        match change.copied().unwrap_or(0.0) {
            change if change >= SMALL_PERCENT => text.push_str(&format!("\x1b[31m{line}\x1b[0m\n")),
            change if change <= -SMALL_PERCENT => {
                text.push_str(&format!("\x1b[32m{line}\x1b[0m\n"));
            }
            _ => text.push_str(&format!("{line}\n")),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figures(count: u64) -> Value {
        json!({ "a": { "cortex-m4f": { "instructions": count } } })
    }

    #[test]
    fn changes_stand_beside_each_other() {
        let both = beside(&figures(200), &figures(210));
        assert_eq!(
            both["a"]["cortex-m4f"]["instructions"],
            json!({ "before": 200, "after": 210, "percent": 5.0 })
        );
        let plain = text(&both, false);
        assert!(
            plain.contains("+5.00 %") && !plain.contains('\x1b'),
            "{plain}"
        );
        assert!(text(&both, true).contains("\x1b[31m| a, cortex-m4f"));
        assert!(text(&beside(&figures(200), &figures(190)), true).contains("\x1b[32m"));
    }

    #[test]
    fn what_only_one_has_is_not_compared() {
        let both = beside(&json!({}), &figures(210));
        assert!(text(&both, true).contains("|      - |   210 |      - |"));
    }
}
