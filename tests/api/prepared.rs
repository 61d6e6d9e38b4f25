//! Systems whose expressions of parameters alone are computed once.

use lagrange::Simulate;
use lagrange::system::{
    CanonicalSystem, ControlledSystem, EnergyFunction, MechanicalSystem, OdeSystem, OutputSystem,
    SeparableSystem,
};

lagrange::system! {
    /// An arm with six joints, whose inertias are parameters.
    pub struct Ur5;

    param p1 = 3.7, p2 = 0.010267495893, p3 = 0.010267495893, p4 = 0.00666, p5 = 8.393, p6 = 0.28, p7 =
        0.22689067591, p8 = 0.22689067591, p9 = 0.0151074, p10 = 2.275, p11 = 0.24999999999999994, p12 =
        0.049443313556, p13 = 0.049443313556, p14 = 0.004095, p15 = 1.219, p16 = 0.111172755531, p17 =
        0.111172755531, p18 = 0.21942, p19 = 1.219, p20 = 0.111172755531, p21 = 0.111172755531, p22 = 0.21942,
        p23 = 0.1879, p24 = 0.0171364731454, p25 = 0.0171364731454, p26 = 0.033822;
    gravity = (0, 0, -9.81);
    body l1 { mass: p1; inertia: (p2, p3, p4, 0, 0, 0); }
    revolute q1 = ground to l1 { at: (0, 0, 0.089159); }
    body l2 { mass: p5; centroid: (0, 0, p6); inertia: (p7, p8, p9, 0, 0, 0); }
    revolute q2 = l1 to l2 { at: (0, 0.13585, 0); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    body l3 { mass: p10; centroid: (0, 0, p11); inertia: (p12, p13, p14, 0, 0, 0); }
    revolute q3 = l2 to l3 { at: (0, -0.1197, 0.425); axis: (0, 1, 0); }
    body l4 { mass: p15; inertia: (p16, p17, p18, 0, 0, 0); }
    revolute q4 = l3 to l4 { at: (0, 0, 0.39225); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    body l5 { mass: p19; inertia: (p20, p21, p22, 0, 0, 0); }
    revolute q5 = l4 to l5 { at: (0, 0.093, 0); }
    body l6 { mass: p23; inertia: (p24, p25, p26, 0, 0, 0); }
    revolute q6 = l5 to l6 { at: (0, 0, 0.09465); axis: (0, 1, 0); }
    emit { prepared, bias, no kinetic_energy, no potential_energy, no momenta, no forcing }
}

lagrange::system! {
    /// A crane with a load on a rope, in any number type.
    #[derive(Debug, PartialEq)]
    struct Crane<S>;

    param trolley = 800, load = 450, l = 8, g = 9.81;
    coord x, theta;
    input drive;
    kinetic = 1/2 * trolley * dot(x)^2 + kinetic_energy(load, dot((x + l*sin(theta), -l*cos(theta))));
    potential = -load * g * l * cos(theta);
    force x = drive;
    output pull = load * (g * cos(theta) + l * dot(theta)^2);
    event top = x - 3, rising => stop;
    emit { prepared, jacobian, momentum_rates }
}

lagrange::system! {
    /// A body without expressions to prepare.
    struct Plain;

    param m = 2;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    potential = m * x;
    emit { prepared }
}

lagrange::system! {
    struct Top;

    param m = 1.5, l = 0.2, i1 = 0.01, i3 = 0.004;
    gravity = (0, 0, -9.81);
    body rotor { mass: m; centroid: (0, 0, l); inertia: (i1, i1, i3); }
    ball turn = ground to rotor;
    emit { prepared }
}

lagrange::system! {
    struct Pendulum;

    param m = 2, l = 1.5, g = 9.81;
    coord theta;
    kinetic = 1/2 * m * (l * dot(theta))^2;
    potential = -m * g * l * cos(theta);
    emit { prepared }
}

/// Returns reproducible numbers in −1 … 1.
fn numbers(seed: u32) -> impl Iterator<Item = f64> {
    let mut state = seed;
    std::iter::repeat_with(move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1_u32 << 23) - 1.0
    })
}

#[track_caller]
fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let scale = expected.iter().fold(1.0_f64, |scale, value| scale.max(value.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance * scale, "{found} is not {expected}");
    }
}

#[test]
fn prepared_methods_compute_the_same() {
    let arm = Ur5 { p1: 4.0, p7: 0.25, ..Ur5::default() };
    let prepared = arm.prepared();
    for seed in 0..20 {
        let mut next = numbers(seed);
        let [q, v, a]: [[f64; 6]; 3] =
            [(); 3].map(|()| [(); 6].map(|()| 3.0 * next.next().expect("endless")));
        let mut y = [0.0; 12];
        y[..6].copy_from_slice(&q);
        y[6..].copy_from_slice(&v);
        assert_near(&prepared.rhs(0.0, &y), &arm.rhs(0.0, &y), 1e-13);
        assert_near(&prepared.acceleration(0.0, &q, &v), &arm.acceleration(0.0, &q, &v), 1e-13);
        assert_near(
            &prepared.inverse_dynamics(0.0, &q, &v, &a),
            &arm.inverse_dynamics(0.0, &q, &v, &a),
            1e-13,
        );
        assert_near(&prepared.bias(0.0, &q, &v), &arm.bias(0.0, &q, &v), 1e-13);
        let [found, expected] = [prepared.mass_matrix(0.0, &q), arm.mass_matrix(0.0, &q)];
        assert_near(found.as_flattened(), expected.as_flattened(), 1e-13);
    }
}

