//! Many motions of one declaration: the same bits however they are computed, and clear errors.
#![cfg(feature = "ensemble")]

mod beside_noise;
mod bits;
#[cfg(feature = "parquet")]
mod files;
#[cfg(feature = "parquet")]
mod folders;
mod lanes;
mod late;
mod noise;
mod pictures;
#[path = "../references/mod.rs"]
mod references;
mod refusals;
mod runs;
mod sensitivities;
mod series;
mod stochastic;

lagrange::system! {
    /// Two point masses on massless rods.
    #[derive(Clone, Debug)]
    pub(crate) struct DoublePendulum;

    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

/// Returns a number of motions: a third of it unoptimised, where motions are slow.
pub(crate) fn shortened(motions: usize) -> usize {
    if cfg!(debug_assertions) { motions.div_ceil(3) } else { motions }
}

/// Returns a start of the double pendulum.
pub(crate) fn start(_: usize, random: &mut lagrange::ensemble::Random) -> [f64; 4] {
    [2.0 + 0.1 * random.normal(), random.uniform(1.0..2.0), 0.0, 0.0]
}
