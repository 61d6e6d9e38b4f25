//! The film as one HTML file: its first picture, its changes as JSON, and a script that plays it.

use crate::film::animation::{full_length, visibility, with_children, with_marks};
use crate::film::chart::{Chart, look};
use crate::film::layers::{Change, Layer, kinds, layers};
use crate::film::motion::Pose;
use crate::film::points;
use crate::picture::{Picture, Segment};
use crate::svg;
use crate::timeline::Curve;
use crate::timeline::Timeline;
use lagrange_plot::characters::escaped;
use lagrange_plot::characters::number;
use lagrange_plot::colours;
use lagrange_plot::label::Label;
use lagrange_plot::notation::Columns;

const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
/// Script for colours that no style sheet sets. `scheme()` is the query for readers who prefer
/// dark, and `tinted(pair)` is the colour of a pair for the reader.
pub const SCHEME: &str = include_str!("scheme.js");
const SCRIPT: &str = include_str!("page.js");
/// Script that shows the layers of pictures.
const LAYERS: &str = include_str!("layers.js");
/// Title of a page without one.
const UNTITLED: &str = "Film";

/// A page with a player. Its own style, data and script display a moment; the player is common to
/// all pages.
pub(crate) struct Page<'a> {
    /// Title in the notation of formulas.
    pub(crate) title: &'a str,
    pub(crate) timeline: &'a Timeline,
    /// CSS rules in addition to the common ones.
    pub(crate) style: &'a str,
    /// Content displayed and changed by the viewer.
    pub(crate) picture: String,
    /// JSON fields for the viewer.
    pub(crate) shown: String,
    /// A script with a function `viewer`. It returns a function that displays the moment between a
    /// picture and the next.
    pub(crate) viewer: &'a str,
    /// Further key bindings.
    pub(crate) keys: &'a str,
}

/// Returns the style sheet of all pages.
pub fn style() -> String {
    colours::variables() + STYLE
}

/// Returns the page of pictures with the same marks.
pub(super) fn of_pictures(pictures: &[Picture], timeline: &Timeline) -> String {
    let layers = layers(pictures);
    let changing = layers.iter().filter(|layer| !is_still(layer)).map(layer_json);
    let page = Page {
        title: pictures.first().map(|picture| &*picture.title).unwrap_or_default(),
        timeline,
        style: "",
        picture: first_picture(pictures, &layers),
        shown: format!("\"layers\":[\n{}]", changing.collect::<Vec<_>>().join(",\n")),
        viewer: LAYERS,
        keys: "",
    };
    page.html()
}

fn first_picture(pictures: &[Picture], layers: &[Layer]) -> String {
    let mut changing = 0;
    let mark = |layer: &Layer| {
        if is_still(layer) {
            return svg::mark(&layer.mark);
        }
        changing += 1;
        group(layer, changing - 1)
    };
    with_marks(pictures, &layers.iter().map(mark).collect::<String>())
}

impl Page<'_> {
    /// Returns the whole page.
    pub(crate) fn html(&self) -> String {
        let chart = Chart::of(self.timeline);
        fill(PAGE, |name| match name {
            "title" => Some(self.name()),
            "style" => Some(style() + self.style),
            "picture" => Some(self.picture.clone()),
            "duration" => Some(format!("{}", self.timeline.duration())),
            "chart" => Some(chart.as_ref().map(|chart| self.figure(chart)).unwrap_or_default()),
            "keys" => Some(self.keys.to_string()),
            "film" => Some(self.json(chart.as_ref())),
            "script" => Some(format!("{SCRIPT}\n{}", self.viewer)),
            _ => None,
        })
    }

    fn name(&self) -> String {
        let title = Label::parse(self.title).plain();
        if title.is_empty() { UNTITLED.to_string() } else { escaped(&title) }
    }

    fn figure(&self, chart: &Chart<'_>) -> String {
        let columns = Columns::new(self.timeline.curves.iter().map(|curve| &*curve.name));
        let entry = |(index, curve): (usize, &Curve)| {
            let name = columns.label(&curve.name).html();
            format!(
                "<li><svg viewBox=\"0 0 35 12\" aria-hidden=\"true\"><path class=\"{}\" d=\"M0 8H35\"/></svg> \
                 {name} <output id=\"value-{index}\"></output></li>",
                look(index),
            )
        };
        let legend: String = self.timeline.curves.iter().enumerate().map(entry).collect();
        format!("<div class=\"plot\">{}\n<ul class=\"legend\">{legend}</ul></div>", chart.svg())
    }

    fn json(&self, chart: Option<&Chart<'_>>) -> String {
        let curve = |curve: &Curve| {
            let values = list(curve.values.iter().map(|value| exact(*value)));
            format!("{{\"name\":{},\"values\":{values}}}", quoted(&curve.name))
        };
        format!(
            "{{\"times\":{},\n{},\n\"curves\":{},\n\"chart\":{}}}",
            list(self.timeline.times.iter().map(|time| exact(*time))),
            self.shown,
            list(self.timeline.curves.iter().map(curve)),
            chart.map_or("null".to_string(), Chart::json),
        )
    }
}

