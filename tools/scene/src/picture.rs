//! Pictures: PNG and JPEG, told apart by their first bytes.

use std::io::Cursor;

use image::{ImageError, ImageFormat, ImageReader, Limits};

use crate::texture::Texture;

/// More than this a side is no picture for a microcontroller.
const MOST_PX: u32 = 4096;
/// What decoding may take.
const MOST_BYTES: u64 = 512 << 20;

/// Pixels by rows from the top left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Picture {
    pub width: u32,
    pub height: u32,
    /// Display-encoded red, green, blue, and alpha, which is 255 where all is
    /// covered.
    pub pixels: Vec<[u8; 4]>,
}

impl Picture {
    /// As a texture of a name.
    pub(crate) fn texture(self, name: &str) -> Texture {
        Texture {
            name: name.to_owned(),
            width: self.width,
            height: self.height,
            texels: self.pixels,
        }
    }
}

/// The picture in a file's bytes; 16 bits a channel become 8.
pub(crate) fn decode(bytes: &[u8]) -> Result<Picture, String> {
    let broken = |error: ImageError| format!("is no valid picture: {error}");
    let format = image::guess_format(bytes).ok();
    let format = format
        .filter(|format| matches!(format, ImageFormat::Png | ImageFormat::Jpeg))
        .ok_or("is not a kind of picture; expected a PNG or a JPEG file")?;
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    limits.max_image_width = Some(MOST_PX);
    limits.max_image_height = Some(MOST_PX);
    limits.max_alloc = Some(MOST_BYTES);
    reader.limits(limits);
    let image = reader.decode().map_err(broken)?.into_rgba8();
    Ok(Picture {
        width: image.width(),
        height: image.height(),
        pixels: image.pixels().map(|pixel| pixel.0).collect(),
    })
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A PNG file of bytes by rows.
    pub(crate) fn png(width: u32, height: u32, bytes: &[u8], kind: image::ColorType) -> Vec<u8> {
        let mut file = Cursor::new(Vec::new());
        image::write_buffer_with_format(&mut file, bytes, width, height, kind, ImageFormat::Png)
            .unwrap();
        file.into_inner()
    }

    #[test]
    fn png_and_jpeg_are_read() {
        let bytes = [255, 0, 0, 128, 0, 0, 255, 255];
        let file = png(1, 2, &bytes, image::ColorType::Rgba8);
        let picture = decode(&file).unwrap();
        assert_eq!((picture.width, picture.height), (1, 2));
        assert_eq!(picture.pixels, [[255, 0, 0, 128], [0, 0, 255, 255]]);
        for end in 0..file.len() - 12 {
            assert!(decode(&file[..end]).is_err(), "{end}");
        }

        let mut jpeg = Cursor::new(Vec::new());
        let grey = image::RgbImage::from_pixel(9, 5, image::Rgb([90; 3]));
        grey.write_to(&mut jpeg, ImageFormat::Jpeg).unwrap();
        let picture = decode(jpeg.get_ref()).unwrap();
        assert_eq!((picture.width, picture.height), (9, 5));
        let grey = |pixel: &[u8; 4]| pixel[0].abs_diff(90) < 2 && pixel[3] == 255;
        assert!(picture.pixels.iter().all(grey));

        assert_eq!(
            decode(b"GIF89a").unwrap_err(),
            "is not a kind of picture; expected a PNG or a JPEG file"
        );
    }
}
