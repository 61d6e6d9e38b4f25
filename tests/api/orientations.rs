//! Emitted types with unit quaternions: names, motions, derivatives, constraints, contacts, inputs.

use lagrange::integrate::{RungeKutta4, Verner98};
use lagrange::system::{MechanicalSystem, join, split};
use lagrange::{Scalar, Simulate};

lagrange::system! {
    /// A satellite with a torque about its z-axis.
    #[derive(Clone, Debug)]
    struct Satellite<S>;

    param m = 3.0, i1 = 1.0, i2 = 2.0, i3 = 2.5;
    input moment;
    body hull { mass: m; inertia: (i1, i2, i3); }
    free hull;
    force hull_wz = moment;
    output momentum = angular_momentum(hull, hull);
    output spin = angular_velocity(hull);
    emit { jacobian, tangent_jacobian, momentum_rates }
}

lagrange::system! {
    /// A cart on a spring, with a pendulum on a ball joint.
    #[derive(Clone, Debug)]
    struct Crane;

    param k = 20.0;
    gravity = (0, 0, -9.81);
    body cart { mass: 2; inertia: (0.1, 0.1, 0.1); }
    prismatic s = ground to cart { axis: (1, 0, 0); }
    potential = spring_energy(k, s);
    body load { mass: 1; centroid: (0.02, 0, -0.5); inertia: (0.1, 0.105, 0.01, 0.002, 0, 0); }
    ball hook = cart to load { at: (0, 0, -0.1); damping: 0.05; }
    output below = load.center;
    emit { jacobian, tangent_jacobian }
    reduce Parked { freeze s = 0.1; }
}

lagrange::system! {
    /// A brick on a floor, which one of its corners touches.
    #[derive(Clone, Debug)]
    struct Brick;

    param e = 0.5;
    gravity = (0, 0, -9.81);
    body brick { mass: 1; inertia: (0.01, 0.02, 0.025); }
    free brick;
    let corner = brick.point(0.1, 0.05, -0.05);
    event floor = corner.z, falling => impact(e);
    event fast = brick_wz - 3, rising => { brick_wz = 0; }
    force brick_wz = 0.1;
}

lagrange::system! {
    /// A free rod whose ends are on a wall and a rail: x = 0 at one, z = 0 at the other.
    #[derive(Clone, Debug)]
    struct Ladder;

    gravity = (0, 0, -9.81);
    body rod { mass: 1; inertia: (1/12, 1/12, 0.001); }
    free rod;
    let top = rod.point(0, 0, 0.5);
    let foot = rod.point(0, 0, -0.5);
    constraint wall = top.x;
    constraint rail = foot.z;
}

/// A rotation by about 74 degrees about an oblique axis.
const TURNED: [f64; 4] = [0.8, 0.36, -0.288, 0.384];

fn satellite_start() -> SatelliteState<f64> {
    let [hull_qw, hull_qx, hull_qy, hull_qz] = TURNED;
    SatelliteState {
        hull_x: 1.0,
        hull_y: 2.0,
        hull_z: 3.0,
        hull_qw,
        hull_qx,
        hull_qy,
        hull_qz,
        hull_vx: 0.1,
        hull_vy: -0.2,
        hull_vz: 0.3,
        hull_wx: 0.2,
        hull_wy: 1.5,
        hull_wz: -0.4,
    }
}

fn length(q: &[f64]) -> f64 {
    q.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn crane_state() -> [f64; 9] {
    let [w, x, y, z] = TURNED;
    [0.05, w, x, y, z, 0.3, -0.7, 0.9, 1.1]
}

#[test]
fn positions_come_before_velocities_in_the_order_of_declaration() {
    assert_eq!(Crane::COORDINATES, ["s", "hook_qw", "hook_qx", "hook_qy", "hook_qz"]);
    assert_eq!(Crane::VELOCITIES, ["s_dot", "hook_wx", "hook_wy", "hook_wz"]);
    let velocities = ["hull_vx", "hull_vy", "hull_vz", "hull_wx", "hull_wy", "hull_wz"];
    assert_eq!(Satellite::<f64>::VELOCITIES, velocities);
    let state = satellite_start();
    assert_eq!(state.coordinates()[3..], TURNED);
    assert_eq!(state.velocities(), [0.1, -0.2, 0.3, 0.2, 1.5, -0.4]);
    let trajectory = Satellite::<f64>::default().simulate(state).until(1.0).every(0.5).run().unwrap();
    let mut csv = Vec::new();
    trajectory.write_csv(&mut csv).unwrap();
    let head = "t,hull_x,hull_y,hull_z,hull_qw,hull_qx,hull_qy,hull_qz,hull_vx,hull_vy,hull_vz,hull_wx,hull_wy,hull_wz";
    assert_eq!(String::from_utf8(csv).unwrap().lines().next(), Some(head));
    assert_eq!(trajectory.hull_x(), [1.0, 1.05, 1.1]);
}

#[test]
fn quaternions_keep_their_length_and_bodies_their_momentum() {
    let satellite = Satellite::<f64>::default();
    let before = satellite.momentum(0.0, &satellite_start().coordinates(), &satellite_start().velocities());
    let run =
        satellite.simulate(satellite_start()).until(50.0).every(0.37).tolerance(1e-12).record("momentum");
    let trajectory = run.run().unwrap();
    assert!(trajectory.states().all(|y| (length(&y[3..7]) - 1.0).abs() < 1e-15));
    for (axis, before) in ["momentum.x", "momentum.y", "momentum.z"].iter().zip(before) {
        let column = trajectory.column(axis).unwrap();
        assert!(column.iter().all(|value| (value - before).abs() < 1e-10), "{axis}: {before}, {column:?}");
    }
}

/// The initial quaternion is normalised, and one without direction is refused.
#[test]
fn starts_are_brought_to_length_one() {
    let satellite = Satellite::<f64>::default();
    let mut start: [f64; 13] = satellite_start().into();
    start[3..7].iter_mut().for_each(|entry| *entry *= 7.0);
    let scaled = satellite.simulate(start).until(1.0).ends_only().run().unwrap().last();
    let unit = satellite.simulate(satellite_start()).until(1.0).ends_only().run().unwrap().last();
    assert!(scaled.iter().zip(unit).all(|(a, b)| (a - b).abs() < 1e-12));
    start[3..7].fill(0.0);
    let error = satellite.simulate(start).until(1.0).run().unwrap_err().to_string();
    assert!(error.contains("quaternion"), "{error}");
}

/// Returns the quotient of central differences.
fn slope<const N: usize>(f: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    const STEP: f64 = 1e-5;
    let (ahead, behind) = (f(STEP), f(-STEP));
    std::array::from_fn(|i| (ahead[i] - behind[i]) / (2.0 * STEP))
}

#[track_caller]
fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= tolerance);
    assert!(near, "{found:?}, not {expected:?}");
}

