//! Pixel images within figures.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::axes::Frame;

/// Pixels in rows, starting at the top.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Image {
    pub(crate) columns: u32,
    /// Red, green, blue and opacity of each pixel, either opaque or transparent.
    pub(crate) rgba: Vec<u8>,
}

/// An image that fills a frame.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Placed {
    pub(crate) image: Image,
    pub(crate) frame: Frame,
}

impl Image {
    pub(crate) fn rows(&self) -> u32 {
        (self.rgba.len() / 4) as u32 / self.columns.max(1)
    }

    /// Encodes the image as PNG.
    fn png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.columns, self.rows());
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.rgba)?;
        writer.finish()?;
        Ok(file)
    }
}

impl Placed {
    /// Returns an SVG element with the encoded image. Its pixels remain squares at any
    /// magnification.
    pub(crate) fn svg(&self) -> Result<String, png::EncodingError> {
        let Frame { left, right, top, bottom, .. } = self.frame;
        let data = STANDARD.encode(self.image.png()?);
        Ok(format!(
            "\n<image x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
             style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{data}\"/>",
            right - left,
            bottom - top
        ))
    }
}
