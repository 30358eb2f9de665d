//! Coefficients of `fixel estimate`: what each kind of work takes on a processor, fitted to
//! counts from emulators.

mod cases;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use fixel_estimate::{Count, Firmware, Model, Parts, Term, non_negative};
use serde_json::{Map, Value, json};

use self::cases::{AS_IT_IS, Case, FRAMES};
use crate::measure::{self, Ready};
use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{footprint, parallel, paths};

/// Processors that are counted.
const TARGETS: [&str; 3] = ["cortex-m4f", "cortex-m0plus", "riscv32imc"];
/// Scenes that nothing is fitted to: each has its like among the others, in another mesh,
/// light or view.
const HELD_OUT: [&str; 14] = [
    "blend",
    "bunny",
    "fog_exponential",
    "house",
    "keyframes",
    "lights",
    "near_clip",
    "parallel",
    "suzanne",
    "textured_floor",
    "two_materials",
    "viewports",
    "w2_teapot_gouraud",
    "wireframe",
];
/// How many times as much a scene counts as one that was changed: it is more like what people
/// make.
const OWN: usize = 4;
/// How far off an estimate of those may be, in percent.
const MOST_PERCENT: f64 = 15.0;
/// Parts that scenes are taken in and out for in turn, to see how well the rest foretell
/// them.
const FOLDS: usize = 5;
const MADE_BY: &str = "made by `cargo xtask fit`";

fn file() -> PathBuf {
    paths::root().join("tools/estimate/coefficients.json")
}

/// How to fit.
#[derive(Debug)]
pub struct Options {
    /// Takes counts from a file that an earlier run wrote, and makes only what it lacks.
    pub from: Option<PathBuf>,
    /// Measures anew what firmware takes, too.
    pub firmware: bool,
}

/// Fits, and writes the file. Gives every count.
pub fn run(tally: &mut Tally, options: &Options) -> Result<Value> {
    let cases = cases::all(tally)?;
    let mut counts = match &options.from {
        Some(path) => read(path)?,
        None => Vec::new(),
    };
    counts.extend(count(tally, &cases, &counts));
    let mut model = Model::fitted().map_err(|error| error.to_string())?;
    model.about = format!("what `fixel estimate` goes by; {MADE_BY}");
    if options.firmware {
        model.firmware = firmware(&footprint::run(tally)?);
    }
    for target in TARGETS {
        let rows: Vec<Row> = rows(&cases, &counts, target);
        let fitted: Vec<&Row> = rows.iter().filter(|row| !row.is_held_out()).collect();
        if fitted.is_empty() {
            tally.skip(&format!("fit of {target}"), "nothing was counted");
            continue;
        }
        let before = before(&model, target);
        let each = fit(&fitted, &before);
        let held = || rows.iter().filter(|row| row.is_held_out());
        let (whole, varied) = held().partition::<Vec<_>, _>(|row| row.case.variant == AS_IT_IS);
        report(target, "fitted", &fitted, &each);
        report(target, "not fitted, changed", &varied, &each);
        let worst = report(target, "not fitted", &whole, &each);
        crosswise(target, &rows, &before);
        let what = format!("scenes that {target} was not fitted to");
        tally.check(&what, near_enough(worst));
        let named = Term::ALL.iter().zip(&each);
        let named = named.map(|(term, each)| (term.name().to_owned(), rounded(*each)));
        model.instructions.insert(target.into(), named.collect());
    }
    let held =
        |count: &&Count| HELD_OUT.contains(&count.scene.as_str()) && count.variant == AS_IT_IS;
    model.held_out = counts.iter().filter(held).cloned().collect();
    let text = serde_json::to_string_pretty(&model).map_err(|error| error.to_string())?;
    fs::write(file(), text + "\n").map_err(|error| format!("{}: {error}", file().display()))?;
    eprintln!("wrote {}", file().display());
    Ok(json!(counts))
}

