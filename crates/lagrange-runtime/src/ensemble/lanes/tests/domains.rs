//! Ranges of the state in lanes compared with checks of single states.

use core::ops::Bound;

use crate::scalar::{Lanes, Mask, Scalar};
use crate::system::{Domain, EntryRange, RangedKind};

const fn range(entry: usize, bounds: (Bound<f64>, Bound<f64>)) -> EntryRange {
    EntryRange { entry, kind: RangedKind::State, name: "x", unit: "", bounds }
}

const RANGES: [EntryRange; 3] = [
    range(0, (Bound::Included(-1.0), Bound::Excluded(3.0))),
    range(1, (Bound::Excluded(0.0), Bound::Unbounded)),
    range(2, (Bound::Unbounded, Bound::Included(1e-6))),
];

/// Asserts that each lane is inside if its state alone passes the check.
fn assert_same<S: Scalar>() {
    let number = S::from_f64;
    let small = S::epsilon() * number(1e3);
    let near = |bound: f64| [number(bound) - small, number(bound), number(bound) + small];
    let values = [-1.0, 0.0, 1e-6, 3.0].map(near).concat();
    let values = [&values[..], &[number(-9.0), number(9.0), S::NAN, S::ONE / S::ZERO]].concat();
    for nominal in [&[][..], &[1.0, 1e3, 1e-3]] {
        let domain = Domain { ranges: &RANGES, nominal };
        for entry in 0..3 {
            for group in values.chunks(8) {
                let mut state = [Lanes::<S, 8, false>([S::from_f64(1e-7); 8]); 3];
                state[entry].0[..group.len()].copy_from_slice(group);
                let are_inside = domain.contains(&state);
                for lane in 0..8 {
                    let alone = state.map(|lanes| lanes.0[lane]);
                    assert_eq!(are_inside.lane(lane), domain.check(&alone).is_ok(), "{entry}: {alone:?}");
                }
            }
        }
    }
}

#[test]
fn lanes_are_inside_if_their_states_are() {
    assert_same::<f64>();
    assert_same::<f32>();
    assert!(Domain::EVERYWHERE.contains(&[Lanes::<f64, 2, true>([f64::NAN; 2])]).all());
}
