//! Types of declarations with arrays beside those written out: arrays in their fields, and
//! identical bits in their results.

use lagrange::Simulate;
use lagrange::system::{ControlledSystem, Equations, KernelSystem, LanesSystem, MechanicalSystem};

lagrange::system! {
    /// Beads on a ring of springs, pushed one by one.
    #[derive(Clone, Debug)]
    struct Ring<S>;

    const n = 3;
    param m[n] = [1, 2, 3], k[n][2] = [[10, 1], [20, 2], 30];
    coord x[n], y;
    input push[n];
    for i in 0..n {
        kinetic = kinetic_energy(m[i], dot(x[i]));
        potential = spring_energy(k[i][0], x[(i + 1) % n] - x[i]) + k[i][1] * x[i]^4;
        force x[i] = push[i];
        output place[i] = (x[i], i);
    }
    kinetic = kinetic_energy(1, dot(y));
    potential = spring_energy(1, y - x[0]);
    output total = sum(i in 0..n, m[i] * x[i]);
    emit { prepared, jacobian, parameter_jacobian }
    reduce Still { freeze x[0] = 0, x[1] = 0, x[2] = 0; }
    reduce Gap { freeze x[1] = 1/2; small x[0]; }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Flat;

    param m_0 = 1, m_1 = 2, m_2 = 3, k_0_0 = 10, k_0_1 = 1, k_1_0 = 20, k_1_1 = 2, k_2_0 = 30, k_2_1 = 30;
    coord x_0, x_1, x_2, y;
    input push_0, push_1, push_2;
    kinetic = kinetic_energy(m_0, dot(x_0));
    potential = spring_energy(k_0_0, x_1 - x_0) + k_0_1 * x_0^4;
    force x_0 = push_0;
    kinetic = kinetic_energy(m_1, dot(x_1));
    potential = spring_energy(k_1_0, x_2 - x_1) + k_1_1 * x_1^4;
    force x_1 = push_1;
    kinetic = kinetic_energy(m_2, dot(x_2));
    potential = spring_energy(k_2_0, x_0 - x_2) + k_2_1 * x_2^4;
    force x_2 = push_2;
    kinetic = kinetic_energy(1, dot(y));
    potential = spring_energy(1, y - x_0);
}

lagrange::system! {
    /// Balls dropped side by side.
    #[scalar(f32)]
    #[derive(Clone, Debug)]
    struct Balls;

    param mu[2] = 0.1;
    coord x[2], y[2];
    for i in 0..2 {
        kinetic = kinetic_energy(i + 1, dot((x[i], y[i])));
        potential = 10 * (i + 1) * y[i];
        event floor[i] = y[i], falling => impact(1/2);
        friction rub[i] = dot(x[i]), mu[i] * floor[i];
    }
}

lagrange::system! {
    /// Beads on springs, also in lanes and as a kernel.
    struct Beads;

    param k[2] = [1, 4];
    coord x[2];
    kinetic = sum(i in 0..2, 1/2 * dot(x[i])^2);
    potential = sum(i in 0..2, spring_energy(k[i], x[i]));
    emit { lanes, kernel }
}

lagrange::system! {
    /// Every array is used somewhere, and every constant is a count, because warnings are errors
    /// here.
    #[deny(unused_variables)]
    struct Used;

    const n = 2, order[n] = [1, 0];
    param m[n + 1] = 1;
    coord x[n];
    for i in 0..n {
        let v[i] = dot(x[i]);
        kinetic = m[0] * v[i]^2 + dot(x[order[i]])^2;
    }
}

const Q: [f64; 4] = [0.3, -0.2, 0.7, 0.1];
const V: [f64; 4] = [0.1, 0.5, -0.4, 0.2];

#[test]
fn arrays_of_a_generic_system_compute_the_bits_of_single_fields() {
    let ring = Ring::<f64> { m: [1.5, 2.5, 0.5], push: [0.25, 0.0, -1.0], ..Ring::default() };
    let flat = Flat { m_0: 1.5, m_1: 2.5, m_2: 0.5, push_0: 0.25, push_2: -1.0, ..Flat::default() };
    assert_eq!(ring.k, [[10.0, 1.0], [20.0, 2.0], [30.0, 30.0]]);
    assert_eq!(ring.acceleration(0.0, &Q, &V), flat.acceleration(0.0, &Q, &V));
    assert_eq!(ring.energy(0.0, &Q, &V), flat.energy(0.0, &Q, &V));
    assert_eq!(ring.prepared().acceleration(0.0, &Q, &V).map(f64::is_finite), [true; 4]);
    assert_eq!(ring.total(0.0, &Q, &V), 1.5 * 0.3 - 2.5 * 0.2 + 0.5 * 0.7);
    assert_eq!(ring.place_2(0.0, &Q, &V), [0.7, 2.0]);
}

