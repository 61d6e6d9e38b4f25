//! A body on a ball joint whose axis constraints keep level: a physical pendulum.

use super::{
    ANGULAR_VELOCITY, Quaternion, Vector, conjugate, cross, distance, dot, length, product, rates, rotation,
    times, to_unit, turn, turned,
};
use crate::constraint::{
    ConstrainedSystem, Unprojected, admit, consistent_velocity, correct, project, redundant_correction,
    redundant_motion, restore, weighed,
};
use crate::integrate::{RungeKutta4, Verner98};
use crate::run::integrate;
use crate::simulate::Simulate;
use crate::system::{
    EnergyFunction, MechanicalSystem, OdeSystem, StateVector, StepFailure, Unnamed, Violated, join, split,
};

/// Principal moments of inertia about the joint.
const INERTIA: Vector = [1.5, 1.0, 0.8];
/// The weight times the distance of the centre of mass, which is below the joint in its rest
/// position.
const WEIGHT: f64 = 9.81;
const AXIS: Vector = [1.0, 0.0, 0.0];
/// The directions in the world to which the axis is held perpendicular.
const ACROSS: [Vector; 2] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// (R e₁)·n = 0 for two directions n, so that the body turns about its first axis only.
#[derive(Clone, Copy, Debug)]
struct Hinged;

impl Hinged {
    const MASS: [[f64; 3]; 3] = [[INERTIA[0], 0.0, 0.0], [0.0, INERTIA[1], 0.0], [0.0, 0.0, INERTIA[2]]];

    /// Returns e₁ × m with m = Rᵀ n, since d/dt (R e₁)·n = (ω × e₁)·m = ω·(e₁ × m).
    fn rows(q: &Quaternion) -> [Vector; 2] {
        ACROSS.map(|n| cross(AXIS, turned(conjugate(*q), n)))
    }

    /// Returns c̈ without the acceleration terms: ω·(e₁ × (m × ω)).
    fn drift(q: &Quaternion, w: &Vector) -> [f64; 2] {
        ACROSS.map(|n| dot(*w, cross(AXIS, cross(turned(conjugate(*q), n), *w))))
    }

    fn torque(q: &Quaternion, w: &Vector) -> Vector {
        let down = turned(conjugate(*q), [0.0, 0.0, -WEIGHT]);
        let (weight, gyroscopic) = (cross([0.0, 0.0, -1.0], down), cross(times(INERTIA, *w), *w));
        core::array::from_fn(|i| weight[i] + gyroscopic[i])
    }
}

impl OdeSystem for Hinged {
    type Scalar = f64;
    type State = [f64; 7];

    fn rhs(&self, t: f64, y: &[f64; 7]) -> [f64; 7] {
        let (q, w) = split::<Self>(y);
        join::<Self>(&self.position_rates(t, &q, &w), &self.acceleration(t, &q, &w))
    }

    const IS_CONSTRAINED: bool = true;

    fn correct(&self, t: f64, y: &mut [f64; 7]) -> Result<(), StepFailure<f64>> {
        correct(self, t, y)
    }

    fn admit(&self, t: f64, y: &mut [f64; 7]) -> Result<(), StepFailure<f64>> {
        admit(self, t, y)
    }

    fn restore(&self, t: f64, y: &mut [f64; 7]) -> Result<(), StepFailure<f64>> {
        restore(self, t, y)
    }
}

impl MechanicalSystem for Hinged {
    type Coordinates = Quaternion;
    type Velocities = Vector;
    type Columns<C> = Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &["q_0", "q_1", "q_2", "q_3"];
    const VELOCITIES: &'static [&'static str] = ANGULAR_VELOCITY;

    fn acceleration(&self, _t: f64, q: &Quaternion, w: &Vector) -> Vector {
        redundant_motion(&Self::MASS, &Self::torque(q, w), &Self::rows(q), &Self::drift(q, w)).acceleration
    }

    fn position_rates(&self, _t: f64, q: &Quaternion, w: &Vector) -> Quaternion {
        rates(*q, *w)
    }

    fn normalise(q: &mut Quaternion) {
        to_unit(q);
    }

    fn displacement(&self, _t: f64, from: &Quaternion, to: &Quaternion) -> Vector {
        rotation(*from, *to)
    }
}

