//! An imported robot with stops, dry friction and feet, against the numbers in its file.

use lagrange::Simulate;
use lagrange::contact::{Contact, Friction};

use super::G;

/// `walker.urdf` with all options, as `lagrange urdf` writes it.
pub(super) mod compiled {
    include!("../../../crates/lagrange-import/tests/data/walker_standing.rs");
}
use compiled::{Walker, WalkerState};

/// Weight of the trunk, the legs, the mast and its load.
pub(super) const WEIGHT: f64 = G * (4.0 + 4.0 * 0.3 + 0.5 + 0.2);
/// Coefficient of friction of the feet, and the dry friction of the mast. This is its own, plus
/// half of that of the weight, which follows at half its speed.
const FRICTION: [f64; 2] = [0.6, 0.5 + 0.5 * 0.2];
const TOLERANCE: f64 = 1e-8;

/// Returns the distances from the limits in the file, including those of the follower.
pub(super) fn gaps(state: &WalkerState) -> [f64; 12] {
    let WalkerState { fl_hip, fr_hip, rl_hip, rr_hip, lift, belt, .. } = *state;
    let ends = |q: f64, lower: f64, upper: f64| [q - lower, upper - q];
    let front = [fl_hip, fr_hip].map(|hip| ends(hip, -0.3, 0.25));
    let rear = [rl_hip, rr_hip].map(|hip| ends(hip, 0.1, 0.35));
    let masts = [ends(lift, -0.05, 0.08), ends(belt, -0.02, 0.05)];
    let [[a, b], [c, d], [e, f]] = [front, rear, masts];
    let pairs = [a, b, c, d, e, f];
    std::array::from_fn(|i| pairs[i / 2][i % 2])
}

/// Returns the normal force and the two friction forces of each foot. All forces push and are
/// within their limits.
fn feet(walker: &Walker, t: f64, state: &WalkerState) -> [[f64; 3]; 4] {
    let reactions = walker.reactions(t, &state.coordinates(), &state.velocities());
    let feet = std::array::from_fn(|foot| std::array::from_fn(|axis| reactions[11 + 3 * foot + axis]));
    assert!(reactions[..10].iter().all(|stop| *stop >= 0.0), "{t}: {reactions:?}");
    assert!(reactions[10].abs() <= FRICTION[1] + TOLERANCE, "{t}: {reactions:?}");
    let is_within =
        |[normal, x, y]: [f64; 3]| normal >= 0.0 && x.hypot(y) <= FRICTION[0] * normal + TOLERANCE;
    assert!(feet.into_iter().all(is_within), "{t}: {feet:?}");
    feet
}

#[test]
fn a_robot_that_is_dropped_stands_on_its_feet_within_the_limits_of_its_file() {
    let (mut walker, mut t) = (Walker::default(), 0.0);
    let mut state = walker.start();
    assert!(gaps(&state).iter().all(|gap| *gap > 0.0), "it starts between the limits");
    (state.trunk_z, state.trunk_qx, state.trunk_qw) = (0.35, 0.05, (1.0_f64 - 0.05 * 0.05).sqrt());
    for _ in 0..5 {
        let run = walker.simulate(state).from(t).until(t + 0.2).every(0.005).tolerance(TOLERANCE);
        let run = run.run().expect("it moves");
        for (time, state) in run.iter() {
            let gaps = gaps(&WalkerState::from(state));
            assert!(gaps.iter().all(|gap| *gap > -TOLERANCE), "{time}: {gaps:?}");
        }
        (t, state) = (t + 0.2, WalkerState::from(run.last()));
        walker = run.system_at_end().expect("a system").clone();
        feet(&walker, t, &state);
    }
    let speed = state.velocities().iter().fold(0.0_f64, |speed, v| speed.max(v.abs()));
    assert!(speed < 1e-12, "it is at rest: {speed}");
    assert_eq!((walker.lift_lower, walker.lift_friction), (Contact::Closed, Friction::Sticks));
    let feet = feet(&walker, t, &state);
    let [normal, x, y] = [0, 1, 2].map(|axis| feet.iter().map(|force| force[axis]).sum::<f64>());
    assert!((normal - WEIGHT).abs() < 1e-8 * WEIGHT, "{normal} carry {WEIGHT}");
    assert!(x.abs().max(y.abs()) < 1e-8 * WEIGHT, "nothing pushes it aside: {x}, {y}");
}

#[test]
fn motors_give_their_efforts_and_no_more() {
    let pushed = |u: f64| {
        let walker = Walker { u_fl_hip: u, ..Walker::default() };
        let state = walker.start();
        walker.acceleration(0.0, &state.coordinates(), &state.velocities())
    };
    assert_eq!(pushed(6.0), pushed(1e3));
    assert_eq!(pushed(-6.0), pushed(f64::NEG_INFINITY));
    assert_ne!(pushed(6.0), pushed(5.9));
    assert!(pushed(f64::NAN).iter().any(|a| a.is_nan()), "NaN is no effort");
}
