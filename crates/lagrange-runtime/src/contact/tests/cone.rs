//! Inequalities of the law of contacts with friction in a plane, on random bodies.

use super::systems::{CLOSED, FREE, OPEN, TestTerms, nothing, slope};
use crate::contact::choice::Choice;
use crate::contact::cone::Cone;
use crate::contact::law::ContactLaw;
use crate::contact::reaction_forces::Balance;
use crate::contact::{Friction, Heading, Mode, Pace, Terms, reactions, switch_values};

/// Number of contacts of a body, each with friction in its plane.
const CONTACTS: usize = 4;
const K: usize = 3 * CONTACTS;
/// Inertia of a body of mass 1 kg, in kg m².
const INERTIA: f64 = 0.3;

struct Random(u64);

impl Random {
    fn within(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn vector(&mut self) -> [f64; 3] {
        core::array::from_fn(|_| self.within(-1.0, 1.0))
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = inner(&a, &a).sqrt();
    a.map(|a| a / length)
}

fn inner<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Draws a body that touches walls, or the floor in the plane of its corners, and its velocities.
fn body(random: &mut Random, mu: f64, is_flat: bool) -> (TestTerms<6, K>, [f64; 6]) {
    let mut terms = nothing::<6, K>();
    let v: [f64; 6] = core::array::from_fn(|_| random.within(-1.0, 1.0));
    for k in (0..K).step_by(3) {
        let mut place = random.vector();
        let mut normal = unit(random.vector());
        if is_flat {
            (place[2], normal) = (-0.5, [0.0, 0.0, 1.0]);
        }
        let along = unit(cross(normal, random.vector()));
        for (row, axis) in [normal, along, cross(normal, along)].into_iter().enumerate() {
            let arm = cross(place, axis);
            terms.rows[k + row] = [axis[0], axis[1], axis[2], arm[0], arm[1], arm[2]];
        }
        for row in [k + 1, k + 2] {
            terms.slopes[row] = slope(row, k, [mu; 2]);
        }
    }
    terms.responses = terms.rows.map(|[x, y, z, a, b, c]| [x, y, z, a / INERTIA, b / INERTIA, c / INERTIA]);
    terms.rates = terms.rows.map(|row| inner(&row, &v));
    (terms, v)
}

fn kinetic_energy(v: &[f64; 6]) -> f64 {
    let [x, y, z, a, b, c] = v;
    0.5 * (x * x + y * y + z * z + INERTIA * (a * a + b * b + c * c))
}

fn modes(contact: Mode, friction: Friction) -> [Mode; K] {
    core::array::from_fn(|k| [contact, Mode::Friction(friction), Mode::Across(friction)][k % 3])
}

/// Computes the error of impulses or forces in the law at the rates that they cause, relative to
/// its terms.
fn violation(mu: f64, found: &[f64; K], rates: &[f64; K]) -> f64 {
    let mut worst = 0.0_f64;
    for k in (0..K).step_by(3) {
        let (load, limit) = (found[k], mu * found[k]);
        let (size, slip) = (found[k + 1].hypot(found[k + 2]), rates[k + 1].hypot(rates[k + 2]));
        let power = found[k + 1] * rates[k + 1] + found[k + 2] * rates[k + 2];
        let parts = [-load, -rates[k], (load * rates[k]).abs(), size - limit, (power + limit * slip).abs()];
        worst = parts.into_iter().fold(worst, f64::max);
    }
    worst
}

fn size(found: &[f64; K]) -> f64 {
    found.iter().fold(1.0, |size: f64, impulse| size.max(impulse.abs()))
}

/// A body that is wedged between four walls, or flat on a floor, has impulses within the cone,
/// which dissipate energy.
#[test]
fn impacts_in_space_obey_the_cone() {
    let is_touching = core::array::from_fn(|k| k % 3 == 0);
    let mut random = Random(7);
    let mut unsolved = 0;
    for case in 0..1000 {
        let mu = random.within(0.0, 1.2);
        let (terms, v) = body(&mut random, mu, case % 2 == 0);
        let Ok(collision) = terms.impact(&v, &modes(OPEN, Friction::Slips), &is_touching, &[0.0; K]) else {
            unsolved += 1;
            continue;
        };
        let rates = terms.rows.map(|row| inner(&row, &collision.velocities));
        let (worst, size) = (violation(mu, &collision.impulses, &rates), size(&collision.impulses));
        assert!(worst <= 1e-8 * size * size, "{worst:e} in case {case}: {:?}", collision.impulses);
        let lost = kinetic_energy(&v) - kinetic_energy(&collision.velocities);
        assert!((lost - collision.energy_loss).abs() < 1e-9 * size * size, "{lost} in case {case}");
        assert!(lost > -1e-12, "{lost} in case {case}");
    }
    // The search is bounded, and fails for one of a thousand wedges.
    assert!(unsolved <= 1, "{unsolved}");
}

/// Impulses that are found in the space of velocities obey the law as exactly as those from the
/// matrix of responses.
#[test]
fn both_ways_to_impulses_obey_the_law() {
    let choices: [Choice<f64>; K] =
        core::array::from_fn(|k| [Choice::Touch, Choice::Rest, Choice::Across][k % 3]);
    let mut random = Random(5);
    let mut unsolved = [0; 2];
    for case in 0..300 {
        let mu = random.within(0.0, 1.2);
        let (terms, _) = body(&mut random, mu, case % 2 == 0);
        let law = ContactLaw::new(&terms, terms.rates, 0.0);
        let entry = |k: usize, j: usize| inner(&terms.rows[k], &terms.responses[j]);
        let by_matrix = Cone::<_, 6, K, K>::new(&law, &choices, true, entry).best(&[0.0; K]);
        let by_velocities = Cone::<_, 6, K, 0>::new(&law, &choices, true, entry).best(&[0.0; K]);
        for (place, found) in [by_matrix, by_velocities].into_iter().enumerate() {
            let impulses = found.settled.reactions;
            let change = terms.change(&impulses);
            let after = core::array::from_fn(|k| terms.rates[k] + inner(&terms.rows[k], &change));
            let (worst, size) = (violation(mu, &impulses, &after), size(&impulses));
            assert!(!found.is_exact || worst <= 1e-8 * size * size, "{worst:e} in case {case}, {place}");
            unsolved[place] += usize::from(!found.is_exact);
        }
    }
    assert!(unsolved.iter().all(|count| *count <= 3), "{unsolved:?}");
}

/// Impacts with restitution do not create energy either.
#[test]
fn impacts_in_space_with_restitution_create_no_energy() {
    let is_touching = core::array::from_fn(|k| k % 3 == 0);
    let mut random = Random(11);
    for case in 0..100 {
        let (mu, e) = (random.within(0.0, 1.2), random.within(0.0, 1.0));
        let (terms, v) = body(&mut random, mu, case % 2 == 0);
        let restitutions = core::array::from_fn(|k| if k % 3 == 0 { e } else { 0.0 });
        let collision = terms.impact(&v, &modes(OPEN, Friction::Slips), &is_touching, &restitutions);
        let collision = collision.unwrap_or_else(|error| panic!("{error} in case {case}"));
        let lost = kinetic_energy(&v) - kinetic_energy(&collision.velocities);
        assert!(lost > -1e-10, "{lost} in case {case}");
    }
}

/// A body at rest on a floor is pulled in any direction: forces satisfy the cone, and accelerations
/// follow from the forces.
#[test]
fn simultaneous_starts_are_decided_together() {
    let choices = core::array::from_fn(|k| [Choice::Touch, Choice::Rest, Choice::Across][k % 3]);
    let mut random = Random(3);
    let mut unsolved = 0;
    for case in 0..500 {
        let mu = random.within(0.05, 0.7);
        let (mut terms, _) = body(&mut random, mu, true);
        terms.rates = [0.0; K];
        terms.free = core::array::from_fn(|_| random.within(-3.0, 3.0));
        terms.free[2] = -10.0;
        let balance = Balance::of_forces(&terms);
        let Some(settled) = balance.settle(&choices) else {
            unsolved += 1;
            continue;
        };
        let rates = core::array::from_fn(|k| balance.rate(k, &settled.reactions));
        let worst = violation(mu, &settled.reactions, &rates);
        let size = size(&settled.reactions);
        assert!(worst <= 1e-8 * size * size, "{worst:e} in case {case}");
    }
    assert_eq!(unsolved, 0);
}

/// Returns a block of 1 kg under a downward force of 10 and a horizontal force of (3, 4), with its
/// slip velocities.
fn pushed(mu: f64, slip: [f64; 2]) -> TestTerms<3, 3> {
    let unit = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    Terms {
        free: [3.0, 4.0, -10.0],
        rows: unit,
        responses: unit,
        rates: [0.0, slip[0], slip[1]],
        slopes: core::array::from_fn(|k| slope(k, 0, if k == 0 { [0.0; 2] } else { [mu; 2] })),
        ..nothing()
    }
}

#[test]
fn a_block_holds_half_of_its_weight_and_starts_the_way_it_is_pushed() {
    let choices = [Choice::Touch, Choice::Rest, Choice::Across];
    for (mu, wanted) in [(0.6, [10.0, -3.0, -4.0]), (0.25, [10.0, -1.5, -2.0])] {
        let terms = pushed(mu, [0.0; 2]);
        let settled = Balance::of_forces(&terms).settle(&choices).expect("forces");
        for (found, wanted) in settled.reactions.into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12, "{:?}", settled.reactions);
        }
    }
}

