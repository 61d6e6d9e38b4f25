//! The interpreter beside the reference.
//!
//! The scale of an error is the change of the result when each operation of the reference is
//! perturbed at random by a relative 2⁻⁶⁴. It shows how roundings grow from energies to results,
//! including cancellation and the condition of all matrices. See Vignes, "A stochastic arithmetic
//! for reliable scientific computation", Mathematics and Computers in Simulation 35 (1993) 233–261.
//! So a wrong term stands out, and digits that no algorithm keeps are not blamed.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::digits::{Arithmetic, Real, approximate};
use crate::jet::Field;
use crate::layout::Layout;
use crate::reference::{FREE, Question, Results};
use crate::tree::Declaration;
use crate::world::State;

/// Bits of the reference, and of its noisy repetitions.
const BITS: [usize; 2] = [256, 128];
/// Noise has the relative magnitude 2⁻⁶⁴.
const NOISE: i32 = 64;
/// Repetitions at first, and before a difference is reported.
const REPETITIONS: [u64; 2] = [1, 5];
/// Factor by which roundings in doubles may exceed the worst of the repetitions.
const SLACK: f64 = 64.0;
/// Relative uncertainty, compared with the largest result of a kind, above which results decide
/// nothing.
const FEWEST_DIGITS: f64 = 1e-7;

/// The verdict on a state.
#[derive(Clone, Debug)]
pub(crate) enum Verdict {
    /// The largest error in units of the expected error.
    Agrees(f64),
    /// The reference has no value, or too few digits to decide.
    Undecided(&'static str),
    Differs(String),
}

impl Verdict {
    pub(crate) fn differs(&self) -> bool {
        matches!(self, Verdict::Differs(_))
    }
}

/// Derives a system through the language, or returns its errors.
pub(crate) fn derived(declaration: &Declaration, choice: StrategyChoice) -> Result<NumericSystem, String> {
    let derived = parse(&declaration.to_string()).and_then(|system| system.derive(choice));
    derived.map(|derived| NumericSystem::new(&derived)).map_err(|report| report.to_string())
}

/// Judges a system at a state by the energies of a declaration.
pub(crate) fn verdict(system: &NumericSystem, reference: &Declaration, at: &(State, Vec<f64>)) -> Verdict {
    let layout = Layout::of(&reference.statements);
    let question = Question { declaration: reference, layout: &layout, state: &at.0, wanted: &at.1 };
    let Some(exact) = question.results(&mut Field::exact(BITS[0])) else {
        return Verdict::Undecided("no value");
    };
    let first = judged(system, at, &question, &exact, REPETITIONS[0]);
    if first.differs() { judged(system, at, &question, &exact, REPETITIONS[1]) } else { first }
}

fn judged(
    system: &NumericSystem,
    at: &(State, Vec<f64>),
    question: &Question<'_>,
    exact: &Results,
    repetitions: u64,
) -> Verdict {
    let noisy = (0..repetitions).map(|seed| question.results(&mut Field::noisy(BITS[1], NOISE, seed)));
    let Some(noisy) = noisy.collect::<Option<Vec<_>>>() else { return Verdict::Undecided("no value nearby") };
    let mut judgements = Vec::new();
    let free = exact.iter().find(|(name, _)| name == FREE).map_or(0.0, |(_, free)| largest(free));
    for (index, (name, exact)) in exact.iter().enumerate() {
        let Some(found) = found(system, at, name, exact.len()) else { continue };
        if found.len() != exact.len() {
            return Verdict::Differs(format!("{name}: {} numbers, not {}", found.len(), exact.len()));
        }
        let floor = if name == "accelerations" || name.starts_with("output") { free } else { 0.0 };
        let noisy = noisy.iter().map(|results| &results[index].1[..]).collect();
        let kind = Kind { name, exact, noisy, floor };
        // Accelerations and multipliers come first, from one matrix. If it is singular for one of
        // them, it is so for all.
        if !kind.is_decided() {
            return Verdict::Undecided("ill-conditioned");
        }
        judgements.push((kind, found));
    }
    let mut worst = 0.0_f64;
    for (kind, found) in &judgements {
        for (k, found) in found.iter().enumerate() {
            match kind.error(k, *found) {
                Ok(error) => worst = worst.max(error),
                Err(what) => return Verdict::Differs(what),
            }
        }
    }
    Verdict::Agrees(worst)
}

/// Numbers of one kind, such as the accelerations.
struct Kind<'a> {
    name: &'a str,
    exact: &'a [Real],
    noisy: Vec<&'a [Real]>,
    /// Magnitude of summands that numbers may be differences of.
    floor: f64,
}

