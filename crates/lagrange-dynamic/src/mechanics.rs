//! Interpreted systems as mechanical systems, with energies and outputs.

use lagrange_core::model::Product;
use lagrange_runtime::system::{
    ControlledSystem, DelayedSystem, Description, EnergyFunction, LagrangianSystem, MechanicalSystem,
    NamedSystem, OutputSystem, StateVector, Unnamed, quaternion,
};

use crate::inline::Inline;
use crate::system::DynamicSystem;

impl<const CAPACITY: usize> MechanicalSystem for DynamicSystem<CAPACITY> {
    type Coordinates = Inline<CAPACITY>;
    type Velocities = Inline<CAPACITY>;
    type Columns<C> = Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &[];

    fn description(&self) -> &'static Description {
        &self.names.description
    }

    fn acceleration(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        Inline::of(&self.accelerations(t, q.as_ref(), v.as_ref()))
    }

    fn position_rates(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        Inline::of(&self.numeric.position_rates(t, q.as_ref(), v.as_ref()))
    }

    fn position_change(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let mut change = self.position_rates(t, q, v);
        let states = change.as_ref().len() - self.names.description.first_order_states;
        change.as_mut()[states..].fill(0.0);
        change
    }

    fn displacement(&self, _t: f64, from: &Inline<CAPACITY>, to: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let (from, to) = (from.as_ref(), to.as_ref());
        let quaternions = self.names.description.quaternions.iter();
        let mut turns = quaternions.flat_map(|&first| quaternion::turn(from, to, first));
        let velocities = self.programs().variables.positions_of_velocities.iter();
        let entries = velocities.map(|position| match position {
            Some(position) => to[*position] - from[*position],
            None => turns.next().unwrap_or(f64::NAN),
        });
        Inline::of(&entries.collect::<Vec<_>>())
    }

    fn parameter(&self, index: usize) -> Option<(&'static str, f64)> {
        let count = self.programs().layout.parameters;
        let name = self.names.fields[..count].get(index)?;
        Some((name, self.numeric.fields()[index]))
    }
}

/// The energy is NaN if the declaration excludes it.
impl<const CAPACITY: usize> EnergyFunction for DynamicSystem<CAPACITY> {
    fn energy(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> f64 {
        let energy = self.product(Product::Energy, t, q, v);
        energy.and_then(|values| values.first().copied()).unwrap_or(f64::NAN)
    }
}

/// Values are NaN unless the declaration has `emit { tests }`.
impl<const CAPACITY: usize> LagrangianSystem for DynamicSystem<CAPACITY> {
    fn lagrangian(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> f64 {
        let lagrangian = self.product(Product::Lagrangian, t, q, v);
        lagrangian.and_then(|values| values.first().copied()).unwrap_or(f64::NAN)
    }

    fn generalised_forces(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let forces = self.product(Product::GeneralisedForces, t, q, v);
        Inline::of(&forces.unwrap_or_else(|| vec![f64::NAN; v.as_ref().len()]))
    }
}

/// The state has no named fields; it is the vector itself.
impl<const CAPACITY: usize> NamedSystem for DynamicSystem<CAPACITY> {
    type NamedState = Inline<CAPACITY>;
}

impl<const CAPACITY: usize> ControlledSystem for DynamicSystem<CAPACITY> {
    type Inputs = Inline<CAPACITY>;
    type InputVector = Inline<CAPACITY>;

    const INPUTS: &'static [&'static str] = &[];

    fn input_names(&self) -> &'static [&'static str] {
        self.names.layout.inputs
    }

    fn inputs(&self) -> Inline<CAPACITY> {
        Inline::of(&self.numeric.fields()[self.programs().layout.parameters..])
    }

    /// Inputs without a number are NaN; if there are too many numbers, all inputs are NaN.
    fn with_inputs(&self, inputs: Inline<CAPACITY>) -> Self {
        let (layout, given) = (self.programs().layout, inputs.as_ref());
        let mut system = self.clone();
        for index in 0..layout.inputs {
            let value = given.get(index).filter(|_| given.len() <= layout.inputs);
            system.numeric.set_field(layout.parameters + index, value.copied().unwrap_or(f64::NAN));
        }
        system
    }
}

impl<const CAPACITY: usize> DelayedSystem for DynamicSystem<CAPACITY> {
    type Signals = Inline<CAPACITY>;

    fn lags(&self) -> Inline<CAPACITY> {
        Inline::of(&self.numeric.evaluate(&self.programs().lags, 0.0, &[], &[]))
    }

    fn signals(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let signals = self.evaluate_at(&self.programs().delayed_signals, t, q.as_ref(), v.as_ref());
        Inline::of(&signals)
    }

    fn signals_before(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Option<Inline<CAPACITY>> {
        let program = self.programs().past_signals.as_ref()?;
        Some(Inline::of(&self.numeric.evaluate(program, t, q.as_ref(), v.as_ref())))
    }

    fn with_delayed(&self, values: &Inline<CAPACITY>) -> Self {
        let (programs, mut system) = (self.programs(), self.clone());
        for (input, value) in programs.delayed_inputs.iter().zip(values.as_ref()) {
            system.numeric.set_field(programs.layout.parameters + input, *value);
        }
        system
    }
}

impl<const CAPACITY: usize> OutputSystem for DynamicSystem<CAPACITY> {
    type Outputs = Vec<f64>;

    const OUTPUTS: &'static [&'static str] = &[];

    fn output_names(&self) -> &'static [&'static str] {
        self.names.layout.outputs
    }

    fn outputs(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Vec<f64> {
        let outputs = self.programs().outputs.iter();
        outputs.flat_map(|(_, output)| self.evaluate_at(output, t, q.as_ref(), v.as_ref())).collect()
    }
}
