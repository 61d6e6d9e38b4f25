//! A car of parts: struts, an engine map, a clutch, gears, a differential and tyres.

use lagrange::Simulate;

lagrange::system! {
    /// A car with rear-wheel drive, which accelerates through two gears. x points forwards, y to
    /// the left and z up; it pitches about y and rolls about x.
    #[derive(Clone, Debug)]
    struct Car;

    include "../parts/driveline.lag";
    include "../parts/strut.lag";

    param mass = 1200, pitch_inertia = 1500, roll_inertia = 500, height = 0.4, g = 9.81;
    param engine = 0.2, wheel = 1.2, radius = 0.3, shift = 300, capacity = 130;
    const ahead[4] = [1.2, 1.2, -1.3, -1.3], aside[4] = [0.7, -0.7, 0.7, -0.7];
    coord x, z, pitch, roll, crank, left, right;
    mode gear = first | second;
    kinetic = 1/2 * mass * (dot(x)^2 + dot(z)^2) + 1/2 * pitch_inertia * dot(pitch)^2
        + 1/2 * roll_inertia * dot(roll)^2 + 1/2 * engine * dot(crank)^2 + 1/2 * wheel * (dot(left)^2 + dot(right)^2);
    potential = mass * g * z;

    strut[i in 0..4]: Strut {
        lower: (ahead[i], 0);
        upper: (ahead[i], z - ahead[i] * pitch + aside[i] * roll);
    }
    tyre[i in 0..2]: Tyre { hub: x; spin: [left, right]; load: -strut[i + 2].coil.force - strut[i + 2].oil.force; radius: radius; }
    force pitch = -height * (tyre[0].push + tyre[1].push);

    table map(speed, throttle) = [
        (50, 0, -5), (50, 1/2, 50), (50, 1, 70),
        (200, 0, -10), (200, 1/2, 65), (200, 1, 100),
        (350, 0, -18), (350, 1/2, 60), (350, 1, 105),
        (500, 0, -30), (500, 1/2, 40), (500, 1, 80),
    ], interpolation: natural, outside: extend;
    force crank = map(dot(crank), 1 - exp(-t / 0.3));
    axle: Differential { left: left; right: right; }
    let ratio = if gear == second { 6 } else { 11 };
    clutch: Clutch { drive: crank; load: ratio * axle.carrier; capacity: capacity; }
    event upshift = dot(crank) - shift, rising => { gear = second; }
}

/// The clutch sticks after 0.02 s, slips at the shift and sticks again.
#[test]
fn a_car_of_parts_moves_as_in_an_independent_integration() {
    let car = Car { tyre_1_grip: 0.7, ..Car::default() };
    let start = [0.0, 0.36, 0.01, 0.02, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 100.0, 1.0 / 0.3, 1.0 / 0.3];
    let run = car.simulate(start).until(5.0).tolerance(1e-13).run().expect("a motion");
    // From `tools/car_of_parts.py`.
    let shift = run.events().iter().find(|event| event.name == "upshift").expect("a shift");
    assert!((shift.time - 3.065952200728588).abs() < 1e-10, "{}", shift.time);
    let reference = [
        3.1202226266188e+01,
        3.5291659143707e-01,
        -1.2792549185864e-03,
        -7.3187126554166e-09,
        9.4238198517475e+02,
        1.0884141058169e+02,
        1.0970921661883e+02,
        1.0,
        1.1237611208286e+01,
        -2.6251146173996e-04,
        -2.4374694480094e-04,
        6.1650530653134e-08,
        2.2932722712119e+02,
        3.8163029709248e+01,
        3.8279379331149e+01,
    ];
    for (value, expected) in run.last().iter().zip(reference) {
        assert!((value - expected).abs() < 1e-10 * expected.abs().max(1.0), "{value} {expected}");
    }
}

lagrange::system! {
    /// A leg that hangs from the ground.
    #[derive(Clone, Debug)]
    struct Hanging;

    include "../parts/leg.lag";

    gravity = (0, 0, -9.81);
    leg: Leg { on: ground; at: (0.1, 0, 0.5); length: 0.3; }
}

/// The motors carry the moments of the weights: turned about y by positive angles, the leg points
/// backwards.
#[test]
fn a_leg_needs_the_moments_of_its_weights() {
    let leg = Hanging::default();
    let (hip, knee) = (0.7_f64, -1.1);
    let found = leg.inverse_dynamics(0.0, &[hip, knee], &[0.0; 2], &[0.0; 2]);
    let shank = 0.4 * 9.81 * 0.15 * (hip + knee).sin();
    let thigh = 9.81 * (1.2 * 0.15 + 0.4 * 0.3) * hip.sin();
    assert!((found[1] - shank).abs() < 1e-14 && (found[0] - thigh - shank).abs() < 1e-14, "{found:?}");
    let foot = leg.leg_place(0.0, &[hip, knee], &[0.0; 2]);
    let wanted =
        [0.1 - 0.3 * (hip.sin() + (hip + knee).sin()), 0.0, 0.5 - 0.3 * (hip.cos() + (hip + knee).cos())];
    assert!(foot.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-15), "{foot:?}");
}

lagrange::system! {
    /// A load on a cylinder, whose valves are closed after half a second.
    #[derive(Clone, Debug)]
    struct Lift;

    include "../parts/hydraulic.lag";

    param mass = 500, g = 9.81, flow = 1e-4;
    coord x;
    kinetic = 1/2 * mass * dot(x)^2;
    potential = mass * g * x;
    cylinder: Cylinder { extension: x; inflow: if t < 1/2 { flow } else { 0 }; outflow: 0; }
}

/// A chamber of the volume V takes up the flow q as V ṗ = K (q − V̇). Without any, p + K ln V is
/// constant.
#[test]
fn trapped_oil_is_compressed_by_the_logarithm_of_its_volume() {
    let lift = Lift { cylinder_leakage: 0.0, ..Lift::default() };
    let start = [0.1, 500.0 * 9.81 / 2e-3, 0.0, 0.0];
    let run = lift.simulate(start).until(2.0).every(0.1).tolerance(1e-11).run().expect("a motion");
    let around = |x: f64| 5e-5 + 1.2e-3 * (0.5 - x);
    let behind = |x: f64| 5e-5 + 2e-3 * x;
    let state = |row| run.state(row).expect("a row");
    let [x0, ..] = state(0);
    for row in 0..run.len() {
        let [x, _, rod, _] = state(row);
        assert!((rod + 1.4e9 * (around(x) / around(x0)).ln()).abs() < 1e-1, "{rod}");
    }
    let ([x5, cap5, ..], [x, cap, ..]) = (state(6), state(20));
    assert!((cap - cap5 + 1.4e9 * (behind(x) / behind(x5)).ln()).abs() < 1e-1, "{cap}");
    assert!(x - x0 > 0.02, "it was lifted: {x}");
}
