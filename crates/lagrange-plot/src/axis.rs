//! Axes: their ranges, the places of their marks, and their labels.

use crate::notation::raised;

/// The scale of an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Scale {
    /// Equal distances for equal differences.
    #[default]
    Linear,
    /// Equal distances for equal ratios; zero is placed at the lower end.
    Logarithmic,
}

/// An axis from its lower to its upper end.
#[derive(Clone, PartialEq, Debug)]
pub struct Axis {
    scale: Scale,
    /// Decimal logarithms on a logarithmic axis.
    from: f64,
    to: f64,
    /// Its marks, from the lower to the upper end.
    pub marks: Vec<Mark>,
    /// Factor and offset shared by all labels.
    pub note: String,
}

/// A label and its position: 0 at the lower end, 1 at the upper end.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark {
    /// Its position.
    pub place: f64,
    /// Its label.
    pub label: String,
}

/// Minimum range of an axis relative to its values, so that rounding errors do not fill the axis.
const LEAST_SPAN: f64 = 3e-14;
/// Range on both sides of zero if all values are zero.
const ZERO_SPAN: f64 = 1.0;
/// Range of numbers with plain labels. Labels of other numbers have a common power of ten next to
/// the axis.
const PLAIN: core::ops::Range<f64> = 1e-3..1e5;
/// If labels would differ only after this many digits, most of the number is written next to the
/// axis.
const DIGITS: f64 = 1e6;

impl Axis {
    /// Creates an axis for values in this range, with relative room at both ends and about this
    /// number of marks.
    pub fn new(scale: Scale, range: Option<(f64, f64)>, room: f64, marks: u32) -> Self {
        match scale {
            Scale::Linear => linear(range.unwrap_or((0.0, 1.0)), room, marks),
            Scale::Logarithmic => logarithmic(range.unwrap_or((0.1, 1.0)), marks),
        }
    }

    /// Creates an axis for the finite values; a logarithmic axis only includes positive ones.
    pub fn over(scale: Scale, values: impl Iterator<Item = f64>, room: f64, marks: u32) -> Self {
        Axis::new(scale, range(scale, values), room, marks)
    }

    /// Creates an axis that ends at the smallest and the largest of the finite values; a
    /// logarithmic axis only includes positive ones.
    pub fn exact(scale: Scale, values: impl Iterator<Item = f64>, marks: u32) -> Self {
        match (scale, range(scale, values)) {
            (Scale::Logarithmic, Some((low, high))) if low < high => exact_logarithmic((low, high)),
            (_, range) => Axis::new(scale, range, 0.0, marks),
        }
    }

    /// Returns the values at both ends; on a logarithmic axis, their decimal logarithms.
    pub fn ends(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// Returns the position of a value; not finite if the value is not.
    pub fn place(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => (value - self.from) / (self.to - self.from),
            Scale::Logarithmic if value.is_nan() => value,
            Scale::Logarithmic => (value.log10().max(self.from) - self.from) / (self.to - self.from),
        }
    }
}

/// Returns the smallest and the largest of the values that an axis can show.
pub(crate) fn range(scale: Scale, values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let shown = values.filter(|value| value.is_finite() && (scale == Scale::Linear || *value > 0.0));
    shown.fold(None, |range, value| {
        let (low, high) = range.unwrap_or((value, value));
        Some((f64::min(low, value), f64::max(high, value)))
    })
}

fn linear((low, high): (f64, f64), room: f64, marks: u32) -> Axis {
    let size = low.abs().max(high.abs());
    let least = if size > 0.0 { LEAST_SPAN * size } else { ZERO_SPAN };
    let is_constant = high - low < least;
    let room = if is_constant { least } else { room * (high - low) };
    let (from, to) = (low - room, high + room);
    let step = nice((to - from) / f64::from(marks));
    let indices = (from / step).ceil()..=(to / step).floor();
    let ticks = std::iter::successors(Some(*indices.start()), |index| Some(index + 1.0));
    let ticks: Vec<f64> =
        ticks.take_while(|index| index <= indices.end()).map(|index| index * step).collect();
    let (labels, note) = labels(&ticks, step);
    let place = |tick: f64| (tick - from) / (to - from);
    let marks = ticks.iter().zip(labels).map(|(tick, label)| Mark { place: place(*tick), label }).collect();
    Axis { scale: Scale::Linear, from, to, marks, note }
}

