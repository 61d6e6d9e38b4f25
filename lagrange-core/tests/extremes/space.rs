//! Bodies in space, one of which is 10⁹ times as heavy, as light, as long or as short as the
//! others.
//!
//! Errors are judged as in [`sweep`](crate::sweep), in units of rounding by `κ + c`. This is the
//! magnification of rounded inputs plus the condition of the scaled mass matrix. All levels keep
//! that bound everywhere. With three degrees of freedom `strict` keeps κ + √c, as in the plane.
//! With more it is never worse than `standard`, and mostly better where lengths differ: see
//! `tests/extremes/README.md`.

use std::env;
use std::f64::consts::PI;
use std::fmt;

use lagrange_core::model::Model;

use crate::cases::cases;
use crate::random::Random;
use crate::reference::{Reference, Truth};
use crate::scenes::{Scene, scenes_in};
use crate::trial::{FAST, STANDARD, STRICT, Sample, Subject, Way};

/// Scenes derived within seconds without optimisation. The others are judged if `LAGRANGE_EXTREMES`
/// is set.
const QUICK: [&str; 3] = ["ball_chain", "universal_and_hinge", "universal_chain"];
/// Ratios of one mass or length to the others.
const RATIOS: [f64; 2] = [1e-9, 1e9];
/// The number of degrees of freedom up to which `strict` keeps κ + √c.
const FEW: usize = 3;
const LEVELS: [Way; 3] = [FAST, STANDARD, STRICT];
const SEED: u64 = 40;
/// The constant in the bounds.
const SLACK: f64 = 4.0;
/// Condition above which a mass matrix in doubles may be singular, and results may not be finite.
const SINGULAR: f64 = 0.1 / f64::EPSILON;

/// The property in which one body differs from the others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Nothing,
    Mass,
    Length,
}

const KINDS: [Kind; 3] = [Kind::Nothing, Kind::Mass, Kind::Length];

/// Returns a state with angles of any size, unit quaternions, and all masses and lengths equal to
/// one.
fn state(model: &Model, random: &mut Random) -> Sample {
    let mut q = model.coordinates.iter().map(|_| random.between(-PI, PI)).collect::<Vec<_>>();
    for orientation in &model.orientations {
        let quaternion = &mut q[orientation.position..orientation.position + 4];
        let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
        quaternion.iter_mut().for_each(|x| *x /= length);
    }
    let v = model.speeds.iter().map(|_| random.between(-3.0, 3.0)).collect();
    let settings = sizes(model).map(|name| (name, 1.0)).collect();
    Sample { settings, t: 0.0, q, v }
}

/// Returns the names of masses and lengths.
fn sizes(model: &Model) -> impl Iterator<Item = String> {
    model.parameters.iter().map(|parameter| parameter.name.clone()).filter(|name| name != "g")
}

/// Returns states at which all bodies are alike, and states at which one mass or one length
/// differs.
fn samples(model: &Model) -> Vec<(Kind, Sample)> {
    let mut random = Random::new(SEED);
    let mut samples = Vec::new();
    for _ in 0..cases(1) {
        samples.push((Kind::Nothing, state(model, &mut random)));
        for (i, name) in sizes(model).enumerate() {
            for ratio in RATIOS {
                let mut sample = state(model, &mut random);
                sample.settings[i].1 = ratio;
                let kind = if name.starts_with('m') { Kind::Mass } else { Kind::Length };
                samples.push((kind, sample));
            }
        }
    }
    samples
}

/// A state with its exact values.
struct Judged {
    kind: Kind,
    sample: Sample,
    truth: Truth,
    magnification: f64,
    condition: f64,
}

impl Judged {
    fn new(reference: &Reference, (kind, sample): (Kind, Sample)) -> Judged {
        let truth = reference.truth(&sample).expect("a regular state");
        let magnification = reference.magnification(&sample, &truth).scaled;
        let [_, condition] = reference.conditions_at(&sample);
        Judged { kind, sample, truth, magnification, condition }
    }

    /// Returns the error that a level may make, in units of rounding.
    fn allowed(&self, way: Way) -> f64 {
        let is_rotated = way == STRICT && self.sample.v.len() <= FEW;
        let condition = if is_rotated { self.condition.sqrt() } else { self.condition };
        SLACK * (self.magnification + condition)
    }
}

/// The largest errors at a level: of an acceleration relative to itself, and in units of rounding
/// over κ + c and over κ + √c.
#[derive(Default)]
struct Worst {
    relative: f64,
    pivots: f64,
    rotations: f64,
}

impl fmt::Display for Worst {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:8.0e} {:8.0e} {:8.0e}", self.relative, self.pivots, self.rotations)
    }
}

/// Prints the largest errors of a scene at a level, and returns the states at which they are too
/// large.
fn judge(scene: &Scene, way: Way, judged: &[Judged]) -> Vec<String> {
    let mut subject = Subject::new(&scene.declaration, way);
    let (mut failures, mut worst) = (Vec::new(), KINDS.map(|_| Worst::default()));
    for state in judged {
        let errors = subject.errors(&state.sample, &state.truth);
        let error = errors.scaled / f64::EPSILON;
        let worst = &mut worst[state.kind as usize];
        worst.relative = worst.relative.max(errors.worst_component());
        if error.is_infinite() && state.condition > SINGULAR {
            continue;
        }
        worst.pivots = worst.pivots.max(error / (state.magnification + state.condition));
        worst.rotations = worst.rotations.max(error / (state.magnification + state.condition.sqrt()));
        if error > state.allowed(way) {
            failures.push(format!("{} {}: {error:e} at {:?}", scene.name, way.name, state.sample));
        }
    }
    let [alike, masses, lengths] = worst;
    println!("{:16} {:9} {alike}   {masses}   {lengths}", scene.name, way.name);
    failures
}

/// Prints the largest errors, shown by `--nocapture`.
#[test]
fn bodies_in_space_lose_no_more_digits_than_their_level_does() {
    println!(
        "\nworst relative error, error over κ + c and over κ + √c: bodies alike; a mass differs; a length differs"
    );
    let takes_all = env::var_os("LAGRANGE_EXTREMES").is_some();
    let scenes = scenes_in("space").into_iter();
    let scenes = scenes.filter(|scene| takes_all || QUICK.contains(&scene.name.as_str()));
    let mut failures = Vec::new();
    for scene in scenes {
        let reference = Reference::new(&scene.declaration);
        let judged = samples(&reference.model).into_iter().map(|sample| Judged::new(&reference, sample));
        let judged = judged.collect::<Vec<_>>();
        failures.extend(LEVELS.into_iter().flat_map(|way| judge(&scene, way, &judged)));
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
