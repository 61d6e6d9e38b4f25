use proptest::prelude::{Just, Strategy, any, prop, prop_assert_eq, prop_oneof, proptest};
use proptest::sample::Index;

use super::systems::systems;
use super::{read, statements};
use crate::syntax::ast::{AstId, Declaration, Expression, StatementKind};
use crate::syntax::{parse_text, print};
use lagrange_expr::number::Number;

/// Returns the printed expression of a single statement.
fn printed(text: &str) -> String {
    let printed = print::statements(&read(&format!("let a = {text};")));
    let value = printed.strip_prefix("let a = ").and_then(|rest| rest.strip_suffix(";\n"));
    value.expect("one statement on one line").to_owned()
}

#[test]
fn statements_are_printed_as_they_are_usually_written() {
    let text = "\
param a, b = 1, c;
param d > 0 = 1, e in 0..=1 = 1/2, f in 0..1, g in ..2 * pi, h in ..=0, i in 0.. = 3, j > 0 <= 1, k > -1 < 1;
input u, w = -2;
noise gust, density: 2 * c;
const k = 1/2, pi2 = 2 * pi;
coord x, theta = 0.1;
start dot(x) = a, theta = 2;
let n = a + b;
let (p, q, r) = (a, b, c);
kinetic = 1/2 * m * dot(x)^2;
potential = -m * g * l * cos(theta);
lagrangian = x;
gibbs = 1/2 * m * ddot(x)^2, for: a - b;
dissipation = 0.1 * x;
force x = -k * x;
force (u, w) at (p, q);
torque -m on theta - x;
constraint ring = p^2 + q^2 - l^2;
stabilise = 10;
event floor = y - b, falling => impact(1/2);
event wall = x, rising => stop;
event tick = sin(t), crossing => record;
event kick = x - a, crossing => { dot(x) = -k * dot(x); y = a; }
event push = x, falling => { let r = 2 * x; x = r; let (u, v) = (r, x); y = u; for i in 0..2 { let w = v; z[i] = w; } dot(y) = v; }
every 1 => { if 1 < 2 { let r = x; y = r; } x = 1; }
friction brake = dot(x) - w, mu * floor;
friction shoe = dot(x), kinetic: mu, static: if x < 0 { a } else if x > 1 { b } else { c };
friction slow = dot(x), mu, smooth: a;
output tip = (p, q);
emit { jacobian, no energy }
reduce Near { freeze x = 0, y = a; small theta, phi = pi/2; freeze z = 1; ignore s, w; }
reduce Far { let r = 2; freeze x = r; small y = r; }
gravity = (0, -g);
body rod { mass: m; inertia: slender_rod(m, l); center: (x, y); centroid: (l/2, 0); angle: a; shape: disk(r); }
body wheel { origin: (x, y); compound { disk(r), mass: m; hole point_mass(), mass: n, at: (a, b), angle: e; } }
line floor { on: rod; through: (0, 0); angle: e; }
spring { from: p; to: q; stiffness: k; rest: l; }
torsion_damper brake { from: ground; to: rod; damping: c; }
pin hinge = point(rod, 0, 0) to (0, 0);
slide q on floor;
roll wheel on floor, radius: r;
";
    assert_eq!(print::statements(&read(text)), text);
}

#[test]
fn parentheses_stand_only_where_operators_need_them() {
    let same = [
        "a - (b - c)",
        "a - b - c",
        "a * (b + c)",
        "a / (b * c)",
        "a * b / c",
        "a/b",
        "1/2 * m",
        "a / b^2",
        "-a * b",
        "-(a * b)",
        "-(a + b)",
        "a - -b",
        "-a^2",
        "(-a)^2",
        "a^b^c",
        "(a^b)^c",
        "a^-b",
        "(a + b)^(c - d)",
        "(a * b).x",
        "a.x.y",
        "(2).x",
        "f((a, b), c)",
        "f()",
        "(a + b, c, -d)",
        "if a < b + c { d } else { e }",
        "if a >= b { c } else if b <= c { d } else { e + f }",
        "2 * (if a < b { c } else { d }) + e",
        "1e-9 * a",
        "norm(v in arm)",
    ];
    for text in same {
        assert_eq!(printed(text), text);
    }
    let shorter = [
        ("(a) + ((b * c))", "a + b * c"),
        ("(a - b) - c", "a - b - c"),
        ("a^(b^c)", "a^b^c"),
        ("a^(-b)", "a^-b"),
        ("a * (-b)", "a * -b"),
        ("(a * b) / c", "a * b / c"),
        ("x.max(y)", "max(x, y)"),
        ("1.50", "1.5"),
        (
            "if (a < b) { c } else { (if d < e { f } else { g }) }",
            "if a < b { c } else if d < e { f } else { g }",
        ),
    ];
    for (text, short) in shorter {
        assert_eq!(printed(text), short);
    }
}

