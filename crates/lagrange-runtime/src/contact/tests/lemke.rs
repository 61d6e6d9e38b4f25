//! Inequalities of the law of contacts and friction, on random bodies.

use super::systems::{BACKWARDS, CLOSED, FORWARDS, FREE, OPEN, STICKS, Stick, TestTerms, nothing, slope};
use crate::contact::choice::Choice;
use crate::contact::reaction_forces::Balance;
use crate::contact::{ContactSystem, Mode, begin};
use crate::system::{Action, OdeSystem};

/// Number of contacts of a body; the friction of each follows its contact.
const CONTACTS: usize = 4;
const K: usize = 2 * CONTACTS;
/// Inertia of a body of mass 1 kg, in kg m².
const INERTIA: f64 = 0.3;

struct Random(u64);

impl Random {
    fn within(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Draws a plane body that touches four walls at random positions, and its velocities.
fn body(random: &mut Random) -> (TestTerms<3, K>, [f64; 3]) {
    let mut terms = nothing::<3, K>();
    let v: [f64; 3] = core::array::from_fn(|_| random.within(-1.0, 1.0));
    let mu = random.within(0.0, 3.0);
    for k in (0..K).step_by(2) {
        let (x, y) = (random.within(-1.0, 1.0), random.within(-1.0, 1.0));
        let (sin, cos) = random.within(-3.0, 3.0).sin_cos();
        terms.rows[k] = [-sin, cos, x * cos + y * sin];
        terms.rows[k + 1] = [cos, sin, x * sin - y * cos];
        terms.slopes[k + 1] = slope(k + 1, k, [mu; 2]);
    }
    terms.responses = terms.rows.map(|[x, y, angle]| [x, y, angle / INERTIA]);
    terms.rates = terms.rows.map(|row| inner(&row, &v));
    (terms, v)
}

fn inner(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn kinetic_energy(v: &[f64; 3]) -> f64 {
    0.5 * (v[0] * v[0] + v[1] * v[1] + INERTIA * v[2] * v[2])
}

/// Computes the error of impulses in the law at velocities after an impact without restitution,
/// relative to its terms.
fn violation(terms: &TestTerms<3, K>, impulses: &[f64; K], after: &[f64; 3]) -> f64 {
    let mut worst = 0.0_f64;
    for k in (0..K).step_by(2) {
        let (normal, friction, limit) =
            (impulses[k], impulses[k + 1], terms.slopes[k + 1].kinetic * impulses[k]);
        let (rate, slip) = (inner(&terms.rows[k], after), inner(&terms.rows[k + 1], after));
        let brakes = (friction * slip + limit * slip.abs()).abs();
        worst = [-normal, -rate, (normal * rate).abs(), friction.abs() - limit, brakes]
            .into_iter()
            .fold(worst, f64::max);
    }
    worst
}

/// A body wedged between four walls, with any friction, has impulses that satisfy the law and
/// create no energy.
#[test]
fn every_impact_has_impulses() {
    let modes: [Mode; K] = core::array::from_fn(|k| if k % 2 == 0 { OPEN } else { FREE });
    let is_touching = core::array::from_fn(|k| k % 2 == 0);
    let mut random = Random(7);
    for case in 0..500 {
        let (terms, v) = body(&mut random);
        let collision = terms.impact(&v, &modes, &is_touching, &[0.0; K]);
        let collision = collision.unwrap_or_else(|error| panic!("{error} in case {case}"));
        let worst = violation(&terms, &collision.impulses, &collision.velocities);
        let size = collision.impulses.iter().fold(1.0_f64, |size, impulse| size.max(impulse.abs()));
        assert!(worst <= 1e-9 * size * size, "{worst:e} in case {case}: {:?}", collision.impulses);
        let lost = kinetic_energy(&v) - kinetic_energy(&collision.velocities);
        assert!(
            (lost - collision.energy_loss).abs() < 1e-9 * size * size && lost > -1e-12,
            "{lost} in case {case}"
        );
    }
}

/// There are impulses with restitution as well, after which no contact approaches. They create no
/// energy.
#[test]
fn every_impact_with_restitution_has_impulses() {
    let modes: [Mode; K] = core::array::from_fn(|k| if k % 2 == 0 { OPEN } else { FREE });
    let is_touching = core::array::from_fn(|k| k % 2 == 0);
    let mut random = Random(11);
    for case in 0..40 {
        let (terms, v) = body(&mut random);
        let restitutions = core::array::from_fn(|k| if k % 2 == 0 { random.within(0.0, 1.0) } else { 0.0 });
        let collision = terms.impact(&v, &modes, &is_touching, &restitutions);
        let collision = collision.unwrap_or_else(|error| panic!("{error} in case {case}"));
        let lost = kinetic_energy(&v) - kinetic_energy(&collision.velocities);
        assert!(lost > -1e-12, "{lost} in case {case}");
        for k in (0..K).step_by(2) {
            let rate = inner(&terms.rows[k], &collision.velocities);
            assert!(rate > -1e-8 && collision.impulses[k] > -1e-9, "{rate} in case {case}");
        }
    }
}

/// Lemke's method alone finds impulses for each wedge.
#[test]
fn lemkes_method_ends_at_impulses() {
    let choices = core::array::from_fn(|k| if k % 2 == 0 { Choice::Touch } else { Choice::Rest });
    let mut random = Random(13);
    for case in 0..500 {
        let (terms, v) = body(&mut random);
        let balance = Balance::of_impulses(&terms, &terms.rates, &[0.0; K]);
        let settled = balance.complementary(&choices).unwrap_or_else(|| panic!("a ray in case {case}"));
        let mut after = v;
        for (response, impulse) in terms.responses.iter().zip(&settled.reactions) {
            after = core::array::from_fn(|i| after[i] + response[i] * impulse);
        }
        let size = settled.reactions.iter().fold(1.0_f64, |size, impulse| size.max(impulse.abs()));
        let worst = violation(&terms, &settled.reactions, &after);
        assert!(worst <= 1e-8 * size * size, "{worst:e} in case {case}");
    }
}

/// A rod is dragged over a floor that is so rough that no force fits its slip. It stops slipping at
/// once, by impulses that follow from G Λ = −(0, slip), and sticks.
#[test]
fn a_rod_that_is_dragged_against_strong_friction_jams() {
    let angle: f64 = 1.0;
    let mut jammed = 0;
    for slip in [-2.0, -0.01, 0.01, 2.0] {
        let stick = Stick { m: 1.0, length: 2.0, g: 9.81, e: 0.0, mu: 3.0, modes: [OPEN, FREE] };
        let y = [0.0, angle.sin(), angle, slip, 0.0, 0.0];
        if begin(&stick, 0.0, &y).is_ok() {
            continue;
        }
        let slips = if slip > 0.0 { FORWARDS } else { BACKWARDS };
        let answer = stick.in_modes([CLOSED, slips]).react(0, 1.0, 1.0, &y).expect("it jams");
        let Action::Replace(after) = answer.action else { panic!("{:?}", answer.action) };
        assert_eq!(answer.system.map(|system| system.modes), Some([CLOSED, STICKS]));
        // J = m L²/12; the end is at (−cos, −sin) from the centre.
        let (sin, cos) = angle.sin_cos();
        let g = [[1.0 + 3.0 * cos * cos, -3.0 * sin * cos], [-3.0 * sin * cos, 1.0 + 3.0 * sin * sin]];
        let determinant = g[0][0] * g[1][1] - g[0][1] * g[1][0];
        let (normal, friction) = (g[0][1] * slip / determinant, -g[0][0] * slip / determinant);
        assert!(normal > 0.0 && friction.abs() < 3.0 * normal);
        let wanted = [slip + friction, normal, 3.0 * (sin * friction - cos * normal)];
        for (found, wanted) in after[3..].iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-13 * slip.abs(), "{found} for {wanted}");
        }
        let lost =
            stick.kinetic_energy([slip, 0.0, 0.0]) - stick.kinetic_energy([after[3], after[4], after[5]]);
        assert!(lost > 0.0);
        jammed += 1;
    }
    assert_eq!(jammed, 2, "one way, fast and slowly");
}

/// Returns the example of the documentation: a block of mass 2 on a floor, with friction of a
/// quarter of the normal force.
fn block(free: [f64; 2], rates: [f64; 2]) -> TestTerms<2, 2> {
    let mut terms = nothing::<2, 2>();
    terms.free = free;
    terms.rows = [[0.0, 1.0], [1.0, 0.0]];
    terms.responses = [[0.0, 0.5], [0.5, 0.0]];
    terms.rates = rates;
    terms.slopes[1] = slope(1, 0, [0.25; 2]);
    terms
}

#[track_caller]
fn assert_near(found: [f64; 2], expected: [f64; 2]) {
    let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13);
    assert!(is_near, "{found:?}, not {expected:?}");
}

#[test]
fn a_block_that_is_pushed_slips_beyond_a_quarter_of_its_weight() {
    for (push, friction) in [(6.0, -5.0), (4.0, -4.0)] {
        let terms = block([push / 2.0, -10.0], [0.0; 2]);
        let settled = Balance::of_forces(&terms).settle(&[Choice::Touch, Choice::Rest]).expect("forces");
        assert_near(settled.reactions, [20.0, friction]);
        assert_near(terms.acceleration(&settled.reactions), [(push + friction) / 2.0, 0.0]);
    }
}

#[test]
fn a_block_that_falls_while_it_slides_loses_a_quarter_of_its_impulse_by_friction() {
    let terms = block([0.0; 2], [-4.0, 3.0]);
    let balance = Balance::of_impulses(&terms, &terms.rates, &[0.5, 0.0]);
    let settled = balance.settle(&[Choice::Touch, Choice::Rest]).expect("impulses");
    assert_near(settled.reactions, [12.0, -3.0]);
    assert_near(terms.acceleration(&settled.reactions), [-1.5, 6.0]);
}
