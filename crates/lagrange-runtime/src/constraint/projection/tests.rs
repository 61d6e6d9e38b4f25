//! Convergence of corrections, quantities that they preserve, and rejected states.

use super::{admit, consistent_velocity, correct, project};
use crate::constraint::ConstrainedSystem;
use crate::constraint::doubles::{Bead, Mechanism, Parallelogram, Pendulum, Skate, System};
use crate::system::{StepFailure, Violated, Violation, split};

const PENDULUM: System<Pendulum, 2, 1> = System(Pendulum);

#[test]
fn corrections_converge_quadratically() {
    for offset in [1e-2, 1e-3, 1e-4] {
        let q = [0.6 * (1.0 + offset), -0.8 * (1.0 + offset)];
        let residuals = PENDULUM.position_residuals(0.0, &q);
        let change = PENDULUM.correction(0.0, &q, &[0.0; 2], &residuals);
        let left = PENDULUM.position_residuals(0.0, &[q[0] + change[0], q[1] + change[1]]);
        // |δ|² exactly, for a circle.
        let square = change[0] * change[0] + change[1] * change[1];
        assert!((left[0] / square - 1.0).abs() < 1e-6, "{left:?} {square}");
    }
}

#[test]
fn positions_and_velocities_end_on_the_constraints_from_near_and_far() {
    for factor in [1.0, 1.0 + 1e-12, 1.0 + 1e-6, 1.3, 0.1, 50.0, 1e4] {
        let (mut q, mut v) = ([0.6 * factor, -0.8 * factor], [3.0, 0.7]);
        project(&PENDULUM, 0.0, &mut q, &mut v).expect("a circle can be reached");
        assert!(PENDULUM.residual(0.0, &[q[0], q[1], v[0], v[1]]) < 1e-15, "{factor}: {q:?} {v:?}");
        // The nearest point is along the radius, and the nearest velocity lacks its radial
        // component.
        assert!((q[0] - 0.6).abs() < 2e-15 && (q[1] + 0.8).abs() < 2e-15, "{factor}: {q:?}");
        let along = 0.8 * 3.0 + 0.6 * 0.7;
        assert!((v[0] - 0.8 * along).abs() < 1e-14 && (v[1] - 0.6 * along).abs() < 1e-14, "{factor}: {v:?}");
    }
}

#[test]
fn the_light_moves_and_the_heavy_stays() {
    let skate = System::<_, 3, 1>(Skate);
    let q = [1.0, 2.0, 0.5];
    let found = consistent_velocity(&skate, 0.0, &q, &[3.0, 0.0, 1.0]).expect("a skate can glide");
    // Motion along the blade and rotation remain unchanged.
    let (sine, cosine) = 0.5_f64.sin_cos();
    assert!((found[0] * cosine + found[1] * sine - 3.0 * cosine).abs() < 1e-15);
    assert_eq!(found[2], 1.0);
    assert!((found[0] * sine - found[1] * cosine).abs() < 1e-15);
}

#[test]
fn moving_constraints_demand_velocities() {
    let bead = System::<_, 2, 1>(Bead { rate: 2.0 });
    let mut y = [3.0 * 0.8_f64.cos(), 3.0 * 0.8_f64.sin(), 0.0, 0.0];
    let refused = admit(&bead, 0.4, &mut y);
    let Err(StepFailure::Violated(Violation { constraint, residual, of })) = refused else {
        panic!("{refused:?}")
    };
    assert_eq!((constraint, of), ("wire", Violated::Velocities));
    assert!((residual - 6.0).abs() < 1e-14, "{residual}");
    let (q, v) = split::<System<Bead, 2, 1>>(&y);
    let v = consistent_velocity(&bead, 0.4, &q, &v).expect("the bead follows the wire");
    assert!((v[0] + 6.0 * 0.8_f64.sin()).abs() < 1e-14 && (v[1] - 6.0 * 0.8_f64.cos()).abs() < 1e-14);
    y = [q[0], q[1], v[0], v[1]];
    assert_eq!(admit(&bead, 0.4, &mut y), Ok(()));
}

#[test]
fn starts_are_mended_if_they_are_near_and_refused_with_the_constraint_if_not() {
    for (offset, is_near) in [(1e-15, true), (9e-7, true), (2e-6, false), (0.1, false)] {
        let start = [0.6, -0.8 + offset, 0.8, 0.6];
        let mut y = start;
        let admitted = admit(&PENDULUM, 0.0, &mut y);
        assert_eq!(admitted.is_ok(), is_near, "{offset}: {admitted:?}");
        if is_near {
            assert!(PENDULUM.residual(0.0, &y) < 1e-15, "{offset}: {y:?}");
        } else {
            assert_eq!(y, start);
            let [residual] = PENDULUM.position_residuals(0.0, &[start[0], start[1]]);
            let wanted = Violation { constraint: "rod", residual, of: Violated::Positions };
            assert_eq!(admitted, Err(StepFailure::Violated(wanted)));
        }
    }
}

