//! A formula is dimensionally correct if and only if it scales with the base units. Inferred
//! dimensions are compared with numbers.
//!
//! The reference knows nothing about dimensions of expressions. It evaluates a tree whose leaves
//! have values of their own, once more with base units that are smaller by some factors. A correct
//! formula is multiplied by a product of powers of these factors.

use lagrange_core::diagnostics::Report;
use lagrange_core::pipeline::parse;
use lagrange_core::syntax::ast::StatementKind;
use lagrange_core::syntax::parse_text;
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};

const TREES: usize = 1000;
/// Base units in use: m, s and kg.
const BASES: usize = 3;
/// Names with their exponents of the base units.
const NAMES: [(&str, &str, [f64; BASES]); 6] = [
    ("a", "m", [1.0, 0.0, 0.0]),
    ("b", "s", [0.0, 1.0, 0.0]),
    ("c", "N", [1.0, -2.0, 1.0]),
    ("d", "m/s", [1.0, -1.0, 0.0]),
    ("e", "1", [0.0; BASES]),
    ("f", "m^(1/2)", [0.5, 0.0, 0.0]),
];
/// Largest exponent of m and s, in halves, for a name whose dimension is unknown.
const LARGEST_HALVES: i32 = 4;

/// A formula. Every leaf has its own value, so that nothing cancels.
#[derive(Clone)]
enum Tree {
    Name(usize),
    /// The name with an undeclared dimension.
    Unknown,
    Number(u32),
    Sum(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    Quotient(Box<Tree>, Box<Tree>),
    /// A power whose exponent counts halves.
    Power(Box<Tree>, i32),
    Exponential(Box<Tree>, Box<Tree>),
    Sine(Box<Tree>),
    Hypotenuse(Box<Tree>, Box<Tree>),
    Angle(Box<Tree>, Box<Tree>),
}

struct Random(TestRng);

impl Random {
    fn below(&mut self, n: u32) -> u32 {
        self.0.next_u32() % n
    }
}

fn tree(random: &mut Random, depth: u32) -> Tree {
    if depth == 0 || random.below(8) == 0 {
        return match random.below(9) {
            0 => Tree::Number(2 + random.below(3)),
            1 => Tree::Unknown,
            name => Tree::Name(name as usize % NAMES.len()),
        };
    }
    let kind = random.below(12);
    let first = Box::new(tree(random, depth - 1));
    // Half of the sums are correct by construction.
    let alike = if random.below(2) == 0 { first.clone() } else { Box::new(tree(random, depth - 1)) };
    let second = Box::new(tree(random, depth - 1));
    match kind {
        0..=2 => Tree::Sum(first, alike),
        3 | 4 => Tree::Product(first, second),
        5 | 6 => Tree::Quotient(first, second),
        7 => Tree::Power(first, [-4, -2, 1, 3, 4][random.below(5) as usize]),
        8 => Tree::Sine(Box::new(Tree::Quotient(first, alike))),
        9 => Tree::Hypotenuse(first, alike),
        10 => Tree::Angle(first, alike),
        _ => Tree::Exponential(first, second),
    }
}

impl Tree {
    fn text(&self) -> String {
        match self {
            Tree::Name(name) => NAMES[*name].0.to_owned(),
            Tree::Unknown => "u".to_owned(),
            Tree::Number(number) => number.to_string(),
            Tree::Sum(x, y) => format!("({} + {})", x.text(), y.text()),
            Tree::Product(x, y) => format!("({} * {})", x.text(), y.text()),
            Tree::Quotient(x, y) => format!("({} / {})", x.text(), y.text()),
            Tree::Power(x, halves) => format!("({})^({halves}/2)", x.text()),
            Tree::Exponential(x, y) => format!("({})^(e + {})", x.text(), y.text()),
            Tree::Sine(x) => format!("sin({})", x.text()),
            Tree::Hypotenuse(x, y) => format!("hypot({}, {})", x.text(), y.text()),
            Tree::Angle(x, y) => format!("atan2({}, {})", x.text(), y.text()),
        }
    }

    /// Returns the value where `leaf` gives the value of each leaf in its order.
    fn value(&self, leaf: &mut impl FnMut(Option<usize>) -> f64) -> f64 {
        match self {
            Tree::Name(name) => leaf(Some(*name)),
            Tree::Unknown => leaf(None),
            Tree::Number(number) => f64::from(*number),
            Tree::Sum(x, y) => x.value(leaf) + y.value(leaf),
            Tree::Product(x, y) => x.value(leaf) * y.value(leaf),
            Tree::Quotient(x, y) => x.value(leaf) / y.value(leaf),
            Tree::Power(x, halves) => x.value(leaf).powf(f64::from(*halves) / 2.0),
            Tree::Exponential(x, y) => {
                let base = x.value(leaf);
                let plain = leaf(Some(4));
                base.powf(plain + y.value(leaf))
            }
            Tree::Sine(x) => 2.0 + x.value(leaf).sin(),
            Tree::Hypotenuse(x, y) => x.value(leaf).hypot(y.value(leaf)),
            Tree::Angle(x, y) => x.value(leaf).atan2(y.value(leaf)),
        }
    }

