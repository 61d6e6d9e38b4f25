mod double_pendulum;
mod large;
mod writers;

use lagrange_expr::elementary::by_name;
use lagrange_expr::expr::{ExprId, Graph, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

const SYMBOLS: [(&str, Role); 12] = [
    ("m1", Role::Parameter(0)),
    ("m2", Role::Parameter(1)),
    ("l", Role::Parameter(2)),
    ("g", Role::Parameter(3)),
    ("k_s", Role::Parameter(4)),
    ("u", Role::Input(0)),
    ("t", Role::Time),
    ("x", Role::Coordinate(0)),
    ("theta", Role::Coordinate(1)),
    ("x'", Role::Velocity(0)),
    ("theta'", Role::Velocity(1)),
    ("theta''", Role::Acceleration(1)),
];

/// Builds an expression from reverse Polish notation; `x'` is the rate of `x`.
fn polish(g: &mut Graph, formula: &str) -> ExprId {
    let mut stack = Vec::new();
    for word in formula.split(' ') {
        if let Some((_, role)) = SYMBOLS.iter().find(|(name, _)| *name == word) {
            stack.push(g.symbol(word.trim_end_matches('\''), *role));
        } else if let Some(number) = Number::parse_decimal(word) {
            stack.push(g.number(number));
        } else if let Some(row) = by_name(word) {
            let arguments = stack.split_off(stack.len() - row.arity);
            stack.push(apply(g, row.function, &arguments));
        } else {
            operate(g, &mut stack, word);
        }
    }
    stack.pop().expect("a formula")
}

fn operate(g: &mut Graph, stack: &mut Vec<ExprId>, operator: &str) {
    let mut pop = || stack.pop().expect("enough operands");
    let new = match operator {
        "pi" => g.pi(),
        "neg" => {
            let a = pop();
            g.negate(a)
        }
        "if<" | "if<=" => {
            let relation = if operator == "if<" { Relation::Less } else { Relation::LessEqual };
            let [otherwise, then, right, left] = [pop(), pop(), pop(), pop()];
            g.choose(relation, left, right, then, otherwise)
        }
        _ => {
            let [b, a] = [pop(), pop()];
            match operator {
                "+" => g.add(a, b),
                "-" => g.subtract(a, b),
                "*" => g.multiply(a, b),
                "/" => g.divide(a, b),
                "^" => {
                    let exponent = g.as_number(b).expect("a numeric exponent").clone();
                    g.power(a, exponent)
                }
                other => panic!("no operator {other}"),
            }
        }
    };
    stack.push(new);
}

/// Declares every symbol in order.
fn declare(g: &mut Graph) {
    for (name, role) in SYMBOLS {
        g.symbol(name.trim_end_matches('\''), role);
    }
}