#[test]
fn friction_is_opposite_to_the_slip_velocity_and_ends_where_it_turns() {
    let towards = Friction::SlipsTowards(Heading::new([1.0, 0.0]), Pace::ZERO);
    let modes = |friction| [CLOSED, Mode::Friction(friction), Mode::Across(friction)];
    let terms = pushed(0.25, [0.6, 0.8]);
    for friction in [towards, Friction::SlipsForwards, Friction::Slips] {
        let [load, x, y] = reactions(&terms, &modes(friction));
        assert!((load - 10.0).abs() + (x + 1.5).abs() + (y + 2.0).abs() < 1e-12, "{load} {x} {y}");
    }
    // After passing zero it continues smoothly.
    let [_, x, y] = reactions(&pushed(0.25, [-0.6, -0.8]), &modes(towards));
    assert!((x + 1.5).abs() + (y + 2.0).abs() < 1e-12, "{x} {y}");
    for (degrees, is_over) in [(59.0_f64, false), (61.0, true), (-59.0, false), (-61.0, true)] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let values = switch_values(&pushed(0.25, [cos, sin]), &modes(towards));
        assert_eq!(values[1] < 0.0, is_over, "{degrees} degrees: {values:?}");
    }
    let [_, x, y] = reactions(&pushed(0.25, [0.0; 2]), &modes(Friction::GivesWay(Pace::ZERO)));
    assert!((x + 1.5).abs() + (y + 2.0).abs() < 1e-12, "{x} {y}");
    assert_eq!(FREE, Mode::Friction(Friction::default()));
}