    fn has_unknown(&self) -> bool {
        match self {
            Tree::Unknown => true,
            Tree::Name(_) | Tree::Number(_) => false,
            Tree::Power(x, _) | Tree::Sine(x) => x.has_unknown(),
            Tree::Sum(x, y)
            | Tree::Product(x, y)
            | Tree::Quotient(x, y)
            | Tree::Exponential(x, y)
            | Tree::Hypotenuse(x, y)
            | Tree::Angle(x, y) => x.has_unknown() || y.has_unknown(),
        }
    }

    /// Returns the factor of the value if base units are smaller by these factors. The seed
    /// determines the values of leaves.
    fn ratio(&self, seed: f64, unknown: &[f64; BASES], factors: &[f64; BASES]) -> f64 {
        let at = |factors: &[f64; BASES]| {
            let mut leaves = 0.0;
            self.value(&mut |name| {
                leaves += seed;
                let exponents = name.map_or(unknown, |name| &NAMES[name].2);
                let scale = exponents.iter().zip(factors).map(|(exponent, factor)| factor.powf(*exponent));
                (0.7 + 0.7 * f64::fract(leaves)) * scale.product::<f64>()
            })
        };
        at(factors) / at(&[1.0; BASES])
    }

    /// True if the formula scales when the unknown name has these exponents. `None` where numbers
    /// overflow.
    fn scales(&self, unknown: &[f64; BASES]) -> Option<bool> {
        let (p, q) = ([1.31, 0.83, 1.17], [0.91, 1.23, 1.09]);
        let both = [p[0] * q[0], p[1] * q[1], p[2] * q[2]];
        let [one, other] = [0.618_034, 0.414_214].map(|seed| self.ratio(seed, unknown, &p));
        if (one / other - 1.0).abs() > 1e-9 {
            return Some(false);
        }
        let (product, quotient) = (self.ratio(0.618_034, unknown, &both), self.ratio(0.618_034, unknown, &q));
        let is_known = [one, other, product, quotient].iter().all(|ratio| ratio.is_finite() && *ratio != 0.0);
        is_known.then(|| (product / (one * quotient) - 1.0).abs() < 1e-9)
    }

    /// True if the formula scales for no exponents of the unknown name within the range tried.
    fn cannot_scale(&self) -> Option<bool> {
        if !self.has_unknown() {
            return self.scales(&[0.0; BASES]).map(|scales| !scales);
        }
        let halves = || (-LARGEST_HALVES..=LARGEST_HALVES).map(|halves| f64::from(halves) / 2.0);
        let mut is_known = false;
        for length in halves() {
            for time in halves() {
                for mass in [-1.0, 0.0, 1.0] {
                    match self.scales(&[length, time, mass]) {
                        Some(true) => return Some(false),
                        Some(false) => is_known = true,
                        None => {}
                    }
                }
            }
        }
        is_known.then_some(true)
    }
}

/// The result of checking a formula.
enum Found {
    /// Correct, with the inferred exponents of the name without a unit.
    Right([f64; BASES]),
    Wrong,
}

/// Returns the result of the dimension check, or `None` if something else is wrong.
fn found(tree: &Tree) -> Option<Found> {
    let names = NAMES.map(|(name, unit, _)| format!("{name}: {unit}")).join(", ");
    let text = format!(
        "param {names}, u; coord x: m; kinetic = kinetic_energy(1 kg, dot(x)); output y = 1 [K] * {};",
        tree.text()
    );
    match parse(&text) {
        Ok(system) => {
            let unit = system.model.units.get("u").map_or("1".to_owned(), |unit| unit.unit.clone());
            Some(Found::Right(exponents(&unit)))
        }
        Err(report) => {
            let text = report.to_string();
            let is_of_units = text.contains(", but ") || text.contains("the units do not match");
            is_of_units.then_some(Found::Wrong)
        }
    }
}

/// Returns the exponents of m, s and kg of a unit.
fn exponents(unit: &str) -> [f64; BASES] {
    let mut report = Report::default();
    let declaration = parse_text(&format!("param u: {unit};"), &mut report).expect("a unit");
    let StatementKind::Parameters(list) = &declaration.statements[0].kind else { panic!("a parameter") };
    let unit = list[0].name.unit.as_ref().expect("a unit");
    [1, 2, 0].map(|base: usize| unit.dimension.exponents()[base].to_f64())
}

#[test]
fn formulas_are_right_if_they_scale() {
    let mut random = Random(TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]));
    let (mut accepted, mut rejected, mut with_unknown) = (0, 0, 0);
    let mut wrong = Vec::new();
    while accepted + rejected < TREES {
        let tree = tree(&mut random, 4);
        let Some(found) = found(&tree) else { continue };
        let is_confirmed = match &found {
            Found::Right(unknown) => tree.scales(unknown),
            Found::Wrong => tree.cannot_scale(),
        };
        let Some(is_confirmed) = is_confirmed else { continue };
        let is_right = matches!(found, Found::Right(_));
        if !is_confirmed {
            wrong.push(format!("{} is {}", tree.text(), if is_right { "accepted" } else { "rejected" }));
        }
        accepted += usize::from(is_right);
        rejected += usize::from(!is_right);
        with_unknown += usize::from(is_right && tree.has_unknown());
    }
    assert!(wrong.is_empty(), "{} of {TREES}:\n{}", wrong.len(), wrong.join("\n"));
    let counts = [accepted, rejected, with_unknown];
    assert!(accepted > TREES / 4 && rejected > TREES / 4 && with_unknown > TREES / 20, "{counts:?}");
}
