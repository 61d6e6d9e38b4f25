//! Films of declarations in both forms: compiled by the macro, and read as text. Pages must be
//! identical, byte by byte.

use lagrange::Simulate;
use lagrange::draw::{DrawError, Drawing, DrawnSpace};
use lagrange::scene::Scene;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{DeclaredFilm, DeclaredSystem};

/// Compiles a declaration and keeps its text.
macro_rules! both_ways {
    ($System:ident = $TEXT:ident { $($statements:tt)* }) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            pub(crate) struct $System;
            $($statements)*
        }
        const $TEXT: &str =
            concat!("pub(crate) struct ", stringify!($System), ";", stringify!($($statements)*));
    };
}

// A line, a joint, a connector, a hole and a polygon.
both_ways! {
    SwingOnWheels = SWING_ON_WHEELS {
        param m = 1.0, r = 0.2, l = 1.5, k = 30.0, g = 9.81;
        coord x, phi;
        gravity = (0, -g);
        let turn = x / r;
        line rail { through: (0, 0); angle: 0; }
        body wheel { mass: m; shape: disk(r); center: (x, r); angle: -turn; }
        body bob {
            compound { rectangle(0.4, 0.3), mass: 2 * m; hole disk(0.1), mass: m / 10, at: (0.05, 0); }
            center: wheel.center + l * (sin(phi), -cos(phi));
            angle: phi;
        }
        body flag { mass: m / 10; shape: polygon((0, 0), (0.3, 0), (0, 0.4)); center: (x, 2 * r); angle: 0; }
        roll wheel on rail;
        spring leash { from: bob.center; to: (1, 1); stiffness: k; rest: 1; }
        emit { drawing }
    }
}

// A force of a constraint, a torque, a damper, and a force at a point.
both_ways! {
    PinnedRod = PINNED_ROD {
        gravity = (0, -9.81);
        coord x, y, phi;
        body rod { mass: 2; shape: slender_rod(1); center: (x, y); angle: phi; }
        pin hinge = rod.point(-0.5, 0) to (0, 0);
        damper brake { from: rod.point(0.5, 0); to: (1, 1); damping: 0.5; }
        torque -0.3 * dot(phi) on phi;
        force (0.5, sin(t)) at rod.point(0.5, 0);
        emit { drawing }
    }
}

both_ways! {
    SpinningTop = SPINNING_TOP {
        gravity = (0, 0, -9.81);
        body rotor { mass: 0.5; shape: cone(0.05, 0.1); }
        body bob { mass: 0.1; shape: hollow_cylinder(0.01, 0.02, 0.05); centroid: (0, 0, -0.1); }
        ball tip = ground to rotor;
        revolute hinge = rotor to bob { at: (0.05, 0, 0.1); axis: (0, 1, 0); }
        spring string { from: bob.origin; to: (0.2, 0, 0.3); stiffness: 2; rest: 0.1; }
        force hinge = -0.01 * dot(hinge);
        emit { drawing }
    }
}

// Terrain with a limited domain, by a function and by a table, whose samples beyond are not finite.
both_ways! {
    BallInBowl = BALL_IN_BOWL {
        param m = 1.0;
        coord x, y;
        gravity = (0, -9.81);
        table ramp(s) = [(-1, 0), (0, 0.1), (1, 0)], interpolation: natural, outside: error;
        terrain bowl { height(s): 1 - sqrt(1 - s^2); }
        terrain ridge { height(s): ramp(s) - 1; }
        body ball { mass: m; shape: disk(0.1); center: (x, y); }
        emit { drawing }
    }
}

// A contact with friction.
both_ways! {
    SlidingDisk = SLIDING_DISK {
        coord x, y, phi;
        gravity = (0, -9.81);
        line floor { through: (0, 0); angle: 0; }
        body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(0.3); }
        contact touch = wheel on floor { friction: 0.2; restitution: 0.4; }
        emit { drawing }
    }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct BallInDish;
    gravity = (0, 0, -9.81);
    coord x, y, z;
    terrain dish { height(s, r): 1 - sqrt(1 - s^2 - r^2); }
    body ball { mass: 1; shape: solid_sphere(0.1); center: (x, y, z); }
    emit { drawing }
}

/// Compares the pages of a motion, without and with forces. Its initial state lists the entries in
/// order.
fn compare<M: Scene<Scalar = f64, Space: DrawnSpace>>(
    text: &str,
    compiled: &M,
    start: M::State,
    title: &str,
) {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    let system = DeclaredSystem::new(programs).unwrap_or_else(|refusal| panic!("{refusal}"));
    let motion = compiled.simulate(start).until(0.5).every(0.05).run().expect("a motion");
    let states = motion.iter().map(|(_, state)| state).collect::<Vec<_>>();
    let drawing = || Drawing::of(compiled).title(title);
    let pages = [(drawing(), false), (drawing().forces(), true)].map(|(drawing, has_forces)| {
        let states = states.iter().map(AsRef::as_ref);
        let film = DeclaredFilm::new(&system, motion.times(), states, has_forces).expect("a film").html();
        let wanted = drawing.film(&motion).expect("a film").html();
        assert!(wanted.len() > 10_000, "a page of {} bytes", wanted.len());
        assert!(film == wanted, "the pages of `{title}` differ, with forces: {has_forces}");
        film
    });
    assert!(pages[0] != pages[1], "no force of `{title}` is drawn");
}

#[test]
fn films_in_the_plane_are_those_of_compiled_types() {
    compare(SWING_ON_WHEELS, &SwingOnWheels::default(), [0.0, 0.5, 0.3, 0.0], "Swing on wheels");
}

#[test]
fn forces_of_constraints_are_those_of_compiled_types() {
    compare(PINNED_ROD, &PinnedRod, [0.5, 0.0, 0.0, 0.0, 0.0, 0.0], "Pinned rod");
}

#[test]
fn forces_of_contacts_are_those_of_compiled_types() {
    compare(SLIDING_DISK, &SlidingDisk::default(), [0.0, 0.35, 0.0, 1.0, 0.0, 0.0], "Sliding disk");
    compare(SLIDING_DISK, &SlidingDisk::default(), [0.0, 0.3, 0.0, 1.0, 0.0, 0.0], "Sliding disk");
}

#[test]
fn films_in_space_are_those_of_compiled_types() {
    let start = [1.0, 0.2, 0.0, 0.0, 0.3, 0.0, 0.0, 20.0, 0.0];
    compare(SPINNING_TOP, &SpinningTop, start, "Spinning top");
}

#[test]
fn films_show_terrain_with_a_limited_domain() {
    let start = [0.3, 0.5, 0.0, 0.0];
    compare(BALL_IN_BOWL, &BallInBowl::default(), start, "Ball in bowl");
    assert!(Drawing::of(&BallInBowl::default()).picture(0.0, &start).is_ok());
    let beyond = Drawing::of(&BallInBowl::default()).picture(0.0, &[9.0, 0.5, 0.0, 0.0]);
    assert!(matches!(beyond, Err(DrawError::NotFinite { item, .. }) if item == "bowl"));
    let dish = |x: f64| Drawing::of(&BallInDish).picture(0.0, &[x, 0.0, 0.5, 0.0, 0.0, 0.0]);
    assert!(dish(1.05).is_ok());
    assert!(matches!(dish(9.0), Err(DrawError::NotFinite { item, .. }) if item == "dish"));
}
