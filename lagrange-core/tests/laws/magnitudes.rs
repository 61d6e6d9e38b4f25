//! Even powers of magnitudes are polynomials at every state, especially at exact zeros.
//!
//! Random systems are written with `abs`, `norm`, `hypot` and roots of squares. Each stands for a
//! polynomial, which is differentiated in exact rational arithmetic.
//! `PROPTEST_CASES=2560 cargo test -p lagrange-core --release --test laws magnitudes` takes 5120
//! systems.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::number::Number;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};
use proptest::prelude::ProptestConfig;

use crate::polynomials::{Polynomial, VARIABLES};

/// Bound on errors relative to the largest entry, or to one if that is larger.
const TOLERANCE: f64 = 1e-11;
const SMALLEST_PIVOT: f64 = 1e-3;
const COORDINATES: usize = 2;
/// States at which each system is tested.
const STATES: usize = 3;
const NAMES: [&str; VARIABLES] = ["x", "y", "dot(x)", "dot(y)", "k"];

/// The generator SplitMix64 (Steele, Lea and Flood, *Fast splittable pseudorandom number
/// generators*, 2014).
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (bits ^ (bits >> 31)) % n
    }

    /// Draws a nonzero multiple of one quarter with a magnitude of at most one.
    fn quarters(&mut self) -> Number {
        let magnitude = 1 + self.below(4) as i64;
        let sign = if self.below(2) == 0 { 1 } else { -1 };
        Number::ratio(sign * magnitude, 4).expect("no zero")
    }
}

/// An expression in the language with the polynomial that it equals.
#[derive(Clone)]
struct Term {
    text: String,
    value: Polynomial,
}

impl Term {
    fn times(&self, other: &Term) -> Term {
        Term { text: format!("({})*({})", self.text, other.text), value: self.value.times(&other.value) }
    }
}

/// Draws a linear function of two variables, or a product of them.
fn simple(random: &mut Random, variables: [usize; 2]) -> Term {
    let [a, b] = variables.map(Polynomial::variable);
    let [p, q] = variables.map(|variable| NAMES[variable]);
    let c = random.quarters();
    match random.below(5) {
        0 => Term { text: p.to_owned(), value: a },
        1 => Term { text: format!("({c})*{q}"), value: b.scaled(&c) },
        2 => Term { text: format!("{p} + ({c})*{q}"), value: a.plus(&b.scaled(&c)) },
        3 => Term { text: format!("{q} - {p}"), value: b.minus(&a) },
        _ => Term { text: format!("({c})*k*{p}"), value: a.times(&Polynomial::variable(4)).scaled(&c) },
    }
}

/// Draws an even power of magnitudes of simple expressions.
fn even(random: &mut Random, variables: [usize; 2]) -> Term {
    let (u, w) = (simple(random, variables), simple(random, variables));
    let (square, other) = (u.value.power(2), w.value.power(2));
    let u_minus_w = u.value.minus(&w.value);
    let sum = square.plus(&other);
    let one = Polynomial::constant(Number::ONE);
    let k = Polynomial::variable(4);
    let (u, w) = (u.text, w.text);
    let (text, value) = match random.below(24) {
        0 => (format!("abs({u})^2"), square),
        1 => (format!("abs({u})*abs({u})"), square),
        2 => (format!("pow(abs({u}), 2)"), square),
        3 => (format!("norm(({u}, 0))^2"), square),
        4 => (format!("norm(({u}, {w}))^2"), sum),
        5 => (format!("norm((0, {u}, {w}))^2"), sum),
        6 => (format!("hypot({u}, 0)^2"), square),
        7 => (format!("hypot({u}, {w})^2"), sum),
        8 => (format!("2*kinetic_energy(1, norm(({u}, {w})))"), sum),
        9 => (format!("sqrt(({u})^2)^2"), square),
        10 => (format!("sqrt(({u})^2)*abs({u})"), square),
        11 => (format!("sqrt(4*({u})^2)*norm(({u}, 0))/2"), square),
        12 => (format!("abs(k*({u}))*abs({u})"), square.times(&k)),
        13 => (format!("(abs({u}) + 1)*(abs({u}) - 1)"), square.minus(&one)),
        14 => (format!("abs({u})^4"), square.power(2)),
        15 => (format!("norm(({u}, {w}))^4"), sum.power(2)),
        16 => (format!("abs(({u})*({w}))*abs({w})*abs({u})"), square.times(&other)),
        17 => (format!("max({u}, -({u}))^2"), square),
        18 => (format!("abs({u})^3/abs({u})"), square),
        19 => (format!("(1/abs(1/norm(({u}, {w}))))^2"), sum),
        20 => (format!("(k*(abs({u})*abs({w})))*abs({w})*abs({u})"), square.times(&other).times(&k)),
        21 => (format!("abs(2*({u}))*abs(-3*({u}))/6"), square),
        22 => (format!("abs({u} - ({w}))*abs(({w}) - ({u}))"), u_minus_w.power(2)),
        _ => (format!("abs({u})/abs(1/({u}))"), square),
    };
    Term { text, value }
}

