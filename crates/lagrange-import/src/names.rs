//! Unique identifiers for declarations, from names in a file.

use std::collections::{HashMap, HashSet};

use lagrange_core::keywords::is_rust_keyword;
use lagrange_core::syntax::can_be_declared;

/// Name of the world in the language.
pub(crate) const GROUND: &str = "ground";
/// Suffixes of names in the state of a body that moves freely, and of an orientation.
pub(crate) const FREE: [&str; 13] =
    ["x", "y", "z", "vx", "vy", "vz", "qw", "qx", "qy", "qz", "wx", "wy", "wz"];

/// The identifiers in use.
#[derive(Debug, Default)]
pub(crate) struct Identifiers {
    taken: HashSet<String>,
    /// For names with many duplicates, the first number that may be free.
    numbers: HashMap<String, usize>,
}

impl Identifiers {
    /// Reserves an identifier similar to a name. `kind`, such as `link`, is appended if the
    /// identifier is invalid or in use.
    ///
    /// Derived names, with `endings` after an underscore, are reserved, too.
    pub(crate) fn take(&mut self, name: &str, kind: &str, endings: &[&str]) -> String {
        let base = identifier(name, kind);
        let with_kind = format!("{base}_{kind}");
        let plain = [base, with_kind.clone()].into_iter().find(|wish| self.is_free(wish, endings));
        let identifier = plain.unwrap_or_else(|| self.numbered(&with_kind, endings));
        self.taken.extend(endings.iter().map(|ending| format!("{identifier}_{ending}")));
        self.taken.insert(identifier.clone());
        identifier
    }

    /// Continues counting from the last number, so that many equal names take no longer than
    /// distinct ones.
    fn numbered(&mut self, name: &str, endings: &[&str]) -> String {
        let first = self.numbers.get(name).copied().unwrap_or(2);
        let mut numbered = (first..).map(|number| (number, format!("{name}_{number}")));
        let free = numbered.find(|(_, wish)| self.is_free(wish, endings));
        let (number, identifier) = free.unwrap_or_else(|| (first, name.to_owned()));
        self.numbers.insert(name.to_owned(), number + 1);
        identifier
    }

    fn is_free(&self, wish: &str, endings: &[&str]) -> bool {
        let is_taken = |name: &str| self.taken.contains(name);
        let made = endings.iter().map(|ending| format!("{wish}_{ending}"));
        can_be_declared(wish)
            && wish != GROUND
            && !is_taken(wish)
            && !made.into_iter().any(|made| is_taken(&made))
    }
}

/// Converts a name to a lower-case identifier: `LHip.Yaw 2` becomes `l_hip_yaw_2`.
fn identifier(name: &str, kind: &str) -> String {
    let words = words(name);
    match words.first() {
        None => kind.to_owned(),
        Some(first) if first.starts_with(|letter: char| letter.is_ascii_digit()) => {
            format!("{kind}_{}", words.join("_"))
        }
        Some(_) => words.join("_"),
    }
}

/// True if an identifier has the same letters and digits as its original name.
pub(crate) fn tells(identifier: &str, name: &str) -> bool {
    let letters =
        name.chars().filter(|letter| letter.is_alphanumeric()).map(|letter| letter.to_ascii_lowercase());
    letters.eq(identifier.chars().filter(|letter| letter.is_alphanumeric()))
}

/// Returns the name of a type: `two_link-arm` becomes `TwoLinkArm`.
pub(crate) fn type_name(name: &str) -> String {
    let capitalised = |word: String| word[..1].to_uppercase() + &word[1..];
    let name = words(name).into_iter().map(capitalised).collect::<String>();
    let is_name = name.starts_with(|letter: char| letter.is_ascii_alphabetic()) && !is_rust_keyword(&name);
    if is_name { name } else { format!("Robot{name}") }
}

/// Splits a name into lower-case words of letters and digits. A capital begins a new word after or
/// before a small letter.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let letters = name.chars().collect::<Vec<_>>();
    for (i, letter) in letters.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| letters[i]);
        let follows_capital = before.is_some_and(|before| before.is_ascii_uppercase());
        let precedes_small = letters.get(i + 1).is_some_and(char::is_ascii_lowercase);
        let begins = letter.is_ascii_uppercase() && (!follows_capital || precedes_small);
        if !letter.is_ascii_alphanumeric() || begins {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut().filter(|_| letter.is_ascii_alphanumeric()) {
            word.push(letter.to_ascii_lowercase());
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::{FREE, Identifiers, type_name};

    #[test]
    fn names_become_identifiers_that_rust_and_the_language_accept() {
        let cases = [
            ("panda_joint1", "panda_joint1"),
            ("LHipYaw", "l_hip_yaw"),
            ("left-arm.link 3", "left_arm_link_3"),
            ("URDFLink", "urdf_link"),
            ("FL_hip", "fl_hip"),
            ("4bar", "link_4bar"),
            ("__x__", "x"),
            ("mount", "mount"),
            ("body", "body_link"),
            ("type", "type_link"),
            ("sin", "sin_link"),
            ("t", "t_link"),
            ("ground", "ground_link"),
            ("spring", "spring_link"),
            ("to", "to_link"),
            ("Gelenk-ä-1", "gelenk_1"),
            ("関節", "link"),
            ("", "link_link"),
        ];
        let mut identifiers = Identifiers::default();
        for (name, wanted) in cases {
            assert_eq!(identifiers.take(name, "link", &[]), wanted, "{name}");
        }
    }

    #[test]
    fn names_that_are_taken_get_an_ending() {
        let mut identifiers = Identifiers::default();
        assert_eq!(identifiers.take("arm", "link", &[]), "arm");
        assert_eq!(identifiers.take("Arm", "link", &[]), "arm_link");
        assert_eq!(identifiers.take("ARM", "link", &[]), "arm_link_2");
        assert_eq!(identifiers.take("q", "joint", &["dot"]), "q");
        assert_eq!(identifiers.take("q_dot", "joint", &["dot"]), "q_dot_joint");
        assert_eq!(identifiers.take("trunk", "link", &FREE), "trunk");
        assert_eq!(identifiers.take("trunk_qw", "joint", &["dot"]), "trunk_qw_joint");
    }

    #[test]
    fn names_of_types_begin_with_a_capital() {
        let cases = [
            ("two_link-arm", "TwoLinkArm"),
            ("ur5", "Ur5"),
            ("4bar", "Robot4bar"),
            ("", "Robot"),
            ("self", "RobotSelf"),
        ];
        for (name, wanted) in cases {
            assert_eq!(type_name(name), wanted);
        }
    }
}
