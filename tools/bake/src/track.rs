//! Key frames, in the blob's formats.

use fixel::scene::{self as core_scene, layout};
use fixel_scene::{Element, Quantity, Scene, Target, Track};
use glam::DVec3;

use crate::error::{BakeError, Spot};
use crate::placement::Placed;
use crate::units::Units;

/// All tracks, and all keys in the order of their tracks.
pub(crate) fn tracks(
    scene: &Scene,
    units: &Units,
    placed: &[Placed],
) -> Result<(Vec<core_scene::Track>, Vec<core_scene::Key>), BakeError> {
    let (mut tracks, mut keys) = (Vec::new(), Vec::new());
    for track in &scene.animation.tracks {
        tracks.push(core_scene::Track {
            target: match track.target {
                Target::Actor(index) => index as u16,
                Target::Camera | Target::Viewport(_) => layout::CAMERA,
            },
            viewport: match track.target {
                Target::Viewport(number) => Some(number as u8),
                _ => None,
            },
            quantity: quantity(track.quantity),
            first_key: keys.len() as u32,
            keys: track.keys.len() as u32,
        });
        for key in &track.keys {
            keys.push(core_scene::Key {
                frame: key.frame,
                values: values(scene, units, placed, track, key.value)?,
            });
        }
    }
    Ok((tracks, keys))
}

fn quantity(quantity: Quantity) -> core_scene::Quantity {
    match quantity {
        Quantity::Position => core_scene::Quantity::Position,
        Quantity::FocalPoint => core_scene::Quantity::FocalPoint,
        Quantity::Orientation => core_scene::Quantity::Orientation,
        Quantity::Scale => core_scene::Quantity::Scale,
        Quantity::Azimuth => core_scene::Quantity::Azimuth,
        Quantity::Elevation => core_scene::Quantity::Elevation,
        Quantity::Roll => core_scene::Quantity::Roll,
        Quantity::Dolly => core_scene::Quantity::Dolly,
        Quantity::Zoom => core_scene::Quantity::Zoom,
        Quantity::Pan => core_scene::Quantity::Pan,
    }
}

/// A key's numbers; see [`core_scene::Quantity`].
fn values(
    scene: &Scene,
    units: &Units,
    placed: &[Placed],
    track: &Track,
    value: [f64; 3],
) -> Result<[i32; 3], BakeError> {
    let fixed = |unit: f64| {
        value.map(|v| {
            let bits = (v * unit * f64::exp2(24.0)).round();
            bits.clamp(f64::from(i32::MIN), f64::from(i32::MAX)) as i32
        })
    };
    let spot = |what| Spot::new(Element::Animation, what);
    match (track.target, track.quantity) {
        (Target::Actor(index), Quantity::Position) => {
            placed[index].position(units, (index, &scene.actors[index]), value)
        }
        (_, Quantity::Position) => units.place(spot("animation.key.position"), DVec3::from(value)),
        (_, Quantity::FocalPoint) => {
            units.place(spot("animation.key.focal_point"), DVec3::from(value))
        }
        (_, Quantity::Pan) => units.vector(spot("animation.key.pan"), DVec3::from(value)),
        (_, Quantity::Orientation | Quantity::Azimuth | Quantity::Elevation | Quantity::Roll) => {
            Ok(fixed(1.0 / 360.0))
        }
        (_, Quantity::Scale | Quantity::Dolly | Quantity::Zoom) => Ok(fixed(1.0)),
    }
}
