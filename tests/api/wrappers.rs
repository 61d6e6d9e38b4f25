//! Types that contain a system and change its equations keep its constraints, events, contacts and
//! friction.

use lagrange::Simulate;
use lagrange::contact::{Contact, Friction};
use lagrange::integrate::{RungeKutta4, Verner98, integrate};
use lagrange::system::{MechanicalSystem, OdeSystem, Wrapper};

lagrange::system! {
    /// A point mass on a rod, pushed by a force, caught at the level and struck back below.
    #[derive(Clone, Debug)]
    struct Rod;

    param m = 2.0, g = 9.81;
    coord x, y;
    input u;
    kinetic = kinetic_energy(m, dot((x, y)));
    potential = m * g * y;
    force x = u;
    constraint length = hypot(x, y) - 1;
    event wall = x - 1/2, rising => { dot(x) = -dot(x) / 2; dot(y) = -dot(y) / 2; }
    event level = y, rising => stop;
}

lagrange::system! {
    /// The rod with the control in its equations.
    struct Controlled;

    param m = 2.0, g = 9.81;
    coord x, y;
    kinetic = kinetic_energy(m, dot((x, y)));
    potential = m * g * y;
    force x = 3 * x - dot(x) / 4;
    constraint length = hypot(x, y) - 1;
    event wall = x - 1/2, rising => { dot(x) = -dot(x) / 2; dot(y) = -dot(y) / 2; }
    event level = y, rising => stop;
}

lagrange::system! {
    /// A crate thrown onto a rough floor.
    #[derive(Clone, Debug)]
    struct Crate;

    param m = 2, g = 9.81, bounce = 0.4, mu = 0.2;
    coord x, y;
    kinetic = kinetic_energy(m, dot((x, y)));
    potential = m * g * y;
    event floor = y, falling => impact(bounce);
    friction rub = dot(x), mu * floor;
}

/// A wrapper without changes.
#[derive(Clone, Debug)]
struct Same<M>(M);

impl<M: OdeSystem> Wrapper for Same<M> {
    type Inner = M;
    type State = M::State;

    fn inner(&self) -> &M {
        &self.0
    }

    fn around(&self, inner: M) -> Self {
        Same(inner)
    }

    fn outer_rhs(&self, t: M::Scalar, y: &M::State) -> M::State {
        self.0.rhs(t, y)
    }
}

/// The rod under control.
struct Driven(Rod);

impl Driven {
    fn force(y: &[f64]) -> f64 {
        3.0 * y[0] - y[2] / 4.0
    }
}

impl Wrapper for Driven {
    type Inner = Rod;
    type State = [f64; 4];

    fn inner(&self) -> &Rod {
        &self.0
    }

    fn around(&self, inner: Rod) -> Driven {
        Driven(inner)
    }

    fn outer_rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
        Rod { u: Driven::force(y), ..self.0.clone() }.rhs(t, y)
    }
}

/// The rod under control, with its work behind the state.
struct WithWork(Rod);

impl Wrapper for WithWork {
    type Inner = Rod;
    type State = [f64; 5];

    fn inner(&self) -> &Rod {
        &self.0
    }

    fn around(&self, inner: Rod) -> WithWork {
        WithWork(inner)
    }

    fn outer_rhs(&self, t: f64, y: &[f64; 5]) -> [f64; 5] {
        let &[x, y, u, v, _] = y;
        let force = Driven::force(&[x, y, u, v]);
        let [x_dot, y_dot, x_ddot, y_ddot] = Rod { u: force, ..self.0.clone() }.rhs(t, &[x, y, u, v]);
        [x_dot, y_dot, x_ddot, y_ddot, force * u]
    }
}

/// The rod in a wrapper that only forwards required methods.
struct Bare(Rod);

impl OdeSystem for Bare {
    type Scalar = f64;
    type State = [f64; 4];

    fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
        self.0.rhs(t, y)
    }
}

const START: [f64; 4] = [0.0, -1.0, 2.4, 0.0];

fn residual(y: &[f64]) -> f64 {
    (y[0].hypot(y[1]) - 1.0).abs()
}