/// Counts every case that is not known yet, on every target.
fn count(tally: &mut Tally, cases: &[Case], known: &[Count]) -> Vec<Count> {
    let known: BTreeSet<_> = known
        .iter()
        .map(|c| {
            (
                c.target.as_str(),
                c.scene.as_str(),
                c.variant.as_str(),
                c.band_rows,
            )
        })
        .collect();
    let is_known = |target, case: &Case| {
        known.contains(&(target, case.scene.as_str(), case.variant, case.band_rows))
    };
    let ready = measure::boards(&TARGETS, "counts", tally);
    let first = |case: &&Case| case.frame == FRAMES.start;
    let runs: Vec<(&Ready, &Case)> = ready
        .iter()
        .flat_map(|ready| cases.iter().filter(first).map(move |case| (ready, case)))
        .filter(|(ready, case)| !is_known(ready.target.name(), case))
        .collect();
    let counted = parallel::map(&runs, |(ready, case)| {
        ready.frames(&case.baked, FRAMES, case.band_rows.into(), None)
    });
    let mut all = Vec::new();
    for ((ready, case), frames) in runs.iter().zip(counted) {
        let what = format!("{} on {}", case.scene, ready.target.name());
        let frames = tally.need(&what, frames).unwrap_or_default();
        all.extend(frames.iter().map(|frame| Count {
            scene: case.scene.clone(),
            variant: case.variant.into(),
            frame: frame.frame,
            band_rows: case.band_rows,
            target: ready.target.name().into(),
            instructions: frame.count,
        }));
    }
    all
}

fn read(path: &Path) -> Result<Vec<Count>> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let text = fs::read_to_string(path).map_err(|error| fail(&error))?;
    Ok(serde_json::from_str(&text).map_err(|error| fail(&error))?)
}

/// A case and what it took.
#[derive(Clone, Copy)]
struct Row<'a> {
    case: &'a Case,
    instructions: f64,
}

impl Row<'_> {
    fn is_held_out(&self) -> bool {
        HELD_OUT.contains(&self.case.scene.as_str())
    }

    /// By how many percent an estimate is more.
    fn off(&self, each: &[f64]) -> f64 {
        let work = self.case.work.all();
        let sum: f64 = work.iter().zip(each).map(|(work, each)| work * each).sum();
        100.0 * (sum / self.instructions - 1.0)
    }
}

fn rows<'a>(cases: &'a [Case], counts: &[Count], target: &str) -> Vec<Row<'a>> {
    let key = |scene: &str, variant: &str, frame, rows| {
        (scene.to_owned(), variant.to_owned(), frame, rows)
    };
    let known: BTreeMap<_, _> = counts
        .iter()
        .filter(|count| count.target == target)
        .map(|c| {
            (
                key(&c.scene, &c.variant, c.frame, c.band_rows),
                c.instructions,
            )
        })
        .collect();
    cases
        .iter()
        .filter_map(|case| {
            let key = key(&case.scene, case.variant, case.frame, case.band_rows);
            let instructions = *known.get(&key)? as f64;
            Some(Row { case, instructions })
        })
        .collect()
}

/// What each term took by the last fit.
fn before(model: &Model, target: &str) -> Vec<f64> {
    let each = model.instructions.get(target);
    let of = |term: &Term| each.and_then(|each| each.get(term.name()));
    let all = Term::ALL.iter();
    all.map(|term| of(term).copied().unwrap_or(0.0)).collect()
}

