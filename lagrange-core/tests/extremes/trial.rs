//! A declaration under test, beside its reference, at samples of its parameters and states.

use lagrange_core::accuracy::Accuracy;
use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::expr::evaluate;
use lagrange_core::model::{Model, Product};
use lagrange_core::pipeline::{NumericSystem, parse};
use lagrange_core::symbol::Role;

use crate::digits::{Arithmetic, Real, approximate};
use crate::reference::{Reference, Truth, relative_error};

/// Values for some parameters, and a state.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    pub(crate) settings: Vec<(String, f64)>,
    pub(crate) t: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
}

impl Sample {
    /// Returns the value of a symbol. A parameter has its default unless it is set.
    pub(crate) fn value(&self, model: &Model, role: Role) -> f64 {
        let setting = |name: &str, default| {
            let set = self.settings.iter().find(|(known, _)| known == name);
            let default = || evaluate(&model.graph, &[Option::expect(default, "a default")], |_| f64::NAN)[0];
            set.map_or_else(default, |(_, value)| *value)
        };
        let parameter = |of: &[lagrange_core::model::Parameter], i: u32| {
            let parameter = &of[i as usize];
            setting(&parameter.name, parameter.default)
        };
        match role {
            Role::Parameter(i) => parameter(&model.parameters, i),
            Role::Input(i) => parameter(&model.inputs, i),
            Role::Time => self.t,
            Role::Coordinate(i) => self.q[i as usize],
            Role::Velocity(i) => self.v[i as usize],
            Role::Acceleration(_)
            | Role::Multiplier(_)
            | Role::Reaction(_)
            | Role::Noise(_)
            | Role::Side(_)
            | Role::State(_)
            | Role::Discrete(_)
            | Role::Operand(_)
            | Role::Placeholder(_) => f64::NAN,
        }
    }

    /// Changes the value of a symbol.
    pub(crate) fn set(&mut self, model: &Model, role: Role, value: f64) {
        let name = match role {
            Role::Parameter(i) => &model.parameters[i as usize].name,
            Role::Input(i) => &model.inputs[i as usize].name,
            Role::Coordinate(i) => return self.q[i as usize] = value,
            Role::Velocity(i) => return self.v[i as usize] = value,
            _ => return self.t = value,
        };
        self.settings.retain(|(known, _)| known != name);
        self.settings.push((name.clone(), value));
    }
}

/// The relative change of an input in difference quotients, far above rounding in 1024 bits.
const CHANGE: f64 = 1e-90;

impl Reference {
    /// Returns the exact values at a sample, or `None` where the mass matrix is singular.
    pub(crate) fn truth(&self, sample: &Sample) -> Option<Truth> {
        self.at(|role, arithmetic| self.value(sample, None, role, arithmetic))
    }

    /// Returns the condition numbers of the mass matrix as it is and scaled to a unit diagonal.
    pub(crate) fn conditions_at(&self, sample: &Sample) -> [f64; 2] {
        self.conditions(|role, arithmetic| self.value(sample, None, role, arithmetic))
    }

    /// Returns the value of a symbol while one input is slightly larger. Rounded quaternions are
    /// normalised.
    fn value(&self, sample: &Sample, larger: Option<Role>, role: Role, arithmetic: &mut Arithmetic) -> Real {
        let value = |role| {
            let value = arithmetic.float(sample.value(&self.model, role));
            let change = arithmetic.multiply(&value, &arithmetic.float(CHANGE));
            if larger == Some(role) { arithmetic.add(&value, &change) } else { value }
        };
        let Role::Coordinate(index) = role else { return value(role) };
        let own = |first: usize| (first..first + 4).contains(&(index as usize));
        let orientation = self.model.orientations.iter().find(|orientation| own(orientation.position));
        let Some(orientation) = orientation else { return value(role) };
        let first = index as usize - orientation.position;
        let components = [0, 1, 2, 3].map(|k| value(Role::Coordinate(index - first as u32 + k)));
        let length = arithmetic.sqrt(&arithmetic.dot(&components, &components));
        arithmetic.divide(&components[first], &length)
    }

    /// Returns every input on which accelerations may depend.
    pub(crate) fn roles(&self) -> Vec<Role> {
        let count = |n: usize| 0..u32::try_from(n).expect("few symbols");
        let model = &self.model;
        let states = count(model.coordinates.len()).map(Role::Coordinate);
        let states = states.chain(count(model.speeds.len()).map(Role::Velocity));
        let parameters = count(model.parameters.len()).map(Role::Parameter);
        let inputs = count(model.inputs.len()).map(Role::Input);
        parameters.chain(inputs).chain(states).chain([Role::Time]).collect()
    }

    /// Returns the magnification of rounded inputs at a sample.
    pub(crate) fn magnification(&self, sample: &Sample, truth: &Truth) -> Magnification {
        let exact = self.moved(sample, None);
        let mut sum = Magnification { components: vec![0.0; exact.len()], scaled: 0.0 };
        for role in self.roles() {
            let moved = self.moved(sample, Some(role));
            sum.scaled += scaled(&moved, truth) / CHANGE;
            for (sum, (moved, exact)) in sum.components.iter_mut().zip(moved.iter().zip(&exact)) {
                *sum += relative_error(moved, exact) / CHANGE;
            }
        }
        sum
    }

