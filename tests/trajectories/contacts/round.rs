//! Circles, spheres and cylinders, outside and inside.

use lagrange::Simulate;
use lagrange::contact::{EventKind, Friction};

use crate::{G, assert_near, flat, pendulum_period};

lagrange::system! {
    /// A disk in a round bowl.
    #[derive(Clone, Debug)]
    struct Bowl<S>;

    param r = 0.1, size = 0.9, mu = 2;
    coord x, y, phi;
    gravity = (0, -9.81);
    circle bowl { center: (0, size); radius: size; }
    body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(r); }
    contact touch = wheel inside bowl { friction: mu; }
    output slip = touch.slip;
}

lagrange::system! {
    /// A ball in a round bowl.
    #[derive(Clone, Debug)]
    struct SphericalBowl;

    param r = 0.1, size = 0.9, mu = 2;
    gravity = (0, 0, -9.81);
    sphere bowl { center: (0, 0, size); radius: size; }
    body ball { mass: 2; shape: solid_sphere(r); }
    free ball;
    contact touch = ball inside bowl { friction: mu; }
}

lagrange::system! {
    /// A ball in a gutter along an oblique horizontal axis.
    #[derive(Clone, Debug)]
    struct Gutter;

    param r = 0.1, size = 0.9, mu = 2;
    gravity = (0, 0, -9.81);
    cylinder gutter { through: (0, 0, size); axis: (3, 4, 0); radius: size; }
    body ball { mass: 2; shape: solid_sphere(r); }
    free ball;
    contact touch = ball inside gutter { friction: mu; }
}

lagrange::system! {
    /// A ball on a fixed frictionless cylinder.
    #[derive(Clone, Debug)]
    struct Barrel;

    param r = 0.1;
    gravity = (0, 0, -9.81);
    body barrel { mass: 1; origin: (0, 0, 0); inertia: (1, 1, 1); shape: solid_cylinder(0.5, 2); angles: (pi/2, 0, 0); sequence: yxy; }
    body ball { mass: 2; shape: solid_sphere(r); }
    free ball;
    contact touch = ball on barrel;
}

lagrange::system! {
    /// A ball on a frictionless globe.
    #[derive(Clone, Debug)]
    struct Globe;

    param r = 0.1, size = 0.5;
    gravity = (0, 0, -9.81);
    sphere globe { radius: size; }
    body ball { mass: 2; shape: solid_sphere(r); }
    free ball;
    contact touch = ball on globe;
}

lagrange::system! {
    /// Two disks that touch nothing else.
    #[derive(Clone, Debug)]
    struct Disks;

    param mu = 0.2, e = 0.5;
    coord a, b, alpha, x, y, phi;
    body first { mass: 2; center: (a, b); angle: alpha; shape: disk(0.3); }
    body second { mass: 1; center: (x, y); angle: phi; shape: disk(0.2); }
    contact touch = second on first { friction: mu; restitution: e; }
    output momentum = linear_momentum(first) + linear_momentum(second);
    output spin = angular_momentum(first) + angular_momentum(second);
}

lagrange::system! {
    /// Two balls that touch nothing else.
    #[derive(Clone, Debug)]
    struct Balls;

    param mu = 0.2, e = 0.5;
    gravity = (0, 0, 0);
    body first { mass: 2; shape: solid_sphere(0.3); }
    free first;
    body second { mass: 1; shape: solid_sphere(0.2); }
    free second;
    contact touch = second on first { friction: mu; restitution: e; }
    output momentum = linear_momentum(first) + linear_momentum(second);
    output spin = angular_momentum(first) + angular_momentum(second);
}

lagrange::system! {
    /// A ball against a floating cylinder.
    #[derive(Clone, Debug)]
    struct Drum;

    param mu = 0.2, e = 0.5;
    gravity = (0, 0, 0);
    body first { mass: 2; shape: solid_cylinder(0.3, 2); }
    free first;
    body second { mass: 1; shape: solid_sphere(0.2); }
    free second;
    contact touch = second on first { friction: mu; restitution: e; }
    output momentum = linear_momentum(first) + linear_momentum(second);
    output spin = angular_momentum(first) + angular_momentum(second);
}

