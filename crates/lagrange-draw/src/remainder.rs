//! The resultant of unnamed forces.
//!
//! By Newton's law, all forces on a body add up to m a. By the axiom of angular momentum, all
//! moments about its centre of mass add up to J α. Named loads may add up to less: joints that the
//! coordinates satisfy, hand-written constraints and potentials, contacts and friction have no
//! named force. Their resultant still follows:
//!
//! ```text
//! R = m a − Σ F,    M_R = J α − Σ (M + r × F).
//! ```

use crate::geometry::{cross, length, subtract, times};
use crate::load::{Load, Value};
use crate::picture::Point;
use lagrange_runtime::body::Motion;

/// The resultant of all forces and moments on a body that have no name, at its centre of mass.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Remainder {
    pub(super) at: Point,
    /// Resultant force; zero if only rounding errors remain.
    pub(super) force: Point,
    /// Resultant moment; zero if only rounding errors remain.
    pub(super) moment: f64,
}

/// Label of the remainder.
pub(super) const REMAINDER: &str = "R";
/// Name of the resultant moment.
pub(super) const MOMENT: &str = "M_R";
/// Error of positions in units of rounding.
const POSITION_ROUNDINGS: f64 = 64.0;

impl Remainder {
    /// Computes the remainder for a body with this motion under these loads, in numbers with the
    /// relative spacing `epsilon`.
    pub(super) fn of<'a>(
        motion: &Motion<f64>,
        loads: impl Iterator<Item = &'a Load>,
        epsilon: f64,
    ) -> Remainder {
        let center = motion.center;
        let mut force = times(motion.mass, motion.acceleration);
        let mut moment = motion.inertia * motion.angular_acceleration;
        let (mut forces, mut moments, mut shifts) = (length(force), moment.abs(), 0.0);
        for load in loads {
            match load.value {
                Value::Force(part) => {
                    let arm = subtract(load.at, center);
                    force = subtract(force, part);
                    moment -= cross(arm, part);
                    forces += length(part);
                    moments += length(arm) * length(part);
                    shifts += (length(load.at) + length(center)) * length(part);
                }
                Value::Moment(part) => {
                    moment -= part;
                    moments += part.abs();
                }
            }
        }
        // Accelerations lose digits in the elimination of unknowns. Half of all digits is more than
        // a picture can show.
        let half = epsilon.sqrt();
        let gyration = (motion.inertia / motion.mass).abs().sqrt();
        let gyration = if gyration.is_finite() { gyration } else { 0.0 };
        let least = half * (moments + gyration * forces) + POSITION_ROUNDINGS * epsilon * shifts;
        // Non-finite values are passed on and rejected later.
        let is_rounding = length(force) <= half * forces;
        Remainder {
            at: center,
            force: if is_rounding { [0.0, 0.0] } else { force },
            moment: if moment.abs() <= least { 0.0 } else { moment },
        }
    }
}

#[cfg(test)]
mod tests {

    use super::Remainder;
    use crate::load::{Load, Value};
    use lagrange_runtime::body::Motion;
    use lagrange_runtime::scene::LoadOrigin;

    const EPSILON: f64 = f64::EPSILON;

    /// A rod of mass 3 and length 2 that swings about its end at the origin. It is horizontal at
    /// this moment: α = −3 g/(2 l).
    const ROD: Motion<f64> = Motion {
        mass: 3.0,
        inertia: 1.0,
        centroid: [0.0, 0.0],
        center: [1.0, 0.0],
        angle: 0.0,
        velocity: [0.0, 0.0],
        angular_velocity: 0.0,
        acceleration: [0.0, -7.5],
        angular_acceleration: -7.5,
    };

    fn load(at: [f64; 2], value: Value) -> Load {
        Load { name: "F".to_string(), cause: LoadOrigin::Applied, body: Some("rod".to_string()), at, value }
    }

    fn weight() -> Load {
        load([1.0, 0.0], Value::Force([0.0, -30.0]))
    }

    #[test]
    fn the_force_of_a_hinge_that_nobody_names_is_found() {
        // The hinge carries a quarter of the weight.
        let found = Remainder::of(&ROD, [weight()].iter(), EPSILON);
        assert_eq!((found.at, found.force, found.moment), ([1.0, 0.0], [0.0, 7.5], -7.5));
    }

    #[test]
    fn nothing_is_left_where_all_forces_are_named_but_for_rounding() {
        let all = |at, hinge| [weight(), load(at, Value::Force(hinge))];
        let found = Remainder::of(&ROD, all([0.0, 0.0], [0.0, 7.5]).iter(), EPSILON);
        assert_eq!((found.force, found.moment), ([0.0, 0.0], 0.0));
        let found = Remainder::of(&ROD, all([1e-15, 0.0], [1e-12, 7.5 - 1e-12]).iter(), EPSILON);
        assert_eq!((found.force, found.moment), ([0.0, 0.0], 0.0));
        let found = Remainder::of(&ROD, all([1e-3, 0.0], [0.0, 7.5]).iter(), EPSILON);
        assert!((found.moment + 7.5e-3).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn a_moment_is_left_that_nobody_names() {
        let loads: Vec<Load> =
            [weight(), load([0.0, 0.0], Value::Force([0.0, 7.5])), load([9.0, 9.0], Value::Moment(2.0))]
                .into();
        let found = Remainder::of(&ROD, loads.iter(), EPSILON);
        assert_eq!((found.force, found.moment), ([0.0, 0.0], -2.0));
    }

    #[test]
    fn what_is_not_a_number_stays_so() {
        let found = Remainder::of(&ROD, [load([0.0, 0.0], Value::Force([f64::NAN, 0.0]))].iter(), EPSILON);
        assert!(found.force[0].is_nan() && found.moment.is_nan());
    }
}
