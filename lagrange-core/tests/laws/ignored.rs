//! Machines with ignored cyclic coordinates: forces on the others, energies and velocities remain
//! those of the whole machine.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::{prop, prop_assert, proptest};

use crate::machines::{Machine, machines};

/// Bounds rounding in differently ordered sums.
const ROUNDED: f64 = 1e-9;

/// Two flywheels, geared with each other and with the machine, in a field.
const FLYWHEELS: &str = "coord s, r;
    KINETIC = 1/2*(1 + q1^2/3)*(dot(s) + cos(q1)*dot(q#) - t/2)^2 + 1/2*(2 + sin(q#))*(dot(r) - dot(s)/2)^2
        + b*q1*dot(r)/3;
    force q1 = -c*dot(s)*dot(r);
    dot(heat) = dot(r)^2 - heat;
    reduce Reduced { ignore r, s; }";

/// A machine with flywheels, and the same machine without them.
struct Pair {
    whole: NumericSystem,
    reduced: NumericSystem,
    t: f64,
    /// Positions and velocities of the machine.
    q: Vec<f64>,
    v: Vec<f64>,
    text: String,
}

/// Angles of the flywheels, and the state.
const OUTER: [f64; 3] = [0.3, -0.7, 0.4];
/// Their velocities.
const SPINS: [f64; 2] = [0.8, -1.1];

impl Pair {
    fn new(machine: Machine) -> Pair {
        let Machine { mut text, t, q, v } = machine;
        let kinetic = if text.contains("lagrangian") { "lagrangian" } else { "kinetic" };
        text += &FLYWHEELS.replace('#', &q.len().to_string()).replace("KINETIC", kinetic);
        text = text.replace("coord s, r;", "coord s, r; state heat;");
        let system = parse(&text).unwrap_or_else(|report| panic!("{report}: {text}"));
        let derived =
            system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}: {text}"));
        let (whole, reduced) = (NumericSystem::new(&derived), NumericSystem::of_part(&derived.reduced[0]));
        let mut pair = Pair { whole, reduced, t, q, v, text };
        let momenta = pair.of_whole(Product::Momenta);
        for (name, momentum) in ["s_momentum", "r_momentum"].iter().zip(&momenta[pair.q.len()..]) {
            assert!(pair.reduced.set(name, *momentum), "{}", pair.text);
        }
        pair
    }

    fn whole_state(&self) -> [Vec<f64>; 2] {
        [[&self.q[..], &OUTER].concat(), [&self.v[..], &SPINS].concat()]
    }

    /// Returns the positions, with the angles of the flywheels behind the state, as states.
    fn reduced_positions(&self) -> Vec<f64> {
        [&self.q[..], &[OUTER[2], OUTER[0], OUTER[1]]].concat()
    }

    fn of_whole(&self, product: Product) -> Vec<f64> {
        let [q, v] = self.whole_state();
        self.whole.product(product, self.t, &q, &v).expect("derived by default")
    }

    /// Returns the forces for given accelerations of the machine while the flywheels are free of
    /// forces.
    fn forces(&self, a: &[f64]) -> Vec<f64> {
        let ([q, v], n) = (self.whole_state(), self.q.len());
        let forces = |spins: [f64; 2]| {
            let a = [a, &spins].concat();
            self.whole.inverse_dynamics(self.t, &q, &v, &a).expect("derived by default")
        };
        let (rest, matrix) = (forces([0.0; 2]), self.of_whole(Product::MassMatrix));
        let entry = |row: usize, column: usize| matrix[(n + row) * (n + 2) + n + column];
        let determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
        let (r, s) = (-rest[n], -rest[n + 1]);
        let spins = [
            (entry(1, 1) * r - entry(0, 1) * s) / determinant,
            (entry(0, 0) * s - entry(1, 0) * r) / determinant,
        ];
        forces(spins)[..n].to_vec()
    }

    /// Returns the scale of errors.
    fn scale(&self) -> f64 {
        let all = [self.of_whole(Product::Forcing), self.of_whole(Product::MassMatrix)].concat();
        all.into_iter().fold(1.0, |largest: f64, x| largest.max(x.abs()))
    }
}

proptest! {
    #![proptest_config(crate::one_in(10))]

    #[test]
    fn ignored_coordinates_still_act(machine in machines(), a in prop::collection::vec(-2.0..2.0, 5)) {
        let pair = Pair::new(machine);
        let (t, q, scale) = (pair.t, pair.reduced_positions(), pair.scale());
        let a = &a[..pair.q.len()];
        let found = pair.reduced.inverse_dynamics(t, &q, &pair.v, a).expect("derived by default");
        for (found, expected) in found.into_iter().zip(pair.forces(a)) {
            prop_assert!((found - expected).abs() <= ROUNDED * scale, "{found} {expected}: {}", pair.text);
        }
        let rates = pair.reduced.position_rates(t, &q, &pair.v);
        for (found, expected) in rates[pair.q.len() + 1..].iter().zip(SPINS) {
            prop_assert!((found - expected).abs() <= ROUNDED * scale, "{found} {expected}: {}", pair.text);
        }
        let energy = pair.reduced.product(Product::Energy, t, &q, &pair.v).expect("derived by default");
        let expected = pair.of_whole(Product::Energy);
        prop_assert!((energy[0] - expected[0]).abs() <= ROUNDED * scale, "{energy:?}: {}", pair.text);
    }
}
