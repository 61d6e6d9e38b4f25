//! Constraints over a million steps of methods that enforce them without projection.

use lagrange::integrate::{
    GaussLegendre4, GaussLegendre6, Method, StormerVerlet, SymplecticEuler, Variational, integrate,
};
use lagrange::system::{CanonicalSystem, EnergyFunction, OdeSystem, split};

use crate::drift::{Line, assert_bounded, line};

lagrange::system! {
    /// A point mass on a rod in space, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    pub(crate) struct Sphere;

    emit { momentum_rates }
    param l = 1.0, g = 9.81;
    coord x, y, z;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    potential = g * z;
    constraint rod = x^2 + y^2 + z^2 - l^2;
}

lagrange::system! {
    /// Two point masses on rods, one below the other, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    pub(crate) struct TwoRods;

    emit { jacobian, momentum_rates }
    param g = 9.81;
    coord x1, y1, x2, y2;
    kinetic = 1/2 * (dot(x1)^2 + dot(y1)^2 + dot(x2)^2 + dot(y2)^2);
    potential = g * (y1 + y2);
    constraint upper = hypot(x1, y1) - 1;
    constraint lower = hypot(x2 - x1, y2 - y1) - 1;
}

lagrange::system! {
    /// A skate that turns on a slope.
    #[derive(Clone, Debug)]
    pub(crate) struct Skate;

    emit { momentum_rates, taylor }
    param fall = 2.0;
    coord x, y, theta;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2) + 1/4 * dot(theta)^2;
    potential = -fall * x;
    constraint blade = dot(y) * cos(theta) - dot(x) * sin(theta);
}

lagrange::system! {
    /// A bead between springs on a rotating wire.
    #[derive(Clone, Debug)]
    pub(crate) struct Wire;

    emit { momentum_rates, taylor }
    param rate = 1.5, k = 9.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 1/2 * k * (x^2 + y^2);
    constraint wire = y * cos(rate * t) - x * sin(rate * t);
}

const MILLION: u32 = 1_000_000;
/// One in this many states is recorded.
const INTERVAL: u32 = 1009;
const SPHERE: [f64; 6] = [0.6, 0.0, -0.8, 0.4, 1.5, 0.3];
const RODS: [f64; 8] = [0.6, -0.8, 1.4, -1.4, 0.4, 0.3, 1.0, 1.1];

/// Observations along a long motion.
struct Seen {
    energy: Line,
    /// The largest residuals of positions and of velocities.
    residuals: [f64; 2],
}

impl Seen {
    #[track_caller]
    fn check(&self, energy: f64, positions: f64, velocities: f64) {
        assert_bounded(&self.energy, energy);
        assert!(self.residuals[0] < positions && self.residuals[1] < velocities, "{:?}", self.residuals);
    }
}

/// Takes a million steps, and records the residuals of these constraints.
fn watched<M, K>(
    system: &M,
    start: M::State,
    step: f64,
    method: &K,
    residuals: impl Fn(f64, &M::Coordinates, &M::Velocities) -> [f64; 2],
) -> Seen
where
    M: OdeSystem<Scalar = f64> + EnergyFunction,
    K: Method<M>,
{
    let energy = |t: f64, y: &M::State| {
        let (q, v) = split::<M>(y);
        system.energy(t, &q, &v)
    };
    let (first, mut count, mut points, mut largest) = (energy(0.0, &start), 0, Vec::new(), [0.0_f64; 2]);
    integrate(system, 0.0, start, f64::from(MILLION) * step, method, |t, y| {
        let (q, v) = split::<M>(y);
        let now = residuals(t, &q, &v);
        largest = [largest[0].max(now[0].abs()), largest[1].max(now[1].abs())];
        if count % INTERVAL == 0 {
            points.push((t, energy(t, y) - first));
        }
        count += 1;
    })
    .expect("converges");
    assert_eq!(count, MILLION + 1);
    let energy = line(&points);
    println!("{}, h = {step}: {energy:?}, residuals {largest:?}", method.name());
    Seen { energy, residuals: largest }
}

fn largest<const K: usize>(values: [f64; K]) -> f64 {
    values.into_iter().fold(0.0, |largest, value| largest.max(value.abs()))
}

#[test]
fn a_rod_keeps_its_length_its_energy_and_its_angular_momentum() {
    fn check(method: &impl Method<Sphere>, step: f64, energy: f64) {
        let (sphere, moment) = (Sphere::default(), |y: &[f64; 6]| y[0] * y[4] - y[1] * y[3]);
        let mut turned = 0.0_f64;
        let residuals = |t: f64, q: &[f64; 3], v: &[f64; 3]| {
            [largest(sphere.constraints(t, q, v)), largest(sphere.constraint_velocity(t, q, v))]
        };
        watched(&sphere, SPHERE, step, method, residuals).check(energy, 4e-15, 4e-14);
        integrate(&sphere, 0.0, SPHERE, f64::from(MILLION) * step, method, |_, y| {
            turned = turned.max((moment(y) / moment(&SPHERE) - 1.0).abs());
        })
        .expect("converges");
        println!("{}: angular momentum {turned:e}", method.name());
        assert!(turned < 1e-12, "{turned:e}");
    }
    check(&Variational { step: 0.02 }, 0.02, 1e-5);
    check(&StormerVerlet { step: 0.01 }, 0.01, 5e-3);
    check(&SymplecticEuler { step: 0.005 }, 0.005, 0.5);
}

