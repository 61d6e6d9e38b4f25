//! Systems without an operating system and without a heap.
#![no_std]
#![forbid(unsafe_code)]

use lagrange::integrate::{RungeKutta4, integrate};
use lagrange::scene::{Item, LoadOrigin, Scene};
use lagrange::{Number, Scalar};

lagrange::system! {
    /// A point mass on a massless rod.
    #[derive(Clone, Copy, Debug)]
    pub struct Pendulum;

    param m = 1.0, l = 1.0, g = 9.81;
    coord theta;
    kinetic = 1/2 * m * (l * dot(theta))^2;
    potential = -m * g * l * cos(theta);
}

lagrange::system! {
    /// A pendulum in single precision, as on a microcontroller.
    #[scalar(f32)]
    #[derive(Clone, Copy, Debug)]
    pub struct SmallPendulum;

    param m = 1.0, l = 1.0, g = 9.81;
    coord theta;
    kinetic = 1/2 * m * (l * dot(theta))^2;
    potential = -m * g * l * cos(theta);
}

lagrange::system! {
    /// Two masses and a hardening spring, in any number type.
    #[derive(Clone, Copy, Debug)]
    pub struct Chain<S>;

    param m = 1.0, k = 2.5;
    coord x1, x2;
    let stretch = hypot(x2 - x1, 1/10) - exp(0 * m);
    kinetic = 1/2 * m * (dot(x1)^2 + dot(x2)^2);
    potential = spring_energy(k, stretch);
    output tension = k * stretch;
}

lagrange::system! {
    /// A double pendulum in single precision, optimised for speed.
    #[scalar(f32)]
    #[accuracy(fast)]
    #[derive(Clone, Copy, Debug)]
    pub struct FastDoublePendulum;

    param l = 1.0, g = 9.81;
    coord a, b;
    let (xa, ya) = (l * sin(a), -l * cos(a));
    let (xb, yb) = (xa + l * sin(b), ya - l * cos(b));
    kinetic = 1/2 * (dot(xa)^2 + dot(ya)^2 + dot(xb)^2 + dot(yb)^2);
    potential = g * (ya + yb);
}

lagrange::system! {
    /// A parcel on a rail that drops onto the ground.
    #[derive(Clone, Copy, Debug)]
    pub struct Parcel;

    param g = 9.81, mu = 0.3;
    coord x, y, z;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    potential = g * y;
    constraint rail = z - sin(x);
    event ground = y, falling => impact(1/2);
    friction rub = dot(x), mu * ground;
}

lagrange::system! {
    /// A rod pinned to the ground, in single precision.
    #[scalar(f32)]
    #[derive(Clone, Copy, Debug)]
    pub struct Beam;

    param m = 2.0, l = 1.0;
    coord x, y, a;
    gravity = (0, -9.81);
    body rod { mass: m; shape: slender_rod(l); center: (x, y); angle: a; }
    pin hinge = rod.point(-l / 2, 0) to (0, 0);
    emit { motion, drawing, system_matrix }
}

/// Returns the height of a road.
fn road<S: Scalar>(x: S) -> S {
    x.sin()
}

fn road_derivative<S: Scalar>(x: S) -> S {
    x.cos()
}

fn road_second_derivative<S: Scalar>(x: S) -> S {
    -x.sin()
}

lagrange::system! {
    /// A wheel on a road of the crate, driven by a motor from a table, in any number type.
    #[derive(Clone, Copy, Debug)]
    pub struct Wheel<S>;

    function road(x);
    table motor(rate) = [(0, 9), (100, 14), (200, 6)], interpolation: monotone, outside: clamp;
    param m = 3.0, g = 9.81;
    coord x;
    kinetic = kinetic_energy(m, dot((x, road(x))));
    potential = m * g * road(x);
    force x = motor(dot(x));
}

/// Returns the acceleration of a wheel at rest at the foot of its road.
#[must_use]
pub fn start<S: Scalar>(wheel: &Wheel<S>) -> S {
    let [acceleration] = wheel.acceleration(S::ZERO, &[S::ZERO], &[S::ZERO]);
    acceleration
}