#[test]
fn the_jacobian_is_that_of_differences() {
    let (crane, y) = (Crane::default(), crane_state());
    let jacobian = crane.jacobian(0.0, &y);
    for column in 0..9 {
        let by_entry = slope(|step| {
            let mut moved = y;
            moved[column] += step;
            crane.rhs(0.0, &moved)
        });
        assert_near(&jacobian.map(|row| row[column]), &by_entry, 2e-7);
    }
}

/// Positions are displaced to q + N(q) δ and normalised.
#[test]
fn the_tangent_jacobian_is_that_of_displacements() {
    let (crane, y) = (Crane::default(), crane_state());
    let (q, v) = split::<Crane>(&y);
    let jacobian = crane.tangent_jacobian(0.0, &y);
    for column in 0..8 {
        let by_displacement = slope(|step| {
            let (mut displacement, mut moved) = ([0.0; 4], v);
            let changed = if column < 4 { &mut displacement[column] } else { &mut moved[column - 4] };
            *changed += step;
            let rates = crane.position_rates(0.0, &q, &displacement);
            let mut place = std::array::from_fn(|i| q[i] + rates[i]);
            Crane::normalise(&mut place);
            crane.acceleration(0.0, &place, &moved)
        });
        assert_near(&jacobian.map(|row| row[column])[4..], &by_displacement, 2e-7);
    }
    // δ̇ = ε − ω × δ
    assert_eq!(jacobian[1], [0.0, 0.0, v[3], -v[2], 0.0, 1.0, 0.0, 0.0]);
}

#[test]
fn frozen_coordinates_rest_and_quaternions_keep_turning() {
    let (crane, parked) = (Crane::default(), Parked::from(&Crane::default()));
    let y = crane_state();
    let mut whole = y;
    (whole[0], whole[5]) = (0.1, 0.0);
    let reduced = ParkedState::from(CraneState::from(whole));
    let found = parked.acceleration(0.0, &reduced.coordinates(), &reduced.velocities());
    // The same forces as for a cart that nothing can move.
    let heavy = crane.inverse_dynamics(
        0.0,
        &split::<Crane>(&whole).0,
        &split::<Crane>(&whole).1,
        &[0.0, found[0], found[1], found[2]],
    );
    assert!(heavy[1..].iter().all(|moment| moment.abs() < 1e-13), "{heavy:?}");
    assert_eq!(parked.expand(reduced), CraneState::from(whole));
}

#[test]
fn a_brick_bounces_and_events_change_its_spin() {
    let mut start = [0.0; 13];
    (start[2], start[3]) = (0.5, 1.0);
    let brick = Brick::default();
    let trajectory = brick.simulate(start).until(3.0).every(0.01).run().unwrap();
    let names = trajectory.events().iter().map(|event| event.name.as_str()).collect::<Vec<_>>();
    assert!(names.contains(&"floor"), "{names:?}");
    let lowest = trajectory.states().map(|y| {
        let (q, _) = split::<Brick>(&y);
        let [w, x, y, z] = [q[3], q[4], q[5], q[6]];
        let third = [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)];
        q[2] + 0.1 * third[0] + 0.05 * third[1] - 0.05 * third[2]
    });
    assert!(lowest.fold(f64::MAX, f64::min) > -1e-9);
    // 0.1 N m on 0.025 kg m² reach 3 rad/s after 0.75 s, unless the brick hits earlier: it falls
    // for 0.3 s.
    assert!(trajectory.states().all(|y| y[12] < 3.0 + 1e-9));
}

