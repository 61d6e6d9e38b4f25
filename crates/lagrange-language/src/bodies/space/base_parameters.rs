//! Base parameters: inertia that a joint cannot distinguish from its carrier's, moved to the
//! carrier.
//!
//! Consider a joint that turns about z. It places a body with its mass on the axis and the same
//! moment of inertia J about x and y. The body moves as if it belonged to the carrier: m, the first
//! moment along the axis and J may be counted there. For a sliding joint, the whole tensor may be
//! moved, since it never turns relative to its carrier; for a ball joint, only the mass. The
//! equations of motion remain the same, with fewer nonzero parameters. Energies change, and are
//! therefore written with the declared parameters. Known values are computed as numbers, unknown
//! ones are written in terms of parameters ([`super::quantities`]); orientations must consist of
//! numbers.
//!
//! Source: Khalil, Dombre, *Modeling, Identification and Control of Robots*, §9.4.
//!
//! # In numbers
//!
//! A disk, m = 2, with the moments 3, 3 and 6 about its centre, turns about z through that centre.
//! It keeps only the moment 6 about its axis. Its carrier receives the mass 2 at the joint and the
//! moments 3 about x and y. At p = (0, 0, 1) in the carrier's axes, these are the first moment (0,
//! 0, 2). The moments are 5, 5 and 0, where 5 = 3 + 2.

use super::quantities::{Quantity, difference, inner, product, sum};
use crate::bodies::terms::TermWriter;

/// Numbers below this fraction of the largest moment are rounding errors of numbers that cancel.
const NEGLIGIBLE: f64 = 1e-15;

/// Mass, first moment and tensor of inertia about the origin of a frame, in its axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct InertialParameters {
    pub(super) mass: Quantity,
    pub(super) moment: [Quantity; 3],
    /// In rows.
    pub(super) tensor: [[Quantity; 3]; 3],
}

/// A step from a body towards its carrier.
#[derive(Clone, Copy, Debug)]
pub(super) enum JointStep {
    /// A turn about a coordinate axis.
    Turn(usize),
    /// A move along any direction.
    Slide,
    /// A turn in any direction.
    Orientation,
    /// Axes that are fixed in the previous frame, in the columns of a matrix of numbers.
    Reorientation([[f64; 3]; 3]),
    /// An origin that is fixed in the previous frame.
    Shift([Quantity; 3]),
}

impl InertialParameters {
    pub(super) const NONE: InertialParameters = InertialParameters {
        mass: Quantity::ZERO,
        moment: [Quantity::ZERO; 3],
        tensor: [[Quantity::ZERO; 3]; 3],
    };

    /// Returns the parameters of a body from those about its centre of mass.
    pub(super) fn of_body(
        terms: &mut TermWriter<'_>,
        mass: Quantity,
        centroid: [Quantity; 3],
        tensor: [Quantity; 6],
    ) -> InertialParameters {
        let [xx, yy, zz, xy, xz, yz] = tensor;
        let about_center = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        InertialParameters { mass, tensor: about_center, ..InertialParameters::NONE }
            .seen_from(terms, centroid)
    }

    fn entries(&self) -> impl Iterator<Item = Quantity> {
        [self.mass].into_iter().chain(self.moment).chain(self.tensor.into_iter().flatten())
    }

    /// True if there is no mass and no inertia.
    pub(super) fn is_nothing(&self) -> bool {
        self.entries().all(Quantity::is_zero)
    }

    /// True if there are only numbers.
    pub(super) fn is_known(&self) -> bool {
        self.entries().all(|entry| entry.term.is_none())
    }

    /// Writes the numbers of sums into their terms.
    pub(super) fn as_terms(self, terms: &mut TermWriter<'_>) -> InertialParameters {
        let mut whole = |entry: Quantity| entry.as_term(terms);
        let (mass, moment) = (whole(self.mass), self.moment.map(&mut whole));
        InertialParameters { mass, moment, tensor: symmetric(|row, column| whole(self.tensor[row][column])) }
    }

    /// True if all numbers are finite.
    pub(super) fn is_finite(&self) -> bool {
        self.entries().all(|entry| entry.number.is_finite())
    }

    pub(super) fn plus(self, terms: &mut TermWriter<'_>, other: InertialParameters) -> InertialParameters {
        InertialParameters {
            mass: sum(terms, self.mass, other.mass),
            moment: each(|axis| sum(terms, self.moment[axis], other.moment[axis])),
            tensor: symmetric(|row, column| sum(terms, self.tensor[row][column], other.tensor[row][column])),
        }
    }