    /// Returns |xⱼ ∂äᵢ/∂xⱼ| / |äᵢ| for one input xⱼ.
    pub(crate) fn slopes(&self, sample: &Sample, input: Role) -> Vec<f64> {
        let [moved, exact] = [Some(input), None].map(|larger| self.moved(sample, larger));
        moved.iter().zip(&exact).map(|(moved, exact)| relative_error(moved, exact) / CHANGE).collect()
    }

    /// Returns the accelerations while one input is slightly larger.
    fn moved(&self, sample: &Sample, larger: Option<Role>) -> Vec<Real> {
        let truth = self.with_bits(1024, &|role, arithmetic: &mut Arithmetic| {
            self.value(sample, larger, role, arithmetic)
        });
        truth.map(|truth| truth.accelerations).unwrap_or_default()
    }
}

/// The magnification of rounding errors in the inputs, summed over all parameters, coordinates and
/// velocities.
#[derive(Clone, Debug)]
pub(crate) struct Magnification {
    /// Σⱼ |xⱼ ∂äᵢ/∂xⱼ| / |äᵢ|
    pub(crate) components: Vec<f64>,
    /// That magnification of the largest acceleration, in the scales of [`Errors::scaled`].
    pub(crate) scaled: f64,
}

/// A way of computing accelerations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Way {
    pub(crate) name: &'static str,
    pub(crate) level: Accuracy,
    pub(crate) strategy: StrategyChoice,
}

/// The levels of accuracy as users get them, and every strategy.
pub(crate) const WAYS: [Way; 5] = [STANDARD, STRICT, DENSE, RECURSIVE, SQUARES];
pub(crate) const FAST: Way = level("fast", Accuracy::Fast);
pub(crate) const STANDARD: Way = level("standard", Accuracy::Standard);
pub(crate) const STRICT: Way = level("strict", Accuracy::Strict);
pub(crate) const DENSE: Way = strategy("dense", Strategy::MassMatrix);
pub(crate) const RECURSIVE: Way = strategy("recursive", Strategy::ArticulatedBody);
pub(crate) const SQUARES: Way = strategy("squares", Strategy::SumOfSquares);

const fn level(name: &'static str, level: Accuracy) -> Way {
    Way { name, level, strategy: StrategyChoice::Cheapest }
}

const fn strategy(name: &'static str, strategy: Strategy) -> Way {
    Way { name, level: Accuracy::Standard, strategy: StrategyChoice::Always(strategy) }
}

/// A declaration derived along one way.
pub(crate) struct Subject {
    system: NumericSystem,
}

/// Differences between results and exact values.
#[derive(Clone, Debug)]
pub(crate) struct Errors {
    /// |Δäᵢ| / |äᵢ|
    pub(crate) components: Vec<f64>,
    /// max √Mᵢᵢ |Δäᵢ| / max √Mᵢᵢ |äᵢ|, which is independent of units.
    pub(crate) scaled: f64,
    /// The relative error of the energy.
    pub(crate) energy: f64,
}

impl Errors {
    pub(crate) fn worst_component(&self) -> f64 {
        self.components.iter().fold(0.0, |worst, error| worst.max(*error))
    }
}

impl Subject {
    /// Derives a declaration without a head along a way.
    pub(crate) fn new(declaration: &str, way: Way) -> Subject {
        let text = format!("#[accuracy({})] struct Subject; {declaration}", way.level.name());
        let derived = parse(&text).and_then(|system| system.derive(way.strategy));
        Subject { system: NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}"))) }
    }

    /// Returns q̈ at a sample.
    pub(crate) fn accelerations(&mut self, sample: &Sample) -> Vec<f64> {
        for (name, value) in &sample.settings {
            assert!(self.system.set(name, *value), "{name} is declared");
        }
        self.system.acceleration(sample.t, &sample.q, &sample.v)
    }

    /// Returns the errors at a sample.
    pub(crate) fn errors(&mut self, sample: &Sample, truth: &Truth) -> Errors {
        let accelerations = self.accelerations(sample);
        let energy = self.system.product(Product::Energy, sample.t, &sample.q, &sample.v);
        let energy = energy.map_or(f64::INFINITY, |energy| error(energy[0], &truth.energy));
        let pairs = accelerations.iter().zip(&truth.accelerations);
        let components = pairs.map(|(found, exact)| error(*found, exact)).collect();
        let arithmetic = Arithmetic::new(64);
        let found = accelerations.iter().map(|value| arithmetic.float(*value)).collect::<Vec<_>>();
        let is_finite = accelerations.iter().all(|value| value.is_finite());
        let scaled = if is_finite { scaled(&found, truth) } else { f64::INFINITY };
        Errors { components, scaled, energy }
    }
}

/// Returns the relative error of a float, or infinity unless it is finite.
fn error(found: f64, exact: &Real) -> f64 {
    if !found.is_finite() {
        return f64::INFINITY;
    }
    relative_error(&Arithmetic::new(64).float(found), exact)
}

/// Returns the largest error in scales that make the diagonal of the mass matrix one, relative to
/// the largest acceleration in the same scales.
fn scaled(found: &[Real], truth: &Truth) -> f64 {
    let arithmetic = Arithmetic::new(512);
    let scale = |values: &[Real]| {
        let scaled = truth.scales.iter().zip(values).map(|(scale, value)| scale * approximate(value).abs());
        scaled.fold(0.0, f64::max)
    };
    let pairs = found.iter().zip(&truth.accelerations);
    let difference = scale(&pairs.map(|(a, b)| arithmetic.subtract(a, b)).collect::<Vec<_>>());
    if difference == 0.0 { 0.0 } else { difference / scale(&truth.accelerations) }
}
