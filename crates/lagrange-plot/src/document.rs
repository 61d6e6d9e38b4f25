//! Figures as SVG documents.

use crate::axes::FINENESS;
use crate::characters::escaped;
use crate::colours::{self, CLASS, Colour, INK, PAPER};
use crate::image::Placed;
use crate::label::Label;
use crate::lettering::FAMILY;
use crate::paper::{FONT, Paper, Place, Point};

/// A document under construction.
pub(crate) struct Document {
    text: String,
    colours: Vec<Colour>,
}

impl Document {
    /// Starts a document of a size in points. Its title serves screen readers and tooltips. Images
    /// are above the ground and below all other elements.
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
            "<svg class=\"{CLASS}\" role=\"img\" stroke-linejoin=\"round\" stroke-linecap=\"round\" width=\"{}\" height=\"{}\" \
             viewBox=\"0 0 {width} {height}\" xmlns=\"http://www.w3.org/2000/svg\" xml:space=\"preserve\" \
             font-family=\"{FAMILY}\">\n\
             <title>{}</title>\n<rect width=\"{width}\" height=\"{height}\"{}/>{images}\n",
            width / FINENESS,
            height / FINENESS,
            escaped(title),
            PAPER.paint("fill"),
        );
        Ok(Document { text, colours: Vec::new() })
    }

    /// Returns the whole document.
    pub(crate) fn finish(self) -> String {
        self.text + &colours::style(self.colours) + "</svg>\n"
    }

    /// Returns an attribute with a colour, which the style sheet will contain.
    fn paint(&mut self, attribute: &str, colour: Colour) -> String {
        self.colours.push(colour);
        colour.paint(attribute)
    }

    fn shape(&mut self, element: &str, points: &[Point], attributes: &str) {
        let points: String = points.iter().map(|(x, y)| format!("{x},{y} ")).collect();
        self.text += &format!("<{element}{attributes} points=\"{}\"/>\n", points.trim_end());
    }
}

impl Paper for Document {
    fn line(&mut self, points: &[Point], colour: Colour, width: u32) {
        let stroke = self.paint("stroke", colour);
        self.shape("polyline", points, &format!(" fill=\"none\"{stroke} stroke-width=\"{width}\""));
    }

    fn area(&mut self, corners: &[Point], colour: Colour) {
        let fill = self.paint("fill", colour);
        self.shape("polygon", corners, &fill);
    }

    fn write(&mut self, label: &Label, Place { at: (x, y), anchor, down, is_turned }: Place) {
        let turned = if is_turned { format!(" transform=\"rotate(270 {x} {y})\"") } else { String::new() };
        let base = (f64::from(y) + down.base()).round();
        let attributes = self.paint("fill", INK) + &turned;
        self.text += &label.element([f64::from(x), base], FONT, anchor, &attributes);
    }
}
