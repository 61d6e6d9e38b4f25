//! Sizes below which a difference counts as rounding, in one table.
//!
//! The unit is ε, the distance from one to the next number, times the magnitude in the third
//! column. Each value is large enough for the effects of sums and eliminations on ε, and small
//! enough to lose no intended value. The values leave a margin: no test fails if
//! one of them is halved or doubled. The last column names the first test, if any, that fails at
//! 1/64 (or else 1/4096) and at 64 (or else 4096) times the value.
//!
//! | constant | ε | times | reason | detected by |
//! |---|---|---|---|---|
//! | [`DEPENDENT_COLUMN`] | 32 | the largest column of a scaled symmetric matrix, for each row | the remainder of a dependent column is rounding | × 1/4096: `units_of_the_rows_do_not_matter_to_the_rank` |
//! | [`DEPENDENT_PIVOT`] | 1000 | one, the largest entries of a scaled matrix | the remainder of a dependent pivot consists of the rounding errors of all previous ones | × 1/4096: `dependent_constraints_and_dead_points_do_not_matter` |
//! | [`PULL`] | 8 | the largest coordinate | a pull is a difference of rounded positions, less its component normal to the constraints | × 1/64: `corrections_that_overshoot_are_shortened` |
//! | [`RESIDUAL`] | 16 | the largest scale of a residual | if a gradient vanishes, its scale is itself rounding, and a ratio to it is meaningless | × 1/64 and × 64: `residuals_without_a_scale_are_rounding_beside_the_largest` |
//! | [`TOUCHING`] | 4096 | changes of gaps and rates if each coordinate changed by its size, or time by the elapsed time of a run | starts are computed by separate formulas; a gap that equals a coordinate has no other terms relative to which it could be small | × 4096: `a_ball_comes_to_rest_where_its_bounces_accumulate` |
//! | [`CLOSED_GAP`] | 64 | the terms of the gap | a Newton correction leaves a few roundings of the terms | × 1/64 and × 64: `a_gap_is_closed_up_to_the_rounding_of_its_terms` |
//! | [`SLIT`] | 16 | the terms of the gap | bodies that touch without pressing are separated by this distance: less than a closed gap, more than rounding | × 1/64 and × 64: `bodies_that_part_are_apart_by_more_than_rounding` |
//! | [`HOP`] | 256 | the terms of the gap | the duration of a lower hop would be rounding; more than a closed gap | × 1/64 and × 64: `hops_no_higher_than_rounding_are_not_resolved` |
//! | [`BOUNDARY`] | 4096 | a bound, or the nominal value or else the largest bound | bodies rest at bounds up to the gaps of closed contacts, and constraints hold up to residuals | × 1/64 and × 64: `bounds_are_exceeded_by_rounding_only` |
//! | [`INSTANT`] | 8 | time | the time of an event is accurate to a few roundings, and gaps and rates to their change in this time | × 1/64 and × 64: `gaps_are_known_as_well_as_the_time_of_an_event` |
//! | [`HOP_TIME`] | 64 | time; the elapsed time of a run | shorter hops are not resolved, in numbers so coarse that 10⁻⁹ of the time is less | × 1/64 and × 64: `hops_no_longer_than_rounding_of_time_are_not_resolved` |
//! | [`BALANCED`] | 16 | the terms of a rate or of a limit | a sum of a handful of terms | × 1/64 and × 64: `forces_that_are_rounding_do_not_press` |
//! | [`BALANCED_BY_SEARCH`] | 2¹⁶ | the same | Lemke's method exchanges many variables, and each exchange rounds the result of the previous one | × 1/64 and × 64: `rules_found_by_search_hold_to_more_than_rounding` |
//! | [`HELD_TOGETHER`] | 2²⁰ | the same | the shortest of undetermined impulses ignore equations that are dependent up to rounding | × 1/64 and × 64: `contacts_at_one_place_are_held_together_up_to_what_undetermined_impulses_leave` |
//! | [`BOUND`] | 64 | the terms of a force or slip velocity | more than the tolerance of balance, so that a body exactly at a bound does not alternate between modes | × 64: `a_block_at_rest_starts_when_the_drive_exceeds_the_static_limit` |
//! | [`STEADY`] | 512 | the impulses of a step | impulses that hardly change from step to step repeat their error, which adds up | × 4096: `corners_share_a_load_evenly_in_each_step` |
//! | [`IMPACT_ENERGY`] | 256 | the exchanged energy | squares of velocities from the solution of equations | × 1/4096: `an_impact_conserves_momentum_and_an_elastic_one_energy`; × 64: `no_impact_creates_energy` |
//! | [`BERNSTEIN_COEFFICIENT`] | 512 | the largest value | the sums of magnitudes in the change to Bernstein coefficients | × 1/4096: `what_only_touches_zero_does_not_change`; × 64: `zeros_next_to_each_other_are_found` |
//! | [`SAME_EVENT`] | 64 | time; the change of a function with the state | times and states differ by a few roundings after a restart | × 1/64: runs that do not end |
//! | [`SURFACE`] | 32 | the largest component of the state | a switch is located this far beyond its surface; on the surface, rounding would trigger it repeatedly | × 1/64 and × 64: `a_switch_changes_its_side_a_few_roundings_beyond_its_surface` |
//! | [`RESTART`] | 2 | time | steps end this far before a jump and start this far after it, so that no evaluation hits it | × 1/64: `no_step_sees_a_jump`; × 64: `a_restart_that_fails_is_an_error_at_the_jump` |
//! | [`SAME_INSTANT`] | 4 | time | instants are rounded multiples of a period, on both sides of a restart | × 1/64 and × 64: `instants_are_apart_by_more_than_the_rounding_of_time` |
//! | [`DEFAULT_TOLERANCE`] | 10 | the state | no default demands more than the accuracy of the numbers | × 1/64 and × 64: `the_default_tolerance_is_what_numbers_can_give` |
//! | [`LEAST_TOLERANCE`] | 16 | the state | shorter steps would only increase rounding | × 64: `a_pendulum_in_the_plane_moves_as_its_angle_does` |
//! | [`DEFECT`] | 256 | the rates | the slope of an interpolant is a sum of 26 rates with weights of both signs | × 1/64 and × 64: `a_defect_that_is_rounding_of_the_rates_is_none` |
//! | [`SAME_STATE`] | 1000 | the state | the quotient of two differences is meaningful if each has three digits | × 1/64 and × 64: `states_that_differ_by_rounding_do_not_tell_of_stiffness` |