/// True if a layer is always shown and never changes.
fn is_still(layer: &Layer) -> bool {
    matches!(&layer.change, Change::Shows(shown) if shown.iter().all(|is_shown| *is_shown))
}

/// Returns a layer in the first picture, to be changed by the script.
fn group(layer: &Layer, index: usize) -> String {
    let (transform, mark) = match &layer.change {
        Change::Shows(_) | Change::Bends(_) => (String::new(), svg::mark(&layer.mark)),
        Change::Moves(poses) => {
            let pose = poses.iter().flatten().next();
            let transform = |pose: &Pose| {
                let [x, y] = pose.at.map(number);
                format!(" transform=\"translate({x} {y}) rotate({})\"", angle(*pose))
            };
            (pose.map(transform).unwrap_or_default(), svg::mark(&layer.mark))
        }
        Change::Grows(drawn) => {
            let all = full_length(&layer.mark);
            let left = all - drawn.iter().flatten().next().unwrap_or(&0.0);
            let (all, left) = (number(all), number(left));
            let dash = format!(" stroke-dasharray=\"{all}\" stroke-dashoffset=\"{left}\"");
            (String::new(), with_children(&layer.mark, &dash, ""))
        }
    };
    let is_shown = layer.change.shown().first().copied().unwrap_or(false);
    format!("<g id=\"layer-{index}\"{transform} visibility=\"{}\">{mark}</g>", visibility(is_shown))
}

fn layer_json(layer: &Layer) -> String {
    match &layer.change {
        Change::Shows(shown) => format!("{{\"change\":\"shows\",\"track\":{}}}", list(runs(shown))),
        Change::Moves(poses) => {
            let turns = poses.iter().flatten().any(|pose| angle(*pose) != "0");
            let pose = |pose: &Pose| {
                let [x, y] = pose.at.map(number);
                if turns { format!("[{x},{y},{}]", angle(*pose)) } else { format!("[{x},{y}]") }
            };
            format!("{{\"change\":\"moves\",\"track\":{}}}", track(poses, pose))
        }
        Change::Grows(drawn) => {
            let length = number(full_length(&layer.mark));
            let drawn = track(drawn, |length| number(*length));
            format!("{{\"change\":\"grows\",\"length\":{length},\"track\":{drawn}}}")
        }
        Change::Bends(shapes) => {
            let numbers = |segments: &Vec<Segment>| {
                list(segments.iter().copied().flat_map(points).flatten().map(number))
            };
            let (kinds, shapes) = (kinds(&layer.mark), track(shapes, numbers));
            format!("{{\"change\":\"bends\",\"kinds\":\"{kinds}\",\"track\":{shapes}}}")
        }
    }
}

/// Returns the index of the first picture of each run of pictures with a layer, and of the first
/// one after the run.
fn runs(shown: &[bool]) -> Vec<String> {
    let mut start = 0;
    let mut runs = Vec::new();
    for run in shown.chunk_by(|a, b| a == b) {
        if run[0] {
            runs.push(format!("[{start},{}]", start + run.len()));
        }
        start += run.len();
    }
    runs
}

fn track<T>(values: &[Option<T>], write: impl Fn(&T) -> String) -> String {
    list(values.iter().map(|value| value.as_ref().map_or("null".to_string(), &write)))
}

pub(crate) fn list(items: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", items.into_iter().collect::<Vec<_>>().join(","))
}

/// Formats the angle of a pose in degrees.
fn angle(pose: Pose) -> String {
    let text = format!("{:.3}", pose.angle.to_degrees());
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

/// Formats a number with all its digits.
pub(crate) fn exact(value: f64) -> String {
    if value.is_finite() { format!("{value:e}") } else { "null".to_string() }
}

/// Returns a JSON string that is safe within an HTML element.
pub(crate) fn quoted(text: &str) -> String {
    let escaped = |letter: char| match letter {
        '"' | '\\' | '<' | '>' | '&' | '\u{2028}' | '\u{2029}' | '\0'..='\u{1f}' => {
            format!("\\u{:04x}", u32::from(letter))
        }
        _ => letter.to_string(),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}

/// Replaces each `{{name}}` of a template; names without a value stay.
fn fill(template: &str, value: impl Fn(&str) -> Option<String>) -> String {
    let mut filled = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once("{{") {
        filled += before;
        rest = after;
        let Some((name, after)) = after.split_once("}}") else { break };
        if let Some(value) = value(name) {
            filled += &value;
        }
        rest = after;
    }
    filled + rest
}
