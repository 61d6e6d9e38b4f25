//! Functions of other languages.

use super::filled;
use super::rates::derivative;

/// Functions with other names, or with another number of arguments, and their spelling here: `#1`
/// is the first argument. Rows with more arguments than given do not match.
pub const FUNCTIONS: &[(&[&str], usize, &str)] = &[
    (&["log", "loge", "Log"], 1, "ln(#1)"),
    (&["log"], 2, "ln(#1)/ln(#2)"),
    (&["log10", "lg"], 1, "ln(#1)/ln(10)"),
    (&["log2", "ld"], 1, "ln(#1)/ln(2)"),
    (&["arcsin", "ArcSin"], 1, "asin(#1)"),
    (&["arccos", "ArcCos"], 1, "acos(#1)"),
    (&["arctan", "ArcTan"], 1, "atan(#1)"),
    (&["arctan", "arctan2", "ArcTan", "atan", "Atan2"], 2, "atan2(#1, #2)"),
    (&["sec"], 1, "1/cos(#1)"),
    (&["csc", "cosec"], 1, "1/sin(#1)"),
    (&["cot", "cotan"], 1, "1/tan(#1)"),
    (&["asinh", "arcsinh"], 1, "ln(#1 + sqrt(#1^2 + 1))"),
    (&["acosh", "arccosh"], 1, "ln(#1 + sqrt(#1^2 - 1))"),
    (&["atanh", "arctanh"], 1, "1/2 * ln((1 + #1)/(1 - #1))"),
    (&["fabs", "Abs", "modulus"], 1, "abs(#1)"),
    (&["sgn", "signum", "Sign"], 1, "sign(#1)"),
    (&["sqr", "square", "sq"], 1, "#1^2"),
    (&["cbrt"], 1, "#1^(1/3)"),
    (&["sqrt", "root", "nthroot"], 2, "#1^(1/#2)"),
    (&["power", "Pow", "Power", "Math_pow"], 2, "#1^#2"),
    (&["exp2"], 1, "2^#1"),
    (&["recip"], 1, "1/#1"),
    (&["half"], 1, "1/2 * #1"),
    (&["to_radians", "radians", "deg2rad", "rad", "deg"], 1, "#1 * pi/180"),
    (&["to_degrees", "degrees", "rad2deg"], 1, "#1 * 180/pi"),
    (&["length", "magnitude", "mag", "len", "Norm", "norm2"], 1, "norm(#1)"),
    (&["norm", "length", "magnitude"], 2, "norm((#1, #2))"),
    (&["norm", "length", "magnitude"], 3, "norm((#1, #2, #3))"),
    (&["normalize", "normalise", "unit"], 1, "#1/norm(#1)"),
    (&["dot", "inner_product", "dot_product", "scalar_product", "Dot"], 2, "inner(#1, #2)"),
    (&["cross_product", "vector_product", "Cross"], 2, "cross(#1, #2)"),
    (&["vec", "vector", "Vector", "Vec2", "vec2", "Matrix", "array"], 2, "(#1, #2)"),
    (&["vec", "vector", "Vector", "Vec3", "vec3", "Matrix", "array"], 3, "(#1, #2, #3)"),
    (&["min"], 3, "min(#1, min(#2, #3))"),
    (&["max"], 3, "max(#1, max(#2, #3))"),
    (&["clamp", "clip", "saturate"], 3, "min(max(#1, #2), #3)"),
    (&["heaviside", "Heaviside", "step"], 1, "if #1 > 0 { 1 } else { 0 }"),
    (&["relu", "positive", "ramp"], 1, "max(#1, 0)"),
    (&["where", "ifelse", "select", "iif"], 3, "if a > 0 { #2 } else { #3 }"),
    (&["mul_add"], 3, "#1 * #2 + #3"),
    (&["add"], 2, "#1 + #2"),
    (&["sub"], 2, "#1 - #2"),
    (&["mul", "times"], 2, "#1 * #2"),
    (&["div"], 2, "#1/#2"),
    (&["neg"], 1, "-#1"),
    (&["transport_delay", "Delay"], 2, "delay(#1, #2)"),
];

