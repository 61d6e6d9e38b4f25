//! Inputs and outputs of systems, by name.

use core::fmt::Debug;

use super::{MechanicalSystem, NamedSystem, OdeSystem, StateVector};

/// A system with inputs: numbers that a controller sets during the motion.
///
/// Emitted types implement it if they declare an `input`. Runs set inputs by
/// [`drive`](crate::simulate::Simulation::drive) and
/// [`sampled`](crate::simulate::Simulation::sampled).
///
/// ```
/// use lagrange::system::ControlledSystem;
///
/// lagrange::system! {
///     /// A cart that is pushed.
///     #[derive(Debug)]
///     struct Cart;
///     param m = 2;
///     coord x;
///     input push, brake = 1;
///     kinetic = 1/2 * m * dot(x)^2;
///     force x = push - brake;
/// }
///
/// let cart = Cart::default();
/// let pushed = cart.with_inputs(CartInputs { push: 5.0, ..cart.inputs() });
/// assert_eq!(pushed.acceleration(0.0, &[0.0], &[0.0]), [2.0]);
/// assert_eq!(Cart::INPUTS, ["push", "brake"]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no inputs",
    note = "declare them as `input u;` and use them in a force, as in `force x = u;`"
)]
pub trait ControlledSystem: NamedSystem + Sized {
    /// A value for each input, under its name.
    type Inputs: Copy + Debug + Into<Self::InputVector> + From<Self::InputVector>;
    /// The inputs in the order of declaration, such as `[S; K]`.
    type InputVector: StateVector<Self::Scalar>;

    /// The names of the inputs in the order of the declaration.
    const INPUTS: &'static [&'static str];

    /// Returns the names of the inputs of this system. They are [`INPUTS`](Self::INPUTS) unless the
    /// system was read at run time.
    #[inline]
    fn input_names(&self) -> &'static [&'static str] {
        Self::INPUTS
    }

    /// Returns the present inputs.
    fn inputs(&self) -> Self::Inputs;

    /// Returns the system with other inputs.
    #[must_use]
    fn with_inputs(&self, inputs: Self::Inputs) -> Self;
}

/// A system with outputs: quantities that its declaration names.
///
/// Emitted types implement it if they declare an `output`. Runs record them by
/// [`outputs`](crate::simulate::Simulation::outputs) and
/// [`record`](crate::simulate::Simulation::record).
#[diagnostic::on_unimplemented(
    message = "`{Self}` declares no outputs",
    note = "declare them as `output tip = (x, y);`, or record any value with `.observe(\"name\", |system, t, y| …)`"
)]
pub trait OutputSystem: MechanicalSystem {
    /// A value for each component of each output, such as `[S; K]`.
    type Outputs: AsRef<[Self::Scalar]>;

    /// Names of the components: `height`, or `tip.x` and `tip.y`, or, for longer vectors, `all.0`,
    /// `all.1`, ….
    const OUTPUTS: &'static [&'static str];

    /// Returns the names of the outputs of this system. They are [`OUTPUTS`](Self::OUTPUTS) unless
    /// the system was read at run time.
    #[inline]
    fn output_names(&self) -> &'static [&'static str] {
        Self::OUTPUTS
    }

    /// Computes all components at time `t`, positions `q` and velocities `v`.
    fn outputs(
        &self,
        t: <Self as OdeSystem>::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
    ) -> Self::Outputs;
}
