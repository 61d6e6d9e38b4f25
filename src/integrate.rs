//! Methods that advance a system ẏ = f(t, y) in time.
//!
//! There is one file per family of methods, each citing its source. Methods need no heap, run
//! forwards or backwards in time, and stop with a [`StepFailure`] instead of propagating NaN or
//! infinity. States and times use compensated summation. Rounding errors therefore do not grow with
//! the number of steps, unless the method itself amplifies them.
//!
//! Pass a [`Method`] to [`integrate`] or to `simulate`, which also takes samples, detects events
//! and stores trajectories. Your own loops can drive a [`Stepper`].
//!
//! | method | for systems | order | symplectic | cost of a step | use it for |
//! |---|---|---|---|---|---|
//! | [`Verner98`], the default of `simulate` | any that is not stiff | 9, adaptive | no | 16 evaluations, 9 more if sampled within | accuracy, from 1e-4 to rounding |
//! | [`Taylor`] | with `emit { taylor }`, not stiff | 8 to 40, adaptive | no | one expansion, in time linear to quadratic in the order | errors below 1e-9 |
//! | [`Radau5`] | any, especially stiff ones | 5, adaptive | no | two to three iterations of 3 evaluations | stiff springs with dampers, compliant contacts, relaxation |
//! | [`RungeKutta4`] | any that is not stiff | 4 | no | 4 evaluations | fixed frame rates, forces with jumps |
//! | [`SymplecticEuler`] | separable, or with position constraints | 1 | yes | 1 acceleration | real-time frames at the lowest cost, without blow-up |
//! | [`StormerVerlet`] | separable, or with position constraints | 2 | yes | 1 acceleration | long runs at moderate accuracy |
//! | [`BlanesMoan4`] | separable | 4 | yes | 6 accelerations | long runs at high accuracy |
//! | [`ImplicitMidpoint`], [`GaussLegendre4`], [`GaussLegendre6`] | with momenta | 2, 4, 6 | yes | iterations of 1, 2, 3 evaluations | long runs with any mass matrix; stiff springs |
//! | [`Variational`] | with momenta | 4 | yes | iterations of 3 evaluations | momenta conserved to rounding, also with forces; constraints enforced |
//! | [`Stepped`](crate::contact::Stepped) | with contacts or friction | 1 | no | 1 evaluation, one complementarity problem for all impulses | many contacts, real time |
//! | [`EulerMaruyama`] | with [white noise](crate::system!) | 1 | no | 1 evaluation, 1 of the diffusion | rough forces, many cheap motions |
//! | [`StochasticRungeKutta4`] | with white noise | 3/2, or 1; 4 without noise | no | 4 evaluations, 4 of the diffusion | noise of any size, small noise above all |
//! | [`PlainGaussLegendre`] | any | 2, 4, 6 | for a constant mass matrix and velocity-independent forces | as above | as above, without momenta |
//!
//! A system is separable if its [declaration](crate::system!) has a constant mass matrix and
//! velocity-independent accelerations. Its type then implements
//! [`SeparableSystem`](crate::system::SeparableSystem); the compiler rejects other systems. A
//! system with position constraints that would be separable without them is a
//! [`LeapfrogSystem`](crate::system::LeapfrogSystem). [`StormerVerlet`] and [`SymplecticEuler`]
//! enforce its constraints themselves, as [`Variational`] does for all systems. The implicit
//! methods for any mass matrix require momenta and their rates, `emit { momentum_rates }`. All
//! implicit methods use Newton's method with `emit { jacobian }`. Without it, difference quotients
//! replace the Jacobian; fixed-step methods first try fixed-point iteration.
//!
//! If a system has [constraints](mod@crate::constraint), the initial state must nearly satisfy them
//! and is projected onto them. The end of every step is also projected, unless the method enforces
//! the constraints itself, and so are states within a step. A step that cannot be corrected is an
//! error with the last valid state; an adaptive method tries shorter steps first.

#[doc(inline)]
pub use lagrange_runtime::integrate::{
    BlanesMoan4, DifferentiableStep, EulerMaruyama, EventSource, FixedStepper, Formula, GaussLegendre,
    GaussLegendre4, GaussLegendre6, Hamiltonian, ImplicitMidpoint, IntegrationError, LanesMethod,
    LanesMethodVisitor, LanesStepper, MAX_LANES, Memory, Method, Outcome, PlainGaussLegendre, Radau5,
    RadauStepper, RungeKutta4, SettingError, Step, StepDerivatives, StepFailure, Stepper,
    StochasticRungeKutta4, StormerVerlet, SuspectStep, SymplecticEuler, Taylor, TaylorStepper, Variational,
    Verner98, VernerStepper, WienerPath, WithinStep, Work, rk4_step, undefined,
};
#[doc(inline)]
pub use lagrange_runtime::run::integrate;
