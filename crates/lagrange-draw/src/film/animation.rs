//! Animated SVG, which browsers play without a script (W3C, *SVG Animations Level 2*).

use crate::film::Film;
use crate::film::layers::{Change, Layer, layers, lengths};
use crate::film::motion::Pose;
use crate::picture::{Mark, Picture};
use crate::svg;
use crate::timeline::Timeline;
use lagrange_plot::characters::number;
use lagrange_plot::colours::CLASS;

/// The value of an attribute in a picture, with the picture's zero-based index.
type Key = (usize, String);

impl Film {
    /// Returns the film as an SVG that plays in a loop. Still viewers show its first picture, and
    /// so do browsers if the reader prefers reduced motion.
    pub fn svg(&self) -> String {
        animated(&self.recording, &self.timeline)
    }
}

pub(super) fn animated(pictures: &[Picture], timeline: &Timeline) -> String {
    let clock = Clock::new(timeline);
    let marks: String = layers(pictures).iter().map(|layer| clock.animated(layer)).collect();
    match pictures {
        [first, _, ..] => with_marks(pictures, &calmed(first, &marks)),
        _ => with_marks(pictures, &marks),
    }
}

/// Returns marks that move, and those of a picture that replace them if the reader prefers reduced
/// motion. Style sheets cannot stop animations of attributes, so they choose between both.
fn calmed(picture: &Picture, moving: &str) -> String {
    format!(
        "<style>@media (prefers-reduced-motion:reduce){{.{CLASS} .still{{display:inline}}.{CLASS} .moving{{display:none}}}}</style>\n\
         <g class=\"still\" display=\"none\">\n{}</g>\n<g class=\"moving\">\n{moving}</g>\n",
        svg::marks(picture)
    )
}

/// Returns an SVG document for a film with the given marks already written.
pub(super) fn with_marks(pictures: &[Picture], marks: &str) -> String {
    format!("{}{marks}</svg>\n", svg::opening(pictures))
}

/// The display times of pictures.
struct Clock {
    /// Duration in seconds.
    duration: f64,
    /// Times of pictures as fractions of the duration.
    keys: Vec<String>,
    /// True if pictures are at equal intervals, so that their times can be omitted.
    is_even: bool,
}

/// Relative deviation of intervals below which pictures count as evenly spaced.
const EVENNESS: f64 = 1e-3;

impl Clock {
    fn new(timeline: &Timeline) -> Clock {
        let (elapsed, duration) = (timeline.elapsed(), timeline.duration());
        let intervals = elapsed.len().saturating_sub(1) as f64;
        let part = |time: &f64| if duration > 0.0 { time / duration } else { 0.0 };
        let is_even = |(index, time): (usize, &f64)| (part(time) * intervals - index as f64).abs() < EVENNESS;
        // A tenth of a millisecond, or of a picture if pictures are shorter.
        let digits = (duration.max(intervals) * 1e4).log10().clamp(3.0, 12.0).ceil() as usize;
        let key = |time: &f64| short(&format!("{:.digits$}", part(time)));
        Clock {
            duration,
            keys: elapsed.iter().map(key).collect(),
            is_even: elapsed.iter().enumerate().all(is_even),
        }
    }

    fn animated(&self, layer: &Layer) -> String {
        let shown = layer.change.shown();
        let mark = match &layer.change {
            Change::Shows(_) => svg::mark(&layer.mark),
            Change::Moves(poses) => self.moving(&layer.mark, poses),
            Change::Grows(drawn) => self.growing(&layer.mark, drawn),
            Change::Bends(shapes) => {
                let data = |shape: &Vec<_>| svg::path_data(shape);
                with_children(&layer.mark, "", &self.animate("d", &self.held(shapes, data)))
            }
        };
        if shown.iter().all(|is_shown| *is_shown) {
            return mark;
        }
        let keys: Vec<Key> = shown.iter().map(|is_shown| visibility(*is_shown)).enumerate().collect();
        let what = "attributeName=\"visibility\" calcMode=\"discrete\"";
        // Without times, discrete values, including the last one, would get equal shares of the
        // duration.
        let animation = self.written("animate", what, &steps(&keys), true);
        format!("<g visibility=\"{}\">{animation}{mark}</g>\n", keys[0].1)
    }

    /// Returns a group that moves, around one that rotates, around the mark.
    fn moving(&self, mark: &Mark, poses: &[Option<Pose>]) -> String {
        let places = self.held(poses, |pose| place(*pose));
        let angles = self.held(poses, |pose| degrees(*pose));
        let turned = self.transformed("rotate", &angles, &svg::mark(mark));
        self.transformed("translate", &places, &turned)
    }

    fn transformed(&self, kind: &str, keys: &[Key], inner: &str) -> String {
        let is_still = keys.iter().all(|key| key.1 == keys[0].1);
        if is_still && keys[0].1 == "0" {
            return inner.to_string();
        }
        let what = format!("attributeName=\"transform\" type=\"{kind}\"");
        let animation = if is_still { String::new() } else { self.element("animateTransform", &what, keys) };
        format!("<g transform=\"{kind}({})\">{animation}{inner}</g>", keys[0].1)
    }

