use super::{errors, read, shown};
use crate::syntax::ast::{Expression, StatementKind};

/// Formats the text of a single expression.
fn tree(text: &str) -> String {
    let declaration = read(&format!("kinetic = {text};"));
    match declaration.statements[0].kind {
        StatementKind::Kinetic(value) => shown(&declaration.expressions, value),
        _ => panic!("{text} is the value of a kinetic energy"),
    }
}

fn mistake(text: &str) -> String {
    let errors = errors(&format!("kinetic = {text};"));
    assert_eq!(errors.len(), 1, "{text}: {errors:#?}");
    errors[0].split_once(": ").expect("a place and a message").1.to_owned()
}

#[test]
fn operators_bind_as_in_mathematics() {
    assert_eq!(tree("a + b * c ^ d"), "(+ a (* b (^ c d)))");
    assert_eq!(tree("a ^ b * c + d"), "(+ (* (^ a b) c) d)");
    assert_eq!(tree("a - b - c"), "(- (- a b) c)");
    assert_eq!(tree("a / b / c * d"), "(* (/ (/ a b) c) d)");
    assert_eq!(tree("a ^ b ^ c"), "(^ a (^ b c))");
    assert_eq!(tree("1/2 * m"), "(* (/ 1 2) m)");
    assert_eq!(tree("(a + b) * (c)"), "(* (+ a b) c)");
}

#[test]
fn powers_bind_tighter_than_signs() {
    assert_eq!(tree("-x^2"), "(- (^ x 2))");
    assert_eq!(tree("x^-2"), "(^ x (- 2))");
    assert_eq!(tree("x^-2 * y"), "(* (^ x (- 2)) y)");
    assert_eq!(tree("x^-y^-z"), "(^ x (- (^ y (- z))))");
    assert_eq!(tree("-a * b"), "(* (- a) b)");
    assert_eq!(tree("a * -b * c"), "(* (* a (- b)) c)");
    assert_eq!(tree("a - --b"), "(- a (- (- b)))");
}

#[test]
fn calls_and_components_bind_tightest() {
    assert_eq!(tree("-theta.sin()^2"), "(- (^ (sin theta) 2))");
    assert_eq!(tree("x.powi(2).sqrt()"), "(sqrt (powi x 2))");
    assert_eq!(tree("atan2(y, x,).cos()"), "(cos (atan2 y x))");
    assert_eq!(tree("(a, b).x + p.y"), "(+ (.x (vector a b)) (.y p))");
    assert_eq!(tree("f()"), "(f)");
    assert_eq!(tree("((a, b, c))"), "(vector a b c)");
    assert_eq!(tree("inner((a, b), (c, d,))"), "(inner (vector a b) (vector c d))");
}

#[test]
fn conditions_choose_between_expressions() {
    let chain = "if s < l { 0 } else if s <= 2 * l { -a } else { b } * 2";
    assert_eq!(tree(chain), "(* (if (< s l) 0 (if (<= s (* 2 l)) (- a) b)) 2)");
    assert_eq!(tree("if (a > b) { 1 } else { 2 }"), "(if (> a b) 1 2)");
    assert_eq!(tree("if (a) >= (b) { 1 } else { 2 }"), "(if (>= a b) 1 2)");
    assert_eq!(tree("if a<-b { 1 } else { 2 }"), "(if (< a (- b)) 1 2)");
    assert_eq!(tree("1 - if a<=-b { 1 } else { 2 }"), "(- 1 (if (<= a (- b)) 1 2))");
}

#[test]
fn numbers_are_exact() {
    assert_eq!(tree("0.1"), "1/10");
    assert_eq!(tree("2. + 1_000"), "(+ 2 1000)");
    assert_eq!(tree("2.5e-3"), "1/400");
    assert_eq!(tree("1E3"), "1000");
    assert_eq!(tree("1.max(2)"), "(max 1 2)");
    assert_eq!(tree("1.5.max(2)"), "(max 3/2 2)");
}

#[test]
fn literals_of_other_kinds_are_refused() {
    assert_eq!(mistake("1.0f64"), "numbers have no individual types here");
    assert_eq!(mistake("1_f32"), "numbers have no individual types here");
    assert_eq!(mistake("2i"), "letters follow this number directly");
    assert_eq!(mistake("2.5x"), "letters follow this number directly");
    assert_eq!(mistake("0x10"), "numbers are written in decimal");
    assert_eq!(mistake("\"a\""), "quotation marks are not allowed here");
    assert_eq!(mistake("'a'"), "quotation marks are not allowed here");
    assert_eq!(mistake("b'a'"), "`b'a'` is not a number");
    assert!(mistake("1e99999").contains("too extreme"));
    assert!(mistake(&"9".repeat(6000)).contains("too long"));
    assert_eq!(mistake("theta.0"), "components are not numbered");
    assert_eq!(mistake(".5"), "expected an expression, found `.`");
}

