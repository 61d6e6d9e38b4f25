//! Outputs in the units that follow their names.

use lagrange::Simulate;
use lagrange::system::MechanicalSystem;

lagrange::system! {
    /// A motor on an axle, with readings as on instruments.
    #[derive(Clone, Debug)]
    struct Axle;

    param inertia: kg*m^2 = 0.5, r: m = 0.3, slope: % = 4, loss: 1 = 2.5 % + 1/200;
    coord phi: rad = 1;
    start dot(phi) = 30 [rpm];
    param ambient: degC = -20, hottest: degC in -10..=2*60 = 85, alarm: K = -5 degC;
    table resistance(winding: degC): ohm = [(-20, 1), (30, 2)], interpolation: linear, outside: clamp;
    input u: N*m = 3;
    kinetic = 1/2 * inertia * dot(phi)^2;
    force phi = u;
    output speed: rpm = dot(phi);
    output angle: deg = phi;
    output tip: mm = (r * cos(phi), r * sin(phi));
    output way: km = r * phi;
    output power: hp = u * dot(phi);
    output share: % = loss + slope;
    output fixed: km/h = 36;
    output si: rad/s = dot(phi);
    output winding: degC = ambient + 40 [K/rad] * phi;
    output cold: degC = -40;
    output warning: 1 = (if ambient < alarm { ambient - -30 degC } else { hottest - ambient }) / 1 [K];
    output loss_of_winding: ohm = resistance(ambient + 25 K);
    reduce Small { small phi; }
}

/// Asserts equality up to a few roundings.
fn assert_near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{found}, not {expected}");
}

#[test]
fn outputs_are_numbers_in_their_units() {
    let axle = Axle::default();
    assert_eq!((axle.slope, axle.loss), (0.04, 0.03));
    let (q, v) = ([0.7], [2.5]);
    assert_near(axle.speed(0.0, &q, &v), 2.5 * 30.0 / std::f64::consts::PI);
    assert_near(axle.angle(0.0, &q, &v), 0.7_f64.to_degrees());
    let [x, y] = axle.tip(0.0, &q, &v);
    assert_near(x, 300.0 * 0.7_f64.cos());
    assert_near(y, 300.0 * 0.7_f64.sin());
    assert_near(axle.way(0.0, &q, &v), 0.3 * 0.7 / 1000.0);
    // 550 foot-pounds a second: 550 · 0.3048 m · 4.4482216152605 N.
    assert_near(axle.power(0.0, &q, &v), 7.5 / (550.0 * 0.3048 * 4.448_221_615_260_5));
    assert_near(axle.share(0.0, &q, &v), 7.0);
    assert_eq!((axle.fixed(0.0, &q, &v), axle.si(0.0, &q, &v)), (36.0, 2.5));
    assert_near(Small::from(&axle).speed(0.0, &q, &v), axle.speed(0.0, &q, &v));
}

/// Numbers in degrees Celsius are temperatures above 273.15 K.
#[test]
fn temperatures_count_from_their_own_zero() {
    let axle = Axle::default();
    assert_eq!((axle.ambient, axle.hottest, axle.alarm), (253.15, 358.15, 268.15));
    let (q, v) = ([0.7], [2.5]);
    assert!((axle.winding(0.0, &q, &v) - (-20.0 + 28.0)).abs() < 1e-12);
    assert_eq!(axle.cold(0.0, &q, &v), -40.0);
    assert!((axle.warning(0.0, &q, &v) - 10.0).abs() < 1e-12);
    assert!((axle.loss_of_winding(0.0, &q, &v) - 1.5).abs() < 1e-13);
    let message = Axle { hottest: 400.0, ..axle }.check_parameters().unwrap_err().to_string();
    assert_eq!(message, "the parameter `hottest` is 400.0 K, but it must be from 263.15 to 393.15 K");
}

#[test]
fn columns_carry_these_units() {
    let axle = Axle::default();
    let unit = |name: &str| Axle::UNITS.iter().find(|(known, _)| *known == name).map(|(_, unit)| *unit);
    assert_eq!([unit("speed"), unit("tip.x"), unit("share")], [Some("rpm"), Some("mm"), Some("%")]);
    assert_eq!([unit("phi"), unit("si"), unit("slope")], [Some("rad"), Some("rad/s"), Some("1")]);
    let run = axle.simulate(axle.start()).until(1.0).every(0.5).outputs().run().expect("a motion");
    let speeds = run.column("speed").expect("an output");
    assert_near(speeds[0], 30.0);
    // ω = ω₀ + u t / J, at t = 1.
    let expected = 30.0 + 6.0 * 30.0 / std::f64::consts::PI;
    assert!((speeds[2] - expected).abs() < 1e-9, "{} rpm", speeds[2]);
}
