//! Postures in which frames reach their goals, against closed forms and known postures.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use lagrange::kinematics::{FrameTask, InverseKinematics, ReachError, Shortfall, resolved_rates};
use lagrange::system::MechanicalSystem;

/// Two links in a plane.
mod planar {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Planar<S>;
        emit { frames, frame_jacobians }
        body upper { mass: 1; shape: slender_rod(0.4); }
        body lower { mass: 1; shape: slender_rod(0.3); }
        frame tip;
        revolute shoulder = ground to upper { axis: (0, 0, 1); }
        revolute elbow = upper to lower { at: (0.4, 0, 0); axis: (0, 0, 1); }
        weld lower to tip { at: (0.3, 0, 0); }
    }
}
use planar::Planar;

/// Two links in a plane with declared ranges of their joints.
mod ranged {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Ranged<S>;
        emit { frames, frame_jacobians }
        body upper { mass: 1; shape: slender_rod(0.4); }
        body lower { mass: 1; shape: slender_rod(0.3); }
        frame tip;
        revolute shoulder = ground to upper { axis: (0, 0, 1); }
        revolute elbow = upper to lower { at: (0.4, 0, 0); axis: (0, 0, 1); }
        weld lower to tip { at: (0.3, 0, 0); }
        range shoulder in -2..=2, elbow in pi/2..=3;
    }
}
use ranged::Ranged;

/// An arm with seven joints and the lengths of the Franka Emika Panda.
mod seven {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Seven;
        emit { frames, frame_jacobians }
        for i in 1..8 { body l[i] { mass: 1; shape: solid_sphere(0.1); } }
        frame hand;
        revolute q1 = ground to l[1] { at: (0, 0, 0.333); }
        revolute q2 = l[1] to l[2] { turned: (-pi/2, 0, 0); }
        revolute q3 = l[2] to l[3] { at: (0, -0.316, 0); turned: (pi/2, 0, 0); }
        revolute q4 = l[3] to l[4] { at: (0.0825, 0, 0); turned: (pi/2, 0, 0); }
        revolute q5 = l[4] to l[5] { at: (-0.0825, 0.384, 0); turned: (-pi/2, 0, 0); }
        revolute q6 = l[5] to l[6] { turned: (pi/2, 0, 0); }
        revolute q7 = l[6] to l[7] { at: (0.088, 0, 0); turned: (pi/2, 0, 0); }
        weld l[7] to hand { at: (0, 0, 0.2104); turned: (0, 0, -pi/4); }
    }
}
use seven::Seven;

/// A floating trunk with two legs.
mod walker {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Walker;
        emit { frames, frame_jacobians }
        body trunk { mass: 5; shape: cuboid(0.4, 0.2, 0.1); }
        free trunk;
        for i in 0..2 {
            body thigh[i] { mass: 1; shape: solid_sphere(0.05); }
            body shin[i] { mass: 1; shape: solid_sphere(0.05); }
            frame foot[i];
            universal (pitch[i], roll[i]) = trunk to thigh[i] { at: (0.2 - 0.4 * i, 0, 0); }
            revolute knee[i] = thigh[i] to shin[i] { at: (0, 0, -0.2); axis: (0, 1, 0); }
            weld shin[i] to foot[i] { at: (0, 0, -0.2); }
        }
    }
}
use walker::Walker;

/// A slide along each axis, in millimetres.
mod gantry {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Gantry;
        emit { frames, frame_jacobians }
        body bridge { mass: 1; shape: solid_sphere(1); }
        body carriage { mass: 1; shape: solid_sphere(1); }
        body tool { mass: 1; shape: solid_sphere(1); }
        prismatic x = ground to bridge { axis: (1, 0, 0); }
        prismatic y = bridge to carriage { axis: (0, 1, 0); }
        prismatic z = carriage to tool { axis: (0, 0, 1); }
    }
}
use gantry::Gantry;