#[test]
fn two_rods_keep_their_lengths_and_their_energy() {
    let rods = TwoRods::default();
    let residuals = |t: f64, q: &[f64; 4], v: &[f64; 4]| {
        [largest(rods.constraints(t, q, v)), largest(rods.constraint_velocity(t, q, v))]
    };
    watched(&rods, RODS, 0.01, &Variational { step: 0.01 }, residuals).check(1e-5, 4e-15, 4e-14);
    watched(&rods, RODS, 0.005, &StormerVerlet { step: 0.005 }, residuals).check(2e-2, 4e-15, 4e-14);
}

/// A callback for every step.
type Observe<'a, const N: usize> = &'a mut dyn FnMut(f64, &[f64; N]);

/// These states are projected after each step.
#[test]
fn gauss_methods_stay_on_constraints_by_projection() {
    let (rods, end) = (TwoRods::default(), 1000.0);
    let energy = |y: &[f64; 8]| {
        let (q, v) = split::<TwoRods>(y);
        rods.energy(0.0, &q, &v)
    };
    let check = |method: &dyn Fn(Observe<'_, 8>), bound: f64| {
        let (mut residual, mut error) = (0.0_f64, 0.0_f64);
        method(&mut |t, y| {
            let (q, v) = split::<TwoRods>(y);
            residual = residual.max(largest(rods.constraints(t, &q, &v)));
            residual = residual.max(largest(rods.constraint_velocity(t, &q, &v)));
            error = error.max((energy(y) - energy(&RODS)).abs());
        });
        println!("residual {residual:e}, energy {error:e}");
        assert!(residual < 1e-12 && error < bound, "{residual:e} {error:e}");
    };
    let step = 0.01;
    check(
        &|see| {
            integrate(&rods, 0.0, RODS, end, &GaussLegendre4 { step }, see).expect("converges");
        },
        1e-4,
    );
    check(
        &|see| {
            integrate(&rods, 0.0, RODS, end, &GaussLegendre6 { step }, see).expect("converges");
        },
        1e-8,
    );
}

#[test]
fn a_skate_on_a_slope_follows_a_cycloid() {
    let (skate, turn) = (Skate::default(), 2.0);
    let start = [0.0, 0.0, 0.0, 0.0, 0.0, turn];
    let residuals = |t: f64, q: &[f64; 3], v: &[f64; 3]| [0.0, largest(skate.constraint_velocity(t, q, v))];
    // The angle grows to twenty thousand, and is rounded.
    let rounding = f64::from(MILLION) * 0.01 * turn * f64::EPSILON;
    watched(&skate, start, 0.01, &Variational { step: 0.01 }, residuals).check(1e-8, 1e-300, 4.0 * rounding);
    let end = 100.0;
    let reached = integrate(&skate, 0.0, start, end, &Variational { step: 0.01 }, |_, _| {});
    let [x, y, ..] = reached.expect("converges");
    let (radius, angle) = (skate.fall / (2.0 * turn * turn), turn * end);
    let (wanted_x, wanted_y) = (radius * angle.sin().powi(2), radius * (angle - 0.5 * (2.0 * angle).sin()));
    println!("skate: {:e} {:e}", x - wanted_x, y - wanted_y);
    assert!((x - wanted_x).abs() < 1e-6 && (y - wanted_y).abs() < 1e-6, "{x} {wanted_x}, {y} {wanted_y}");
}

/// In the frame of the wire the bead oscillates.
#[test]
fn a_bead_on_a_turning_wire_oscillates_for_ever() {
    let wire = Wire::default();
    let frequency = (wire.k - wire.rate * wire.rate).sqrt();
    let (start, end) = ([0.5, 0.0, 0.0, 0.5 * wire.rate], 1000.0);
    let check = |method: &dyn Fn(Observe<'_, 4>), bound: f64| {
        let (mut error, mut residual) = (0.0_f64, 0.0_f64);
        method(&mut |t, y| {
            let (q, v) = ([y[0], y[1]], [y[2], y[3]]);
            let amplitude = (y[0] * y[0] + y[1] * y[1]).sqrt();
            error = error.max((amplitude - 0.5 * (frequency * t).cos().abs()).abs());
            residual = residual.max(largest(wire.constraints(t, &q, &v)));
        });
        println!("wire: {error:e}, residual {residual:e}");
        // Time, and with it the angle of the wire, is rounded.
        assert!(error < bound && residual < end * wire.rate * f64::EPSILON, "{error:e} {residual:e}");
    };
    check(
        &|see| {
            integrate(&wire, 0.0, start, end, &Variational { step: 0.01 }, see).expect("converges");
        },
        1e-5,
    );
    check(
        &|see| {
            integrate(&wire, 0.0, start, end, &StormerVerlet { step: 0.001 }, see).expect("converges");
        },
        2e-3,
    );
}

/// Multipliers are tensions, and methods that do not return them do not affect them.
#[test]
fn the_tension_of_the_rod_follows_from_the_motion() {
    let sphere = Sphere::default();
    let end =
        integrate(&sphere, 0.0, SPHERE, 100.0, &Variational { step: 0.01 }, |_, _| {}).expect("converges");
    let (q, v) = split::<Sphere>(&end);
    let [multiplier] = sphere.multipliers(100.0, &q, &v);
    let speed: f64 = v.iter().map(|v| v * v).sum();
    // The gradient of the constraint is twice the position.
    assert!((2.0 * multiplier + speed - sphere.g * q[2]).abs() < 1e-12, "{multiplier}");
    let momenta = CanonicalSystem::momenta(&sphere, 100.0, &q, &v);
    assert_eq!(momenta, v);
}
