//! A cylinder rolls down a slope and pulls a cuboid along a floor that is smooth at first and rough from there on.
//!
//! Both have the mass m; the rope runs over a massless pulley. The cuboid, 2 r long, is on smooth floor up to s =
//! l1; then the friction grows with the part of it that is on rough floor, to μ m g. The cylinder may meet a wall
//! at s = l3. From rest
//!
//! ```text
//! 5/4 v² = g s sin α                                on smooth floor,
//! 5/4 v² = g s sin α − μ g (s − l1)²/(4 r)          while the cuboid enters the rough floor,
//! 5/4 v² = g s sin α − μ g (s − l1 − r)             on rough floor,
//! ```
//!
//! so that it comes to rest at s = μ (l1 + r)/(μ − sin α), unless that is beyond the wall.
//!
//! The rope and the rolling are constraints; their multipliers are the force of the rope and the friction below the
//! cylinder. One more coordinate, w, has no inertia and a constraint on its velocity: it is the work of the
//! friction, integrated along with the motion. Look for T + V − w, which stays what it is at the start, and for
//! both ends: at rest for μ = 0.8, at the wall for μ = 0.6.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// The cuboid at s, the cylinder at x down the slope, turned by phi.
    #[derive(Clone, Debug)]
    pub struct Rope;

    param m = 1.0, r = 0.25, l1 = 1.0, l3 = 4.0, mu = 0.8, alpha = 30 * pi / 180, g = 9.81;
    coord s, x, phi, w;

    let full = mu * m * g;
    let grip = if s < l1 { 0 } else if s < l1 + 2 * r { full * (s - l1) / (2 * r) } else { full };
    kinetic = 1/2 * m * (dot(s)^2 + dot(x)^2) + 1/4 * m * r^2 * dot(phi)^2;
    potential = -m * g * x * sin(alpha);
    friction floor = dot(s), grip;
    constraint rope = s - x;
    constraint rolling = r * phi - x;
    constraint work = dot(w) + grip * dot(s);

    event enters = s - l1, rising => record;
    event rough = s - l1 - 2 * r, rising => record;
    event wall = s - l3, rising => stop;
    output rope_force = rope;
    output pull = ddot(s);
}

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Rope::default();
    let (last, system) = run(&scene, "mu = 0.8")?;
    let (q, v) = (last.coordinates(), last.velocities());
    let held = scene.m * scene.g * scene.alpha.sin();
    let [grip] = system.reactions(0.0, &q, &v);
    let rows = [
        ("s, m", last.s, 10.0 / 3.0),
        ("s_dot, m/s", last.s_dot, 0.0),
        ("friction, N", grip, -held),
        ("rope, N", system.rope_force(0.0, &q, &v), held),
    ];
    compare("mu = 0.8, at rest", 1e-9, &rows);

    let (last, _) = run(&Rope { mu: 0.6, ..scene }, "mu = 0.6")?;
    let speed = (0.8_f64 * 9.81 * 0.35).sqrt();
    compare("mu = 0.6, at the wall", 1e-10, &[("s, m", last.s, 4.0), ("s_dot, m/s", last.s_dot, speed)]);
    Ok(())
}

/// The last state, and the system with its friction as it is then. What happens on the way is compared with the formulas.
fn run(scene: &Rope, title: &str) -> Result<(RopeState, Rope), Box<dyn Error>> {
    let trajectory = scene
        .simulate([0.0; 8])
        .until(10.0)
        .tolerance(1e-13)
        .observe("balance", balance)
        .observe_each(["rope", "sag"], rope_force)
        .run()?;
    for event in trajectory.events() {
        let state = RopeState::from(event.state);
        let row = ("s_dot^2", state.s_dot.powi(2), squared_speed(scene, state.s));
        compare(
            &format!("{title}, {} at {:.6} s, s = {:.6} m", event.name, event.time, state.s),
            1e-12,
            &[row],
        );
    }
    let column = |name| trajectory.column(name).unwrap_or_default();
    let largest = |name| column(name).iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let slack = column("rope").iter().copied().fold(f64::INFINITY, f64::min);
    println!(
        "largest error of T + V - w {:.1e} J, of the rope's force {:.1e} N",
        largest("balance"),
        largest("sag")
    );
    println!("smallest force of the rope {slack:.3} N\n");
    assert!(largest("balance") < 1e-10 && largest("sag") < 1e-10 && slack > 0.0);
    let system = trajectory.system_at_end().unwrap_or(scene).clone();
    Ok((trajectory.last().into(), system))
}

/// T + V − w, which is zero at the start.
fn balance(rope: &Rope, t: f64, y: &[f64; 8]) -> f64 {
    let state = RopeState::from(*y);
    rope.energy(t, &state.coordinates(), &state.velocities()) - state.w
}

/// The force of the rope, and by how much it differs from m g sin α − 3/2 m s̈.
fn rope_force(rope: &Rope, t: f64, y: &[f64; 8]) -> [f64; 2] {
    let state = RopeState::from(*y);
    let (q, v) = (state.coordinates(), state.velocities());
    let force = rope.rope_force(t, &q, &v);
    let wanted = rope.m * (rope.g * rope.alpha.sin() - 1.5 * rope.pull(t, &q, &v));
    [force, force - wanted]
}

/// The square of the speed at s, by the formulas above.
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
