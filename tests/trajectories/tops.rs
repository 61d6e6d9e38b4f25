//! Tops in unit quaternions with known motions: Euler's free top, a tumbling one, and the heavy top
//! in steady precession.
//!
//! Sources: Landau, Lifshitz, *Mechanics*, §§ 35 and 37; Whittaker, *Analytical Dynamics*, § 69.

use core::array::from_fn;
use core::f64::consts::TAU;

use lagrange::event::{Action, Direction, integrate_with_events};
use lagrange::integrate::{Verner98, integrate};

use crate::elliptic::Elliptic;
use crate::quaternions::{Quaternion, cross, distance, dot, product, turn, turned};

lagrange::system! {
    /// A body with three different moments of inertia, supported at its centre of mass.
    #[derive(Clone, Debug)]
    struct Brick;

    param a = 0.3, b = 0.5, c = 0.7;
    gravity = (0, 0, 0);
    body brick { mass: 2; inertia: (a, b, c); }
    ball turn = ground to brick;
}

lagrange::system! {
    /// A bar along y with a stem along z from its middle, which is the origin.
    #[derive(Clone, Debug)]
    struct Handle;

    param bar = 0.3, stem = 0.1;
    gravity = (0, 0, 0);
    body handle {
        compound {
            solid_cylinder(0.02, 0.16), mass: bar, turned: (pi/2, 0, 0);
            solid_cylinder(0.01, 0.08), mass: stem, at: (0, 0, 0.04);
        }
    }
    free handle;
}

lagrange::system! {
    /// A symmetrical top on its tip.
    #[derive(Clone, Debug)]
    struct Spinning;

    param m = 1.25, l = 0.4, across = 0.05, along = 0.02, g = 9.81;
    gravity = (0, 0, -g);
    body top { mass: m; inertia: (across, across, along); centroid: (0, 0, l); }
    ball tip = ground to top;
}

/// Relative change of a body that a test must detect.
const CONTROL: f64 = 1.0 + 1e-6;
const AXIS: [f64; 3] = [1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0];

fn tight() -> Verner98<f64> {
    Verner98::tolerance(1e-13)
}

fn error(found: [f64; 3], known: [f64; 3]) -> f64 {
    found.iter().zip(known).fold(0.0, |largest, (found, known)| (found - known).abs().max(largest))
}

/// The angular velocity of a free body along its principal axes, whose second component is
/// initially zero: (37.10). The first and the third axis are exchanged if the angular momentum
/// circles the first.
struct FreeTop {
    inertia: [f64; 3],
    amplitudes: [f64; 3],
    rate: f64,
    /// Axes of cn, sn and dn.
    axes: [usize; 3],
    functions: Elliptic,
}

impl FreeTop {
    fn new(inertia: [f64; 3], [first, third]: [f64; 2]) -> FreeTop {
        let mut amplitudes = [first, 0.0, third];
        let difference = |i: usize, k: usize| (inertia[i] - inertia[k]).abs();
        let weight = |k: usize| inertia[k] * difference(k, 1) * amplitudes[k].powi(2);
        let axes = if weight(0) < weight(2) { [0, 1, 2] } else { [2, 1, 0] };
        let [c, s, d] = axes;
        let functions = Elliptic::new(weight(c) / weight(d), (weight(d) - weight(c)) / weight(d));
        let rate = (difference(d, s) * difference(d, c) / (inertia[c] * inertia[s])).sqrt() * amplitudes[d];
        amplitudes[s] =
            (inertia[c] * difference(d, c) / (inertia[s] * difference(d, s))).sqrt() * amplitudes[c];
        FreeTop { inertia, amplitudes, rate, axes, functions }
    }

    fn period(&self) -> f64 {
        4.0 * self.functions.quarter() / self.rate
    }

    fn angular_velocity(&self, t: f64) -> [f64; 3] {
        let [sn, cn, dn] = self.functions.functions(self.rate * t);
        let mut found = self.amplitudes;
        self.axes.iter().zip([cn, sn, dn]).for_each(|(axis, value)| found[*axis] *= value);
        found
    }

