//! Regressors of emitted types: generic and single numbers, arrays, prepared types, interpreted
//! twins.

use lagrange::system::RegressorSystem;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse};

macro_rules! declared {
    ($(#[$attribute:meta])* $name:ident, $($product:ident)*) => {
        lagrange::system! {
            /// Two rods on a cart, with springs.
            $(#[$attribute])*
            struct $name;
            param m[2] = 2, c[2] = 0.2, k = 3, cart = 4;
            input push;
            gravity = (0, -9.81);
            coord x;
            kinetic = 1/2 * cart * dot(x)^2;
            coord a, b;
            body upper { mass: m[0]; inertia: 0.1; centroid: (0.5, 0); origin: (x, 0); angle: a; }
            body lower { mass: m[1]; inertia: 0.2; centroid: (0.4, 0.1); origin: upper.point(1, 0); angle: a + b; }
            potential = 1/2 * k * x^2;
            dissipation = 1/2 * c[0] * dot(a)^2 + 1/2 * c[1] * dot(b)^2;
            force x = push;
            emit { $($product),* }
        }
    };
}

declared! { Rods, regressor prepared }

declared! { #[scalar(f32)] Small, regressor }

/// Returns τ − Y π.
fn rest<M>(system: &M, q: &M::Coordinates, v: &M::Velocities, a: &M::Velocities) -> Vec<f64>
where
    M: RegressorSystem,
    M::Scalar: Into<f64>,
{
    let (rows, parameters) =
        (system.regressor(lagrange::Number::ZERO, q, v, a), system.regressor_parameters());
    let torques = system.inverse_dynamics(lagrange::Number::ZERO, q, v, a);
    assert_eq!(parameters.as_ref().len(), M::REGRESSOR_PARAMETERS.len());
    let row = |row: &M::Row| {
        let products = row.as_ref().iter().zip(parameters.as_ref());
        products.map(|(y, p)| (*y).into() * (*p).into()).sum::<f64>()
    };
    torques
        .as_ref()
        .iter()
        .zip(rows.as_ref())
        .map(|(torque, entries)| (*torque).into() - row(entries))
        .collect()
}

#[test]
fn the_rest_is_the_input() {
    let (q, v, a) = ([0.3, 0.7, -0.4], [0.5, -1.0, 2.0], [1.5, 0.25, -0.75]);
    let rods = Rods { push: 1.5, ..Rods::default() };
    let found = rest(&rods, &q, &v, &a);
    assert!((found[0] + 1.5).abs() < 1e-13 && found[1].abs() < 1e-13 && found[2].abs() < 1e-13, "{found:?}");
    let small = Small { push: 1.5, ..Small::default() };
    let found = rest(&small, &q.map(|x| x as f32), &v.map(|x| x as f32), &a.map(|x| x as f32));
    assert!((found[0] + 1.5).abs() < 2e-5 && found[1].abs() < 2e-5 && found[2].abs() < 2e-5, "{found:?}");
    // NaN propagates.
    let broken = Rods { cart: f64::NAN, ..Rods::default() };
    assert!(rest(&broken, &q, &v, &a)[0].is_nan());
}

#[test]
fn names_are_those_of_bodies_and_of_array_elements() {
    let of_bodies =
        ["upper.mass", "upper.mx", "upper.my", "upper.zz", "lower.mass", "lower.mx", "lower.my", "lower.zz"];
    assert_eq!(Rods::REGRESSOR_PARAMETERS[..8], of_bodies);
    assert_eq!(Rods::REGRESSOR_PARAMETERS[8..], ["cart", "c[0]", "c[1]", "k"]);
}

#[test]
fn prepared_systems_have_the_same_regressor() {
    let (rods, q, v, a) = (Rods::default(), [0.3, 0.7, -0.4], [0.5, -1.0, 2.0], [1.5, 0.25, -0.75]);
    let (own, prepared) = (rods.regressor(0.0, &q, &v, &a), rods.prepared().regressor(0.0, &q, &v, &a));
    for (own, prepared) in own.iter().flatten().zip(prepared.iter().flatten()) {
        assert!((own - prepared).abs() < 1e-13);
    }
}

#[test]
fn the_interpreter_has_the_same_bits() {
    let text = "struct S; param m = 2, l = 0.7, c = 0.1; coord phi;
        gravity = (0, -9.81); body bob { mass: m; inertia: 0.1; centroid: (l, 0); origin: (0, 0); angle: phi; }
        dissipation = 1/2 * c * dot(phi)^2; emit { regressor }";
    let derived = parse(text).expect("valid").derive(StrategyChoice::Cheapest).expect("derived");
    let twin = NumericSystem::new(&derived);
    let bob = Bob::default();
    let emitted = bob.regressor(0.0, &[0.4], &[0.5], &[0.6]).concat();
    assert_eq!(twin.regressor(0.0, &[0.4], &[0.5], &[0.6]), Some(emitted));
    assert_eq!(twin.regressor_parameters(), bob.regressor_parameters());
}

lagrange::system! {
    /// A bob on a hinge.
    struct Bob;
    param m = 2, l = 0.7, c = 0.1;
    coord phi;
    gravity = (0, -9.81);
    body bob { mass: m; inertia: 0.1; centroid: (l, 0); origin: (0, 0); angle: phi; }
    dissipation = 1/2 * c * dot(phi)^2;
    emit { regressor }
}
