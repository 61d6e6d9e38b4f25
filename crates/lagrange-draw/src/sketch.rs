//! User additions to pictures.

use crate::colour::{ACCELERATION, FORCE, INK, VELOCITY, ink};
use crate::element::{Element, Layer, Measure, Shape};
use crate::picture::{Colour, Point};
use lagrange_plot::notation::formula;

/// User marks over a picture, in the coordinates of the scene.
///
/// Points and lengths are those of the scene, angles in radians counterclockwise. Labels are
/// written as in formulas: `v_P`, `J_{SP}`, `phi` for φ; an empty label draws nothing. Marks drawn
/// only at some moments of a film are invisible at the others.
#[derive(Debug)]
pub struct Sketch {
    pub(super) elements: Vec<Element>,
    ink: Colour,
}

impl Sketch {
    pub(super) fn new() -> Self {
        Sketch { elements: Vec::new(), ink: INK }
    }

    /// Sets the colour of later marks: 0 is dark grey, followed by blue, vermilion, green, purple,
    /// orange, light blue. Velocities, accelerations and forces have separate colours.
    pub fn ink(&mut self, number: usize) -> &mut Self {
        self.ink = ink(number);
        self
    }

    /// Draws a point.
    pub fn point(&mut self, at: [f64; 2], label: &str) -> &mut Self {
        self.add(label, Shape::Dot { at })
    }

    /// Draws a straight line between two points.
    pub fn segment(&mut self, from: [f64; 2], to: [f64; 2]) -> &mut Self {
        self.add("", Shape::Segment { ends: [from, to], is_dashed: false })
    }

    /// Draws a dashed straight line between two points.
    pub fn dashed(&mut self, from: [f64; 2], to: [f64; 2]) -> &mut Self {
        self.add("", Shape::Segment { ends: [from, to], is_dashed: true })
    }

    /// Draws a dashed straight line through two points, to the borders of the picture.
    pub fn line(&mut self, a: [f64; 2], b: [f64; 2]) -> &mut Self {
        self.add("", Shape::Through { points: [a, b] })
    }

    /// Draws a circle.
    pub fn circle(&mut self, center: [f64; 2], radius: f64) -> &mut Self {
        self.add("", Shape::Circle { center, radius, is_dashed: false })
    }

    /// Draws a dashed circle.
    pub fn dashed_circle(&mut self, center: [f64; 2], radius: f64) -> &mut Self {
        self.add("", Shape::Circle { center, radius, is_dashed: true })
    }

    /// Draws an arrow, as long as the vector.
    pub fn arrow(&mut self, from: [f64; 2], vector: [f64; 2], label: &str) -> &mut Self {
        self.add(label, Shape::Arrow { from, vector, measure: Measure::World, is_push: false })
    }

    /// Draws a velocity, at the common scale of velocities of the film.
    pub fn velocity(&mut self, from: [f64; 2], velocity: [f64; 2], label: &str) -> &mut Self {
        self.measured(from, velocity, label, Measure::Velocity, VELOCITY)
    }

    /// Draws an acceleration, at the common scale of accelerations of the film.
    pub fn acceleration(&mut self, from: [f64; 2], acceleration: [f64; 2], label: &str) -> &mut Self {
        self.measured(from, acceleration, label, Measure::Acceleration, ACCELERATION)
    }

    /// Draws a force, at the common scale of forces of the film.
    pub fn force(&mut self, from: [f64; 2], force: [f64; 2], label: &str) -> &mut Self {
        self.measured(from, force, label, Measure::Force, FORCE)
    }

    /// Draws an arc about a point with an arrowhead, from one angle to another.
    pub fn angle(&mut self, at: [f64; 2], from: f64, to: f64, label: &str) -> &mut Self {
        self.add(label, Shape::Angle { at, from, to })
    }

    /// Draws a line with arrowheads to mark a distance, with its label on the left as seen from
    /// `from` to `to`.
    pub fn dimension(&mut self, from: [f64; 2], to: [f64; 2], label: &str) -> &mut Self {
        self.add(label, Shape::Dimension { ends: [from, to] })
    }

    /// Writes text centred at a point, or next to it to avoid lines.
    pub fn text(&mut self, at: [f64; 2], text: &str) -> &mut Self {
        // A single word is typeset as a symbol, a sentence is not.
        let written = if text.contains(' ') { text.to_string() } else { formula(text) };
        self.push(written, text, Shape::Words { at }, self.ink);
        self
    }

    /// Draws a line through points.
    pub fn polyline(&mut self, points: &[[f64; 2]]) -> &mut Self {
        self.add("", Shape::Polyline { points: points.to_vec() })
    }

    /// Draws an area with these corners, lightly filled.
    pub fn area(&mut self, points: &[[f64; 2]]) -> &mut Self {
        self.add("", Shape::Area { points: points.to_vec() })
    }

    fn measured(
        &mut self,
        from: Point,
        vector: Point,
        label: &str,
        measure: Measure,
        colour: Colour,
    ) -> &mut Self {
        self.push(formula(label), label, Shape::Arrow { from, vector, measure, is_push: false }, colour);
        self
    }

    fn add(&mut self, label: &str, shape: Shape) -> &mut Self {
        self.push(formula(label), label, shape, self.ink);
        self
    }

    fn push(&mut self, label: String, name: &str, shape: Shape, colour: Colour) {
        // Text may change during a film but remains the same element.
        let name = if matches!(shape, Shape::Words { .. }) { "text" } else { name };
        let name = if name.is_empty() { "sketch" } else { name }.to_string();
        self.elements.push(Element { name, label, colour, layer: Layer::Sketch, shape });
    }
}
