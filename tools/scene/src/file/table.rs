//! Typed access to one TOML table. Every key is either known, or known for
//! later, or a mistake: nothing in a scene file is silently ignored.

use std::ops::{Range, RangeInclusive};

use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use crate::error::Error;
use crate::files::Origin;

/// The text of a scene file, to find lines in.
#[derive(Debug)]
pub(crate) struct Source<'a> {
    pub origin: Origin<'a>,
    text: &'a str,
    /// Where lines end: each table's line is asked for.
    ends: Vec<usize>,
}

impl<'a> Source<'a> {
    pub fn new(origin: Origin<'a>, text: &'a str) -> Self {
        let ends = text.match_indices('\n').map(|(at, _)| at).collect();
        Self { origin, text, ends }
    }

    /// Line and column, from 1, of a byte offset.
    pub fn place(&self, offset: usize) -> (usize, usize) {
        let before = self.ends.partition_point(|end| *end < offset);
        let begin = before.checked_sub(1).map_or(0, |line| self.ends[line] + 1);
        let left = self.text.get(begin..offset).unwrap_or_default();
        (before + 1, left.chars().count() + 1)
    }

    pub fn error(&self, offset: usize, message: impl Into<String>) -> Error {
        Error::at_line(self.origin.path, self.place(offset).0, message)
    }
}

/// The value at which a key of a later capability says nothing.
#[derive(Debug)]
pub(crate) enum Neutral {
    /// There is none: the key itself asks for the capability.
    Never,
    /// A string.
    Text(&'static str),
}

/// The keys of one kind of table.
#[derive(Debug)]
pub(crate) struct Keys {
    pub known: &'static [&'static str],
    pub later: &'static [(&'static str, Neutral)],
}

/// One table whose keys have been checked.
#[derive(Debug)]
pub(crate) struct Table<'t, 'i> {
    pub source: &'t Source<'t>,
    name: &'static str,
    table: &'t DeTable<'i>,
    header: Range<usize>,
}

impl<'t, 'i> Table<'t, 'i> {
    /// Checks the keys. `name` is how messages call the table; the root has
    /// an empty one.
    pub fn new(
        source: &'t Source<'t>,
        name: &'static str,
        table: &'t DeTable<'i>,
        header: Range<usize>,
        keys: &Keys,
    ) -> Result<Self, Error> {
        let this = Self {
            source,
            name,
            table,
            header,
        };
        // In the file's order, so that the first mistake is the one reported.
        let mut entries: Vec<_> = table.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        for (key, value) in entries {
            let word: &str = key.get_ref();
            if keys.known.contains(&word) {
                continue;
            }
            match keys.later.iter().find(|(later, _)| *later == word) {
                Some((_, neutral)) if neutral.is(value.get_ref()) => {}
                Some((_, neutral)) => {
                    return Err(this.not_yet(word, key.span().start, neutral));
                }
                None => {
                    return Err(source.error(
                        key.span().start,
                        format!("{}: {}", this.field(word), unknown(word, keys)),
                    ));
                }
            }
        }
        Ok(this)
    }

    fn not_yet(&self, key: &str, offset: usize, neutral: &Neutral) -> Error {
        let but = match neutral {
            Neutral::Never => "; expected no such key".to_owned(),
            Neutral::Text(value) => format!("; expected {key} = \"{value}\", or no such key"),
        };
        self.source.error(
            offset,
            format!("{}: is not supported yet{but}", self.field(key)),
        )
    }

