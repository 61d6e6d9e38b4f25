//! Matrices of the dynamics of emitted types: with the bits of their interpreted twins, prepared,
//! and in other numbers.

use lagrange::system::OdeSystem;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

macro_rules! declared {
    ($text:ident: $name:ident { $($statements:tt)* }) => {
        const $text: &str = stringify!($($statements)*);

        lagrange::system! {
            #[derive(Debug)]
            struct $name<S>;
            $($statements)*
        }
    };
}

declared! { ROD: Rod {
    param m = 2, l = 0.7, g = 9.81, k = 3;
    coord x, phi;
    kinetic = 1/2 * dot(x)^2 + kinetic_energy(m, dot((x + l*sin(phi), -l*cos(phi))));
    potential = 1/2*k*x^2 - m*g*l*cos(phi);
    dissipation = 0.1*dot(phi)^2;
    emit { coriolis_matrix, inverse_mass_matrix, inverse_dynamics_jacobian, bias, prepared }
} }

declared! { BALL: Ball {
    param g = 9.81;
    coord x, y = 1;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g*y;
    event near = x*y - sin(3*t), rising => record;
    event floor = y - 0.1*x^2, falling => { dot(y) = -0.5*dot(y); };
    emit { event_jacobian }
} }

fn twin(text: &str) -> NumericSystem {
    let derived =
        parse(&format!("struct S; {text}")).and_then(|system| system.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}")))
}

const Q: [f64; 2] = [0.3, 0.7];
const V: [f64; 2] = [0.5, -1.0];
const A: [f64; 2] = [1.5, 0.25];

#[test]
fn the_interpreter_has_the_same_bits() {
    let (rod, rod_twin) = (Rod::default(), twin(ROD));
    let of_twin = |product| rod_twin.product(product, 0.0, &Q, &V).expect("it is emitted");
    assert_eq!(rod.coriolis_matrix(0.0, &Q, &V).concat(), of_twin(Product::CoriolisMatrix));
    assert_eq!(rod.inverse_mass_matrix(0.0, &Q).concat(), of_twin(Product::InverseMassMatrix));
    let slopes = rod.inverse_dynamics_jacobian(0.0, &Q, &V, &A);
    assert_eq!(Some(slopes.concat()), rod_twin.inverse_dynamics_jacobian(0.0, &Q, &V, &A));
    let (ball, ball_twin) = (Ball::<f64>::default(), twin(BALL));
    let found = ball.event_jacobian(0.5, &[Q[0], Q[1], V[0], V[1]]);
    assert_eq!(Some(found.concat()), ball_twin.product(Product::EventJacobian, 0.5, &Q, &V));
}

#[test]
fn prepared_systems_and_other_numbers_have_the_same_matrices() {
    let (rod, small) = (Rod::<f64>::default(), Rod::<f32>::default());
    let prepared = rod.prepared();
    let narrow = |vector: [f64; 2]| vector.map(|x| x as f32);
    let rows = [
        (
            rod.coriolis_matrix(0.0, &Q, &V).concat(),
            prepared.coriolis_matrix(0.0, &Q, &V).concat(),
            small.coriolis_matrix(0.0, &narrow(Q), &narrow(V)).concat(),
        ),
        (
            rod.inverse_mass_matrix(0.0, &Q).concat(),
            prepared.inverse_mass_matrix(0.0, &Q).concat(),
            small.inverse_mass_matrix(0.0, &narrow(Q)).concat(),
        ),
        (
            rod.inverse_dynamics_jacobian(0.0, &Q, &V, &A).concat(),
            prepared.inverse_dynamics_jacobian(0.0, &Q, &V, &A).concat(),
            small.inverse_dynamics_jacobian(0.0, &narrow(Q), &narrow(V), &narrow(A)).concat(),
        ),
    ];
    for (own, prepared, small) in rows {
        for ((own, prepared), small) in own.iter().zip(prepared).zip(small) {
            assert!((own - prepared).abs() < 1e-13, "{own} {prepared}");
            assert!((own - f64::from(small)).abs() < 1e-4, "{own} {small}");
        }
    }
}

/// The only entry is −m l sin φ φ̇, in the row of x and the column of φ.
#[test]
fn a_rod_on_a_cart_has_the_matrix_found_by_hand() {
    let entry = -2.0 * 0.7 * Q[1].sin() * V[1];
    let [[xx, across], row] = Rod::default().coriolis_matrix(0.0, &Q, &V);
    assert!([xx, across - entry, row[0], row[1]].iter().all(|error: &f64| error.abs() < 1e-15));
}

/// The rate of an event function along the motion tells how transversal its zero is.
#[test]
fn derivatives_of_events_give_their_rates() {
    let (ball, t, y) = (Ball::<f64>::default(), 0.4, [0.3, 0.7, 0.5, -1.0]);
    let rates = OdeSystem::rhs(&ball, t, &y);
    let found = ball
        .event_jacobian(t, &y)
        .map(|row| row.iter().zip(rates).map(|(slope, rate)| slope * rate).sum::<f64>() + row[4]);
    let expected = [0.5 * 0.7 - 0.3 - 3.0 * f64::cos(1.2), -1.0 - 0.2 * 0.3 * 0.5];
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {expected:?}");
}
