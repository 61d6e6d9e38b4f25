//! A Gibbs function and its energies give the same equations of motion, at random states and where
//! rates and angles are exactly zero.

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::{Just, Strategy as Values, prop, prop_oneof, proptest};

use crate::one_in;

/// Bounds rounding in differently ordered sums and eliminations.
const ROUNDED: f64 = 1e-9;

/// Energies, the Gibbs function that replaces all or some of them, and the other statements.
struct Pair {
    energies: &'static str,
    gibbs: &'static str,
    rest: &'static str,
}

/// A top about a fixed point. In body axes, ω satisfies Euler's kinematic equations, and with α =
/// ω̇ the Gibbs function leads to Euler's equations. Gravity acts as an acceleration of the base.
const TOP: Pair = Pair {
    energies: "coord psi, theta, phi;
        let w1 = dot(psi)*sin(theta)*sin(phi) + dot(theta)*cos(phi);
        let w2 = dot(psi)*sin(theta)*cos(phi) - dot(theta)*sin(phi);
        let w3 = dot(psi)*cos(theta) + dot(phi);
        let T = 1/2*(2*w1^2 + 3*w2^2 + 4*w3^2); let V = 5*9.81*cos(theta);
        kinetic = T; potential = V;",
    gibbs: "let (a1, a2, a3) = (dot(w1), dot(w2), dot(w3));
        gibbs = 1/2*(2*a1^2 + 3*a2^2 + 4*a3^2) + (4 - 3)*w2*w3*a1 + (2 - 4)*w3*w1*a2 + (3 - 2)*w1*w2*a3
            + 5*9.81*(a2*sin(theta)*sin(phi) - a1*sin(theta)*cos(phi)), for: T - V;",
    rest: "dissipation = 1/2*0.3*dot(phi)^2; force theta = 0.7*sin(t);",
};

/// An arm that turns about a vertical axis and bends at its elbow. The accelerations of its two
/// links are in body-fixed axes. Its motor is in no Gibbs function.
const ARM: Pair = Pair {
    energies: "coord yaw, shoulder, elbow, motor;
        let (c1, s1) = (cos(shoulder), sin(shoulder));
        let (u1, u2, u3) = (s1*dot(yaw), c1*dot(yaw), dot(shoulder));
        let (c2, s2) = (cos(elbow), sin(elbow));
        let (w1, w2, w3) = (c2*u1 + s2*u2, c2*u2 - s2*u1, u3 + dot(elbow));
        let (x, y, z) = (0, 0.8*u3, -0.8*u2);
        let (v1, v2, v3) = (c2*x + s2*y, c2*y - s2*x, z);
        let T1 = 1/2*(0.1*u1^2 + 0.9*u2^2 + 0.8*u3^2); let V1 = 3*9.81*0.4*s1;
        let T2 = 1/2*1.5*(v1^2 + (v2 + 0.3*w3)^2 + (v3 - 0.3*w2)^2) + 1/2*(0.01*w1^2 + 0.2*w2^2 + 0.21*w3^2);
        let V2 = 1.5*9.81*(0.8*s1 + 0.3*sin(shoulder + elbow));
        kinetic = T1 + T2 + 1/2*0.4*dot(motor)^2; potential = V1 + V2 + 1/2*7*(motor - elbow)^2;",
    gibbs: "let (e1, e2, e3) = (s1*ddot(yaw) + c1*dot(yaw)*dot(shoulder), c1*ddot(yaw) - s1*dot(yaw)*dot(shoulder), ddot(shoulder));
        let (g1, g2) = (9.81*s1, 9.81*c1);
        let b = (g1 - 0.8*(u2^2 + u3^2), g2 + 0.8*(e3 + u1*u2), 0.8*(u1*u3 - e2));
        let (d1, d2, d3) = (c2*e1 + s2*e2 + w2*dot(elbow), c2*e2 - s2*e1 - w1*dot(elbow), e3 + ddot(elbow));
        let (a1, a2, a3) = (c2*b.x + s2*b.y, c2*b.y - s2*b.x, b.z);
        gibbs = 1/2*(0.1*e1^2 + 0.9*e2^2 + 0.8*e3^2) + (0.8 - 0.9)*u2*u3*e1 + (0.1 - 0.8)*u3*u1*e2
            + (0.9 - 0.1)*u1*u2*e3 + 3*0.4*g2*e3, for: T1 - V1;
        gibbs = 1/2*1.5*((a1 - 0.3*(w2^2 + w3^2))^2 + (a2 + 0.3*(d3 + w1*w2))^2 + (a3 + 0.3*(w1*w3 - d2))^2)
            + 1/2*(0.01*d1^2 + 0.2*d2^2 + 0.21*d3^2) + (0.21 - 0.2)*w2*w3*d1 + (0.01 - 0.21)*w3*w1*d2
            + (0.2 - 0.01)*w1*w2*d3, for: T2 - V2;",
    rest: "input u; force motor = u - 0.2*dot(motor);
        force (0.3, -0.2) at (sin(yaw)*cos(shoulder), sin(shoulder));",
};

