//! Names in the notation of labels: `v_P`, θ̇₁ for `theta1_dot`.

use std::collections::BTreeMap;

use crate::label::{Label, is_symbol};

const GREEK: [(&str, char); 34] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// Maximum number of letters of a subscript after a word; a longer part is another word.
const SHORT: usize = 3;

/// Writes a name in the notation of labels. Names of Greek letters become Greek letters, and
/// numbers after a letter become subscripts. A part after an underscore is a subscript of a symbol,
/// or of a word if the part is short. Longer parts are words: `left_half`.
pub fn formula(name: &str) -> String {
    let is_name = name.chars().all(|c| c.is_alphanumeric() || "_'′".contains(c));
    let mut parts = name.split('_').map(symbols);
    let (Some(base), true) = (parts.next(), is_name) else { return symbols(name) };
    // Subscripts have no subscripts of their own.
    let behind: Vec<String> = parts.map(|part| part.replace('_', "")).collect();
    if base.is_empty() || behind.is_empty() || behind.iter().any(String::is_empty) {
        return symbols(name);
    }
    let letters = |part: &str| part.chars().filter(|c| c.is_alphanumeric()).count();
    let (letter, number) = base.split_once('_').unwrap_or((&base, ""));
    match &behind[..] {
        parts if letters(letter) > 1 && (parts.len() > 1 || letters(&parts[0]) > SHORT) => {
            format!("{base} {}", parts.join(" "))
        }
        [part] if number.is_empty() => format!("{letter}_{part}"),
        // Several subscripts are joined into one.
        parts => format!("{letter}_{{{}}}", format!("{number} {}", parts.join(" ")).trim_start()),
    }
}

/// Writes a symbol, with a name as subscript if there are several symbols.
pub fn symbol(letter: &str, name: &str, has_others: bool) -> String {
    if has_others {
        format!("{letter}_{{{}}}", Label::parse(&formula(name)).plain())
    } else {
        letter.to_owned()
    }
}

/// Writes Greek letters, primes, and numbers after single letters; underscores remain unchanged.
fn symbols(name: &str) -> String {
    let mut written = String::new();
    let mut rest = name;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c: char| c.is_alphabetic() != first.is_alphabetic()).unwrap_or(rest.len());
        let (word, behind) = rest.split_at(end);
        let greek = GREEK.iter().find(|(spelt, _)| *spelt == word);
        match greek {
            Some((_, letter)) => written.push(*letter),
            None => written.push_str(&word.replace('\'', "′")),
        }
        let is_symbol = greek.is_some() || word.chars().count() == 1;
        if is_symbol && first.is_alphabetic() && behind.starts_with(|c: char| c.is_ascii_digit()) {
            written.push('_');
        }
        rest = behind;
    }
    written
}

/// The columns of a system. They are labelled by symbols if their names are those of symbols and no
/// two look alike.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Columns {
    /// Names by the corresponding symbols; `None` for a symbol of several names.
    names: BTreeMap<String, Option<String>>,
}

impl Columns {
    /// Collects the names of all columns.
    pub fn new<'n>(names: impl IntoIterator<Item = &'n str>) -> Columns {
        let mut columns = Columns::default();
        for name in names {
            let Some(symbol) = quantity(name) else { continue };
            let first = columns.names.entry(symbol).or_insert_with(|| Some(name.to_owned()));
            // Two names that look alike remain as they are spelled.
            if first.as_deref().is_some_and(|first| first != name) {
                *first = None;
            }
        }
        columns
    }

    /// Returns the label of a column.
    pub fn label(&self, name: &str) -> Label {
        let is_unique =
            |symbol: &String| self.names.get(symbol).is_none_or(|known| known.as_deref() == Some(name));
        quantity(name).filter(is_unique).map_or_else(|| name.into(), |symbol| Label::parse(&symbol))
    }
}

/// Writes the name of a column in the notation of labels if it denotes a symbol. For example,
/// `theta1_dot` is θ̇ with the subscript 1, and `x[2]` is x with the subscript 2. Words such as
/// `energy` have no symbol.
fn quantity(name: &str) -> Option<String> {
    let (stem, indices) = name.split_at(name.find('[').unwrap_or(name.len()));
    let (stem, dots) = [("_ddot", "\u{308}"), ("_dot", "\u{307}")]
        .into_iter()
        .find_map(|(suffix, dots)| Some((stem.strip_suffix(suffix)?, dots)))
        .unwrap_or((stem, ""));
    let written = formula(stem);
    let (letter, subscript) = match written.split_once('_') {
        Some((letter, subscript)) => (letter, Some(subscript.trim_matches(['{', '}']))),
        None => (&*written, None),
    };
    let is_name = stem.chars().all(|c| c.is_alphanumeric() || c == '_') && !stem.ends_with("dot");
    if !is_name || !is_symbol(letter) || subscript.is_some_and(|part| part.is_empty() || part.contains('_')) {
        return None;
    }
    let parts = subscript.into_iter().chain(numbers(indices)?).collect::<Vec<_>>();
    // Dots replace the dot of the letter.
    let letter = match letter {
        "i" if !dots.is_empty() => "ı",
        "j" if !dots.is_empty() => "ȷ",
        letter => letter,
    };
    let subscript = if parts.is_empty() { String::new() } else { format!("_{{{}}}", parts.join(", ")) };
    Some(format!("{letter}{dots}{subscript}"))
}

/// Returns the numbers of `[1][2]`; `None` for any other text.
fn numbers(indices: &str) -> Option<Vec<&str>> {
    let is_number = |index: &str| !index.is_empty() && index.chars().all(|c| c.is_ascii_digit());
    let parts = indices.split('[').skip(1).map(|part| part.strip_suffix(']'));
    parts.map(|index| index.filter(|index| is_number(index))).collect()
}

/// Writes a unit as in formulas: `kg*m^2/s^2` becomes kg·m²/s².
pub fn unit(unit: &str) -> String {
    let mut written = String::new();
    let mut is_raised = false;
    let has_fractions = unit.contains("^(");
    for character in unit.chars() {
        is_raised = character == '^' || is_raised && (character == '-' || character.is_ascii_digit());
        match character {
            _ if has_fractions && character != '*' => written.push(character),
            '^' => {}
            '*' => written.push('·'),
            _ if is_raised => written.push(raised(character)),
            _ => written.push(character),
        }
    }
    written
}

/// Returns a digit or sign as a superscript.
pub fn raised(character: char) -> char {
    match character {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        // The other superscripts are consecutive.
        _ => character.to_digit(10).and_then(|digit| char::from_u32('⁰' as u32 + digit)).unwrap_or(character),
    }
}

#[cfg(test)]
mod tests;
