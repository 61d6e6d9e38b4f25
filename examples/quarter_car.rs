//! A quarter of a car on a measured road: the car and a wheel, a spring and a damper between them,
//! and a tyre below.
//!
//! The road is a table of heights every 0.25 m, in the file `examples/data/road.csv`, which is read
//! at compile time. Between the points it is a natural cubic spline: the force of the tyre is
//! continuous in its second derivative. Displacements of the masses are from rest on a level road,
//! so weights do not appear. At 20 m/s the car passes all 50 m in 2.5 s.
//!
//! References: `tools/quarter_car.py`, by SciPy's spline and Runge–Kutta method, and by matrix
//! exponentials, which agree in 12 digits. Look for the acceleration of the car, which the springs
//! reduce to a sixth of that of the wheel. The tyre carries less than at rest, but never leaves the
//! road.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A quarter of a car that drives at a constant speed.
    #[derive(Clone, Debug)]
    pub struct QuarterCar;

    table road(x: m): m = "examples/data/road.csv", interpolation: natural, outside: extend;

    param m_car: kg = 290, m_wheel: kg = 59, stiffness: kN/m = 16.8, damping: N*s/m = 1000, tyre: kN/m = 190;
    param speed: km/h = 72, g: m/s^2 = 9.81;
    coord car: m, wheel: m;
    let ground = road(speed * t);
    kinetic = kinetic_energy(m_car, dot(car)) + kinetic_energy(m_wheel, dot(wheel));
    potential = spring_energy(stiffness, car - wheel) + spring_energy(tyre, wheel - ground);
    dissipation = 1/2 * damping * (dot(car) - dot(wheel))^2;
    output comfort = ddot(car);
    output jolt = ddot(wheel);
    output load = (m_car + m_wheel) * g - tyre * (wheel - ground);
    output climb = dot(ground);
}

/// Positions and velocities of car and wheel after 2.5 s, and the acceleration of the car.
const REFERENCE: [f64; 5] = [
    4.9828210872437e-02,
    4.2975830132694e-02,
    -1.1430469924451e-01,
    -9.1360131418912e-02,
    -3.1784630552443e-01,
];

fn main() -> Result<(), Box<dyn Error>> {
    let car = QuarterCar::default();
    let run = car.simulate([0.0; 4]).until(2.5).every(0.005).tolerance(1e-14).outputs().run()?;
    let end = QuarterCarState::from(run.last());
    let comfort = run.column("comfort").unwrap_or_default();
    let [car, wheel, car_dot, wheel_dot, acceleration] = REFERENCE;
    let rows = [
        ("car / m", end.car, car),
        ("wheel / m", end.wheel, wheel),
        ("car, m/s", end.car_dot, car_dot),
        ("wheel, m/s", end.wheel_dot, wheel_dot),
        ("car, m/s²", comfort[comfort.len() - 1], acceleration),
    ];
    compare("after 50 m", 1e-12, &rows);

    let largest = |name: &str| {
        let column = run.column(name).unwrap_or_default();
        column.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    let load = run.column("load").unwrap_or_default();
    let least = load.iter().copied().fold(f64::INFINITY, f64::min);
    println!("largest acceleration of the car   {:6.2} m/s²", largest("comfort"));
    println!("largest acceleration of the wheel {:6.2} m/s²", largest("jolt"));
    println!("steepest rise of the ground       {:6.2} m/s", largest("climb"));
    println!("least load of the tyre            {:6.2} of that at rest", least / load[0]);
    assert!(least > 0.0, "the wheel leaves the road");
    Ok(())
}
