//! The laws of plane motion for random bodies, each verified in an independent way.

use super::{Motion, cross, difference, norm_squared, sum, turned};

/// Number of random motions for each law.
const TRIALS: u64 = 200;

/// Knuth's generator of 64 bits with the constants of MMIX. The upper half of its state is random
/// enough for places.
struct Random(u64);

impl Random {
    /// Returns a number in [−2, 2).
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) as f64 / f64::from(u32::MAX) * 4.0 - 2.0
    }

    fn vector(&mut self) -> [f64; 2] {
        [self.number(), self.number()]
    }

    fn motion(&mut self) -> Motion<f64> {
        Motion {
            mass: 2.5 + self.number(),
            inertia: 2.5 + self.number(),
            centroid: self.vector(),
            center: self.vector(),
            angle: self.number(),
            velocity: self.vector(),
            angular_velocity: self.number(),
            acceleration: self.vector(),
            angular_acceleration: self.number(),
        }
    }
}

/// Returns random motions, each with a source of more random numbers.
fn motions() -> impl Iterator<Item = (Motion<f64>, Random)> {
    (0..TRIALS).map(|seed| {
        let mut random = Random(seed);
        // The first numbers of neighbouring seeds are similar.
        random.motion();
        (random.motion(), random)
    })
}

/// Returns the motion a short time later, with constant accelerations.
fn later(motion: &Motion<f64>, time: f64) -> Motion<f64> {
    let advanced = |x: f64, v: f64, a: f64| x + time * (v + 0.5 * time * a);
    let Motion { center, velocity, acceleration, angle, angular_velocity, angular_acceleration, .. } =
        *motion;
    Motion {
        center: [0, 1].map(|i| advanced(center[i], velocity[i], acceleration[i])),
        velocity: [0, 1].map(|i| velocity[i] + time * acceleration[i]),
        angle: advanced(angle, angular_velocity, angular_acceleration),
        angular_velocity: angular_velocity + time * angular_acceleration,
        ..*motion
    }
}

/// Computes the rate of a function of time, by differences of sixth order.
fn rate(f: impl Fn(f64) -> f64) -> f64 {
    const STEP: f64 = 1e-3;
    let odd = |k: f64| f(k * STEP) - f(-k * STEP);
    (45.0 * odd(1.0) - 9.0 * odd(2.0) + odd(3.0)) / (60.0 * STEP)
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(error <= tolerance * expected.abs().max(1.0), "{found} is not {expected}");
}

#[track_caller]
fn assert_vectors_near(found: [f64; 2], expected: [f64; 2], tolerance: f64) {
    let scale = norm_squared(expected).sqrt().max(1.0);
    let error = norm_squared(difference(found, expected)).sqrt();
    assert!(error <= tolerance * scale, "{found:?} is not {expected:?}");
}

#[test]
fn velocities_and_accelerations_are_rates_of_positions() {
    for (motion, mut random) in motions() {
        let own = random.vector();
        let velocity = [0, 1].map(|i| rate(|t| later(&motion, t).point(own)[i]));
        let acceleration = [0, 1].map(|i| rate(|t| later(&motion, t).velocity_at(own)[i]));
        assert_vectors_near(motion.velocity_at(own), velocity, 1e-11);
        assert_vectors_near(motion.acceleration_at(own).total(), acceleration, 1e-11);
    }
}

#[test]
fn velocity_of_a_point_is_the_same_from_any_reference_point() {
    for (motion, mut random) in motions() {
        let (own, reference) = (random.vector(), random.vector());
        let rho = difference(motion.point(own), motion.point(reference));
        let [carried, about] = motion.velocity_from(own, reference);
        let omega = motion.angular_velocity;
        assert_vectors_near(about, [-omega * rho[1], omega * rho[0]], 1e-14);
        assert_vectors_near(sum(carried, about), motion.velocity_at(own), 1e-14);
    }
}

/// Computes ω from the velocities of two points of a body alone: (ρ × (v_Q − v_P))_z / ρ².
fn angular_velocity_between(motion: &Motion<f64>, p: [f64; 2], q: [f64; 2]) -> f64 {
    let rho = difference(motion.point(q), motion.point(p));
    cross(rho, difference(motion.velocity_at(q), motion.velocity_at(p))) / norm_squared(rho)
}

#[test]
fn angular_velocity_does_not_depend_on_the_reference_point() {
    for (motion, mut random) in motions() {
        let q = random.vector();
        let far = |p: [f64; 2]| [p[0] + 5.0, p[1]];
        for p in [far(random.vector()), far(random.vector())] {
            assert_near(angular_velocity_between(&motion, p, q), motion.angular_velocity, 1e-13);
        }
    }
}

