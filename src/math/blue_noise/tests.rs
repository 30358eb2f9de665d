use super::{PATTERN, SIDE, blue_noise};
use std::vec::Vec;

const CELLS: usize = SIDE * SIDE;

/// How near a cell is to another so many columns and rows away, round the edges: a
/// Gaussian of 1.5 cells, as whole numbers so that sums do not depend on their order.
fn nearness(from: usize, to: usize) -> u64 {
    let apart = |a: usize, b: usize| {
        let d = a.abs_diff(b);
        d.min(SIDE - d).pow(2) as f64
    };
    let square = apart(from % SIDE, to % SIDE) + apart(from / SIDE, to / SIDE);
    ((-square / (2.0 * 1.5 * 1.5)).exp() * f64::from(1 << 24)).round() as u64
}

struct Points {
    there: Vec<bool>,
    /// Sum of the nearness of all points that are there.
    crowd: Vec<u64>,
    near: Vec<u64>,
}

impl Points {
    fn toggle(&mut self, at: usize) {
        self.there[at] = !self.there[at];
        for cell in 0..CELLS {
            let column = (cell % SIDE + SIDE - at % SIDE) % SIDE;
            let row = (cell / SIDE + SIDE - at / SIDE) % SIDE;
            let near = self.near[row * SIDE + column];
            if self.there[at] {
                self.crowd[cell] += near;
            } else {
                self.crowd[cell] -= near;
            }
        }
    }

    fn tightest(&self) -> usize {
        let points = (0..CELLS).filter(|c| self.there[*c]);
        points.max_by_key(|c| self.crowd[*c]).unwrap()
    }

    fn emptiest(&self) -> usize {
        let gaps = (0..CELLS).filter(|c| !self.there[*c]);
        gaps.min_by_key(|c| self.crowd[*c]).unwrap()
    }
}

/// Ranks 0..1024 of the cells, divided by four.
fn void_and_cluster() -> Vec<u8> {
    let mut points = Points {
        there: std::vec![false; CELLS],
        crowd: std::vec![0; CELLS],
        near: (0..CELLS).map(|cell| nearness(0, cell)).collect(),
    };
    // A tenth, anywhere, then evened out.
    let mut seed = 1u32;
    let mut left = CELLS / 10;
    while left > 0 {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let at = (seed >> 16) as usize % CELLS;
        if !points.there[at] {
            points.toggle(at);
            left -= 1;
        }
    }
    loop {
        let tightest = points.tightest();
        points.toggle(tightest);
        let emptiest = points.emptiest();
        points.toggle(emptiest);
        if emptiest == tightest {
            break;
        }
    }
    let start = points.there.clone();
    let count = start.iter().filter(|there| **there).count();
    let mut ranks = std::vec![0; CELLS];
    for rank in (0..count).rev() {
        let tightest = points.tightest();
        points.toggle(tightest);
        ranks[tightest] = rank;
    }
    for at in (0..CELLS).filter(|at| start[*at]) {
        points.toggle(at);
    }
    // With a kernel that sums to the same everywhere, the emptiest gap is the tightest
    // cluster of gaps, too: one loop to the end.
    for rank in count..CELLS {
        let emptiest = points.emptiest();
        points.toggle(emptiest);
        ranks[emptiest] = rank;
    }
    ranks.into_iter().map(|rank| (rank / 4) as u8).collect()
}

/// `FIXEL_BLESS=1` writes the pattern anew.
#[test]
fn the_pattern_is_what_void_and_cluster_makes() {
    let made = void_and_cluster();
    if std::env::var_os("FIXEL_BLESS").is_some() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/src/math/blue_noise.bin");
        std::fs::write(file, &made).unwrap();
        return;
    }
    assert!(made == PATTERN, "not what is in blue_noise.bin");
}

#[test]
fn each_threshold_is_there_four_times_and_apart() {
    let mut count = [0; 256];
    for threshold in PATTERN {
        count[usize::from(threshold)] += 1;
    }
    assert_eq!(count, [4; 256]);
    // Of a tenth of all cells, no two touch.
    let is_low = |x: i32, y: i32| blue_noise([x, y]) < 25;
    for (x, y) in (0..32).flat_map(|y| (0..32).map(move |x| (x, y))) {
        let beside = is_low(x + 1, y) || is_low(x, y + 1) || is_low(x + 1, y + 1);
        assert!(!is_low(x, y) || !beside, "{x}, {y}");
    }
    assert_eq!(blue_noise([-1, -1]), blue_noise([31, 31]));
}
