//! Integrals over bodies by Gauss–Legendre quadrature. It is exact for polynomials and, with this
//! many nodes, accurate to rounding for the smooth functions that describe curved bodies.

use std::f64::consts::PI;
use std::sync::OnceLock;

const NODES: usize = 20;

/// A point in the plane of a body, and the mass per volume of the unit cube there.
pub(super) type Element = ([f64; 2], f64);

/// Integrals over a body of density one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measured {
    pub(super) mass: f64,
    pub(super) center: [f64; 2],
    /// About the centre of mass.
    pub(super) inertia: f64,
}

/// Returns ∫ (X² + Y²) dm about a point over the image of the unit cube under `element`.
pub(super) fn moment(about: [f64; 2], element: &dyn Fn([f64; 3]) -> Element) -> f64 {
    integral(&|place| (place[0] - about[0]).powi(2) + (place[1] - about[1]).powi(2), element)
}

/// Returns mass, centre of mass and moment of inertia of several pieces. The moment is integrated
/// about the centre of mass, so that Steiner's theorem is not used.
pub(super) fn measure(pieces: &[&dyn Fn([f64; 3]) -> Element]) -> Measured {
    let over_all =
        |of: &dyn Fn([f64; 2]) -> f64| pieces.iter().map(|piece| integral(of, *piece)).sum::<f64>();
    let mass = over_all(&|_| 1.0);
    let center = [0, 1].map(|axis| over_all(&|place| place[axis]) / mass);
    Measured { mass, center, inertia: pieces.iter().map(|piece| moment(center, *piece)).sum() }
}

/// Integrates a function of position over a body.
fn integral(of: &dyn Fn([f64; 2]) -> f64, element: &dyn Fn([f64; 3]) -> Element) -> f64 {
    static RULE: OnceLock<[(f64, f64); NODES]> = OnceLock::new();
    let rule = RULE.get_or_init(rule);
    let mut sum = 0.0;
    for (u, weight_u) in rule {
        for (v, weight_v) in rule {
            for (w, weight_w) in rule {
                let (place, amount) = element([*u, *v, *w]);
                sum += weight_u * weight_v * weight_w * amount * of(place);
            }
        }
    }
    sum
}

/// Returns nodes on [0, 1] with their weights: zeros of Legendre's polynomial by Newton's method
/// from Tricomi's estimate (Davis, Rabinowitz, *Methods of Numerical Integration*, 2.7).
fn rule() -> [(f64, f64); NODES] {
    std::array::from_fn(|i| {
        let mut x = (PI * (i as f64 + 0.75) / (NODES as f64 + 0.5)).cos();
        for _ in 0..8 {
            let (value, slope) = legendre(x);
            x -= value / slope;
        }
        let (_, slope) = legendre(x);
        ((1.0 - x) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// Returns legendre's polynomial of degree `NODES` and its derivative.
fn legendre(x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for degree in 2..=NODES {
        let n = degree as f64;
        (before, value) = (value, ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n);
    }
    (value, NODES as f64 * (x * value - before) / (x * x - 1.0))
}

#[test]
fn the_rule_integrates_polynomials_of_its_degree() {
    let highest = 2 * NODES as i32 - 1;
    for power in [0, 1, 2, 7, highest] {
        let sum = rule().iter().map(|(x, weight)| weight * x.powi(power)).sum::<f64>();
        assert!((sum * f64::from(power + 1) - 1.0).abs() < 1e-13, "x^{power}");
    }
    let beyond = rule().iter().map(|(x, weight)| weight * (2.0 * x - 1.0).powi(400)).sum::<f64>();
    assert!((beyond * 401.0 - 1.0).abs() > 1e-6);
}
