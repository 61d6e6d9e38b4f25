//! NaN and undefined values in the input never lead to a plausible number in the result.

use std::cell::LazyCell;
use std::fs;
use std::path::Path;

use lagrange_core::symbol::Role;
use serde_json::Value;

use crate::digits::approximate;
use crate::reference::Reference;
use crate::scenes::scenes;
use crate::trial::{SQUARES, Sample, Subject, WAYS};

/// Threshold for the change of an acceleration, relative to that of an input. Below it the
/// acceleration is independent of the input.
const INDEPENDENT: f64 = 1e-60;

/// A number that stands for infinity in a limit.
const FAR: f64 = 1e100;
/// Threshold below which a number may be zero at infinity.
const NEAR_ZERO: f64 = 1e-30;

/// A system of `tests/oracle` at its first state.
struct Case {
    name: String,
    declaration: String,
    sample: Sample,
}

fn cases() -> Vec<Case> {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/oracle"));
    let entries = fs::read_dir(directory).expect("the directory of references");
    let mut paths = entries.map(|entry| entry.expect("a readable entry").path()).collect::<Vec<_>>();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "lag"));
    paths.sort();
    assert!(!paths.is_empty());
    paths.iter().map(|path| Case::read(path)).collect()
}

impl Case {
    fn read(path: &Path) -> Case {
        let text = |path: &Path| fs::read_to_string(path).expect("readable text");
        let values: Value = serde_json::from_str(&text(&path.with_extension("json"))).expect("valid JSON");
        let number = |value: &Value| value.as_str().expect("a number in quotes").parse().expect("a number");
        let numbers = |value: &Value| value.as_array().expect("a vector").iter().map(number).collect();
        let kinds = ["params", "inputs"].map(|kind| values[kind].as_object().expect("values by name"));
        let settings =
            kinds.into_iter().flatten().map(|(name, value)| (name.clone(), number(value))).collect();
        let state = &values["states"][0];
        let sample =
            Sample { settings, t: number(&state["t"]), q: numbers(&state["q"]), v: numbers(&state["v"]) };
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        Case { name, declaration: text(path), sample }
    }
}

/// Derives a declaration along every way.
fn subjects(declaration: &str) -> Vec<(&'static str, Subject)> {
    WAYS.map(|way| (way.name, Subject::new(declaration, way))).into()
}

