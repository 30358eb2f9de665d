//! Pixels as the bytes of a PNG file.

use png::{BitDepth, ColorType, Encoder, EncodingError};

/// A PNG of 8 bits a channel. Pixels go by rows from the top left.
///
/// # Errors
/// If there are not `width * height` pixels.
pub fn png_rgb(width: u32, height: u32, pixels: &[[u8; 3]]) -> Result<Vec<u8>, EncodingError> {
    let bytes = pixels.as_flattened();
    png(width, height, ColorType::Rgb, BitDepth::Eight, bytes)
}

/// A PNG of 16-bit greys.
///
/// # Errors
/// If there are not `width * height` pixels.
pub fn png_grey16(width: u32, height: u32, pixels: &[u16]) -> Result<Vec<u8>, EncodingError> {
    let bytes: Vec<u8> = pixels.iter().flat_map(|v| v.to_be_bytes()).collect();
    let depth = BitDepth::Sixteen;
    png(width, height, ColorType::Grayscale, depth, &bytes)
}

fn png(
    width: u32,
    height: u32,
    colour: ColorType,
    depth: BitDepth,
    bytes: &[u8],
) -> Result<Vec<u8>, EncodingError> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(bytes)?;
    writer.finish()?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(file: &[u8]) -> (u32, u32, Vec<u8>) {
        let decoder = png::Decoder::new(std::io::Cursor::new(file));
        let mut reader = decoder.read_info().expect("a PNG");
        let mut bytes = vec![0; reader.output_buffer_size().expect("small")];
        let info = reader.next_frame(&mut bytes).expect("whole");
        (info.width, info.height, bytes)
    }

    #[test]
    fn pixels_come_back() {
        let file = png_rgb(2, 1, &[[1, 2, 3], [4, 5, 6]]).expect("two pixels");
        assert_eq!(read(&file), (2, 1, vec![1, 2, 3, 4, 5, 6]));
        let file = png_grey16(1, 2, &[0x1234, 5]).expect("two pixels");
        assert_eq!(read(&file), (1, 2, vec![0x12, 0x34, 0, 5]));
        assert!(png_rgb(2, 2, &[[0; 3]]).is_err());
    }
}