#[test]
fn a_state_that_cannot_be_corrected_stays_what_it_was() {
    // At the centre of the circle no direction leads outwards; NaN and infinity lead nowhere.
    for (q, v) in [
        ([0.0, 0.0], [1.0, 0.0]),
        ([f64::NAN, 0.0], [1.0, 0.0]),
        ([0.6, f64::INFINITY], [1.0, 0.0]),
        ([0.6, -0.8], [f64::NAN, 0.0]),
        ([0.7, -0.8], [f64::INFINITY, 0.0]),
    ] {
        let bits = |q: [f64; 2], v: [f64; 2]| [q, v].map(|x| x.map(f64::to_bits));
        let (mut to, mut speed) = (q, v);
        let violation = project(&PENDULUM, 0.0, &mut to, &mut speed).expect_err("cannot be corrected");
        assert_eq!(violation.constraint, "rod");
        assert_eq!(bits(q, v), bits(to, speed));
        let mut y = [q[0], q[1], v[0], v[1]];
        assert!(correct(&PENDULUM, 0.0, &mut y).is_err() && admit(&PENDULUM, 0.0, &mut y).is_err());
        assert_eq!(bits(q, v), bits([y[0], y[1]], [y[2], y[3]]));
    }
}

/// c = atan x, with starts from which Newton's method diverges.
struct Bent;

impl Mechanism<1, 1> for Bent {
    type State = [f64; 2];

    const NAMES: &'static [&'static str] = &["bent"];

    fn masses(&self) -> [f64; 1] {
        [1.0]
    }

    fn positions(&self, _t: f64, [x]: &[f64; 1]) -> [f64; 1] {
        [x.atan()]
    }

    fn jacobian(&self, _t: f64, [x]: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0 / (1.0 + x * x)]]
    }

    fn drift(&self, _t: f64, [x]: &[f64; 1], [v]: &[f64; 1]) -> [f64; 1] {
        [-2.0 * x * v * v / (1.0 + x * x).powi(2)]
    }
}

#[test]
fn corrections_that_overshoot_are_shortened() {
    for start in [1.5, -3.0, 20.0] {
        let (mut q, mut v) = ([start], [0.0]);
        project(&System::<_, 1, 1>(Bent), 0.0, &mut q, &mut v).expect("shorter steps lead there");
        assert!(q[0].abs() < 1e-15, "{start}: {q:?}");
    }
}

/// One coordinate that must be in two places at once.
struct Torn;

impl Mechanism<1, 2> for Torn {
    type State = [f64; 2];

    const NAMES: &'static [&'static str] = &["here", "there"];

    fn masses(&self) -> [f64; 1] {
        [1.0]
    }

    fn positions(&self, _t: f64, [x]: &[f64; 1]) -> [f64; 2] {
        [*x, 2.0 * x - 6.0]
    }

    fn jacobian(&self, _t: f64, _q: &[f64; 1]) -> [[f64; 1]; 2] {
        [[1.0], [2.0]]
    }

    fn drift(&self, _t: f64, _q: &[f64; 1], _v: &[f64; 1]) -> [f64; 2] {
        [0.0; 2]
    }
}

#[test]
fn contradictory_constraints_are_reported_by_name() {
    let (mut q, mut v) = ([0.5], [0.0]);
    let violation = project(&System::<_, 1, 2>(Torn), 0.0, &mut q, &mut v).expect_err("torn");
    assert_eq!(violation, Violation { constraint: "there", residual: -5.0, of: Violated::Positions });
    assert_eq!(q, [0.5]);
}

#[test]
fn a_loop_with_a_crank_too_many_is_closed_at_every_angle() {
    let loops = System::<_, 6, 6>(Parallelogram);
    for degrees in (0..360).step_by(15) {
        // If all cranks are aligned, the constraints do not determine to first order how the loop
        // bends.
        let offset = if degrees % 180 == 0 { 1e-13 } else { 1e-7 };
        let mut y = Parallelogram::state(f64::from(degrees).to_radians(), 2.0);
        for (i, component) in y.iter_mut().enumerate() {
            *component += offset * (i as f64).sin();
        }
        admit(&loops, 0.0, &mut y).unwrap_or_else(|cause| panic!("{degrees}: {cause}"));
        let bound = if degrees % 180 == 0 { 1e-12 } else { 1e-14 };
        assert!(loops.residual(0.0, &y) < bound, "{degrees}: {}", loops.residual(0.0, &y));
    }
}

