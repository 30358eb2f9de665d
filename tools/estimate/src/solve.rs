//! Coefficients of a linear model, none of them negative, by least squares.

/// Passes over all coefficients; it stands still long before.
const PASSES: usize = 5_000;
/// How much a coefficient is drawn to 0, so that of two that always go together neither
/// runs away.
const RIDGE: f64 = 1e-6;

/// Finds `x`, no element negative, so that each row's `sum(a * x)` is as near as can be to
/// its count, in proportion to the count. Coordinate descent (Franc, Hlavac and Navara,
/// "Sequential coordinate-wise algorithm for the non-negative least squares problem",
/// 2005).
pub fn non_negative(rows: &[(Vec<f64>, f64)], columns: usize) -> Vec<f64> {
    // Columns are scaled to length 1, rows by what they are to give.
    let scaled: Vec<Vec<f64>> = rows
        .iter()
        .map(|(row, count)| row.iter().map(|a| a / count).collect())
        .collect();
    let lengths: Vec<f64> = (0..columns)
        .map(|c| scaled.iter().map(|row| row[c] * row[c]).sum::<f64>().sqrt())
        .collect();
    let dot = |a: usize, b: usize| -> f64 {
        let scale = lengths[a] * lengths[b];
        scaled.iter().map(|row| row[a] * row[b]).sum::<f64>() / scale.max(f64::MIN_POSITIVE)
    };
    let all = 0..columns;
    let products: Vec<Vec<f64>> = all
        .clone()
        .map(|a| {
            let ridge = |b| if a == b { RIDGE } else { 0.0 };
            all.clone().map(|b| dot(a, b) + ridge(b)).collect()
        })
        .collect();
    let mut x = vec![0.0; columns];
    // How far each product with the rest is from what is asked for.
    let mut off: Vec<f64> = (0..columns)
        .map(|c| {
            let sum: f64 = scaled.iter().map(|row| row[c]).sum();
            -sum / lengths[c].max(f64::MIN_POSITIVE)
        })
        .collect();
    for _ in 0..PASSES {
        for c in 0..columns {
            if lengths[c] == 0.0 {
                continue;
            }
            let new = f64::max(0.0, x[c] - off[c] / products[c][c]);
            let change = new - x[c];
            if change != 0.0 {
                x[c] = new;
                for (off, product) in off.iter_mut().zip(&products[c]) {
                    *off += change * product;
                }
            }
        }
    }
    x.iter()
        .zip(&lengths)
        .map(|(x, length)| if *length > 0.0 { x / length } else { 0.0 })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rows_are_made_of_is_found() {
        let made = |a: f64, b: f64| (vec![a, b, a * b], 5.0 * a + 700.0 * b);
        let rows = [
            made(1.0, 2.0),
            made(30.0, 1.0),
            made(200.0, 3.0),
            made(7.0, 7.0),
        ];
        let x = non_negative(&rows, 3);
        assert!(
            (x[0] - 5.0).abs() < 0.01 && (x[1] - 700.0).abs() < 0.1,
            "{x:?}"
        );
        assert!(x[2].abs() < 0.01, "{x:?}");
    }

    #[test]
    fn nothing_is_negative() {
        let rows = [(vec![1.0, 1.0], 1.0), (vec![1.0, 2.0], 0.5)];
        assert!(non_negative(&rows, 2).iter().all(|x| *x >= 0.0));
    }
}
