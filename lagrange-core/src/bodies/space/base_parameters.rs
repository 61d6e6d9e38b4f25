//! Base parameters: inertia that a joint cannot tell from its carrier's, moved to the carrier.
//!
//! Seen from a joint that turns about z, a body with its mass on the axis and the same moment of inertia J about x and y moves as if it
//! belonged to the carrier: m, the first moment along the axis and J may be counted there. Of a joint that slides the whole tensor may,
//! since it never turns against its carrier; of a ball joint only the mass. Equations of motion stay the same, with fewer parameters that are not zero; energies do
//! not, and are written with what the user declared. All of it is computed in numbers, and only where inertia and joint are made of
//! numbers.
//!
//! Source: Khalil, Dombre, *Modeling, Identification and Control of Robots*, §9.4.
//!
//! # In numbers
//!
//! A disk, m = 2, with the moments 3, 3 and 6 about its centre, turns about z through that centre: all that is left of it is the moment
//! 6 about its axis. Its carrier gets the mass 2 at the joint and the moments 3 about x and y. At p = (0, 0, 1) in the carrier's axes that
//! is the first moment (0, 0, 2) and the moments 3 + 2, 3 + 2 and 0.

/// Entries below this fraction of the largest moment are what is left of numbers that cancel.
const NEGLIGIBLE: f64 = 1e-15;

/// Mass, first moment and tensor of inertia about the origin of a frame, in its axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct InertialParameters {
    pub(super) mass: f64,
    pub(super) moment: [f64; 3],
    /// In rows.
    pub(super) tensor: [[f64; 3]; 3],
}

/// What lies between a body and its carrier, from the body inwards.
#[derive(Clone, Copy, Debug)]
pub(super) enum NumericStep {
    /// A turn about a coordinate axis.
    Turn(usize),
    /// A move along any direction.
    Slide,
    /// A turn in any direction.
    Orientation,
    /// Axes that are fixed in the frame before, in the columns of a matrix.
    Reorientation([[f64; 3]; 3]),
    /// An origin that is fixed in the frame before.
    Shift([f64; 3]),
}

impl InertialParameters {
    pub(super) const NONE: InertialParameters =
        InertialParameters { mass: 0.0, moment: [0.0; 3], tensor: [[0.0; 3]; 3] };

    /// Those of a body from what is known about its centre of mass.
    pub(super) fn of_body(mass: f64, centroid: [f64; 3], tensor: [f64; 6]) -> InertialParameters {
        let [xx, yy, zz, xy, xz, yz] = tensor;
        let about_center = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        InertialParameters { mass, moment: [0.0; 3], tensor: about_center }.seen_from(centroid)
    }

    /// True if there is no mass and no inertia.
    pub(super) fn is_nothing(&self) -> bool {
        let entries = self.moment.iter().chain(self.tensor.iter().flatten());
        self.mass == 0.0 && entries.copied().all(|entry| entry == 0.0)
    }

    /// False if numbers are too large for what is computed of them.
    pub(super) fn is_finite(&self) -> bool {
        let entries = self.moment.iter().chain(self.tensor.iter().flatten());
        self.mass.is_finite() && entries.copied().all(f64::is_finite)
    }

    pub(super) fn plus(self, other: InertialParameters) -> InertialParameters {
        InertialParameters {
            mass: self.mass + other.mass,
            moment: each(|axis| self.moment[axis] + other.moment[axis]),
            tensor: each(|row| each(|column| self.tensor[row][column] + other.tensor[row][column])),
        }
    }

    /// What a step cannot tell from what is before it, taken out of this, and in the frame before the step.
    pub(super) fn take_hidden(&mut self, step: NumericStep) -> InertialParameters {
        match step {
            NumericStep::Turn(axis) => self.take_symmetric(axis),
            NumericStep::Slide => {
                let tensor = std::mem::replace(&mut self.tensor, [[0.0; 3]; 3]);
                InertialParameters { tensor, ..InertialParameters::NONE }
            }
            NumericStep::Orientation => {
                let mass = std::mem::replace(&mut self.mass, 0.0);
                InertialParameters { mass, ..InertialParameters::NONE }
            }
            NumericStep::Reorientation(_) | NumericStep::Shift(_) => {
                std::mem::replace(self, InertialParameters::NONE).before(step)
            }
        }
    }