/// Draws numbers between −1 and 1.
fn random(seed: &mut u64) -> f64 {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// Returns the largest difference of entries.
fn difference(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Limits of the joints of the arm.
const LIMITS: [(&str, f64, f64); 7] = [
    ("q1", -2.8973, 2.8973),
    ("q2", -1.7628, 1.7628),
    ("q3", -2.8973, 2.8973),
    ("q4", -3.0718, -0.0698),
    ("q5", -2.8973, 2.8973),
    ("q6", -0.0175, 3.7525),
    ("q7", -2.8973, 2.8973),
];
const HOME: [f64; 7] = [0.0, -FRAC_PI_4, 0.0, -3.0 * FRAC_PI_4, 0.0, FRAC_PI_2, FRAC_PI_4];

#[test]
fn two_links_obey_the_law_of_cosines() {
    let (arm, mut seed) = (Planar::<f64>::default(), 0x1234_5678_9abc_def1);
    for _ in 0..200 {
        let (reach, angle) = (0.4 + 0.299 * random(&mut seed), PI * random(&mut seed));
        let goal = [reach * angle.cos(), reach * angle.sin(), 0.0];
        let tasks = [FrameTask::position(Planar::tip_frame, Planar::tip_jacobian, goal)];
        let found =
            arm.reach(&tasks, &[angle - 0.5, 1.0]).within("elbow", 0.0, PI).solve().expect("in reach");
        let elbow = ((reach * reach - 0.16 - 0.09) / 0.24).acos();
        assert!((found.q[1] - elbow).abs() < 1e-10, "{found:?} {elbow}");
        assert!(found.iterations < 25, "{found:?}");
    }
}

#[test]
fn a_goal_out_of_reach_is_missed_by_the_least_distance() {
    let arm = Planar::<f64>::default();
    let goal = |x| [FrameTask::position(Planar::tip_frame, Planar::tip_jacobian, [x, 0.0, 0.0])];
    let far = goal(1.0);
    let Err(ReachError::Short(shortfall)) = arm.reach(&far, &[0.3, -0.4]).solve() else { panic!("reached") };
    assert!((shortfall.distance - 0.3).abs() < 1e-6 && shortfall.at_limit.is_none(), "{shortfall:?}");
    let message = ReachError::Short(shortfall).to_string();
    assert!(message.contains("task 0 is missed by the distance 0.3"), "{message}");
    // With the elbow at least at a right angle the arm is half a metre long.
    let limited = arm.reach(&far, &[0.3, 2.0]).within("elbow", FRAC_PI_2, 3.0).solve();
    let Err(ReachError::Short(shortfall)) = limited else { panic!("reached") };
    assert_eq!((shortfall.at_limit, shortfall.q[1]), (Some("elbow"), FRAC_PI_2));
    assert!((shortfall.distance - 0.5).abs() < 1e-6, "{shortfall:?}");
    // The nearest boundary of its reach is also a singular posture.
    let found = arm.reach(&goal(0.7), &[0.3, -0.4]).tolerance(1e-8).solve().expect("stretched");
    assert!(found.q[1].abs() < 1e-3, "{found:?}");
}

#[test]
fn declared_ranges_are_limits_unless_others_are_given() {
    let arm = Ranged::<f64>::default();
    let far = [FrameTask::position(Ranged::tip_frame, Ranged::tip_jacobian, [1.0, 0.0, 0.0])];
    for start in [[0.3, 2.0], [3.0, -1.0]] {
        let Err(ReachError::Short(shortfall)) = arm.reach(&far, &start).solve() else { panic!("reached") };
        assert_eq!((shortfall.at_limit, shortfall.q[1]), (Some("elbow"), FRAC_PI_2));
        assert!((shortfall.distance - 0.5).abs() < 1e-6, "{shortfall:?}");
    }
    let near = [FrameTask::position(Ranged::tip_frame, Ranged::tip_jacobian, [0.6, 0.0, 0.0])];
    assert!(arm.reach(&near, &[0.3, 2.0]).starts(20).solve().is_err());
    let widened = arm.reach(&near, &[0.3, 2.0]).within("elbow", 0.0, PI).solve().expect("in reach");
    assert!((widened.q[1].cos() - (0.36 - 0.16 - 0.09) / 0.24).abs() < 1e-12);

    let arm = Ranged::<f32>::default();
    let goal = [FrameTask::position(Ranged::tip_frame, Ranged::tip_jacobian, [0.3, 0.0, 0.0])];
    let found = arm.reach(&goal, &[-1.0, 2.0]).solve().expect("in reach");
    assert!((found.q[1].cos() - (0.09 - 0.16 - 0.09) / 0.24).abs() < 1e-5);
}

#[test]
fn seven_joints_reach_the_poses_of_random_postures_within_their_limits() {
    let (arm, mut seed) = (Seven, 0x9e37_79b9_7f4a_7c15);
    let (mut first, mut steps, mut reached) = (0, 0, 0);
    for _ in 0..300 {
        let q: [f64; 7] = LIMITS.map(|(_, lower, upper)| {
            let part = 0.5 + 0.49 * random(&mut seed);
            lower + part * (upper - lower)
        });
        let (rotation, position) = arm.hand_frame(0.0, &q);
        let tasks = [FrameTask::pose(Seven::hand_frame, Seven::hand_jacobian, (rotation, position))];
        let search = LIMITS.iter().fold(arm.reach(&tasks, &HOME), |search, (name, lower, upper)| {
            search.within(name, *lower, *upper)
        });
        first += u32::from(search.solve().is_ok());
        let Ok(found) = search.starts(40).solve() else { continue };
        let (turned, place) = arm.hand_frame(0.0, &found.q);
        assert!(distance(&place, &position) < 1e-10 && difference(&turned, &rotation) < 1e-10);
        assert!(found.q.iter().zip(LIMITS).all(|(q, (_, lower, upper))| (lower..=upper).contains(q)));
        (reached, steps) = (reached + 1, steps + found.iterations);
    }
    println!("{first} at once, {reached} from several starts, {steps} steps");
    assert!(reached == 300, "{first} at once, {reached} of 300");
}

#[test]
fn a_trunk_turns_and_its_feet_stand() {
    let walker = Walker;
    let mut seed = 0x0123_4567_89ab_cdef;
    let mut near = [0.0; 13];
    (near[2], near[3]) = (0.35, 1.0);
    for (name, angle) in [("pitch[0]", 0.3), ("pitch[1]", 0.3), ("knee[0]", -0.6), ("knee[1]", -0.6)] {
        near[Walker::COORDINATES.iter().position(|known| *known == name).expect("declared")] = angle;
    }
    for _ in 0..50 {
        let q: [f64; 13] = std::array::from_fn(|i| near[i] + 0.15 * random(&mut seed));
        let mut q = q;
        let length = q[3..7].iter().map(|x| x * x).sum::<f64>().sqrt();
        q[3..7].iter_mut().for_each(|x| *x /= length);
        let rotation = walker.trunk_frame(0.0, &q).0;
        let feet = [walker.foot_0_frame(0.0, &q).1, walker.foot_1_frame(0.0, &q).1];
        let tasks = [
            FrameTask::rotation(Walker::trunk_frame, Walker::trunk_jacobian, rotation),
            FrameTask::position(Walker::foot_0_frame, Walker::foot_0_jacobian, feet[0]),
            FrameTask::position(Walker::foot_1_frame, Walker::foot_1_jacobian, feet[1]),
        ];
        let found = walker.reach(&tasks, &near).solve().expect("in reach").q;
        assert!(difference(&walker.trunk_frame(0.0, &found).0, &rotation) < 1e-10);
        assert!(distance(&walker.foot_0_frame(0.0, &found).1, &feet[0]) < 1e-10);
        assert!(distance(&walker.foot_1_frame(0.0, &found).1, &feet[1]) < 1e-10);
        let length = found[3..7].iter().map(|x| x * x).sum::<f64>();
        assert!((length - 1.0).abs() < 1e-14, "unit quaternions stay so");
    }
}

#[test]
fn slides_in_millimetres_and_in_single_precision() {
    let gantry = Gantry;
    let tasks = [FrameTask::position(Gantry::tool_frame, Gantry::tool_jacobian, [1250.0, -730.5, 88.0])];
    let found = gantry.reach(&tasks, &[0.0; 3]).within("x", 0.0, 1250.0).solve().expect("in reach");
    assert!(distance(&found.q, &[1250.0, -730.5, 88.0]) < 1e-9, "{found:?}");

    let arm = Planar::<f32>::default();
    let tasks = [FrameTask::position(Planar::<f32>::tip_frame, Planar::<f32>::tip_jacobian, [0.3, 0.4, 0.0])];
    let found = arm.reach(&tasks, &[0.0, 1.0]).solve().expect("in reach");
    let (_, place) = arm.tip_frame(0.0, &found.q);
    assert!((place[0] - 0.3).abs() + (place[1] - 0.4).abs() < 1e-5, "{found:?}");
}

#[test]
fn invalid_goals_are_reported() {
    let arm = Planar::<f64>::default();
    let to = |goal| [FrameTask::position(Planar::tip_frame, Planar::tip_jacobian, goal)];
    let message = |error: ReachError<[f64; 2], f64>| error.to_string();
    let error = arm.reach(&to([f64::NAN, 0.0, 0.0]), &[0.1, 0.2]).solve().unwrap_err();
    assert_eq!(error, ReachError::Goal { task: 0 });
    let mirrored = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
    let tasks = [FrameTask::rotation(Planar::tip_frame, Planar::tip_jacobian, mirrored)];
    assert_eq!(arm.reach(&tasks, &[0.1, 0.2]).solve().unwrap_err(), ReachError::Goal { task: 0 });
    let tasks = to([0.3, 0.3, 0.0]);
    let unknown = arm.reach(&tasks, &[0.1, 0.2]).within("elbo", 0.0, 1.0).solve().unwrap_err();
    assert!(message(unknown).contains("`elbo`") && message(unknown).contains("\"shoulder\", \"elbow\""));
    let limits = arm.reach(&tasks, &[0.1, 0.2]).within("elbow", 1.0, 1.0).solve().unwrap_err();
    assert_eq!(message(limits), "the lower limit of `elbow` is not below its upper limit");
    assert_eq!(arm.reach(&tasks, &[f64::NAN, 0.2]).solve().unwrap_err(), ReachError::NotFinite);
    // Without tasks any posture is a solution.
    assert_eq!(arm.reach(&[], &[0.1, 0.2]).solve().expect("no goals").q, [0.1, 0.2]);
}

#[test]
fn resolved_rates_move_the_frame_as_given() {
    let arm = Seven;
    let jacobian = arm.hand_jacobian(0.0, &HOME);
    let (twist, preferred) = ([0.1, -0.2, 0.3, 0.4, -0.5, 0.6], [0.5, 0.0, -0.5, 0.2, 0.0, 0.0, 0.1]);
    let rates = resolved_rates(&jacobian, &twist, &preferred);
    for (row, twist) in jacobian.iter().zip(twist) {
        let found: f64 = row.iter().zip(&rates).map(|(entry, rate)| entry * rate).sum();
        assert!((found - twist).abs() < 1e-13);
    }
    // The remaining freedom follows the preference: the difference is a combination of rows.
    let null = resolved_rates(&jacobian, &[0.0; 6], &[0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    let along: f64 = (0..7).map(|i| null[i] * (rates[i] - preferred[i])).sum();
    assert!(null.iter().any(|rate| rate.abs() > 0.1) && along.abs() < 1e-13, "{along}");
}

/// A rod that a constraint keeps on a line.
mod guided {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Guided;
        emit { frames, frame_jacobians }
        body rod { mass: 1; shape: slender_rod(1); }
        frame carriage;
        prismatic x = ground to carriage { axis: (1, 0, 0); }
        prismatic y = carriage to rod { axis: (0, 1, 0); }
        constraint slot = y;
    }
    lagrange::system! {
        /// The rod with a constraint that no position satisfies.
        #[derive(Clone, Debug)]
        pub struct Impossible;
        emit { frames, frame_jacobians }
        body rod { mass: 1; shape: slender_rod(1); }
        prismatic x = ground to rod { axis: (1, 0, 0); }
        constraint nowhere = x^2 + 1;
    }
    lagrange::system! {
        /// A rolling rod: only its velocities are constrained.
        #[derive(Clone, Debug)]
        pub struct Rolling;
        emit { frames, frame_jacobians }
        body rod { mass: 1; shape: slender_rod(1); }
        body carriage { mass: 1; shape: slender_rod(1); }
        prismatic x = ground to carriage { axis: (1, 0, 0); }
        prismatic y = carriage to rod { axis: (0, 1, 0); }
        constraint slip = dot(y) - 2 * dot(x);
    }
}
use guided::{Guided, Impossible, Rolling};

/// Two arms that hold the same tip, on motors 0.3 m apart.
mod five_bar {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct FiveBar<S>;
        emit { frames, frame_jacobians }
        body left { mass: 1; shape: slender_rod(0.4); }
        body fore { mass: 1; shape: slender_rod(0.5); }
        body right { mass: 1; shape: slender_rod(0.4); }
        body hind { mass: 1; shape: slender_rod(0.5); }
        frame tip;
        revolute a = ground to left { axis: (0, 0, 1); }
        revolute b = left to fore { at: (0.4, 0, 0); axis: (0, 0, 1); }
        weld fore to tip { at: (0.5, 0, 0); }
        revolute c = ground to right { at: (0.3, 0, 0); axis: (0, 0, 1); }
        revolute d = right to hind { at: (0.4, 0, 0); axis: (0, 0, 1); }
        let gap = fore.point(0.5, 0, 0) - hind.point(0.5, 0, 0);
        constraint gap_x = gap.x;
        constraint gap_y = gap.y;
    }
}
use five_bar::FiveBar;

mod turning_five_bar {
    lagrange::system! {
        /// The five-bar mechanism on a base that turns at a given speed.
        #[derive(Clone, Debug)]
        pub struct Turning;
        param w = 100;
        emit { frames, frame_jacobians }
        body base { mass: 1; inertia: (1, 1, 1); }
        body left { mass: 1; shape: slender_rod(0.4); }
        body fore { mass: 1; shape: slender_rod(0.5); }
        body right { mass: 1; shape: slender_rod(0.4); }
        body hind { mass: 1; shape: slender_rod(0.5); }
        frame tip;
        revolute e = ground to base { axis: (0, 0, 1); }
        revolute a = base to left { axis: (0, 0, 1); }
        revolute b = left to fore { at: (0.4, 0, 0); axis: (0, 0, 1); }
        weld fore to tip { at: (0.5, 0, 0); }
        revolute c = base to right { at: (0.3, 0, 0); axis: (0, 0, 1); }
        revolute d = right to hind { at: (0.4, 0, 0); axis: (0, 0, 1); }
        let gap = fore.point(0.5, 0, 0) - hind.point(0.5, 0, 0);
        constraint gap_x = gap.x;
        constraint gap_y = gap.y;
        constraint drive = e - w * t;
    }
}
use turning_five_bar::Turning;

/// Returns the angles of an arm of 0.4 m and 0.5 m from (x, 0) to a point, by the law of cosines.
fn bent(x: f64, [px, py]: [f64; 2], side: f64) -> [f64; 2] {
    let (square, direction) = ((px - x).powi(2) + py * py, py.atan2(px - x));
    let elbow = ((square - 0.41) / 0.4).acos();
    let inner = ((square + 0.16 - 0.25) / (0.8 * square.sqrt())).acos();
    [direction + side * inner, -side * elbow]
}

#[test]
fn loops_stay_closed_on_the_way_to_a_goal() {
    let (linkage, mut seed) = (FiveBar::<f64>::default(), 7);
    for _ in 0..200 {
        let goal = [0.15 + 0.15 * random(&mut seed), 0.6 + 0.1 * random(&mut seed)];
        let task = [FrameTask::position(FiveBar::tip_frame, FiveBar::tip_jacobian, [goal[0], goal[1], 0.0])];
        // The loop is open at this start.
        let found =
            linkage.reach(&task, &[2.2, -1.4, 0.9, 1.4]).solve().unwrap_or_else(|e| panic!("{goal:?}: {e}"));
        let wanted = [bent(0.0, goal, 1.0), bent(0.3, goal, -1.0)].concat();
        for (found, wanted) in found.q.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-9, "{goal:?}: {found} {wanted}");
        }
    }
    let near = [2.2_f32, -1.4, 0.9, 1.4];
    let task = [FrameTask::position(FiveBar::tip_frame, FiveBar::tip_jacobian, [0.1_f32, 0.6, 0.0])];
    let found = FiveBar::<f32>::default().reach(&task, &near).solve().expect("is within reach");
    assert!((f64::from(found.q[2]) - bent(0.3, [0.1, 0.6], -1.0)[0]).abs() < 1e-4, "{found:?}");
}

