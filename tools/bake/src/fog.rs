//! Fog in the blob's records, and the colours that it makes.

use fixel::scene::layout::FOG_ROWS;
use fixel::scene::{self as core_scene};
use fixel_scene::{Fog, FogMode, Rgb};

use crate::units::Units;

/// Steps between the rows of the fog table.
const STEPS: f64 = (FOG_ROWS - 1) as f64;

/// How much fog there is at a distance along the line of sight, 0..=1.
pub(crate) fn factor(fog: &Fog, distance: f64) -> f64 {
    let part = match fog.mode {
        FogMode::Linear { start, end } => (distance - start) / (end - start),
        FogMode::Exponential { density } => 1.0 - libm::exp(-density * distance),
        FogMode::ExponentialSquared { density } => {
            1.0 - libm::exp(-(density * distance) * (density * distance))
        }
    };
    part.clamp(0.0, 1.0)
}

/// The distance at which there is so much fog; `part` is below 1.
fn distance(fog: &Fog, part: f64) -> f64 {
    match fog.mode {
        FogMode::Linear { start, end } => start + (end - start) * part,
        FogMode::Exponential { density } => -libm::log(1.0 - part) / density,
        FogMode::ExponentialSquared { density } => libm::sqrt(-libm::log(1.0 - part)) / density,
    }
}

/// A colour in fog.
pub(crate) fn fogged(fog: &Fog, colour: Rgb, part: f64) -> Rgb {
    [0, 1, 2].map(|c| colour[c] + (fog.colour[c] - colour[c]) * part)
}

/// The colour of a row of the fog table.
pub(crate) fn fogged_row(fog: &Fog, colour: Rgb, row: usize) -> Rgb {
    fogged(fog, colour, row as f64 / STEPS)
}

/// The record. What is farther than a world length holds is farther than all there
/// is.
pub(crate) fn fog(fog: &Fog, units: &Units) -> core_scene::Fog {
    let length = |distance| units.bits(distance).unwrap_or(i32::MAX);
    core_scene::Fog {
        colour: fog.colour.map(|c| (c * 255.0).round() as u8),
        mode: match fog.mode {
            FogMode::Linear { .. } => core_scene::FogMode::Linear,
            FogMode::Exponential { .. } => core_scene::FogMode::Exponential,
            FogMode::ExponentialSquared { .. } => core_scene::FogMode::ExponentialSquared,
        },
        distances: std::array::from_fn(|r| length(distance(fog, (r as f64 + 0.5) / STEPS))),
    }
}

/// The description of a record; `length` gives scene units.
pub(crate) fn unbake(fog: &core_scene::Fog, length: impl Fn(i32) -> f64) -> Fog {
    // The thickest row that is not beyond all lengths says most.
    let known = |d: &i32| *d < i32::MAX && *d > 0;
    let row = fog.distances.iter().rposition(known).unwrap_or(0);
    let part = (row as f64 + 0.5) / STEPS;
    let far = length(fog.distances[row]).max(f64::MIN_POSITIVE);
    let first = length(fog.distances[0]);
    let exponent = -libm::log(1.0 - part);
    Fog {
        colour: fog.colour.map(|c| f64::from(c) / 255.0),
        mode: match fog.mode {
            core_scene::FogMode::Linear => {
                let all = (far - first) / (row.max(1) as f64 / STEPS);
                let start = first - all * 0.5 / STEPS;
                FogMode::Linear {
                    start,
                    end: start + all.max(f64::MIN_POSITIVE),
                }
            }
            core_scene::FogMode::Exponential => FogMode::Exponential {
                density: exponent / far,
            },
            core_scene::FogMode::ExponentialSquared => FogMode::ExponentialSquared {
                density: libm::sqrt(exponent) / far,
            },
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn modes() -> [FogMode; 3] {
        [
            FogMode::Linear {
                start: 3.0,
                end: 28.0,
            },
            FogMode::Exponential { density: 0.07 },
            FogMode::ExponentialSquared { density: 0.05 },
        ]
    }

    #[test]
    fn a_row_begins_half_a_step_before_its_own_fog() {
        for mode in modes() {
            let fog = Fog {
                colour: [0.5; 3],
                mode,
            };
            for step in 0..31 {
                let part = (f64::from(step) + 0.5) / 31.0;
                let found = factor(&fog, distance(&fog, part));
                assert!((found - part).abs() < 1e-12, "{mode:?}: {part} {found}");
            }
        }
    }

    #[test]
    fn a_record_tells_what_fog_it_was() {
        for mode in modes() {
            let fog = Fog {
                colour: [0.2, 0.4, 0.6],
                mode,
            };
            let distances = std::array::from_fn(|r| {
                (distance(&fog, (r as f64 + 0.5) / STEPS) * 65536.0).round() as i32
            });
            let mode = match mode {
                FogMode::Linear { .. } => core_scene::FogMode::Linear,
                FogMode::Exponential { .. } => core_scene::FogMode::Exponential,
                FogMode::ExponentialSquared { .. } => core_scene::FogMode::ExponentialSquared,
            };
            let record = core_scene::Fog {
                colour: [51, 102, 153],
                mode,
                distances,
            };
            let back = unbake(&record, |bits| f64::from(bits) / 65536.0);
            for tenths in 0..400 {
                let w = f64::from(tenths) / 10.0;
                assert!(
                    (factor(&back, w) - factor(&fog, w)).abs() < 1e-4,
                    "{back:?} {w}"
                );
            }
        }
    }
}
