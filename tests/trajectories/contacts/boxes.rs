//! A box that is dropped, slides and tumbles on a rough floor: eight corners with redundant
//! contacts and friction.

use lagrange::Simulate;

/// Declares a box with impacts and friction in x and y at these corners.
macro_rules! thrown {
    ($($p:ident $corner:ident $along:ident $across:ident: $x:expr, $y:expr, $z:expr;)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            #[allow(deprecated, reason = "each direction has its own limit, which the tests expect")]
            struct Thrown;

            param mu = 0.5, e = 0.2;
            gravity = (0, 0, -9.81);
            body b { mass: 1; shape: cuboid(0.4, 0.3, 0.2); }
            free b;
            $(
                let $p = b.point($x, $y, $z);
                event $corner = $p.z, falling => impact(e);
                friction $along = dot($p).x, mu * $corner;
                friction $across = dot($p).y, mu * $corner;
            )*
        }
    };
}

thrown! {
    p0 c0 x0 y0: 0.2, 0.15, 0.1;
    p1 c1 x1 y1: 0.2, 0.15, -0.1;
    p2 c2 x2 y2: 0.2, -0.15, 0.1;
    p3 c3 x3 y3: 0.2, -0.15, -0.1;
    p4 c4 x4 y4: -0.2, 0.15, 0.1;
    p5 c5 x5 y5: -0.2, 0.15, -0.1;
    p6 c6 x6 y6: -0.2, -0.15, 0.1;
    p7 c7 x7 y7: -0.2, -0.15, -0.1;
}

/// Returns the box at this height, with angular velocity, velocity and orientation.
fn start(height: f64, turning: [f64; 3], velocity: [f64; 3], orientation: [f64; 4]) -> [f64; 13] {
    let length = orientation.iter().map(|part| part * part).sum::<f64>().sqrt();
    let mut state = [0.0; 13];
    state[2] = height;
    (0..4).for_each(|k| state[3 + k] = orientation[k] / length);
    state[7..10].copy_from_slice(&velocity);
    state[10..].copy_from_slice(&turning);
    state
}

/// Returns the final state of a run whose energy never increases.
fn settled(start: [f64; 13], end: f64) -> [f64; 13] {
    let run = Thrown::default().simulate(start).until(end).tolerance(1e-8).energy().run();
    let run = run.unwrap_or_else(|error| panic!("{start:?}: {error}"));
    let energy = run.column("energy").expect("it is recorded");
    assert!(energy.windows(2).all(|pair| pair[1] <= pair[0] + 1e-6), "{start:?}");
    run.last()
}

const FLAT: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

#[test]
fn a_flat_box_slides_until_friction_has_taken_its_speed() {
    let speed: f64 = 1.0;
    let slid = speed * speed / (2.0 * 0.5 * 9.81);
    let last = settled(start(0.1, [0.0; 3], [speed, 0.0, 0.0], FLAT), 1.0);
    assert!((last[0] - slid).abs() < 1e-5 && last[1].abs() < 1e-7, "{last:?}");
    // Each direction has its own limit: both decelerate independently.
    let last = settled(start(0.1, [0.0; 3], [speed, speed, 0.0], FLAT), 1.0);
    assert!((last[0] - slid).abs() < 1e-5 && (last[1] - slid).abs() < 1e-5, "{last:?}");
    assert!(last[7..].iter().all(|entry| entry.abs() < 1e-6), "{last:?}");
}

#[test]
fn a_box_that_spins_or_drops_on_its_face_stays_in_place() {
    for (height, spin) in [(0.1, 5.0), (0.3, 0.0)] {
        let last = settled(start(height, [0.0, 0.0, spin], [0.0; 3], FLAT), 2.0);
        assert!(last[0].abs() < 1e-5 && last[1].abs() < 1e-5, "{last:?}");
        assert!((last[2] - 0.1).abs() < 1e-6, "{last:?}");
        assert!(last[7..].iter().all(|entry| entry.abs() < 1e-6), "{last:?}");
    }
}

#[test]
fn tumbling_boxes_come_to_rest_on_a_face() {
    for (case, start) in [
        start(0.5, [1.0, 2.0, 0.5], [1.0, 0.5, 0.0], [1.0, 0.2, -0.3, 0.1]),
        start(0.5, [3.0, -2.0, 1.5], [-2.0, 1.0, 1.0], [0.3, 0.2, -0.3, 0.8]),
        start(0.5, [0.0; 3], [0.0; 3], [0.9, 0.3, 0.1, 0.0]),
    ]
    .into_iter()
    .enumerate()
    {
        let last = settled(start, 4.0);
        let heights = [0.2, 0.15, 0.1].map(|height| (last[2] - height).abs());
        assert!(heights.iter().any(|miss| *miss < 1e-6), "{case}: {last:?}");
        assert!(last[7..].iter().all(|entry| entry.abs() < 1e-6), "{case}: {last:?}");
    }
}
