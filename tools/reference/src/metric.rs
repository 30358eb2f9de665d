//! Sums that become a report's figures.

use crate::report::PSNR_IDENTICAL_DB;

/// `part` of `whole`; 100 of none.
pub(crate) fn percent(part: usize, whole: usize) -> f64 {
    if whole == 0 {
        100.0
    } else {
        100.0 * part as f64 / whole as f64
    }
}

/// Maximum and mean of absolute differences.
#[derive(Default)]
pub(crate) struct Differences {
    pub count: usize,
    /// How many are within their limit.
    pub within: usize,
    sum: f64,
    pub max: f64,
    /// The pixel of the maximum.
    pub max_at: Option<usize>,
}

impl Differences {
    pub fn add(&mut self, pixel: usize, difference: f64, limit: f64) {
        let size = difference.abs();
        self.count += 1;
        self.within += usize::from(size <= limit);
        self.sum += size;
        if self.max_at.is_none() || size > self.max {
            self.max = size;
            self.max_at = Some(pixel);
        }
    }

    pub fn mean(&self) -> f64 {
        self.sum / self.count.max(1) as f64
    }
}

/// Peak signal-to-noise ratio for a peak of 255.
#[derive(Default)]
pub(crate) struct Psnr {
    squares: f64,
    values: usize,
}

impl Psnr {
    pub fn add(&mut self, a: [f64; 3], b: [f64; 3]) {
        self.squares += a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        self.values += 3;
    }

    pub fn db(&self) -> f64 {
        let mean = self.squares / self.values as f64;
        // Infinite without any difference.
        (10.0 * (255.0 * 255.0 / mean).log10()).min(PSNR_IDENTICAL_DB)
    }
}

/// PSNR of one picture against another of the same size, for a peak of 255, at most
/// [`PSNR_IDENTICAL_DB`].
pub fn psnr_db(picture: &[[u8; 3]], wanted: &[[u8; 3]]) -> f64 {
    let mut psnr = Psnr::default();
    for (a, b) in picture.iter().zip(wanted) {
        psnr.add(a.map(f64::from), b.map(f64::from));
    }
    psnr.db()
}
