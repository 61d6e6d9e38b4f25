//! Methods that advance a system ẏ = f(t, y) in time.
//!
//! One file per family of methods, each citing its source. They need no heap, run forwards or
//! backwards in time, and stop with a [`StepFailure`] instead of passing on NaN or infinity. States
//! and times are summed with compensation. Rounding errors therefore do not grow with the number of
//! steps unless the method itself lets them.
//!
//! A [`Method`] is chosen and given to [`integrate`] or to `simulate`, which also samples, watches
//! for events and keeps trajectories. User-written loops drive a [`Stepper`].
//!
//! | method | for systems | order | symplectic | cost of a step | take it for |
//! |---|---|---|---|---|---|
//! | [`Verner98`], the default of the front door | any that is not stiff | 9, adaptive | no | 16 evaluations, 9 more if sampled within | accuracy, from 1e-4 to rounding |
//! | [`Taylor`] | with `emit { taylor }`, not stiff | 8 to 40, adaptive | no | one expansion, in time linear to quadratic in the order | errors below 1e-9 |
//! | [`Radau5`] | any, stiff ones first of all | 5, adaptive | no | two to three iterations of 3 evaluations | stiff springs with dampers, compliant contacts, relaxation |
//! | [`RungeKutta4`] | any that is not stiff | 4 | no | 4 evaluations | fixed frame rates, forces with jumps |
//! | [`SymplecticEuler`] | separable, or held by constraints on positions | 1 | yes | 1 acceleration | the cheapest frame that stays alive |
//! | [`StormerVerlet`] | separable, or held by constraints on positions | 2 | yes | 1 acceleration | long runs at moderate accuracy |
//! | [`BlanesMoan4`] | separable | 4 | yes | 6 accelerations | long runs, accurately |
//! | [`ImplicitMidpoint`], [`GaussLegendre4`], [`GaussLegendre6`] | with momenta | 2, 4, 6 | yes | iterations of 1, 2, 3 evaluations | long runs with any mass matrix; stiff springs |
//! | [`Variational`] | with momenta | 4 | yes | iterations of 3 evaluations | momenta kept to rounding, forces included; constraints enforced |
//! | [`Stepped`](crate::contact::Stepped) | with contacts or friction | 1 | no | 1 evaluation, one problem for all impulses | many contacts, real time |
//! | [`PlainGaussLegendre`] | any | 2, 4, 6 | for a constant mass matrix and forces without velocities | as above | as above, without momenta |
//!
//! A separable system is one whose [declaration](crate::system!) shows a constant mass matrix and
//! accelerations without velocities. Emitted types then implement
//! [`SeparableSystem`](crate::system::SeparableSystem), and the compiler refuses the others. One
//! that constraints on positions hold, and that would be separable without them, is a
//! [`LeapfrogSystem`](crate::system::LeapfrogSystem). [`StormerVerlet`] and [`SymplecticEuler`]
//! enforce its constraints themselves, as [`Variational`] does for all systems. The implicit
//! methods for any mass matrix require momenta and their rates, `emit { momentum_rates }`. All
//! implicit methods iterate by Newton's method with `emit { jacobian }`. Without it, difference
//! quotients replace the Jacobian; methods of equal steps try fixed points first.
//!
//! If a system has [constraints](mod@crate::constraint), a start must nearly satisfy these and is
//! moved onto them. The end of every step is brought back unless the method ends there itself, and
//! so are states within a step. A step that cannot be corrected is an error with the last good
//! state; an adaptive method tries shorter ones first.

#[doc(inline)]
pub use lagrange_runtime::integrate::{
    BlanesMoan4, EventSource, FixedStepper, Formula, GaussLegendre, GaussLegendre4, GaussLegendre6,
    Hamiltonian, ImplicitMidpoint, IntegrationError, LanesMethod, LanesMethodVisitor, LanesStepper,
    MOST_LANES, Memory, Method, Outcome, PlainGaussLegendre, Radau5, RadauStepper, RungeKutta4, SettingError,
    StepFailure, Stepper, StormerVerlet, SuspectStep, SymplecticEuler, Taylor, TaylorStepper, Variational,
    Verner98, VernerStepper, Work, rk4_step, undefined,
};
#[doc(inline)]
pub use lagrange_runtime::run::integrate;