#[test]
fn states_and_inputs_are_arrays() {
    let state = RingState { x: [0.3, -0.2, 0.7], y: 0.1, x_dot: [0.1, 0.5, -0.4], y_dot: 0.2 };
    assert_eq!((state.coordinates(), state.velocities()), (Q, V));
    assert_eq!(RingState::from(<[f64; 8]>::from(state)), state);
    let ring = Ring::<f64>::default().with_inputs(RingInputs { push: [1.0, 2.0, 3.0] });
    assert_eq!(ring.push, [1.0, 2.0, 3.0]);
    assert_eq!(<[f64; 3]>::from(ring.inputs()), [1.0, 2.0, 3.0]);
}

#[test]
fn names_have_indices() {
    assert_eq!(<Ring<f64> as MechanicalSystem>::COORDINATES, ["x[0]", "x[1]", "x[2]", "y"]);
    assert_eq!(<Ring<f64> as ControlledSystem>::INPUTS, ["push[0]", "push[1]", "push[2]"]);
    assert_eq!(Ring::<f64>::PARAMETERS[..5], ["m[0]", "m[1]", "m[2]", "k[0][0]", "k[0][1]"]);
}

#[test]
fn columns_take_indices() {
    let ring = Ring::<f64>::default();
    let run = ring.simulate([0.1; 8]).until(0.1);
    let run = run.accelerations().run().expect("a smooth motion");
    assert_eq!(run.x(2), run.column("x[2]").expect("a coordinate"));
    assert_eq!(run.x_dot(1), run.column("x_dot[1]").expect("a velocity"));
    assert!(run.column("x_ddot[0]").is_some());
    assert!(std::panic::catch_unwind(|| run.x(3).len()).is_err());
}

#[test]
fn reduced_types_have_arrays_unless_elements_are_missing() {
    let ring = Ring::<f64>::default();
    let state = RingState { x: [0.3, 0.5, 0.7], y: 0.1, x_dot: [0.1, 0.0, -0.4], y_dot: 0.2 };
    let still = StillState::from(state);
    assert_eq!((still.y, still.y_dot), (0.1, 0.2));
    assert_eq!(Still::from(&ring).expand(still).x, [0.0; 3]);
    let gap = GapState::from(state);
    assert_eq!((gap.x_0, gap.x_2, gap.x_0_dot, gap.y), (0.3, 0.7, 0.1, 0.1));
    assert_eq!(Gap::from(&ring).expand(gap), state);
    assert_eq!(Gap::from(&ring).deviation(state).x, [0.3, 0.0, 0.0]);
}

#[test]
fn lanes_and_kernels_hold_arrays() {
    let beads = Beads::default();
    let lanes: BeadsLanes<f64> = beads.lanes(|number| number);
    assert_eq!(lanes.k, [1.0, 4.0]);
    assert_eq!(lanes.rhs(0.0, &[1.0, 1.0, 0.0, 0.0]), [0.0, 0.0, -1.0, -4.0]);
    assert_eq!(beads.parameters(), [1.0, 4.0]);
    assert_eq!(<Beads as KernelSystem>::PARAMETERS, ["k[0]", "k[1]"]);
}

#[test]
fn constants_that_count_are_used() {
    let used = Used::default();
    assert_eq!(used.acceleration(0.0, &[1.0; 2], &[1.0; 2]), [0.0; 2]);
}

#[test]
fn contacts_and_friction_may_be_many() {
    let balls = Balls::default();
    assert_eq!(balls.mu, [0.1; 2]);
    let start = BallsState { x: [0.0; 2], y: [1.0, 2.0], x_dot: [0.5; 2], y_dot: [0.0; 2] };
    let acceleration = balls.acceleration(0.0, &start.coordinates(), &start.velocities());
    assert_eq!(acceleration, [0.0, 0.0, -10.0, -10.0]);
}
