//! The linear model of a system at a state.

use std::fmt::{Display, Formatter, Result as Written};
use std::string::String;
use std::vec::Vec;

use super::corner::corner;
use super::error::{LinearisationError, NotConverged, Undetermined};
use super::modes::Modes;
use super::names::{Components, Names};
use super::regulator::{DesignError, Observer, Plant, Regulator, Time, observer, regulator};
use super::sampled::{SampledModel, held};
use super::tables::write_model;
use super::tangent::{Blocks, TangentSpace, first_undefined};
use super::transfer::{NoSuchChannel, Transfer};
use super::weakest::{Channel, WeakestDirection, weakest};
use crate::linalg::dense::DenseMatrix;
use crate::simulate::unit_among;
use crate::system::{LinearisedSystem, MatrixLayout};

/// The linear model ẋ = A x + B u, y = C x + D u of a system near a state, with names on rows and
/// columns.
///
/// Here x, u and y are deviations of states, inputs and outputs. States are displacements,
/// first-order states and velocities, without those that follow from constraints. If the state is
/// neither an equilibrium nor a steady motion, deviations are from the motion through it, at that
/// instant.
#[derive(Clone, PartialEq, Debug)]
pub struct LinearModel {
    a: DenseMatrix,
    b: DenseMatrix,
    c: DenseMatrix,
    d: DenseMatrix,
    states: Vec<String>,
    inputs: &'static [&'static str],
    outputs: &'static [&'static str],
    components: Components,
    /// Units by names.
    units: &'static [(&'static str, &'static str)],
}

/// Writes the matrices as tables with names, without empty ones. A precision is that of significant
/// digits.
impl Display for LinearModel {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let matrices = [&self.a, &self.b, &self.c, &self.d];
        write_model(f, matrices, &self.states, (self.inputs, self.outputs))
    }
}

impl LinearModel {
    pub(super) fn of<M>(
        system: &M,
        t: M::Scalar,
        mut y: M::State,
    ) -> Result<LinearModel, LinearisationError<M::Scalar>>
    where
        M: LinearisedSystem,
        M::Scalar: Into<f64>,
    {
        let (names, rates) = (Names::of(system), system.rhs(t, &y));
        if let Some(undefined) = system.undefined(t, &y, &rates) {
            return Err(LinearisationError::Undefined(undefined.with_names_of(names.state)));
        }
        system.admit(t, &mut y).map_err(LinearisationError::NotAdmitted)?;
        if let Some(surface) = corner(system, t, &y) {
            return Err(LinearisationError::Corner { surface });
        }
        let blocks = Blocks::of(system, t, &y);
        if let Some(place) = first_undefined(&blocks.matrix) {
            return Err(LinearisationError::Derivative(Undetermined::of(&names, place)));
        }
        let space = TangentSpace::new(&blocks, names.beyond.are_holonomic);
        Ok(LinearModel::on(&blocks, &space, &names))
    }

    fn on(blocks: &Blocks, space: &TangentSpace, names: &Names) -> LinearModel {
        let MatrixLayout { inputs, outputs, .. } = names.beyond;
        let (units, names) = (names.state.units, names.tangent());
        let all = (0..blocks.tangent).collect::<Vec<_>>();
        let of_outputs = (blocks.tangent..blocks.tangent + blocks.outputs).collect::<Vec<_>>();
        let on_basis = |rows: &[usize]| blocks.matrix.part(rows, &all).times(&space.basis);
        let by_inputs = |rows: &[usize]| blocks.matrix.part(rows, &blocks.inputs());
        LinearModel {
            a: on_basis(&space.free),
            b: by_inputs(&space.free),
            c: on_basis(&of_outputs),
            d: by_inputs(&of_outputs),
            states: space.free.iter().map(|&index| names[index].clone()).collect(),
            inputs,
            outputs,
            components: Components { names, displacements: blocks.freedoms, basis: space.basis.clone() },
            units,
        }
    }

    /// Returns A: derivatives of the rates with respect to the states.
    #[must_use]
    pub fn a(&self) -> &DenseMatrix {
        &self.a
    }

    /// Returns B: derivatives of the rates with respect to the inputs.
    #[must_use]
    pub fn b(&self) -> &DenseMatrix {
        &self.b
    }

    /// Returns C: derivatives of the outputs with respect to the states.
    #[must_use]
    pub fn c(&self) -> &DenseMatrix {
        &self.c
    }

    /// Returns D: derivatives of the outputs with respect to the inputs.
    #[must_use]
    pub fn d(&self) -> &DenseMatrix {
        &self.d
    }

    /// Returns the names of the states: the rows of A and B, and the columns of A and C.
    #[must_use]
    pub fn states(&self) -> &[String] {
        &self.states
    }

    /// Returns the names of the inputs: the columns of B and D.
    #[must_use]
    pub fn inputs(&self) -> &[&'static str] {
        self.inputs
    }

    /// Returns the names of the outputs: the rows of C and D.
    #[must_use]
    pub fn outputs(&self) -> &[&'static str] {
        self.outputs
    }

