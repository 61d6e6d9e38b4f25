//! Reference trajectories, to the precision of 53 bits.

use lagrange::Simulate;
use lagrange::integrate::Verner98;
use lagrange::system::MechanicalSystem;

use super::references::{Numbers, state};
use super::systems::{DoublePendulum, Pendulum, Star, Top};

lagrange::system! {
    /// A point mass on a rod that swings in all directions; theta is measured from straight down.
    struct SphericalPendulum;

    param l = 1.0, g = 9.81;
    coord theta, phi;
    kinetic = 1/2 * l^2 * (dot(theta)^2 + (dot(phi) * sin(theta))^2);
    potential = -g * l * cos(theta);
}

lagrange::system! {
    /// A cart that carries a pendulum; theta is measured from straight down.
    struct CartPole;

    param mc = 1.0, mp = 0.1, l = 0.5, g = 9.81;
    coord x, theta;
    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
}

lagrange::system! {
    /// Seven bodies in a plane that attract one another; the mass of each is its number.
    struct Pleiades;

    coord x1, x2, x3, x4, x5, x6, x7, y1, y2, y3, y4, y5, y6, y7;
    kinetic = 1/2 * (dot(x1)^2 + dot(y1)^2) + 2/2 * (dot(x2)^2 + dot(y2)^2)
        + 3/2 * (dot(x3)^2 + dot(y3)^2) + 4/2 * (dot(x4)^2 + dot(y4)^2) + 5/2 * (dot(x5)^2 + dot(y5)^2) + 6/2 * (dot(x6)^2 + dot(y6)^2) + 7/2 * (dot(x7)^2 + dot(y7)^2);
    potential = -(2 / hypot(x1 - x2, y1 - y2)
        + 3 / hypot(x1 - x3, y1 - y3) + 4 / hypot(x1 - x4, y1 - y4) + 5 / hypot(x1 - x5, y1 - y5)
        + 6 / hypot(x1 - x6, y1 - y6) + 7 / hypot(x1 - x7, y1 - y7) + 6 / hypot(x2 - x3, y2 - y3)
        + 8 / hypot(x2 - x4, y2 - y4) + 10 / hypot(x2 - x5, y2 - y5) + 12 / hypot(x2 - x6, y2 - y6)
        + 14 / hypot(x2 - x7, y2 - y7) + 12 / hypot(x3 - x4, y3 - y4) + 15 / hypot(x3 - x5, y3 - y5)
        + 18 / hypot(x3 - x6, y3 - y6) + 21 / hypot(x3 - x7, y3 - y7) + 20 / hypot(x4 - x5, y4 - y5)
        + 24 / hypot(x4 - x6, y4 - y6) + 28 / hypot(x4 - x7, y4 - y7) + 30 / hypot(x5 - x6, y5 - y6)
        + 35 / hypot(x5 - x7, y5 - y7) + 42 / hypot(x6 - x7, y6 - y7));
}

/// Returns the largest error at the times, from the start at zero.
fn error<M, const N: usize>(system: &M, case: &str, times: &[f64]) -> f64
where
    M: MechanicalSystem<Scalar = f64, State = [f64; N]>,
{
    let start = state::<N>(case, Numbers::Binary, 0.0);
    let errors = times.iter().map(|&time| {
        let method = Verner98::tolerance(1e-15);
        let run = system.simulate(start).until(time).method(method).ends_only().run();
        let end = run.expect("reaches the end").last();
        let wanted = state::<N>(case, Numbers::Binary, time);
        end.iter().zip(wanted).fold(0.0_f64, |largest, (found, wanted)| (found - wanted).abs().max(largest))
    });
    errors.fold(0.0, f64::max)
}

#[track_caller]
fn assert_reaches<M, const N: usize>(system: &M, case: &str, times: &[f64], bound: f64)
where
    M: MechanicalSystem<Scalar = f64, State = [f64; N]>,
{
    let error = error(system, case, times);
    println!("{case}: {error:e}");
    assert!(error < bound, "{case}: {error:e}");
}

#[test]
fn motions_end_where_more_digits_say() {
    assert_reaches(&Pendulum::default(), "pendulum", &[10.0], 1e-13);
    // The rounding of the period grows with time.
    assert_reaches(&Pendulum::default(), "pendulum", &[2000.0], 1e-9);
    assert_reaches(&DoublePendulum::default(), "double_pendulum_horizontal", &[1.0, 5.0, 10.0], 2e-12);
    assert_reaches(&SphericalPendulum::default(), "spherical_pendulum", &[10.0], 2e-13);
    assert_reaches(&CartPole::default(), "cart_pole", &[5.0], 1e-13);
    assert_reaches(&Star, "henon_heiles", &[100.0], 2e-13);
    assert_reaches(&Top::default(), "heavy_top", &[10.0], 2e-13);
}

/// Seven bodies with close encounters. End of the Pleiades problem in the ODE test sets (Hairer,
/// Nørsett, Wanner, *Solving Ordinary Differential Equations I*, §II.10), in 15 digits.
#[test]
fn seven_stars_meet() {
    let mut start = [0.0; 28];
    start[..7].copy_from_slice(&[3.0, 3.0, -1.0, -3.0, 2.0, -2.0, 2.0]);
    start[7..14].copy_from_slice(&[3.0, -3.0, 2.0, 0.0, 0.0, -4.0, 4.0]);
    (start[19], start[20], start[24], start[25]) = (1.75, -1.5, -1.25, 1.0);
    let end = [
        0.370_613_914_397_050_3,
        3.237_284_092_057_233,
        -3.222_559_032_418_324,
        0.659_709_145_577_531,
        0.342_558_170_715_658_3,
        1.562_172_101_400_631,
        -0.700_309_292_221_249_5,
        -3.943_437_585_517_392,
        -3.271_380_973_972_55,
        5.225_081_843_456_544,
        -2.590_612_434_977_47,
        1.198_213_693_392_275,
        -0.242_968_234_493_582_5,
        1.091_449_240_428_98,
    ];
    let run =
        Pleiades.simulate(start).until(3.0).tolerance(1e-15).ends_only().run().expect("reaches the end");
    let error =
        run.last().iter().zip(end).fold(0.0_f64, |largest, (found, end)| (found - end).abs().max(largest));
    println!("pleiades: {error:e}");
    assert!(error < 2e-12, "{error:e}");
}
