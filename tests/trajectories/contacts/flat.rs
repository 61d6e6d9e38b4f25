//! Lines and planes, against closed forms.

use lagrange::Simulate;
use lagrange::contact::{Contact, EventKind, Friction};

use crate::{G, assert_near, flat};

lagrange::system! {
    /// A disk on a slope that descends along x.
    #[derive(Clone, Debug)]
    struct Slope<S>;

    param r = 0.3, mu = 0.3, angle = 0.3;
    coord x, y, phi;
    gravity = (0, -9.81);
    line slope { angle: -angle; }
    body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(r); }
    contact touch = wheel on slope { friction: mu; }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Ball;

    param mu = 0.3, r = 0.1;
    gravity = (0, 0, -9.81);
    body b { mass: 1; shape: solid_sphere(r); }
    free b;
    contact floor = b on ground { friction: mu; }
}

lagrange::system! {
    /// A ball on a plane whose normal depends on parameters.
    #[derive(Clone, Debug)]
    struct Incline;

    param mu = 0.4, r = 0.1, a = 0.1, b = 0.2, c = 0.9;
    gravity = (0, 0, -9.81);
    plane slope { through: (0, 0, 1); normal: (a, b, c); }
    body ball { mass: 1; shape: thin_sphere(r); }
    free ball;
    contact touch = ball on slope { friction: mu; }
    output gap = touch.gap;
    output slip = touch.slip;
}

lagrange::system! {
    /// The incline with numbers.
    #[derive(Clone, Debug)]
    struct InclineInNumbers;

    param mu = 0.4, r = 0.1;
    gravity = (0, 0, -9.81);
    plane slope { through: (0, 0, 1); normal: (0.1, 0.2, 0.9); }
    body ball { mass: 1; shape: thin_sphere(r); }
    free ball;
    contact touch = ball on slope { friction: mu; }
    output gap = touch.gap;
}

lagrange::system! {
    /// A box on its four lower corners.
    #[derive(Clone, Debug)]
    struct Cuboid;

    param mu = 0.5, e = 0;
    gravity = (0, 0, -9.81);
    body b { mass: 1; shape: cuboid(0.4, 0.3, 0.2); }
    free b;
    for i in 0..4 {
        contact floor[i] = b.corner(i) on ground { friction: mu; restitution: e; }
    }
}

lagrange::system! {
    /// A rod in a frictionless corner.
    #[derive(Clone, Debug)]
    struct Rod;

    param l = 1.2;
    coord x, y, phi;
    gravity = (0, -9.81);
    line wall { angle: -pi/2; }
    body rod { mass: 3; center: (x, y); angle: phi; shape: rod(l); }
    contact top = rod.point(l/2, 0) on wall;
    contact foot = rod.point(-l/2, 0) on ground;
}

/// It rolls with 2/3 g sin α if tan α is at most 3 μ. Otherwise it slides with g (sin α − μ cos α)
/// and rotates with 2 μ g cos α / r.
#[test]
fn a_disk_on_a_slope_rolls_or_slides() {
    for angle in [0.3_f64, 0.7, 0.8] {
        let slope = Slope::<f64> { angle, ..Slope::default() };
        let (sin, cos) = angle.sin_cos();
        let start = [0.3 * sin, 0.3 * cos, 0.0, 0.0, 0.0, 0.0];
        let run = slope.simulate(start).until(1.0).tolerance(1e-12).run().expect("moves");
        let rolls = angle.tan() <= 0.9;
        let (along, turning) = match rolls {
            true => (2.0 / 3.0 * G * sin, 2.0 / 3.0 * G * sin / 0.3),
            false => (G * (sin - 0.3 * cos), 2.0 * 0.3 * G * cos / 0.3),
        };
        let [x, y, phi, vx, vy, omega] = run.last();
        let wanted = [
            0.3 * sin + 0.5 * along * cos,
            0.3 * cos - 0.5 * along * sin,
            -0.5 * turning,
            along * cos,
            -along * sin,
            -turning,
        ];
        assert_near([x, y, phi, vx, vy, omega], wanted, 1e-11);
        let end = run.system_at_end().expect("touches");
        assert_eq!(end.touch, Contact::Closed);
        assert_eq!(end.touch_friction == Friction::Sticks, rolls);
        let single: Slope<f32> = Slope { angle: angle as f32, ..Slope::default() };
        let run = single.simulate(start.map(|x| x as f32)).until(1.0).run().expect("moves");
        assert_near(run.last().map(f64::from), wanted, 2e-4);
    }
}

#[test]
fn a_ball_slides_until_it_rolls_with_five_sevenths_of_its_speed() {
    let ball = Ball::default();
    let run = ball.simulate(flat([0.0, 0.0, 0.1], [3.0, 0.0, 0.0], [0.0; 3]));
    let run = run.until(2.0).tolerance(1e-12).run().expect("rolls");
    let [event] = run.events() else { panic!("{:?}", run.events()) };
    assert!(event.kind == EventKind::Stuck && (event.time - 2.0 * 3.0 / (7.0 * 0.3 * G)).abs() < 1e-11);
    assert_near([run.last()[7]], [15.0 / 7.0], 1e-11);
}

