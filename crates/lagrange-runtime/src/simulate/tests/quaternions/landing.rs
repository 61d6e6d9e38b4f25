//! A body that falls to the ground on a corner: some positions have their rates as velocities,
//! others form a unit quaternion.

use super::{Quaternion, Vector, conjugate, cross, dot, length, rates, rotation, times, to_unit, turned};
use crate::contact::{self, Contact, ContactSystem, EventKind, LimitSlope, Mode, Terms};
use crate::event::DeclaredEvent;
use crate::simulate::Simulate;
use crate::system::{
    EnergyFunction, MechanicalSystem, OdeSystem, Reacted, StepFailure, Unnamed, join, split,
};

const MASS: f64 = 2.0;
const INERTIA: Vector = [0.3, 0.4, 0.2];
const GRAVITY: f64 = 9.81;
/// The position of the corner relative to the centre of mass, in body axes.
const CORNER: Vector = [0.3, 0.2, -0.4];
const UP: Vector = [0.0, 0.0, 1.0];

/// A body with its centre of mass at (x, y, z).
#[derive(Clone, Copy, Debug)]
struct Falling {
    restitution: f64,
    modes: [Mode; 1],
}

impl Falling {
    fn new(restitution: f64) -> Self {
        Falling { restitution, modes: [Mode::Contact(Contact::Open)] }
    }
}

fn parts(q: &[f64; 7], v: &[f64; 6]) -> (Quaternion, Vector) {
    ([q[3], q[4], q[5], q[6]], [v[3], v[4], v[5]])
}

impl OdeSystem for Falling {
    type Scalar = f64;
    type State = [f64; 13];

    fn rhs(&self, t: f64, y: &[f64; 13]) -> [f64; 13] {
        let (q, v) = split::<Self>(y);
        join::<Self>(&self.position_rates(t, &q, &v), &self.acceleration(t, &q, &v))
    }

    const IS_CONSTRAINED: bool = true;

    fn correct(&self, t: f64, y: &mut [f64; 13]) -> Result<(), StepFailure<f64>> {
        contact::correct(self, t, y)
    }

    const EVENTS: &'static [DeclaredEvent] = &[DeclaredEvent::switch("floor")];

    fn event_values(&self, t: f64, y: &[f64; 13], values: &mut [f64]) {
        contact::event_values(self, t, y, values);
    }

    fn react(&self, event: usize, t: f64, elapsed: f64, y: &[f64; 13]) -> Reacted<Self> {
        contact::react(self, event, t, elapsed, y)
    }

    fn begin(&self, t: f64, y: &[f64; 13]) -> Result<Option<Self>, StepFailure<f64>> {
        contact::begin(self, t, y)
    }
}

impl MechanicalSystem for Falling {
    type Coordinates = [f64; 7];
    type Velocities = [f64; 6];
    type Columns<C> = Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &["x", "y", "z", "q_0", "q_1", "q_2", "q_3"];
    const VELOCITIES: &'static [&'static str] = &["x_dot", "y_dot", "z_dot", "w_x", "w_y", "w_z"];

    fn acceleration(&self, t: f64, q: &[f64; 7], v: &[f64; 6]) -> [f64; 6] {
        let terms = self.terms(t, q, v);
        terms.acceleration(&contact::reactions(&terms, &self.modes))
    }

    fn position_rates(&self, _t: f64, q: &[f64; 7], v: &[f64; 6]) -> [f64; 7] {
        let (orientation, w) = parts(q, v);
        let [q_0, q_1, q_2, q_3] = rates(orientation, w);
        [v[0], v[1], v[2], q_0, q_1, q_2, q_3]
    }

    fn normalise(q: &mut [f64; 7]) {
        to_unit(&mut q[3..]);
    }

    fn displacement(&self, _t: f64, from: &[f64; 7], to: &[f64; 7]) -> [f64; 6] {
        let [one, other] = [from, to].map(|q| parts(q, &[0.0; 6]).0);
        let turn = rotation(one, other);
        core::array::from_fn(|i| if i < 3 { to[i] - from[i] } else { turn[i - 3] })
    }
}

