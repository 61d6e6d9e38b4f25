//! All scenes at random parameters and states that span 24 decades.
//!
//! Two numbers predict the error in units of rounding. The magnification κ of rounded inputs
//! affects every algorithm that computes sines and products of the inputs. The other is the
//! condition number c of the mass matrix scaled to a unit diagonal. Elimination by pivots loses
//! `κ + c`. Elimination by rotations loses `κ + √c` if velocities are weighted with the roots of
//! their masses. See Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., §10.1 and
//! §20.1.

use std::f64::consts::PI;

use lagrange_core::model::Model;

use crate::cases::cases;
use crate::random::Random;
use crate::reference::Reference;
use crate::scenes::{Scene, scenes};
use crate::trial::{DENSE, SQUARES, STANDARD, STRICT, Sample, Subject, WAYS, Way};

/// Random states of each scene.
const CASES: usize = 24;
const SEED: u64 = 20;
/// Number of decimal digits after which no digit remains.
const MAX_DIGITS: usize = 16;
/// Constants in the bounds κ + c and κ + √c.
const SLACK: f64 = 16.0;
/// Condition above which a mass matrix in doubles may be singular, and results may not be finite.
const SINGULAR: f64 = 0.1 / f64::EPSILON;
/// The share of all states at which bounds must hold, exceptions included.
const SHARE: f64 = 0.9;

/// The loss at one state, in units of rounding, and the expected loss.
struct Loss {
    sample: Sample,
    error: f64,
    magnification: f64,
    condition: f64,
}

impl Loss {
    /// Returns the error relative to the expected error of elimination by pivots or by rotations.
    fn beyond(&self, condition: fn(f64) -> f64) -> f64 {
        let is_singular = self.error.is_infinite() && self.condition > SINGULAR;
        if is_singular { 0.0 } else { self.error / (self.magnification + condition(self.condition)) }
    }

    fn digits(&self) -> usize {
        // A float becomes the nearest valid index.
        (self.error.max(1.0).log10().round() as usize).min(MAX_DIGITS)
    }
}

/// Returns the function of the condition in the bound of a way: c or √c.
fn conditioned(way: Way) -> fn(f64) -> f64 {
    match way {
        STRICT | SQUARES => f64::sqrt,
        _ => |condition| condition,
    }
}

/// Returns the scenes in which a way exceeds its bound at some states, because forces cancel
/// unnoticed.
fn exceptions(way: Way) -> &'static [&'static str] {
    match way {
        STANDARD | DENSE => &["relative_pendulum", "two_link_arm", "written_out_pendulum"],
        STRICT => &["two_link_arm"],
        SQUARES => &["spherical_pendulum", "two_link_arm", "written_out_pendulum"],
        _ => &[
            "branching_tree",
            "cart_pole",
            "double_pendulum",
            "relative_pendulum",
            "spherical_pendulum",
            "triple_pendulum",
            "two_link_arm",
            "written_out_pendulum",
        ],
    }
}

/// Draws positive parameters from 10⁻¹² to 10¹², angles of any size, tiny angles, and tiny
/// differences between them.
fn sample(model: &Model, random: &mut Random) -> Sample {
    let parameters = model.parameters.iter();
    let settings = parameters.map(|p| (p.name.clone(), random.decades(-12.0, 12.0).abs())).collect();
    let mut q: Vec<f64> = Vec::new();
    for _ in &model.coordinates {
        let before = q.last().copied().unwrap_or_default();
        q.push(match random.below(8) {
            0..3 => random.between(-PI, PI),
            3..5 => random.decades(-12.0, 0.0),
            5..7 => before + random.decades(-12.0, 0.0),
            _ => random.decades(0.0, 12.0),
        });
    }
    let v = q.iter().map(|_| if random.below(5) == 0 { 0.0 } else { random.decades(-6.0, 6.0) }).collect();
    Sample { settings, t: 0.0, q, v }
}

