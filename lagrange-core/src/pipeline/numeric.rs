//! A derived system that can be evaluated without compilation: for tests, tools, build scripts and
//! systems read at run time.

use std::sync::Arc;

use super::callables::{Callables, calls};
use super::drawn::PlacedHeight;
use super::layout::Place;
use super::phases::DerivedPart;
use super::programs::Programs;
use super::routines::{Backend, Found, Numbers, Routines};
use super::second_way::{correction, is_regular, motion};
use super::series::MotionSeries;
use super::system::Derived;
use crate::model::Product;
use lagrange_algebra::program::{Program, run, run_with};
use lagrange_expr::elementary::row;
use lagrange_expr::expr::Function;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// Maximum number of values computed without heap allocation.
const SMALL: usize = 64;

/// A system as interpreted or compiled programs, with values for its parameters and inputs.
///
/// Vectors are in the order of the positions or of the velocities; angles in radians.
#[derive(Clone, Debug)]
pub struct NumericSystem {
    programs: Arc<Programs>,
    routines: Arc<Routines>,
    /// Values of parameters, then inputs.
    fields: Vec<f64>,
    /// Sides of the switches, where they are fixed.
    sides: Vec<Option<f64>>,
    callables: Callables,
}

fn are_finite(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite())
}

impl NumericSystem {
    /// Lowers all parts of `derived`. Parameters without a default are NaN until they are set.
    pub fn new(derived: &Derived) -> NumericSystem {
        NumericSystem::of(Arc::new(Programs::new(derived)))
    }

    /// Lowers all parts of a reduced type.
    pub fn of_part(part: &DerivedPart) -> NumericSystem {
        NumericSystem::of(Arc::new(Programs::of_part(part)))
    }

    /// Interprets programs. Parameters and inputs have their defaults, and switches are on the
    /// sides of the state.
    pub fn of(programs: Arc<Programs>) -> NumericSystem {
        let (fields, sides) = (programs.defaults.clone(), vec![None; programs.layout.sides]);
        let callables = Callables::solving(programs.solutions.clone());
        let routines = Arc::new(Routines::new(&programs, None));
        NumericSystem { programs, routines, fields, sides, callables }
    }

    /// Compiles programs on their first run. Programs that call functions of the user's crate, and
    /// those rejected by `backend`, remain interpreted; results do not change.
    pub fn compiled_by(self, backend: Arc<dyn Backend>) -> NumericSystem {
        let routines = Arc::new(Routines::new(&self.programs, Some(backend)));
        NumericSystem { routines, ..self }
    }

    /// Defines the numbers of the contact points of two blocks as a function of those of the
    /// blocks. Undefined numbers are NaN.
    #[must_use]
    pub fn with_contact_points(mut self, contact_points: fn(&[f64]) -> Vec<f64>) -> NumericSystem {
        self.callables.contact_points = Some(contact_points);
        self
    }

    /// Returns the compiler of the programs, if there is one.
    pub fn backend(&self) -> Option<&Arc<dyn Backend>> {
        self.routines.backend.as_ref()
    }

    /// Returns the programs, which include all names.
    pub fn programs(&self) -> &Arc<Programs> {
        &self.programs
    }

    /// Sets a parameter or an input, by its declared name, such as `k[0]` for an array element.
    /// Returns true if the name exists.
    pub fn set(&mut self, name: &str, value: f64) -> bool {
        let index = self.programs.variables.fields.iter().position(|known| known == name);
        index.is_some_and(|index| self.set_field(index, value))
    }

    /// Sets the parameter or input with this index, parameters first. Returns true if the index
    /// exists.
    pub fn set_field(&mut self, index: usize, value: f64) -> bool {
        self.fields.get_mut(index).map(|field| *field = value).is_some()
    }

    /// Returns parameters, then inputs.
    pub fn fields(&self) -> &[f64] {
        &self.fields
    }

    /// Fixes the sides of switches: 1 or −1, or `None` to follow the state.
    pub fn fix_sides(&mut self, sides: impl IntoIterator<Item = Option<f64>>) {
        self.sides.iter_mut().zip(sides).for_each(|(side, fixed)| *side = fixed);
    }

