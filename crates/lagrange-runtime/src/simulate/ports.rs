//! Settings of a run for inputs and outputs.

use std::boxed::Box;
use std::vec::Vec;

use crate::scalar::Scalar;
use crate::simulate::builder::Simulation;
use crate::simulate::control::{Law, Undriven};
use crate::simulate::controllers::Act;
use crate::simulate::observer::{columns_of, inputs};
use crate::system::{
    ControlledSystem, MechanicalSystem, OutputSystem, SettingError, StepFailure, Undefined, split,
};

// Each method has its own bounds on the system, so that compiler messages name the missing trait.
impl<'a, M: MechanicalSystem, K, E> Simulation<'a, M, K, Undriven, E> {
    /// Sets the inputs at every instant by a law, a function of time and state: a feedback, or a
    /// force over time.
    ///
    /// The law is part of the equations: methods evaluate it at trial states in any order, so it
    /// cannot have memory. It receives the system with the declared, set or
    /// [sampled](Simulation::sampled) inputs, from which it copies those that it does not compute.
    /// Contacts, friction, events and observers see the inputs of the law. Every input becomes a
    /// column.
    ///
    /// Jumps and kinks of a law are not located. If they matter, put them into the declaration,
    /// such as `min(u, 20)` for a force that saturates. Runs then locate the points where the
    /// motion is not smooth. Implicit methods compute the derivatives of a law by difference
    /// quotients.
    ///
    /// ```
    /// use lagrange::Simulate;
    ///
    /// lagrange::system! {
    ///     struct Cart;
    ///     coord x;
    ///     input u;
    ///     kinetic = 1/2 * dot(x)^2;
    ///     force x = u;
    /// }
    ///
    /// let cart = Cart::default();
    /// let spring = |_: &Cart, _, state: CartState| CartInputs { u: -4.0 * state.x };
    /// let motion = cart.simulate([1.0, 0.0]).until(3.0).drive(spring).run()?;
    /// assert!((motion.last()[0] - 6.0_f64.cos()).abs() < 1e-9);
    /// assert_eq!(motion.column("u").unwrap()[0], -4.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn drive<F>(mut self, law: F) -> Simulation<'a, M, K, Law<F>, E>
    where
        M: ControlledSystem,
        F: Fn(&M, M::Scalar, M::NamedState) -> M::Inputs,
    {
        self.plan.record_inputs(self.system, Box::new(columns_of(inputs::<M>)));
        let Simulation { system, state, plan, callbacks, method, end, .. } = self;
        Simulation { system, state, plan, callbacks, method, drive: Law::new(law), end }
    }
}

impl<'a, M: MechanicalSystem, K, D, E> Simulation<'a, M, K, D, E> {
    /// Sets the inputs by a controller that is called at the start and then every `period`. Inputs
    /// are held in between (a zero-order hold).
    ///
    /// A step ends at each of these instants, so no step sees two values of an input. The
    /// controller may have memory, such as the integral of a deviation. It is called exactly once
    /// at the start and at each instant, in order, with the current state. It is not called at the
    /// end of a run. It receives the system with its present inputs, from which it copies those
    /// that it does not compute. Several controllers at the same instant act in the order in which
    /// they were added. Every input becomes a column, which holds the new value at an instant.
    ///
    /// ```
    /// use lagrange::Simulate;
    ///
    /// lagrange::system! {
    ///     struct Cart;
    ///     coord x;
    ///     input u;
    ///     kinetic = 1/2 * dot(x)^2;
    ///     force x = u;
    /// }
    ///
    /// let cart = Cart::default();
    /// let mut pushes = 0.0;
    /// let counting = |_: &Cart, _, _: CartState| {
    ///     pushes += 1.0;
    ///     CartInputs { u: pushes }
    /// };
    /// let motion = cart.simulate([0.0, 0.0]).until(3.0).sampled(1.0, counting).every(1.0).run()?;
    /// assert_eq!(motion.column("u").unwrap(), [1.0, 2.0, 3.0, 3.0]);
    /// assert!((motion.last()[1] - 6.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sampled<F>(mut self, period: M::Scalar, control: F) -> Self
    where
        M: ControlledSystem,
        F: FnMut(&M, M::Scalar, M::NamedState) -> M::Inputs + 'a,
    {
        self.plan.control(period, held(control));
        self.plan.record_inputs(self.system, Box::new(columns_of(inputs::<M>)));
        self
    }
}

/// Returns a controller as a function that sets the inputs of a system, if they are finite.
pub(crate) fn held<'a, M, F>(mut control: F) -> Act<'a, M>
where
    M: ControlledSystem,
    F: FnMut(&M, M::Scalar, M::NamedState) -> M::Inputs + 'a,
{
    Box::new(move |system, t, y| {
        let inputs = control(system, t, M::NamedState::from(*y));
        check_finite(system, t, inputs)?;
        Ok(system.with_inputs(inputs))
    })
}

impl<M: MechanicalSystem, K, D, E> Simulation<'_, M, K, D, E> {
    /// Adds a column for each component of each output, such as `height`, `tip.x` and `tip.y`.
    pub fn outputs(mut self) -> Self
    where
        M: OutputSystem,
    {
        self.plan.observe(self.system.output_names(), Box::new(columns_of(M::outputs)));
        self
    }

    /// Adds the columns of an output or of one component, such as `tip` or `tip.x`. An undeclared
    /// output is reported as an error by the run.
    pub fn record(mut self, output: &'static str) -> Self
    where
        M: OutputSystem,
    {
        let belongs = |name: &str| {
            name.strip_prefix(output).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let known = self.system.output_names();
        let chosen = (0..known.len()).filter(|&index| belongs(known[index])).collect::<Vec<_>>();
        if chosen.is_empty() {
            self.plan.settings.refuse(SettingError::UnknownOutput { name: output, known });
            return self;
        }
        let names: Vec<_> = chosen.iter().map(|&index| known[index]).collect();
        let extend = move |system: &M, t, y: &M::State, row: &mut Vec<_>| {
            let (q, v) = split::<M>(y);
            let outputs = system.outputs(t, &q, &v);
            row.extend(chosen.iter().map(|&index| outputs.as_ref()[index]));
        };
        self.plan.observe(names, Box::new(extend));
        self
    }
}

/// Checks the inputs of a sample.
///
/// # Errors
/// If an input is not finite.
fn check_finite<M: ControlledSystem>(
    system: &M,
    time: M::Scalar,
    inputs: M::Inputs,
) -> Result<(), StepFailure<M::Scalar>> {
    let values: M::InputVector = inputs.into();
    let mut named = system.input_names().iter().zip(values.as_ref());
    match named.find(|(_, value)| !value.is_finite()) {
        Some((name, &value)) => Err(StepFailure::Undefined(Undefined::Input { name, value, time })),
        None => Ok(()),
    }
}