/// A ladder that slides down in the plane y = 0: its middle is on a circle, and energy is
/// conserved.
#[test]
fn constraints_hold_free_bodies() {
    let ladder = Ladder;
    let (sine, cosine) = (0.15_f64.sin(), 0.15_f64.cos());
    // Leaning by 0.3 about y: its top at x = 0, its foot at z = 0.
    let (x, z) = (-0.5 * 0.3_f64.sin(), 0.5 * 0.3_f64.cos());
    let start = [x, 0.0, z, cosine, 0.0, sine, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let trajectory = ladder.simulate(start).until(0.5).every(0.05).tolerance(1e-11).run().unwrap();
    for y in trajectory.states() {
        let (q, v) = split::<Ladder>(&y);
        let angle = 2.0 * q[5].atan2(q[3]);
        // θ̇² = 3 g (cos θ₀ − cos θ) / l of a uniform ladder (Goldstein, problem 2.20).
        let expected = 3.0 * 9.81 * (0.3_f64.cos() - angle.cos());
        assert!((v[4] * v[4] - expected).abs() < 1e-8, "{angle}: {} {expected}", v[4]);
        assert!(ladder.constraints(0.0, &q, &v).iter().all(|rest| rest.abs() < 1e-13));
    }
    let (mut q, mut v) = split::<Ladder>(&start);
    (q[0], q[5], v[0]) = (0.3, 0.6, 2.0);
    ladder.project(0.0, &mut q, &mut v).unwrap();
    assert!((length(&q[3..]) - 1.0).abs() < 1e-15);
    assert!(ladder.constraints(0.0, &q, &v).iter().all(|rest| rest.abs() < 1e-12));
    assert!(ladder.constraint_velocity(0.0, &q, &v).iter().all(|rest| rest.abs() < 1e-12));
}

#[test]
fn inputs_turn_bodies() {
    let satellite = Satellite::<f64>::default();
    // About its own z, with a law of the state: ω̇ = −ω.
    let mut start: [f64; 13] = satellite_start().into();
    (start[10], start[11], start[12]) = (0.0, 0.0, 2.0);
    let run = satellite.simulate(start).until(2.0).tolerance(1e-12);
    let driven = run
        .drive(|_, _, state: SatelliteState<f64>| SatelliteInputs { moment: -2.5 * state.hull_wz })
        .run()
        .unwrap();
    assert!((driven.last()[12] - 2.0 * (-2.0_f64).exp()).abs() < 1e-10);
}

#[test]
fn momenta_change_by_the_torque_and_the_turning_of_the_axes() {
    let satellite = Satellite { moment: 0.7, ..Satellite::<f64>::default() };
    let (q, v) = (satellite_start().coordinates(), satellite_start().velocities());
    let (momenta, rates) = (satellite.momenta(0.0, &q, &v), satellite.momentum_rates(0.0, &q, &v));
    assert_eq!(momenta, [3.0 * 0.1, 3.0 * -0.2, 3.0 * 0.3, 0.2, 2.0 * 1.5, 2.5 * -0.4]);
    let a = satellite.acceleration(0.0, &q, &v);
    let expected = [0.0, 0.0, 0.0, a[3], 2.0 * a[4], 2.5 * a[5]];
    assert!(rates.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{rates:?}, {expected:?}");
}

fn turned_by<S: Scalar>(satellite: &Satellite<S>) -> S {
    let state: [f64; 13] = satellite_start().into();
    let start = state.map(S::from_f64);
    let method = RungeKutta4 { step: S::from_f64(0.01) };
    satellite.simulate(start).until(S::ONE).method(method).ends_only().run().unwrap().last()[3]
}

#[test]
fn any_scalar_will_do() {
    let (double, single) = (turned_by(&Satellite::<f64>::default()), turned_by(&Satellite::<f32>::default()));
    assert!((double - f64::from(single)).abs() < 1e-6);
    let satellite = Satellite::<f64>::default();
    let adaptive = satellite.simulate(satellite_start()).until(1.0);
    let adaptive = adaptive.method(Verner98::tolerance(1e-12)).ends_only().run().unwrap();
    assert!((adaptive.last()[3] - double).abs() < 1e-8);
}

#[test]
fn rates_of_positions_and_accelerations_are_the_right_hand_side() {
    let (crane, y) = (Crane::default(), crane_state());
    let (q, v) = split::<Crane>(&y);
    let joined = join::<Crane>(&crane.position_rates(0.0, &q, &v), &crane.acceleration(0.0, &q, &v));
    assert_eq!(crane.rhs(0.0, &y), joined);
    let [w, x, y, z] = TURNED;
    let expected = [0.3, x * 0.7 - y * 0.9 - z * 1.1, -w * 0.7 + y * 1.1 - z * 0.9];
    assert_eq!(joined[0], expected[0]);
    assert!((joined[1] - expected[1] / 2.0).abs() < 1e-16);
    assert!((joined[2] - expected[2] / 2.0).abs() < 1e-16);
}
