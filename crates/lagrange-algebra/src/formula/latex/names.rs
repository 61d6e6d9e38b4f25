//! Names of symbols in LaTeX.

/// Greek letters that LaTeX has a command for; omicron and most capitals look like Latin letters.
const GREEK: [&str; 34] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu",
    "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta",
    "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega",
];

/// Writes a name with Greek letters, and with subscripts for trailing digits and for the part after
/// an underscore. The command `accent` is applied to the letter.
pub(super) fn latex_name(name: &str, accent: Option<&str>) -> String {
    let mut parts = name.split('_').filter(|part| !part.is_empty());
    let first = parts.next().unwrap_or(name);
    let letters = first.trim_end_matches(|c: char| c.is_ascii_digit());
    let (letters, digits) = if letters.is_empty() { (first, "") } else { first.split_at(letters.len()) };
    let mut subscripts = Vec::new();
    if !digits.is_empty() {
        subscripts.push(digits.to_owned());
    }
    subscripts.extend(parts.map(subscript));
    let head = word(letters);
    let head = accent.map_or(head.clone(), |accent| format!("{accent}{{{head}}}"));
    if subscripts.is_empty() { head } else { format!("{head}_{{{}}}", subscripts.join(",")) }
}

fn subscript(part: &str) -> String {
    let letters = part.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &part[letters.len()..];
    if letters.is_empty() { digits.to_owned() } else { format!("{}{digits}", word(letters)) }
}

fn word(letters: &str) -> String {
    if GREEK.contains(&letters) {
        format!(r"\{letters}")
    } else if letters == "_" {
        r"\_".to_owned()
    } else if letters.chars().count() == 1 {
        letters.to_owned()
    } else {
        format!(r"\mathrm{{{letters}}}")
    }
}

#[cfg(test)]
mod tests {
    use super::latex_name;

    #[test]
    fn names_become_letters_with_subscripts() {
        let cases = [
            ("x", "x"),
            ("theta", r"\theta"),
            ("theta1", r"\theta_{1}"),
            ("theta_12", r"\theta_{12}"),
            ("omega", r"\omega"),
            ("m_c", "m_{c}"),
            ("mc", r"\mathrm{mc}"),
            ("m1", "m_{1}"),
            ("k_rel2", r"k_{\mathrm{rel}2}"),
            ("x_a_b", "x_{a,b}"),
            ("_", r"\_"),
        ];
        for (name, expected) in cases {
            assert_eq!(latex_name(name, None), expected);
        }
        assert_eq!(latex_name("theta1", Some(r"\dot")), r"\dot{\theta}_{1}");
        assert_eq!(latex_name("mc", Some(r"\ddot")), r"\ddot{\mathrm{mc}}");
    }
}
