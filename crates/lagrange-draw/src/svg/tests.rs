use roxmltree::{Document, Node};

use super::document;
use crate::colour::{FORCE, INK, body};
use crate::picture::{Mark, Picture, Segment, Style};
use lagrange_plot::characters::number;
use lagrange_plot::label::{Anchor, Label, SUBSCRIPT};

const NAMESPACE: &str = "http://www.w3.org/2000/svg";

/// Returns texts that resemble markup, contain characters forbidden in documents, or exceed any
/// line.
pub(crate) fn hostile() -> Vec<String> {
    let controls =
        (0..0x20).chain(0x7f..0xa0).chain([0x2028, 0x2029, 0xfdd0, 0xfffe, 0xffff, 0x1_fffe, 0x10_ffff]);
    let texts = [
        "<script>alert(\"1\")</script>",
        "a < b && c > 'd' \"e\"",
        "]]> &amp; &#0; &bogus; <!-- -- --> <?xml?>",
        "\u{301}\u{308}",
        "_\u{301}{",
        "{{{{ _{_{_{ }}",
        "v_a_b_{c d}_e",
        "العربية \u{202e}rtl\u{2066} עברית",
        "👩\u{200d}🚀 🦀\u{fe0f}",
        "%s ${x} {{name}} \\u0000 \\",
        "\u{feff}\u{200b}\u{ad}",
        " \t\r\n ",
    ];
    let mut texts = texts.map(str::to_owned).to_vec();
    texts.push(controls.filter_map(char::from_u32).collect());
    texts.push("word ".repeat(2_000));
    texts.push("Ж".repeat(10_000));
    texts.push("{ a_".repeat(2_500));
    texts
}

/// Parses a document, and checks that every length is a number in units of the picture.
pub(crate) fn assert_plain(svg: &str) {
    let document = Document::parse(svg).unwrap_or_else(|error| panic!("{error}: {svg}"));
    for node in document.descendants() {
        for name in ["x", "y", "dx", "dy", "width", "height", "font-size", "stroke-width"] {
            let Some(value) = node.attribute(name) else { continue };
            assert!(value.parse::<f64>().is_ok_and(f64::is_finite), "{name}=\"{value}\"");
        }
    }
    let first = document.root_element().first_element_child().map(|child| child.tag_name().name().to_owned());
    assert_eq!(first.as_deref(), Some("title"));
}

fn picture(text: &str) -> Picture {
    let mark = Mark::Text {
        at: [10.0, 20.0],
        text: text.to_owned(),
        size: 14.0,
        anchor: Anchor::Middle,
        colour: INK,
    };
    Picture { size: [100.0, 50.0], title: text.to_owned(), marks: vec![mark] }
}

#[test]
fn every_colour_has_its_replacement_on_a_dark_ground() {
    let style = Style { stroke: Some(FORCE), width: 2.0, dashes: &[], fill: Some(body(0)) };
    let path = |segments| Mark::Path { segments, style: style.clone() };
    let mut picture = picture("text");
    picture.marks.push(path(vec![Segment::Move([1.0, 2.0]), Segment::Line([3.0, 4.0])]));
    let svg = document(&picture);
    let document = Document::parse(&svg).expect("is well formed");
    let sheet = document.descendants().find(|node| node.has_tag_name((NAMESPACE, "style")));
    let sheet = sheet.and_then(|node| node.text()).expect("has rules");
    let mut count = 0;
    for node in document.descendants() {
        for attribute in ["fill", "stroke"] {
            let Some(colour) = node.attribute(attribute) else { continue };
            assert!(
                sheet.contains(&format!("[{attribute}=\"{colour}\"]{{{attribute}:#")),
                "{colour}: {sheet}"
            );
            count += 1;
        }
    }
    assert_eq!(count, 4, "the ground, a text and a path");
    for colour in [INK, FORCE, body(0)] {
        assert_ne!(colour.light, colour.dark);
    }
}

#[test]
fn numbers_have_two_decimals_at_most() {
    let pairs = [(1.0, "1"), (-0.001, "0"), (0.126, "0.13"), (1200.0, "1200"), (-2.5, "-2.5")];
    for (value, written) in pairs {
        assert_eq!(number(value), written);
    }
}

#[test]
fn names_cannot_break_a_document() {
    for text in hostile() {
        assert_plain(&document(&picture(&text)));
    }
    let text = format!("<text>{}</text>", Label::parse("<v>_P'&_{<Q>}").content(10.0));
    let document = Document::parse(&text).expect("is well formed");
    let words: String = document.descendants().filter_map(|node| node.text()).collect();
    assert!(words.contains("<v>") && words.contains("<Q>"));
}

/// Text has the same positions and sizes in documents as in rasterised pictures.
#[test]
fn subscripts_have_sizes_and_heights_in_units_of_the_picture() {
    for size in [10.0, 14.0, 160.0, 0.5] {
        for text in ["v_P", "J_{S P}′ = a_Q", "v_a_b_{c d} e", "_a", "x", "a_1 b_2"] {
            let xml = format!("<text>{}</text>", Label::parse(text).content(size));
            let document = Document::parse(&xml).expect("is well formed");
            let mut down = 0.0;
            let pieces = document.root_element().children().map(|node: Node<'_, '_>| {
                let value =
                    |name: &str| node.attribute(name).map(|value| value.parse::<f64>().expect("a number"));
                let text = node.text().or_else(|| node.first_child()?.text()).expect("letters").to_owned();
                down += value("dy").unwrap_or(0.0);
                (text, value("font-size").unwrap_or(size), down)
            });
            let pieces = pieces.collect::<Vec<_>>();
            let (expected, _) = Label::parse(text).set(size);
            assert_eq!(pieces.len(), expected.len(), "{text}");
            for ((letters, found, down), piece) in pieces.iter().zip(&expected) {
                assert_eq!(*letters, piece.text);
                assert!((found - piece.size).abs() < 0.01, "{text}: {found}");
                assert!((down - piece.at[1]).abs() < 0.01, "{text}: {down}");
                assert!(piece.at[1] == 0.0 || *found < size && SUBSCRIPT.0 < 1.0);
            }
        }
    }
}
