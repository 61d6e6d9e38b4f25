//! Numbers with units on the command line, parsed like defaults of parameters in the language.

use lagrange_core::diagnostics::Severity;
use lagrange_core::expr::evaluate;
use lagrange_core::pipeline::parse;

/// Parses the value of a quantity in coherent units. `unit` is the unit of the quantity, if known.
///
/// # Errors
/// If the text is invalid, with the errors as text.
pub(crate) fn value(quantity: &str, text: &str, unit: Option<&str>) -> Result<f64, String> {
    // An additional statement would otherwise be accepted.
    if text.contains(',') && text.contains('=') {
        return Err("expected one number; repeat the option for each name".to_owned());
    }
    if text.trim().is_empty() || text.contains([';', '{', ',', '=']) {
        return Err("expected a number".to_owned());
    }
    let (text, unit) = (spaced(text), unit.map_or_else(String::new, |unit| format!(": {unit}")));
    let declaration = format!("param value{unit} = {text}; coord x; kinetic = dot(x)^2;");
    let system = parse(&declaration).map_err(|report| {
        let errors = report.diagnostics().iter().filter(|mistake| mistake.severity == Severity::Error);
        let mistakes = errors.map(|mistake| mistake.message.clone());
        let mistakes = mistakes.collect::<Vec<_>>().join("; ").replace("the default of `value`", "the value");
        mistakes.replace("`value`", &format!("`{quantity}`"))
    })?;
    let value = system.model.parameters.first().and_then(|parameter| parameter.default);
    let value = value.map_or(f64::NAN, |value| evaluate(&system.model.graph, &[value], |_| f64::NAN)[0]);
    if value.is_finite() { Ok(value) } else { Err(format!("the number is {value}")) }
}

/// Separates a unit from the number before it, as in `2kg`. Exponents as in `1e-3` are not units.
fn spaced(text: &str) -> String {
    let text = text.trim();
    let digits = text.find(|c: char| !c.is_ascii_digit() && c != '.' && c != '-').unwrap_or(text.len());
    let (number, rest) = text.split_at(digits);
    let is_exponent =
        rest.trim_start_matches(['e', 'E']).starts_with(|c: char| c.is_ascii_digit() || "+-".contains(c));
    match rest.starts_with(char::is_alphabetic) && !is_exponent && !number.is_empty() {
        true => format!("{number} {rest}"),
        false => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::value;

    #[test]
    fn values_are_those_of_the_language() {
        assert_eq!(value("m", "2", None), Ok(2.0));
        assert_eq!(value("m", "-1.5e-3", None), Ok(-1.5e-3));
        assert_eq!(value("m", "500mm", Some("m")), Ok(0.5));
        assert_eq!(value("m", "9.81 [m/s^2]", Some("m/s^2")), Ok(9.81));
        assert_eq!(value("m", "180deg", Some("rad")), Ok(std::f64::consts::PI));
        assert_eq!(value("m", "pi / 4", Some("rad")), Ok(std::f64::consts::FRAC_PI_4));
        assert_eq!(value("m", "-2kg", Some("kg")), Ok(-2.0));
    }

    #[test]
    fn anything_else_is_a_mistake() {
        let several = value("m", "2kg,l=10cm", None);
        assert!(several.is_err_and(|error| error.contains("repeat the option")));
        for text in ["", "two", "2; coord y", "nan", "1/0", "2 s", "1 2", "inf"] {
            assert!(value("m", text, Some("kg")).is_err(), "{text}: {:?}", value("m", text, Some("kg")));
        }
    }
}
