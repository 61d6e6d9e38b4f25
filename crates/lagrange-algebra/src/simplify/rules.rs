//! The identities, as data.
//!
//! Each rule turns two terms of a sum with the same cofactor into one. Source of the formulas:
//! Abramowitz and Stegun, *Handbook of Mathematical Functions*, §4.3 (circular) and §4.5
//! (hyperbolic).

use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;

/// Relation between the arguments of the two calls in one side of a rule.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RuleArguments {
    /// The arguments are the same expression.
    Same,
    /// The arguments are different expressions.
    Distinct,
}

/// `a · left₀(x) · left₁(y) + sign · a · right₀(x) · right₁(y) → a · result(x, y)`
#[derive(Debug)]
pub struct Rule {
    /// The name.
    pub name: &'static str,
    /// Formula of the rule.
    pub algebra: &'static str,
    /// Domain where it holds.
    pub domain: &'static str,
    /// Measure that decreases with each application, so that application terminates.
    pub measure: &'static str,
    /// The functions of the first term.
    pub left: [Function; 2],
    /// The functions of the second term.
    pub right: [Function; 2],
    /// True if the second term is subtracted.
    pub subtracts: bool,
    /// Relation between x and y.
    pub arguments: RuleArguments,
    /// Expression that replaces the two terms.
    pub result: fn(&mut Graph, ExprId, ExprId) -> ExprId,
}

const FEWER_TERMS: &str = "the number of terms falls by one";
const EVERYWHERE: &str = "everywhere";

/// Every rule; those that need a single argument come first.
pub const RULES: [Rule; 6] = [
    Rule {
        name: "circle",
        algebra: "a·cos²x + a·sin²x → a",
        domain: EVERYWHERE,
        measure: FEWER_TERMS,
        left: [Function::Cos, Function::Cos],
        right: [Function::Sin, Function::Sin],
        subtracts: false,
        arguments: RuleArguments::Same,
        result: |graph, _, _| graph.number(1),
    },
    Rule {
        name: "hyperbola",
        algebra: "a·cosh²x - a·sinh²x → a",
        domain: EVERYWHERE,
        measure: FEWER_TERMS,
        left: [Function::Cosh, Function::Cosh],
        right: [Function::Sinh, Function::Sinh],
        subtracts: true,
        arguments: RuleArguments::Same,
        result: |graph, _, _| graph.number(1),
    },
    Rule {
        name: "cosine of a difference",
        algebra: "a·cos x·cos y + a·sin x·sin y → a·cos(x - y)",
        domain: EVERYWHERE,
        measure: FEWER_TERMS,
        left: [Function::Cos, Function::Cos],
        right: [Function::Sin, Function::Sin],
        subtracts: false,
        arguments: RuleArguments::Distinct,
        result: |graph, x, y| of_sum(graph, Function::Cos, x, y, Number::MINUS_ONE),
    },
    Rule {
        name: "cosine of a sum",
        algebra: "a·cos x·cos y - a·sin x·sin y → a·cos(x + y)",
        domain: EVERYWHERE,
        measure: FEWER_TERMS,
        left: [Function::Cos, Function::Cos],
        right: [Function::Sin, Function::Sin],
        subtracts: true,
        arguments: RuleArguments::Distinct,
        result: |graph, x, y| of_sum(graph, Function::Cos, x, y, Number::ONE),
    },
    Rule {
        name: "sine of a difference",
        algebra: "a·sin x·cos y - a·cos x·sin y → a·sin(x - y)",
        domain: EVERYWHERE,
        measure: FEWER_TERMS,
        left: [Function::Sin, Function::Cos],
        right: [Function::Cos, Function::Sin],
        subtracts: true,
        arguments: RuleArguments::Distinct,
        result: |graph, x, y| of_sum(graph, Function::Sin, x, y, Number::MINUS_ONE),
    },
    Rule {
        name: "sine of a sum",
        algebra: "a·sin x·cos y + a·cos x·sin y → a·sin(x + y)",
        domain: EVERYWHERE,
        measure: FEWER_TERMS,
        left: [Function::Sin, Function::Cos],
        right: [Function::Cos, Function::Sin],
        subtracts: false,
        arguments: RuleArguments::Distinct,
        result: |graph, x, y| of_sum(graph, Function::Sin, x, y, Number::ONE),
    },
];

/// Returns the rules that remove squares without introducing functions.
pub(super) fn squares() -> &'static [Rule] {
    const SQUARES: &[Rule] = RULES.split_at(2).0;
    SQUARES
}

/// Returns `function(x + sign·y)`, with sums expanded so that equal parts of the arguments are
/// combined.
fn of_sum(graph: &mut Graph, function: Function, x: ExprId, y: ExprId, sign: Number) -> ExprId {
    let mut constant = Number::ZERO;
    let mut terms = Vec::new();
    for (argument, sign) in [(x, Number::ONE), (y, sign)] {
        let (inner, core) = graph.split_coefficient(argument);
        let scale = &inner * &sign;
        match graph.node(core) {
            Node::Sum { constant: shift, terms: inner } => {
                constant = &constant + &(shift * &scale);
                terms.extend(inner.iter().map(|(term, c)| (*term, c * &scale)));
            }
            _ => terms.push((core, scale)),
        }
    }
    let argument = graph.sum(constant, terms);
    apply(graph, function, &[argument])
}