/// Fits to the counts and, as much as to one frame for each term, to the last fit: what no
/// scene tells apart stays what it was.
fn fit(rows: &[&Row<'_>], before: &[f64]) -> Vec<f64> {
    let stays = before.iter().enumerate().filter(|(_, each)| **each > 0.0);
    let stays = stays.map(|(term, each)| {
        let mut row = vec![0.0; before.len()];
        row[term] = 1.0;
        (row, *each)
    });
    let rows: Vec<(Vec<f64>, f64)> = rows
        .iter()
        .flat_map(|row| {
            let times = if row.case.variant == AS_IT_IS { OWN } else { 1 };
            let row = (row.case.work.all().to_vec(), row.instructions);
            std::iter::repeat_n(row, times)
        })
        .chain(stays)
        .collect();
    non_negative(&rows, Term::ALL.len())
}

/// Prints how near estimates are to counts; gives the worst, as a percentage.
fn report(target: &str, what: &str, rows: &[&Row<'_>], each: &[f64]) -> f64 {
    let mut by_scene: BTreeMap<String, (f64, usize, f64)> = BTreeMap::new();
    for row in rows {
        let off = row.off(each).abs();
        let (worst, count, sum) = by_scene
            .entry(format!("{}{}", row.case.scene, row.case.variant))
            .or_default();
        *worst = worst.max(off);
        *count += 1;
        *sum += off;
    }
    let lines: Vec<Vec<String>> = by_scene
        .iter()
        .map(|(scene, (worst, count, sum))| {
            let mean = sum / *count as f64;
            vec![scene.clone(), format!("{mean:.1}"), format!("{worst:.1}")]
        })
        .collect();
    let text = table(&["scene", "off, %", "worst, %"], &lines);
    eprintln!("\n{target}, {what}\n{text}");
    by_scene
        .values()
        .map(|(worst, ..)| *worst)
        .fold(0.0, f64::max)
}

/// Prints how well scenes are foretold by the others: each is in one of some parts, which
/// are left out in turn.
fn crosswise(target: &str, rows: &[Row<'_>], before: &[f64]) {
    let mut names: Vec<&str> = rows.iter().map(|row| row.case.scene.as_str()).collect();
    names.dedup();
    let (mut sum, mut over, mut worst) = (0.0, 0, (0.0, ""));
    for fold in 0..FOLDS {
        let left_out = |row: &&Row<'_>| {
            let place = names.iter().position(|name| *name == row.case.scene);
            place.is_some_and(|place| place % FOLDS == fold)
        };
        let others: Vec<&Row> = rows.iter().filter(|row| !left_out(row)).collect();
        let each = fit(&others, before);
        for row in rows.iter().filter(left_out) {
            let off = row.off(&each).abs();
            sum += off;
            over += usize::from(off > MOST_PERCENT);
            if off > worst.0 {
                worst = (off, &row.case.scene);
            }
        }
    }
    eprintln!(
        "{target}: left out in turn, {} frames are off by {:.1} % in the mean, {over} by more \
         than {MOST_PERCENT} %, {} by {:.1} % at worst",
        rows.len(),
        sum / rows.len().max(1) as f64,
        worst.1,
        worst.0
    );
}

fn near_enough(worst: f64) -> Result<()> {
    if worst > MOST_PERCENT {
        return Err(format!("one is off by {worst:.1} %, {MOST_PERCENT} % are allowed").into());
    }
    Ok(())
}

/// A thousandth of an instruction is enough.
fn rounded(each: f64) -> f64 {
    (each * 1e3).round() / 1e3
}

/// What firmware takes, from the footprint's figures: the most of those with the same parts.
fn firmware(footprint: &Value) -> BTreeMap<String, BTreeMap<Parts, Firmware>> {
    let cases = [
        (Parts::Flat, "w1_teapot_flat"),
        (Parts::Gouraud, "w3_bunny_gouraud"),
        (Parts::Triangles, "w3_bunny_gouraud with all but rays"),
    ];
    let empty = Map::new();
    let mut all: BTreeMap<String, BTreeMap<Parts, Firmware>> = BTreeMap::new();
    for (parts, case) in cases {
        for (target, figures) in footprint[case].as_object().unwrap_or(&empty) {
            let figure = |name: &str| figures[name].as_u64().unwrap_or_default();
            let taken = Firmware {
                code_bytes: figure("code_bytes"),
                stack_bytes: figure("stack_bytes"),
            };
            all.entry(target.clone()).or_default().insert(parts, taken);
        }
    }
    all
}
