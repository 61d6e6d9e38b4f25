use super::polish;
use crate::formula::{latex, text};
use lagrange_expr::expr::Graph;

/// A formula in reverse Polish notation, its text and its LaTeX.
const FORMULAS: [(&str, &str, &str); 45] = [
    ("0", "0", "0"),
    ("7 neg", "-7", "-7"),
    ("1 2 /", "1/2", r"\frac{1}{2}"),
    ("9.81 m1 *", "9.81*m1", "9.81 m_{1}"),
    ("1e9 m1 *", "1e9*m1", r"10^{9} m_{1}"),
    ("pi 2 *", "2*pi", r"2 \pi"),
    ("theta' l l m1 * * *", "m1*l^2*dot(theta)", r"m_{1} l^{2} \dot{\theta}"),
    ("theta'' l *", "l*ddot(theta)", r"l \ddot{\theta}"),
    ("theta' 2 ^ m1 * 1 2 / *", "1/2*m1*dot(theta)^2", r"\frac{1}{2} m_{1} \dot{\theta}^{2}"),
    ("x l -", "x - l", "x - l"),
    ("l x -", "l - x", "l - x"),
    ("x l - neg", "l - x", "l - x"),
    ("x neg l -", "-l - x", "-l - x"),
    ("1 x 2 ^ -", "1 - x^2", "1 - x^{2}"),
    ("x 1 +", "x + 1", "x + 1"),
    ("m1 x l + + g -", "m1 + l - g + x", "m_{1} + l - g + x"),
    ("x theta + 3 *", "3*(x + theta)", r"3 \left(x + \theta\right)"),
    ("x l - k_s * neg", "k_s*(l - x)", r"k_{s} \left(l - x\right)"),
    ("m1 m2 + l 2 ^ *", "(m1 + m2)*l^2", r"\left(m_{1} + m_{2}\right) l^{2}"),
    ("theta sin l * x +", "x + l*sin(theta)", r"x + l \sin\left(\theta\right)"),
    ("theta sin 2 ^", "sin(theta)^2", r"\sin^{2}\left(\theta\right)"),
    ("x theta + 2 ^", "(x + theta)^2", r"\left(x + \theta\right)^{2}"),
    ("m1 l *", "m1*l", "m_{1} l"),
    ("m1 l * 3 ^", "m1^3*l^3", "m_{1}^{3} l^{3}"),
    ("1 x /", "1/x", r"\frac{1}{x}"),
    ("m1 x 2 ^ / neg", "-m1/x^2", r"-\frac{m_{1}}{x^{2}}"),
    ("m1 l x * /", "m1/(l*x)", r"\frac{m_{1}}{l x}"),
    ("m1 2 / x /", "m1/(2*x)", r"\frac{m_{1}}{2 x}"),
    ("m1 x l + /", "m1/(l + x)", r"\frac{m_{1}}{l + x}"),
    ("m1 x l + 2 ^ /", "m1/(l + x)^2", r"\frac{m_{1}}{\left(l + x\right)^{2}}"),
    ("x sqrt", "sqrt(x)", r"\sqrt{x}"),
    ("1 x sqrt /", "1/sqrt(x)", r"\frac{1}{\sqrt{x}}"),
    ("x 1.5 ^", "x^(3/2)", "x^{3/2}"),
    ("m1 l + x 2.5 ^ /", "(m1 + l)/x^(5/2)", r"\frac{m_{1} + l}{x^{5/2}}"),
    ("x 2 ^ sqrt", "abs(x)", r"\left|x\right|"),
    ("2 sqrt x *", "sqrt(2)*x", r"\sqrt{2} x"),
    ("x 1.25 sqrt / 2 ^", "x^2/(5/4)", r"\frac{x^{2}}{\frac{5}{4}}"),
    ("x theta pow", "pow(x, theta)", r"{x}^{\theta}"),
    ("x l + theta 1 + pow", "pow(l + x, theta + 1)", r"{\left(l + x\right)}^{\theta + 1}"),
    ("x theta atan2", "atan2(x, theta)", r"\operatorname{atan2}\left(x, \theta\right)"),
    ("x neg exp u *", "u*exp(-x)", r"u \exp\left(-x\right)"),
    ("x l - abs 3 ^ t *", "t*abs(l - x)^3", r"t \left|l - x\right|^{3}"),
    (
        "x 0 l g if<",
        "if x < 0 { l } else { g }",
        r"\begin{cases} l & \text{if } x < 0 \\ g & \text{otherwise} \end{cases}",
    ),
    (
        "x 0 l x 1 g m1 neg if<= if<",
        "if x < 0 { l } else if x <= 1 { g } else { -m1 }",
        r"\begin{cases} l & \text{if } x < 0 \\ g & \text{if } x \le 1 \\ -m_{1} & \text{otherwise} \end{cases}",
    ),
    (
        "x 0 l g if< 2 * 1 +",
        "2*(if x < 0 { l } else { g }) + 1",
        r"2 \left(\begin{cases} l & \text{if } x < 0 \\ g & \text{otherwise} \end{cases}\right) + 1",
    ),
];

#[test]
fn formulas_are_written_as_people_write_them() {
    let mut wrong = Vec::new();
    for (formula, expected, expected_latex) in FORMULAS {
        let mut g = Graph::new();
        // Declares every symbol in order, whatever the order in the formula.
        super::declare(&mut g);
        let expr = polish(&mut g, formula);
        let found = (text::text(&g, expr), latex::latex(&g, expr));
        if found != (expected.to_owned(), expected_latex.to_owned()) {
            wrong.push((formula, found));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn parts_with_names_are_not_opened() {
    let mut g = Graph::new();
    let sum = polish(&mut g, "m1 m2 +");
    let whole = polish(&mut g, "m1 m2 + l + m1 m2 + x * +");
    let names = |id| (id == sum).then_some("total");
    assert_eq!(text::write(&g, whole, &names), "l + total + total*x");
    assert_eq!(text::write(&g, sum, &names), "m1 + m2", "a definition is written out");
}