    /// Returns the names of all displacements, first-order states and velocities, including those
    /// that follow from constraints: the rows of [`basis`](Self::basis).
    #[must_use]
    pub fn components(&self) -> &[String] {
        &self.components.names
    }

    /// Returns the matrix T: T x are all displacements, first-order states and velocities, which
    /// satisfy the constraints to first order. Without constraints, T is the identity.
    #[must_use]
    pub fn basis(&self) -> &DenseMatrix {
        &self.components.basis
    }

    /// Computes the eigenvalues of A with frequencies, damping ratios and shapes.
    ///
    /// # Errors
    /// If the iteration for the eigenvalues does not converge; no such matrix is known.
    pub fn modes(&self) -> Result<Modes, NotConverged> {
        Modes::of(&self.a, &self.components)
    }

    /// Computes the feedback u = −K x that minimises ∫ (xᵀQx + uᵀRu) dt.
    ///
    /// # Errors
    /// If weights are not symmetric and positive, or if no feedback stabilises the system.
    pub fn lqr(&self, q: &DenseMatrix, r: &DenseMatrix) -> Result<Regulator, DesignError> {
        regulator(self.plant(), (&self.b, self.inputs), q, r)
    }

    /// Computes the stationary Kalman–Bucy filter `ẋ = A x + B u + L (y − C x − D u)`. White noise
    /// of intensity W acts on the states, and of intensity V on the outputs.
    ///
    /// # Errors
    /// If intensities are not symmetric and positive, or if a growing mode is not observable in the
    /// outputs.
    pub fn observer(&self, w: &DenseMatrix, v: &DenseMatrix) -> Result<Observer, DesignError> {
        observer(self.plant(), (&self.c, self.outputs), w, v)
    }

    /// Returns the transfer function from an input to an output, by their names.
    ///
    /// # Errors
    /// If there is no such input or output.
    pub fn transfer(&self, input: &str, output: &str) -> Result<Transfer, NoSuchChannel> {
        let matrices = [&self.a, &self.b, &self.c, &self.d];
        let units = [input, output].map(|name| unit_among(self.units, name));
        Transfer::new(matrices, (self.inputs, input), (self.outputs, output), units)
    }

    /// Returns the model with the feedback u = r − K x and the inputs r. `None` unless K has a row
    /// for each input and a column for each state.
    #[must_use]
    pub fn with_feedback(&self, gain: &DenseMatrix) -> Option<LinearModel> {
        if (gain.rows(), gain.columns()) != (self.b.columns(), self.a.rows()) {
            return None;
        }
        let a = self.a.plus(-1.0, &self.b.times(gain));
        let c = self.c.plus(-1.0, &self.d.times(gain));
        Some(LinearModel { a, c, ..self.clone() })
    }

    /// Returns the loop of the feedback u = −K x, cut open at one input. The feedback of other
    /// inputs stays closed. The [margins](super::FrequencyResponse::margins) of this transfer
    /// function are those of the regulator. `None` if there is no such input, or if K has the wrong
    /// size.
    #[must_use]
    pub fn open_loop(&self, gain: &DenseMatrix, input: &str) -> Option<Transfer> {
        let LinearModel { a, .. } = self.with_feedback(gain)?;
        let cut = self.inputs.iter().position(|name| *name == input)?;
        let (n, k) = (a.rows(), gain.row(cut));
        let a = DenseMatrix::from_fn(n, n, |i, j| a[(i, j)] + self.b[(i, cut)] * k[j]);
        let (row, none) =
            (DenseMatrix::from_fn(1, n, |_, j| k[j]), DenseMatrix::from_fn(1, self.inputs.len(), |_, _| 0.0));
        let (matrices, output) = ([&a, &self.b, &row, &none], &["feedback"]);
        // The feedback replaces the input, in its unit.
        let units = [unit_among(self.units, input); 2];
        Transfer::new(matrices, (self.inputs, input), (output, output[0]), units).ok()
    }

    /// Returns the discrete-time model for inputs held over a period. `None` if the period is NaN,
    /// or so long that the matrices overflow.
    #[must_use]
    pub fn sampled(&self, period: f64) -> Option<SampledModel> {
        let (a, b) = held(&self.a, &self.b, period)?;
        let (c, d, states) = (self.c.clone(), self.d.clone(), self.states.clone());
        Some(SampledModel { period, a, b, c, d, states, inputs: self.inputs, outputs: self.outputs })
    }

    /// Returns the combination of states that the inputs control least; `None` without states.
    #[must_use]
    pub fn weakest_direction(&self) -> Option<WeakestDirection> {
        weakest(&self.a, &self.b, &self.states, Channel::Inputs, |_| true)
    }

    /// Returns the combination of states that is least observable in the outputs; `None` without
    /// states.
    #[must_use]
    pub fn least_observed_direction(&self) -> Option<WeakestDirection> {
        weakest(&self.a.transposed(), &self.c.transposed(), &self.states, Channel::Outputs, |_| true)
    }

    fn plant(&self) -> Plant<'_> {
        Plant { time: Time::Continuous, a: &self.a, states: &self.states }
    }
}
