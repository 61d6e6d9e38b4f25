//! The items that `system!` emits: names, types, conversions and traits on which users may rely.

mod accuracy;
mod arrays;
mod axiom;
mod bodies;
mod car;
mod changing_inertia;
mod coarse_times;
mod columns;
mod conserved;
mod constrained_references;
mod constraints;
mod contact_quantities;
mod contacts;
mod control;
mod declarations;
mod discrete;
mod display_units;
mod events;
mod external_functions;
mod failures;
mod first_order;
mod fixed_steps;
mod fractional_powers;
mod frames;
mod friction_limits;
mod functions;
mod hamiltonian;
mod hessian;
mod hints;
mod hybrid;
mod ignored;
mod inertia;
mod kinematics;
mod lanes;
mod laws;
mod long_rope;
mod matrices;
mod methods;
mod orientations;
mod overdetermined;
mod parts;
mod pivots;
mod power;
mod prepared;
mod product_rows;
mod products;
mod projection;
mod ranges;
mod rate_equations;
mod reduced;
mod regressor;
mod resting;
mod saved;
mod scalars;
mod shadowing;
mod simulation;
mod solve;
mod spatial_axiom;
mod start;
mod state_equations;
mod state_ranges;
mod states;
mod switches;
mod tables;
mod time_spans;
mod torques;
#[cfg(feature = "trade")]
mod trade;
mod traits;
mod units;
mod wrappers;

#[path = "../references/mod.rs"]
mod references;
mod user_functions;
mod visuals;

/// Asserts that two numbers agree to a few units in the last place of `f64`.
#[track_caller]
fn assert_close(found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= 1e-14 * expected.abs().max(1.0), "{found} is not {expected}");
}
