//! Declared systems with values for their parameters, independent of the size of their state.

use std::sync::Arc;

use lagrange_core::emit::Variables;
use lagrange_core::opaque::Opaque;
use lagrange_core::pipeline::{Backend, NumericSystem, Programs};
use lagrange_core::program::Program;
use lagrange_runtime::manifold::{MAX_TOUCHES, TOUCH_LENGTH, touches};
use lagrange_runtime::system::{OdeSystem, OutOfRange};

use crate::names::{Names, names_of};
use crate::reactions::Room;
use crate::refusal::{NoSuchName, Refusal, StartError};
use crate::system::DynamicSystem;

/// Capacities of states for which code is compiled.
const CAPACITIES: [usize; 3] = [8, 32, LARGEST];
/// Numbers of the largest number of contact points of two blocks; fewer points have the first ones.
const MAX_NUMBERS: usize = MAX_TOUCHES * TOUCH_LENGTH;
/// Capacity of the largest states.
pub(crate) const LARGEST: usize = 128;

/// A system read at run time, with values for its parameters and inputs.
#[derive(Clone, Debug)]
pub struct DeclaredSystem {
    numeric: NumericSystem,
    names: &'static Names,
}

/// A computation with a system.
pub trait Visitor {
    /// Result of the computation.
    type Output;

    /// Computes with a system whose states have at most `CAPACITY` entries.
    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output;
}

impl DeclaredSystem {
    /// Creates a system from its programs. Parameters and inputs have their defaults, or are NaN
    /// until they are set; inputs stay constant.
    ///
    /// # Errors
    /// If it has parts that only compiled Rust can run.
    pub fn new(programs: Programs) -> Result<Self, Refusal> {
        check(&programs)?;
        let names = names_of(&programs);
        Ok(DeclaredSystem {
            numeric: NumericSystem::of(Arc::new(programs)).with_contact_points(contact_points),
            names,
        })
    }

    /// Compiles programs on their first run instead of interpreting them. Results are the same.
    pub fn compiled_by(self, backend: Arc<dyn Backend>) -> Self {
        DeclaredSystem { numeric: self.numeric.compiled_by(backend), ..self }
    }

    /// Returns the names and units of the variables.
    pub fn variables(&self) -> &Variables {
        &self.numeric.programs().variables
    }

    /// Returns the interpreter.
    pub fn numeric(&self) -> &NumericSystem {
        &self.numeric
    }

    /// Returns the programs.
    pub fn programs(&self) -> &Programs {
        self.numeric.programs()
    }

