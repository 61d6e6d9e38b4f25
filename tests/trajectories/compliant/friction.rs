//! Regularised friction: sliding, creep, and its isotropy in space.

use lagrange::Simulate;
use lagrange::integrate::Radau5;

use crate::{G, assert_near};

lagrange::system! {
    /// A block on a slope.
    #[derive(Clone, Debug)]
    struct Block;

    param mu = 0.3, k = 1e5, v = 1e-3, tilt = 0.2;
    coord x, y;
    line slope { angle: -tilt; }
    gravity = (0, -9.81);
    body block { mass: 2; center: (x, y); }
    contact touch = block on slope { friction: mu; stiffness: k; dissipation: 10; stiction: v; }
    output slip = touch.slip;
    output rub = touch.friction;
    output gap = touch.gap;
    emit { jacobian }
}

lagrange::system! {
    /// A box on its corners.
    #[derive(Clone, Debug)]
    struct Case;

    param mu = 0.5, k = 1e6, v = 1e-4;
    gravity = (0, 0, -9.81);
    body case { mass: 2; shape: cuboid(0.2, 0.2, 0.2); }
    free case;
    contact foot = case.corners on ground { friction: mu; stiffness: k; dissipation: 2; stiction: v; }
    output load = foot[0].normal + foot[1].normal + foot[2].normal + foot[3].normal;
    output grip = foot[0].friction;
    emit { jacobian }
}

impl Block {
    /// Returns the block on the slope, sunk by its weight, with a speed along it.
    fn on_slope(&self, speed: f64) -> [f64; 4] {
        let (sin, cos) = self.tilt.sin_cos();
        let depth = 2.0 * G * cos / self.k;
        [-depth * sin, -depth * cos, speed * cos, -speed * sin]
    }
}

/// The path of a sliding block is v₀ t + ½ g (sin α − μ cos α) t². The remaining error is
/// proportional to the square of the stiction speed, as √(s² + v²) ≈ s + ½ v²/s.
#[test]
fn a_sliding_block_tends_to_its_closed_form() {
    let mut errors = Vec::new();
    for v in [4e-2, 2e-2, 1e-2] {
        let block = Block { v, ..Block::default() };
        let (sin, cos) = block.tilt.sin_cos();
        let run = block.simulate(block.on_slope(1.0)).until(0.5).tolerance(1e-12).run().unwrap();
        let [x, y, ..] = run.last();
        let [x0, y0, ..] = block.on_slope(1.0);
        let path = (x - x0) * cos - (y - y0) * sin;
        errors.push((path - (0.5 + 0.125 * G * (sin - block.mu * cos))).abs());
    }
    let orders = [0, 1].map(|i| (errors[i] / errors[i + 1]).log2());
    println!("sliding block: errors {errors:?}, orders {orders:?}");
    assert!(orders.iter().all(|order| (order - 2.0).abs() < 0.1) && errors[2] < 1e-4);
}

/// A block that Coulomb's law would hold creeps with v f / √((μ N)² − f²).
#[test]
fn a_block_that_would_stick_creeps() {
    for v in [1e-2, 1e-3, 1e-4] {
        let block = Block { v, ..Block::default() };
        let (sin, cos) = block.tilt.sin_cos();
        let run =
            block.simulate(block.on_slope(0.3)).until(2.0).method(Radau5::tolerance(1e-9)).record("slip");
        let run = run.run().unwrap();
        let creep = v * sin / ((block.mu * cos).powi(2) - sin * sin).sqrt();
        let slip = *run.column("slip").unwrap().last().unwrap();
        assert!((slip / creep - 1.0).abs() < 1e-4, "{slip} {creep}");
    }
}

/// Along a diagonal it stops after v²/(2 μ g) = 0.204 m, as along an axis. With separate friction
/// in each direction it would stop after 0.144 m.
#[test]
fn friction_in_space_is_isotropic() {
    let case = Case::default();
    let start = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let speed = 2.0_f64.sqrt();
        let height = 0.1 - 2.0 * G / (4.0 * case.k);
        [0.0, 0.0, height, 1.0, 0.0, 0.0, 0.0, speed * cos, speed * sin, 0.0, 0.0, 0.0, 0.0]
    };
    let path = 2.0 / (2.0 * 0.5 * G);
    for angle in [0.0, 0.3, std::f64::consts::FRAC_PI_4] {
        let run = case.simulate(start(angle)).until(1.2).method(Radau5::tolerance(1e-8)).record("load").run();
        let run = run.unwrap();
        let [x, y, ..] = run.last();
        println!("box at {angle}: {:.6} m instead of {path:.6} m", x.hypot(y));
        assert!((x.hypot(y) - path).abs() < 2e-4 && (y.atan2(x) - angle).abs() < 5e-3);
        assert!((run.column("load").unwrap().last().unwrap() / (2.0 * G) - 1.0).abs() < 0.03);
    }
}

/// The emitted Jacobian agrees with differences on every side of the surfaces.
#[test]
fn derivatives_are_exact() {
    let block = Block { v: 0.2, ..Block::default() };
    for y in [[0.0, -1e-3, 0.3, 0.1], [0.1, 0.2, 0.3, 0.4], [0.0, -1e-3, 0.0, 0.3], [0.1, -0.03, -0.1, -0.1]]
    {
        let found = block.jacobian(0.0, &y);
        for column in 0..4 {
            let at = |by: f64| {
                let mut moved = y;
                moved[column] += by;
                block.rhs(0.0, &moved)
            };
            let h = 1e-6;
            let (ahead, behind) = (at(h), at(-h));
            for row in 0..4 {
                let wanted = (ahead[row] - behind[row]) / (2.0 * h);
                let size = 1.0 + wanted.abs();
                assert!((found[row][column] - wanted).abs() < 1e-5 * size, "{row} {column} {y:?}");
            }
        }
    }
}

/// Without slip there is neither friction nor a division by zero.
#[test]
fn friction_at_rest_is_zero() {
    let block = Block { v: 1e-100, tilt: 0.0, ..Block::default() };
    assert_eq!(block.rub(0.0, &[0.0, -0.1], &[0.0, 0.0]).abs(), 0.0);
    assert_near([block.rub(0.0, &[0.0, -0.1], &[1e-3, 0.0])], [-0.3 * 1e5 * 0.1], 1e-9);
    assert_eq!(block.rub(0.0, &[0.0, 0.1], &[1.0, 0.0]).abs(), 0.0);
}