#[test]
fn acceleration_is_that_of_the_reference_point_and_a_tangential_and_a_radial_part() {
    for (motion, mut random) in motions() {
        let (own, reference) = (random.vector(), random.vector());
        let rho = difference(motion.point(own), motion.point(reference));
        let parts = motion.acceleration_from(own, reference);
        assert_vectors_near(parts.reference, motion.acceleration_at(reference).total(), 1e-14);
        let omega = motion.angular_velocity;
        assert_near(cross(rho, parts.tangential), motion.angular_acceleration * norm_squared(rho), 1e-13);
        assert_near(rho[0] * parts.tangential[0] + rho[1] * parts.tangential[1], 0.0, 1e-13);
        assert_vectors_near(parts.radial, rho.map(|component| -omega * omega * component), 1e-13);
        assert_vectors_near(parts.total(), motion.acceleration_at(own).total(), 1e-13);
    }
}

#[test]
fn instantaneous_centre_has_no_velocity() {
    for (motion, _) in motions() {
        let (center, own) = (motion.instant_center().unwrap(), motion.own_instant_center().unwrap());
        let distance = norm_squared(difference(center, motion.center)).sqrt().max(1.0);
        assert_vectors_near(motion.velocity_at(own), [0.0; 2], 1e-14 * distance);
        assert_vectors_near(motion.point(own), center, 1e-14);
        assert_vectors_near(motion.own(center), own, 1e-14);
    }
}

/// Returns the intersection of the normals to the velocities of two points, by Cramer's rule on (r
/// − r_P)·v_P = 0 = (r − r_Q)·v_Q.
fn meeting_point(motion: &Motion<f64>, p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    let (v, w) = (motion.velocity_at(p), motion.velocity_at(q));
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let (b, c) = (dot(motion.point(p), v), dot(motion.point(q), w));
    let determinant = cross(v, w);
    [(b * w[1] - c * v[1]) / determinant, (v[0] * c - w[0] * b) / determinant]
}

#[test]
fn normals_to_two_velocities_meet_in_the_instantaneous_centre() {
    let mut compared = 0;
    for (motion, mut random) in motions() {
        let (p, q) = (random.vector(), random.vector());
        let angle = cross(motion.velocity_at(p), motion.velocity_at(q));
        // Points that are nearly collinear with the centre do not determine it.
        if angle.abs() > 0.1 {
            assert_vectors_near(meeting_point(&motion, p, q), motion.instant_center().unwrap(), 1e-12);
            compared += 1;
        }
    }
    assert!(compared > TRIALS / 2, "only {compared}");
}

#[test]
fn pure_translation_has_no_instantaneous_centre() {
    for (motion, mut random) in motions() {
        let shifted = Motion { angular_velocity: 0.0, ..motion };
        assert_eq!(shifted.instant_center(), None);
        assert_eq!(shifted.own_instant_center(), None);
        assert_eq!(shifted.velocity_at(random.vector()), motion.velocity);
        let at_rest = Motion { velocity: [0.0; 2], ..shifted };
        assert_eq!(at_rest.instant_center(), None);
    }
}

#[test]
fn motions_without_rotation_or_values_have_no_centre() {
    let (motion, _) = motions().next().unwrap();
    for omega in [f64::MIN_POSITIVE * 1e-10, f64::NAN] {
        assert_eq!(Motion { angular_velocity: omega, ..motion }.instant_center(), None);
    }
    let lost = Motion { velocity: [f64::NAN, 0.0], ..motion };
    assert_eq!(lost.instant_center(), None);
    assert_eq!(Motion { angle: f64::NAN, ..motion }.own_instant_center(), None);
}

/// L_O = m r_P × v_S + m ρ_S × v_P + J_P ω for any point P of the body, with the origin O.
#[test]
fn angular_momentum_has_three_parts_from_any_reference_point() {
    for (motion, mut random) in motions() {
        let p = random.vector();
        let rho = difference(motion.center, motion.point(p));
        let parts = motion.mass * cross(motion.point(p), motion.velocity)
            + motion.mass * cross(rho, motion.velocity_at(p))
            + motion.inertia_about(p) * motion.angular_velocity;
        assert_near(motion.angular_momentum([0.0; 2]), parts, 1e-13);
    }
}