    /// Removes the parameters that a step makes indistinguishable, and returns them in the frame
    /// before the step.
    pub(super) fn take_hidden(&mut self, terms: &mut TermWriter<'_>, step: JointStep) -> InertialParameters {
        match step {
            JointStep::Turn(axis) => self.take_symmetric(terms, axis),
            JointStep::Slide => {
                let tensor = std::mem::replace(&mut self.tensor, InertialParameters::NONE.tensor);
                InertialParameters { tensor, ..InertialParameters::NONE }
            }
            JointStep::Orientation => {
                let mass = std::mem::replace(&mut self.mass, Quantity::ZERO);
                InertialParameters { mass, ..InertialParameters::NONE }
            }
            JointStep::Reorientation(rotation) => self.take_all().turned(terms, rotation),
            JointStep::Shift(origin) => self.take_all().seen_from(terms, origin),
        }
    }

    fn take_all(&mut self) -> InertialParameters {
        std::mem::replace(self, InertialParameters::NONE)
    }

    /// Removes the part that turning about a coordinate axis does not change.
    fn take_symmetric(&mut self, terms: &mut TermWriter<'_>, axis: usize) -> InertialParameters {
        let [next, last] = self.kept_and_hidden(axis);
        let mut hidden = InertialParameters { mass: self.mass, ..InertialParameters::NONE };
        hidden.moment[axis] = self.moment[axis];
        let across = self.tensor[last][last];
        hidden.tensor[next][next] = across;
        hidden.tensor[last][last] = across;
        let scale = self.scale();
        self.mass = Quantity::ZERO;
        self.moment[axis] = Quantity::ZERO;
        self.tensor[last][last] = Quantity::ZERO;
        let rest = difference(terms, self.tensor[next][next], across);
        self.tensor[next][next] = without_rounding(rest, scale);
        hidden
    }

    /// Returns the two axes perpendicular to one. The excess of the moment about the first is kept,
    /// and the moment about the second is hidden; the latter is the simpler term.
    fn kept_and_hidden(&self, axis: usize) -> [usize; 2] {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        match self.tensor[next][next].is_zero() && self.tensor[last][last].term.is_some() {
            true => [last, next],
            false => [next, last],
        }
    }

    /// Returns the components in axes with respect to which the current axes are the columns of a
    /// rotation.
    fn turned(self, terms: &mut TermWriter<'_>, rotation: [[f64; 3]; 3]) -> InertialParameters {
        let rotation = rotation.map(|row| row.map(Quantity::known));
        let mut times = |vector: [Quantity; 3]| each(|row| inner(terms, rotation[row], vector));
        // R J Rᵀ, column by column and row by row; J is symmetric.
        let half = self.tensor.map(&mut times);
        let columns = each(|axis| [half[0][axis], half[1][axis], half[2][axis]]);
        let (moment, tensor) = (times(self.moment), columns.map(&mut times));
        InertialParameters { mass: self.mass, moment, tensor: symmetric(|row, column| tensor[row][column]) }
    }

    /// Returns the parameters about the origin of a frame with the same axes, in which the current
    /// origin is at p. They are h′ = h + m p, and J + (h + h′)·p 1 − h′ pᵀ − p hᵀ.
    fn seen_from(self, terms: &mut TermWriter<'_>, place: [Quantity; 3]) -> InertialParameters {
        let InertialParameters { mass, moment: h, tensor } = self;
        let moment = each(|axis| {
            let added = product(terms, mass, place[axis]);
            sum(terms, h[axis], added)
        });
        let squares = each(|axis| {
            let both = sum(terms, h[axis], moment[axis]);
            product(terms, both, place[axis])
        });
        let tensor = symmetric(|row, column| match row == column {
            true => {
                let across = sum(terms, squares[(row + 1) % 3], squares[(row + 2) % 3]);
                sum(terms, tensor[row][row], across)
            }
            false => {
                let behind = product(terms, moment[row], place[column]);
                let before = product(terms, place[row], h[column]);
                let both = sum(terms, behind, before);
                difference(terms, tensor[row][column], both)
            }
        });
        InertialParameters { mass, moment, tensor }
    }

    /// Sets numbers that are rounding errors of larger ones to zero.
    pub(super) fn without_rounding(self) -> InertialParameters {
        let scale = self.scale();
        let tensor = self.tensor.map(|row| row.map(|entry| without_rounding(entry, scale)));
        InertialParameters { tensor, ..self }
    }

