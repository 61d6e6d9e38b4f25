//! Compiled systems against reference values of an independent derivation with many digits (see
//! `tests/oracle/README.md`) and, bit for bit, against the interpreter of programs.

#[path = "oracle/complex.rs"]
mod complex;
#[path = "oracle/reference.rs"]
mod reference;

use std::path::Path;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

use complex::Complex;
use reference::{Reference, Subject, names};

/// Results of a system that the references lack.
trait Compiled: Subject {
    fn momentum_rates(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64>;
    /// Returns the right-hand side, and that of the lanes type with one number.
    fn both_rhs(&self, t: f64, y: &[f64]) -> [Vec<f64>; 2];
}

/// Declares a system, compiled at two levels of accuracy, with its tests:
/// `declare! { name, energies: …, mass_matrix: …; statements }`. The two words determine its
/// methods. `kinetic_energy` and `potential_energy` exist only for `separate` energies;
/// `mass_matrix` is a function of the `positions` or of the whole `state`.
macro_rules! declare {
    ($name:ident, energies: $energies:ident, mass_matrix: $mass_matrix:ident; $($declaration:tt)*) => {
        mod $name {
            const NAME: &str = stringify!($name);
            const DECLARATION: &str = stringify!($($declaration)*);

            declare!(@level standard, $energies, $mass_matrix; $($declaration)*);
            declare!(@level fast, $energies, $mass_matrix; $($declaration)*);
            declare!(@generic $($declaration)*);

            fn array<const N: usize>(values: &[f64]) -> [f64; N] {
                values.try_into().expect("one value for each coordinate")
            }
        }
    };
    (@level $level:ident, $energies:ident, $mass_matrix:ident; $($declaration:tt)*) => {
        mod $level {
            use lagrange::system::{CanonicalSystem, Equations, LanesSystem};

            use super::{DECLARATION, NAME, array};

            lagrange::system! {
                #[accuracy($level)]
                pub(crate) struct Compiled;
                $($declaration)*
                emit { momentum_rates, lanes }
            }

            impl crate::Compiled for Compiled {
                fn momentum_rates(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
                    let matrix = CanonicalSystem::mass_matrix(self, t, &array(q), &array(v));
                    assert_eq!(matrix, declare!(@$mass_matrix self, t, &array(q), &array(v)));
                    CanonicalSystem::momentum_rates(self, t, &array(q), &array(v)).to_vec()
                }

                fn both_rhs(&self, t: f64, y: &[f64]) -> [Vec<f64>; 2] {
                    let lanes = self.lanes(|parameter| parameter);
                    [self.rhs(t, &array(y)).to_vec(), lanes.rhs(t, &array(y)).to_vec()]
                }
            }

            impl crate::Subject for Compiled {
                fn acceleration(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
                    self.acceleration(t, &array(q), &array(v)).to_vec()
                }

                fn quantity(&self, key: &str, t: f64, q: &[f64], v: &[f64]) -> Option<Vec<f64>> {
                    let (q, v) = (&array(q), &array(v));
                    Some(match key {
                        "forcing" => self.forcing(t, q, v).to_vec(),
                        "mass_matrix" => declare!(@$mass_matrix self, t, q, v).concat(),
                        "momenta" => self.momenta(t, q, v).to_vec(),
                        "energy" => vec![self.energy(t, q, v)],
                        "kinetic" => declare!(@$energies vec![self.kinetic_energy(t, q, v)]),
                        "potential" => declare!(@$energies vec![self.potential_energy(t, q)]),
                        _ => return None,
                    })
                }

                fn inverse_dynamics(&self, t: f64, q: &[f64], v: &[f64], a: &[f64]) -> Vec<f64> {
                    self.inverse_dynamics(t, &array(q), &array(v), &array(a)).to_vec()
                }
            }

            #[test]
            fn agrees_with_reference_and_interpreter() {
                crate::check(NAME, stringify!($level), DECLARATION, &Compiled::default());
            }
        }
    };
    (@generic $($declaration:tt)*) => {
        mod generic {
            use lagrange::system::OdeSystem;

            use super::{NAME, array};
            use crate::complex::Complex;

            lagrange::system! {
                pub(crate) struct Compiled<S>;
                $($declaration)*
                emit { jacobian }
            }

            impl crate::Differentiated for Compiled<f64> {
                fn jacobian(&self, t: f64, y: &[f64]) -> Vec<f64> {
                    let jacobian = self.jacobian(t, &array(y));
                    assert_eq!(Some(jacobian), OdeSystem::jacobian(self, t, &array(y)));
                    jacobian.concat()
                }

                fn parameter_jacobian(&self, t: f64, y: &[f64]) -> (Vec<&'static str>, Vec<f64>) {
                    (Self::PARAMETERS.to_vec(), self.parameter_jacobian(t, &array(y)).concat())
                }

                fn complex_rhs(&self, t: Complex, y: &[Complex]) -> Vec<Complex> {
                    Compiled::<Complex>::default().rhs(t, y.try_into().expect("a state")).to_vec()
                }
            }

            #[test]
            fn jacobians_agree_with_complex_steps_and_interpreter() {
                crate::check_jacobians(NAME, &Compiled::default());
            }
        }
    };
    (@separate $value:expr) => { $value };
    (@joint $value:expr) => { return None };
    (@positions $system:expr, $t:expr, $q:expr, $v:expr) => { $system.mass_matrix($t, $q) };
    (@state $system:expr, $t:expr, $q:expr, $v:expr) => { $system.mass_matrix($t, $q, $v) };
}

#[path = "oracle/systems.rs"]
mod systems;

fn directory() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/oracle"))
}

