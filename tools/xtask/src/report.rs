//! What was checked and how it went, and where figures go.

use std::io::Write;
use std::path::Path;

use serde_json::Value;

use crate::problem::{Problem, Result};

/// Checks, counted and named on standard error as they end.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Checks that passed.
    pub passed: usize,
    /// Names of those that failed.
    pub failed: Vec<String>,
    /// Names of those that could not be made here, and why.
    pub skipped: Vec<String>,
}

impl Tally {
    /// Counts a check by its result; hands its value on if it passed.
    pub fn check<T>(&mut self, name: &str, result: Result<T>) -> Option<T> {
        match result {
            Ok(value) => {
                self.passed += 1;
                eprintln!("ok    {name}");
                Some(value)
            }
            Err(Problem::Missing(why)) => {
                self.skip(name, &why);
                None
            }
            Err(Problem::Failed(why)) => {
                self.failed.push(name.to_owned());
                eprintln!("FAIL  {name}: {why}");
                None
            }
        }
    }

    /// Like [`Tally::check`] for something that is only a means: nothing is
    /// counted when it works.
    pub fn need<T>(&mut self, name: &str, result: Result<T>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(problem) => self.check(name, Err(problem)),
        }
    }

    /// Counts a check that cannot be made.
    pub fn skip(&mut self, name: &str, why: &str) {
        self.skipped.push(format!("{name}: {why}"));
        eprintln!("skip  {name}: {why}");
    }

    /// Takes in another tally.
    pub fn add(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed.extend(other.failed);
        self.skipped.extend(other.skipped);
    }

    /// Fails if a check did.
    pub fn result(&self) -> Result<()> {
        match self.failed.as_slice() {
            [] => Ok(()),
            [one] => Err(format!("{one} failed").into()),
            [first, others @ ..] => Err(format!("{first} and {} more failed", others.len()).into()),
        }
    }

    /// `N passed, N failed, N skipped`.
    pub fn summary(&self) -> String {
        format!(
            "{} passed, {} failed, {} skipped",
            self.passed,
            self.failed.len(),
            self.skipped.len()
        )
    }
}

/// Writes figures as JSON to a file, or to standard output for `-`.
pub fn write_json(to: &str, value: &Value) -> Result<()> {
    let text = serde_json::to_string_pretty(value).map_err(|error| error.to_string())? + "\n";
    if to == "-" {
        let written = std::io::stdout().write_all(text.as_bytes());
        return written.map_err(|error| format!("standard output: {error}").into());
    }
    Ok(fixel_output::write(Path::new(to), text.as_bytes())?)
}

/// A table in Markdown, columns padded, the first to the left, others to the
/// right.
pub fn table(head: &[&str], rows: &[Vec<String>]) -> String {
    let widths: Vec<usize> = (0..head.len())
        .map(|column| {
            let cells = rows.iter().filter_map(|row| row.get(column));
            let cells = cells.map(|cell| cell.chars().count());
            cells
                .chain([head[column].chars().count(), 3])
                .max()
                .unwrap_or(3)
        })
        .collect();
    let line = |cells: Vec<String>| {
        let mut text = String::from("|");
        for (column, (cell, width)) in cells.iter().zip(&widths).enumerate() {
            match column {
                0 => text.push_str(&format!(" {cell:<width$} |")),
                _ => text.push_str(&format!(" {cell:>width$} |")),
            }
        }
        text + "\n"
    };
    let mut text = line(head.iter().map(|&cell| cell.into()).collect());
    let rule = widths
        .iter()
        .enumerate()
        .map(|(column, &width)| match column {
            0 => "-".repeat(width),
            _ => "-".repeat(width - 1) + ":",
        });
    text.push_str(&line(rule.collect()));
    for row in rows {
        text.push_str(&line(row.clone()));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_failure_fails() {
        let mut tally = Tally::default();
        tally.check("a", Ok(()));
        tally.check::<()>("b", Err(Problem::Missing("no b".into())));
        assert!(tally.result().is_ok());
        tally.check::<()>("c", Err("broken".into()));
        assert!(tally.result().is_err());
        assert_eq!(tally.summary(), "1 passed, 1 failed, 1 skipped");
    }

    #[test]
    fn columns_line_up() {
        let rows = [
            vec!["a".into(), "1".into()],
            vec!["bcd".into(), "1000".into()],
        ];
        let text = table(&["x", "n"], &rows);
        assert_eq!(
            text,
            "| x   |    n |\n| --- | ---: |\n| a   |    1 |\n| bcd | 1000 |\n"
        );
    }
}
