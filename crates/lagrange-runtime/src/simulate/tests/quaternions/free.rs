//! A free rigid body.

use std::string::{String, ToString};
use std::vec::Vec;

use super::{
    ANGULAR_VELOCITY, Quaternion, Vector, conjugate, cross, distance, dot, length, product, rates, rotation,
    times, to_unit, turn, turned,
};
use crate::integrate::{GaussLegendre6, IntegrationError, RungeKutta4, Verner98};
use crate::run::integrate;
use crate::simulate::{Simulate, Trajectory};
use crate::system::{
    Component, Direction, EnergyFunction, MechanicalSystem, OdeSystem, StepFailure, Undefined, Unnamed,
    Wrapper, join, normalise, split,
};

/// A rigid body that turns freely, with its principal moments of inertia: I ω̇ = (I ω) × ω.
#[derive(Clone, Copy, Debug)]
struct FreeBody(Vector);

impl OdeSystem for FreeBody {
    type Scalar = f64;
    type State = [f64; 7];

    fn rhs(&self, t: f64, y: &[f64; 7]) -> [f64; 7] {
        let (q, w) = split::<Self>(y);
        join::<Self>(&self.position_rates(t, &q, &w), &self.acceleration(t, &q, &w))
    }

    const IS_CONSTRAINED: bool = true;

    fn correct(&self, _t: f64, y: &mut [f64; 7]) -> Result<(), StepFailure<f64>> {
        normalise::<Self>(y)
    }
}

