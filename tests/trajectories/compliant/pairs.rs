//! Two moving bodies in contact: forces act on both.

use lagrange::Simulate;

use crate::assert_near;

lagrange::system! {
    /// Two disks that fly towards each other.
    #[derive(Clone, Debug)]
    struct Disks;

    param k = 2e4, mu = 0.4, d = 0.3;
    coord x1, y1, a, x2, y2, b;
    body one { mass: 2; center: (x1, y1); angle: a; shape: disk(0.3); }
    body two { mass: 0.7; center: (x2, y2); angle: b; shape: thin_ring(0.2); }
    contact touch = one on two { friction: mu; stiffness: k; dissipation: d; stiction: 0.01; }
    event edge = touch.gap, crossing => record;
    output px = 2 * dot(x1) + 0.7 * dot(x2);
    output py = 2 * dot(y1) + 0.7 * dot(y2);
    output spin = 2 * (x1 * dot(y1) - y1 * dot(x1)) + 0.7 * (x2 * dot(y2) - y2 * dot(x2))
        + one.inertia * dot(a) + two.inertia * dot(b);
}

lagrange::system! {
    /// A ball that lands on a cart, which rolls away.
    #[derive(Clone, Debug)]
    struct Cart;

    param k = 1e5, mu = 0.4;
    coord s, x, y;
    gravity = (0, -9.81);
    body cart { mass: 3; center: (s, 0.5); }
    line top { on: cart; through: (0, 0.1); }
    body block { mass: 1; center: (x, y); }
    contact touch = block on top { friction: mu; stiffness: k; dissipation: 1; stiction: 1e-3; }
    output momentum = 3 * dot(s) + dot(x);
    output slip = touch.slip;
}

lagrange::system! {
    /// A ball on a ball in space.
    #[derive(Clone, Debug)]
    struct Balls;

    param k = 1e4, mu = 0.3;
    body one { mass: 1; shape: solid_sphere(0.2); }
    body two { mass: 2; shape: thin_sphere(0.3); }
    free one;
    free two;
    contact touch = one on two { friction: mu; stiffness: k; dissipation: 0.2; stiction: 0.01; }
    output push = touch.force;
}

#[test]
fn momenta_of_two_disks_stay() {
    let disks = Disks::default();
    let start = [-1.0, 0.1, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 5.0, -1.0, 0.1, -3.0];
    let run = disks.simulate(start).until(1.0).tolerance(1e-12);
    let run = run.record("px").record("py").record("spin").energy().run().unwrap();
    assert_eq!(run.events().len(), 2);
    for name in ["px", "py", "spin"] {
        let column = run.column(name).unwrap();
        assert_near([*column.last().unwrap()], [column[0]], 1e-11);
    }
    let energy = run.column("energy").unwrap();
    assert!(*energy.last().unwrap() < energy[0] - 0.1);
}

#[test]
fn a_block_takes_the_cart_along() {
    let cart = Cart::default();
    let run = cart.simulate([0.0, 0.0, 0.65, 0.0, 2.0, 0.0]).until(1.5).tolerance(1e-9);
    let run = run.record("momentum").record("slip").run().unwrap();
    assert!(run.column("momentum").unwrap().iter().all(|p| (p - 2.0).abs() < 1e-9));
    let [.., cart_speed, block_speed, _] = run.last();
    assert_near([cart_speed, block_speed], [0.5, 0.5], 1e-4);
}

/// The total moment is the force on one ball times the lever arm between the centres. The balls
/// share it in the ratio of the distances of their centres from the contact point.
#[test]
fn balls_in_space_push_each_other() {
    let balls = Balls::default();
    let at = |[x, y, z]: [f64; 3]| [x, y, z, 1.0, 0.0, 0.0, 0.0];
    let q = [at([0.3, 0.05, 0.39]), at([0.0, 0.0, 0.0])].concat().try_into().unwrap();
    let v = [-0.1, 0.2, -0.5, 1.0, 2.0, -1.0, 0.0, 0.3, 0.1, -2.0, 0.5, 1.0];
    let a = balls.acceleration(0.0, &q, &v);
    let force = balls.push(0.0, &q, &v);
    assert!(force[2] > 10.0);
    assert_near([a[0], a[1], a[2]], force, 1e-9);
    assert_near([a[6], a[7], a[8]], force.map(|f| -f / 2.0), 1e-9);
    // About the centres: I α = arm × force. Arms lie along the line of the centres.
    let distance = (0.3_f64.powi(2) + 0.05_f64.powi(2) + 0.39_f64.powi(2)).sqrt();
    let n = [0.3 / distance, 0.05 / distance, 0.39 / distance];
    let moment = [
        n[1] * force[2] - n[2] * force[1],
        n[2] * force[0] - n[0] * force[2],
        n[0] * force[1] - n[1] * force[0],
    ];
    let (small, large) = (0.4 * 0.04, 2.0 / 3.0 * 2.0 * 0.09);
    assert_near([a[3], a[4], a[5]], moment.map(|m| -0.2 * m / small), 1e-9);
    // The material point of the other ball lies inside its surface, where the first ball touches.
    assert_near([a[9], a[10], a[11]], moment.map(|m| -(distance - 0.2) * m / large), 1e-9);
}
