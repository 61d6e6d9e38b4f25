//! States: random ones, and ones with exact zeros, equal numbers and quarter turns.

use std::f64::consts::FRAC_PI_2;

use crate::layout::{Layout, Slot};
use crate::random::Random;
use crate::world::State;

/// Quaternions of the identity, of half turns and of a third of a turn about a diagonal.
const QUATERNIONS: [[f64; 4]; 6] = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, -1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
    [0.5, 0.5, 0.5, 0.5],
    [-1.0, 0.0, 0.0, 0.0],
];

/// Returns a state with accelerations. A special one is full of zeros, equal numbers and quarter
/// turns.
pub(super) fn state(layout: &Layout, is_special: bool, random: &mut Random) -> (State, Vec<f64>) {
    let same = random.between(-1.5, 1.5);
    let entry = |random: &mut Random| match random.below(if is_special { 6 } else { 1 }) {
        0 => random.between(-1.5, 1.5),
        1..4 => 0.0,
        4 => same,
        _ => FRAC_PI_2 * random.below(4) as f64,
    };
    let mut q = (0..layout.positions + layout.states.len()).map(|_| entry(random)).collect::<Vec<_>>();
    for slot in &layout.slots {
        if let Slot::Orientation { position, .. } = slot {
            let quaternion = if is_special {
                *random.choice(&QUATERNIONS)
            } else {
                let parts = [0, 1, 2, 3].map(|_| random.between(-1.0, 1.0));
                let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
                parts.map(|part| part / length)
            };
            q[*position..position + 4].copy_from_slice(&quaternion);
        }
    }
    let v = (0..layout.velocities).map(|_| entry(random)).collect();
    let wanted = (0..layout.velocities).map(|_| random.between(-2.0, 2.0)).collect();
    let t = if is_special { 0.0 } else { random.between(-2.0, 2.0) };
    (State { t, q, v }, wanted)
}