/// Creates a body of four point masses, with momenta, energy and moment of inertia as sums.
fn points_of(motion: &mut Motion<f64>, random: &mut Random) -> [(f64, [f64; 2]); 4] {
    let points = [(); 4].map(|()| (2.5 + random.number(), random.vector()));
    motion.mass = points.iter().map(|(mass, _)| mass).sum();
    motion.centroid =
        [0, 1].map(|i| points.iter().map(|(mass, place)| mass * place[i]).sum::<f64>() / motion.mass);
    let about_center =
        |(mass, place): &(f64, [f64; 2])| mass * norm_squared(difference(*place, motion.centroid));
    motion.inertia = points.iter().map(about_center).sum();
    points
}

#[test]
fn momenta_energy_and_moments_are_those_of_the_points_of_mass() {
    for (mut motion, mut random) in motions() {
        let points = points_of(&mut motion, &mut random);
        let total = |f: &dyn Fn(f64, [f64; 2]) -> f64| points.iter().map(|(m, own)| f(*m, *own)).sum::<f64>();
        let (about, p) = (random.vector(), random.vector());
        let momentum = [0, 1].map(|i| total(&|m, own| m * motion.velocity_at(own)[i]));
        assert_vectors_near(motion.linear_momentum(), momentum, 1e-13);
        let spin = total(&|m, own| m * cross(difference(motion.point(own), about), motion.velocity_at(own)));
        assert_near(motion.angular_momentum(about), spin, 1e-12);
        let energy = total(&|m, own| 0.5 * m * norm_squared(motion.velocity_at(own)));
        assert_near(motion.kinetic_energy(), energy, 1e-13);
        assert_near(motion.inertia_about(p), total(&|m, own| m * norm_squared(difference(own, p))), 1e-13);
        // The axiom: the forces m a of the points have this moment about P.
        let moment = total(&|m, own| {
            let arm = difference(motion.point(own), motion.point(p));
            m * cross(arm, motion.acceleration_at(own).total())
        });
        assert_near(motion.moment_about(p), moment, 1e-12);
    }
}

#[test]
fn moment_about_the_centre_of_mass_and_a_fixed_point_are_the_two_special_cases() {
    for (motion, mut random) in motions() {
        let about_center = motion.moment_about(motion.centroid);
        assert_eq!(about_center, motion.inertia * motion.angular_acceleration);
        // A body that rotates about its point P, which is at rest.
        let p = random.vector();
        let rho = motion.vector(difference(motion.centroid, p));
        let (omega, rate) = (motion.angular_velocity, motion.angular_acceleration);
        let turn = turned(rho);
        let fixed = Motion {
            velocity: turn.map(|component| omega * component),
            acceleration: [0, 1].map(|i| rate * turn[i] - omega * omega * rho[i]),
            ..motion
        };
        assert_near(fixed.moment_about(p), fixed.inertia_about(p) * rate, 1e-13);
    }
}

#[test]
fn inertia_is_least_about_the_centre_of_mass() {
    for (motion, mut random) in motions() {
        assert_eq!(motion.inertia_about(motion.centroid), motion.inertia);
        assert!(motion.inertia_about(random.vector()) > motion.inertia);
    }
}

/// A step ladder has two halves of length L = 2, hinged at the top. Its left foot is at the origin,
/// its right foot on the floor. The right half rotates about (2 L cos φ, 2 L sin φ).
#[test]
fn instantaneous_centre_of_a_ladder_is_on_a_circle_of_twice_its_length() {
    const LENGTH: f64 = 2.0;
    for step in 1..10 {
        let (phi, rate) = (0.15 * f64::from(step), -0.7);
        let (sin, cos) = phi.sin_cos();
        let right_half = Motion {
            mass: 1.0,
            inertia: LENGTH * LENGTH / 12.0,
            centroid: [0.0; 2],
            center: [1.5 * LENGTH * cos, 0.5 * LENGTH * sin],
            angle: -phi,
            velocity: [-1.5 * LENGTH * sin * rate, 0.5 * LENGTH * cos * rate],
            angular_velocity: -rate,
            acceleration: [0.0; 2],
            angular_acceleration: 0.0,
        };
        let center = right_half.instant_center().unwrap();
        assert_vectors_near(center, [2.0 * LENGTH * cos, 2.0 * LENGTH * sin], 1e-14);
        assert_near(norm_squared(center).sqrt(), 2.0 * LENGTH, 1e-14);
    }
}

#[test]
fn motion_is_generic_over_numbers() {
    let wheel = Motion::<f32> {
        mass: 2.0,
        inertia: 0.25,
        centroid: [0.0; 2],
        center: [3.0, 0.5],
        angle: 0.0,
        velocity: [1.0, 0.0],
        angular_velocity: -2.0,
        acceleration: [0.0; 2],
        angular_acceleration: 0.0,
    };
    assert_eq!(wheel.instant_center(), Some([3.0, 0.0]));
}
