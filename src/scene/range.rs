//! Numbers of a blob, held against their ranges.

use super::{Field, SceneError, Section};

/// The greatest place where `count` things can begin among `all`; below 0 if there are not as
/// many. Neither is near the ends of its type: one is in memory, the other in a record.
pub(super) fn last(all: usize, count: i64) -> i64 {
    (all as i64).wrapping_sub(count)
}

pub(super) fn count(
    section: Section,
    count: usize,
    least: usize,
    most: usize,
) -> Result<(), SceneError> {
    range(
        section,
        0,
        Field::Count,
        count as i64,
        least as i64,
        most as i64,
    )
}

/// Inlined, because most comparisons are with constants, and the rest is a call elsewhere.
#[inline(always)]
pub(super) fn range(
    section: Section,
    index: usize,
    field: Field,
    value: i64,
    least: i64,
    most: i64,
) -> Result<(), SceneError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(out_of_range(section, index, field, value))
    }
}

#[cold]
#[inline(never)]
fn out_of_range(section: Section, index: usize, field: Field, value: i64) -> SceneError {
    SceneError::Record {
        section,
        index,
        field,
        value,
    }
}