    /// Returns the largest numeric moment.
    fn scale(&self) -> f64 {
        self.tensor.iter().flatten().fold(0.0_f64, |scale, entry| scale.max(entry.number.abs()))
    }
}

fn without_rounding(entry: Quantity, scale: f64) -> Quantity {
    let number = if entry.number.abs() <= NEGLIGIBLE * scale { 0.0 } else { entry.number };
    Quantity { number, ..entry }
}

fn each<T>(entry: impl FnMut(usize) -> T) -> [T; 3] {
    [0, 1, 2].map(entry)
}

/// Returns a matrix that is equal to its transpose to the last bit and term.
fn symmetric(mut entry: impl FnMut(usize, usize) -> Quantity) -> [[Quantity; 3]; 3] {
    let [xx, yy, zz] = each(|axis| entry(axis, axis));
    let (xy, xz, yz) = (entry(0, 1), entry(0, 2), entry(1, 2));
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

#[cfg(test)]
mod tests {
    use super::{InertialParameters, JointStep, Quantity};
    use crate::bodies::terms::TermWriter;
    use crate::syntax::ast::{Expression, Expressions};
    use proc_macro2::Span;

    fn known<const N: usize>(numbers: [f64; N]) -> [Quantity; N] {
        numbers.map(Quantity::known)
    }

    fn numbers(tensor: [[Quantity; 3]; 3]) -> [[f64; 3]; 3] {
        tensor.map(|row| row.map(|entry| entry.number))
    }

    #[test]
    fn a_disk_leaves_its_axis() {
        let mut expressions = Expressions::default();
        let terms = &mut TermWriter::new(&mut expressions, Span::call_site().into());
        let tensor = known([3.0, 3.0, 6.0, 0.0, 0.0, 0.0]);
        let mut disk = InertialParameters::of_body(terms, Quantity::known(2.0), known([0.0; 3]), tensor);
        let mut hidden = disk.take_hidden(terms, JointStep::Turn(2));
        assert!(disk.mass.is_zero() && disk.moment.iter().all(|entry| entry.is_zero()));
        assert_eq!(numbers(disk.tensor), [[0.0; 3], [0.0; 3], [0.0, 0.0, 6.0]]);
        let carried = hidden.take_hidden(terms, JointStep::Shift(known([0.0, 0.0, 1.0])));
        assert_eq!((carried.mass, carried.moment), (Quantity::known(2.0), known([0.0, 0.0, 2.0])));
        assert_eq!(numbers(carried.tensor), [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0; 3]]);
    }

    #[test]
    fn a_quarter_turn_about_x_swaps_moments() {
        let mut expressions = Expressions::default();
        let terms = &mut TermWriter::new(&mut expressions, Span::call_site().into());
        let rotation = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
        let tensor = known([1.0, 2.0, 3.0, 0.5, 0.0, 0.0]);
        let place = known([0.0, 2.0, 0.0]);
        let mut body = InertialParameters::of_body(terms, Quantity::known(1.0), place, tensor);
        let turned = body.take_hidden(terms, JointStep::Reorientation(rotation));
        assert_eq!(turned.moment, known([0.0, 0.0, 2.0]));
        // About the origin the moments were 1 + 4, 2, 3 + 4.
        assert_eq!(numbers(turned.tensor), [[5.0, 0.0, 0.5], [0.0, 7.0, 0.0], [0.5, 0.0, 2.0]]);
    }

    #[test]
    fn equal_moments_leave_an_axis_whatever_they_are() {
        let mut expressions = Expressions::default();
        let terms = &mut TermWriter::new(&mut expressions, Span::call_site().into());
        let [across, along] = ["i", "j"].map(|name| {
            let term = Some(terms.add_node(Expression::Name(name.to_owned())));
            Quantity { number: 1.0, term }
        });
        let [xy, xz, yz] = known([0.0; 3]);
        let tensor = [across, across, along, xy, xz, yz];
        let mut disk = InertialParameters::of_body(terms, Quantity::known(2.0), known([0.0; 3]), tensor);
        let hidden = disk.take_hidden(terms, JointStep::Turn(2));
        assert_eq!(disk.tensor, [[Quantity::ZERO; 3], [Quantity::ZERO; 3], [xy, xy, along]]);
        assert_eq!([hidden.tensor[0][0], hidden.tensor[1][1]], [across, across]);
    }
}
