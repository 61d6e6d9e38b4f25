//! Figures as SVG documents.

use crate::axes::FINENESS;
use crate::characters::{escaped, number};
use crate::image::Placed;
use crate::label::Label;
use crate::lettering::FAMILY;
use crate::paper::{FONT, INK, Paper, Place, Point};
use crate::pixels::Colour;

/// A document under construction.
pub(crate) struct Document {
    text: String,
}

impl Document {
    /// Starts a document of a size in points. Its title serves screen readers and tooltips. Images
    /// are above the white ground and below all other elements.
    ///
    /// # Errors
    /// If an image cannot be encoded.
    pub(crate) fn new(
        (width, height): (u32, u32),
        title: &str,
        images: &[Placed],
    ) -> Result<Self, png::EncodingError> {
        let images = images.iter().map(Placed::svg).collect::<Result<String, _>>()?;
        // Points are smaller than the unit of the given size. Round joins prevent corners and ends
        // of curves from sticking out.
        let text = format!(
            "<svg role=\"img\" stroke-linejoin=\"round\" stroke-linecap=\"round\" width=\"{}\" height=\"{}\" \
             viewBox=\"0 0 {width} {height}\" xmlns=\"http://www.w3.org/2000/svg\" xml:space=\"preserve\" \
             font-family=\"{FAMILY}\">\n\
             <title>{}</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#FFFFFF\"/>{images}\n",
            width / FINENESS,
            height / FINENESS,
            escaped(title),
        );
        Ok(Document { text })
    }

    /// Returns the whole document.
    pub(crate) fn finish(self) -> String {
        self.text + "</svg>\n"
    }

    fn shape(&mut self, element: &str, points: &[Point], attributes: &str) {
        let points: String = points.iter().map(|(x, y)| format!("{x},{y} ")).collect();
        self.text += &format!("<{element} {attributes} points=\"{}\"/>\n", points.trim_end());
    }
}

fn paint(attribute: &str, [red, green, blue, opacity]: Colour) -> String {
    let colour = format!("{attribute}=\"#{red:02X}{green:02X}{blue:02X}\"");
    if opacity == u8::MAX {
        return colour;
    }
    format!("{colour} opacity=\"{}\"", number(f64::from(opacity) / 255.0))
}

impl Paper for Document {
    fn line(&mut self, points: &[Point], colour: Colour, width: u32) {
        let stroke = paint("stroke", colour);
        self.shape("polyline", points, &format!("fill=\"none\" {stroke} stroke-width=\"{width}\""));
    }

    fn area(&mut self, corners: &[Point], colour: Colour) {
        self.shape("polygon", corners, &paint("fill", colour));
    }

    fn write(&mut self, label: &Label, Place { at: (x, y), anchor, down, is_turned }: Place) {
        let turned = if is_turned { format!(" transform=\"rotate(270 {x} {y})\"") } else { String::new() };
        let base = (f64::from(y) + down.base()).round();
        let attributes = format!(" {}{turned}", paint("fill", INK));
        self.text += &label.element([f64::from(x), base], FONT, anchor, &attributes);
    }
}