#[test]
fn expressions_of_rust_are_refused_in_words() {
    assert_eq!(mistake("a ** 2"), "`**` is not an operator");
    assert_eq!(mistake("&x"), "references are not supported");
    assert_eq!(mistake("f64::sin(x)"), "paths with `::` are not supported");
    assert_eq!(mistake("::sin(x)"), "paths with `::` are not supported");
    assert_eq!(mistake("vec![1]"), "macros cannot be called in expressions");
    assert_eq!(mistake("x as f64"), "`as` is not supported");
    assert_eq!(mistake("(a, b)[kg]"), "square brackets are not allowed here");
    assert_eq!(mistake("[a, b]"), "expected an expression, found `[`");
    assert_eq!(mistake("self.x"), "the keyword `self` has no value");
    assert_eq!(mistake("potential"), "the keyword `potential` has no value");
    assert_eq!(mistake("r#x"), "`r#x` is a raw identifier, which cannot be used as a name here");
    assert_eq!(mistake("x % 2"), "`%` is not an operator");
    assert_eq!(mistake("a < b"), "comparisons are allowed only between `if` and `{`");
    assert_eq!(mistake("a == b"), "comparisons are allowed only between `if` and `{`");
    assert_eq!(mistake("a != b"), "comparisons are allowed only between `if` and `{`");
}

#[test]
fn missing_parts_are_named() {
    assert_eq!(mistake(""), "expected an expression, found `;`");
    assert_eq!(mistake("a + "), "expected an expression, found `;`");
    assert_eq!(mistake("+a"), "`+` has nothing on its left");
    assert_eq!(mistake("2 mass"), "expected an operator or `;`, found `mass`");
    assert_eq!(mistake("2 metres"), "`metres` is not a unit");
    assert_eq!(mistake("2 m/s"), "a unit of several factors needs square brackets after its number");
    assert_eq!(mistake("2(m)"), "expected an operator or `;`, found `(`");
    assert_eq!(mistake("(a b)"), "expected an operator, `,` or `)`, found `b`");
    assert_eq!(mistake("f(a; b)"), "expected an operator, `,` or `)`, found `;`");
    assert_eq!(mistake("f(,)"), "expected an expression, found `,`");
    assert_eq!(mistake("()"), "these parentheses are empty");
    assert_eq!(mistake("(a,)"), "a vector has two or more components, not 1");
    assert_eq!(mistake("(a, , b, c)"), "expected an expression, found `,`");
    assert_eq!(mistake("a..b"), "expected an operator or `;`, found `.`");
}

#[test]
fn mistakes_of_conditions_are_named() {
    assert_eq!(mistake("if a < b { 1 }"), "this `if` has no value when its condition is false");
    assert_eq!(
        mistake("if a < b and c < d { 1 } else { 2 }"),
        "conditions are combined with `&&` and `||`, and are allowed only after `if`"
    );
    assert_eq!(
        mistake("if a < b && c { 1 } else { 2 }"),
        "expected `<`, `<=`, `>`, `>=`, `==` or `!=`, found `{`"
    );
    assert_eq!(
        mistake("if !(a < b && c) { 1 } else { 2 }"),
        "expected an operator, `<`, `<=`, `>`, `>=`, `==` or `!=`, found nothing"
    );
    assert_eq!(mistake("if a = b { 1 } else { 2 }"), "conditions compare with `==`, not `=`");
    assert_eq!(mistake("if a < b < c { 1 } else { 2 }"), "a comparison has two sides");
    assert_eq!(mistake("if a { 1 } else { 2 }"), "expected `<`, `<=`, `>`, `>=`, `==` or `!=`, found `{`");
    assert_eq!(mistake("if a < 2 (1) else { 2 }"), "expected an operator or `{`, found `(`");
    assert_eq!(mistake("if a < b { 1 } else 2"), "expected `{`, found `2`");
    assert_eq!(mistake("if a < b { } else { 2 }"), "these braces are empty");
    assert_eq!(mistake("if a < b { 1; } else { 2 }"), "a block contains exactly one expression");
    assert_eq!(mistake("if a < b { let c = 1; c } else { 2 }"), "a block contains exactly one expression");
    assert_eq!(mistake("if a < b { 1 2 } else { 2 }"), "expected an operator or `}`, found `2`");
}

#[test]
fn mistakes_in_different_brackets_are_all_reported() {
    let found = errors("kinetic = f(a b, c +) * (d e) + if x < (1 +) { g h } else { i, j };");
    assert_eq!(found.len(), 6, "{found:#?}");
}

#[test]
fn origins_reach_from_the_first_to_the_last_token() {
    let declaration = read("kinetic = (a + b) * -c.f(d).x;\nlet e = if a < b { 1 } else { (2, 3) };");
    let found = declaration.expressions.iter().map(|(id, expression)| {
        let origin = declaration.expressions.origin(id);
        let (start, end) = (origin.start.start().column, origin.end.end().column);
        let head = match expression {
            Expression::Name(name) => name.clone(),
            Expression::Number(number) => number.to_string(),
            other => format!("{other:?}").split([' ', '(']).next().expect("a variant").to_owned(),
        };
        format!("{head} {start}..{end}")
    });
    let first = ["a 11..12", "b 15..16", "Binary 11..16", "c 21..22", "d 25..26", "Call 21..27"];
    let second = ["Component 21..29", "Negate 20..29", "Binary 10..29", "a 11..12", "b 15..16", "1 19..20"];
    let third = ["2 31..32", "3 34..35", "Tuple 30..36", "If 8..38"];
    assert_eq!(found.collect::<Vec<_>>(), [&first[..], &second, &third].concat());
}
