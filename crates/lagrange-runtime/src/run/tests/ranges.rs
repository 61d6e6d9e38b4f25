//! Ranges of entries at events.

use core::ops::Bound;

use crate::integrate::RungeKutta4;
use crate::run::integrate_with_events;
use crate::system::{Action, Direction, Domain, EntryRange, OdeSystem, RangedKind, StepFailure};

const UNIT: EntryRange = EntryRange {
    entry: 0,
    kind: RangedKind::Coordinate,
    name: "y",
    unit: "",
    bounds: (Bound::Included(0.0), Bound::Included(1.0)),
};

/// ẏ = 1 in a range.
struct Walk;

impl OdeSystem for Walk {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [1.0]
    }

    fn domain(&self) -> &'static Domain {
        &Domain { ranges: &[UNIT], nominal: &[] }
    }
}

#[test]
fn events_neither_leave_ranges_nor_hide_that_they_are_left() {
    let walk = |level: f64, action: Action<[f64; 1]>, end: f64| {
        let watch = ([Direction::Rising], move |_: f64, y: &[f64; 1]| [y[0] - level]);
        integrate_with_events(&Walk, (0.0, [0.5]), end, &RungeKutta4 { step: 1.0 }, watch, |_| action)
            .map(|_| ())
            .map_err(|failed| match failed.cause {
                StepFailure::OutOfRange(outside) => outside.value,
                other => panic!("{other}"),
            })
    };
    let leaves = |result: Result<(), f64>, at: f64| result.is_err_and(|value| (value - at).abs() < 1e-12);
    assert!(leaves(walk(1.2, Action::Stop, 2.0), 1.2));
    assert!(leaves(walk(1.2, Action::Replace([0.2]), 2.0), 1.2));
    assert!(leaves(walk(0.8, Action::Replace([5.0]), 2.0), 5.0));
    assert!(leaves(walk(0.75, Action::Replace([5.0]), 0.25), 5.0));
    assert_eq!(walk(1.0, Action::Stop, 2.0), Ok(()));
    assert_eq!(walk(1.0, Action::Replace([0.2]), 0.9), Ok(()));
}

#[test]
fn slack_of_small_ranges_is_small() {
    const RANGE: EntryRange =
        EntryRange { bounds: (Bound::Included(-1e-13), Bound::Included(1e-13)), ..UNIT };
    for nominal in [&[][..], &[1.0], &[1e-13]] {
        let domain = Domain { ranges: &[RANGE], nominal };
        assert!(domain.check(&[1e-13 + 1e-27]).is_ok() && domain.check(&[1e-12]).is_err(), "{nominal:?}");
    }
}
