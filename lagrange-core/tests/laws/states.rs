//! First-order states beside any machine. Accelerations are those under inputs with the values of
//! the states. Rates follow their equations, derivatives those of both, and a frozen state is a
//! number.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::{Strategy, prop, prop_assert, prop_assert_eq, proptest};

use crate::machines::{Machine, machines};

/// Rates of the states `w` and `z`, in a machine with at least one coordinate.
const RATES: [[&str; 2]; 4] = [
    ["u - k*w - c*dot(q1)", "w*q1 - z"],
    ["sin(q1 - t)*z", "-w*z + dot(q1)^2"],
    ["exp(-w^2)/(1 + t^2)", "u*q1*sqrt(1 + z^2)"],
    ["z", "k*(q1 - w) - c*z"],
];

/// The action of the states on the machine.
const ACTIONS: [&str; 4] = [
    "force q1 = k*w - dot(q1)*z;",
    "potential = w*q1 + z^2*cos(q1);",
    "dissipation = (1 + w^2)*dot(q1)^2/2; force q1 = z;",
    "let pull = w*z; force q1 = pull*t; potential = k/2*(q1 - w)^2;",
];

/// Step of differences, short enough to avoid the kinks of a machine, which are at hundredths.
const STEP: f64 = 1e-5;

/// A machine with states, its parts without them, and the values of both.
#[derive(Clone, Debug)]
struct Motor {
    machine: Machine,
    rates: [&'static str; 2],
    action: String,
    values: [f64; 2],
}

fn motors() -> impl Strategy<Value = Motor> {
    let value = || (-150..150).prop_map(|hundredths: i32| f64::from(hundredths) / 100.0 + 0.003);
    let choices = (prop::sample::select(RATES.to_vec()), prop::sample::select(ACTIONS.to_vec()));
    (machines(), choices, [value(), value()]).prop_map(|(mut machine, (rates, action), values)| {
        machine.q.iter_mut().chain(&mut machine.v).for_each(|x| *x += 0.003);
        let action = match machine.text.contains("lagrangian = ") {
            true => action.replace("potential = ", "lagrangian = -1*").to_owned(),
            false => action.to_owned(),
        };
        Motor { machine, rates, action, values }
    })
}

impl Motor {
    /// Returns the machine with text before and behind the action of the states.
    fn system(&self, before: &str, behind: &str) -> Result<NumericSystem, String> {
        let text = format!("{} {before} {} {behind}", self.machine.text, self.action);
        let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        Ok(NumericSystem::new(&derived.map_err(|report| format!("{report}{text}"))?))
    }

    /// Returns the machine with states declared before a coordinate or behind all.
    fn with_states(&self) -> Result<NumericSystem, String> {
        let [a, b] = self.rates;
        self.system("state w, z;", &format!("dot(w) = {a}; dot(z) = {b}; emit {{ jacobian }}"))
    }

    /// Returns the machine with inputs instead of the states, and outputs instead of their rates.
    fn with_inputs(&self) -> Result<NumericSystem, String> {
        let [a, b] = self.rates;
        let mut system =
            self.system("input w, z;", &format!("output rate_of_w = {a}; output rate_of_z = {b};"))?;
        system.set("w", self.values[0]);
        system.set("z", self.values[1]);
        Ok(system)
    }

    fn positions(&self) -> Vec<f64> {
        [&self.machine.q[..], &self.values].concat()
    }
}

proptest! {
    #![proptest_config(crate::one_in(64))]

    #[test]
    fn states_are_inputs_with_rates(motor in motors()) {
        let (whole, given) = (motor.with_states().expect("derives"), motor.with_inputs().expect("derives"));
        let Machine { t, q, v, .. } = &motor.machine;
        let rates = whole.rhs(*t, &[&motor.positions()[..], v].concat());
        let output = |name| given.output(name, *t, q, v).expect("declared")[0];
        let expected = [v, &[output("rate_of_w"), output("rate_of_z")][..], &given.acceleration(*t, q, v)].concat();
        for (found, expected) in rates.iter().zip(&expected) {
            prop_assert!((found - expected).abs() <= 1e-9 * (1.0 + expected.abs()) || found.is_nan() && expected.is_nan());
        }
        prop_assert_eq!(rates.len(), expected.len());
    }

    #[test]
    fn derivatives_by_states_are_those_of_accelerations(motor in motors()) {
        let whole = motor.with_states().expect("derives");
        let Machine { t, q, v, .. } = &motor.machine;
        let n = v.len();
        let jacobian = whole.product(Product::Jacobian, *t, &motor.positions(), v).expect("asked for");
        for state in 0..2 {
            let at = |by: f64| {
                let mut positions = motor.positions();
                positions[q.len() + state] += by;
                whole.acceleration(*t, &positions, v)
            };
            let (ahead, behind) = (at(STEP), at(-STEP));
            for row in 0..n {
                let quotient = (ahead[row] - behind[row]) / (2.0 * STEP);
                let slope = jacobian[row * (2 * n + 2) + n + state];
                let size = 1.0 + slope.abs() + ahead[row].abs();
                prop_assert!((slope - quotient).abs() <= 1e-5 * size || slope.is_nan(), "{slope} {quotient}");
            }
        }
    }

    #[test]
    fn a_frozen_state_is_a_number(motor in motors()) {
        let ([a, b], value) = (motor.rates, motor.values[0]);
        let text = format!(
            "{} state w, z; {} dot(w) = {a}; dot(z) = {b}; reduce Held {{ freeze w = {value:?}; }}",
            motor.machine.text, motor.action
        );
        let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let derived = derived.unwrap_or_else(|report| panic!("{report}{text}"));
        let (whole, held) = (NumericSystem::new(&derived), NumericSystem::of_part(&derived.reduced[0]));
        let Machine { t, q, v, .. } = &motor.machine;
        let all = whole.rhs(*t, &[&motor.positions()[..], v].concat());
        let kept = held.rhs(*t, &[&q[..], &motor.values[1..], v].concat());
        let expected = [&all[..q.len()], &all[q.len() + 1..]].concat();
        for (found, expected) in kept.iter().zip(&expected) {
            prop_assert!((found - expected).abs() <= 1e-9 * (1.0 + expected.abs()) || found.is_nan() && expected.is_nan());
        }
        prop_assert_eq!(kept.len(), expected.len());
    }
}
