//! Available characters, their widths, and the positions of accents.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use tiny_skia::Rect;

use super::{CAPITALS, SMALL, Slope, UPRIGHT, outline, width};

/// Characters of labels, marks of axes and titles in several languages.
const WRITTEN: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789!\"#$%&'()*+,-./:;<=>?@[\\]^_`{|}~\
                       ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩαβγδεζηθικλμνξοπρςστυφχψωϑϕϵ′″·×−–—°½…±≈≠≤≥→∞√∂∑∫∥⊥⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻₀₁₂\
                       ẋẍẏäöüßéèçñåøłšž«»„“‚‘АБВГДабвгдёж";
/// A character that no text font contains.
const UNKNOWN: &str = "\u{f8ff}";

fn bounds(text: &str, slope: Slope) -> Rect {
    outline(text, slope).expect("has an outline").bounds()
}

#[test]
fn every_character_of_labels_has_a_glyph() {
    for slope in [Slope::Upright, Slope::Italic] {
        let unknown = outline(UNKNOWN, slope);
        for letter in WRITTEN.chars().map(String::from) {
            assert!(
                outline(&letter, slope).is_some_and(|drawn| Some(drawn) != unknown),
                "{letter} {slope:?}"
            );
            let area = bounds(&letter, slope);
            assert!(area.top() > -1.1 && area.bottom() < 0.4, "{letter} {area:?}");
            assert!(
                area.left() > -0.3 && area.right() < 0.3 + width(&letter, slope) as f32,
                "{letter} {area:?}"
            );
        }
    }
}

#[test]
fn every_character_that_examples_write_has_a_glyph() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let files = fs::read_dir(folder).expect("is there").map(|file| file.expect("is there").path());
    let mut written = BTreeSet::new();
    for file in files.filter(|path| path.is_file()) {
        let text = fs::read_to_string(file).expect("is text");
        let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        written.extend(lines.flat_map(|line| line.split('"').skip(1).step_by(2)).flat_map(str::chars));
    }
    assert!(
        ['ρ', '′', '×'].iter().all(|letter| written.contains(letter)),
        "what examples are known to write"
    );
    let unknown = outline(UNKNOWN, Slope::Upright);
    let lost: String =
        written.iter().filter(|c| outline(&c.to_string(), Slope::Upright) == unknown).collect();
    assert_eq!(lost, "");
}

#[test]
fn symbols_lean_and_their_greek_does() {
    for letter in ["x", "F", "φ", "Δ", "é"] {
        assert_ne!(outline(letter, Slope::Italic), outline(letter, Slope::Upright), "{letter}");
    }
    assert_eq!(outline("≤", Slope::Italic), outline("≤", Slope::Upright));
}

#[test]
fn missing_characters_are_boxes() {
    let area = bounds(UNKNOWN, Slope::Upright);
    assert!(area.width() > 0.4 && area.height() > 0.6, "{area:?}");
    for text in ["\u{1f980}", "字", "ا"] {
        assert_eq!(outline(text, Slope::Italic), outline(UNKNOWN, Slope::Upright), "{text}");
    }
    assert!(width("a字b", Slope::Upright) > width("ab", Slope::Upright) + 0.5);
    assert_eq!(outline("a\nb", Slope::Upright), outline("a b", Slope::Upright));
    assert_eq!((outline(" ", Slope::Upright), outline("", Slope::Upright)), (None, None));
    assert_eq!(width("", Slope::Upright), 0.0);
}

#[test]
fn heights_are_those_of_the_font() {
    let size = f64::from(UPRIGHT.units_per_em());
    let heights = [UPRIGHT.capital_height(), UPRIGHT.x_height()].map(|height| height.map(f64::from));
    assert_eq!(heights, [Some(CAPITALS * size), Some(SMALL * size)]);
    let flat = bounds("E", Slope::Upright);
    assert!((f64::from(flat.height()) - CAPITALS).abs() < 0.01, "{flat:?}");
    assert!(f64::from(flat.bottom()).abs() < 0.01, "stands on the base line");
}

#[test]
fn pairs_follow_the_kerning_of_the_font() {
    let apart = |a, b| width(a, Slope::Upright) + width(b, Slope::Upright);
    assert!(width("AV", Slope::Upright) < apart("A", "V") - 0.05);
    assert_eq!(width("nn", Slope::Upright), apart("n", "n"));
}

/// Accents have no width, and are placed above the middle of tall and of short letters without
/// touching them.
#[test]
fn accents_stand_above_their_letters() {
    for slope in [Slope::Upright, Slope::Italic] {
        for letter in ["x", "φ", "θ", "L"] {
            for accent in ["\u{307}", "\u{308}", "\u{20d7}"] {
                let dotted = format!("{letter}{accent}");
                assert_eq!(width(&dotted, slope), width(letter, slope), "{dotted}");
                let (plain, all) = (bounds(letter, slope), bounds(&dotted, slope));
                assert!(all.top() < plain.top() - 0.1, "{dotted} {plain:?} {all:?}");
                assert!(all.top() > plain.top() - 0.4, "{dotted} {plain:?} {all:?}");
                assert!(
                    all.left() > plain.left() - 0.1 && all.right() < plain.right() + 0.25,
                    "{dotted} {plain:?} {all:?}"
                );
            }
        }
    }
    let (set, drawn) = (bounds("x\u{307}", Slope::Upright), bounds("ẋ", Slope::Upright));
    assert!((set.top() - drawn.top()).abs() < 0.02, "as the letter that has its dot {set:?} {drawn:?}");
    assert!(outline("\u{307}", Slope::Upright).is_some(), "above nothing");
}