/// Rolling in a bowl is the motion of a pendulum of length κ (R − r), κ = 1 + J/mr².
#[test]
fn rolling_in_a_bowl_has_the_period_of_a_pendulum() {
    for amplitude in [0.05_f64, 1.0] {
        let (sin, cos) = amplitude.sin_cos();
        let start = [0.8 * sin, 0.9 - 0.8 * cos, 0.0, 0.0, 0.0, 0.0];
        let period = pendulum_period(1.5 * 0.8, amplitude);
        let run = Bowl::<f64>::default().simulate(start).until(period).tolerance(1e-12).run().expect("rolls");
        assert_near(run.last(), start, 1e-8);
        assert_eq!(run.system_at_end().expect("touches").touch_friction, Friction::Sticks);
        let single = Bowl::<f32>::default().simulate(start.map(|x| x as f32)).until(period as f32).run();
        assert_near(single.expect("rolls").last().map(f64::from), start, 2e-3);
        let start = flat([0.8 * sin, 0.0, 0.9 - 0.8 * cos], [0.0; 3], [0.0; 3]);
        let period = pendulum_period(1.4 * 0.8, amplitude);
        let run =
            SphericalBowl::default().simulate(start).until(period).tolerance(1e-12).run().expect("rolls");
        let last = run.last();
        assert_near([last[0], last[1], last[2], last[7]], [0.8 * sin, 0.0, 0.9 - 0.8 * cos, 0.0], 1e-8);
        let across = [0.8, -0.6].map(|part| 0.8 * sin * part);
        let start = flat([across[0], across[1], 0.9 - 0.8 * cos], [0.0; 3], [0.0; 3]);
        let last =
            Gutter::default().simulate(start).until(period).tolerance(1e-12).run().expect("rolls").last();
        assert_near([last[0], last[1], last[2], last[7]], [across[0], across[1], 0.9 - 0.8 * cos, 0.0], 1e-8);
    }
}

/// cos θ = 2/3 (cos θ₀ + v²/2gL) where it leaves the round surface.
#[test]
fn a_ball_leaves_what_is_round_at_two_thirds() {
    let start = flat([0.0, 0.0, 0.6], [0.0, 0.3, 0.0], [0.0; 3]);
    let wanted = 2.0 / 3.0 * (1.0 + 0.09 / (2.0 * G * 0.6));
    let check = |events: &[lagrange::simulate::Event<f64, [f64; 13]>]| {
        let opened = events.iter().find(|event| event.kind == EventKind::Opened).expect("it leaves");
        assert_near([opened.state[2] / 0.6], [wanted], 1e-9);
    };
    check(Globe::default().simulate(start).until(2.0).tolerance(1e-12).run().expect("falls").events());
    check(Barrel::default().simulate(start).until(2.0).tolerance(1e-12).run().expect("falls").events());
}

/// Force and moment are opposite on both bodies, and the impulse is in the cone.
#[test]
fn collisions_keep_momenta() {
    macro_rules! check {
        ($system:expr, $start:expr, $names:expr) => {
            let run = $system
                .simulate($start)
                .until(1.0)
                .tolerance(1e-12)
                .energy()
                .outputs()
                .run()
                .expect("collides");
            assert_eq!(run.events().len(), 1);
            for name in $names {
                let values = run.column(name).unwrap_or_else(|| panic!("no {name}"));
                assert!(values.iter().all(|value| (value - values[0]).abs() < 1e-9), "{name}");
            }
            let energy = run.column("energy").expect("an energy");
            assert!(energy[energy.len() - 1] < 0.99 * energy[0]);
        };
    }
    let start = [0.0, 0.0, 0.0, 1.0, 0.2, 0.0, 0.3, 0.5, 3.0, -1.0, 0.4, 5.0];
    check!(Disks::default(), start, ["momentum.x", "momentum.y", "spin"]);
    let names = ["momentum.x", "momentum.y", "momentum.z", "spin.x", "spin.y", "spin.z"];
    let (first, second) = ([[0.2, 0.1, 0.3], [1.0, 2.0, 3.0]], [[-1.0, 0.3, -0.2], [4.0, -5.0, 6.0]]);
    let first = flat([0.0; 3], first[0], first[1]);
    let second = flat([1.0, 0.1, 0.4], second[0], second[1]);
    let start: Vec<f64> = [&first[..7], &second[..7], &first[7..], &second[7..]].concat();
    let start: [f64; 26] = start.try_into().expect("twenty-six");
    check!(Balls::default(), start, names);
    check!(Drum::default(), start, names);
}