#[test]
fn a_wrapped_system_moves_as_one_with_the_same_equations() {
    let method = Verner98::tolerance(1e-11);
    let declared = Controlled::default().simulate(START).until(2.0).method(method).run().expect("runs");
    let wrapped = Driven(Rod::default()).simulate(START).until(2.0).method(method).run().expect("runs");
    let (expected, found) = (declared.last(), wrapped.last());
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-9, "{found:?} for {expected:?}");
    }
    assert!(residual(&found) < 1e-15);
    assert!(<Driven as OdeSystem>::IS_CONSTRAINED && <Driven as OdeSystem>::EVENTS.len() == 2);
    let (q, v) = ([0.6, -0.8], [0.8, 0.6]);
    let [ax, ay] = MechanicalSystem::acceleration(&Driven(Rod::default()), 0.0, &q, &v);
    let [bx, by] = Controlled::default().acceleration(0.0, &q, &v);
    assert!((ax - bx).abs() < 1e-14 && (ay - by).abs() < 1e-14);
}

#[test]
fn additional_entries_of_the_state_pass_events_and_constraints() {
    let system = WithWork(Rod::default());
    let rod = &system.0;
    let energy = |y: &[f64]| rod.energy(0.0, &[y[0], y[1]], &[y[2], y[3]]);
    let start = [0.0, -1.0, 2.4, 0.0, 0.0];
    let (mut lost, mut before) = (0.0, start);
    let end = integrate(&system, 0.0, start, 1.5, &Verner98::tolerance(1e-12), |_, y| {
        assert!(residual(y) < 1e-15, "{y:?}");
        let gain = energy(y) - energy(&before) - (y[4] - before[4]);
        // At the wall it loses three quarters of its kinetic energy, and nowhere else.
        if gain.abs() > 1e-3 {
            lost += gain;
        } else {
            assert!(gain.abs() < 1e-9, "{gain}");
        }
        before = *y;
    })
    .expect("runs");
    assert!(lost < -1.0, "it meets the wall: {lost}");
    assert!((energy(&end) - energy(&start) - end[4] - lost).abs() < 1e-9);
}

#[test]
fn contacts_and_friction_work_through_a_wrapper() {
    let start = [0.0, 1.0, 2.0, 0.0];
    let crate_alone = Crate::default().simulate(start).until(5.0).run().expect("comes to rest");
    let wrapped = Same(Crate::default()).simulate(start).until(5.0).run().expect("comes to rest");
    assert_eq!(wrapped.last(), crate_alone.last());
    assert_eq!(wrapped.len(), crate_alone.len());
    let Same(at_rest) = wrapped.system_at_end().expect("modes have changed");
    assert_eq!((at_rest.floor, at_rest.rub), (Contact::Closed, Friction::Sticks));
}

#[test]
fn wrappers_in_wrappers_are_wrappers() {
    let run = |steps: &mut Vec<[f64; 4]>, system: Same<Same<Rod>>| {
        integrate(&system, 0.0, START, 1.0, &RungeKutta4 { step: 0.01 }, |_, y| steps.push(*y))
            .expect("runs");
    };
    let (mut twice, mut once) = (Vec::new(), Vec::new());
    run(&mut twice, Same(Same(Rod::default())));
    let method = RungeKutta4 { step: 0.01 };
    integrate(&Rod::default(), 0.0, START, 1.0, &method, |_, y| once.push(*y)).expect("runs");
    assert_eq!(twice, once);
}

#[test]
fn a_type_that_forwards_its_equations_alone_leaves_constraints_behind() {
    let method = RungeKutta4 { step: 0.01 };
    let end = integrate(&Bare(Rod::default()), 0.0, START, 5.0, &method, |_, _| {}).expect("runs");
    assert!(residual(&end) > 1e-12, "{end:?}");
    let end = integrate(&Same(Rod::default()), 0.0, START, 5.0, &method, |_, _| {}).expect("runs");
    assert!(residual(&end) < 1e-15, "{end:?}");
}
