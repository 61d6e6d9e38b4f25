//! A hundred thousand double pendulums over the processes of an MPI job:
//! `mpirun -n 4 pendulums FOLDER [MOTIONS [PARTS]]`
//!
//! Ends are saved to the folder part by part, and then summed again without it. The first process
//! prints the bits of the sums, which are the same for any number of processes.
//! `tools/mpi_check.py` kills processes of this in the middle.

mod processes;

use std::env;
use std::error::Error;

use lagrange::Ensembles;
use lagrange::ensemble::{Ensemble, Histogram, Moments};
use lagrange::integrate::Verner98;
use mpi::traits::Communicator;

use processes::{all_ok, initialize, reduce_over, shard};

lagrange::system! {
    /// Two point masses on massless rods.
    #[derive(Clone)]
    struct DoublePendulum;

    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

/// Returns motions of ten seconds, one in a thousand of which fails at its start.
fn ensemble(
    pendulum: &DoublePendulum,
    motions: usize,
    parts: usize,
) -> Ensemble<'_, DoublePendulum, Verner98<f64>> {
    let motions_per_part = motions.div_ceil(parts);
    let motions = pendulum.ensemble(motions).start(|i, random| {
        let angle = if i % 1000 == 999 { f64::NAN } else { 2.0 + 0.1 * random.normal() };
        [angle, 2.0, 0.0, 0.0]
    });
    let motions = motions.parameters(|i, pendulum| pendulum.m2 = 0.5 + 1e-5 * i as f64);
    motions.until(10.0).seed(7).threads(1).motions_per_part(motions_per_part)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let folder = arguments.next().ok_or("usage: mpirun -n 4 pendulums FOLDER [MOTIONS [PARTS]]")?;
    let motions = arguments.next().map_or(Ok(100_000), |text| text.parse())?;
    let parts = arguments.next().map_or(Ok(100), |text| text.parse())?;

    let universe = initialize()?;
    let world = universe.world();
    let pendulum = DoublePendulum::default();

    let share = ensemble(&pendulum, motions, parts).shard(shard(&world));
    let saved = all_ok(&world, share.save_parquet(folder))?;
    println!("rank {}: {} parts written, {} found", world.rank(), saved.written, saved.found);

    let identity = (Moments::new(), Histogram::new(64));
    let motions = ensemble(&pendulum, motions, parts);
    let ((rates, angles), failed, failures) =
        reduce_over(&world, motions, identity, |(moments, angles), motion| {
            moments.add(motion.end().theta1_dot);
            angles.add(motion.end().theta2);
        })?;
    if world.rank() == 0 {
        let [mean, deviation] = [rates.mean(), rates.standard_deviation()];
        println!("mean {mean} deviation {deviation} of {}, {} failed", rates.count(), failed);
        println!("bits {:016x} {:016x}", mean.to_bits(), deviation.to_bits());
        let counts: Vec<_> = angles.bins().map(|(_, count)| count).collect();
        println!("counts {counts:?}");
        println!("failures {failures:?}");
    }
    Ok(())
}
