//! The plot under the picture of a page: curves over time, and a cursor that the page's script moves.

use std::ops::Range;

use crate::timeline::Curve;
use crate::timeline::Timeline;
use lagrange_plot::characters::escaped;
use lagrange_plot::characters::number;

/// Width and height, in pixels.
const SIZE: [f64; 2] = [640.0, 300.0];
/// Left edge of the curves.
const LEFT: f64 = 64.0;
const RIGHT: f64 = 628.0;
const TOP: f64 = 12.0;
const BOTTOM: f64 = 256.0;
/// Label of the time axis.
const TIME: &str = "time t in s";
/// About how many ticks an axis has.
const TICKS: f64 = 6.0;
/// Number of colours for curves.
const LOOKS: usize = 6;
/// Curves whose values differ by a smaller part of them than this are shown as level, not as rounding.
const LEVEL: f64 = 1e-6;

/// A plot of curves over time.
pub(super) struct Chart<'a> {
    timeline: &'a Timeline,
    values: Range<f64>,
}

impl Chart<'_> {
    /// The plot of a film's curves; none if there is nothing to plot.
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
        Some(Chart { timeline, values: low - margin..high + margin })
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
        let Range { start: low, end: high } = self.values;
        format!(
            "{{\"left\":{LEFT},\"right\":{RIGHT},\"top\":{TOP},\"bottom\":{BOTTOM},\"low\":{low:e},\"high\":{high:e}}}"
        )
    }

    fn value_axis(&self) -> String {
        let tick = |(value, label): &(f64, String)| {
            let (y, x) = (number(self.y(*value)), number(LEFT - 6.0));
            format!(
                "<path class=\"grid\" d=\"M{LEFT} {y}H{RIGHT}\"/>\
                 <text x=\"{x}\" y=\"{y}\" dy=\".35em\" text-anchor=\"end\">{label}</text>"
            )
        };
        ticks(&self.values).iter().map(tick).collect()
    }

    fn time_axis(&self) -> String {
        let (start, end) = self.ends();
        let tick = |(time, label): &(f64, String)| {
            let x = number(self.x(*time));
            format!(
                "<path class=\"axis\" d=\"M{x} {BOTTOM}v4\"/>\
                 <text x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
                number(BOTTOM + 18.0)
            )
        };
        let ticks: String = ticks(&(start.min(end)..start.max(end))).iter().map(tick).collect();
        let (middle, below) = (number(0.5 * (LEFT + RIGHT)), number(BOTTOM + 38.0));
        format!(
            "<path class=\"axis\" d=\"M{LEFT} {TOP}V{BOTTOM}H{RIGHT}\"/>{ticks}\
             <text x=\"{middle}\" y=\"{below}\" text-anchor=\"middle\">{TIME}</text>"
        )
    }

    /// Neighbours that are finite are joined.
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
            "<g id=\"cursor\" transform=\"translate({LEFT} 0)\"><path d=\"M0 {TOP}V{BOTTOM}\"/>{dots}</g>"
        )
    }

    fn ends(&self) -> (f64, f64) {
        let times = &self.timeline.times;
        (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0))
    }

    /// Time always runs to the right.
    fn x(&self, time: f64) -> f64 {
        let (start, end) = self.ends();
        let part = if end == start { 0.0 } else { (time - start) / (end - start) };
        LEFT + part * (RIGHT - LEFT)
    }

    fn y(&self, value: f64) -> f64 {
        let Range { start, end } = self.values;
        BOTTOM - (value - start) / (end - start) * (BOTTOM - TOP)
    }
}

/// The class of a curve's colour and dashes, of which `page.css` has some.
pub(super) fn look(index: usize) -> String {
    format!("curve-{}", index % LOOKS)
}

/// Round numbers in a range and how they are written: multiples of 1, 2 or 5 times a power of ten.
fn ticks(range: &Range<f64>) -> Vec<(f64, String)> {
    let rough = (range.end - range.start) / TICKS;
    if !(rough > 0.0 && rough.is_finite()) {
        return vec![(range.start, format!("{}", range.start))];
    }
    let exponent = rough.log10().floor() as i32;
    let power = 10f64.powi(exponent);
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * power >= rough).unwrap_or(10.0);
    let step = factor * power;
    let digits = usize::try_from(-step.log10().floor() as i32).unwrap_or(0);
    let is_plain = (-3..6).contains(&exponent);
    let label = |value: f64| {
        if is_plain {
            format!("{value:.digits$}")
        } else if value == 0.0 {
            "0".into()
        } else {
            format!("{value:.1e}")
        }
    };
    let label = |value| label(value).replace('-', "−");
    let (first, last) = ((range.start / step).ceil() as i64, (range.end / step).floor() as i64);
    (first..=last).map(|index| index as f64 * step).map(|value| (value, label(value))).collect()
}

#[cfg(test)]
mod tests {
    use super::ticks;

    #[test]
    fn ticks_are_round_numbers_within_their_range() {
        let labels = |range| ticks(&range).into_iter().map(|(_, label)| label).collect::<Vec<_>>();
        assert_eq!(labels(0.0..6.0), ["0", "1", "2", "3", "4", "5", "6"]);
        assert_eq!(labels(-0.12..0.11), ["−0.10", "−0.05", "0.00", "0.05", "0.10"]);
        assert_eq!(labels(90.0..1100.0), ["200", "400", "600", "800", "1000"]);
        assert_eq!(labels(0.0..3e-7), ["0", "5.0e−8", "1.0e−7", "1.5e−7", "2.0e−7", "2.5e−7", "3.0e−7"]);
    }
}