/// Returns the losses along each way at the same random states of a scene.
fn losses(scene: &Scene) -> [(Way, Vec<Loss>); WAYS.len()] {
    let reference = Reference::new(&scene.declaration);
    let mut random = Random::new(SEED);
    let samples = (0..cases(CASES)).map(|_| sample(&reference.model, &mut random));
    let judged = samples.filter_map(|sample| Some((reference.truth(&sample)?, sample)));
    let judged = judged.map(|(truth, sample)| {
        let magnification = reference.magnification(&sample, &truth).scaled;
        let [_, condition] = reference.conditions_at(&sample);
        (truth, Loss { sample, error: 0.0, magnification, condition })
    });
    let judged = judged.collect::<Vec<_>>();
    assert!(!judged.is_empty(), "{}: some states are regular", scene.name);
    WAYS.map(|way| {
        let mut subject = Subject::new(&scene.declaration, way);
        let losses = judged.iter().map(|(truth, expected)| Loss {
            sample: expected.sample.clone(),
            error: subject.errors(&expected.sample, truth).scaled / f64::EPSILON,
            ..*expected
        });
        (way, losses.collect())
    })
}

/// Prints the number of states that lost 0, 1, … digits, and the states with unexpectedly large
/// losses, shown by `--nocapture`.
#[test]
fn digits_are_lost_only_to_the_condition_of_the_mass_matrix() {
    let mut all = WAYS.map(|way| (way, Vec::new()));
    let mut failures = Vec::new();
    println!("\nrandom states by digits lost, 0 to {MAX_DIGITS}; worst error over κ + c and over κ + √c");
    for scene in scenes() {
        for ((way, losses), (_, all)) in losses(&scene).into_iter().zip(&mut all) {
            print_histogram(&scene.name, way, &losses);
            print_worst(way, &losses);
            if share(way, &losses) < 1.0 && !exceptions(way).contains(&scene.name.as_str()) {
                failures.push(format!("{} in {}", way.name, scene.name));
            }
            all.extend(losses);
        }
    }
    for (way, losses) in &all {
        print_histogram("all", *way, losses);
        let share = share(*way, losses);
        println!("{:20} {:9} keeps its bound at {share:.4} of the states", "", way.name);
        if share < SHARE {
            failures.push(format!("{} at many states", way.name));
        }
    }
    assert!(failures.is_empty(), "more digits are lost than must be: {failures:?}");
}

/// Returns the share of states at which a way keeps its bound.
fn share(way: Way, losses: &[Loss]) -> f64 {
    let kept = losses.iter().filter(|loss| loss.beyond(conditioned(way)) <= SLACK);
    kept.count() as f64 / losses.len() as f64
}

fn print_histogram(name: &str, way: Way, losses: &[Loss]) {
    let mut counts = [0; MAX_DIGITS + 1];
    losses.iter().for_each(|loss| counts[loss.digits()] += 1);
    let counts = counts.map(|count| format!("{count:4}")).concat();
    let worst =
        |condition: fn(f64) -> f64| losses.iter().map(|loss| loss.beyond(condition)).fold(0.0, f64::max);
    let [pivots, rotations] = [worst(|condition| condition), worst(f64::sqrt)];
    println!("{name:20} {:9} {counts}  {pivots:.0e} {rotations:.0e}", way.name);
}

/// Prints the state at which a bound is exceeded most.
fn print_worst(way: Way, losses: &[Loss]) {
    let condition = conditioned(way);
    let worst = losses.iter().max_by(|a, b| a.beyond(condition).total_cmp(&b.beyond(condition)));
    if let Some(loss) = worst.filter(|loss| loss.beyond(condition) > SLACK) {
        let Loss { sample: Sample { settings, q, v, .. }, error, magnification, condition } = loss;
        let settings =
            settings.iter().map(|(name, value)| format!("{name} = {value:e}, ")).collect::<String>();
        println!(
            "    error {error:.0e}, κ {magnification:.0e}, c {condition:.0e} at {settings}q = {q:?}, v = {v:?}"
        );
    }
}