const POSITIONS: [usize; 2] = [0, 1];
const VELOCITIES: [usize; 2] = [2, 3];

/// Returns d/dt of a function of positions.
fn rate(value: &Polynomial) -> Polynomial {
    let parts = POSITIONS.map(|i| value.derivative(i).times(&Polynomial::variable(COORDINATES + i)));
    parts[0].plus(&parts[1])
}

/// The contents of a declaration.
struct System {
    text: String,
    kinetic: Polynomial,
    potential: Polynomial,
    dissipation: Polynomial,
}

impl System {
    fn random(random: &mut Random) -> System {
        let mut system = System {
            text: "param k = 3/2; coord x, y; emit { bias, jacobian, momentum_rates }\n".to_owned(),
            kinetic: Polynomial::default(),
            potential: Polynomial::default(),
            dissipation: Polynomial::default(),
        };
        for _ in 0..2 + random.below(2) {
            let mut term = even(random, VELOCITIES);
            if random.below(3) == 0 {
                term = even(random, POSITIONS).times(&term);
            }
            system.text.push_str(&format!("kinetic = 1/2*({});\n", term.text));
            system.kinetic = system.kinetic.plus(&term.value.scaled(&Number::ratio(1, 2).expect("no zero")));
        }
        // Rates of magnitudes, whatever is squared.
        let u = simple(random, POSITIONS);
        system.text.push_str(&format!("kinetic = dot(norm(({}, 0)))^2;\n", u.text));
        system.kinetic = system.kinetic.plus(&rate(&u.value).power(2));
        let term = even(random, POSITIONS);
        system.text.push_str(&format!("let n = {}; potential = n;\n", term.text));
        system.potential = system.potential.plus(&term.value);
        let (term, u) = (even(random, VELOCITIES), simple(random, POSITIONS));
        system.text.push_str(&format!("dissipation = {} + dot(abs({}))^2/2;\n", term.text, u.text));
        let half = Number::ratio(1, 2).expect("no zero");
        system.dissipation = term.value.plus(&rate(&u.value).power(2).scaled(&half));
        system
    }

    /// True if the mass matrix is regular somewhere.
    fn has_inertia(&self) -> bool {
        let generic = [3, 5, 7, 11, 13].map(|n| Number::ratio(n, 8).expect("no zero"));
        truth(self, &generic).is_some()
    }

    fn lagrangian(&self) -> Polynomial {
        self.kinetic.minus(&self.potential)
    }
}

/// A row of polynomials.
type Row = Vec<Polynomial>;

/// The undivided equations M a = f of a system.
struct Equations {
    mass: Vec<Row>,
    forcing: Row,
    momenta: Row,
}

impl Equations {
    fn new(system: &System) -> Equations {
        let lagrangian = system.lagrangian();
        let momenta = VELOCITIES.map(|v| lagrangian.derivative(v)).to_vec();
        let mass = momenta.iter().map(|p| VELOCITIES.map(|v| p.derivative(v)).to_vec()).collect();
        let forcing = (0..COORDINATES).map(|i| {
            let force = lagrangian.derivative(i).minus(&system.dissipation.derivative(COORDINATES + i));
            force.minus(&rate(&momenta[i]))
        });
        Equations { mass, forcing: forcing.collect(), momenta }
    }
}

type Point = [Number; VARIABLES];

fn values(row: &[Polynomial], point: &Point) -> Vec<Number> {
    row.iter().map(|polynomial| polynomial.at(point)).collect()
}