impl MechanicalSystem for FreeBody {
    type Coordinates = Quaternion;
    type Velocities = Vector;
    type Columns<C> = Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &["q_0", "q_1", "q_2", "q_3"];
    const VELOCITIES: &'static [&'static str] = ANGULAR_VELOCITY;

    fn acceleration(&self, _t: f64, _q: &Quaternion, w: &Vector) -> Vector {
        let torque = cross(times(self.0, *w), *w);
        core::array::from_fn(|i| torque[i] / self.0[i])
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

impl EnergyFunction for FreeBody {
    fn energy(&self, _t: f64, _q: &Quaternion, w: &Vector) -> f64 {
        0.5 * dot(times(self.0, *w), *w)
    }
}

impl FreeBody {
    /// Returns the angular momentum in the world.
    fn angular_momentum(&self, y: &[f64; 7]) -> Vector {
        let (q, w) = split::<Self>(y);
        turned(q, times(self.0, w))
    }
}

const BODY: FreeBody = FreeBody([1.0, 2.0, 3.0]);
/// Close to the middle axis, about which it tumbles.
const START: [f64; 7] = [0.5, 0.5, -0.5, 0.5, 0.1, 2.0, -0.05];

/// Returns the largest deviations of the quaternion's length from one and of the angular momentum.
fn deviations(trajectory: &Trajectory<FreeBody>) -> [f64; 2] {
    let start = BODY.angular_momentum(&START);
    trajectory.states().fold([0.0_f64; 2], |[unit, momentum], y| {
        let change = distance(&BODY.angular_momentum(&y), &start);
        [unit.max((length(&y[..4]) - 1.0).abs()), momentum.max(change)]
    })
}

#[test]
fn quaternions_keep_their_length_and_bodies_their_angular_momentum() {
    let run = || BODY.simulate(START).until(20.0).energy();
    let adaptive = run().tolerance(1e-12).run().expect("runs");
    let fixed = run().method(RungeKutta4 { step: 2e-3 }).run().expect("runs");
    let implicit = run().method(GaussLegendre6 { step: 2e-2 }.plain()).run().expect("runs");
    for trajectory in [adaptive, fixed, implicit] {
        let [unit, momentum] = deviations(&trajectory);
        assert!(unit < 4e-16, "{}: {unit:e}", trajectory.method());
        assert!(momentum < 1e-9, "{}: {momentum:e}", trajectory.method());
        let energies = trajectory.column("energy").expect("asked for");
        assert!(energies.iter().all(|energy| (energy - energies[0]).abs() < 1e-9));
    }
}

/// A symmetric body turns about its angular momentum at the rate L/I₁, and within that about its
/// axis.
#[test]
fn a_symmetric_body_moves_as_it_must() {
    let body = FreeBody([2.0, 2.0, 0.7]);
    let momentum = body.angular_momentum(&START);
    let size = length(&momentum);
    let slip = START[6] * (1.0 - 0.7 / 2.0);
    for method_end in [3.0, -3.0] {
        let around = turn(size / 2.0 * method_end, momentum.map(|entry| entry / size));
        let own = turn(slip * method_end, [0.0, 0.0, 1.0]);
        let expected = product(product(around, [0.5, 0.5, -0.5, 0.5]), own);
        let found = body.simulate(START).until(method_end).tolerance(1e-13).run().expect("runs").last();
        let missed = rotation(expected, [found[0], found[1], found[2], found[3]]);
        assert!(length(&missed) < 1e-11, "{missed:?}");
    }
}

#[test]
fn runge_kutta_has_order_four() {
    let exact = BODY.simulate(START).until(2.0).tolerance(1e-14).run().expect("runs").last();
    let errors = [0.04, 0.02, 0.01].map(|step| {
        let run = BODY.simulate(START).until(2.0).method(RungeKutta4 { step });
        distance(&run.run().expect("runs").last(), &exact)
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((3.8..4.3).contains(&order), "{order}: {errors:?}");
    }
}

#[test]
fn motions_run_backwards() {
    let there = BODY.simulate(START).until(5.0).tolerance(1e-13).run().expect("runs").last();
    let back = BODY.simulate(there).from(5.0).until(0.0).tolerance(1e-13).every(0.1).run().expect("runs");
    assert!(distance(&back.last(), &START) < 1e-9, "{:?}", back.last());
    assert!(deviations(&back)[0] < 4e-16);
}

/// The tolerance is so loose that quaternions within steps are far from unit length before
/// normalisation.
#[test]
fn states_within_steps_have_unit_length() {
    let loose = || BODY.simulate(START).until(20.0).tolerance(1e-3);
    let event = |_: &FreeBody, _, y: &[f64; 7]| y[1];
    let trajectory = loose().every(0.037).dense().event("upright", Direction::Crossing, event).run();
    let trajectory = trajectory.expect("runs");
    let unit = |y: &[f64]| (length(&y[..4]) - 1.0).abs() < 4e-16;
    assert!(trajectory.states().all(|y| unit(&y)));
    assert!(!trajectory.events().is_empty() && trajectory.events().iter().all(|event| unit(&event.state)));
    for k in 0..500 {
        let t = 0.04 * f64::from(k);
        assert!(unit(&trajectory.at(t).expect("dense")), "{t}");
    }
    let start = BODY.angular_momentum(&START);
    let errors = trajectory.states().map(|y| distance(&BODY.angular_momentum(&y), &start));
    assert!(errors.fold(0.0, f64::max) > 1e-6, "steps are not long enough to tell anything");
}

#[test]
fn loops_without_heap_keep_the_length() {
    let mut longest = 0.0_f64;
    let mut see = |_, y: &[f64; 7]| longest = longest.max((length(&y[..4]) - 1.0).abs());
    let end = integrate(&BODY, 0.0, START, 3.0, &Verner98::tolerance(1e-6), &mut see).expect("runs");
    assert!(longest < 4e-16 && distance(&BODY.angular_momentum(&end), &BODY.angular_momentum(&START)) < 1e-4);
}

#[test]
fn starts_are_brought_to_unit_length() {
    let twice = core::array::from_fn(|i| if i < 4 { 2.0 * START[i] } else { START[i] });
    let [one, other] = [START, twice].map(|start| BODY.simulate(start).until(1.0).run().expect("runs"));
    assert_eq!((one.first(), one.last()), (other.first(), other.last()));
    let mut none = START;
    none[..4].fill(0.0);
    let error = BODY.simulate(none).until(1.0).run().expect_err("has no direction");
    assert_eq!(error.to_string(), "a quaternion of zeros is not an orientation (at time 0.0)");
    assert_eq!(error.state(), none);
}

#[test]
fn columns_are_called_as_positions_and_velocities_are() {
    let trajectory = BODY.simulate(START).until(0.1).accelerations().run().expect("runs");
    let mut bytes = Vec::new();
    trajectory.write_csv(&mut bytes).expect("memory takes everything");
    let text = String::from_utf8(bytes).expect("text");
    let header = "t,q_0,q_1,q_2,q_3,w_x,w_y,w_z,w_x_dot,w_y_dot,w_z_dot";
    assert_eq!(text.lines().next(), Some(header));
    let (rate, [_, y, _]) = (trajectory.column("w_y_dot").expect("asked for"), BODY.0);
    assert!((rate[0] - (3.0 - 1.0) / y * 0.1 * -0.05).abs() < 1e-15);
}

/// A free body in a fluid that slows its rotation.
struct Slowed(FreeBody);

impl Wrapper for Slowed {
    type Inner = FreeBody;
    type State = [f64; 7];

    fn inner(&self) -> &FreeBody {
        &self.0
    }

    fn around(&self, inner: FreeBody) -> Self {
        Slowed(inner)
    }

    fn outer_rhs(&self, t: f64, y: &[f64; 7]) -> [f64; 7] {
        let rates = self.0.rhs(t, y);
        core::array::from_fn(|i| if i < 4 { rates[i] } else { rates[i] - 0.3 * y[i] })
    }
}

#[test]
fn systems_around_others_keep_what_these_say_of_positions() {
    let slowed = Slowed(BODY);
    let trajectory = slowed.simulate(START).until(3.0).tolerance(1e-4).dense().accelerations().run();
    let trajectory = trajectory.expect("runs");
    assert_eq!(trajectory.names()[4..8], ["w_x", "w_y", "w_z", "w_x_dot"]);
    assert!((0..60).all(|k| {
        let state = trajectory.at(0.05 * f64::from(k)).expect("dense");
        (length(&state[..4]) - 1.0).abs() < 4e-16
    }));
    let (q, w) = split::<FreeBody>(&START);
    assert_eq!(slowed.position_rates(0.0, &q, &w), BODY.position_rates(0.0, &q, &w));
    assert_eq!(slowed.displacement(0.0, &q, &[1.0, 0.0, 0.0, 0.0]), rotation(q, [1.0, 0.0, 0.0, 0.0]));
    assert_eq!(slowed.acceleration(0.0, &q, &w)[0], BODY.acceleration(0.0, &q, &w)[0] - 0.3 * w[0]);
}

#[cfg(feature = "plot")]
#[test]
fn positions_and_velocities_are_plotted_however_many_there_are() {
    use crate::simulate::tests::plots::{labels, written};

    let trajectory = BODY.simulate(START).until(1.0).run().expect("runs");
    let found = labels(&written("turning", |path| trajectory.plot_states(path)));
    let wanted = ["coordinates", "velocities", "q{3}", "w{z}"];
    assert!(wanted.iter().all(|wanted| found.iter().any(|label| label == wanted)), "{found:?}");
}

#[test]
fn infinite_entries_are_reported_by_name() {
    let mut start = START;
    start[5] = f64::NAN;
    let error = BODY.simulate(start).until(1.0).run().expect_err("not a number");
    let StepFailure::Undefined(Undefined::State { component, .. }) = error.cause else { panic!("{error}") };
    assert_eq!(component, Component::NamedVelocity("w_y"));
    let flat = FreeBody([1.0, 1.0, 0.0]);
    let error = flat.simulate(START).until(1.0).run().expect_err("no inertia about the axis");
    let message = error.to_string();
    assert!(message.starts_with("the acceleration `w_z_dot` is "), "{message}");
    let stopped: Result<_, IntegrationError<f64, [f64; 7]>> =
        integrate(&flat, 0.0, START, 1.0, &RungeKutta4 { step: 0.1 }, |_, _| {});
    assert!(stopped.is_err());
}

#[test]
fn displacements_lead_back() {
    let [q, mut p]: [Quaternion; 2] = [[0.5, 0.5, -0.5, 0.5], [0.52, 0.49, -0.51, 0.48]];
    to_unit(&mut p);
    for p in [p, p.map(|entry| -entry)] {
        let way = BODY.displacement(0.0, &q, &p);
        let reached = crate::system::displaced(&BODY, 0.0, &q, [(1.0, &way)]);
        let [real, ..] = product(conjugate(reached), p);
        // There is no second-order error: ½ δ ⊗ (0, δ) is real.
        assert!((real.abs() - 1.0).abs() < 1e-8, "{real}");
        assert!(length(&rotation(reached, p)) < length(&way).powi(3), "{way:?}");
    }
}
