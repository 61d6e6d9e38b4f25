//! Gradients of costs with respect to many parameters, computed backwards along the steps of a run.

mod backwards;
mod jump;
mod trace;

use std::sync::Arc;
use std::vec::Vec;

use self::backwards::Backwards;
use self::trace::trace;
use crate::integrate::{ExplicitRungeKutta, Method};
use crate::scalar::{Number, Scalar};
use crate::simulate::builder::Simulation;
use crate::simulate::closed_loop::ClosedLoop;
use crate::simulate::control::Undriven;
use crate::simulate::plan::{RunPlan, RunSettings};
use crate::simulate::sensitivity::{Sensitive, Varied, copy, varied};
use crate::system::{MechanicalSystem, OdeSystem, ParametricSystem, ScalarOf, SettingError, StepFailure};

const OF_RUN: &str = "a gradient takes no events, controllers, columns, single times, restarts, dense output and progress of a run";
const KINKS: &str = "gradients do not go through kinks of tables: use `.sensitivities([…])`, or `interpolation: natural` with `outside: extend`";
const STATE: &str =
    "slopes by the start are in `by_start`, for all entries of the state: name parameters and inputs alone";

/// The gradient of a cost of a motion.
#[derive(Clone, PartialEq, Debug)]
pub struct Gradient<S, const N: usize> {
    /// The cost.
    pub value: S,
    /// Derivatives with respect to parameters and inputs, in the order of the names.
    pub by: Vec<S>,
    /// Derivatives with respect to the entries of the initial state.
    pub by_start: [S; N],
    /// Number of steps.
    pub steps: usize,
    /// Maximum number of states kept at the same time.
    pub kept_states: usize,
}

impl<M: MechanicalSystem, K> Simulation<'_, M, K, Undriven> {
    /// Computes a cost of the motion with its derivatives with respect to the named parameters and
    /// inputs, and to the initial state. With `emit { jacobian }`, the work hardly depends on the
    /// number of names; constraints add a few corrections per name.
    ///
    /// `cost` receives a time, the state and a vector of zeros. It writes its derivatives with
    /// respect to the state to the vector, and returns its value. It is called once for the end or,
    /// with [`every`](Simulation::every), for each sample, the last one first. Values and
    /// derivatives are summed. To integrate a cost along the motion, declare it as a `state`.
    ///
    /// The gradient is that of the motion as computed: each step is differentiated, with its length
    /// held. At most 3 √n + 2 states are kept for n steps without an event, and two numbers per
    /// step. The others are computed a second time.
    ///
    /// With `emit { jacobian }`, rates are differentiated exactly. Otherwise, as for systems with
    /// contacts, finite differences have errors of about 10⁻¹² and one direction per variable and
    /// entry of the state. So have projections onto closed contacts and of quaternions. At events,
    /// switches and ticks of clocks the adjoint jumps according to the transpose of the saltation
    /// matrix, which takes one reaction per direction.
    ///
    /// ```
    /// use lagrange::Simulate;
    ///
    /// lagrange::system! {
    ///     struct Oscillator;
    ///     param k = 4.0;
    ///     coord x;
    ///     kinetic = 1/2 * dot(x)^2;
    ///     potential = 1/2 * k * x^2;
    ///     emit { jacobian }
    /// }
    ///
    /// // x = cos(√k t), of which the derivative with respect to k is −t sin(√k t)/(2 √k).
    /// let oscillator = Oscillator::default();
    /// let gradient = oscillator.simulate([1.0, 0.0]).until(3.0).gradient(["k"], |_, [x, _], slope| {
    ///     slope[0] = 1.0;
    ///     *x
    /// })?;
    /// assert!((gradient.value - 6.0_f64.cos()).abs() < 1e-8);
    /// assert!((gradient.by[0] + 0.75 * 6.0_f64.sin()).abs() < 1e-8);
    /// assert!((gradient.by_start[0] - 6.0_f64.cos()).abs() < 1e-8);
    /// # Ok::<(), lagrange::integrate::StepFailure<f64>>(())
    /// ```
    ///
    /// # Errors
    /// If a step fails, a setting is invalid, an event or a projection has no derivative, or an
    /// event stops the motion before its end. Motions with kinks of tables have no gradient of this
    /// kind; use [`sensitivities`](Simulation::sensitivities). Neither do runs with controllers,
    /// columns, events of their own, restarts or progress.
    pub fn gradient<const N: usize>(
        self,
        names: impl IntoIterator<Item = &'static str>,
        cost: impl FnMut(M::Scalar, &M::State, &mut M::State) -> M::Scalar,
    ) -> Result<Gradient<M::Scalar, N>, StepFailure<M::Scalar>>
    where
        M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
        K: Method<M> + ExplicitRungeKutta,
    {
        let Simulation { system, state, plan, callbacks, method, .. } = self;
        let variables = names.into_iter().map(|name| number(system, &state, name));
        let variables = variables.collect::<Result<Arc<[_]>, _>>();
        let settings = &plan.settings;
        let is_reported = callbacks.are_set();
        let checked = variables.and_then(|variables| {
            let sensitive = Sensitive::<M, M, N, 2>::new(copy(system), Arc::clone(&variables));
            sensitive.check(settings.span, false)?;
            Ok((variables, checked(system, &plan, is_reported, method)?, samples(settings)?))
        });
        let (variables, method, samples) = checked.map_err(StepFailure::Setting)?;
        let start = (settings.span[0], state);
        let trace = trace(system, &method, start, &samples, settings.max_steps)?;
        Backwards::<M, K, N>::new(system, &variables).along(&trace, (start.0, &start.1), cost)
    }
}

/// Returns the method with its settings.
fn checked<M: ParametricSystem, K: Method<M>>(
    system: &M,
    plan: &RunPlan<'_, M>,
    is_reported: bool,
    method: K,
) -> Result<K, SettingError<M::Scalar>> {
    let settings = &plan.settings;
    let is_plain = plan.watches.is_empty() && plan.controllers.is_empty() && plan.columns.is_empty();
    let has_times = settings.is_dense || !settings.restarts.is_empty() || !settings.times.is_empty();
    let obstacles = [(!is_plain || has_times || is_reported, OF_RUN), (system.has_kinks(), KINKS)];
    match obstacles.into_iter().find(|(is_there, _)| *is_there) {
        Some((_, words)) => Err(SettingError::Invalid(words)),
        None => settings.check::<M, K>(system, &settings.names(system.description()), method),
    }
}

/// Returns the times of samples, the last of which is the end.
fn samples<S: Scalar>(settings: &RunSettings<S>) -> Result<Vec<S>, SettingError<S>> {
    let [start, end] = settings.span;
    let mut samples = Vec::new();
    if let Some(mut grid) = settings.grid()? {
        samples.push(start);
        samples.extend(std::iter::from_fn(|| grid.up_to(end)));
    }
    // A run of zero duration has one sample.
    if samples.last() != Some(&end) {
        samples.push(end);
    }
    Ok(samples)
}

/// Finds a parameter or input by its name.
fn number<M: ParametricSystem>(
    system: &M,
    start: &M::State,
    name: &'static str,
) -> Result<Varied<M::Scalar>, SettingError<M::Scalar>> {
    let found = varied(system, start, name, Number::ONE)?;
    found.number().map(|_| found).ok_or(SettingError::Invalid(STATE))
}
