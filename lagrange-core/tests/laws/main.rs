//! Laws that hold for any declaration, checked on random ones. `PROPTEST_CASES` scales their
//! number.

mod arrays;
mod callables;
mod centroidal;
mod conditions;
mod coriolis;
mod coupled;
mod dampers;
mod declarations;
mod dimensions;
mod event_jacobian;
mod expressions;
mod formulas;
mod gibbs;
mod grids;
mod growth;
mod ignored;
mod inverse_dynamics_jacobian;
mod inverse_mass_matrix;
mod machines;
mod magnitudes;
mod mechanics;
mod mechanisms;
mod parts;
mod pivots;
mod polynomials;
mod power;
mod printing;
mod products;
mod quasi_velocities;
#[path = "../common/random.rs"]
#[allow(dead_code, reason = "other tests draw otherwise")]
mod random;
mod reductions;
mod regressor;
mod scaling;
mod scenes;
mod states;
mod switches;
mod trees;
mod units;
mod unknowns;
mod vectors;

use proptest::prelude::ProptestConfig;

/// Returns a fraction of the usual number of cases, for laws that are slow to check.
fn one_in(share: u32) -> ProptestConfig {
    let usual = ProptestConfig::default();
    ProptestConfig { cases: (usual.cases / share).max(4), failure_persistence: None, ..usual }
}
