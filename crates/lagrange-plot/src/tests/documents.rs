//! Figures as documents that every viewer can read, regardless of names.

use roxmltree::Document;

use super::{curve, figure};
use crate::colours::{LINES, PAPER};
use crate::figure::PlotError;
use crate::{Figure, Panel};

const NAMES: [&str; 8] = [
    "<script>&amp;]]> 'a' \"b\"",
    "\u{0}\u{1}\u{8}\u{b}\u{1b}[31m\u{7f}\u{9f}",
    "\u{fffe}\u{ffff}\u{fdd0}\u{10ffff}",
    "\u{301}",
    "\u{202e}العربية",
    "👩\u{200d}🚀",
    "\t\r\n",
    "--> <!-- ${x} %",
];

fn named(name: &str) -> Figure {
    let line = || [(0.0, 1.0), (1.0, 2.0)].into_iter();
    let mut figure = figure(vec![curve(name, line()), curve("other", line())]);
    figure.panels[0].x = name.into();
    figure.panels[0].y = name.into();
    figure
}

#[test]
fn names_cannot_break_a_figure() -> Result<(), PlotError> {
    let long = ["long ".repeat(2_000), "Ж".repeat(10_000)];
    for name in NAMES.iter().copied().chain(long.iter().map(String::as_str)) {
        let figure = named(name);
        let svg = figure.svg()?;
        let document = Document::parse(&svg).unwrap_or_else(|error| panic!("{error}: {name:?}"));
        let root = document.root_element();
        assert_eq!(
            root.first_element_child().map(|child| child.tag_name().name()),
            Some("title"),
            "{name:?}"
        );
        assert_eq!(root.attribute("role"), Some("img"));
        for length in ["font-size", "x", "y", "dy", "stroke-width"] {
            for value in document.descendants().filter_map(|node| node.attribute(length)) {
                assert!(value.parse::<f64>().is_ok(), "{length}=\"{value}\"");
            }
        }
        figure.pixels()?;
    }
    Ok(())
}

fn title(figure: &Figure) -> String {
    let svg = figure.svg().expect("draws");
    let document = Document::parse(&svg).expect("is well formed");
    let title = document.root_element().first_element_child().and_then(|title| title.text());
    title.unwrap_or_default().to_owned()
}

#[test]
fn titles_describe_the_content() {
    let line = |name: &str| curve(name, [(0.0, 1.0), (1.0, 2.0)].into_iter());
    assert_eq!(title(&figure(vec![line("y")])), "height over time");
    assert_eq!(title(&figure(vec![line("a < b"), line("c")])), "height (a < b, c) over time");
    let many = (0..20).map(|index| line(&index.to_string())).collect::<Vec<_>>();
    assert_eq!(title(&figure(many)), "height (0, 1, 2, 3, 4, 5, 6 and 13 more) over time");
    let unnamed = Panel { curves: vec![line("a"), line("b")], ..Panel::default() };
    let panels = vec![figure(vec![line("y")]).panels.remove(0), unnamed, Panel::default()];
    assert_eq!(title(&Figure { panels, columns: 2, size: (400, 300) }), "height over time; a, b");
}

#[test]
fn every_colour_has_its_replacement_on_a_dark_ground() {
    let line = |index: usize| curve(&index.to_string(), [(0.0, 1.0), (1.0, index as f64)].into_iter());
    for count in [1, 7, 30] {
        let svg = figure((0..count).map(line).collect()).svg().expect("draws");
        let document = Document::parse(&svg).expect("is well formed");
        let sheet = document.descendants().find(|node| node.tag_name().name() == "style");
        let sheet = sheet.and_then(|node| node.text()).expect("has rules");
        for node in document.descendants() {
            for attribute in ["fill", "stroke"] {
                let colour = node.attribute(attribute).filter(|colour| *colour != "none");
                let Some(colour) = colour else { continue };
                assert!(sheet.contains(&format!("[{attribute}=\"{colour}\"]{{{attribute}:#")), "{colour}");
            }
        }
        assert!(sheet.matches("stroke:").count() >= count, "{count} colours of curves");
    }
}

#[test]
fn the_colours_of_many_curves_contrast_with_both_grounds() {
    let panel =
        Panel { curves: (0..100).map(|_| curve("", std::iter::empty())).collect(), ..Panel::default() };
    for colour in (0..100).map(|index| panel.colour(index)) {
        assert!(colour.contrast(PAPER) >= LINES, "{colour:?}");
    }
}