impl EnergyFunction for Hinged {
    fn energy(&self, _t: f64, q: &Quaternion, w: &Vector) -> f64 {
        0.5 * dot(times(INERTIA, *w), *w) + WEIGHT * turned(*q, [0.0, 0.0, -1.0])[2]
    }
}

impl ConstrainedSystem for Hinged {
    type Multipliers = [f64; 2];

    const CONSTRAINTS: &'static [&'static str] = &["level", "straight"];

    fn multipliers(&self, _t: f64, q: &Quaternion, w: &Vector) -> [f64; 2] {
        redundant_motion(&Self::MASS, &Self::torque(q, w), &Self::rows(q), &Self::drift(q, w)).multipliers
    }

    fn position_residuals(&self, _t: f64, q: &Quaternion) -> [f64; 2] {
        ACROSS.map(|n| dot(turned(*q, AXIS), n))
    }

    fn velocity_residuals(&self, _t: f64, q: &Quaternion, w: &Vector) -> [f64; 2] {
        Self::rows(q).map(|row| dot(row, *w))
    }

    fn residual_scales(&self, _t: f64, q: &Quaternion, by: &Vector) -> [f64; 2] {
        weighed(&Self::rows(q), by)
    }

    fn correction(&self, _t: f64, q: &Quaternion, _w: &Vector, residuals: &[f64; 2]) -> Vector {
        redundant_correction(&Self::MASS, &Self::rows(q), residuals)
    }

    fn mass_times(&self, _t: f64, _q: &Quaternion, _w: &Vector, change: &Vector) -> Vector {
        times(INERTIA, *change)
    }
}

/// Returns the residual of unit length and of the constraints.
fn residual(y: &[f64; 7]) -> f64 {
    let (q, w) = split::<Hinged>(y);
    let residuals = [Hinged.position_residuals(0.0, &q), Hinged.velocity_residuals(0.0, &q, &w)];
    residuals.as_flattened().iter().fold((length(&q) - 1.0).abs(), |most, residual| most.max(residual.abs()))
}

/// The hinged pendulum by its angle: I₁ θ̈ = −m g s sin θ.
struct ByAngle;

impl OdeSystem for ByAngle {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [angle, rate]: &[f64; 2]) -> [f64; 2] {
        [*rate, -WEIGHT / INERTIA[0] * angle.sin()]
    }
}

#[test]
fn the_body_swings_as_its_angle_does() {
    let [q_0, q_1, q_2, q_3] = turn(2.5, AXIS);
    let start = [q_0, q_1, q_2, q_3, 0.3, 0.0, 0.0];
    for end in [10.0, -10.0] {
        let pair = Verner98::tolerance(1e-13);
        let [angle, rate] = integrate(&ByAngle, 0.0, [2.5, 0.3], end, &pair, |_, _| {}).expect("swings");
        let adaptive = Hinged.simulate(start).until(end).tolerance(1e-12).every(0.013).energy().run();
        let fixed = Hinged.simulate(start).until(end).method(RungeKutta4 { step: 1e-3 }).energy().run();
        for trajectory in [adaptive.expect("runs"), fixed.expect("runs")] {
            let (q, w) = split::<Hinged>(&trajectory.last());
            let missed = length(&rotation(q, turn(angle, AXIS))) + distance(&w, &[rate, 0.0, 0.0]);
            assert!(missed < 1e-8, "{} {missed:e}", trajectory.method());
            assert!(trajectory.states().all(|y| residual(&y) < 1e-15));
            let energies = trajectory.column("energy").expect("asked for");
            assert!(energies.iter().all(|energy| (energy - energies[0]).abs() < 1e-8));
        }
    }
}