#[test]
fn vanishing_coordinates_are_scaled_by_the_others() {
    // The gap of 1e-9 is small relative to a coordinate of one, but not relative to one of a
    // thousandth.
    for (x, is_near) in [(1.0, true), (1e6, true), (1e-2, true), (1e-4, false), (0.0, false)] {
        let mut y = [x, 1e-9, 0.0, 0.0];
        let admitted = admit(&System::<_, 2, 1>(Ground), 0.0, &mut y);
        assert_eq!(admitted.is_ok(), is_near, "{x}: {admitted:?}");
    }
}

/// A point mass on the ground.
struct Ground;

impl Mechanism<2, 1> for Ground {
    type State = [f64; 4];

    const NAMES: &'static [&'static str] = &["ground"];

    fn masses(&self) -> [f64; 2] {
        [1.0, 1.0]
    }

    fn positions(&self, _t: f64, [_, y]: &[f64; 2]) -> [f64; 1] {
        [*y]
    }

    fn jacobian(&self, _t: f64, _q: &[f64; 2]) -> [[f64; 2]; 1] {
        [[0.0, 1.0]]
    }

    fn drift(&self, _t: f64, _q: &[f64; 2], _v: &[f64; 2]) -> [f64; 1] {
        [0.0]
    }
}

/// A point mass with different masses by direction, on an ellipse that may expand: x²/a² + y²/b² =
/// (1 + t)².
#[derive(Clone, Copy, Debug)]
struct Ellipse {
    masses: [f64; 2],
    axes: [f64; 2],
}

impl Mechanism<2, 1> for Ellipse {
    type State = [f64; 4];

    const NAMES: &'static [&'static str] = &["ellipse"];

    fn masses(&self) -> [f64; 2] {
        self.masses
    }

    fn positions(&self, t: f64, q: &[f64; 2]) -> [f64; 1] {
        let [x, y] = [q[0] / self.axes[0], q[1] / self.axes[1]];
        [x * x + y * y - (1.0 + t) * (1.0 + t)]
    }

    fn jacobian(&self, _t: f64, q: &[f64; 2]) -> [[f64; 2]; 1] {
        [[2.0 * q[0] / self.axes[0].powi(2), 2.0 * q[1] / self.axes[1].powi(2)]]
    }

    fn rates(&self, t: f64, _q: &[f64; 2]) -> [f64; 1] {
        [-2.0 * (1.0 + t)]
    }

    fn drift(&self, _t: f64, _q: &[f64; 2], v: &[f64; 2]) -> [f64; 1] {
        [2.0 * (v[0] / self.axes[0]).powi(2) + 2.0 * (v[1] / self.axes[1]).powi(2) - 2.0]
    }
}

/// Returns the nearest point of x²/a² + y²/b² = 1 from outside or inside, by bisection for the
/// multiplier. With `M (q₀ − q) = μ A` and masses as weights, `qᵢ = mᵢ aᵢ² pᵢ/(mᵢ aᵢ² + μ)` and
/// `Σ (qᵢ/aᵢ)² = 1`. The largest root is the global minimum (Eberly, *Distance from a point to an
/// ellipse*, 2013).
fn nearest_on_ellipse(masses: [f64; 2], axes: [f64; 2], p: [f64; 2]) -> [f64; 2] {
    let weights = [0, 1].map(|i| masses[i] * axes[i] * axes[i]);
    let at = |mu: f64| [0, 1].map(|i| weights[i] * p[i] / (weights[i] + mu));
    let sum = |mu: f64| at(mu).iter().zip(axes).map(|(q, a)| (q / a) * (q / a)).sum::<f64>();
    // The sum falls from infinity after the last pole.
    let (mut low, mut high) = (-weights[0].min(weights[1]), 1.0);
    while sum(high) > 1.0 {
        high *= 2.0;
    }
    for _ in 0..200 {
        let middle = (low + high) / 2.0;
        if sum(middle) > 1.0 { low = middle } else { high = middle }
    }
    at((low + high) / 2.0)
}

