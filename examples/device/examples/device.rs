//! The number of motions per second of a device, compared with the scalar code on one thread of the
//! processor.
//!
//! `cargo run --release --example device` in the folder of `lagrange-device`. The motions are those
//! of double pendulums, 10 s each, from slightly different starts. Ends of the device and of the
//! scalar code must agree.

use std::error::Error;
use std::time::Instant;

use lagrange::Simulate;
use lagrange_device::{Device, RungeKutta4};

lagrange::system! {
    /// Two point masses on massless rods, absolute angles.
    #[derive(Clone)]
    pub struct DoublePendulum;
    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = kinetic_energy(m1, dot((x1, y1))) + kinetic_energy(m2, dot((x2, y2)));
    potential = gravitational_energy(m1, g, y1) + gravitational_energy(m2, g, y2);
    emit { kernel }
}

const STEP: f64 = 1e-2;
const TOLERANCE: f64 = 1e-9;
const END: f64 = 10.0;
/// Number of motions of the scalar code, for which a few suffice to measure the time.
const SAMPLE: usize = 256;

fn main() -> Result<(), Box<dyn Error>> {
    let motions = std::env::args().nth(1).map_or(Ok(16_384), |number| number.parse::<usize>())?.max(SAMPLE);
    let pendulum = DoublePendulum::default();
    let starts =
        (0..motions).map(|i| [0.6 + 0.4 * i as f64 / motions as f64, 0.3, 0.0, 0.0]).collect::<Vec<_>>();
    let scalar = sample(&pendulum, &starts)?;
    for device in Device::all()? {
        println!("\n{}, {motions} motions:", device.name());
        let asked = || device.ensemble(&pendulum, starts.iter().copied()).until(END);
        if device.has_double_precision() {
            let equal =
                timed("f64, Runge–Kutta 4", motions, || asked().method(RungeKutta4 { step: STEP }).run())?;
            let adaptive =
                timed("f64, Dormand–Prince 5(4)", motions, || asked().tolerance(TOLERANCE).run())?;
            for (found, (i, expected)) in [(equal, &scalar[0]), (adaptive, &scalar[1])]
                .iter()
                .flat_map(|(ends, scalar)| scalar.iter().enumerate().map(move |expected| (ends, expected)))
            {
                let found = found.state(i).ok_or("no motion fails")?;
                let distance = (0..4).map(|k| (found[k] - expected[k]).abs()).fold(0.0, f64::max);
                assert!(distance < 1e-5, "motion {i} ends {distance:e} away from where it should");
            }
        }
        let single = || asked().method(RungeKutta4 { step: STEP }).single_precision().run();
        timed("f32, Runge–Kutta 4", motions, single)?;
    }
    Ok(())
}

/// Returns the ends of some motions by the scalar code: in equal steps, and by the pair of orders
/// nine and eight.
fn sample(pendulum: &DoublePendulum, starts: &[[f64; 4]]) -> Result<[Vec<[f64; 4]>; 2], Box<dyn Error>> {
    println!("scalar code, one thread, {SAMPLE} motions:");
    let starts = &starts[..SAMPLE];
    let equal = timed("f64, Runge–Kutta 4", SAMPLE, || {
        let runs = starts.iter().map(|start| {
            Ok(pendulum.simulate(*start).until(END).method(RungeKutta4 { step: STEP }).run()?.last())
        });
        runs.collect::<Result<Vec<_>, Box<dyn Error>>>()
    })?;
    let adaptive = timed("f64, Verner 9(8)", SAMPLE, || {
        let runs = starts
            .iter()
            .map(|start| Ok(pendulum.simulate(*start).until(END).tolerance(TOLERANCE).run()?.last()));
        runs.collect::<Result<Vec<_>, Box<dyn Error>>>()
    })?;
    Ok([equal, adaptive])
}

/// Computes twice, since the first run compiles the kernel, and prints the speed of the second run.
fn timed<T, E>(method: &str, motions: usize, compute: impl Fn() -> Result<T, E>) -> Result<T, E> {
    compute()?;
    let start = Instant::now();
    let computed = compute()?;
    let seconds = start.elapsed().as_secs_f64();
    println!("  {method:<26}{:>12.0} motions a second", motions as f64 / seconds);
    Ok(computed)
}