#[test]
fn without_projection_what_accelerations_keep_is_all_that_holds_the_body() {
    let [q_0, q_1, q_2, q_3] = turn(2.5, AXIS);
    let start = [q_0, q_1, q_2, q_3, 0.3, 0.0, 0.0];
    let loose = Unprojected(Hinged);
    let trajectory = loose.simulate(start).until(10.0).method(RungeKutta4 { step: 0.02 }).dense().run();
    let trajectory = trajectory.expect("runs");
    let error = |y: &[f64; 7]| (length(&y[..4]) - 1.0).abs();
    let largest = trajectory.states().map(|y| error(&y)).fold(0.0, f64::max);
    assert!((1e-12..1e-3).contains(&largest), "{largest:e}");
    assert_eq!(trajectory.names()[4..], ["w_x", "w_y", "w_z"]);
}

#[test]
fn projection_from_afar_ends_on_the_constraints_at_unit_length() {
    let starts = [[1.0, 0.2, 0.3, -0.4], [3.0, -1.0, 0.5, 0.7], [0.2, 0.9, 0.3, 0.3], [1.0, 0.0, 1e-9, 0.0]];
    for start in starts {
        let (mut q, mut w) = (start, [1.0, 2.0, 3.0]);
        project(&Hinged, 0.0, &mut q, &mut w).expect("an axis can be turned to any direction");
        assert!(residual(&join::<Hinged>(&q, &w)) < 1e-15, "{q:?} {w:?}");
        let mut from = start;
        to_unit(&mut from);
        let way = rotation(q, from);
        assert!(length(&way) > 1e-10);
        // What is left about the free axis would lead nearer; the free part of the angular velocity
        // stays.
        assert!(way[0].abs() < 1e-13, "{way:?}");
        assert!((w[0] - 1.0).abs() < 1e-14 && w[1].abs() + w[2].abs() < 1e-14, "{w:?}");
        // No orientation that the hinge admits is nearer.
        for angle in [-2.0, -0.1, -1e-3, 1e-3, 0.1, 2.0] {
            let other = rotation(product(q, turn(angle, AXIS)), from);
            assert!(length(&other) > length(&way), "{start:?} {angle}");
        }
    }
}

#[test]
fn starts_nearly_on_the_constraints_are_admitted_and_others_refused() {
    let good = [1.0, 1e-9, 1e-9, 0.0, 0.3, 1e-8, 0.0];
    let mut admitted = good;
    admit(&Hinged, 0.0, &mut admitted).expect("nearly satisfies all");
    assert!(residual(&admitted) < 1e-15 && distance(&admitted, &good) < 1e-7);
    let mut askew = [1.0, 0.0, 0.01, 0.0, 0.3, 0.0, 0.0];
    let refused = admit(&Hinged, 0.0, &mut askew);
    let Err(StepFailure::Violated(violation)) = refused else { panic!("{refused:?}") };
    assert_eq!((violation.constraint, violation.of), ("straight", Violated::Positions));
    let found = consistent_velocity(&Hinged, 0.0, &[1.0, 0.0, 0.0, 0.0], &[1.0, 2.0, 3.0]);
    assert!(found.is_ok_and(|found| distance(&found, &[1.0, 0.0, 0.0]) < 1e-15), "{found:?}");
    let mut none = [0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0];
    for refused in [admit(&Hinged, 0.0, &mut none), correct(&Hinged, 0.0, &mut none)] {
        assert!(matches!(refused, Err(StepFailure::Stuck(_))), "{refused:?}");
    }
}

#[test]
fn sizes_of_quaternions_are_those_of_angles() {
    for angle in [0.0, 0.7, 2.0, 3.0] {
        let q = turn(angle, AXIS);
        let reach = crate::system::reach(&Hinged, 0.0, &q, &[1e-3; 4]);
        // No component of the rotation to q + δ is larger where each |δᵢ| is at most 10⁻³.
        for signs in 0..16 {
            let to = core::array::from_fn(|i| q[i] + if signs >> i & 1 == 0 { 1e-3 } else { -1e-3 });
            let way = rotation(q, to);
            assert!(way.iter().zip(&reach).all(|(way, reach)| way.abs() <= reach * (1.0 + 1e-12)));
        }
        assert!(reach.as_ref().iter().all(|reach| *reach <= 4.0 * 1e-3), "{reach:?}");
    }
    assert_eq!(Quaternion::ZERO.as_ref().len(), Hinged::COORDINATES.len());
}