fn largest(values: &[Real]) -> f64 {
    values.iter().map(|value| approximate(value).abs()).fold(0.0, f64::max)
}

impl Kind<'_> {
    fn largest(&self) -> f64 {
        largest(self.exact).max(self.floor)
    }

    /// Returns the expected error of doubles. Elimination mixes numbers of a kind.
    fn expected(&self, k: usize) -> f64 {
        let changes = self.noisy.iter().map(|noisy| {
            let difference = Arithmetic::new(BITS[1]).subtract(&noisy[k], &self.exact[k]);
            approximate(&difference).abs() * f64::from(NOISE).exp2()
        });
        (changes.fold(0.0, f64::max) + self.largest()) * f64::EPSILON
    }

    /// True if all numbers keep enough digits.
    fn is_decided(&self) -> bool {
        let most = FEWEST_DIGITS * self.largest().max(1.0);
        (0..self.exact.len()).all(|k| self.expected(k) <= most)
    }

    /// Returns the error of a number in units of the expected error, or a description of the
    /// failure.
    fn error(&self, k: usize, found: f64) -> Result<f64, String> {
        let (exact, expected) = (&self.exact[k], self.expected(k));
        let (name, value) = (self.name, approximate(exact));
        if !found.is_finite() {
            return Err(format!("{name} {k}: {found}, not {value:e}"));
        }
        let arithmetic = Arithmetic::new(BITS[1]);
        let error = approximate(&arithmetic.subtract(&arithmetic.float(found), exact)).abs();
        if error > SLACK * expected {
            return Err(format!(
                "{name} {k}: {found:e}, not {value:e}, off by {error:.1e}, expected {expected:.1e}"
            ));
        }
        Ok(if error == 0.0 { 0.0 } else { error / expected })
    }
}

/// Returns the interpreter's results of a kind.
pub(crate) fn found(
    system: &NumericSystem,
    (State { t, q, v }, wanted): &(State, Vec<f64>),
    name: &str,
    count: usize,
) -> Option<Vec<f64>> {
    let product = |product| system.product(product, *t, q, v);
    match name {
        "accelerations" => Some(system.acceleration(*t, q, v)),
        "multipliers" => Some(system.multipliers(*t, q, v)),
        "state rates" => {
            let rates = system.rhs(*t, &[&q[..], v].concat());
            let end = rates.len() - v.len();
            Some(rates[end - count..end].to_vec())
        }
        "energy" => product(Product::Energy),
        "momenta" => product(Product::Momenta),
        "mass matrix" => product(Product::MassMatrix),
        "forcing" => product(Product::Forcing),
        "kinetic energy" => product(Product::KineticEnergy),
        "potential energy" => product(Product::PotentialEnergy),
        "inverse dynamics" => system.inverse_dynamics(*t, q, v, wanted),
        _ => system.output(name.strip_prefix("output ")?, *t, q, v),
    }
}

/// The relative change of a result that tells two declarations apart.
const VISIBLE: f64 = 2e-10;

/// True if results of two declarations differ.
pub(crate) fn is_visible(one: &Declaration, other: &Declaration, at: &(State, Vec<f64>)) -> bool {
    let results = [one, other].map(|declaration| {
        let layout = Layout::of(&declaration.statements);
        let question = Question { declaration, layout: &layout, state: &at.0, wanted: &at.1 };
        question.results(&mut Field::exact(BITS[0]))
    });
    let [Some(one), Some(other)] = results else { return false };
    one.iter().zip(&other).any(|((name, one), (_, other))| {
        let kind = Kind { name, exact: one, noisy: Vec::new(), floor: 0.0 };
        one.iter().zip(other).any(|(a, b)| {
            let difference = approximate(&Arithmetic::new(BITS[1]).subtract(a, b)).abs();
            difference > VISIBLE * kind.largest()
        })
    })
}
