//! Motions: chaotic ones, which amplify any difference in a last bit, and ones with contacts,
//! impacts, friction and events.

use lagrange::Portable;
use lagrange::integrate::{GaussLegendre4, Method, RungeKutta4, Taylor, Verner98, integrate};
use lagrange::system::OdeSystem;

use crate::hash::Hash;

lagrange::system! {
    /// Two point masses on massless rods.
    #[accuracy(fast)]
    #[derive(Clone, Debug)]
    struct DoublePendulum<S>;

    param m1 = 1.0, m2 = 0.8, l1 = 1.0, l2 = 0.7, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    emit { taylor, momentum_rates, jacobian }
}

lagrange::system! {
    /// A pendulum driven into chaos, with elementary functions of all kinds in its forces.
    #[accuracy(strict)]
    #[derive(Clone, Debug)]
    struct Driven<S>;

    param c = 0.05, a = 1.2, w = 0.7;
    table ramp(time) = [(0, 0), (5, 1), (9, 1.5), (20, 1)], interpolation: natural, outside: clamp;
    coord q;
    kinetic = 1/2 * dot(q)^2;
    potential = -cos(q) + 1/10 * exp(-q^2) + 1/20 * ln(1 + q^2) + 1/50 * (2 + q^2)^(3/10);
    force q = a * ramp(t) * cos(w * t) - c * tanh(dot(q)) + 1/10 * atan2(sin(q), 2 + cos(q));
}

lagrange::system! {
    /// Two discs that fall onto the ground, against a rough wall, and onto each other.
    #[derive(Clone, Debug)]
    struct Discs<S>;

    param g = 9.81, mu = 0.3, e = 0.7, r = 0.2;
    coord x1, y1, x2, y2;
    kinetic = 1/2 * (dot(x1)^2 + dot(y1)^2) + 1/2 * (dot(x2)^2 + dot(y2)^2);
    potential = g * (y1 + y2) + 2 * (x1^2 + x2^2);
    event ground1 = y1 - r, falling => impact(e);
    event ground2 = y2 - r, falling => impact(1/2);
    event meet = hypot(x1 - x2, y1 - y2) - 2 * r, falling => impact(9/10);
    friction rub1 = dot(x1), mu * ground1;
    friction rub2 = dot(x2), mu * ground2;
}

lagrange::system! {
    /// A bead on a wire, struck at every passage of the top, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    struct Bead<S>;

    param g = 9.81;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint wire = hypot(x, y) - 1;
    dissipation = 1/20 * (dot(x)^2 + dot(y)^2);
    event side = x, rising => { dot(x) = dot(x) * 11/10; dot(y) = dot(y) * 11/10; }
}

/// Hashes every step of a motion.
fn steps<M, T, K>(system: &M, start: M::State, end: Portable<T>, method: &K) -> Hash
where
    M: OdeSystem<Scalar = Portable<T>>,
    Portable<T>: lagrange::Scalar + Into<f64>,
    K: Method<M>,
{
    let mut hash = Hash::NEW;
    let zero = <Portable<T> as lagrange::Number>::ZERO;
    let last = integrate(system, zero, start, end, method, |t, state| {
        hash.add(t);
        hash.add_all(state.as_ref().iter().copied());
    });
    assert!(last.is_ok(), "the motion ends early");
    hash
}

const TOP: [Portable; 4] = [Portable(2.0), Portable(1.5), Portable(0.0), Portable(0.0)];

pub(crate) fn chaos() -> Hash {
    let system = Driven::<Portable>::default();
    let start = [Portable(1.0), Portable(0.0)];
    steps(&system, start, Portable(20_000.0), &RungeKutta4 { step: Portable(0.02) })
}

pub(crate) fn single() -> Hash {
    let start = TOP.map(|Portable(component)| Portable(component as f32));
    let method = RungeKutta4 { step: Portable(0.002) };
    steps(&DoublePendulum::<Portable<f32>>::default(), start, Portable(20.0), &method)
}

pub(crate) fn adaptive() -> Hash {
    let system = DoublePendulum::<Portable>::default();
    steps(&system, TOP, Portable(100.0), &Verner98::tolerance(Portable(1e-10)))
}

pub(crate) fn series() -> Hash {
    let system = DoublePendulum::<Portable>::default();
    steps(&system, TOP, Portable(100.0), &Taylor::tolerance(Portable(1e-14)))
}

pub(crate) fn implicit() -> Hash {
    let system = DoublePendulum::<Portable>::default();
    steps(&system, TOP, Portable(20.0), &GaussLegendre4 { step: Portable(0.01) })
}

const DISCS_START: [Portable; 8] = [
    Portable(-1.0),
    Portable(1.5),
    Portable(0.4),
    Portable(1.0),
    Portable(0.0),
    Portable(0.0),
    Portable(-0.5),
    Portable(0.2),
];
const DISCS_END: Portable = Portable(10.0);

pub(crate) fn contacts() -> Hash {
    let system = Discs::<Portable>::default();
    steps(&system, DISCS_START, DISCS_END, &Verner98::tolerance(Portable(1e-9)))
}

pub(crate) fn events() -> Hash {
    let system = Bead::<Portable>::default();
    let start = [0.0, -1.0, 4.0, 0.0].map(Portable);
    steps(&system, start, Portable(30.0), &Verner98::tolerance(Portable(1e-9)))
}

#[cfg(test)]
mod tests {
    use lagrange::Portable;
    use lagrange::integrate::{Verner98, integrate};

    use super::{Bead, DISCS_END, DISCS_START, Discs};

    /// Energy lost by impacts and friction, and gained by blows, shows that the hashes cover these.
    #[test]
    fn discs_lie_and_slide_after_impacts() {
        let (system, method) = (Discs::<Portable>::default(), Verner98::tolerance(Portable(1e-9)));
        let end = integrate(&system, Portable(0.0), DISCS_START, DISCS_END, &method, |_, _| {}).unwrap();
        let vertical = [end[1], end[3], end[5], end[7]].map(|Portable(component)| component);
        for (found, expected) in vertical.into_iter().zip([0.2, 0.2, 0.0, 0.0]) {
            assert!((found - expected).abs() < 1e-12, "{vertical:?}");
        }
    }

    #[test]
    fn beads_are_driven_around() {
        let (system, method) = (Bead::<Portable>::default(), Verner98::tolerance(Portable(1e-9)));
        let start = [0.0, -1.0, 4.0, 0.0].map(Portable);
        let mut passes = 0;
        let mut left = false;
        integrate(&system, Portable(0.0), start, Portable(30.0), &method, |_, state| {
            passes += u32::from(left && state[0].0 > 0.0);
            left = state[0].0 < 0.0;
        })
        .unwrap();
        assert!(passes > 10, "{passes}");
    }
}