#[test]
fn every_reference_is_compiled() {
    let systems = include_str!("oracle/systems.rs");
    let declared = systems.lines().filter_map(|line| line.strip_prefix("declare! { ")?.split(',').next());
    assert!(declared.eq(names(directory()).iter()), "run `python3 tests/oracle/declare.py`");
}

fn check(name: &str, level: &str, declaration: &str, compiled: &impl Compiled) {
    let reference = Reference::read(directory(), name);
    assert_eq!(packed(declaration), packed(&reference.declaration), "run `python3 tests/oracle/declare.py`");
    let failures = reference.failures(compiled);
    assert!(failures.is_empty(), "{}", failures.join("\n"));

    let text = format!(
        "#[accuracy({level})] struct Interpreted; {} emit {{ momentum_rates }}",
        reference.declaration
    );
    let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let mut interpreted = NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    for (name, value) in reference.settings() {
        assert!(interpreted.set(name, value), "{name} is declared");
    }
    for state in reference.states() {
        let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(
            bits(compiled.acceleration(state.t, &state.q, &state.v)),
            bits(interpreted.acceleration(state.t, &state.q, &state.v)),
        );
        let rates = interpreted.product(Product::MomentumRates, state.t, &state.q, &state.v);
        assert_eq!(
            bits(compiled.momentum_rates(state.t, &state.q, &state.v)),
            bits(rates.expect("it is asked for")),
        );
        check_lanes(compiled, state.t, &[state.q.clone(), state.v.clone()].concat());
    }
}

/// Compares the lanes type with the bits of the system at a state, and where one of its entries is
/// zero or NaN.
fn check_lanes(compiled: &impl Compiled, t: f64, y: &[f64]) {
    let others =
        (0..y.len()).flat_map(|entry| [0.0, -0.0, f64::NAN, f64::INFINITY].map(|value| (entry, value)));
    let states = others.map(|(entry, value)| {
        let mut other = y.to_vec();
        other[entry] = value;
        other
    });
    for y in states.chain([y.to_vec(), vec![0.0; y.len()]]) {
        let [alone, lanes] = compiled.both_rhs(t, &y);
        let is_same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
        assert!(alone.iter().zip(&lanes).all(is_same), "{lanes:?} is not {alone:?} at {y:?}");
    }
}

/// A compiled system with its Jacobians, row by row.
trait Differentiated {
    fn jacobian(&self, t: f64, y: &[f64]) -> Vec<f64>;
    /// Returns the parameter Jacobian with the names of its columns.
    fn parameter_jacobian(&self, t: f64, y: &[f64]) -> (Vec<&'static str>, Vec<f64>);
    /// Returns the right-hand side in complex numbers.
    fn complex_rhs(&self, t: Complex, y: &[Complex]) -> Vec<Complex>;
}

fn check_jacobians(name: &str, compiled: &impl Differentiated) {
    let reference = Reference::read(directory(), name);
    let text = format!("struct Interpreted; {} emit {{ jacobian }}", reference.declaration);
    let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let derived = derived.unwrap_or_else(|report| panic!("{report}"));
    let fields = derived.model.parameters.iter().chain(&derived.model.inputs);
    let fields = fields.map(|field| field.name.as_str()).collect::<Vec<_>>();
    let interpreted = NumericSystem::new(&derived);
    for state in reference.states() {
        let (t, y) = (state.t, [state.q.clone(), state.v.clone()].concat());
        let n = state.q.len();
        let (jacobian, (names, by_fields)) = (compiled.jacobian(t, &y), compiled.parameter_jacobian(t, &y));
        assert_eq!(names, fields);
        let steps = (0..2 * n).map(|j| complex_slope(compiled, t, &y, j)).collect::<Vec<_>>();
        for (i, row) in jacobian.chunks(2 * n).enumerate() {
            let slopes = steps.iter().map(|step| step[i]).collect::<Vec<_>>();
            let scale = slopes.iter().fold(1.0_f64, |largest, slope| largest.max(slope.abs()));
            let agrees = row.iter().zip(&slopes).all(|(a, b)| (a - b).abs() <= 1e-11 * scale);
            assert!(agrees, "{name}, row {i} at t = {t}: {row:?} or {slopes:?}");
        }
        let of_accelerations = [&jacobian[2 * n * n..], &by_fields[n * fields.len()..]];
        for (found, product) in
            of_accelerations.into_iter().zip([Product::Jacobian, Product::ParameterJacobian])
        {
            let expected = interpreted.product(product, t, &state.q, &state.v).expect("it is asked for");
            assert!(
                found.iter().map(|x| x.to_bits()).eq(expected.iter().map(|x| x.to_bits())),
                "{name}: {product:?}"
            );
        }
        assert!(by_fields[..n * fields.len()].iter().all(|entry| *entry == 0.0));
    }
}

/// Returns the derivative of the right-hand side by entry `j` of the state. It is the imaginary
/// part at a state with a tiny imaginary part in that entry, divided by it. Nothing is subtracted,
/// so the result is exact to rounding (Squire and Trapp 1998).
fn complex_slope(compiled: &impl Differentiated, t: f64, y: &[f64], j: usize) -> Vec<f64> {
    const STEP: f64 = 1e-100;
    let mut at = y.iter().map(|&y| Complex::from_real(y)).collect::<Vec<_>>();
    at[j].imaginary = STEP;
    let rate = compiled.complex_rhs(Complex::from_real(t), &at);
    rate.iter().map(|rate| rate.imaginary / STEP).collect()
}

/// Returns the tokens of a declaration, without comments and spaces.
fn packed(declaration: &str) -> String {
    let code = declaration.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| line.chars().filter(|c| !c.is_whitespace())).collect()
}