    /// Returns a line of one dash that is shifted forward.
    fn growing(&self, mark: &Mark, drawn: &[Option<f64>]) -> String {
        let all = full_length(mark);
        let keys = self.held(drawn, |drawn| number(all - drawn));
        let dash = format!(" stroke-dasharray=\"{}\" stroke-dashoffset=\"{}\"", number(all), keys[0].1);
        with_children(mark, &dash, &self.animate("stroke-dashoffset", &keys))
    }

    fn animate(&self, attribute: &str, keys: &[Key]) -> String {
        self.element("animate", &format!("attributeName=\"{attribute}\""), keys)
    }

    /// Returns an element that animates its parent; it is empty if nothing changes.
    fn element(&self, name: &str, what: &str, keys: &[Key]) -> String {
        if keys.iter().all(|key| key.1 == keys[0].1) || self.duration == 0.0 {
            return String::new();
        }
        let keys = without_repetition(keys);
        let has_times = !self.is_even || keys.len() < self.keys.len();
        self.written(name, what, &keys, has_times)
    }

    fn written(&self, name: &str, what: &str, keys: &[Key], has_times: bool) -> String {
        let values: Vec<&str> = keys.iter().map(|key| key.1.as_str()).collect();
        let times: Vec<&str> = keys.iter().map(|key| self.keys[key.0].as_str()).collect();
        let times = if has_times { format!(" keyTimes=\"{}\"", times.join(";")) } else { String::new() };
        let (values, duration) = (values.join(";"), seconds(self.duration));
        format!("<{name} {what} dur=\"{duration}s\" repeatCount=\"indefinite\"{times} values=\"{values}\"/>")
    }

    /// Returns values for all pictures. Pictures without the mark repeat the last value, or
    /// initially the first one.
    fn held<T>(&self, track: &[Option<T>], write: impl Fn(&T) -> String) -> Vec<Key> {
        let mut held = track.iter().flatten().next().map(&write).unwrap_or_default();
        let mut value = |value: &Option<T>| {
            if let Some(value) = value {
                held = write(value);
            }
            held.clone()
        };
        track.iter().map(&mut value).enumerate().collect()
    }
}

/// Removes keys between two others of the same value, if this saves space despite the times then
/// required.
fn without_repetition(keys: &[Key]) -> Vec<Key> {
    let is_needed = |index: usize| {
        let is_inner = index > 0 && index + 1 < keys.len();
        !(is_inner && keys[index - 1].1 == keys[index].1 && keys[index].1 == keys[index + 1].1)
    };
    let needed: Vec<Key> =
        keys.iter().enumerate().filter(|(index, _)| is_needed(*index)).map(|(_, key)| key.clone()).collect();
    if 2 * needed.len() > keys.len() { keys.to_vec() } else { needed }
}

/// Returns the keys at which the value changes; values in between are held.
fn steps(keys: &[Key]) -> Vec<Key> {
    let changes = |index: &usize| *index == 0 || keys[*index].1 != keys[*index - 1].1;
    (0..keys.len()).filter(changes).map(|index| keys[index].clone()).collect()
}

/// Returns the element of a mark with additional attributes and with children.
pub(super) fn with_children(mark: &Mark, attributes: &str, children: &str) -> String {
    let element = svg::mark(mark);
    match element.trim_end().strip_suffix("/>") {
        Some(open) => format!("{open}{attributes}>{children}</path>\n"),
        None => element,
    }
}

/// Returns the length of a growing line. It slightly exceeds the actual length, so that rounding
/// never leaves the end undrawn.
pub(super) fn full_length(mark: &Mark) -> f64 {
    let Mark::Path { segments, .. } = mark else { return 0.0 };
    lengths(segments).last().map_or(0.0, |length| length.ceil() + 1.0)
}

pub(super) fn place(pose: Pose) -> String {
    format!("{},{}", number(pose.at[0]), number(pose.at[1]))
}

/// Formats an angle to a thousandth of a degree. On a screen, this is less than a hundredth of a
/// pixel.
pub(super) fn degrees(pose: Pose) -> String {
    short(&format!("{:.3}", pose.angle.to_degrees()))
}

pub(super) fn visibility(is_shown: bool) -> String {
    if is_shown { "visible" } else { "hidden" }.to_string()
}

fn seconds(duration: f64) -> String {
    short(&format!("{duration:.6}"))
}

/// Returns a decimal number without superfluous characters.
pub(super) fn short(number: &str) -> String {
    let number =
        if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number };
    match number {
        "-0" | "0" => "0".to_string(),
        _ => match (number.strip_prefix("0."), number.strip_prefix("-0.")) {
            (Some(rest), _) => format!(".{rest}"),
            (_, Some(rest)) => format!("-.{rest}"),
            _ => number.to_string(),
        },
    }
}