/// Time is fixed during a search, however fast constraints move.
#[test]
fn moving_constraints_hold_a_posture_like_fixed_ones() {
    let linkage = Turning::default();
    for k in 0..20 {
        let goal = [0.015 * f64::from(k), 0.5 + 0.01 * f64::from(k)];
        let task = [FrameTask::position(Turning::tip_frame, Turning::tip_jacobian, [goal[0], goal[1], 0.0])];
        let found = linkage.reach(&task, &[0.0, 2.2, -1.4, 0.9, 1.4]).solve();
        let found = found.unwrap_or_else(|error| panic!("{goal:?}: {error}"));
        let wanted = [bent(0.0, goal, 1.0), bent(0.3, goal, -1.0)].concat();
        assert!(found.q[0].abs() < 1e-12);
        for (found, wanted) in found.q[1..].iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-9, "{goal:?}: {found} {wanted}");
        }
    }
}

#[test]
fn constraints_of_velocities_exclude_no_posture() {
    let task = [FrameTask::position(Rolling::rod_frame, Rolling::rod_jacobian, [2.0, 2.0, 0.0])];
    let found = Rolling.reach(&task, &[0.0; 2]).solve().expect("the rod rolls there on some way");
    assert!(found.q.iter().all(|entry| (entry - 2.0).abs() < 1e-9), "{:?}", found.q);
}

