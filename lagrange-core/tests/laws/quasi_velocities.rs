//! Components along moving axes give the same equations whether or not the derivation sees that a
//! joint turns them. Where cosines are written as 1 − 2 sin²(x/2), generalised momenta and their
//! rates replace brackets.

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::proptest;

use crate::gibbs::{assert_equal, numbers};
use crate::one_in;

/// Returns axes that turn with time and with coordinates, each made of others, in either sense.
/// Weights change, products are of all kinds, and some terms are linear in the velocities.
fn declaration(cosine: impl Fn(&str) -> String) -> String {
    let [theta, b, d] = ["theta", "b", "d"].map(cosine);
    format!(
        "coord x, y, z, a, b, d;
        let theta = 2*a + 3*t; let w = 2*dot(a) + 3;
        let (v1, v2) = ({theta}*dot(x) + sin(theta)*dot(y), {theta}*dot(y) - sin(theta)*dot(x));
        let h2 = v2 + 0.7*w;
        let (u1, u2) = ({b}*v1 - sin(b)*h2, {b}*h2 + sin(b)*v1);
        let (k2, k3) = (-{d}*u2 - sin(d)*dot(z), sin(d)*u2 - {d}*dot(z));
        let drift = x*u1 + if a < 0 {{ k2 }} else {{ 2*k2 }} + sin(t);
        kinetic = 1/2*(2 + sin(a)^2)*(u1^2 + k2^2 + 2*k3^2) + 0.5*u1*k2 - 0.3*k2*k3 + 1/2*drift^2
            + 1/2*(dot(a)^2 + 0.3*(dot(b) + w)^2 + 0.2*dot(d)^2) + cos(x)*u2 + y*k3;
        potential = z*cos(b) + x^2;
        emit {{ jacobian, bias, momenta, momentum_rates, energy }}"
    )
}

fn system(text: &str, strategy: Strategy) -> NumericSystem {
    let system = parse(text).unwrap_or_else(|report| panic!("{report}"));
    NumericSystem::new(
        &system.derive(StrategyChoice::Always(strategy)).unwrap_or_else(|report| panic!("{report}")),
    )
}

proptest! {
    #![proptest_config(one_in(32))]

    #[test]
    fn brackets_are_rates_of_momenta(q in numbers(6), v in numbers(6), a in numbers(6)) {
        let hidden = declaration(|angle| format!("(1 - 2*sin({angle}/2)^2)"));
        let turned = declaration(|angle| format!("cos({angle})"));
        for strategy in [Strategy::MassMatrix, Strategy::ArticulatedBody] {
            assert_equal([&system(&hidden, Strategy::MassMatrix), &system(&turned, strategy)], [&q, &v, &a]);
        }
    }
}
