//! Two point masses on massless rods, released at rest with both rods horizontal.
//!
//! The motion is chaotic: deviations, including rounding errors, grow exponentially with time. The
//! reference states were computed in 160-bit arithmetic with two step counts that agree in all
//! printed digits.
//!
//! Look for the errors, which grow a hundredfold in ten seconds, and for the drift of the energy.
//! Without a known reference, the drift is the only check.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// Two point masses on massless rods; angles are measured from the rest position.
    #[derive(Clone, Debug)]
    pub struct DoublePendulum;

    param m1: kg = 1.0, m2: kg = 1.0, l1: m = 1.0, l2: m = 1.0, g: m/s^2 = 9.81;
    coord theta1: rad, theta2: rad;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

/// Times with the states at these times.
const REFERENCE: [(f64, [f64; 4]); 3] = [
    (1.0, [-0.6250876998063907, -1.0345850856800123, -3.9222795728879767, -1.3030992486963313]),
    (5.0, [-0.6271867050665307, -1.3013155502098117, 2.1254086738429105, 3.8818887272656073]),
    (10.0, [-0.5684746640159501, -0.5263937279324047, 6.078384885761965, -9.68136068170888]),
];

fn main() -> Result<(), Box<dyn Error>> {
    let pendulum = DoublePendulum::default();
    let start = [90_f64.to_radians(), 90_f64.to_radians(), 0.0, 0.0];
    let trajectory = pendulum.simulate(start).until(10.0).tolerance(1e-13).every(1.0).energy().run()?;
    let energies = trajectory.column("energy").unwrap_or_default();
    for (t, reference) in REFERENCE {
        let Some((second, (_, end))) = trajectory.iter().enumerate().find(|(_, (time, _))| *time == t) else {
            return Err(format!("there is no sample at {t} s").into());
        };
        let drift = energies[..=second].iter().map(|energy| (energy - energies[0]).abs()).fold(0.0, f64::max);
        let rows: [_; 4] = std::array::from_fn(|i| (trajectory.names()[i].as_str(), end[i], reference[i]));
        compare(&format!("t = {t} s, energy drift {drift:.1e} J"), 1e-11, &rows);
        assert!(drift < 1e-11);
    }
    println!("{} steps, {} evaluations", trajectory.work().steps, trajectory.work().evaluations);
    Ok(())
}
