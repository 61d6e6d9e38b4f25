//! Text in the notation of formulas: `v_P`, `J_{SP}`, `phi` for φ.
//!
//! An underscore starts a subscript: the letters and digits that follow it, or what stands in braces.

use lagrange_plot::lettering::{self, Slope};

/// Subscripts are smaller by this factor and lowered by this part of the size of the font.
pub(super) const SUBSCRIPT: (f64, f64) = (0.7, 0.2);

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

/// A piece of a text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Run {
    pub(super) text: String,
    pub(super) is_subscript: bool,
}

impl Run {
    /// True if it is a symbol, which is set in italics: one letter, perhaps with dots and primes.
    pub(super) fn is_symbol(&self) -> bool {
        let is_beside = |c: char| "′'″‴".contains(c) || lettering::is_accent(c);
        let mut letters = self.text.trim_end_matches(is_beside).chars();
        let first = letters.next();
        !self.is_subscript && letters.next().is_none() && first.is_some_and(char::is_alphabetic)
    }
}

/// Behind a word, more letters than these are another word and no subscript.
const SHORT: usize = 3;

/// A name as it is written in formulas: Greek letters by their names, numbers behind a letter as subscripts. What stands behind an
/// underscore is a subscript of a symbol, or of a word if it is short; longer parts are words of their own: `left_half`.
pub(super) fn formula(name: &str) -> String {
    let is_name = name.chars().all(|c| c.is_alphanumeric() || "_'′".contains(c));
    let mut parts = name.split('_').map(symbols);
    let (Some(base), true) = (parts.next(), is_name) else { return symbols(name) };
    // What is within a subscript has none of its own.
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
        // Several subscripts are one.
        parts => format!("{letter}_{{{}}}", format!("{number} {}", parts.join(" ")).trim_start()),
    }
}

/// A symbol, with a name as subscript where there are several.
pub(super) fn symbol(letter: &str, name: &str, has_others: bool) -> String {
    if has_others { format!("{letter}_{{{}}}", plain(&formula(name))) } else { letter.to_owned() }
}

/// Greek letters, primes and numbers behind single letters; underscores stay as they are.
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

/// The pieces of a text.
pub(super) fn runs(text: &str) -> Vec<Run> {
    let mut runs = Vec::new();
    let mut push = |text: &str, is_subscript| {
        if !text.is_empty() {
            runs.push(Run { text: text.into(), is_subscript });
        }
    };
    let mut rest = text;
    while let Some((plain, behind)) = rest.split_once('_') {
        push(plain, false);
        let braced = behind.strip_prefix('{').and_then(|inner| inner.split_once('}'));
        let end = behind.find(|c: char| !c.is_alphanumeric()).unwrap_or(behind.len());
        let (subscript, after) = braced.unwrap_or_else(|| behind.split_at(end));
        // A lone underscore is one.
        push(if subscript.is_empty() { "_" } else { subscript }, !subscript.is_empty());
        rest = after;
    }
    push(rest, false);
    runs
}

/// The text in one line of plain letters.
pub(super) fn plain(text: &str) -> String {
    runs(text).into_iter().map(|run| run.text).collect()
}

/// A piece of a text in its place.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Set {
    pub(super) text: String,
    pub(super) slope: Slope,
    /// The size of its letters.
    pub(super) size: f64,
    /// From the left end of the base line of the text to that of its own, y downwards.
    pub(super) at: [f64; 2],
}

/// The pieces of a text where they belong, and its width.
pub(super) fn set(text: &str, size: f64) -> (Vec<Set>, f64) {
    let mut left = 0.0;
    let place = |run: Run| {
        let (factor, lowered) = if run.is_subscript { SUBSCRIPT } else { (1.0, 0.0) };
        let slope = if run.is_symbol() { Slope::Italic } else { Slope::Upright };
        let piece = Set { slope, size: factor * size, at: [left, lowered * size], text: run.text };
        left += piece.size * lettering::width(&piece.text, slope);
        piece
    };
    (runs(text).into_iter().map(place).collect(), left)
}

/// The width of a text in pixels, about, whatever the font.
pub(super) fn width(text: &str, size: f64) -> f64 {
    set(text, size).1
}

#[cfg(test)]
mod tests {

    use super::{formula, plain, runs, set, width};
    use lagrange_plot::lettering::{Slope, outline};

    #[test]
    fn names_are_written_as_in_formulas() {
        let pairs = [
            ("phi", "φ"),
            ("omega_rod", "ω_rod"),
            ("k1", "k_1"),
            ("phi2", "φ_2"),
            ("rod", "rod"),
            ("rod1", "rod1"),
            ("v_P'", "v_P′"),
            ("left_half", "left half"),
            ("left_arm", "left_arm"),
            ("wheel_2", "wheel_2"),
            ("v_left", "v_left"),
            ("omega_wheel", "ω_wheel"),
            ("torsion_spring_1", "torsion spring 1"),
            ("front_l_wheel", "front l wheel"),
            ("v_P_max", "v_{P max}"),
            ("k1_left", "k_{1 left}"),
            ("v_P1", "v_P1"),
            ("a_Q = b_longer", "a_Q = b_longer"),
            ("J_{S P}", "J_{S P}"),
            ("a__b", "a__b"),
            ("_", "_"),
            ("Delta phi", "Δ φ"),
            ("", ""),
        ];
        for (name, written) in pairs {
            assert_eq!(formula(name), written);
        }
    }

    #[test]
    fn an_underscore_starts_a_subscript() {
        let split = |text| runs(text).into_iter().map(|run| (run.text, run.is_subscript)).collect::<Vec<_>>();
        let run = |text: &str, is_subscript| (text.into(), is_subscript);
        assert_eq!(split("v_P"), [run("v", false), run("P", true)]);
        assert_eq!(split("J_{S P}′"), [run("J", false), run("S P", true), run("′", false)]);
        assert_eq!(split("a_Q = b"), [run("a", false), run("Q", true), run(" = b", false)]);
        assert_eq!(split("a_"), [run("a", false), run("_", false)]);
        assert_eq!(plain("v_P"), "vP");
    }

    #[test]
    fn subscripts_hang_below_the_base_line_and_are_narrower() {
        let (pieces, _) = set("v_P", 10.0);
        assert_eq!(
            pieces.iter().map(|piece| piece.slope).collect::<Vec<_>>(),
            [Slope::Italic, Slope::Upright]
        );
        assert_eq!(pieces.iter().map(|piece| piece.size).collect::<Vec<_>>(), [10.0, 7.0]);
        assert_eq!((pieces[0].at, pieces[1].at), ([0.0, 0.0], [width("v", 10.0), 2.0]));
        assert!(width("vP", 10.0) > width("v_P", 10.0) && width("v_P", 10.0) > width("v", 10.0));
    }

    #[test]
    fn every_greek_letter_has_a_glyph_of_its_own() {
        for slope in [Slope::Upright, Slope::Italic] {
            let unknown = outline("\u{f8ff}", slope);
            for (name, letter) in super::GREEK {
                assert_ne!(outline(&formula(name), slope), unknown, "{name} {letter}");
            }
        }
    }

    #[test]
    fn symbols_may_have_dots_and_primes() {
        for (text, is_symbol) in [
            ("φ\u{307}", true),
            ("x\u{308}′", true),
            ("ẋ", true),
            ("P″", true),
            ("rod", false),
            ("2′", false),
            ("′", false),
        ] {
            assert_eq!(runs(text)[0].is_symbol(), is_symbol, "{text}");
        }
    }
}