#[test]
fn prepared_systems_move_as_they_do_unprepared() {
    let (arm, start) = (Ur5::default(), [0.3, -0.4, 0.7, 0.1, -0.2, 0.5, 0.0, 0.1, -0.3, 0.2, 0.0, 0.4]);
    let plain = arm.simulate(start).until(1.0).tolerance(1e-10).energy().run().expect("a motion");
    let prepared = arm.prepared();
    let found = prepared.simulate(start).until(1.0).tolerance(1e-10).energy().run().expect("a motion");
    assert_near(&found.last(), &plain.last(), 1e-9);
    assert_near(&prepared.rhs(0.0, &start), &OdeSystem::rhs(&arm, 0.0, &start), 1e-12);
    assert_eq!(prepared.rhs(0.0, &start), OdeSystem::rhs(&prepared, 0.0, &start));
    assert_eq!(Ur5Prepared::COORDINATES, Ur5::COORDINATES);
}

/// The prepared type uses its own parameters, even if those of the system change.
#[test]
fn parameters_are_those_of_the_time_of_preparing() {
    let mut pendulum = Pendulum::default();
    let prepared = pendulum.prepared();
    pendulum.l = 3.0;
    assert_eq!(prepared.system().l, 1.5);
    let ratio = prepared.acceleration(0.0, &[0.5], &[0.0])[0] / pendulum.acceleration(0.0, &[0.5], &[0.0])[0];
    assert_near(&[ratio], &[2.0], 1e-15);
    let copied = prepared.clone();
    assert_eq!(copied.acceleration(0.0, &[0.5], &[0.0]), prepared.acceleration(0.0, &[0.5], &[0.0]));
}

#[test]
fn inputs_outputs_and_events_are_those_of_the_system() {
    let crane = Crane::<f64>::default();
    let prepared = crane.prepared();
    let start = [0.0, 0.1, 0.0, 0.0];
    let inputs = |t: f64| CraneInputs { drive: 400.0 * (1.0 - t / 20.0) };
    let plain = crane.simulate(start).until(60.0).drive(|_, t, _| inputs(t)).outputs().run();
    let found = prepared.simulate(start).until(60.0).drive(|_, t, _| inputs(t)).outputs().run();
    let (plain, found) = (plain.expect("a motion"), found.expect("a motion"));
    // Both stop at the event.
    assert!(plain.times().last() < Some(&60.0));
    assert_near(&[*found.times().last().expect("an end")], &[*plain.times().last().expect("an end")], 1e-9);
    assert_near(&found.last(), &plain.last(), 1e-8);
    let pushed = prepared.with_inputs(CraneInputs { drive: 50.0 });
    assert_eq!(pushed.inputs(), CraneInputs { drive: 50.0 });
    assert_eq!(pushed.system().drive, 50.0);
    let expected = crane.with_inputs(CraneInputs { drive: 50.0 });
    assert_near(&pushed.rhs(0.0, &start), &expected.rhs(0.0, &start), 1e-15);
    assert_eq!(pushed.outputs(0.0, &[0.0, 0.1], &[0.0; 2]), expected.outputs(0.0, &[0.0, 0.1], &[0.0; 2]));
    let [found, plain] = [pushed.jacobian(0.0, &start), expected.jacobian(0.0, &start)];
    assert_near(found.as_flattened(), plain.as_flattened(), 1e-13);
    assert_eq!(OdeSystem::jacobian(&pushed, 0.0, &start), Some(found));
}

#[test]
fn any_number_type_is_prepared() {
    let (wide, narrow) = (Crane::<f64>::default().prepared(), Crane::<f32>::default().prepared());
    let wide = wide.acceleration(0.0, &[0.0, 0.3], &[0.1, 0.2]);
    let narrow = narrow.acceleration(0.0, &[0.0, 0.3], &[0.1, 0.2]).map(f64::from);
    assert_near(&narrow, &wide, 1e-6);
}

#[test]
fn orientations_are_prepared() {
    let top = Top::default();
    let start = [0.8, 0.6, 0.0, 0.0, 0.5, 0.0, 30.0];
    assert_near(&top.prepared().rhs(0.0, &start), &top.rhs(0.0, &start), 1e-13);
    let plain = top.simulate(start).until(0.5).energy().run().expect("a motion");
    let found = top.prepared().simulate(start).until(0.5).energy().run().expect("a motion");
    assert_near(&found.last(), &plain.last(), 1e-8);
}

#[test]
fn types_without_prepared_values_contain_only_the_system() {
    assert_eq!(size_of::<PlainPrepared>(), size_of::<Plain>());
    assert!(size_of::<PendulumPrepared>() > size_of::<Pendulum>());
    assert_eq!(Plain::default().prepared().acceleration(0.0, &[1.0], &[0.0]), [-1.0]);
}

#[test]
fn methods_of_integration_take_prepared_systems() {
    fn momenta<M: CanonicalSystem<Scalar = f64> + EnergyFunction>(
        system: &M,
        q: M::Coordinates,
        v: M::Velocities,
    ) -> M::Coordinates {
        CanonicalSystem::momenta(system, 0.0, &q, &v)
    }
    fn is_separable<M: SeparableSystem>(_: &M) {}
    let crane = Crane::<f64>::default();
    let expected = crane.momenta(0.0, &[0.0, 0.3], &[0.1, 0.2]);
    assert_near(&momenta(&crane.prepared(), [0.0, 0.3], [0.1, 0.2]), &expected, 1e-15);
    is_separable(&Pendulum::default().prepared());
}
