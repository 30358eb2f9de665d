//! `[ray]`.

use super::table::{Keys, Table};
use crate::description::Ray;
use crate::error::Error;

pub(super) const RAY: Keys = Keys {
    known: &["shadows", "depth", "samples", "threshold", "light_samples"],
    later: &[],
};

/// Reads how rays are cast.
pub(super) fn ray(table: Option<&Table<'_, '_>>) -> Result<Ray, Error> {
    let mut ray = Ray::default();
    let Some(table) = table else {
        return Ok(ray);
    };
    if let Some(shadows) = table.boolean("shadows")? {
        ray.shadows = shadows;
    }
    if let Some(threshold) = table.number("threshold", 0.0..=1.0)? {
        ray.threshold = threshold;
    }
    for (key, value, range) in [
        ("depth", &mut ray.depth, 1..=8),
        ("samples", &mut ray.samples, 1..=16),
        ("light_samples", &mut ray.light_samples, 1..=16),
    ] {
        if let Some(number) = table.whole(key, range)? {
            *value = number;
        }
    }
    if ![1, 4, 8, 16].contains(&ray.samples) {
        let what = format!("{} is out of range; expected 1, 4, 8 or 16", ray.samples);
        return Err(table.error("samples", what));
    }
    Ok(ray)
}
