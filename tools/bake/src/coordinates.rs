//! Texture coordinates in 16 bits.

use fixel::scene::Coordinates;

use crate::error::{BakeError, Problem};

/// A mesh's coordinates as the blob has them, v from the top, and their record but for
/// the offset; none for a mesh without.
pub(crate) fn place(
    coordinates: &[[f64; 2]],
) -> Result<(Option<Coordinates>, Vec<[i16; 2]>), BakeError> {
    if coordinates.is_empty() {
        return Ok((None, Vec::new()));
    }
    let from_top = coordinates.iter().map(|[u, v]| [*u, 1.0 - v]);
    let from_top: Vec<[f64; 2]> = from_top.collect();
    let bounds = |axis: usize| {
        let all = from_top.iter().map(|c| c[axis]);
        let low = all.clone().fold(f64::INFINITY, f64::min);
        (low, all.fold(f64::NEG_INFINITY, f64::max))
    };
    let bounds = [bounds(0), bounds(1)];
    let range = bounds
        .iter()
        .fold(0.0, |m: f64, (low, high)| m.max(high - low));
    let farthest = bounds
        .iter()
        .fold(1.0, |m: f64, (low, high)| m.max(low.abs()).max(high.abs()));
    // Steps as fine as 16 bits allow, and the origin within 30.
    let finest = |most: f64, bits: f64| (bits - most.max(f64::MIN_POSITIVE).log2()).floor();
    let exponent = finest(range, 65534f64.log2())
        .min(finest(farthest, 30.0))
        .min(24.0);
    if exponent < 0.0 {
        let problem = Problem::Range {
            what: "the range of a mesh's texture coordinates".into(),
            value: range.max(farthest),
            most: 65534.0,
        };
        return Err(problem.into());
    }
    let steps = f64::exp2(exponent);
    let origin = bounds.map(|(low, high)| ((low + high) / 2.0 * steps).round());
    let stored = from_top.iter().map(|c| {
        [0, 1].map(|axis| {
            (c[axis] * steps - origin[axis])
                .round()
                .clamp(-32767.0, 32767.0) as i16
        })
    });
    let record = Coordinates {
        offset: 0,
        origin: origin.map(|c| c as i32),
        exponent: exponent as u8,
    };
    Ok((Some(record), stored.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_as_exact_as_16_bits() {
        for (scale, shift) in [(1.0, 0.0), (100.0, -50.0), (1e-3, 7.0), (30_000.0, 1e3)] {
            let made: Vec<[f64; 2]> = (0..=100)
                .map(|i| f64::from(i) / 100.0)
                .map(|part| [part * scale + shift, shift - part * part * scale])
                .collect();
            let (record, stored) = place(&made).unwrap();
            let record = record.unwrap();
            for (c, stored) in made.iter().zip(stored) {
                let back = [0, 1].map(|axis| {
                    let steps = f64::from(stored[axis]) + f64::from(record.origin[axis]);
                    steps / f64::exp2(record.exponent.into())
                });
                let off = (back[0] - c[0]).abs().max((1.0 - back[1] - c[1]).abs());
                assert!(off <= scale / 65534.0 + 1e-6, "{off} of {scale}");
            }
        }
        assert!(place(&[[0.0, 0.0], [1e9, 0.0]]).is_err());
        assert_eq!(place(&[]).unwrap(), (None, Vec::new()));
    }
}
