//! A cylinder that rolls down a slope pulls a cuboid over a floor that becomes rough. Values follow
//! from the energy balance, ½ m v² + ½ (m + J/r²) v² = m g s sin α − ∫ F_R ds with J = m r²/2.

use lagrange::Simulate;
use lagrange::simulate::Trajectory;

use crate::assert_within;

lagrange::system! {
    /// The cuboid at s, the cylinder at x down the slope; w is the work of the friction.
    #[derive(Clone, Debug)]
    struct Rope;

    param m = 1.0, r = 0.25, l1 = 1.0, l3 = 4.0, mu = 0.8, alpha = 30 * pi / 180, g = 9.81;
    coord s, x, phi, w;
    gravity = (0, -g);
    line ground {}
    line slope { angle: -alpha; }
    body cuboid { mass: m; shape: rectangle(2 * r, 2 * r); center: (s - l3 - 3 * r, r); }
    body cylinder {
        mass: m;
        shape: solid_cylinder(r);
        center: x * (cos(alpha), -sin(alpha)) + r * (sin(alpha), cos(alpha));
        angle: -phi;
    }
    slide cuboid.point(0, -r) on ground;
    roll contact = cylinder on slope;
    constraint rope = s - x;

    let full = mu * m * g;
    let grip = if s < l1 { 0 } else if s < l1 + 2 * r { full * (s - l1) / (2 * r) } else { full };
    friction floor = dot(s), grip;
    constraint work = dot(w) + grip * dot(s);
    event enters = s - l1, rising => record;
    event rough = s - l1 - 2 * r, rising => record;
    event wall = s - l3, rising => stop;
    output pulls = (rope, ddot(s), contact.friction);
}

fn run(rope: &Rope) -> Trajectory<Rope> {
    rope.simulate([0.0; 8]).until(10.0).tolerance(1e-13).every(0.02).run().expect("it runs")
}

/// Records accelerations along the motion, because only the system in its current mode knows the
/// forces.
fn pulls(rope: &Rope) -> Trajectory<Rope> {
    let observed = |rope: &Rope, t: f64, y: &[f64; 8]| {
        let state = RopeState::from(*y);
        rope.pulls(t, &state.coordinates(), &state.velocities())
    };
    let run = rope.simulate([0.0; 8]).until(10.0).tolerance(1e-13).every(0.02);
    run.observe_each(["rope", "pull", "friction"], observed).run().expect("it runs")
}

/// Returns v² by the three relations.
fn squared_speed(rope: &Rope, s: f64) -> f64 {
    let &Rope { r, l1, mu, alpha, g, .. } = rope;
    let lost = if s < l1 {
        0.0
    } else if s < l1 + 2.0 * r {
        (s - l1).powi(2) / (4.0 * r)
    } else {
        s - l1 - r
    };
    0.8 * g * (s * alpha.sin() - mu * lost)
}

#[test]
fn speed_follows_the_relation_of_each_phase() {
    for mu in [0.8, 0.6] {
        let rope = Rope { mu, ..Rope::default() };
        let mut phases = [0; 3];
        for (_, y) in run(&rope).iter() {
            let state = RopeState::from(y);
            assert_within(1e-11, state.s_dot * state.s_dot, squared_speed(&rope, state.s));
            let phase = usize::from(state.s >= rope.l1) + usize::from(state.s >= rope.l1 + 2.0 * rope.r);
            phases[phase] += 1;
        }
        assert!(phases.iter().all(|&samples| samples > 5), "{phases:?}");
    }
}

#[test]
fn on_the_smooth_floor_it_accelerates_uniformly() {
    let rope = Rope::default();
    let run = pulls(&rope);
    let [s, pull] = ["s", "pull"].map(|name| run.column(name).expect("it is there"));
    let smooth = s.iter().zip(pull).filter(|(s, _)| **s < rope.l1);
    let count = smooth.map(|(_, pull)| assert_within(1e-12, *pull, 0.4 * rope.g * rope.alpha.sin())).count();
    assert!(count > 20);
}

#[test]
fn strong_friction_brings_it_to_rest_at_ten_thirds() {
    let rope = Rope::default();
    let run = run(&rope);
    let last = RopeState::from(run.last());
    let sine = rope.alpha.sin();
    assert_within(1e-10, last.s, 10.0 / 3.0);
    assert_within(1e-10, last.s, rope.mu * (rope.l1 + rope.r) / (rope.mu - sine));
    assert_eq!(last.s_dot, 0.0);
    let names = run.events().iter().map(|event| event.name.as_str()).collect::<Vec<_>>();
    assert_eq!(names[..2], ["enters", "rough"]);
    assert!(!names.contains(&"wall"));
    let held = run.system_at_end().expect("it sticks");
    let (q, v) = (last.coordinates(), last.velocities());
    assert_within(1e-12, held.pulls(0.0, &q, &v)[0], rope.m * rope.g * sine);
}

#[test]
fn weak_friction_lets_it_hit_the_wall() {
    let rope = Rope { mu: 0.6, ..Rope::default() };
    let run = run(&rope);
    let last = RopeState::from(run.last());
    assert_eq!(run.events().last().map(|event| event.name.as_str()), Some("wall"));
    assert_within(1e-12, last.s, 4.0);
    assert!((last.s_dot - 1.6573).abs() < 5e-5, "{}", last.s_dot);
    assert_within(1e-12, last.s_dot, (0.8_f64 * 9.81 * 0.35).sqrt());
}

/// S = m g sin α − 3/2 m s̈ > 0: the rope stays taut. The friction below the cylinder is J φ̈/r.
#[test]
fn the_rope_always_pulls() {
    for mu in [0.8, 0.6] {
        let rope = Rope { mu, ..Rope::default() };
        let run = pulls(&rope);
        let [force, pull, friction] =
            ["rope", "pull", "friction"].map(|name| run.column(name).expect("it is there"));
        for i in 0..run.len() {
            assert_within(1e-11, force[i], rope.m * (rope.g * rope.alpha.sin() - 1.5 * pull[i]));
            assert_within(1e-11, friction[i], -rope.m * pull[i] / 2.0);
            assert!(force[i] > 0.0);
        }
    }
}

#[test]
fn energy_changes_by_the_work_of_the_friction() {
    for mu in [0.8, 0.6] {
        let rope = Rope { mu, ..Rope::default() };
        let energy = |state: RopeState| rope.energy(0.0, &state.coordinates(), &state.velocities());
        let start = energy([0.0; 8].into());
        let lost = run(&rope).iter().fold(0.0, |_, (_, y)| {
            let state = RopeState::from(y);
            assert_within(1e-11, energy(state), start + state.w);
            state.w
        });
        assert!(lost < -1.0, "{lost}");
    }
}