/// Solves two equations by Cramer's rule; `None` if they are singular.
fn solve(mass: &[Vec<Number>], right: &[Number]) -> Option<Vec<Number>> {
    let minor = |a: &Number, b: &Number, c: &Number, d: &Number| &(a * d) - &(b * c);
    let inverse = minor(&mass[0][0], &mass[0][1], &mass[1][0], &mass[1][1]).reciprocal()?;
    let first = minor(&right[0], &mass[0][1], &right[1], &mass[1][1]);
    let second = minor(&mass[0][0], &right[0], &mass[1][0], &right[1]);
    Some(vec![&first * &inverse, &second * &inverse])
}

/// Returns ∂a/∂x = M⁻¹ (∂f/∂x − ∂M/∂x a) for the variable with this index.
fn slope(equations: &Equations, mass: &[Vec<Number>], a: &[Number], at: &Point, index: usize) -> Vec<Number> {
    let right = (0..COORDINATES).map(|i| {
        let changes = equations.mass[i].iter().zip(a).map(|(m, a)| &m.derivative(index).at(at) * a);
        changes.fold(equations.forcing[i].derivative(index).at(at), |sum, change| &sum - &change)
    });
    solve(mass, &right.collect::<Vec<_>>()).expect("it was regular")
}

/// The accelerations, and every product with its value.
type Truth = (Vec<Number>, Vec<(Product, Vec<Number>)>);

/// Returns every product with its exact value.
fn truth(system: &System, at: &Point) -> Option<Truth> {
    let equations = Equations::new(system);
    let mass = equations.mass.iter().map(|row| values(row, at)).collect::<Vec<_>>();
    let forcing = values(&equations.forcing, at);
    let a = solve(&mass, &forcing)?;
    let lagrangian = system.lagrangian();
    let inertial = |i: usize| &rate(&equations.momenta[i]).at(at) - &lagrangian.derivative(i).at(at);
    let momentum_rate =
        |i: usize| &lagrangian.derivative(i).at(at) - &system.dissipation.derivative(COORDINATES + i).at(at);
    let momenta = values(&equations.momenta, at);
    let power = momenta.iter().zip(&at[2..]).fold(Number::ZERO, |sum, (p, v)| &sum + &(p * v));
    let slopes = (0..VARIABLES).map(|index| slope(&equations, &mass, &a, at, index)).collect::<Vec<_>>();
    let row = |i: usize| slopes[..2 * COORDINATES].iter().map(move |column| column[i].clone());
    let truth = vec![
        (Product::MassMatrix, mass.concat()),
        (Product::Forcing, forcing),
        (Product::Bias, (0..COORDINATES).map(inertial).collect()),
        (Product::MomentumRates, (0..COORDINATES).map(momentum_rate).collect()),
        (Product::Momenta, momenta),
        (Product::KineticEnergy, vec![system.kinetic.at(at)]),
        (Product::PotentialEnergy, vec![system.potential.at(at)]),
        (Product::Energy, vec![&power - &lagrangian.at(at)]),
        (Product::Jacobian, (0..COORDINATES).flat_map(row).collect()),
        (Product::ParameterJacobian, slopes[2 * COORDINATES].clone()),
    ];
    Some((a, truth))
}

fn point(random: &mut Random) -> Point {
    // Everything zero, everything at rest, or each component independently.
    let kind = random.below(4);
    let mut point = std::array::from_fn(|i| match kind {
        0 => Number::ZERO,
        1 if i >= COORDINATES => Number::ZERO,
        2 => random.quarters(),
        _ if random.below(2) == 0 => Number::ZERO,
        _ => random.quarters(),
    });
    point[4] = Number::ratio(3, 2).expect("no zero");
    point
}

fn assert_near(found: &[f64], exact: &[Number], what: &str) {
    let exact = exact.iter().map(Number::to_f64).collect::<Vec<_>>();
    let scale = exact.iter().fold(1.0_f64, |largest, value| largest.max(value.abs()));
    assert_eq!(found.len(), exact.len(), "{what}");
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= TOLERANCE * scale;
    assert!(found.iter().zip(&exact).all(is_near), "{what}: {found:?}, not {exact:?}");
}