    /// Returns the angle of rotation about the angular momentum in one period: (37.17) by the
    /// trapezoidal rule. For periodic integrands it converges faster than any power.
    fn turn_in_a_period(&self) -> f64 {
        let points = 128;
        let rate = |index: i32| {
            let w = self.angular_velocity(f64::from(index) / f64::from(points) * self.period());
            let sum = |power: i32| (0..2).map(|k| self.inertia[k].powi(power) * w[k] * w[k]).sum::<f64>();
            sum(1) / sum(2)
        };
        let mean = (0..points).map(rate).sum::<f64>() / f64::from(points);
        mean * self.period() * size(self.momentum(0.0))
    }

    /// Returns the angular momentum in the axes of the body.
    fn momentum(&self, t: f64) -> [f64; 3] {
        let w = self.angular_velocity(t);
        from_fn(|k| self.inertia[k] * w[k])
    }
}

fn size(vector: [f64; 3]) -> f64 {
    dot(vector, vector).sqrt()
}

const PERIODS: u32 = 5;

/// Returns the largest errors of angular velocities, and of orientations after whole periods.
fn errors_of_free_top(brick: &Brick, start: [f64; 2]) -> [f64; 2] {
    let known = FreeTop::new([0.3, 0.5, 0.7], start);
    let first = turn(AXIS, 1.0);
    let momentum = turned(first, known.momentum(0.0));
    let about = momentum.map(|component| component / size(momentum));
    let ([w, x, y, z], [a, b, c]) = (first, known.angular_velocity(0.0));
    let (mut state, mut errors) = ([w, x, y, z, a, b, c], [0.0_f64; 2]);
    for period in 0..PERIODS {
        let [begin, end] = [period, period + 1].map(|count| f64::from(count) * known.period());
        let watch = |t: f64, [.., a, b, c]: &[f64; 7]| {
            errors[0] = errors[0].max(error([*a, *b, *c], known.angular_velocity(t)));
        };
        state = integrate(brick, begin, state, end, &tight(), watch).expect("a finite motion");
        let [found @ .., _, _, _] = state;
        let angle = f64::from(period + 1) * known.turn_in_a_period();
        errors[1] = errors[1].max(distance(found, product(turn(about, angle), first)));
    }
    errors
}

#[test]
fn a_free_top_turns_by_elliptic_functions() {
    for start in [[0.4, 1.5], [1.5, 0.3], [1.0, 0.7]] {
        let found = errors_of_free_top(&Brick::default(), start);
        println!("free top from {start:?}: {found:?}");
        assert!(found.iter().all(|error| *error < 1e-12), "{start:?}: {found:?}");
        let other = errors_of_free_top(&Brick { c: 0.7 * CONTROL, ..Brick::default() }, start);
        assert!(other.iter().all(|error| *error > 1e-7), "{start:?}: {other:?}");
    }
}

/// Returns the moments of [`Handle`] along y, z, x, from the smallest, and the position of its
/// centre of mass on the stem.
fn moments_of_handle() -> ([f64; 3], f64) {
    let (bar, stem) = (0.3, 0.1);
    let across = |mass: f64, r: f64, h: f64| mass * (3.0 * r * r + h * h) / 12.0;
    let along = |mass: f64, r: f64| mass * r * r / 2.0;
    let center = stem * 0.04 / (bar + stem);
    let offsets = bar * center * center + stem * (0.04 - center) * (0.04 - center);
    let [bar_across, stem_across] = [across(bar, 0.02, 0.16), across(stem, 0.01, 0.08)];
    let y = along(bar, 0.02) + stem_across + offsets;
    ([y, bar_across + along(stem, 0.01), bar_across + stem_across + offsets], center)
}

/// Returns the times of the first flips for a rotation about the stem with a little about x. Flips
/// are 2 K apart.
fn flips_of(handle: &Handle, [spin, aside]: [f64; 2], until: f64) -> Vec<f64> {
    let (_, center) = moments_of_handle();
    let w = [aside, 0.0, spin];
    // The centre of mass is at rest.
    let v = cross([0.0, 0.0, center], w);
    let state = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, v[0], v[1], v[2], w[0], w[1], w[2]];
    let watch = ([Direction::Crossing], |_: f64, state: &[f64; 13]| [state[12]]);
    let mut flips = Vec::new();
    integrate_with_events(handle, (0.0, state), until, &tight(), watch, |event| {
        flips.push(event.time);
        Action::Continue
    })
    .expect("a finite motion");
    flips
}