impl EnergyFunction for Falling {
    fn energy(&self, _t: f64, q: &[f64; 7], v: &[f64; 6]) -> f64 {
        let (_, w) = parts(q, v);
        let translation = MASS * dot([v[0], v[1], v[2]], [v[0], v[1], v[2]]);
        0.5 * (translation + dot(times(INERTIA, w), w)) + MASS * GRAVITY * q[2]
    }
}

impl ContactSystem<6, 1> for Falling {
    type Terms = Terms<f64, 6, 1, [LimitSlope<f64>; 0]>;

    const REACTIONS: [&'static str; 1] = ["floor"];

    fn modes(&self) -> [Mode; 1] {
        self.modes
    }

    fn in_modes(&self, modes: [Mode; 1]) -> Self {
        Falling { modes, ..*self }
    }

    fn terms(&self, _t: f64, q: &[f64; 7], v: &[f64; 6]) -> Self::Terms {
        let (orientation, w) = parts(q, v);
        let up = turned(conjugate(orientation), UP);
        let (lever, spin) = (cross(CORNER, up), cross(times(INERTIA, w), w));
        let row = [0.0, 0.0, 1.0, lever[0], lever[1], lever[2]];
        let inertia = [MASS, MASS, MASS, INERTIA[0], INERTIA[1], INERTIA[2]];
        let loads = [0.0, 0.0, -MASS * GRAVITY, spin[0], spin[1], spin[2]];
        let per_mass = |loads: [f64; 6]| core::array::from_fn(|i| loads[i] / inertia[i]);
        Terms {
            free: per_mass(loads),
            responses: [per_mass(row)],
            rows: [row],
            gaps: [q[2] + dot(CORNER, up)],
            rates: [dot(row, *v)],
            drifts: [dot(w, cross(CORNER, cross(up, w)))],
            restitutions: [self.restitution],
            kinetic: [0.0],
            fixed: [0.0],
            slopes: [],
        }
    }

    fn event_of(&self, k: usize) -> Option<usize> {
        Some(k)
    }
}

/// At rest in the air, tilted.
const START: [f64; 13] = [0.0, 0.0, 1.0, 0.8, 0.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3, 0.0];

#[test]
fn an_elastic_impact_keeps_the_energy() {
    let trajectory =
        Falling::new(1.0).simulate(START).until(0.6).tolerance(1e-12).energy().run().expect("runs");
    assert!(matches!(trajectory.events(), [event, ..] if matches!(event.kind, EventKind::Impact(_))));
    let energies = trajectory.column("energy").expect("asked for");
    assert!(energies.iter().all(|energy| (energy - energies[0]).abs() < 1e-10 * energies[0]));
    assert!(trajectory.states().all(|y| (length(&y[3..7]) - 1.0).abs() < 4e-16));
}

#[test]
fn a_corner_that_stays_on_the_ground_does_so_to_rounding() {
    let body = Falling::new(0.0);
    let simulation = body.simulate(START).until(0.6).tolerance(1e-10).every(7e-4).accelerations();
    let trajectory = simulation.run().expect("runs");
    let closed = trajectory.events().first().expect("lands");
    assert!(matches!(closed.kind, EventKind::Closed { .. }), "{closed:?}");
    let mut seen = 0;
    for (t, y) in trajectory.iter() {
        assert!((length(&y[3..7]) - 1.0).abs() < 4e-16, "{t}");
        let (q, v) = split::<Falling>(&y);
        let terms = body.terms(t, &q, &v);
        if t > closed.time {
            assert!(terms.gaps[0].abs() < 5e-14 && terms.rates[0].abs() < 1e-14, "{t}: {terms:?}");
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
    assert!(trajectory.column("z_ddot").is_some() && trajectory.column("w_x_dot").is_some());
}