#[test]
fn the_nearest_point_of_an_ellipse_is_found_from_far_away() {
    let axes = [2.0, 0.5];
    for masses in [[1.0, 1.0], [1.0, 30.0], [30.0, 1.0]] {
        for breath in [0.0, 0.25] {
            let ellipse = System::<_, 2, 1>(Ellipse { masses, axes });
            let now = axes.map(|axis| axis * (1.0 + breath));
            for k in 0..40 {
                let (distance, angle) = ([0.7, 1.1, 2.0, 5.0][k % 4], 0.05 + 0.157 * k as f64);
                let p = [now[0] * distance * angle.cos(), now[1] * distance * angle.sin()];
                let (mut q, mut v) = (p, [0.4, -0.2]);
                project(&ellipse, breath, &mut q, &mut v).expect("an ellipse can be reached");
                let expected = nearest_on_ellipse(masses, now, p);
                let squares = [q, expected].map(|q: [f64; 2]| {
                    (0..2).map(|i| masses[i] * (q[i] - p[i]) * (q[i] - p[i])).sum::<f64>()
                });
                assert!(
                    (q[0] - expected[0]).abs().max((q[1] - expected[1]).abs()) < 1e-10,
                    "{masses:?}, {p:?}: {q:?} at {} for {expected:?} at {}",
                    squares[0],
                    squares[1]
                );
                assert!(ellipse.residual(breath, &[q[0], q[1], v[0], v[1]]) < 1e-12, "{p:?}: {q:?} {v:?}");
            }
        }
    }
}

/// A chain of three points on rods of length one, starting at the origin.
#[derive(Clone, Copy, Debug)]
struct Chain;

impl Mechanism<6, 3> for Chain {
    type State = [f64; 12];

    const NAMES: &'static [&'static str] = &["first", "second", "third"];

    fn masses(&self) -> [f64; 6] {
        [1.0, 1.0, 0.2, 0.2, 5.0, 5.0]
    }

    fn positions(&self, _t: f64, q: &[f64; 6]) -> [f64; 3] {
        let square = |x: f64, y: f64| x * x + y * y - 1.0;
        [square(q[0], q[1]), square(q[2] - q[0], q[3] - q[1]), square(q[4] - q[2], q[5] - q[3])]
    }

    fn jacobian(&self, _t: f64, q: &[f64; 6]) -> [[f64; 6]; 3] {
        let mut rows = [[0.0; 6]; 3];
        for k in 0..3 {
            for i in 0..2 {
                let along = 2.0 * (q[2 * k + i] - if k == 0 { 0.0 } else { q[2 * k + i - 2] });
                rows[k][2 * k + i] = along;
                if k > 0 {
                    rows[k][2 * k + i - 2] = -along;
                }
            }
        }
        rows
    }

    fn drift(&self, _t: f64, _q: &[f64; 6], v: &[f64; 6]) -> [f64; 3] {
        let square = |x: f64, y: f64| 2.0 * (x * x + y * y);
        [square(v[0], v[1]), square(v[2] - v[0], v[3] - v[1]), square(v[4] - v[2], v[5] - v[3])]
    }
}

/// Returns the squared distance of a chain with these angles from a point.
fn square_of_chain(angles: &[f64; 3], p: &[f64; 6]) -> f64 {
    let (mut end, mut square) = ([0.0; 2], 0.0);
    for (k, angle) in angles.iter().enumerate() {
        end = [end[0] + angle.cos(), end[1] + angle.sin()];
        square += Chain.masses()[2 * k] * ((end[0] - p[2 * k]).powi(2) + (end[1] - p[2 * k + 1]).powi(2));
    }
    square
}

#[test]
fn no_small_turn_of_a_chain_brings_it_nearer_than_where_it_was_projected() {
    let chain = System::<_, 6, 3>(Chain);
    for seed in 1..40_u32 {
        let number = |k: u32| f64::from((seed * 7919 + k * 104_729) % 1009) / 1009.0 - 0.5;
        let p: [f64; 6] = core::array::from_fn(|i| 5.0 * number(i as u32));
        let (mut q, mut v) = (p, [0.0; 6]);
        if project(&chain, 0.0, &mut q, &mut v).is_err() {
            assert_eq!(q, p);
            continue;
        }
        let angles: [f64; 3] = core::array::from_fn(|k| {
            let from = if k == 0 { [0.0; 2] } else { [q[2 * k - 2], q[2 * k - 1]] };
            (q[2 * k + 1] - from[1]).atan2(q[2 * k] - from[0])
        });
        let here = square_of_chain(&angles, &p);
        for k in 0..3 {
            let turned = |by: f64| {
                let mut turned = angles;
                turned[k] += by;
                square_of_chain(&turned, &p)
            };
            let slope = (turned(1e-4) - turned(-1e-4)) / 2e-4;
            assert!(slope.abs() < 1e-6 * here.max(1.0), "{seed}, {k}: {slope} at {here}");
            assert!(turned(1e-3) > here - 1e-9 && turned(-1e-3) > here - 1e-9, "{seed}, {k}");
        }
    }
}

#[test]
fn states_on_the_constraints_stay_to_the_bit() {
    let (mut q, mut v) = ([0.6, -0.8], [0.8, 0.6]);
    project(&PENDULUM, 0.0, &mut q, &mut v).expect("nothing to do");
    assert_eq!((q, v), ([0.6, -0.8], [0.8, 0.6]));
}
