//! Increasingly stiff contacts against rigid ones.

use lagrange::Simulate;
use lagrange::integrate::Radau5;

use crate::G;

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Soft;

    param k = 1e4;
    coord x, y;
    gravity = (0, -9.81);
    body ball { mass: 1; center: (x, y); }
    contact touch = ball on ground { stiffness: k; }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Hard;

    coord x, y;
    gravity = (0, -9.81);
    body ball { mass: 1; center: (x, y); }
    contact touch = ball on ground { restitution: 1; }
}

lagrange::system! {
    /// A block that comes to a stop on soft ground.
    #[derive(Clone, Debug)]
    struct SoftBlock;

    param k = 1e4, v = 1e-3;
    coord x, y, phi;
    gravity = (0, -9.81);
    body block { mass: 1; center: (x, y); angle: phi; shape: rectangle(0.4, 0.2); }
    contact foot = block.corners on ground { friction: 0.3; stiffness: k; dissipation: 1; stiction: v; }
    emit { jacobian }
}

lagrange::system! {
    /// A block on hard ground, which two of its corners touch.
    #[derive(Clone, Debug)]
    struct HardBlock;

    coord x, y, phi;
    gravity = (0, -9.81);
    body block { mass: 1; center: (x, y); angle: phi; shape: rectangle(0.4, 0.2); }
    contact foot = block.corners on ground { friction: 0.3; }
}

/// A bounce lasts π √(m/k) longer, so the error is of the order of the root of the compliance.
#[test]
fn bounces_tend_to_those_of_a_rigid_ball() {
    let start = [0.0, 1.0, 0.3, 0.0];
    let rigid = Hard::default().simulate(start).until(1.6).run().unwrap().last();
    let mut errors = Vec::new();
    for k in [1e6, 1e8, 1e10] {
        let soft =
            Soft { k, ..Soft::default() }.simulate(start).until(1.6).tolerance(1e-12).run().unwrap().last();
        errors.push((soft[1] - rigid[1]).abs());
    }
    let orders = [0, 1].map(|i| (errors[i] / errors[i + 1]).log10() / 2.0);
    println!("bounces: errors {errors:?}, orders in 1/k {orders:?}");
    assert!(orders.iter().all(|order| (order - 0.5).abs() < 0.02) && errors[2] < 2e-4);
}

/// The error of motions without bounces decreases with the compliance and with the stiction speed.
#[test]
fn a_block_that_stops_tends_to_a_rigid_one() {
    let rigid =
        HardBlock::default().simulate([0.0, 0.1, 0.0, 1.0, 0.0, 0.0]).until(0.6).run().unwrap().last();
    assert!((rigid[0] - 1.0 / (2.0 * 0.3 * G)).abs() < 1e-9);
    let mut errors = Vec::new();
    for scale in [1.0, 0.1, 0.01] {
        let soft = SoftBlock { k: 1e4 / scale, v: 1e-2 * scale, ..SoftBlock::default() };
        let start = [0.0, 0.1 - G / (2.0 * soft.k), 0.0, 1.0, 0.0, 0.0];
        let run = soft.simulate(start).until(0.6).method(Radau5::tolerance(1e-10)).run().unwrap().last();
        errors.push(((run[0] - rigid[0]).abs(), (run[1] - rigid[1]).abs()));
    }
    let order = |a: f64, b: f64| (a / b).log10();
    let along = [0, 1].map(|i| order(errors[i].0, errors[i + 1].0));
    let down = [0, 1].map(|i| order(errors[i].1, errors[i + 1].1));
    println!("block: errors {errors:?}, orders {along:?}, {down:?}");
    assert!(along[1] > 0.7 && (down[1] - 1.0).abs() < 0.05);
    assert!(errors[2].0 < 1e-6 && errors[2].1 < 1e-5);
}
