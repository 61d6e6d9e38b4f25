//! Motions of `contact` statements against handwritten declarations.

use lagrange::Simulate;
use lagrange::integrate::Radau5;

use crate::flat;

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Ball<S>;

    param mu = 0.3, e = 0.5, r = 0.1;
    gravity = (0, 0, -9.81);
    body b { mass: 1; shape: solid_sphere(r); }
    free b;
    contact floor = b on ground { friction: mu; restitution: e; }
    output load = floor;
    output gap = floor.gap;
    output grip = floor.friction;
    output slip = floor.slip;
    output pushing = floor.force;
    output foot = floor.point;
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct BallByHand<S>;

    param mu = 0.3, e = 0.5, r = 0.1;
    gravity = (0, 0, -9.81);
    body b { mass: 1; shape: solid_sphere(r); }
    free b;
    let slip = dot(b.origin) + cross(angular_velocity(b), (0, 0, -r));
    event floor = b.origin.z - r, falling => impact(e);
    friction rub = (slip.x, slip.y), mu * floor;
    output load = floor;
    output grip = rub;
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Disk;

    param r = 0.3, mu = 0.3, hold = 0.35, e = 0.4, angle = 0.3;
    coord x, y, phi;
    gravity = (0, -9.81);
    line slope { angle: -angle; }
    body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(r); }
    contact touch = wheel on slope { kinetic: mu; static: hold; restitution: e; }
    output load = touch.normal;
    output grip = touch.friction;
    output push = touch.force;
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct DiskByHand;

    param r = 0.3, mu = 0.3, hold = 0.35, e = 0.4, angle = 0.3;
    coord x, y, phi;
    gravity = (0, -9.81);
    line slope { angle: -angle; }
    body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(r); }
    event touch = slope.distance(wheel) - r, falling => impact(e);
    friction rub = dot(x) * cos(angle) - dot(y) * sin(angle) + r * dot(phi), kinetic: mu * touch, static: hold * touch;
    output load = touch;
    output grip = rub;
}

lagrange::system! {
    /// A plate with unevenly distributed mass.
    #[allow(deprecated)]
    #[derive(Clone, Debug)]
    struct Plate;

    param mu = 0.4;
    coord x, y, phi;
    gravity = (0, -9.81);
    body plate { mass: 2; origin: (x, y); angle: phi; shape: rectangle(0.4, 0.2); centroid: (0.1, 0); inertia: 0.05; }
    contact foot = plate on ground { friction: mu; restitution: 0.2; }
    output load = foot[1];
    output corner = plate.corner(1);
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct PlateByHand;

    param mu = 0.4;
    coord x, y, phi;
    gravity = (0, -9.81);
    body plate { mass: 2; origin: (x, y); angle: phi; centroid: (0.1, 0); inertia: 0.05; }
    const a[4] = [-0.2, 0.2, -0.2, 0.2], b[4] = [-0.1, -0.1, 0.1, 0.1];
    for i in 0..4 {
        let corner[i] = plate.point(a[i], b[i]);
        event foot[i] = corner[i].y, falling => impact(0.2);
        friction rub[i] = dot(corner[i].x), mu * foot[i];
    }
}

/// The formulas differ at most by a rotation and its inverse.
#[test]
fn a_thrown_ball_moves_as_by_hand() {
    for (place, v, omega) in
        [([0.0, 0.0, 0.5], [2.0, 0.5, 1.0], [15.0, 0.0, 3.0]), ([0.0, 0.0, 0.1], [2.0, -1.0, 0.0], [0.0; 3])]
    {
        let start = flat(place, v, omega);
        let contact =
            Ball::<f64>::default().simulate(start).until(2.0).tolerance(1e-12).run().expect("bounces");
        let by_hand =
            BallByHand::<f64>::default().simulate(start).until(2.0).tolerance(1e-12).run().expect("bounces");
        assert_eq!(contact.events().len(), by_hand.events().len());
        for (a, b) in contact.last().into_iter().zip(by_hand.last()) {
            assert!((a - b).abs() < 1e-11, "{a} {b}");
        }
    }
    let start = flat([0.0, 0.0, 0.5], [2.0, 0.5, 1.0], [15.0, 0.0, 3.0]);
    let contact =
        Ball::<f64>::default().simulate(start).until(1.0).tolerance(1e-12).run().expect("bounces").last();
    let single = Ball::<f32>::default().simulate(start.map(|x| x as f32)).until(1.0).run().expect("bounces");
    for (a, b) in single.last().into_iter().zip(contact) {
        assert!((f64::from(a) - b).abs() < 1e-3, "{a} {b}");
    }
}

