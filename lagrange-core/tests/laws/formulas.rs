//! Random expressions in the symbols of one declaration, and their values.

use lagrange_core::elementary::ROWS;
use lagrange_core::expr::evaluate;
use lagrange_core::expr::{ExprId, Graph, Relation};
use lagrange_core::functions::apply;
use lagrange_core::number::Number;
use lagrange_core::symbol::Role;
use proptest::prelude::{Strategy, any, prop};

/// Declares the symbols, for an output to follow.
pub(crate) const DECLARATION: &str =
    "param a, b; input u; coord x, y; kinetic = dot(x)^2 + dot(y)^2; emit { no mass_matrix }";

/// The symbols in order of declaration.
const SYMBOLS: [(&str, Role); 8] = [
    ("a", Role::Parameter(0)),
    ("b", Role::Parameter(1)),
    ("u", Role::Input(0)),
    ("t", Role::Time),
    ("x", Role::Coordinate(0)),
    ("y", Role::Coordinate(1)),
    ("x", Role::Velocity(0)),
    ("y", Role::Velocity(1)),
];

/// A number for each symbol.
pub(crate) type Point = [f64; SYMBOLS.len()];

pub(crate) fn points() -> impl Strategy<Value = Point> {
    [(); SYMBOLS.len()].map(|()| (-200..200).prop_map(|hundredths: i32| f64::from(hundredths) / 100.0))
}

/// The next operation, and the earlier expressions that it takes.
pub(crate) type Step = (u8, u8, u8, i8);

pub(crate) fn steps(most: usize) -> impl Strategy<Value = Vec<Step>> {
    prop::collection::vec(any::<Step>(), 1..most)
}

/// Returns the symbols and a few numbers.
pub(crate) fn leaves(graph: &mut Graph) -> Vec<ExprId> {
    let mut leaves = SYMBOLS.map(|(name, role)| graph.symbol(name, role)).to_vec();
    leaves.push(graph.pi());
    leaves.extend([Number::from(2), Number::from(-3)].map(|number| graph.number(number)));
    leaves.extend(["0.75", "9.81"].map(|text| graph.number(Number::parse_decimal(text).expect("a literal"))));
    leaves
}

/// Returns the leaves and the results of the steps, in order of construction.
pub(crate) fn build(graph: &mut Graph, steps: &[Step]) -> Vec<ExprId> {
    let leaves = leaves(graph);
    let mut made = leaves.clone();
    for &(kind, i, j, n) in steps {
        // One operand is mostly recent, so that expressions become deep.
        let a = made[made.len() - 1 - usize::from(i) % made.len().min(4)];
        let b = made[usize::from(j) % made.len()];
        let n = i64::from(n % 5);
        let new = match kind % 9 {
            0 => graph.sum(Number::from(n), [(a, Number::ONE), (b, Number::MINUS_ONE)]),
            1 => graph.sum(Number::ZERO, [(a, Number::from(n)), (b, Number::from(3))]),
            2 | 3 => graph.multiply(a, b),
            4 => graph.divide(b, a),
            5 => graph.power(a, Number::ratio(n, 2).expect("no zero")),
            6 => graph.choose(Relation::LessEqual, a, b, leaves[4], b),
            7 => graph.subtract(leaves[usize::from(j) % leaves.len()], a),
            _ => {
                let row = &ROWS[usize::from(j) % ROWS.len()];
                apply(graph, row.function, &[a, b][..row.arity])
            }
        };
        made.push(new);
    }
    made
}

/// Returns the value at a point.
pub(crate) fn value(graph: &Graph, expression: ExprId, point: &Point) -> f64 {
    evaluate(graph, &[expression], |role| coordinate(point, role))[0]
}

/// Returns the largest magnitude of any part of the expression.
pub(crate) fn largest_part(graph: &Graph, expression: ExprId, point: &Point) -> f64 {
    let parts = evaluate(graph, &graph.reachable(&[expression]), |role| coordinate(point, role));
    parts.into_iter().fold(0.0, |largest, part| part.abs().max(largest))
}

/// True if any part of the expression is undefined at a point where nothing vanishes by chance.
pub(crate) fn has_undefined_part(graph: &Graph, expression: ExprId) -> bool {
    const GENERIC: Point =
        [0.314_159, 0.271_828, -0.577_216, 0.493_147, 0.141_421, -0.173_205, 0.618_034, 0.915_966];
    let parts = evaluate(graph, &graph.reachable(&[expression]), |role| coordinate(&GENERIC, role));
    parts.iter().any(|part| !part.is_finite())
}

fn coordinate(point: &Point, role: Role) -> f64 {
    let position = SYMBOLS.iter().position(|(_, known)| *known == role);
    position.map_or(f64::NAN, |position| point[position])
}

/// Returns the largest difference that rounding alone may cause between two values. It is measured
/// between values at points that differ by slightly more than rounding. It is infinite where the
/// expression has no value or is about to switch.
pub(crate) fn leeway(graph: &Graph, expression: ExprId, point: &Point) -> f64 {
    let centre = value(graph, expression, point);
    let spread = (0..6).map(|shift| {
        let shifted = std::array::from_fn(|i| {
            let direction = f64::from(u8::from((i >> (shift % 3)) % 2 == shift / 3)) - 0.5;
            point[i] + 1e-12 * direction * (1.0 + point[i].abs())
        });
        (value(graph, expression, &shifted) - centre).abs()
    });
    let spread =
        spread.fold(0.0, |most: f64, next| if next.is_nan() { f64::INFINITY } else { most.max(next) });
    // A maximum with NaN would be the other number.
    if centre.is_nan() { f64::INFINITY } else { 1e3 * spread + 1e-9 * (1.0 + centre.abs()) }
}