#[test]
fn headings_keep_all_digits() {
    for angle in [0.0_f64, 0.3, 2.0, -1.0, 3.0] {
        let wanted = [angle.cos(), angle.sin()];
        let found: [f64; 2] = Heading::new(wanted).components();
        assert!((found[0] - wanted[0]).abs().max((found[1] - wanted[1]).abs()) < 4e-16, "{found:?}");
    }
    assert_eq!(Heading::new([1.0, -0.0]), Heading::new([1.0_f32, 0.0]));
}

/// Returns a box with these corners on a slope, with x downhill, that slides slowly.
fn sliding(steepness: f64, speed: f64) -> TestTerms<6, K> {
    let mut terms = nothing::<6, K>();
    for (corner, [x, y]) in [[0.2, 0.15], [0.2, -0.15], [-0.2, 0.15], [-0.2, -0.15]].into_iter().enumerate() {
        for (row, axis) in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].into_iter().enumerate() {
            let arm = cross([x, y, -0.1], axis);
            terms.rows[3 * corner + row] = [axis[0], axis[1], axis[2], arm[0], arm[1], arm[2]];
        }
        for row in [1, 2] {
            let row = 3 * corner + row;
            terms.slopes[row] = slope(row, 3 * corner, [0.5; 2]);
        }
    }
    terms.responses = terms.rows.map(|[x, y, z, a, b, c]| [x, y, z, 92.3 * a, 60.0 * b, 48.0 * c]);
    terms.free = [steepness, 0.0, -1.0, 0.0, 0.0, 0.0];
    terms.rates = terms.rows.map(|row| speed * row[0]);
    terms
}

/// Loads are not unique if some friction has a direction and some is about to have one. Their sum
/// and the motion are unique.
#[test]
fn a_start_beside_a_slide_presses_everywhere() {
    for excess in [1e-13, 1e-9, 1e-6, 1e-3, 0.1] {
        for slides in 0..16 {
            let terms = sliding(0.5 + excess, 1e-5);
            let modes = core::array::from_fn(|k| {
                let friction = match slides >> (k / 3) & 1 {
                    1 => Friction::SlipsTowards(Heading::new([1.0, 0.0]), Pace::ZERO),
                    _ => Friction::GivesWay(Pace::new(2e-5)),
                };
                [CLOSED, Mode::Friction(friction), Mode::Across(friction)][k % 3]
            });
            let found = reactions(&terms, &modes);
            let [x, others @ ..] = terms.acceleration(&found);
            assert!((x - excess).abs() < 1e-10, "{excess} {slides:04b}: {x}");
            assert!(others.iter().all(|other| other.abs() < 1e-10), "{excess} {slides:04b}: {others:?}");
            for k in (0..K).step_by(3) {
                assert!(found[k] > 0.15, "{excess} {slides:04b}: {found:?}");
                assert!((found[k + 1].hypot(found[k + 2]) - 0.5 * found[k]).abs() < 1e-10, "{found:?}");
            }
        }
    }
}
