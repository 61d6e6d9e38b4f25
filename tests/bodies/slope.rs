//! A sliding cuboid and a rolling cylinder on a slope, both of mass m and from rest, the cuboid a
//! distance d above. Source of the values: Newton's laws for both bodies, m ẍ = m g sin α − H and J
//! φ̈ = H r with J = m r²/2.

use lagrange::Simulate;

use crate::assert_within;

lagrange::system! {
    /// Each body by the position of its centre.
    #[derive(Clone, Debug)]
    struct Slope;

    param m = 1.0, r = 0.25, alpha = 30 * pi / 180, g = 9.81;
    coord x1, y1, x2, y2, phi;
    gravity = (0, -g);
    line slope { angle: -alpha; }
    body cuboid { mass: m; shape: rectangle(2 * r, 2 * r); center: (x1, y1); angle: -alpha; }
    body cylinder { mass: m; shape: solid_cylinder(r); center: (x2, y2); angle: phi; }
    slide foot = cuboid.point(0, -r) on slope;
    roll contact = cylinder on slope;
    event touch = slope.along(cylinder) - slope.along(cuboid) - 2 * r, falling => stop;
    output forces = (foot.normal, contact.normal, contact.friction);
    output on_cuboid = foot.force;
    output on_cylinder = contact.force;
    output places = (slope.along(cuboid), slope.along(cylinder));
    output heights = (slope.distance(cuboid), slope.distance(cylinder));
    output of_cuboid = acceleration(cuboid);
    output of_cylinder = acceleration(cylinder);
}

/// d, in m.
const DISTANCE: f64 = 10.0;
const MASSES: [f64; 5] = [1e-3, 0.2, 1.0, 40.0, 3e4];
/// sqrt(6 d/(g sin α)) for α = 30°, d = 10 m, g = 9.81 m/s².
const TIME: f64 = 3.497_487_084;

fn start(slope: &Slope) -> SlopeState {
    let (sine, cosine) = slope.alpha.sin_cos();
    let on_slope = |s: f64| [s * cosine + slope.r * sine, slope.r * cosine - s * sine];
    let ([x1, y1], [x2, y2]) = (on_slope(0.0), on_slope(DISTANCE + 2.0 * slope.r));
    SlopeState { x1, y1, x2, y2, ..SlopeState::from([0.0; 10]) }
}

#[test]
fn multipliers_are_normal_forces_and_the_friction_that_makes_the_cylinder_roll() {
    for m in MASSES {
        let slope = Slope { m, ..Slope::default() };
        let (q, v) = (start(&slope).coordinates(), [0.0; 5]);
        let [cuboid, cylinder, friction] = slope.forces(0.0, &q, &v).map(|force| force / (m * slope.g));
        assert_within(1e-13, cuboid, slope.alpha.cos());
        assert_within(1e-13, cylinder, slope.alpha.cos());
        // The friction points up the slope, the line down.
        assert_within(1e-13, -friction, slope.alpha.sin() / 3.0);
        let [x, y] = slope.on_cylinder(0.0, &q, &v).map(|force| force / (m * slope.g));
        let (sine, cosine) = slope.alpha.sin_cos();
        assert_within(1e-13, x, cosine * sine - sine * cosine / 3.0);
        assert_within(1e-13, y, cosine * cosine + sine * sine / 3.0);
    }
}

#[test]
fn the_cylinder_accelerates_at_two_thirds_of_what_the_cuboid_does() {
    let slope = Slope::default();
    let (q, v) = (start(&slope).coordinates(), [0.0; 5]);
    let (sine, cosine) = slope.alpha.sin_cos();
    let drive = slope.g * sine;
    for (found, size) in
        [(slope.of_cuboid(0.0, &q, &v), drive), (slope.of_cylinder(0.0, &q, &v), 2.0 / 3.0 * drive)]
    {
        assert_within(1e-13, found[0], size * cosine);
        assert_within(1e-13, found[1], -size * sine);
    }
    let [.., turning] = slope.acceleration(0.0, &q, &v);
    assert_within(1e-13, turning, -2.0 / 3.0 * drive / slope.r);
}

#[test]
fn they_touch_at_the_same_time_whatever_their_mass() {
    for m in MASSES {
        let slope = Slope { m, ..Slope::default() };
        let begin = start(&slope);
        let run = slope.simulate(begin).until(100.0).tolerance(1e-13).run().expect("it runs");
        let (t, drive) = (run.end_time(), slope.g * slope.alpha.sin());
        assert_eq!(run.events().len(), 1);
        assert!((t - TIME).abs() < 5e-10, "{t}");
        assert_within(1e-13, t, (6.0 * DISTANCE / drive).sqrt());
        let end = SlopeState::from(run.last());
        let (q, v) = (end.coordinates(), end.velocities());
        let ([s1, s2], [s10, s20]) =
            (slope.places(t, &q, &v), slope.places(0.0, &begin.coordinates(), &[0.0; 5]));
        assert_within(1e-12, s1 - s10, drive * t * t / 2.0);
        assert_within(1e-12, s2 - s20, drive * t * t / 3.0);
        for height in slope.heights(t, &q, &v) {
            assert_within(1e-13, height, slope.r);
        }
    }
}

/// N is constant along the motion. T + V is conserved, since the friction of rolling does no work.
#[test]
fn forces_are_constant_and_energy_is_conserved() {
    let slope = Slope::default();
    let run = slope
        .simulate(start(&slope))
        .until(100.0)
        .tolerance(1e-13)
        .every(0.1)
        .energy()
        .run()
        .expect("it runs");
    let energy = run.column("energy").expect("it is observed");
    for ((t, y), now) in run.iter().zip(energy) {
        assert_within(1e-12, *now, energy[0]);
        let state = SlopeState::from(y);
        let [cuboid, ..] = slope.forces(t, &state.coordinates(), &state.velocities());
        assert_within(1e-12, cuboid, slope.m * slope.g * slope.alpha.cos());
    }
    assert!(run.len() > 30);
}