#[test]
fn parts_of_a_contact_are_those_of_its_geometry() {
    let ball = Ball::<f64>::default();
    let state = flat([1.0, 2.0, 0.1], [2.0, -1.0, 0.0], [3.0, 4.0, 5.0]);
    let (q, v) = (state[..7].try_into().expect("seven"), state[7..].try_into().expect("six"));
    assert_eq!(ball.load(0.0, &q, &v), 0.0);
    assert_eq!(ball.gap(0.0, &q, &v), 0.0);
    assert_eq!(ball.foot(0.0, &q, &v), [1.0, 2.0, 0.0]);
    let slip = ball.slip(0.0, &q, &v);
    assert!((slip[0] - (2.0 - 0.4)).abs() < 1e-15 && (slip[1] - (-1.0 + 0.3)).abs() < 1e-15, "{slip:?}");
    let run = ball.simulate(state).until(0.01).outputs().run().expect("slides");
    let first = |name: &str| run.column(name).expect("a column")[0];
    let size = slip[0].hypot(slip[1]);
    let wanted = [-0.3 * 9.81 * slip[0] / size, -0.3 * 9.81 * slip[1] / size, 9.81];
    for (axis, wanted) in ["x", "y", "z"].into_iter().zip(wanted) {
        assert!((first(&format!("pushing.{axis}")) - wanted).abs() < 1e-12);
    }
    assert_eq!(first("load"), first("pushing.z"));
    assert_eq!(first("grip.x"), first("pushing.x"));
}

/// The emitted formulas are the same.
#[test]
fn a_disk_on_a_slope_moves_as_by_hand() {
    for start in
        [[0.0, 0.6, 0.0, 1.0, 0.0, -9.0], [0.3 * 0.3_f64.sin(), 0.3 * 0.3_f64.cos(), 0.0, 0.0, 0.0, 4.0]]
    {
        let contact = Disk::default().simulate(start).until(2.0).tolerance(1e-12).run().expect("moves");
        let by_hand = DiskByHand::default().simulate(start).until(2.0).tolerance(1e-12).run().expect("moves");
        assert_eq!(contact.events().len(), by_hand.events().len());
        assert_eq!(contact.last(), by_hand.last());
        let implicit = Disk::default().simulate(start).until(2.0).method(Radau5::tolerance(1e-10)).run();
        for (a, b) in implicit.expect("moves").last().into_iter().zip(contact.last()) {
            assert!((a - b).abs() < 1e-6, "{a} {b}");
        }
    }
}

#[test]
fn a_plate_falls_on_its_corners_as_by_hand() {
    let start = [0.0, 0.5, 0.4, 1.0, 0.0, 0.5];
    let contact = Plate::default().simulate(start).until(1.5).tolerance(1e-11).run().expect("falls");
    let by_hand = PlateByHand::default().simulate(start).until(1.5).tolerance(1e-11).run().expect("falls");
    assert!(!contact.events().is_empty());
    assert_eq!(contact.events().len(), by_hand.events().len());
    for (a, b) in contact.last().into_iter().zip(by_hand.last()) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
    let end = contact.system_at_end().expect("touched");
    let by_hand = by_hand.system_at_end().expect("touched");
    assert_eq!([end.foot_0, end.foot_1], [by_hand.foot_0, by_hand.foot_1]);
    assert_eq!([end.foot_0_friction, end.foot_1_friction], [by_hand.rub_0, by_hand.rub_1]);
    let corner = Plate::default().corner(0.0, &[1.0, 2.0, 0.0], &[0.0; 3]);
    assert!((corner[0] - 1.2).abs() < 1e-15 && (corner[1] - 1.9).abs() < 1e-15, "{corner:?}");
}
