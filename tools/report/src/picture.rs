//! Pictures within the page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// A picture as an address that holds it.
pub(crate) fn address(width: u32, height: u32, rgb: &[[u8; 3]]) -> String {
    // The number of pixels is the picture's own.
    let png = fixel_output::png_rgb(width, height, rgb).unwrap_or_default();
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// The same, at most so wide: means of whole blocks of pixels.
pub(crate) fn thumbnail(width: u32, height: u32, rgb: &[[u8; 3]], most: u32) -> String {
    let step = width.div_ceil(most.max(1)).max(1);
    let (columns, rows) = (width / step, height / step);
    if columns == 0 || rows == 0 {
        return address(width, height, rgb);
    }
    let mean = |x: u32, y: u32| {
        let block = (0..step).flat_map(|dy| (0..step).map(move |dx| (dx, dy)));
        let at = |(dx, dy)| ((y * step + dy) * width + x * step + dx) as usize;
        let sum = block.fold([0; 3], |sum: [u32; 3], place| {
            let pixel = rgb.get(at(place)).copied().unwrap_or_default();
            [0, 1, 2].map(|c| sum[c] + u32::from(pixel[c]))
        });
        sum.map(|sum| ((sum + step * step / 2) / (step * step)) as u8)
    };
    let pixels = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
    let pixels: Vec<[u8; 3]> = pixels.map(|(x, y)| mean(x, y)).collect();
    address(columns, rows, &pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_become_their_means() {
        let rgb = [[0; 3], [10; 3], [0; 3], [255; 3], [0; 3], [9; 3]];
        assert_eq!(thumbnail(3, 2, &rgb, 2), address(1, 1, &[[66; 3]]));
        assert_eq!(thumbnail(3, 2, &rgb, 3), address(3, 2, &rgb));
        assert_eq!(thumbnail(3, 2, &rgb, 1), address(3, 2, &rgb));
    }
}
