//! Trees evaluated along a motion.
//!
//! At a state with accelerations, every coordinate is a [`Jet`] with two variations for each
//! velocity: a constant displacement, and one that grows as τ. Expressions follow by arithmetic
//! with jets, and [`Sums`] collects the contributions of statements.

mod statements;
mod values;

use std::collections::HashMap;

use crate::digits::Real;
use crate::jet::{Field, Jet};
use crate::layout::{Layout, Slot};
use crate::splines::Spline;
use crate::tree::Expr;

/// Time, positions and velocities in the order of emitted code.
#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) t: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
}

/// Sums of the contributions of statements.
pub(crate) struct Sums {
    pub(crate) kinetic: Jet,
    pub(crate) potential: Jet,
    /// The declared Lagrangian.
    pub(crate) lagrangian: Jet,
    pub(crate) dissipation: Jet,
    /// Forces along the velocities.
    pub(crate) forces: Vec<Real>,
    pub(crate) constraints: Vec<(Jet, bool)>,
    pub(crate) state_rates: Vec<Real>,
    pub(crate) outputs: Vec<(String, Vec<Jet>)>,
}

/// The pose of a rigid body or a frame.
#[derive(Clone)]
pub(crate) struct Placed {
    pub(crate) rotation: Vec<Vec<Jet>>,
    pub(crate) origin: Vec<Jet>,
    pub(crate) centroid: Vec<Jet>,
}

/// Names with their values. Everything that depends on a missing name is `None`.
pub(crate) struct World<'a> {
    pub(crate) field: &'a mut Field,
    pub(crate) layout: &'a Layout,
    pub(crate) sums: Sums,
    pub(crate) scope: HashMap<String, Vec<Jet>>,
    pub(crate) placed: HashMap<String, Placed>,
    pub(crate) gravity: Vec<Jet>,
    functions: HashMap<String, (Vec<String>, Expr)>,
    splines: HashMap<String, Spline>,
    variable: Option<i64>,
    /// True if loads and outputs, which change no acceleration, are skipped.
    pub(crate) only_energies: bool,
    /// Unknowns found earlier.
    pub(crate) roots: HashMap<String, Real>,
}

impl<'a> World<'a> {
    /// Returns the world at a state with accelerations, and with rates of first-order states if
    /// they are known.
    pub(crate) fn new(
        field: &'a mut Field,
        layout: &'a Layout,
        state: &State,
        accelerations: &[Real],
        state_rates: Option<&[Real]>,
    ) -> World<'a> {
        let zero = field.whole(0);
        let sums = Sums {
            kinetic: zero.clone(),
            potential: zero.clone(),
            lagrangian: zero.clone(),
            dissipation: zero,
            forces: vec![field.integer(0); layout.velocities],
            constraints: Vec::new(),
            state_rates: Vec::new(),
            outputs: Vec::new(),
        };
        let mut world = World {
            field,
            layout,
            sums,
            scope: HashMap::new(),
            placed: HashMap::new(),
            gravity: Vec::new(),
            functions: HashMap::new(),
            splines: HashMap::new(),
            variable: None,
            only_energies: false,
            roots: HashMap::new(),
        };
        world.set_positions(state, accelerations);
        world.set_states(state, state_rates);
        world
    }

    fn float(&mut self, value: f64) -> Real {
        let value = self.field.arithmetic.float(value);
        self.field.rounded(value)
    }

    fn set_positions(&mut self, state: &State, accelerations: &[Real]) {
        let layout = self.layout;
        for slot in &layout.slots {
            match slot {
                Slot::Coordinate { name, position, velocity } => {
                    let (q, v) = (self.float(state.q[*position]), self.float(state.v[*velocity]));
                    let half = self.field.arithmetic.float(0.5);
                    let bend = self.field.product(&half, &accelerations[*velocity]);
                    let jet = Jet { value: vec![q, v, bend], ..self.field.whole(0) };
                    let jet = self.displaced(jet, *velocity);
                    self.scope.insert(name.clone(), vec![jet]);
                }
                Slot::Orientation { name, position, velocity } => {
                    let q = [0, 1, 2, 3].map(|k| self.float(state.q[position + k]));
                    let w = [0, 1, 2].map(|k| self.float(state.v[velocity + k]));
                    self.set_orientation(name, *velocity, &q, &w, &accelerations[*velocity..velocity + 3]);
                }
            }
        }
        let t = self.float(state.t);
        let time = self.field.series(&[t, self.field.integer(1)]);
        self.scope.insert("t".to_owned(), vec![time]);
    }

    /// Returns the jet of a displaced coordinate.
    fn displaced(&self, mut jet: Jet, velocity: usize) -> Jet {
        let one = self.field.integer(1);
        let zero = self.field.integer(0);
        jet.variations[velocity] = vec![one.clone(), zero.clone(), zero.clone()];
        jet.variations[self.layout.velocities + velocity] = vec![zero.clone(), one, zero];
        jet
    }

    /// Sets a first-order state along its rate, or only its value while the rate is unknown.
    fn set_states(&mut self, state: &State, rates: Option<&[Real]>) {
        let first = self.layout.positions;
        for (k, name) in self.layout.states.iter().enumerate() {
            let value = self.float(state.q[first + k]);
            let rate = rates.map_or_else(|| self.field.integer(0), |rates| rates[k].clone());
            let jet = self.field.series(&[value, rate]);
            self.scope.insert(name.clone(), vec![jet]);
        }
    }
}

/// Returns the name of an element of an array.
pub(crate) fn element(name: &str, index: i64) -> String {
    format!("{name}[{index}]")
}
