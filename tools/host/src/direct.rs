//! Frames without a palette.

use fixel::Scene;
use fixel::frame::Band;
use fixel::render::Bands;
use fixel::scene::{Dither, Pose};

use crate::colour::widened;
use crate::planes::HostScratch;

/// The pixels of a scene that is baked without a palette, in bands of `rows` rows, as the
/// panel shows them; none of another scene.
pub fn direct(
    scene: &Scene<'_>,
    size: (u16, u16),
    rows: u16,
    frame: u32,
    dither: Dither,
) -> Vec<[u8; 3]> {
    direct_posed(scene, size, rows, scene.pose(frame), dither)
}

/// The same of a pose, whatever its height.
pub(crate) fn direct_posed(
    scene: &Scene<'_>,
    (width, height): (u16, u16),
    rows: u16,
    mut pose: Pose<'_>,
    dither: Dither,
) -> Vec<[u8; 3]> {
    let pixels = usize::from(width.max(1)) * usize::from(rows.max(1));
    let (mut colours, mut depths) = (vec![0; pixels], vec![0; pixels]);
    pose.height = height;
    let mut scratch = Box::new(HostScratch::new());
    let mut work = scratch.workspace();
    let mut all = Vec::new();
    if let Ok(mut band) = Band::new(width, &mut colours, &mut depths)
        && let Some(mut bands) = Bands::direct(scene, &pose, dither, &mut work, &mut band)
    {
        while let Some(rows) = bands.next() {
            all.extend(rows.indices.iter().map(|c| widened(u16::from_be(*c))));
        }
    }
    all
}