    /// Defines a function of the user's crate, or one of its derivatives, by its name in emitted
    /// code. Returns true if anything calls it. Undefined functions are NaN.
    ///
    /// ```
    /// use lagrange_core::derive::StrategyChoice;
    /// use lagrange_core::pipeline::{NumericSystem, parse};
    ///
    /// let bead = "function height(x); coord x; kinetic = 1/2 * (dot(x)^2 + dot(height(x))^2); potential = 9.81 * height(x);";
    /// let mut bead = NumericSystem::new(&parse(bead)?.derive(StrategyChoice::Cheapest)?);
    /// bead.define("height", |x| x[0] * x[0] / 2.0);
    /// bead.define("height_derivative", |x| x[0]);
    /// bead.define("height_second_derivative", |_| 1.0);
    ///
    /// let (x, v) = (0.5, 0.3);
    /// let acceleration = bead.acceleration(0.0, &[x], &[v])[0];
    /// assert!((acceleration + x * (v * v + 9.81) / (1.0 + x * x)).abs() < 1e-15);
    /// # Ok::<(), lagrange_core::diagnostics::Report>(())
    /// ```
    pub fn define(&mut self, name: &str, value: impl Fn(&[f64]) -> f64 + Send + Sync + 'static) -> bool {
        let of_solutions = self.callables.programs();
        let is_called = self.programs.all().chain(of_solutions).any(|program| calls(program, name));
        self.callables.define(name, value);
        is_called
    }

    /// Returns the number of velocities.
    pub fn degrees_of_freedom(&self) -> usize {
        self.programs.layout.velocities
    }

