//! Key frames.

use fixel_scene::{Animation, Quantity, Target};

/// A quantity in a frame: `plain` if nothing moves it, otherwise linear between its
/// keys and constant outside them.
pub(crate) fn sample(
    animation: &Animation,
    target: Target,
    quantity: Quantity,
    frame: u32,
    plain: [f64; 3],
) -> [f64; 3] {
    let mut tracks = animation.tracks.iter();
    let Some(track) = tracks.find(|t| t.target == target && t.quantity == quantity) else {
        return plain;
    };
    let frame = match animation.frames {
        Some(frames) => frame % frames,
        None => frame,
    };
    let keys = &track.keys;
    let mut value = keys[0].value;
    for pair in keys.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        if frame >= from.frame {
            let t = f64::from(frame - from.frame) / f64::from(to.frame - from.frame);
            let t = t.min(1.0);
            value = std::array::from_fn(|i| from.value[i] * (1.0 - t) + to.value[i] * t);
        }
    }
    value
}
