//! Derivatives of motions with respect to parameters, inputs and initial values.

mod company;
mod equations;
mod lanes;
mod stacked;
mod system;
mod variable;

use std::format;
use std::string::String;
use std::sync::Arc;
use std::vec::Vec;

pub use self::stacked::Stacked;
pub use self::system::Sensitive;
pub use self::variable::Varied;
use self::variable::VariedPlace;
use crate::scalar::{Number, Scalar};
use crate::simulate::builder::Simulation;
use crate::simulate::closed_loop::{ClosedLoop, GivenEvent};
use crate::simulate::control::Drive;
use crate::simulate::observer::state_names;
use crate::simulate::plan::RunSettings;
use crate::system::{
    EventSource, MechanicalSystem, OdeSystem, ParametricSystem, ScalarOf, SettingError, StepFailure,
};

impl<'a, M: MechanicalSystem, K, D, E> Simulation<'a, M, K, D, E> {
    /// Adds the derivatives of the state with respect to parameters, inputs of constant value and
    /// initial values: a column such as `d(theta)/d(m)` for each pair. At most 24 names are
    /// accepted.
    ///
    /// Names refer to parameters, inputs and states; the name of a state stands for its initial
    /// value. Derivatives are taken at fixed times, even for motions that an event stops.
    /// [`Trajectory::sensitivities`](super::Trajectory::sensitivities) returns them as vectors.
    ///
    /// The derivatives are unknowns of the integration, and their errors count like errors of the
    /// state. They are measured as changes of the state per relative change of the variable. Steps
    /// are therefore shorter; [`sensitivities_alongside`](Self::sensitivities_alongside) keeps the
    /// steps of the state alone.
    ///
    /// With `emit { jacobian }`, rates of derivatives are exact. Otherwise, as for systems with
    /// contacts, they are differences with errors of about 10⁻¹². Changes at events are always
    /// differences. The reaction to an event is called several times, and must be a function of
    /// system, time and state. A run ends with
    /// [`NotDifferentiable`](crate::integrate::StepFailure::NotDifferentiable) if a motion has no
    /// derivative, as at an event that is only touched.
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
    /// let motion = oscillator.simulate([1.0, 0.0]).until(3.0).sensitivities(["k", "x"]).run()?;
    /// let slopes = motion.column("d(x)/d(k)").unwrap();
    /// assert!((slopes.last().unwrap() + 0.75 * 6.0_f64.sin()).abs() < 1e-8);
    /// let [by_k, by_start] = motion.sensitivities(motion.len() - 1).unwrap()[..] else { panic!() };
    /// assert_eq!(by_k[0], *slopes.last().unwrap());
    /// assert!((by_start[0] - 6.0_f64.cos()).abs() < 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sensitivities<V, const N: usize>(self, names: V) -> Simulation<'a, M, K, V::Sensitive<M, D, N>, E>
    where
        V: Variables,
        M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    {
        self.differentiated::<V, N>(names.into(), Number::ONE)
    }

    /// Adds derivatives as [`sensitivities`](Self::sensitivities) does, with steps chosen for the
    /// state alone. Errors of the derivatives are not controlled.
    pub fn sensitivities_alongside<V, const N: usize>(
        self,
        names: V,
    ) -> Simulation<'a, M, K, V::Sensitive<M, D, N>, E>
    where
        V: Variables,
        M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    {
        self.differentiated::<V, N>(names.into(), uncounted())
    }

    fn differentiated<V, const N: usize>(
        mut self,
        names: Vec<&'static str>,
        weight: M::Scalar,
    ) -> Simulation<'a, M, K, V::Sensitive<M, D, N>, E>
    where
        V: Variables,
        M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    {
        let variables = self.plan.settings.find_variables(self.system, &self.state, names, weight);
        let Simulation { system, state, plan, callbacks, method, drive, end } = self;
        let drive = V::around(drive, variables);
        Simulation { system, state, plan, callbacks, method, drive, end }
    }
}

/// Returns a weight of derivatives whose errors are negligible compared with an absolute tolerance.
pub(crate) fn uncounted<S: Scalar>() -> S {
    S::epsilon().powi(4)
}

