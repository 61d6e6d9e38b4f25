//! Checks of what the recipes of `ARCHITECTURE.md` add, against independent answers. The tool
//! `tools/recipes.py` compiles them in a scratch copy of the project.

use std::sync::Arc;

use lagrange::Ensembles;
use lagrange::integrate::{Ralston, integrate};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, Programs, parse};
use lagrange_double::Double;
use lagrange_dynamic::visit_items;
use lagrange_runtime::scalar::Number;
use lagrange_runtime::scene::{Item, Outline, Plane, Solid, Spatial, SpatialJointKind};

fn system(text: &str) -> NumericSystem {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let derived = derived.unwrap_or_else(|report| panic!("{text}: {report}"));
    NumericSystem::of(Arc::new(Programs::new(&derived)))
}

fn product(text: &str, product: Product, q: &[f64], v: &[f64]) -> Vec<f64> {
    system(text).product(product, 0.0, q, v).unwrap_or_else(|| panic!("{text}: {product:?}"))
}

#[track_caller]
fn assert_alike(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-13 * (1.0 + expected.abs()), "{found}, {expected}");
    }
}

lagrange::system! {
    /// A mass in a potential whose slope is 1/√(1 + x²).
    #[derive(Clone)]
    struct Slope<S>;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = asinh(x);
    output height = asinh(x);
    emit { lanes, virial }
}

const SLOPE: &str = "coord x; kinetic = 1/2 * dot(x)^2; potential = asinh(x); output height = asinh(x);";

#[test]
fn function() {
    for x in [-30.0_f64, -1.0, -1e-9, 0.0, 1e-300, 0.3, 1.0, 1e8, 1e300] {
        let (height, slope) = (x.asinh(), x.hypot(1.0).recip());
        let slope_system = Slope::<f64>::default();
        let read = system(SLOPE);
        assert_alike(&[slope_system.height(0.0, &[x], &[0.0])], &[height]);
        assert_alike(&read.output("height", 0.0, &[x], &[0.0]).expect("an output"), &[height]);
        assert_alike(&slope_system.acceleration(0.0, &[x], &[0.0]), &[-slope]);
        assert_alike(&read.acceleration(0.0, &[x], &[0.0]), &[-slope]);
    }
    for x in [-700.0, -1.0, -1e-3, 1e-20, 0.2, 0.99, 1.01, 5.0, 1e3] {
        let x = Double::from_f64(x);
        let error = (x.asinh().sinh() - x) / x;
        assert!(error.abs() < Double::from_f64(1e-28), "{error:?}");
    }
}

#[test]
fn product_of_the_model() {
    let text = "coord x, y; kinetic = 1/2 * (dot(x)^2 + 3 * dot(x) * dot(y) + 5 * dot(y)^2); \
                potential = x^2; emit { virial }";
    let v = [0.3, -1.2];
    let twice_kinetic = v[0] * v[0] + 3.0 * v[0] * v[1] + 5.0 * v[1] * v[1];
    assert_alike(&product(text, Product::Virial, &[0.4, 0.5], &v), &[twice_kinetic]);
    assert_alike(&[Slope::<f64>::default().virial(0.0, &[0.4], &[0.5])], &[0.25]);
}

const BODIES: &str = "gravity = (0, 0, -9.81);
    body fork { mass: 2; inertia: (0.3, 0.4, 0.5, 0.01, 0.02, 0.03); centroid: (0.1, 0.2, -0.7); }";