/// A hollow ball rolls with 3/5 of gravity along the plane.
#[test]
fn a_ball_rolls_down_any_plane() {
    let length = (0.01_f64 + 0.04 + 0.81).sqrt();
    let normal = [0.1 / length, 0.2 / length, 0.9 / length];
    let place = [0, 1, 2].map(|axis| 0.1 * normal[axis] + [0.0, 0.0, 1.0][axis]);
    let start = flat(place, [0.0; 3], [0.0; 3]);
    let along = [0, 1, 2].map(|axis| 0.6 * G * (normal[2] * normal[axis] - [0.0, 0.0, 1.0][axis]));
    let wanted = [0, 1, 2].map(|axis| place[axis] + 0.5 * along[axis]);
    let last = Incline::default().simulate(start).until(1.0).tolerance(1e-12).run().expect("rolls").last();
    assert_near([last[0], last[1], last[2]], wanted, 1e-10);
    let last =
        InclineInNumbers::default().simulate(start).until(1.0).tolerance(1e-12).run().expect("rolls").last();
    assert_near([last[0], last[1], last[2]], wanted, 1e-10);
}

/// The distance v²/2μg along the diagonal, and the angle of its spin.
#[test]
fn a_box_on_its_face_stops_as_a_puck_does() {
    let part = 1.0 / (2.0 * 0.5 * G);
    let stop = |v, omega| {
        let cuboid = Cuboid::default();
        let run = cuboid.simulate(flat([0.0, 0.0, 0.1], v, omega)).until(1.0).tolerance(1e-11).run();
        let run = run.expect("stops");
        assert!(run.last()[7..].iter().all(|v| v.abs() < 1e-12));
        (run.last(), run.system_at_end().cloned().expect("touches"))
    };
    let (last, end) = stop([1.0, 1.0, 0.0], [0.0; 3]);
    assert_near([last[0], last[1], last[2]], [2_f64.sqrt() * part, 2_f64.sqrt() * part, 0.1], 1e-9);
    assert_eq!([end.floor_0, end.floor_1, end.floor_2, end.floor_3], [Contact::Closed; 4]);
    assert_eq!(end.floor_0_friction, Friction::Sticks);
    let (last, _) = stop([0.0; 3], [0.0, 0.0, 5.0]);
    let angle = 25.0 * (0.16 + 0.09) / 12.0 * part / 0.25;
    assert_near([2.0 * last[6].atan2(last[3])], [angle], 1e-9);
}

/// Its top leaves the wall at two thirds of its initial height.
#[test]
fn a_rod_that_slides_down_leaves_the_wall() {
    for lean in [0.2_f64, 0.6] {
        let half = 0.6;
        let phi = std::f64::consts::FRAC_PI_2 + lean;
        let start = [half * lean.sin(), half * lean.cos(), phi, 0.0, 0.0, 0.0];
        let run = Rod::default().simulate(start).until(3.0).tolerance(1e-12).run().expect("falls");
        let opened = run.events().iter().find(|event| event.kind == EventKind::Opened).expect("it leaves");
        let height = opened.state[1];
        assert!((height - 2.0 / 3.0 * half * lean.cos()).abs() < 1e-9, "{height}");
    }
}

/// Declares a block that slides along one axis of the floor only.
macro_rules! guided {
    ($name:ident, $axis:tt) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;

            param mu = 0.3;
            gravity = (0, 0, -9.81);
            frame slider;
            body block { mass: 2; shape: cuboid(0.2, 0.1, 0.1); }
            prismatic s = ground to slider { axis: $axis; }
            prismatic z = slider to block { axis: (0, 0, 1); }
            contact foot = block.point(0, 0, -0.05) on ground { friction: mu; }
        }
    };
}

guided!(Lengthwise, (1, 0, 0));
guided!(Crosswise, (0, 1, 0));

/// It falls, slides with the friction left after the impact, and stops.
#[test]
fn blocks_that_are_guided_along_one_axis_slide_along_it() {
    let fall = (0.4 / G).sqrt();
    let left = 2.0 - 0.3 * G * fall;
    let way = 2.0 * fall + left * left / (0.6 * G);
    let lengthwise = Lengthwise::default().simulate([0.0, 0.25, 2.0, 0.0]).until(3.0).tolerance(1e-10).run();
    let crosswise = Crosswise::default().simulate([0.0, 0.25, -2.0, 0.0]).until(3.0).tolerance(1e-10).run();
    let (lengthwise, crosswise) = (lengthwise.expect("stops"), crosswise.expect("stops"));
    assert_near(lengthwise.last(), [way, 0.05, 0.0, 0.0], 1e-11);
    assert_near(crosswise.last(), [-way, 0.05, 0.0, 0.0], 1e-11);
    assert_eq!(lengthwise.events().last().expect("stuck").kind, EventKind::Stuck);
}