/// Returns the force with which the ground holds a rod at rest at an angle.
#[must_use]
pub fn grip(beam: &Beam, angle: f32) -> f32 {
    let (sin, cos) = Number::sin_cos(angle);
    let mut grip = 0.0;
    beam.items(0.0, &[0.5 * beam.l * cos, 0.5 * beam.l * sin, angle], &[0.0; 3], &mut |item| {
        if let Item::Force { cause: LoadOrigin::Joint, force: [x, y], .. } = item {
            grip = Number::hypot(x, y);
        }
    });
    grip
}

/// Returns the state of a parcel some seconds after a throw, or `None` if its motion cannot be
/// computed.
#[must_use]
pub fn thrown(parcel: &Parcel, state: [f64; 6], seconds: f64) -> Option<[f64; 6]> {
    integrate(parcel, 0.0, state, seconds, &RungeKutta4 { step: 5e-3 }, |_, _| {}).ok()
}

/// Returns the angle of a pendulum one second after rest at an angle, or `None` if its motion
/// cannot be computed.
#[must_use]
pub fn angle_after_a_second(pendulum: &Pendulum, angle: f64) -> Option<f64> {
    let method = RungeKutta4 { step: 5e-3 };
    integrate(pendulum, 0.0, [angle, 0.0], 1.0, &method, |_, _| {}).ok().map(|[theta, _]| theta)
}

/// Returns the relative acceleration of two masses at rest at a distance.
#[must_use]
pub fn repulsion<S: Scalar>(chain: &Chain<S>, distance: S) -> S {
    let [first, second] = chain.acceleration(S::ZERO, &[S::ZERO, distance], &[S::ZERO; 2]);
    second - first
}

#[cfg(test)]
mod tests {
    use super::{
        Beam, Chain, Parcel, Pendulum, SmallPendulum, Wheel, angle_after_a_second, grip, repulsion, start,
        thrown,
    };

    #[test]
    fn wheels_start_with_the_torque_of_their_motor() {
        let (double, single) = (start(&Wheel::<f64>::default()), start(&Wheel::<f32>::default()));
        assert!((double - (9.0 / 3.0 - 9.81) / 2.0).abs() < 1e-14, "{double}");
        assert!((f64::from(single) - double).abs() < 1e-5, "{single}");
    }

    #[test]
    fn parcels_come_to_rest_on_the_ground() {
        let state = thrown(&Parcel::default(), [0.0, 1.0, 0.0, 1.0, 0.0, 1.0], 5.0);
        let [x, y, z, velocities @ ..] = state.expect("a motion");
        assert!(x > 0.45 && y == 0.0 && (z - x.sin()).abs() < 1e-15, "{x} {y} {z}");
        assert_eq!(velocities, [0.0; 3]);
    }

    #[test]
    fn level_rods_hang_by_a_quarter_of_their_weight() {
        assert!((grip(&Beam::default(), 0.0) - 0.25 * 2.0 * 9.81).abs() < 1e-4);
    }

    #[test]
    fn systems_compute_in_both_precisions() {
        let (pendulum, small) = (Pendulum::default(), SmallPendulum::default());
        let double = pendulum.acceleration(0.0, &[0.5], &[0.0])[0];
        let single = small.acceleration(0.0, &[0.5], &[0.0])[0];
        assert!((double + 9.81 * 0.479_425_538_604_203).abs() < 1e-12);
        assert!((f64::from(single) - double).abs() < 1e-5);
        let tension = Chain::<f64>::default().tension(0.0, &[0.0, 2.0], &[0.0, 0.0]);
        assert!(
            (repulsion(&Chain::<f64>::default(), 2.0) + 2.0 * tension * 0.998_752_338_877_845_4).abs()
                < 1e-12
        );
        assert!(
            (f64::from(repulsion(&Chain::<f32>::default(), 2.0)) + 2.0 * tension * 0.998_752).abs() < 1e-4
        );
    }

    #[test]
    fn motions_are_integrated() {
        // A small swing takes T = 2π √(l/g); a second is slightly less than half of it.
        let angle = angle_after_a_second(&Pendulum::default(), 0.01).expect("finite");
        assert!((angle - 0.01 * (9.81_f64.sqrt()).cos()).abs() < 1e-7);
    }
}