/// A bead held on a moving ellipse by a constraint, and another that rolls. Velocities are rates of
/// positions, and the Gibbs function includes the motion of the base.
const BEAD: Pair = Pair {
    energies: "coord x, y, phi;
        let lift = 0.1*sin(3*t);
        let T = 1/2*2*(dot(x)^2 + (dot(y) + dot(lift))^2) + 1/2*0.5*dot(phi)^2; let V = 2*9.81*y;
        kinetic = T; potential = V;",
    gibbs: "gibbs = 1/2*2*(ddot(x)^2 + (ddot(y) + ddot(lift) + 9.81)^2) + 1/2*0.5*ddot(phi)^2, for: T - V;",
    rest: "constraint ellipse = x^2 + 4*y^2 - 1; constraint rolling = dot(x) + y*dot(phi);
        dissipation = 1/2*0.2*(dot(x)^2 + dot(y)^2);",
};

impl Pair {
    fn system(&self, gibbs: &str, choice: StrategyChoice) -> NumericSystem {
        let emit = "emit { jacobian, bias, momenta, momentum_rates, energy }";
        let text = [self.energies, gibbs, self.rest, emit].join("\n");
        let system = parse(&text).unwrap_or_else(|report| panic!("{report}"));
        NumericSystem::new(&system.derive(choice).unwrap_or_else(|report| panic!("{report}")))
    }

    /// Compares every consequence of the energies with that of the Gibbs function, by each
    /// strategy.
    fn check(&self, [q, v, a]: [&[f64]; 3]) {
        let by_energies = self.system("", StrategyChoice::Always(Strategy::MassMatrix));
        for strategy in [Strategy::MassMatrix, Strategy::ArticulatedBody] {
            let by_gibbs = self.system(self.gibbs, StrategyChoice::Always(strategy));
            assert_equal([&by_energies, &by_gibbs], [q, v, a]);
        }
    }
}

/// Compares every consequence of two declarations.
pub(crate) fn assert_equal(both: [&NumericSystem; 2], [q, v, a]: [&[f64]; 3]) {
    assert_near("acceleration", both.map(|system| system.acceleration(0.3, q, v)));
    assert_near("multipliers", both.map(|system| system.multipliers(0.3, q, v)));
    let inverse = both.map(|system| system.inverse_dynamics(0.3, q, v, a).expect("by default"));
    assert_near("inverse_dynamics", inverse);
    for product in Product::ALL.into_iter().filter(|product| *product != Product::InverseDynamics) {
        if let [Some(expected), Some(found)] = both.map(|system| system.product(product, 0.3, q, v)) {
            assert_near(product.name(), [expected, found]);
        }
    }
}

fn assert_near(what: &str, [expected, found]: [Vec<f64>; 2]) {
    assert_eq!(expected.len(), found.len(), "{what}");
    let size = expected.iter().fold(1.0_f64, |size, value| size.max(value.abs()));
    for (i, (expected, found)) in expected.iter().zip(&found).enumerate() {
        assert!((expected - found).abs() <= ROUNDED * size, "{what}, {i}: {expected} and {found}");
    }
}

/// Draws numbers, every third of them exactly zero.
pub(crate) fn numbers(count: usize) -> impl Values<Value = Vec<f64>> {
    prop::collection::vec(prop_oneof![1 => Just(0.0), 2 => -2.0..2.0], count)
}

proptest! {
    #![proptest_config(one_in(16))]

    #[test]
    fn a_top_obeys_eulers_equations(q in numbers(3), v in numbers(3), a in numbers(3)) {
        let upright = q[1].sin().abs() < 1e-2;
        let q = if upright { vec![q[0], 1.0, q[2]] } else { q };
        TOP.check([&q, &v, &a]);
    }

    #[test]
    fn links_move_by_accelerations_in_their_own_axes(q in numbers(4), v in numbers(4), a in numbers(4)) {
        ARM.check([&q, &v, &a]);
    }

    #[test]
    fn constraints_act_on_what_gibbs_functions_state(angle in 0.2..2.9_f64, speed in -2.0..2.0_f64, a in numbers(3)) {
        let (q, x_dot) = ([angle.cos(), 0.5 * angle.sin(), 0.0], -angle.sin() * speed);
        BEAD.check([&q, &[x_dot, 0.5 * angle.cos() * speed, -x_dot / q[1]], &a]);
    }
}

#[test]
fn everything_may_be_at_rest() {
    ARM.check([&[0.0; 4]; 3]);
    BEAD.check([&[0.0, 0.5, 0.0], &[0.0; 3], &[0.0; 3]]);
    TOP.check([&[0.0, 1.0, 0.0], &[0.0; 3], &[0.0; 3]]);
}
