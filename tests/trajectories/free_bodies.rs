//! Bodies in free flight over a million steps: momenta and energy change only by rounding, and
//! quaternions keep unit length.

use lagrange::integrate::{RungeKutta4, integrate};

lagrange::system! {
    /// A body in free flight with an arm on a ball joint and a wheel on an axle.
    #[derive(Clone, Debug)]
    struct Flyer;

    param tensor = 0.6;
    gravity = (0, 0, 0);
    body trunk { mass: 3; centroid: (0.1, -0.2, 0.05); inertia: (0.5, tensor, 0.4, 0.02, -0.05, 0.1); }
    body arm { mass: 1.5; centroid: (0.3, 0, 0.1); inertia: (0.1, 0.2, 0.15, 0.01, 0.02, -0.03); }
    body wheel { mass: 0.8; centroid: (0.05, 0, 0.1); inertia: (0.05, 0.05, 0.08); }
    free trunk;
    ball shoulder = trunk to arm { at: (0.4, 0.1, -0.3); turned: (0.3, -0.4, 0.5); }
    revolute axle = trunk to wheel { at: (-0.2, 0.3, 0.1); axis: (2, 3, -6); }
    output p = linear_momentum(trunk) + linear_momentum(arm) + linear_momentum(wheel);
    output l = angular_momentum(trunk) + angular_momentum(arm) + angular_momentum(wheel);
}

type State = [f64; 22];

const STEPS: u32 = 1_000_000;
/// Small enough that the accumulated error of the method, a few 1e-15, is less than rounding.
const STEP: f64 = 1.0 / 4096.0;
/// One in this many states is recorded.
const INTERVAL: u32 = 1009;
/// Relative error of rounding to the nearest number.
const ROUNDING: f64 = f64::EPSILON / 2.0;
const TRUNK: usize = 3;
const SHOULDER: usize = 7;
const START: State = [
    0.1, -0.2, 0.3, 0.6, 0.0, -0.8, 0.0, 0.5, -0.5, 0.5, 0.5, 0.25, // positions
    0.02, -0.09, -0.03, 0.5, -0.3, 0.7, -0.4, 0.9, 0.2, -0.6, // velocities
];

/// Observations along a long motion, with energies and momenta as differences from the first ones.
struct Seen {
    energies: Vec<(f64, f64)>,
    /// The largest change of the linear and of the angular momentum.
    momenta: [f64; 2],
    end: State,
}

impl Seen {
    fn largest_energy(&self) -> f64 {
        self.energies.iter().fold(0.0, |largest, point| largest.max(point.1.abs()))
    }
}

fn halves(y: &State) -> ([f64; 12], [f64; 10]) {
    lagrange::system::split::<Flyer>(y)
}

/// Returns the first energy, and the initial magnitudes of the momenta.
fn sizes() -> (f64, [f64; 2]) {
    let (flyer, (q, v)) = (Flyer::default(), halves(&START));
    let size = |vector: [f64; 3]| vector.iter().fold(0.0_f64, |sum, x| sum.hypot(*x));
    (flyer.energy(0.0, &q, &v), [size(flyer.p(0.0, &q, &v)), size(flyer.l(0.0, &q, &v))])
}

/// Follows the motion of a system, and records energies and momenta.
fn follow(moving: &Flyer, steps: u32, step: f64) -> Seen {
    let flyer = Flyer::default();
    let measured = |y: &State| {
        let (q, v) = halves(y);
        (flyer.energy(0.0, &q, &v), [flyer.p(0.0, &q, &v), flyer.l(0.0, &q, &v)])
    };
    let (energy, first) = measured(&START);
    let (mut count, mut energies, mut momenta) = (0, Vec::new(), [0.0_f64; 2]);
    let end = integrate(moving, 0.0, START, f64::from(steps) * step, &RungeKutta4 { step }, |t, y| {
        if count % INTERVAL == 0 {
            let (now, vectors) = measured(y);
            energies.push((t, now - energy));
            for ((largest, vector), first) in momenta.iter_mut().zip(vectors).zip(first) {
                vector.iter().zip(first).for_each(|(x, y)| *largest = largest.max((x - y).abs()));
            }
        }
        count += 1;
    })
    .expect("a finite motion");
    assert_eq!(count, steps + 1);
    Seen { energies, momenta, end }
}

/// Returns the change of a fitted line over the whole time, beside the bound for a random walk with
/// the same increments. For a walk of n increments with variance s², the change of the line has the
/// variance 6/5 n s². Three times its root is exceeded once in four hundred walks.
fn trend(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let [time, value] =
        [0, 1].map(|k| points.iter().map(|p| if k == 0 { p.0 } else { p.1 }).sum::<f64>() / count);
    let spread: f64 = points.iter().map(|p| (p.0 - time).powi(2)).sum();
    let slope = points.iter().map(|p| (p.0 - time) * (p.1 - value)).sum::<f64>() / spread;
    let changes: f64 = points.windows(2).map(|pair| (pair[1].1 - pair[0].1).powi(2)).sum();
    let duration = points[points.len() - 1].0 - points[0].0;
    ((slope * duration).abs(), 3.0 * (1.2 * changes).sqrt())
}

fn length(quaternion: &[f64]) -> f64 {
    quaternion.iter().map(|component| component * component).sum::<f64>().sqrt()
}

/// Returns the size of a random walk after some steps. Each step rounds the velocities, and with
/// them the conserved quantities, by about one rounding to either side: √n of them after n steps.
fn walk(steps: u32) -> f64 {
    f64::from(steps).sqrt() * ROUNDING
}

#[test]
fn a_million_steps_keep_momenta_and_energy_to_rounding() {
    let seen = follow(&Flyer::default(), STEPS, STEP);
    let (energy, momenta) = sizes();
    let bound = 4.0 * walk(STEPS);
    let (change, most) = trend(&seen.energies);
    let largest = seen.largest_energy();
    println!("momenta {:?} of {momenta:?}, energy {largest:e} of {energy}", seen.momenta);
    println!("trend {change:e} of {most:e}, bound {bound:e}");
    assert!(seen.momenta.iter().zip(momenta).all(|(change, size)| *change < bound * size.max(1.0)));
    assert!(largest < bound * energy, "{largest:e}");
    assert!(change < most && most < bound * energy, "{change:e} of {most:e}");
    for first in [TRUNK, SHOULDER] {
        let error = (length(&seen.end[first..first + 4]) - 1.0).abs();
        assert!(error <= 2.0 * f64::EPSILON, "{error:e}");
    }
}

#[test]
fn a_body_that_is_a_little_different_does_not_keep_them() {
    let seen = follow(&Flyer { tensor: 0.6 * (1.0 + 1e-6) }, 20_000, STEP);
    let largest = seen.largest_energy();
    println!("other body: momenta {:?}, energy {largest:e}", seen.momenta);
    assert!(seen.momenta[1] > 1e-8 && largest > 1e-8, "{:?}, {largest:e}", seen.momenta);
}

/// With sixty-four times the step, the loss of the method has a slope. In a tenth of the steps it
/// exceeds all rounding.
#[test]
fn a_trend_of_the_energy_is_seen() {
    let seen = follow(&Flyer::default(), STEPS / 10, 64.0 * STEP);
    let ((change, _), bound) = (trend(&seen.energies), 4.0 * walk(STEPS) * sizes().0);
    println!("coarse: trend {change:e} beside {bound:e}");
    assert!(change > 10.0 * bound, "{change:e} of {bound:e}");
}