#[test]
fn every_system_is_printed_as_what_it_says() {
    for (name, text) in systems() {
        let declaration = read(&text);
        let printed = print::statements(&declaration);
        let again = read(&printed);
        assert_eq!(statements(&again), statements(&declaration), "{name}");
        assert_eq!(print::statements(&again), printed, "{name}");
    }
}

#[test]
fn long_chains_are_printed() {
    for link in [" + x", " * x", "^x", "^-x", ".y"] {
        let text = format!("let a = x{};\n", link.repeat(50_000));
        assert_eq!(print::statements(&read(&text)), text);
    }
}

/// One step in constructing an expression: its kind, its operands, and a number.
type Step = (u8, [Index; 4], i8);

/// Adds an expression that contains others.
fn grow(declaration: &mut Declaration, ids: &mut Vec<AstId>, names: [AstId; 2], step: &Step) {
    let (kind, operands, number) = step;
    let [a, b, c, d] = operands.map(|index| ids[index.index(ids.len())]);
    // Copies from readable statements avoid constructing spans and names.
    let of = |text: &str| read(text).expressions.iter().last().map(|(_, expression)| expression.clone());
    let origin = declaration.expressions.origin(names[0]);
    let expression = match (kind % 10, of("let a = f(a + b, b);")) {
        (0, _) => Expression::Negate(a),
        (1, Some(Expression::Call(function, _))) => Expression::Call(function, vec![a, b]),
        (2, Some(Expression::Call(function, _))) => Expression::Component(a, function),
        (3, _) => Expression::Tuple(vec![a, b]),
        (4, _) => Expression::Number(Number::from(i64::from(number.unsigned_abs()))),
        (operator, _) => {
            let text = ["a + b", "a - b", "a * b", "a / b", "a^b"][usize::from(operator) - 5];
            match of(&format!("let a = {text};")) {
                Some(Expression::Binary(operator, span, ..)) => Expression::Binary(operator, span, a, b),
                _ => Expression::Negate(c),
            }
        }
    };
    let choice = match of("let a = if a < b { a } else { b };") {
        Some(Expression::If { condition, .. }) if *number == 0 => {
            let condition = crate::syntax::ast::Condition { left: a, right: b, ..condition };
            Some(Expression::If { condition, then: c, otherwise: d })
        }
        _ => None,
    };
    ids.push(declaration.expressions.add(choice.unwrap_or(expression), origin));
}

fn steps() -> impl Strategy<Value = Vec<Step>> {
    let number = prop_oneof![Just(0), any::<i8>()];
    prop::collection::vec((any::<u8>(), any::<[Index; 4]>(), number), 1..14)
}

proptest! {
    #[test]
    fn any_expression_is_read_as_it_was_printed(steps in steps()) {
        let mut declaration = read("let a = x; let b = y;");
        let names = [0, 1].map(|i| declaration.expressions.iter().nth(i).expect("two names").0);
        let mut ids = names.to_vec();
        steps.iter().for_each(|step| grow(&mut declaration, &mut ids, names, step));
        if let StatementKind::Let(_, value) = &mut declaration.statements[0].kind {
            *value = ids[ids.len() - 1];
        }
        let printed = print::statements(&declaration);
        let again = read(&printed);
        prop_assert_eq!(statements(&again), statements(&declaration));
        prop_assert_eq!(print::statements(&again), printed);
    }
}

#[test]
fn unreadable_expressions_are_not_printed_as_others() {
    let mut report = lagrange_expr::diagnostics::Report::default();
    let declaration = parse_text("let a = 1 +;", &mut report).expect("tokens");
    assert_eq!(print::statements(&declaration), "let a = ?;\n");
}