    /// How messages call a key.
    pub fn field(&self, key: &str) -> String {
        if self.name.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.name)
        }
    }

    /// An error about a key: at its value, or at the table's header if the
    /// key is missing.
    pub fn error(&self, key: &str, message: impl AsRef<str>) -> Error {
        let offset = match self.get(key) {
            Some(value) => value.span().start,
            None => self.header.start,
        };
        self.source
            .error(offset, format!("{}: {}", self.field(key), message.as_ref()))
    }

    /// An error about a file that a key names, with an example if `what` has none.
    pub fn file_error(&self, key: &str, name: &str, what: &str, example: &str) -> Error {
        let expected = if what.contains("expected") {
            String::new()
        } else {
            format!(
                "; expected a file's name, relative to the scene file, e.g. {key} = \"{example}\""
            )
        };
        self.error(key, format!("\"{name}\" {what}{expected}"))
    }

    /// The raw value.
    pub fn get(&self, key: &str) -> Option<&'t Spanned<DeValue<'i>>> {
        self.table.get(key)
    }

    /// Whether the file has the key.
    pub fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// A string.
    pub fn text(&self, key: &str, example: &str) -> Result<Option<&'t str>, Error> {
        match self.get(key).map(Spanned::get_ref) {
            None => Ok(None),
            Some(DeValue::String(text)) => Ok(Some(text)),
            Some(other) => Err(self.error(
                key,
                format!(
                    "{} is not a string; expected e.g. {key} = \"{example}\"",
                    found(other)
                ),
            )),
        }
    }

    /// A number in a range.
    pub fn number(&self, key: &str, range: RangeInclusive<f64>) -> Result<Option<f64>, Error> {
        let Some(value) = self.get(key) else {
            return Ok(None);
        };
        let expected = format!("expected a number in {}..={}", range.start(), range.end());
        let number = to_f64(value.get_ref()).ok_or_else(|| {
            let found = found(value.get_ref());
            self.error(key, format!("{found} is not a number; {expected}"))
        })?;
        if range.contains(&number) {
            Ok(Some(number))
        } else {
            Err(self.error(key, format!("{number} is out of range; {expected}")))
        }
    }

    /// True or false.
    pub fn boolean(&self, key: &str) -> Result<Option<bool>, Error> {
        match self.get(key).map(Spanned::get_ref) {
            None => Ok(None),
            Some(DeValue::Boolean(value)) => Ok(Some(*value)),
            Some(other) => Err(self.error(
                key,
                format!(
                    "{} is neither true nor false; expected e.g. {key} = true",
                    found(other)
                ),
            )),
        }
    }

    /// A whole number in a range.
    pub fn whole(&self, key: &str, range: RangeInclusive<u32>) -> Result<Option<u32>, Error> {
        let Some(value) = self.get(key) else {
            return Ok(None);
        };
        let expected = format!(
            "expected a whole number in {}..={}",
            range.start(),
            range.end()
        );
        let DeValue::Integer(integer) = value.get_ref() else {
            let found = found(value.get_ref());
            return Err(self.error(key, format!("{found} is not a whole number; {expected}")));
        };
        match u32::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(number) if range.contains(&number) => Ok(Some(number)),
            _ => Err(self.error(key, format!("{integer} is out of range; {expected}"))),
        }
    }

    /// `N` numbers, each within `±limit`.
    pub fn numbers<const N: usize>(
        &self,
        key: &str,
        limit: f64,
        example: &str,
    ) -> Result<Option<[f64; N]>, Error> {
        let Some(array) = self.array(key, example)? else {
            return Ok(None);
        };
        let wrong =
            |what: &str| self.error(key, format!("{what}; expected e.g. {key} = {example}"));
        if array.len() != N {
            return Err(wrong(&format!(
                "has {} numbers where {N} belong",
                array.len()
            )));
        }
        let mut numbers = [0.0; N];
        for (number, value) in numbers.iter_mut().zip(array.iter()) {
            *number = to_f64(value.get_ref()).ok_or_else(|| {
                let found = found(value.get_ref());
                wrong(&format!("holds {found}, which is not a number"))
            })?;
            if !(-limit..=limit).contains(number) {
                return Err(wrong(&format!(
                    "{number} is out of range (-{limit:e}..={limit:e})"
                )));
            }
        }
        Ok(Some(numbers))
    }

    /// An array of any length.
    pub fn array(&self, key: &str, example: &str) -> Result<Option<&'t DeArray<'i>>, Error> {
        match self.get(key).map(Spanned::get_ref) {
            None => Ok(None),
            Some(DeValue::Array(array)) => Ok(Some(array)),
            Some(other) => Err(self.error(
                key,
                format!(
                    "{} is not an array; expected e.g. {key} = {example}",
                    found(other)
                ),
            )),
        }
    }

    /// One of a few words; `later` are words of later capabilities.
    pub fn choice<T: Copy>(
        &self,
        key: &str,
        words: &[(&str, T)],
        later: &[&str],
    ) -> Result<Option<T>, Error> {
        let example = words.first().map_or("", |(word, _)| *word);
        let Some(text) = self.text(key, example)? else {
            return Ok(None);
        };
        if let Some((_, value)) = words.iter().find(|(word, _)| *word == text) {
            return Ok(Some(*value));
        }
        let listed: Vec<_> = words
            .iter()
            .map(|(word, _)| format!("\"{word}\""))
            .collect();
        let what = if later.contains(&text) {
            "is not supported yet"
        } else {
            "is unknown"
        };
        let expected = listed.join(" or ");
        Err(self.error(key, format!("\"{text}\" {what}; expected {expected}")))
    }
}

impl Neutral {
    fn is(&self, value: &DeValue<'_>) -> bool {
        match self {
            Neutral::Never => false,
            Neutral::Text(text) => matches!(value, DeValue::String(found) if found == text),
        }
    }
}

/// The number that a value stands for; infinities and NaN included, so that
/// the range check can name them.
pub(crate) fn to_f64(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
            .ok()
            .map(|integer| integer as f64),
        _ => None,
    }
}

/// A value as a message calls it.
fn found(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) if text.len() <= 40 => format!("\"{text}\""),
        DeValue::String(_) => "a long text".into(),
        DeValue::Integer(integer) => integer.to_string(),
        DeValue::Float(float) => float.to_string(),
        DeValue::Boolean(value) => value.to_string(),
        DeValue::Datetime(date) => date.to_string(),
        DeValue::Array(_) => "an array".into(),
        DeValue::Table(_) => "a table".into(),
    }
}

/// Letters of a word that is compared with others.
const MOST_LETTERS: usize = 100;

/// Text for a key that no table of this kind has.
fn unknown(word: &str, keys: &Keys) -> String {
    let all = || {
        let later = keys.later.iter().map(|(later, _)| *later);
        keys.known.iter().copied().chain(later)
    };
    // A word as long as a file is like none of them.
    let near = word.len() <= MOST_LETTERS;
    let distance = |key: &&str| strsim::damerau_levenshtein(word, key);
    match all().filter(|_| near).min_by_key(distance) {
        Some(key) if distance(&key) * 2 <= word.len().max(3) => {
            format!("is an unknown key; did you mean {key}?")
        }
        _ => format!(
            "is an unknown key; expected one of {}",
            keys.known.join(", ")
        ),
    }
}