/// Functions without an equivalent, with alternatives for their purpose.
const MISSING: &[(&[&str], &str)] = &[
    (
        &["diff", "D", "grad", "gradient", "derivative", "jacobian"],
        "a derivative with respect to a name is `partial(e, x)`; forces follow from energies: write `potential = V;` instead of its slope",
    ),
    (
        &["random", "rand", "randn", "noise", "normal", "gauss", "uniform"],
        "white noise is declared as `noise w, density: d;`; other random values are an `input`, set during the run",
    ),
    (
        &["floor", "ceil", "round", "trunc", "mod", "fmod"],
        "steps are written as conditions, `if t < 1 { 0 } else { 1 }`, whose jumps runs locate",
    ),
    (
        &["inverse", "inv", "Inverse", "pinv", "linsolve", "mldivide"],
        "matrices are not inverted: name the unknowns of linear equations, `solve (x, y): 0 = …, 0 = …;`",
    ),
    (
        &["det", "determinant", "Det", "trace", "tr", "eig", "eigenvalues"],
        "write it out by entries, such as `A[0][0] * A[1][1] - A[0][1] * A[1][0]`",
    ),
    (
        &["identity", "eye", "Identity", "zeros", "ones", "diag"],
        "write a matrix by rows, `((1, 0), (0, 1))`, or declare `param A[2][2] = [[1, 0], [0, 1]];`",
    ),
    (&["sum", "Sum", "total"], "a sum has a variable and a range: write `sum(i in 0..n, e)`"),
    (&["integral", "integrate", "int"], "an integral over time is a state: `state a; dot(a) = e;`"),
];

/// Returns advice for a function without a counterpart.
pub fn without_counterpart(name: &str) -> Option<&'static str> {
    MISSING.iter().find(|(names, _)| names.contains(&name)).map(|(_, advice)| *advice)
}

/// Puts an argument in parentheses unless it is a word.
fn bracketed(argument: &str) -> String {
    let is_word = argument.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '.');
    let is_enclosed = argument.ends_with(')') && closes_at_its_end(argument);
    if is_word || is_enclosed { argument.to_owned() } else { format!("({argument})") }
}

/// True if the first bracket of a text is closed by its last character, and only a word precedes
/// it.
fn closes_at_its_end(text: &str) -> bool {
    let Some(open) = text.find('(') else { return false };
    let is_call = text[..open].chars().all(|c| c.is_alphanumeric() || c == '_' || c == '.');
    let mut depth = 0;
    let closing = text[open..].char_indices().find(|(_, c)| {
        depth += i32::from(*c == '(') - i32::from(*c == ')');
        depth == 0
    });
    is_call && closing.is_some_and(|(at, _)| open + at + 1 == text.len())
}

/// Returns the spelling here of a call of a function that does not exist, or not with this number
/// of arguments.
pub fn function(name: &str, arguments: &[String]) -> Option<String> {
    if let Some(rate) = derivative(name, arguments) {
        return Some(rate.written());
    }
    let fits =
        |(names, count, _): &&(&[&str], usize, &str)| names.contains(&name) && *count == arguments.len();
    let (.., template) = FUNCTIONS.iter().find(fits)?;
    if template.contains("((") && arguments.iter().any(|argument| argument.starts_with('(')) {
        // A component of a vector cannot be a vector.
        return None;
    }
    let is_alone = |place: &str| {
        // Between parentheses or commas, no grouping can change.
        let around = |at: usize| {
            let before = template[..at].trim_end().chars().last();
            let after = template[at + place.len()..].trim_start().chars().next();
            matches!(before, Some('(' | ',' | '{')) && matches!(after, Some(')' | ',' | '}'))
        };
        template.match_indices(place).all(|(at, _)| around(at))
    };
    let texts = arguments.iter().enumerate().map(|(i, argument)| match is_alone(&format!("#{}", i + 1)) {
        true => argument.clone(),
        false => bracketed(argument),
    });
    Some(filled(template, &texts.collect::<Vec<_>>()))
}