#[test]
fn limits_of_coupled_joints_are_checked() {
    let linkage = FiveBar::<f64>::default();
    let task = [FrameTask::position(FiveBar::tip_frame, FiveBar::tip_jacobian, [0.15, 0.6, 0.0])];
    let from = |reach: lagrange::kinematics::Reach<'_, _, 4>| reach.solve();
    let near = [2.2, -1.4, 0.9, 1.4];
    assert!(from(linkage.reach(&task, &near).within("d", 0.0, 2.0)).is_ok());
    let error = from(linkage.reach(&task, &near).within("d", 0.0, 0.5)).unwrap_err();
    assert!(matches!(error, ReachError::BeyondLimit { name: "d", .. }), "{error}");
    assert!(error.to_string().starts_with("constraints carry `d` beyond its limits"), "{error}");
    let far = [FrameTask::position(FiveBar::tip_frame, FiveBar::tip_jacobian, [0.15, 2.0, 0.0])];
    let error = linkage.reach(&far, &near).solve().unwrap_err();
    let ReachError::Short(Shortfall { q, distance, .. }) = error else { panic!("{error}") };
    // Both arms are stretched as far as the loop allows.
    let highest = (0.81 - 0.15_f64 * 0.15).sqrt();
    assert!((distance - (2.0 - highest)).abs() < 1e-6, "{distance} {q:?}");
}

