//! Symbols and subscripts in pictures.

use roxmltree::Document;

use super::{Anchor, Label};
use crate::lettering::Slope;

#[test]
fn an_underscore_starts_a_subscript() {
    let split = |text| {
        Label::parse(text)
            .runs()
            .to_vec()
            .into_iter()
            .map(|run| (run.text, run.is_subscript))
            .collect::<Vec<_>>()
    };
    let run = |text: &str, is_subscript| (text.into(), is_subscript);
    assert_eq!(split("v_P"), [run("v", false), run("P", true)]);
    assert_eq!(split("J_{S P}′"), [run("J", false), run("S P", true), run("′", false)]);
    assert_eq!(split("a_Q = b"), [run("a", false), run("Q", true), run(" = b", false)]);
    assert_eq!(split("a_"), [run("a", false), run("_", false)]);
    assert_eq!(Label::parse("v_P").plain(), "vP");
}

#[test]
fn subscripts_hang_below_the_base_line_and_are_narrower() {
    let (pieces, _) = Label::parse("v_P").set(10.0);
    assert_eq!(pieces.iter().map(|piece| piece.slope).collect::<Vec<_>>(), [Slope::Italic, Slope::Upright]);
    assert_eq!(pieces.iter().map(|piece| piece.size).collect::<Vec<_>>(), [10.0, 7.0]);
    assert_eq!((pieces[0].at, pieces[1].at), ([0.0, 0.0], [Label::from("v").width(10.0), 2.0]));
    let width = |text: &str, size| Label::parse(text).width(size);
    assert!(width("vP", 10.0) > width("v_P", 10.0) && width("v_P", 10.0) > width("v", 10.0));
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
        assert_eq!(Label::parse(text).runs()[0].is_symbol(), is_symbol, "{text}");
    }
}

/// Outlines show dots above letters, which fonts of viewers may hide.
#[test]
fn texts_with_accents_are_outlines_in_their_place() {
    for (text, size) in [("θ\u{307}_1 in rad", 14.0), ("Ω\u{308}", 137.0), ("a < \u{307}b", 10.0)] {
        let label = Label::parse(text);
        for anchor in [Anchor::Start, Anchor::Middle, Anchor::End] {
            let element = label.element([100.0, 50.0], size, anchor, " fill=\"#000000\"");
            let document = Document::parse(&element).expect("is well formed");
            assert_eq!(document.root_element().attribute("aria-label"), Some(&*label.plain()));
            let path = document.root_element().first_element_child().expect("a path");
            let numbers =
                path.attribute("d").expect("data").split(|c: char| c == ' ' || c.is_ascii_alphabetic());
            let numbers = numbers.filter(|number| !number.is_empty()).map(str::parse::<f64>);
            let numbers = numbers.collect::<Result<Vec<_>, _>>().expect("numbers");
            let left = 100.0 + anchor.offset(label.width(size));
            let (across, down): (Vec<_>, Vec<_>) =
                numbers.chunks_exact(2).map(|point| (point[0], point[1])).unzip();
            let within = |x: &f64| (left - 0.3 * size..left + label.width(size) + 0.3 * size).contains(x);
            assert!(across.iter().all(within), "{element}");
            assert!(down.iter().all(|y| (50.0 - 1.2 * size..50.0 + 0.5 * size).contains(y)), "{element}");
        }
    }
    let plain = Label::parse("theta_1").element([0.0, 0.0], 14.0, Anchor::Start, "");
    assert!(plain.starts_with("<text ") && !plain.contains("path"), "{plain}");
    // The dots of θ̈ are above the letter.
    let top = |text: &str| crate::lettering::outline(text, Slope::Italic).expect("letters").bounds().top();
    assert!(top("θ\u{308}") < top("θ") - 0.05);
}
