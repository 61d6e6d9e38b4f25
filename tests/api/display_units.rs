//! Outputs in the units behind their names.

use lagrange::Simulate;
use lagrange::system::MechanicalSystem;

lagrange::system! {
    /// A motor on an axle, with readings as on its instruments.
    #[derive(Clone, Debug)]
    struct Axle;

    param inertia: kg*m^2 = 0.5, r: m = 0.3, slope: % = 4, loss: 1 = 2.5 % + 1/200;
    coord phi: rad = 1;
    start dot(phi) = 30 [rpm];
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
    reduce Small { small phi; }
}

/// Distance of a few roundings.
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