    /// Sets a parameter or an input, in coherent units.
    ///
    /// # Errors
    /// If the name is unknown, or that of a delayed signal, whose values runs compute. Elements of
    /// arrays are called `k[0]`.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), NoSuchName> {
        let known = self.settable().map(str::to_owned).collect::<Vec<_>>();
        if known.iter().any(|known| known == name) && self.numeric.set(name, value) {
            return Ok(());
        }
        Err(NoSuchName { name: name.to_owned(), known })
    }

    /// Returns the names of parameters and inputs, except delayed signals.
    pub fn settable(&self) -> impl Iterator<Item = &str> {
        let programs = self.numeric.programs();
        let is_delayed = |field: usize| {
            programs.delayed_inputs.iter().any(|input| programs.layout.parameters + input == field)
        };
        let fields = self.variables().fields.iter().enumerate();
        fields.filter(move |(field, _)| !is_delayed(*field)).map(|(_, name)| &**name)
    }

    /// Returns the first parameter or input without a value, if there is one.
    pub fn missing(&self) -> Option<&str> {
        let index = self.numeric.fields().iter().position(|value| value.is_nan())?;
        self.variables().fields.get(index).map(String::as_str)
    }

    /// Returns the names of the entries of the state: positions, then velocities.
    pub fn state_names(&self) -> Vec<String> {
        self.variables().state_names()
    }

    /// Returns the declared initial state, in which entries without a value are zero; `None` if
    /// nothing is declared.
    pub fn start(&self) -> Option<Vec<f64>> {
        self.programs().start.as_ref().map(|start| self.evaluated(start))
    }

    /// Returns the declared initial state with other values for some of its entries. If nothing is
    /// declared, velocities are zero, and each position needs a value.
    ///
    /// # Errors
    /// If a name is unknown, an entry has no value, or one is out of its declared range.
    pub fn start_with(&self, values: &[(String, f64)]) -> Result<Vec<f64>, StartError> {
        let start = self.unchecked_start(values)?;
        self.check_state(&start).map_err(StartError::OutOfRange)?;
        Ok(start)
    }

    /// Checks that the entries of a state are in their declared ranges.
    ///
    /// # Errors
    /// If one is not, with the first one.
    pub fn check_state(&self, state: &[f64]) -> Result<(), OutOfRange<f64>> {
        self.names.domain.check(state)
    }

    /// Returns the bounds of the declared range of a parameter or an entry of the state, if it has
    /// two.
    pub fn bounds(&self, name: &str) -> Option<[f64; 2]> {
        let Variables { fields, limits, .. } = self.variables();
        let entry = self.state_names().iter().position(|known| known == name);
        let of_entry = entry.and_then(|entry| limits.get(entry)).map(|limits| limits.bounds);
        let ranges = self.programs().ranges.iter();
        let of_parameter = ranges.clone().find(|range| fields[range.parameter] == name);
        let [lower, upper] = of_entry.or(of_parameter.map(|range| range.bounds))?;
        Some([lower?.0, upper?.0])
    }

    /// Returns the same state, which may be out of the declared ranges. Runs from there fail.
    ///
    /// # Errors
    /// If a name is unknown, or an entry has no value.
    pub fn unchecked_start(&self, values: &[(String, f64)]) -> Result<Vec<f64>, StartError> {
        let (names, positions) = (self.state_names(), self.variables().positions.len());
        let undeclared = || {
            let mut start = vec![0.0; names.len()];
            start[..positions].fill(f64::NAN);
            start
        };
        let mut start = self.start().unwrap_or_else(undeclared);
        for (name, value) in values {
            let place = names.iter().position(|known| known == name);
            let unknown = || StartError::Unknown(NoSuchName { name: name.clone(), known: names.clone() });
            start[place.ok_or_else(unknown)?] = *value;
        }
        match names.iter().zip(&start).find(|(_, value)| value.is_nan()) {
            Some((name, _)) => Err(StartError::Missing(name.clone())),
            None => Ok(start),
        }
    }

    fn evaluated(&self, program: &Program) -> Vec<f64> {
        self.numeric.evaluate(program, 0.0, &[], &[])
    }

    /// Computes the rates [q̇, v̇] at a state `[q…, v…]`. As in a new value of an emitted type,
    /// contacts are open, and friction acts against its slip velocity.
    ///
    /// # Panics
    /// If the state is longer or shorter than those of the system.
    pub fn rates(&self, t: f64, state: &[f64]) -> Vec<f64> {
        match self.programs().touching {
            None => self.numeric.rhs(t, state),
            Some(_) => self.visit(AtState { program: None, t, state }),
        }
    }

    /// Runs a program at a state, with the forces of [`rates`](Self::rates).
    ///
    /// # Panics
    /// If the state is longer or shorter than those of the system.
    pub fn evaluate(&self, program: &Program, t: f64, state: &[f64]) -> Vec<f64> {
        let (q, v) = state.split_at(self.programs().layout.positions);
        match self.programs().touching {
            None => self.numeric.evaluate(program, t, q, v),
            Some(_) => self.visit(AtState { program: Some(program), t, state }),
        }
    }

    /// Computes with the system, in the smallest capacity that fits its state.
    pub fn visit<V: Visitor>(&self, visitor: V) -> V::Output {
        let [small, middle, _] = CAPACITIES;
        match room(self.programs()) {
            entries if entries <= small => visitor.visit(&self.dynamic::<{ CAPACITIES[0] }>()),
            entries if entries <= middle => visitor.visit(&self.dynamic::<{ CAPACITIES[1] }>()),
            _ => visitor.visit(&self.dynamic::<LARGEST>()),
        }
    }

    pub(crate) fn dynamic<const CAPACITY: usize>(&self) -> DynamicSystem<CAPACITY> {
        DynamicSystem::new(self.numeric.clone(), self.names)
    }
}

/// The evaluation of a program, or of the rates, at a state.
struct AtState<'a> {
    program: Option<&'a Program>,
    t: f64,
    state: &'a [f64],
}

impl Visitor for AtState<'_> {
    type Output = Vec<f64>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Vec<f64> {
        let AtState { program, t, state } = self;
        let state = system.state(state);
        program.map_or_else(
            || system.rhs(t, &state).as_ref().to_vec(),
            |program| system.evaluate(program, t, &state),
        )
    }
}

/// Returns the numbers of the contact points of two blocks; none if those of the blocks are
/// missing.
fn contact_points(blocks: &[f64]) -> Vec<f64> {
    <[f64; 32]>::try_from(blocks)
        .map_or_else(|_| Vec::new(), |blocks| touches::<f64, MAX_NUMBERS>(blocks).into())
}

/// Returns the length of the longest vector of a system.
fn room(programs: &Programs) -> usize {
    let layout = &programs.layout;
    (layout.positions + layout.velocities).max(layout.multipliers).max(layout.inputs)
}

fn check(programs: &Programs) -> Result<(), Refusal> {
    if Room::of(programs).is_none() && programs.touching.is_some() {
        let (velocities, forces) = (programs.layout.velocities, programs.layout.reactions);
        return Err(Refusal::Touching { velocities, forces });
    }
    let mut functions = programs.functions();
    functions.retain(|function| !function.is_contact_point());
    if !functions.is_empty() {
        return Err(Refusal::Functions(functions.iter().map(Opaque::rust_name).collect()));
    }
    let (entries, most) = (room(programs), LARGEST);
    if entries > most { Err(Refusal::TooLarge { entries, most }) } else { Ok(()) }
}
