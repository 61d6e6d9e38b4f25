use super::{errors, read};
use crate::syntax::print;

#[test]
fn units_are_printed_as_they_are_usually_written() {
    let text = "\
param m: kg = 1, l: mm = 500, k: N/m, c: 1/s;
input u: N*m/rad = 2;
const g: m/s^2 = 9.81, r: m^(1/2) = 1, n: 1 = 3;
coord x: m, theta: rad, q;
velocity w: rad/s = dot(theta);
let v: m/s = dot(x);
let (a: m, b: kg*m/(s*K)) = (x, y);
function lift(alpha: rad, v: m/s): 1;
function drag(v: m/s): N { by v: slope; }
table drive(speed: rpm): N*m = [(0 [rpm], 5)], interpolation: linear, outside: error;
output tip: m = x + 30 [deg] * 9.81 [m/s^2]^2 - 2 [mm];
";
    assert_eq!(print::statements(&read(text)), text);
}

#[test]
fn units_are_read_in_every_form() {
    let forms = [
        ("m/s/s", "m/(s*s)"),
        ("s^-1", "1/s"),
        ("1/s", "1/s"),
        ("(m/s)^2", "m^2/s^2"),
        ("kg*(m/s)^(-1/2)", "kg*s^(1/2)/m^(1/2)"),
        ("1", "1"),
        ("m^0.5", "m^(1/2)"),
        ("N / (m * s)", "N/(m*s)"),
    ];
    for (written, printed) in forms {
        let printed = format!("param a: {printed} = 1;\n");
        assert_eq!(print::statements(&read(&format!("param a: {written} = 1;"))), printed);
        assert_eq!(print::statements(&read(&printed)), printed);
    }
}

#[test]
fn units_behind_numbers_end_where_operators_stand() {
    let values = [
        ("30 deg", "30 [deg]"),
        ("2 m^2", "2 [m^2]"),
        ("2 m^2 * a", "2 [m^2] * a"),
        ("1 / 2 s", "1 / 2 [s]"),
        ("-9.81 [m/s^2]", "-9.81 [m/s^2]"),
        ("sin(30 deg) - 2 N", "sin(30 [deg]) - 2 [N]"),
        ("2 [m]", "2 [m]"),
        ("(2 m, 3 mm)", "(2 [m], 3 [mm])"),
        ("if 2 s < t { 1 N } else { 0 }", "if 2 [s] < t { 1 [N] } else { 0 }"),
    ];
    for (written, printed) in values {
        assert_eq!(print::statements(&read(&format!("let a = {written};"))), format!("let a = {printed};\n"));
    }
    // After a declared name a product is intended, and its missing sign is reported.
    let messages = errors("param m; let a = 2 m; let b = 2 [m];");
    assert_eq!(messages, ["error at 1:20: expected an operator or `;`, found `m`"]);
}

#[test]
fn invalid_units_are_reported() {
    let messages = [
        ("param a: metre = 1;", "error at 1:10: `metre` is not a unit"),
        ("param a: kgg = 1;", "error at 1:10: `kgg` is not a unit"),
        ("param a: m^ = 1;", "error at 1:13: expected a unit, found `=`"),
        ("param a: m*2 = 1;", "error at 1:12: expected a unit, found `2`"),
        ("param a: m^1000 = 1;", "error at 1:12: this power of a unit is too large"),
        ("param a: mm^(1/2) = 1;", "error at 1:10: this root of a unit is not an exact number of SI units"),
        ("param a: f64 = 1;", "error at 1:8: names have no individual types here"),
        ("let f(x: m) = 2 * x;", "error at 1:10: functions defined by `let` take quantities of any unit"),
        ("let a = 2 [kg m];", "error at 1:15: expected a unit, found `m`"),
        ("let a = 2 [];", "error at 1:12: expected a unit, found nothing"),
        ("let a = 2 m/s;", "error at 1:11: a unit of several factors needs square brackets after its number"),
        (
            "param m = 1; let a = 2 kg*m/s^2;",
            "error at 1:24: a unit of several factors needs square brackets after its number",
        ),
        ("let a = 2m;", "error at 1:9: a space is missing between a number and its unit"),
    ];
    for (text, message) in messages {
        assert_eq!(errors(text), [message], "{text}");
    }
}