/// Compares every product of a system, and returns true if the system was regular.
fn check(system: &System, numeric: &NumericSystem, at: &Point) -> bool {
    let state = at.each_ref().map(Number::to_f64);
    let (q, v) = (&state[..COORDINATES], &state[COORDINATES..2 * COORDINATES]);
    let Some((a, products)) = truth(system, at) else { return false };
    // Near-zero pivots lose digits, which this test does not judge.
    let mass = products[0].1.clone();
    let determinant = &(&mass[0] * &mass[3]) - &(&mass[1] * &mass[2]);
    if [&mass[0], &mass[3], &determinant].into_iter().any(|pivot| pivot.to_f64() < SMALLEST_PIVOT) {
        return false;
    }
    let what = |name: &str| format!("{name} of\n{}at {state:?}", system.text);
    assert_near(&numeric.acceleration(0.0, q, v), &a, &what("accelerations"));
    for (product, exact) in products {
        let found = numeric.product(product, 0.0, q, v).expect("it is emitted");
        assert_near(&found, &exact, &what(product.name()));
    }
    let accelerations = a.iter().map(Number::to_f64).collect::<Vec<_>>();
    let forces = numeric.inverse_dynamics(0.0, q, v, &accelerations).expect("it is emitted");
    // The residual M a − f, relative to M a.
    let largest = |values: &[f64]| values.iter().fold(1.0_f64, |largest, value| largest.max(value.abs()));
    let scale = largest(&mass.iter().map(Number::to_f64).collect::<Vec<_>>()) * largest(&accelerations);
    let parts = forces.iter().map(|force| force / scale).collect::<Vec<_>>();
    assert_near(&parts, &[Number::ZERO, Number::ZERO], &what("inverse dynamics"));
    true
}

#[test]
fn even_powers_of_magnitudes_are_polynomials_at_every_state() {
    let count = 2 * ProptestConfig::default().cases;
    let mut random = Random(1);
    let mut regular = 0;
    for _ in 0..count {
        let system = System::random(&mut random);
        if !system.has_inertia() {
            continue;
        }
        let numeric = NumericSystem::new(&derived(&system.text));
        for _ in 0..STATES {
            let point = point(&mut random);
            regular += u32::from(check(&system, &numeric, &point));
        }
    }
    assert!(regular > count, "only {regular} states were regular");
}

fn derived(text: &str) -> Derived {
    let derived = parse(text).and_then(|parsed| parsed.derive(StrategyChoice::Cheapest));
    derived.unwrap_or_else(|report| panic!("{report}{text}"))
}

#[test]
fn magnitudes_squared_are_smooth_where_coordinates_are_small() {
    let squares =
        ["abs({})^2", "norm(({}, 0))^2", "hypot({}, 0)^2", "abs({})*sqrt(({})^2)", "abs(2*{})*abs({})/2"];
    for square in squares {
        let (inertia, stiffness) = (square.replace("{}", "dot(x)"), square.replace("{}", "x"));
        let text = format!(
            "struct Full; coord x, y; kinetic = 1/2*({inertia}) + 1/2*dot(y)^2; potential = 2*({stiffness}) + y;
             reduce Small {{ small x; }}"
        );
        let derived = derived(&text);
        let small = NumericSystem::of_part(&derived.reduced[0]);
        assert_eq!(small.acceleration(0.0, &[0.5, 0.0], &[0.0; 2]), [-2.0, -1.0], "{text}");
    }
}

/// f(|x|) with f′(0) = 0 has the second derivative f″(0) there.
#[test]
fn functions_of_magnitudes_have_their_second_derivative_at_zero() {
    for (function, curvature) in [
        ("cos(abs({}))", -1.0),
        ("cosh(abs({}))", 1.0),
        ("abs({})*sin(abs({}))", 2.0),
        ("pow(abs({}), p)", 2.0),
        ("exp(-abs({})*abs({}))", -2.0),
        ("abs({})^3", 0.0),
        ("abs({})*({})", 0.0),
        ("(1 + abs({}))*exp(-abs({}))", -1.0),
    ] {
        let [kinetic, potential] = ["dot(x)", "x"].map(|u| function.replace("{}", u));
        let inertia = if function.starts_with("(1") { "0" } else { kinetic.as_str() };
        let text = format!(
            "param p = 2; coord x; kinetic = 2*dot(x)^2 + {inertia}; potential = {potential}; emit {{ jacobian }}"
        );
        let numeric = NumericSystem::new(&derived(&text));
        let mass = 4.0 + if inertia == "0" { 0.0 } else { curvature };
        let found = numeric.product(Product::MassMatrix, 0.0, &[0.0], &[0.0]).expect("it is emitted");
        assert_eq!(found, [mass], "{text}");
        let jacobian = numeric.product(Product::Jacobian, 0.0, &[0.0], &[0.0]).expect("it is emitted");
        assert_eq!(jacobian[0], -curvature / mass, "{text}");
    }
}
