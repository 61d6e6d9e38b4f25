//! The laws of motion in space for random bodies, each verified in an independent way.

use super::{SpatialMotion, Triple, cross, difference, dot, multiple, sum};

/// Number of random motions for each law.
const TRIALS: u64 = 100;

/// Knuth's generator of 64 bits with the constants of MMIX. The upper half of its state is random
/// enough for places.
struct Random(u64);

impl Random {
    /// Returns a number in [−2, 2).
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) as f64 / f64::from(u32::MAX) * 4.0 - 2.0
    }

    fn vector(&mut self) -> Triple<f64> {
        [self.number(), self.number(), self.number()]
    }

    /// Draws a body of eight equal point masses, with their positions in body coordinates.
    fn body(&mut self) -> (SpatialMotion<f64>, [Triple<f64>; 8]) {
        let points = [(); 8].map(|()| self.vector());
        let weigh = |f: &dyn Fn(Triple<f64>) -> f64| points.iter().map(|&point| f(point)).sum::<f64>();
        let centroid = [0, 1, 2].map(|i| weigh(&|point| point[i]) / 8.0);
        let about = |point| difference(&point, &centroid);
        let entry = |i: usize, j: usize| {
            let square = |arm: Triple<f64>| if i == j { dot(&arm, &arm) } else { 0.0 };
            weigh(&|point| square(about(point)) - about(point)[i] * about(point)[j])
        };
        let motion = SpatialMotion {
            mass: 8.0,
            inertia: [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j))),
            centroid,
            center: self.vector(),
            rotation: turned(self.vector(), IDENTITY),
            velocity: self.vector(),
            angular_velocity: self.vector(),
            acceleration: self.vector(),
            angular_acceleration: self.vector(),
        };
        (motion, points)
    }
}

const IDENTITY: [Triple<f64>; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Returns a rotation followed by another one about a vector, by an angle equal to its length
/// (Rodrigues).
fn turned(by: Triple<f64>, rotation: [Triple<f64>; 3]) -> [Triple<f64>; 3] {
    let angle = dot(&by, &by).sqrt();
    if angle == 0.0 {
        return rotation;
    }
    let axis = multiple(1.0 / angle, &by);
    let turn = |a: Triple<f64>| {
        let across = sum(multiple(angle.cos(), &a), multiple(angle.sin(), &cross(&axis, &a)));
        sum(across, multiple((1.0 - angle.cos()) * dot(&axis, &a), &axis))
    };
    let columns = [0, 1, 2].map(|j| turn([0, 1, 2].map(|i| rotation[i][j])));
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| columns[j][i]))
}

/// Returns the motion a short time later, with constant accelerations; exact to first order.
fn later(motion: &SpatialMotion<f64>, time: f64) -> SpatialMotion<f64> {
    let gained = |v: Triple<f64>, a: Triple<f64>| sum(v, multiple(time, &a));
    let half = |v: Triple<f64>, a: Triple<f64>| multiple(time, &sum(v, multiple(0.5 * time, &a)));
    let spin = half(motion.angular_velocity, motion.angular_acceleration);
    SpatialMotion {
        center: sum(motion.center, half(motion.velocity, motion.acceleration)),
        rotation: turned(spin, motion.rotation),
        velocity: gained(motion.velocity, motion.acceleration),
        angular_velocity: gained(motion.angular_velocity, motion.angular_acceleration),
        ..*motion
    }
}

/// Computes the rate of a function of time, by differences of sixth order.
fn rate(f: impl Fn(f64) -> Triple<f64>) -> Triple<f64> {
    const STEP: f64 = 1e-3;
    let odd = |k: f64| difference(&f(k * STEP), &f(-k * STEP));
    let weighed = sum(multiple(45.0, &odd(1.0)), difference(&odd(3.0), &multiple(9.0, &odd(2.0))));
    multiple(1.0 / (60.0 * STEP), &weighed)
}

#[track_caller]
fn assert_near(found: Triple<f64>, expected: Triple<f64>, tolerance: f64) {
    let scale = dot(&expected, &expected).sqrt().max(1.0);
    let error = difference(&found, &expected);
    assert!(dot(&error, &error).sqrt() <= tolerance * scale, "{found:?} is not {expected:?}");
}

fn bodies() -> impl Iterator<Item = (SpatialMotion<f64>, [Triple<f64>; 8], Random)> {
    (0..TRIALS).map(|seed| {
        let mut random = Random(seed);
        // The first numbers of neighbouring seeds are similar.
        random.body();
        let (motion, points) = random.body();
        (motion, points, random)
    })
}

#[test]
fn velocities_and_accelerations_are_rates_of_positions() {
    for (motion, _, mut random) in bodies() {
        let own = random.vector();
        let velocity = rate(|t| later(&motion, t).point(own));
        let acceleration = rate(|t| later(&motion, t).velocity_of(own));
        assert_near(motion.velocity_of(own), velocity, 1e-11);
        assert_near(motion.acceleration_of(own), acceleration, 1e-11);
    }
}

#[test]
fn own_components_are_those_along_the_axes_of_the_body() {
    for (motion, _, mut random) in bodies() {
        let vector = random.vector();
        let axes = IDENTITY.map(|axis| motion.vector(axis));
        assert_near(motion.to_body(vector), axes.map(|axis| dot(&axis, &vector)), 1e-14);
        assert_near(motion.vector(motion.to_body(vector)), vector, 1e-14);
        assert_eq!(motion.point(motion.centroid), motion.center);
    }
}

#[test]
fn momenta_and_energy_are_those_of_the_point_masses() {
    for (motion, points, mut random) in bodies() {
        let (place, mut linear, mut angular, mut energy) = (random.vector(), [0.0; 3], [0.0; 3], 0.0);
        for point in points {
            let velocity = motion.velocity_of(point);
            linear = sum(linear, velocity);
            angular = sum(angular, cross(&difference(&motion.point(point), &place), &velocity));
            energy += 0.5 * dot(&velocity, &velocity);
        }
        assert_near(motion.linear_momentum(), linear, 1e-13);
        assert_near(motion.angular_momentum_about(place), angular, 1e-12);
        let carried = cross(&place, &linear);
        assert_near(
            difference(&motion.angular_momentum(), &motion.angular_momentum_about(place)),
            carried,
            1e-12,
        );
        assert!((motion.kinetic_energy() - energy).abs() <= 1e-13 * energy);
    }
}
