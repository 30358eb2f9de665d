//! How many rays a picture took.

use std::sync::atomic::{AtomicU64, Ordering};

/// Rays of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// From the eye.
    pub camera: u64,
    /// Mirrored, refracted and straight through.
    pub bounced: u64,
    /// To lights.
    pub shadow: u64,
}

/// The same while many threads count.
#[derive(Debug, Default)]
pub(crate) struct Counters {
    camera: AtomicU64,
    bounced: AtomicU64,
    shadow: AtomicU64,
}

impl Counters {
    pub fn camera(&self) {
        self.camera.fetch_add(1, Ordering::Relaxed);
    }

    pub fn bounced(&self) {
        self.bounced.fetch_add(1, Ordering::Relaxed);
    }

    pub fn shadow(&self) {
        self.shadow.fetch_add(1, Ordering::Relaxed);
    }

    /// What they stand at.
    pub fn read(&self) -> RayCounts {
        let read = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
        RayCounts {
            camera: read(&self.camera),
            bounced: read(&self.bounced),
            shadow: read(&self.shadow),
        }
    }
}