use crate::scalar::Scalar;

/// A number of roundings.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Roundings(f64);

impl Roundings {
    /// Zero roundings.
    pub(crate) const NONE: Roundings = Roundings(0.0);

    /// Returns their fraction of a magnitude.
    #[inline]
    pub(crate) fn part<S: Scalar>(self) -> S {
        S::from_f64(self.0) * S::epsilon()
    }

    /// Multiplies the number of roundings.
    #[inline]
    pub(crate) fn times(self, count: usize) -> Roundings {
        Roundings(self.0 * count as f64)
    }
}

/// Remainder of a dependent column, for each row.
pub(crate) const DEPENDENT_COLUMN: Roundings = Roundings(32.0);
/// Largest pivot of dependent equations.
pub(crate) const DEPENDENT_PIVOT: Roundings = Roundings(1e3);
/// Largest negligible pull towards the nearest positions.
pub(crate) const PULL: Roundings = Roundings(8.0);
/// Largest negligible residual.
pub(crate) const RESIDUAL: Roundings = Roundings(16.0);
/// Gap or rate that counts as zero at the start of a motion.
pub(crate) const TOUCHING: Roundings = Roundings(4096.0);
/// Largest gap that counts as closed.
pub(crate) const CLOSED_GAP: Roundings = Roundings(64.0);
/// Distance between bodies that touch without pressing.
pub(crate) const SLIT: Roundings = Roundings(16.0);
/// Height of a hop that is too low to be resolved.
pub(crate) const HOP: Roundings = Roundings(256.0);
/// Distance beyond an included bound of a state.
pub(crate) const BOUNDARY: Roundings = Roundings(4096.0);
/// Accuracy of the time of an event.
pub(crate) const INSTANT: Roundings = Roundings(8.0);
/// Duration of a hop that is too short to be resolved.
pub(crate) const HOP_TIME: Roundings = Roundings(64.0);
/// Rates and limits that count as met.
pub(crate) const BALANCED: Roundings = Roundings(16.0);
/// Rates and limits that count as met in solutions of Lemke's method.
pub(crate) const BALANCED_BY_SEARCH: Roundings = Roundings(65_536.0);
/// Rates held together by impulses that the motion does not determine.
pub(crate) const HELD_TOGETHER: Roundings = Roundings(1_048_576.0);
/// Amount by which forces may exceed their bounds before a mode ends.
pub(crate) const BOUND: Roundings = Roundings(64.0);
/// Error of impulses that hardly change from step to step.
pub(crate) const STEADY: Roundings = Roundings(512.0);
/// Difference of energies that count as equal.
pub(crate) const IMPACT_ENERGY: Roundings = Roundings(256.0);
/// Rounding error of Bernstein coefficients.
pub(crate) const BERNSTEIN_COEFFICIENT: Roundings = Roundings(512.0);
/// Difference of times and values that belong to the same event.
pub(crate) const SAME_EVENT: Roundings = Roundings(64.0);
/// Distance beyond its surface at which a switch is located.
pub(crate) const SURFACE: Roundings = Roundings(32.0);
/// Distance of steps from a restart.
pub(crate) const RESTART: Roundings = Roundings(2.0);
/// Difference of instants that are the same.
pub(crate) const SAME_INSTANT: Roundings = Roundings(4.0);
/// Minimum default tolerance.
#[cfg(feature = "std")]
pub(crate) const DEFAULT_TOLERANCE: Roundings = Roundings(10.0);
/// Minimum tolerance.
pub(crate) const LEAST_TOLERANCE: Roundings = Roundings(16.0);
/// Largest negligible defect of an interpolant.
pub(crate) const DEFECT: Roundings = Roundings(256.0);
/// Difference of states that is too small for a quotient.
pub(crate) const SAME_STATE: Roundings = Roundings(1e3);