/// Returns the largest relative error of the times of flips.
fn error_of_flips(handle: &Handle) -> f64 {
    let ([small, middle, large], _) = moments_of_handle();
    let [spin, aside] = [6.0_f64, 0.02];
    let outer = large * (large - small) * aside * aside;
    let sum = middle * (middle - small) * spin * spin + outer;
    let rate = ((large - middle) * sum / (small * middle * large)).sqrt();
    let functions = Elliptic::new((sum - outer) / sum, outer / sum);
    let quarter = functions.quarter() / rate;
    let flips = flips_of(handle, [spin, aside], 12.0 * quarter);
    assert_eq!(flips.len(), 6, "{flips:?} of {quarter}");
    let errors = (0..6).map(|index| flips[index] / (quarter * (2 * index + 1) as f64) - 1.0);
    errors.fold(0.0, |largest, error| largest.max(error.abs()))
}

#[test]
fn a_handle_tumbles_with_the_period_of_elliptic_functions() {
    let found = error_of_flips(&Handle::default());
    println!("tumbling handle: {found:e}");
    assert!(found < 1e-9, "{found}");
    let other = error_of_flips(&Handle { bar: 0.3 * CONTROL, ..Handle::default() });
    assert!(other > 1e-8, "{other}");
}

/// Returns the largest errors of a steady precession over two of its turns, of angular velocities
/// relative to the spin and of orientations. Its rate ψ̇ satisfies A cos θ ψ̇² − C ω₃ ψ̇ + m g l =
/// 0, with the angle θ and the spin ω₃.
fn errors_of_precession(top: &Spinning, theta: f64, spin: f64, is_fast: bool) -> [f64; 2] {
    let (about_tip, along, weight) = (0.05 + 1.25 * 0.4 * 0.4, 0.02, 1.25 * 9.81 * 0.4);
    let (a, b) = (about_tip * theta.cos(), along * spin);
    let larger = 0.5 * (b + b.signum() * (b * b - 4.0 * a * weight).sqrt());
    let rate = if is_fast { larger / a } else { weight / larger };
    let own = spin - rate * theta.cos();
    let orientation = |t: f64| -> Quaternion {
        let [precessed, spun] = [rate, own].map(|rate| turn([0.0, 0.0, 1.0], rate * t));
        product(product(precessed, turn([1.0, 0.0, 0.0], theta)), spun)
    };
    let angular_velocity = |t: f64| {
        let (sin, cos) = (own * t).sin_cos();
        [rate * theta.sin() * sin, rate * theta.sin() * cos, spin]
    };
    let ([w, x, y, z], [p, q, r]) = (orientation(0.0), angular_velocity(0.0));
    let mut errors = [0.0_f64; 2];
    integrate(top, 0.0, [w, x, y, z, p, q, r], 2.0 * TAU / rate.abs(), &tight(), |t, [q @ .., a, b, c]| {
        errors[0] = errors[0].max(error([*a, *b, *c], angular_velocity(t)) / spin.abs());
        errors[1] = errors[1].max(distance(*q, orientation(t)));
    })
    .expect("a finite motion");
    errors
}

#[test]
fn a_top_on_a_ball_precesses_steadily_at_both_of_its_rates() {
    for (theta, spin) in [(0.4, 110.0), (1.2, 75.0), (2.0, 40.0)] {
        for is_fast in [false, true] {
            let what = format!("θ = {theta}, ω₃ = {spin}, fast: {is_fast}");
            let found = errors_of_precession(&Spinning::default(), theta, spin, is_fast);
            println!("{what}: {found:?}");
            assert!(found.iter().all(|error| *error < 1e-12), "{what}: {found:?}");
            let other = Spinning { along: 0.02 * CONTROL, ..Spinning::default() };
            let other = errors_of_precession(&other, theta, spin, is_fast);
            assert!(other.iter().all(|error| *error > 1e-9), "{what}: {other:?}");
        }
    }
}