/// Moving an input slightly shows which accelerations depend on it.
#[test]
fn an_acceleration_is_nan_if_an_input_is() {
    let mut failures = Vec::new();
    for Case { name, declaration, sample } in cases() {
        let reference = Reference::new(&declaration);
        let mut subjects = subjects(&declaration);
        let mut dependent = 0;
        for role in reference.roles() {
            let slopes = reference.slopes(&sample, role);
            dependent += slopes.iter().filter(|slope| **slope > INDEPENDENT).count();
            let mut undefined = sample.clone();
            undefined.set(&reference.model, role, f64::NAN);
            for (title, subject) in &mut subjects {
                let found = subject.accelerations(&undefined);
                let hidden =
                    found.iter().zip(&slopes).position(|(a, slope)| *slope > INDEPENDENT && !a.is_nan());
                failures.extend(
                    hidden.map(|i| format!("{name}, {title}, {role:?}: acceleration {i} of {found:?}")),
                );
            }
        }
        assert!(dependent > 0, "{name}: nothing depends on anything");
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// A finite acceleration must be the limit, such as 0 for g/l.
#[test]
fn an_acceleration_at_infinity_is_the_limit_or_not_finite() {
    let mut failures = Vec::new();
    let mut limits = 0;
    for case in cases() {
        let reference = Reference::new(&case.declaration);
        let mut subjects = subjects(&case.declaration);
        for role in reference.roles() {
            let slopes = reference.slopes(&case.sample, role);
            for infinity in [f64::INFINITY, f64::NEG_INFINITY] {
                let finite = case.limits(&reference, (role, infinity), &slopes, &mut subjects);
                limits += finite.len();
                let wrong = finite.into_iter().filter(|(_, found, limit)| !is_near(*found, *limit));
                failures.extend(wrong.map(|wrong| format!("{}: {wrong:?}", case.name)));
            }
        }
    }
    assert!(limits > 0, "some limits are finite");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

impl Case {
    /// Returns the finite accelerations at an infinite input on which they depend, and those
    /// nearby.
    fn limits(
        &self,
        reference: &Reference,
        (role, infinity): (Role, f64),
        slopes: &[f64],
        subjects: &mut [(&'static str, Subject)],
    ) -> Vec<(String, f64, f64)> {
        let with = |value: f64| {
            let mut sample = self.sample.clone();
            sample.set(&reference.model, role, value);
            sample
        };
        let truth = LazyCell::new(|| reference.truth(&with(FAR.copysign(infinity))));
        let limit = |i: usize| truth.as_ref().map_or(f64::NAN, |truth| approximate(&truth.accelerations[i]));
        let found = subjects.iter_mut().flat_map(|(title, subject)| {
            let accelerations = subject.accelerations(&with(infinity)).into_iter().enumerate();
            let finite = accelerations.filter(|(i, found)| slopes[*i] > INDEPENDENT && found.is_finite());
            let finite = finite.map(|(i, found)| (format!("{title}, {role:?}"), found, limit(i)));
            finite.collect::<Vec<_>>()
        });
        found.collect()
    }
}

fn is_near(found: f64, limit: f64) -> bool {
    (found - limit).abs() <= 1e-9 * limit.abs() + NEAR_ZERO
}

/// A state of a scene at which accelerations have no value.
struct Singularity {
    scene: &'static str,
    settings: &'static [(&'static str, f64)],
    q: &'static [f64],
    v: &'static [f64],
    /// The accelerations without a value.
    undefined: &'static [usize],
}

/// Singularities at which pivots vanish exactly.
const EXACT: [Singularity; 9] = [
    singularity("kepler", &[], &[0.0, 0.3], &[1.0, 1.0], &[0, 1]),
    singularity("spherical_pendulum", &[], &[0.0, 0.3], &[1.0, 1.0], &[1]),
    singularity("spherical_pendulum", &[("l", 0.0)], &[0.4, 0.3], &[1.0, 1.0], &[0]),
    singularity("spring_pendulum", &[], &[0.0, 0.3], &[1.0, 1.0], &[1]),
    singularity("double_pendulum", &[("m1", 0.0)], &[0.0, 0.0], &[1.0, -2.0], &[0, 1]),
    singularity("double_pendulum", &[("l1", 0.0)], &[0.3, 0.7], &[1.0, -2.0], &[0]),
    singularity("double_pendulum", &[("m1", 0.0), ("m2", 0.0)], &[0.3, 0.7], &[1.0, -2.0], &[0, 1]),
    singularity("cart_pole", &[("mc", 0.0)], &[0.0, 0.0], &[1.0, 2.0], &[0, 1]),
    singularity("rolling_ball", &[("R", 1.0)], &[0.4, 0.0], &[1.0, 2.0], &[0]),
];

/// Singularities at which pivots vanish only if angles are subtracted before sines are taken, since
/// sin² + cos² is rounded.
const PARALLEL: [Singularity; 3] = [
    singularity("double_pendulum", &[("m1", 0.0)], &[0.3, 0.3], &[1.0, -2.0], &[0, 1]),
    singularity("relative_pendulum", &[("m2", 0.0)], &[0.3, 0.4, 0.0], &[1.0, -2.0, 0.5], &[1, 2]),
    singularity("branching_tree", &[("m1", 0.0)], &[0.3, 0.3, 0.3], &[1.0, -2.0, 0.5], &[0, 1, 2]),
];

const fn singularity(
    scene: &'static str,
    settings: &'static [(&'static str, f64)],
    q: &'static [f64],
    v: &'static [f64],
    undefined: &'static [usize],
) -> Singularity {
    Singularity { scene, settings, q, v, undefined }
}

impl Singularity {
    /// Returns the ways that yield numbers.
    fn failures(&self, subjects: impl Fn(&str) -> Vec<(&'static str, Subject)>) -> Vec<String> {
        let scenes = scenes();
        let scene = scenes.iter().find(|scene| scene.name == self.scene).expect("a scene");
        let settings = self.settings.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
        let sample = Sample { settings, t: 0.0, q: self.q.to_vec(), v: self.v.to_vec() };
        let truth = Reference::new(&scene.declaration).truth(&sample);
        assert!(truth.is_none(), "{}: {sample:?} is regular", self.scene);
        let found = subjects(&scene.declaration)
            .into_iter()
            .map(|(title, mut subject)| (title, subject.accelerations(&sample)));
        let wrong = found.filter(|(_, found)| self.undefined.iter().any(|i| found[*i].is_finite()));
        wrong.map(|(title, found)| format!("{}, {title}: {found:?} at {sample:?}", self.scene)).collect()
    }
}

#[test]
fn accelerations_without_a_value_are_not_finite() {
    let failures = EXACT.iter().flat_map(|singularity| singularity.failures(subjects)).collect::<Vec<_>>();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn squares_see_that_links_are_parallel() {
    let squares = |text: &str| vec![(SQUARES.name, Subject::new(text, SQUARES))];
    let failures = PARALLEL.iter().flat_map(|singularity| singularity.failures(squares)).collect::<Vec<_>>();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