#[test]
fn postures_beside_constraints_are_missed() {
    let rod = Guided;
    let to = |goal| [FrameTask::position(Guided::rod_frame, Guided::rod_jacobian, goal)];
    let along = rod.reach(&to([2.0, 0.0, 0.0]), &[0.0; 2]).solve().expect("along the slot");
    assert!((along.q[0] - 2.0).abs() < 1e-11);
    // Limits hold during the search even for a coordinate without constraints.
    let error = rod.reach(&to([2.0, 0.0, 0.0]), &[0.0; 2]).within("x", -1.0, 1.0).solve().unwrap_err();
    assert!(
        matches!(error, ReachError::Short(Shortfall { q: [1.0, _], at_limit: Some("x"), .. })),
        "{error:?}"
    );
    let error = rod.reach(&to([2.0, 1.0, 0.0]), &[0.0; 2]).solve().unwrap_err();
    // The nearest posture is in the slot.
    let ReachError::Short(Shortfall { q, distance, .. }) = error else { panic!("{error}") };
    assert!((q[0] - 2.0).abs() < 1e-6 && q[1] == 0.0 && (distance - 1.0).abs() < 1e-9, "{q:?}");
}

#[test]
fn constraints_that_cannot_be_satisfied_are_named() {
    let task = [FrameTask::position(Impossible::rod_frame, Impossible::rod_jacobian, [0.5, 0.0, 0.0])];
    let error = Impossible.reach(&task, &[0.3]).starts(3).solve().unwrap_err();
    assert!(matches!(error, ReachError::Constrained { .. }), "{error:?}");
    assert!(error.to_string().contains("`nowhere`"), "{error}");
}

/// With more joints than rows, JᵀJ is singular at every goal.
#[test]
fn a_hand_follows_a_circle_in_small_steps() {
    let (arm, mut q, mut steps) = (Seven, HOME, 0);
    let (rotation, [x, y, z]) = arm.hand_frame(0.0, &HOME);
    for k in 0..6500 {
        let (sin, cos) = (1e-3 * f64::from(k)).sin_cos();
        let goal = [x + 0.1 * sin, y + 0.1 * (cos - 1.0), z];
        let tasks = [FrameTask::pose(Seven::hand_frame, Seven::hand_jacobian, (rotation, goal))];
        let found = arm.reach(&tasks, &q).solve().unwrap_or_else(|error| panic!("{k}: {error}"));
        (q, steps) = (found.q, steps + found.iterations);
    }
    assert!(steps <= 2 * 6500, "{steps}");
}
