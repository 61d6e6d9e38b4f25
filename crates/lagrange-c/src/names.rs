//! Names and numbers as C text.

use lagrange_core::emit::Variables;

/// Returns a name in snake case with ASCII letters: `double_pendulum` for `DoublePendulum`.
pub(crate) fn identifier(name: &str) -> String {
    let mut written = String::new();
    let mut was_lower = false;
    for letter in name.chars() {
        if letter.is_ascii_uppercase() && was_lower {
            written.push('_');
        }
        was_lower = letter.is_ascii_lowercase() || letter.is_ascii_digit();
        match letter {
            _ if letter.is_ascii_alphanumeric() => written.push(letter.to_ascii_lowercase()),
            '_' => written.push('_'),
            _ => written += &format!("u{:x}", u32::from(letter)),
        }
    }
    written
}

/// Returns a text as a string literal.
pub(crate) fn text(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// Returns a number as an expression.
pub(crate) fn number(value: f64) -> String {
    match value {
        _ if value.is_nan() => "NAN".to_owned(),
        _ if value.is_infinite() => if value > 0.0 { "INFINITY" } else { "-INFINITY" }.to_owned(),
        _ => format!("{value:?}"),
    }
}

/// Returns the unit of a name; empty if it is unknown.
pub(crate) fn unit<'a>(variables: &'a Variables, name: &str) -> &'a str {
    variables.unit(name).unwrap_or_default()
}

/// Returns a name with its unit as text.
pub(crate) fn with_unit(variables: &Variables, name: &str) -> String {
    match unit(variables, name) {
        "" | "1" => name.to_owned(),
        unit => format!("{name} in {unit}"),
    }
}

#[cfg(test)]
mod tests {
    use super::identifier;

    #[test]
    fn names_are_in_snake_case() {
        let names = ["DoublePendulum", "Top2D", "RLC", "Größe", "already_so"];
        let written = ["double_pendulum", "top2_d", "rlc", "gruf6udfe", "already_so"];
        assert_eq!(names.map(identifier), written);
    }
}