fn logarithmic((low, high): (f64, f64), marks: u32) -> Axis {
    let from = low.log10().floor();
    let to = high.log10().ceil().max(from + 1.0);
    let step = ((to - from) / f64::from(marks)).ceil().max(1.0);
    let powers =
        std::iter::successors(Some(from), |power| Some(power + step)).take_while(|power| *power <= to);
    let mark = |power: f64| Mark { place: (power - from) / (to - from), label: power_of_ten(power) };
    Axis { scale: Scale::Logarithmic, from, to, marks: powers.map(mark).collect(), note: String::new() }
}

/// Creates an axis whose ends need not be powers of ten. Marks are at powers of ten and, if these
/// are few, also at 2 and 5 times each power.
fn exact_logarithmic((low, high): (f64, f64)) -> Axis {
    let (from, to) = (low.log10(), high.log10());
    let powers: Vec<f64> = std::iter::successors(Some(from.floor()), |power| Some(power + 1.0))
        .take_while(|power| *power <= to)
        .collect();
    let step = (powers.len() / 8).max(1);
    let factors: &[f64] = if powers.len() < 5 { &[1.0, 2.0, 5.0] } else { &[1.0] };
    let ticks = powers.iter().step_by(step).flat_map(|power| factors.iter().map(|factor| (*power, *factor)));
    let mark = |(power, factor): (f64, f64)| {
        let place = (power + factor.log10() - from) / (to - from);
        let value = factor * 10_f64.powf(power);
        let label = match factor {
            _ if PLAIN.contains(&value) => format!("{value:.*}", (-power).max(0.0) as usize),
            1.0 => power_of_ten(power),
            _ => format!("{factor}×{}", power_of_ten(power)),
        };
        Mark { place, label }
    };
    let marks = ticks.map(mark).filter(|mark| (0.0..=1.0).contains(&mark.place)).collect();
    Axis { scale: Scale::Logarithmic, from, to, marks, note: String::new() }
}

/// Returns the smallest of 1, 2, 5 times a power of ten that is not below `step`.
fn nice(step: f64) -> f64 {
    let power = 10_f64.powf(step.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * power >= step * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

/// Returns the labels of ticks with this spacing, and the note next to the axis.
fn labels(ticks: &[f64], step: f64) -> (Vec<String>, String) {
    let largest = |offset: f64| ticks.iter().fold(0.0_f64, |most, tick| most.max((tick - offset).abs()));
    let offset =
        if largest(0.0) < DIGITS * step { 0.0 } else { ticks.get(ticks.len() / 2).copied().unwrap_or(0.0) };
    let offset = round_to(offset, 100.0 * step);
    let largest = largest(offset);
    let exponent =
        if largest == 0.0 || PLAIN.contains(&largest) { 0.0 } else { (largest * 1.000_001).log10().floor() };
    let decimals = (exponent - (step * 1.000_001).log10().floor()).max(0.0) as usize;
    let label = |tick: &f64| {
        let value = (tick - offset) / 10_f64.powf(exponent);
        minus(&if (tick - offset).abs() < 1e-6 * step {
            "0".to_string()
        } else {
            format!("{value:.decimals$}")
        })
    };
    let factor = if exponent == 0.0 { String::new() } else { format!("×{}", power_of_ten(exponent)) };
    let sign = if offset < 0.0 { "− " } else { "+ " };
    let shift = if offset == 0.0 { String::new() } else { format!("{sign}{}", offset.abs()) };
    let note = [factor, shift].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ");
    (ticks.iter().map(label).collect(), note)
}

fn round_to(value: f64, unit: f64) -> f64 {
    (value / unit).round() * unit
}

/// Replaces the hyphen with a minus sign, which is as wide as a plus sign.
fn minus(number: &str) -> String {
    number.replace('-', "−")
}

fn power_of_ten(exponent: f64) -> String {
    let digits: String = format!("{exponent:.0}").chars().map(raised).collect();
    format!("10{digits}")
}