#[cfg(feature = "linear")]
impl<'a, M: MechanicalSystem, K, D, E> Simulation<'a, M, K, D, E> {
    /// Adds the derivatives with respect to initial values, starting with index `first`, under
    /// fewer than R names.
    pub(crate) fn by_initial_values<const N: usize, const R: usize>(
        self,
        first: usize,
        names: &[&'static str],
    ) -> Simulation<'a, M, K, Differentiated<M, D, N, R>, E>
    where
        M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    {
        let Simulation { system, state, plan, callbacks, method, drive, end } = self;
        let initial = |index, name| of_place(name, VariedPlace::Initial(index), system, &state, Number::ONE);
        let variables = (first..N).zip(names).map(|(index, name)| initial(index, name));
        let drive = Differentiated { drive, variables: variables.collect() };
        Simulation { system, state, plan, callbacks, method, drive, end }
    }
}

impl<S: Scalar> RunSettings<S> {
    /// Finds variables by name; unknown names are recorded as errors.
    pub(crate) fn find_variables<M: ParametricSystem<Scalar = S>>(
        &mut self,
        system: &M,
        start: &M::State,
        names: Vec<&'static str>,
        weight: S,
    ) -> Arc<[Varied<S>]> {
        let found =
            names.into_iter().map(|name| varied(system, start, name, weight)).collect::<Result<_, _>>();
        found.unwrap_or_else(|error| {
            self.refuse(error);
            Arc::default()
        })
    }
}

/// Finds a variable by name.
pub(crate) fn varied<M: ParametricSystem>(
    system: &M,
    start: &M::State,
    name: &'static str,
    weight: M::Scalar,
) -> Result<Varied<M::Scalar>, SettingError<M::Scalar>> {
    let description = system.description();
    let numbers = system.numbers();
    let number = numbers.iter().position(|number| *number == name).map(VariedPlace::Number);
    let initial = || state_names(description).position(|state| state == name).map(VariedPlace::Initial);
    let place = number.or_else(initial);
    let place = place.ok_or(SettingError::UnknownVariable { name, numbers, state: description })?;
    Ok(of_place(name, place, system, start, weight))
}

/// Returns the variable at a place.
fn of_place<M: ParametricSystem>(
    name: &'static str,
    place: VariedPlace,
    system: &M,
    start: &M::State,
    weight: M::Scalar,
) -> Varied<M::Scalar> {
    Varied { name, place, scale: weight, weight }.scaled(system, start)
}

/// Names of variables: an array of 1 to 24 names.
#[diagnostic::on_unimplemented(
    message = "`{Self}` are no names of variables to differentiate by",
    note = "write an array of 1 to 24 names, such as `[\"m\", \"theta\"]`"
)]
pub trait Variables: Into<Vec<&'static str>> {
    /// The drive D, with derivatives of a state of N entries by as many variables.
    type Sensitive<M: MechanicalSystem, D, const N: usize>;

    /// Returns that drive.
    fn around<M: MechanicalSystem, D, const N: usize>(
        drive: D,
        variables: Arc<[Varied<M::Scalar>]>,
    ) -> Self::Sensitive<M, D, N>;
}

macro_rules! variables {
    ($($count:literal)*) => {
        $(impl Variables for [&'static str; $count] {
            type Sensitive<M: MechanicalSystem, D, const N: usize> = Differentiated<M, D, N, { $count + 1 }>;

            fn around<M: MechanicalSystem, D, const N: usize>(
                drive: D,
                variables: Arc<[Varied<M::Scalar>]>,
            ) -> Self::Sensitive<M, D, N> {
                Differentiated { drive, variables }
            }
        })*
    };
}

variables! { 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 }

/// A drive D whose motions are differentiated with respect to variables.
pub struct Differentiated<M: MechanicalSystem, D, const N: usize, const R: usize> {
    drive: D,
    variables: Arc<[Varied<M::Scalar>]>,
}

#[cfg(feature = "fit")]
impl<M: MechanicalSystem, D, const N: usize, const R: usize> Differentiated<M, D, N, R> {
    /// Returns the drive with derivatives with respect to fewer than R variables.
    pub(crate) fn new(drive: D, variables: Arc<[Varied<M::Scalar>]>) -> Self {
        debug_assert!(variables.len() < R);
        Differentiated { drive, variables }
    }
}

impl<M: MechanicalSystem, D: Clone, const N: usize, const R: usize> Clone for Differentiated<M, D, N, R> {
    fn clone(&self) -> Self {
        Differentiated { drive: self.drive.clone(), variables: Arc::clone(&self.variables) }
    }
}

impl<M, D, const N: usize, const R: usize> Drive<M> for Differentiated<M, D, N, R>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    D: Drive<M>,
    D::Closed: OdeSystem<State = [ScalarOf<M>; N]>,
{
    type Closed = Sensitive<M, D::Closed, N, R>;

    fn close<T>(&self, system: &M, run: impl FnOnce(&Self::Closed) -> T) -> T {
        self.drive.close(system, |closed| {
            let closed = closed.with_plant(copy(system));
            run(&Sensitive { closed, variables: Arc::clone(&self.variables) })
        })
    }

    /// Scales changes by the values of parameters and initial values in this motion.
    fn for_motion(&self, system: &M, start: &M::State) -> Self {
        let variables = self.variables.iter().map(|variable| variable.scaled(system, start));
        Differentiated { drive: self.drive.for_motion(system, start), variables: variables.collect() }
    }
}

/// Returns a copy of a system, in its present modes.
pub(super) fn copy<M: ParametricSystem>(system: &M) -> M {
    system.with_number(usize::MAX, Number::ZERO)
}