#[test]
fn joint_in_space() {
    let one = format!(
        "{BODIES} gimbal (a, b, c) = ground to fork {{ at: (0.1, 0, 0.4); turned: (0.2, 0.1, 0.3); }} emit {{ bias, drawing }}"
    );
    let composed = format!(
        "{BODIES} frame first; frame second;
        revolute a = ground to first {{ at: (0.1, 0, 0.4); turned: (0.2, 0.1, 0.3); axis: (1, 0, 0); }}
        revolute b = first to second {{ axis: (0, 1, 0); }}
        revolute c = second to fork {{ axis: (0, 0, 1); }} emit {{ bias }}"
    );
    let (q, v) = ([0.3, -0.8, 1.9], [0.7, 1.1, -0.4]);
    for what in [Product::MassMatrix, Product::Bias, Product::Energy] {
        assert_alike(&product(&one, what, &q, &v), &product(&composed, what, &q, &v));
    }
    let mut kinds = Vec::new();
    let system = system(&one);
    let scene = system.programs().drawing.clone().expect("a drawing");
    visit_items::<Spatial>(&system, &scene, (0.0, &q, &v), &mut |item| {
        if let Item::Joint { kind, .. } = item {
            kinds.push(kind.kind);
        }
    });
    assert_eq!(kinds, [SpatialJointKind::Gimbal]);
}

#[test]
fn unit() {
    let text = "const way = 2.5 furlong; coord x; kinetic = 1/2 * dot(x)^2; output ways = way + 0 * x;";
    let found = system(text).output("ways", 0.0, &[1.0], &[0.0]).expect("an output");
    assert_alike(&found, &[2.5 * 660.0 * 12.0 * 0.0254]);
}

/// A rhombus is also a polygon.
#[test]
fn solid_of_the_plane() {
    let (a, b) = (1.3, 0.4);
    let corners = [[a / 2.0, 0.0], [0.0, b / 2.0], [-a / 2.0, 0.0], [0.0, -b / 2.0]];
    let expected = lagrange::inertia::polygon(2.0, &corners);
    let found = lagrange::inertia::rhombus(2.0, a, b);
    assert_alike(&[found], &[expected]);
    let text =
        "coord x; body r { mass: 2; shape: rhombus(1.3, 0.4); center: (0, 0); angle: x; } emit { drawing }";
    assert_alike(&product(text, Product::MassMatrix, &[0.2], &[0.0]), &[expected]);
    let mut outlines = Vec::new();
    let system = system(text);
    let scene = system.programs().drawing.clone().expect("a drawing");
    visit_items::<Plane>(&system, &scene, (0.0, &[0.2], &[0.0]), &mut |item| {
        if let Item::Body { parts, .. } = item {
            outlines.extend(parts.iter().map(|part| part.shape == Outline::Rhombus(a, b)));
        }
    });
    assert_eq!(outlines, [true]);
}

/// About every diameter of its base, half a sphere has the moment of inertia of a sphere of its
/// mass.
#[test]
fn solid_in_space() {
    for axis in ["(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)"] {
        let text = format!(
            "gravity = (0, 0, -1); body b {{ compound {{ hemisphere(0.5), mass: 3, at: (0, 0, 0); }} }}
            revolute q = ground to b {{ axis: {axis}; }} emit {{ drawing }}"
        );
        assert_alike(&product(&text, Product::MassMatrix, &[0.2], &[0.0]), &[3.0 * 0.4 * 0.25]);
    }
    assert_eq!(Solid::Hemisphere(2.0_f32).map(f64::from), Solid::Hemisphere(2.0));
}

#[test]
fn integrator() {
    let slope = Slope::<f64>::default();
    let end = |step| {
        let mut last = [0.0; 2];
        integrate(&slope, 0.0, [0.3, 1.1], 1.0, &Ralston { step }, |_, y| last = *y).expect("a motion");
        last[0]
    };
    let (coarse, middle, fine) = (end(0.1), end(0.05), end(0.025));
    let order = ((coarse - middle) / (middle - fine)).log2();
    assert!((order - 2.0).abs() < 0.1, "{order}");
    let ensemble = || {
        slope
            .ensemble(9)
            .start(|index, _| [0.1 * index as f64, 1.0])
            .until(1.0)
            .method(Ralston { step: 0.05 })
    };
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    assert_alike(lanes.x(), alone.x());
}
