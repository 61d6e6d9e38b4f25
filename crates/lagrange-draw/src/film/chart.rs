//! The plot below the picture of a page: curves over time, and a cursor moved by the page's script.

use crate::timeline::Curve;
use crate::timeline::Timeline;
use lagrange_plot::axis::Axis;
use lagrange_plot::axis::Mark;
use lagrange_plot::axis::Scale;
use lagrange_plot::characters::escaped;
use lagrange_plot::characters::number;

/// Width and height in pixels.
const SIZE: [f64; 2] = [640.0, 300.0];
/// Left edge of the plot area.
const LEFT: f64 = 64.0;
const RIGHT: f64 = 628.0;
const TOP: f64 = 12.0;
/// Room for the common part of the labels of values.
const NOTE: f64 = 12.0;
const BOTTOM: f64 = 256.0;
/// Label of the time axis.
const TIME: &str = "time t in s";
/// Approximate number of ticks of an axis.
const TICKS: u32 = 6;
/// Number of colours for curves.
const LOOKS: usize = 6;
/// Relative range of values below which a curve is drawn as constant, to hide rounding errors.
const LEVEL: f64 = 1e-6;

/// A plot of curves over time.
pub(super) struct Chart<'a> {
    timeline: &'a Timeline,
    time: Axis,
    values: Axis,
    /// Top edge of the plot area.
    top: f64,
}

impl Chart<'_> {
    /// Creates the plot of a film's curves; none if there are no finite values.
    pub(super) fn of(timeline: &Timeline) -> Option<Chart<'_>> {
        let finite = || {
            timeline.curves.iter().flat_map(|curve| &curve.values).copied().filter(|value| value.is_finite())
        };
        let (low, high) = (finite().reduce(f64::min)?, finite().reduce(f64::max)?);
        let largest = low.abs().max(high.abs());
        let margin = if high - low > LEVEL * largest {
            0.05 * (high - low)
        } else if largest > 0.0 {
            0.1 * largest
        } else {
            1.0
        };
        let axis = |low, high| Axis::new(Scale::Linear, Some((low, high)), 0.0, TICKS);
        let (start, end) = (*timeline.times.first()?, *timeline.times.last()?);
        let duration = if start == end { 1.0 } else { (end - start).abs() };
        let first = start.min(end);
        let time = axis(first, first + duration);
        let values = axis(low - margin, high + margin);
        let top = if values.note.is_empty() { TOP } else { TOP + NOTE };
        Some(Chart { timeline, time, values, top })
    }

    pub(super) fn svg(&self) -> String {
        let [width, height] = SIZE;
        let names: Vec<String> = self.timeline.curves.iter().map(|curve| escaped(&curve.name)).collect();
        let names = names.join(", ");
        let curves: String = self.timeline.curves.iter().enumerate().map(|curve| self.curve(curve)).collect();
        format!(
            "<svg class=\"chart\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{names} over time\">\
             {}{}{curves}{}</svg>",
            self.value_axis(),
            self.time_axis(),
            self.cursor(),
        )
    }

    /// Returns the data that the script needs to move the cursor.
    pub(super) fn json(&self) -> String {
        let ([low, high], top) = (self.values.ends(), self.top);
        format!(
            "{{\"left\":{LEFT},\"right\":{RIGHT},\"top\":{top},\"bottom\":{BOTTOM},\"low\":{low:e},\"high\":{high:e}}}"
        )
    }

    fn value_axis(&self) -> String {
        let tick = |Mark { place, label }: &Mark| {
            let (y, x) = (number(self.height(*place)), number(LEFT - 6.0));
            format!(
                "<path class=\"grid\" d=\"M{LEFT} {y}H{RIGHT}\"/>\
                 <text x=\"{x}\" y=\"{y}\" dy=\".35em\" text-anchor=\"end\">{label}</text>"
            )
        };
        let ticks: String = self.values.marks.iter().map(tick).collect();
        ticks + &text(LEFT, self.top - 6.0, "start", &self.values.note)
    }

    fn time_axis(&self) -> String {
        let tick = |Mark { place, label }: &Mark| {
            let at = x(if self.is_backwards() { 1.0 - place } else { *place });
            let label = text(at, BOTTOM + 18.0, "middle", label);
            format!("<path class=\"axis\" d=\"M{} {BOTTOM}v4\"/>{label}", number(at))
        };
        let ticks: String = self.time.marks.iter().map(tick).collect();
        let name = text(x(0.5), BOTTOM + 38.0, "middle", TIME);
        let note = text(RIGHT, BOTTOM + 38.0, "end", &self.time.note);
        format!("<path class=\"axis\" d=\"M{LEFT} {}V{BOTTOM}H{RIGHT}\"/>{ticks}{name}{note}", self.top)
    }

    /// Returns a curve that connects adjacent finite values.
    fn curve(&self, (index, curve): (usize, &Curve)) -> String {
        let mut data = String::new();
        let mut command = 'M';
        for (time, value) in self.timeline.times.iter().zip(&curve.values) {
            if value.is_finite() {
                data += &format!("{command}{} {}", number(self.x(*time)), number(self.y(*value)));
            }
            command = if value.is_finite() { 'L' } else { 'M' };
        }
        format!("<path class=\"curve {}\" d=\"{data}\"/>", look(index))
    }

    fn cursor(&self) -> String {
        let at = |(index, curve): (usize, &Curve)| {
            let value = curve.values.first().filter(|value| value.is_finite());
            let (y, hidden) = match value {
                Some(value) => (self.y(*value), ""),
                None => (BOTTOM, " visibility=\"hidden\""),
            };
            format!("<circle class=\"{}\" r=\"4\" cy=\"{}\"{hidden}/>", look(index), number(y))
        };
        let dots: String = self.timeline.curves.iter().enumerate().map(at).collect();
        format!(
            "<g id=\"cursor\" transform=\"translate({LEFT} 0)\"><path d=\"M0 {}V{BOTTOM}\"/>{dots}</g>",
            self.top
        )
    }

    fn is_backwards(&self) -> bool {
        self.timeline.times.first() > self.timeline.times.last()
    }

    /// Returns the pixel of a time. Time always runs to the right.
    fn x(&self, time: f64) -> f64 {
        let place = self.time.place(time);
        x(if self.is_backwards() { 1.0 - place } else { place })
    }

    fn y(&self, value: f64) -> f64 {
        self.height(self.values.place(value))
    }

    /// Returns the pixel of a place on the axis of values.
    fn height(&self, place: f64) -> f64 {
        BOTTOM - place * (BOTTOM - self.top)
    }
}

/// Returns the pixel of a place on the axis of time.
fn x(place: f64) -> f64 {
    LEFT + place * (RIGHT - LEFT)
}

/// Returns a text anchored at a point; it is empty if the text is empty.
fn text(x: f64, y: f64, anchor: &str, text: &str) -> String {
    if text.is_empty() {
        return String::new();
    }
    format!("<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{text}</text>", number(x), number(y))
}

/// Returns the class for the colour and dashes of a curve. The number of classes in `page.css` is
/// limited.
pub(super) fn look(index: usize) -> String {
    format!("curve-{}", index % LOOKS)
}