    /// The same in the frame before a step that does not move.
    fn before(self, step: NumericStep) -> InertialParameters {
        match step {
            NumericStep::Reorientation(rotation) => self.turned(&rotation),
            NumericStep::Shift(origin) => self.seen_from(origin),
            NumericStep::Turn(_) | NumericStep::Slide | NumericStep::Orientation => self,
        }
    }

    /// The part that turning about a coordinate axis does not change.
    fn take_symmetric(&mut self, axis: usize) -> InertialParameters {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut hidden = InertialParameters { mass: self.mass, ..InertialParameters::NONE };
        hidden.moment[axis] = self.moment[axis];
        let across = self.tensor[last][last];
        hidden.tensor[next][next] = across;
        hidden.tensor[last][last] = across;
        let scale = self.tensor.iter().flatten().fold(0.0_f64, |scale, entry| scale.max(entry.abs()));
        self.mass = 0.0;
        self.moment[axis] = 0.0;
        self.tensor[last][last] = 0.0;
        let rest = self.tensor[next][next] - across;
        self.tensor[next][next] = if rest.abs() <= NEGLIGIBLE * scale { 0.0 } else { rest };
        hidden
    }

    /// Components in axes in which those here are the columns of a rotation.
    fn turned(self, rotation: &[[f64; 3]; 3]) -> InertialParameters {
        let times = |vector: [f64; 3]| each(|row| inner(rotation[row], vector));
        // R J Rᵀ, column by column and row by row; J is symmetric.
        let half = self.tensor.map(times);
        let columns = each(|axis| [half[0][axis], half[1][axis], half[2][axis]]);
        InertialParameters { mass: self.mass, moment: times(self.moment), tensor: columns.map(times) }
    }

    /// About the origin of a frame with the same axes in which the origin here is at a place p: J + 2 (h·p) 1 − h pᵀ − p hᵀ + m (p² 1 − p pᵀ).
    fn seen_from(self, place: [f64; 3]) -> InertialParameters {
        let InertialParameters { mass, moment: h, tensor } = self;
        let diagonal = 2.0 * inner(h, place) + mass * inner(place, place);
        let moved = |row: usize, column: usize| {
            let product = h[row] * place[column] + place[row] * h[column] + mass * place[row] * place[column];
            tensor[row][column] - product + if row == column { diagonal } else { 0.0 }
        };
        InertialParameters {
            mass,
            moment: each(|axis| h[axis] + mass * place[axis]),
            tensor: each(|row| each(|column| moved(row, column))),
        }
    }

    /// Entries that are rounding errors of larger ones are zero.
    pub(super) fn without_rounding(self) -> InertialParameters {
        let scale = self.tensor.iter().flatten().fold(0.0_f64, |scale, entry| scale.max(entry.abs()));
        let cleaned = |entry: f64| if entry.abs() <= NEGLIGIBLE * scale { 0.0 } else { entry };
        InertialParameters { tensor: self.tensor.map(|row| row.map(cleaned)), ..self }
    }
}

fn each<T>(entry: impl Fn(usize) -> T) -> [T; 3] {
    [0, 1, 2].map(entry)
}

fn inner(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::{InertialParameters, NumericStep};

    #[test]
    fn a_disk_leaves_its_axis() {
        let mut disk = InertialParameters::of_body(2.0, [0.0; 3], [3.0, 3.0, 6.0, 0.0, 0.0, 0.0]);
        let mut hidden = disk.take_hidden(NumericStep::Turn(2));
        assert_eq!((disk.mass, disk.moment), (0.0, [0.0; 3]));
        assert_eq!(disk.tensor, [[0.0; 3], [0.0; 3], [0.0, 0.0, 6.0]]);
        let carried = hidden.take_hidden(NumericStep::Shift([0.0, 0.0, 1.0]));
        assert_eq!((carried.mass, carried.moment), (2.0, [0.0, 0.0, 2.0]));
        assert_eq!(carried.tensor, [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0; 3]]);
    }

    #[test]
    fn a_quarter_turn_about_x_swaps_moments() {
        let rotation = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
        let mut body = InertialParameters::of_body(1.0, [0.0, 2.0, 0.0], [1.0, 2.0, 3.0, 0.5, 0.0, 0.0]);
        let turned = body.take_hidden(NumericStep::Reorientation(rotation));
        assert_eq!(turned.moment, [0.0, 0.0, 2.0]);
        // About the origin the moments were 1 + 4, 2, 3 + 4.
        assert_eq!(turned.tensor, [[5.0, 0.0, 0.5], [0.0, 7.0, 0.0], [0.5, 0.0, 2.0]]);
    }
}