    fn at<'a>(&'a self, t: f64, q: &'a [f64], v: &'a [f64]) -> Numbers<'a> {
        let (positions, velocities, fields) = (q, v, &self.fields[..]);
        Numbers { t, positions, velocities, fields, ..Numbers::NONE }
    }

    /// Runs one of the programs of the system.
    fn run(&self, program: &Program, at: Numbers<'_>) -> Vec<f64> {
        let mut outputs = vec![f64::NAN; program.outputs().len()];
        self.run_into(program, &at, &mut outputs);
        outputs
    }

    /// Runs a program of the system whose number of outputs matches `outputs`.
    fn run_into(&self, program: &Program, at: &Numbers<'_>, outputs: &mut [f64]) {
        let found = self.routines.find(program);
        if found.taken().sides {
            self.run_on(found, &Numbers { sides: &self.sides(at), ..*at }, outputs);
        } else {
            self.run_on(found, at, outputs);
        }
    }

    /// Returns the sides of the switches, determined by the state unless fixed.
    fn sides(&self, at: &Numbers<'_>) -> Vec<f64> {
        if let Some(fixed) = self.sides.iter().copied().collect::<Option<_>>() {
            return fixed;
        }
        let (sign, mut values) = (row(Function::Sign).value, vec![f64::NAN; self.sides.len()]);
        self.run_on(self.routines.find(&self.programs.switches), at, &mut values);
        self.sides.iter().zip(values).map(|(side, value)| side.unwrap_or_else(|| sign(&[value]))).collect()
    }

    fn run_on(&self, found: Found<'_>, at: &Numbers<'_>, outputs: &mut [f64]) {
        if outputs.is_empty() {
            return;
        }
        let layout = &self.programs.layout;
        let code = self.routines.code(found, layout, &self.callables);
        if code.is_some_and(|code| code.run(at, outputs)) {
            return;
        }
        outputs.copy_from_slice(&self.interpreted(found.program, *at, |_| None));
    }

    /// Interprets a program. `given` returns values of roles that have no place in the layout.
    fn interpreted(
        &self,
        program: &Program,
        at: Numbers<'_>,
        given: impl Fn(Role) -> Option<f64>,
    ) -> Vec<f64> {
        let (layout, lists) = (&self.programs.layout, at.lists());
        let value_of = |role| match layout.place(role) {
            Some(Place::Time) => at.t,
            place => {
                let entry = place.and_then(|place| layout.entry(place));
                let value = entry.and_then(|(list, index)| lists[list].get(index)).copied();
                value.or_else(|| given(role)).unwrap_or(f64::NAN)
            }
        };
        let call = |function: &Opaque, arguments: &[f64]| self.callables.call(function, arguments);
        run_with(program, value_of, call)
    }

    /// Computes the height of terrain over a place at a state.
    pub fn height(&self, height: &PlacedHeight, (t, q, v): (f64, &[f64], &[f64]), place: [f64; 2]) -> f64 {
        let given = |role| {
            let index = height.variables.iter().position(|variable| *variable == role)?;
            place.get(index).copied()
        };
        self.interpreted(&height.program, self.at(t, q, v), given)[0]
    }

    /// Computes q̈, without forces of contacts and friction.
    pub fn acceleration(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        let mut accelerations = vec![f64::NAN; self.degrees_of_freedom()];
        self.accelerate(self.at(t, q, v), &mut accelerations);
        accelerations
    }

    fn accelerate(&self, at: Numbers<'_>, accelerations: &mut [f64]) {
        if self.programs.touching.is_some() {
            return self.run_into(&self.programs.accelerations, &at, accelerations);
        }
        if !self.straight_way(at, accelerations) {
            let [found, _] = self.second_way(at);
            accelerations.copy_from_slice(&found);
        }
    }

    /// Computes the multipliers in the order of the constraints, without forces of contacts and
    /// friction.
    pub fn multipliers(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        if self.programs.touching.is_some() {
            return self.multipliers_under(t, q, v, &vec![0.0; self.programs.layout.reactions]);
        }
        let at = self.at(t, q, v);
        let mut accelerations = vec![f64::NAN; self.degrees_of_freedom()];
        match self.trusted(&self.programs.multipliers, at) {
            Some(found) if self.straight_way(at, &mut accelerations) => found,
            _ => {
                let [_, multipliers] = self.second_way(at);
                multipliers
            }
        }
    }

    /// Computes the multipliers under these reactions of contacts and friction.
    pub fn multipliers_under(&self, t: f64, q: &[f64], v: &[f64], reactions: &[f64]) -> Vec<f64> {
        self.run(&self.programs.multipliers, Numbers { reactions, ..self.at(t, q, v) })
    }

    /// Computes the accelerations by elimination. Returns false if they are not finite, or not
    /// accurate enough.
    fn straight_way(&self, at: Numbers<'_>, accelerations: &mut [f64]) -> bool {
        let program = &self.programs.accelerations;
        let count = program.outputs().len();
        if count == accelerations.len() {
            self.run_into(program, &at, accelerations);
            return self.are_trusted(accelerations) && !self.programs.is_redundant;
        }
        let (mut small, mut large) = ([f64::NAN; SMALL], Vec::new());
        let found = match small.get_mut(..count) {
            Some(found) => found,
            None => {
                large.resize(count, f64::NAN);
                &mut large[..]
            }
        };
        self.run_into(program, &at, found);
        accelerations.copy_from_slice(&found[..accelerations.len()]);
        self.are_trusted(found) && !self.programs.is_redundant
    }

    /// Returns results by elimination, if they are finite and accurate enough.
    fn trusted(&self, program: &Program, at: Numbers<'_>) -> Option<Vec<f64>> {
        let mut found = self.run(program, at);
        let are_trusted = self.are_trusted(&found);
        found.truncate(found.len() - self.programs.growths);
        are_trusted.then_some(found)
    }

    /// True if results, and the growth of their rounding errors after them, are finite and accurate
    /// enough.
    fn are_trusted(&self, found: &[f64]) -> bool {
        let (found, growth) = found.split_at(found.len() - self.programs.growths);
        are_finite(found) && growth.iter().copied().all(is_regular)
    }

    /// Returns results by elimination, and the growth of their rounding errors.
    fn eliminated(&self, program: &Program, at: Numbers<'_>) -> [Vec<f64>; 2] {
        let mut found = self.run(program, at);
        let growth = found.split_off(found.len() - self.programs.growths);
        [found, growth]
    }

    /// Computes accelerations and multipliers from the undivided equations. Without these, the
    /// results of elimination are used. They are also used if the equations have no solution
    /// although no pivot was expected to vanish, since some accelerations may be finite.
    fn second_way(&self, at: Numbers<'_>) -> [Vec<f64>; 2] {
        let (n, values) = (self.degrees_of_freedom(), self.run(&self.programs.undivided, at));
        let constraints = if values.is_empty() { 0 } else { values.len() / (n + 1) - n };
        let mut motion = if values.is_empty() { Vec::new() } else { motion(n, constraints, &values) };
        let is_guarded = constraints > 0 || self.programs.growths > 0;
        if values.is_empty() || !is_guarded && !are_finite(&motion) {
            let Programs { accelerations, multipliers, .. } = &*self.programs;
            let [[mut accelerations, _], [multipliers, _]] =
                [accelerations, multipliers].map(|program| self.eliminated(program, at));
            accelerations.truncate(n);
            return [accelerations, multipliers];
        }
        let multipliers = motion.split_off(n);
        [motion, multipliers]
    }

    /// Computes q̇.
    pub fn position_rates(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        self.run(&self.programs.position_rates, self.at(t, q, v))
    }

    /// Computes ẏ = [q̇, v̇] for y = [q, v].
    pub fn rhs(&self, t: f64, y: &[f64]) -> Vec<f64> {
        let layout = &self.programs.layout;
        let (q, v) = y.split_at(layout.positions.min(y.len()));
        let mut rates = vec![f64::NAN; layout.positions + layout.velocities];
        self.rates(t, q, v, &mut rates);
        rates
    }

    /// Computes [q̇, v̇] in place, without heap allocation for compiled code of small systems.
    ///
    /// # Panics
    /// If the number of rates differs from the number of entries of the state.
    pub fn rates(&self, t: f64, q: &[f64], v: &[f64], rates: &mut [f64]) {
        let (at, positions) = (self.at(t, q, v), self.programs.layout.positions);
        let (of_positions, accelerations) = rates.split_at_mut(positions);
        self.run_into(&self.programs.position_rates, &at, of_positions);
        self.accelerate(at, accelerations);
    }

    /// Computes a product at a state: one value for an energy, one per coordinate for a vector,
    /// consecutive rows for a matrix. Jacobians only have the rows of the accelerations. `None` if
    /// it was not derived.
    pub fn product(&self, product: Product, t: f64, q: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        Some(self.evaluate(self.programs.product(product)?, t, q, v))
    }

    /// Computes the generalised forces that must act in addition to the declared ones to produce
    /// accelerations. `None` if they were not derived.
    pub fn inverse_dynamics(&self, t: f64, q: &[f64], v: &[f64], a: &[f64]) -> Option<Vec<f64>> {
        self.with_accelerations(Product::InverseDynamics, (t, q, v, a))
    }

    /// Computes the derivatives of the inverse dynamics in rows, by displacements of the positions,
    /// by states and by velocities. `None` if they were not derived.
    pub fn inverse_dynamics_jacobian(&self, t: f64, q: &[f64], v: &[f64], a: &[f64]) -> Option<Vec<f64>> {
        self.with_accelerations(Product::InverseDynamicsJacobian, (t, q, v, a))
    }

    /// Computes the regressor of the inverse dynamics in rows. Its columns multiply
    /// [`regressor_parameters`](Self::regressor_parameters), whose names are in
    /// [`Variables`](crate::emit::Variables). `None` if it was not derived.
    pub fn regressor(&self, t: f64, q: &[f64], v: &[f64], a: &[f64]) -> Option<Vec<f64>> {
        self.with_accelerations(Product::Regressor, (t, q, v, a))
    }

    /// Computes the parameters that multiply the columns of the regressor.
    pub fn regressor_parameters(&self) -> Vec<f64> {
        self.run(&self.programs.regressor_parameters, self.at(f64::NAN, &[], &[]))
    }

    /// Computes the components of a product at given accelerations, in the order of
    /// [`product`](Self::product). `None` if it was not derived.
    pub fn with_accelerations(
        &self,
        product: Product,
        (t, q, v, a): (f64, &[f64], &[f64], &[f64]),
    ) -> Option<Vec<f64>> {
        let program = self.programs.product(product)?;
        Some(self.run(program, Numbers { accelerations: a, ..self.at(t, q, v) }))
    }

    /// Computes the components of a declared output; `None` if there is none of that name.
    pub fn output(&self, name: &str, t: f64, q: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        let (_, program) = self.programs.outputs.iter().find(|(known, _)| known == name)?;
        Some(self.evaluate(program, t, q, v))
    }

    /// Runs a program of the system at a state, with the accelerations and multipliers of the
    /// motion. `reactions` computes the accelerations and the reactions of contacts and friction.
    pub fn evaluate_under(
        &self,
        program: &Program,
        (t, q, v): (f64, &[f64], &[f64]),
        reactions: impl FnOnce() -> [Vec<f64>; 2],
    ) -> Vec<f64> {
        let taken = self.routines.find(program).taken();
        if !(taken.accelerations || taken.multipliers || taken.reactions) {
            return self.run(program, self.at(t, q, v));
        }
        let [accelerations, reactions] = &reactions();
        let multipliers = &self.multipliers_under(t, q, v, reactions);
        self.run(program, Numbers { accelerations, multipliers, reactions, ..self.at(t, q, v) })
    }

    /// Runs a program of the system at a state, with the accelerations and multipliers of the
    /// motion, without contacts and friction.
    pub fn evaluate(&self, program: &Program, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        let taken = self.routines.find(program).taken();
        let accelerations = if taken.accelerations { self.acceleration(t, q, v) } else { Vec::new() };
        let multipliers = if taken.multipliers { self.multipliers(t, q, v) } else { Vec::new() };
        let (accelerations, multipliers) = (&accelerations[..], &multipliers[..]);
        self.run(program, Numbers { accelerations, multipliers, ..self.at(t, q, v) })
    }

    /// Computes the first slots of the steps of a Taylor series of the system, about a state.
    ///
    /// # Panics
    /// If the number of slots differs from that of the initial program.
    pub fn begin_series(&self, series: &MotionSeries, (t, q, v): (f64, &[f64], &[f64]), slots: &mut [f64]) {
        self.run_into(&series.initial, &self.at(t, q, v), slots);
    }

    /// Returns a function that computes the results of one step from the slots.
    pub fn series_step<'a>(&'a self, series: &'a MotionSeries) -> impl Fn(&[f64], &mut [f64]) + 'a {
        let found = self.routines.find(&series.step);
        let code = self.routines.code(found, &series.layout, &self.callables);
        move |slots, results| {
            let at = Numbers { fields: slots, ..Numbers::NONE };
            if !code.is_some_and(|code| code.run(&at, results)) {
                results.copy_from_slice(&run(&series.step, |role| match role {
                    Role::Parameter(index) => slots[index as usize],
                    _ => f64::NAN,
                }));
            }
        }
    }

    /// Computes M a for accelerations a.
    pub fn mass_times(&self, t: f64, q: &[f64], v: &[f64], a: &[f64]) -> Vec<f64> {
        self.run(&self.programs.mass_times, Numbers { accelerations: a, ..self.at(t, q, v) })
    }

    /// Computes the smallest change, measured by mass, that removes residuals of the constraints to
    /// first order.
    pub fn correction(&self, t: f64, q: &[f64], v: &[f64], residuals: &[f64]) -> Vec<f64> {
        let at = Numbers { multipliers: residuals, ..self.at(t, q, v) };
        let trusted = self.trusted(&self.programs.correction, at);
        if let Some(found) = trusted.filter(|_| !self.programs.is_redundant) {
            return found;
        }
        match self.run(&self.programs.undivided, at) {
            values if values.is_empty() => vec![f64::NAN; v.len()],
            values => correction(v.len(), residuals, &values),
        }
    }
}