/// Maximum number of restarts to compare.
const MAX_RESTARTS: usize = 1000;

impl<M, L, const N: usize, const R: usize> ClosedLoop<M> for Sensitive<M, L, N, R>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    L: ClosedLoop<M> + OdeSystem<Scalar = ScalarOf<M>, State = [ScalarOf<M>; N]>,
{
    fn plant(&self) -> &M {
        self.closed.plant()
    }

    fn with_plant(&self, plant: M) -> Self {
        Sensitive { closed: self.closed.with_plant(plant), variables: Arc::clone(&self.variables) }
    }

    fn into_plant(self) -> M {
        self.closed.into_plant()
    }

    fn detached(&self) -> Option<Self> {
        Some(self.with_plant(copy(self.closed.plant())))
    }

    fn ask<T>(&self, t: M::Scalar, y: &M::State, question: impl FnOnce(&M) -> T) -> T {
        self.closed.ask(t, y, question)
    }

    /// Changes of parameters and initial values move the start as constraints and closed contacts
    /// let them.
    fn extended(&self, t: M::Scalar, y: &M::State) -> Self::State {
        let begun = self.closed.begin(t, y).ok().flatten().map(|closed| self.around(closed));
        let begun = begun.as_ref().unwrap_or(self);
        let mut whole = Stacked::new(*y, self.variables.len());
        for (variable, change) in self.variables.iter().zip(&mut whole.rows[1..]) {
            if let VariedPlace::Initial(index) = variable.place {
                change[index] = variable.scale;
            }
            if begun.is_constrained() {
                let restored = |closed: &L, t, y: &M::State| {
                    let mut state = *y;
                    closed.restore(t, &mut state).ok().map(|()| state)
                };
                let direction = *change;
                let found = begun.along((t, y), (Number::ZERO, &direction), Some(variable), restored);
                *change = found.unwrap_or([M::Scalar::NAN; N]);
            }
        }
        whole
    }

    fn state_of_plant(y: &Self::State) -> M::State {
        y.rows[0]
    }

    fn check(
        &self,
        [start, end]: [M::Scalar; 2],
        has_controllers: bool,
    ) -> Result<(), SettingError<M::Scalar>> {
        if has_controllers {
            let what = "sensitivities do not go through sampled controllers, which may have a memory: use `.drive(…)`";
            return Err(SettingError::Invalid(what));
        }
        if self.closed.noise().acts() {
            let what = "derivatives do not go through white noise: compare runs along the same path, or replace each noise with an `input`";
            return Err(SettingError::Invalid(what));
        }
        let restarts = |closed: &L| {
            let next = |t: &M::Scalar| closed.next_restart(*t, end);
            std::iter::successors(next(&start), next).take(MAX_RESTARTS).collect::<Vec<_>>()
        };
        let here = restarts(&self.closed);
        let step = M::Scalar::epsilon().sqrt();
        let moves = |variable: &&Varied<M::Scalar>| {
            let step = step / variable.weight;
            [step, -step].into_iter().any(|by| self.moved(variable, by, restarts) != here)
        };
        match self.variables.iter().find(moves) {
            Some(variable) => Err(SettingError::MovesTimes { name: variable.name }),
            None => Ok(()),
        }
    }

    fn further_columns(&self) -> Vec<String> {
        let names = state_names(self.plant().description()).collect::<Vec<_>>();
        let columns = self.variables.iter().flat_map(|variable| {
            let by = match variable.place {
                VariedPlace::Number(_) => variable.name.into(),
                VariedPlace::Initial(_) => format!("start.{}", variable.name),
            };
            names.iter().map(move |name| format!("d({name})/d({by})"))
        });
        columns.collect()
    }

    fn variables(&self) -> usize {
        self.variables.len()
    }

    fn extend_row(&self, y: &Self::State, row: &mut Vec<M::Scalar>) {
        for (variable, change) in self.variables.iter().zip(y.derivatives()) {
            row.extend(change.map(|change| change / variable.scale));
        }
    }

    fn after_event(
        &self,
        (t, y): (M::Scalar, &Self::State),
        mut after: M::State,
        event: &mut dyn GivenEvent<M>,
    ) -> Result<Self::State, StepFailure<M::Scalar>> {
        let begun = self.closed.begin(t, &after)?;
        let next = begun.as_ref().unwrap_or(&self.closed);
        next.restore(t, &mut after)?;
        let event = core::cell::RefCell::new(event);
        let source = EventSource::Given(event.borrow().index());
        let value =
            |closed: &L, t, y: &M::State| closed.ask(t, y, |plant| event.borrow_mut().value(plant, t, y));
        let outcome = |closed: &L, t, y: &M::State| {
            let mut state = closed.ask(t, y, |plant| event.borrow_mut().outcome(plant, t, y))?;
            closed.restore(t, &mut state).ok().map(|()| state)
        };
        self.after((t, y), source, value, outcome, (next, after))
    }
}
