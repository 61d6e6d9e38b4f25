//! The window of a film: the visible part of the world and its scale.

use crate::element::{Measure, Reach};
use crate::error::DrawError;
use crate::geometry::{bounds, clipped, mix, subtract, times};
use crate::picture::Point;

/// Free margin at the borders.
pub(super) const MARGIN: f64 = 12.0;
/// Minimum distance of labels and titles from the borders.
pub(super) const BORDER: f64 = 2.0;

/// A map from the world to pixels, with the same scale in both directions.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct View {
    /// Pixels per unit of length.
    scale: f64,
    /// A point of the world, whose pixel is `origin`. Subtracting it first preserves the digits of
    /// nearby numbers.
    base: Point,
    origin: Point,
    /// Corners of the drawing area in pixels.
    pub(super) window: [Point; 2],
    /// Pixels per unit of velocity, acceleration and force.
    pub(super) arrows: [f64; 3],
}

/// Halvings of the range of scales.
const ROUNDS: usize = 60;
/// Fraction of the smaller side per unit of length if everything shown is at one point.
const UNIT: f64 = 0.25;
/// Minimum width of a window in units of the spacing of neighbouring numbers, so that positions in
/// it are distinct.
const NEIGHBOURS: f64 = 4096.0;
/// Extent below which reciprocals overflow.
const TINY: f64 = 1e-300;

impl View {
    /// Creates the view with the largest scale at which everything fits in the window, centred.
    pub(super) fn new(window: [Point; 2], arrows: [f64; 3], reaches: &[Reach]) -> Result<Self, DrawError> {
        let size = subtract(window[1], window[0]);
        let [low, high] = bounds(reaches.iter().map(|reach| reach.at));
        let extent = subtract(high, low).into_iter().fold(0.0, f64::max);
        let farthest = [low, high].as_flattened().iter().map(|x| x.abs()).fold(0.0, f64::max);
        let [smaller, larger] = [size[0].min(size[1]), size[0].max(size[1])];
        let widest = if extent > 0.0 { larger / extent.max(TINY) } else { UNIT * smaller };
        let most = widest.min(larger / (NEIGHBOURS * f64::EPSILON * farthest).max(TINY));
        let base = mix(low, high, 0.5);
        let from_base = |reach: &Reach| Reach { at: subtract(reach.at, base), ..*reach };
        let reaches: Vec<Reach> = reaches.iter().map(from_base).collect();
        let reaches = &reaches[..];
        let fits = |scale: f64| {
            (0..2).all(|axis| {
                let [low, high] = range(reaches, axis, scale);
                high - low <= size[axis]
            })
        };
        if reaches.is_empty() {
            return Err(DrawError::NothingToDraw);
        }
        let scale = largest(most, fits).ok_or(DrawError::Size(size))?;
        let middle = |axis: usize| {
            let [low, high] = range(reaches, axis, scale);
            0.5 * (low + high)
        };
        let of_window = [0, 1].map(|axis| 0.5 * (window[0][axis] + window[1][axis]));
        let origin = [of_window[0] - middle(0), of_window[1] + middle(1)];
        Ok(View { scale, base, origin, window, arrows })
    }

    pub(super) fn point(&self, p: Point) -> Point {
        let [x, y] = subtract(p, self.base);
        [self.origin[0] + self.scale * x, self.origin[1] - self.scale * y]
    }

    /// Converts a length to pixels.
    pub(super) fn length(&self, length: f64) -> f64 {
        self.scale * length
    }

    /// Converts pixels to a length of the world.
    pub(super) fn of_pixels(&self, pixels: f64) -> f64 {
        pixels / self.scale
    }

    /// Converts a vector to pixels, y downwards.
    pub(super) fn vector(&self, vector: Point, measure: Measure) -> Point {
        let [x, y] = times(self.pixels(measure), vector);
        [x, -y]
    }

    pub(super) fn pixels(&self, measure: Measure) -> f64 {
        match measure {
            Measure::World => self.scale,
            Measure::Pixels => 1.0,
            Measure::Velocity => self.arrows[0],
            Measure::Acceleration => self.arrows[1],
            Measure::Force => self.arrows[2],
        }
    }

    /// Returns the part of a segment in pixels inside the window.
    pub(super) fn clipped(&self, ends: [Point; 2]) -> Option<[Point; 2]> {
        clipped(ends, self.window)
    }

    pub(super) fn holds(&self, p: Point) -> bool {
        (0..2).all(|axis| (self.window[0][axis]..=self.window[1][axis]).contains(&p[axis]))
    }
}

/// Returns the range of an axis in pixels at a scale.
fn range(reaches: &[Reach], axis: usize, scale: f64) -> [f64; 2] {
    reaches.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], reach| {
        let at = scale * reach.at[axis] + reach.offset[axis];
        [low.min(at - reach.room), high.max(at + reach.room)]
    })
}

/// Returns the largest number up to a limit that fits, or none if even zero does not.
fn largest(most: f64, fits: impl Fn(f64) -> bool) -> Option<f64> {
    if !most.is_finite() || most <= 0.0 || !fits(0.0) {
        return None;
    }
    let (mut low, mut high) = (0.0, most);
    for _ in 0..ROUNDS {
        let middle = 0.5 * (low + high);
        if fits(middle) { low = middle } else { high = middle }
    }
    (low > 0.0).then_some(low)
}

#[cfg(test)]
mod tests {
    use super::View;
    use crate::element::Reach;
    use crate::error::DrawError;

    const WINDOW: [[f64; 2]; 2] = [[0.0, 0.0], [200.0, 100.0]];

    fn reach(at: [f64; 2], offset: [f64; 2], room: f64) -> Reach {
        Reach { at, offset, room }
    }

    #[test]
    fn everything_fits_and_nothing_could_be_larger() {
        let reaches = [reach([-1.0, 0.0], [0.0, 0.0], 10.0), reach([1.0, 0.5], [20.0, 0.0], 10.0)];
        let view = View::new(WINDOW, [0.0; 3], &reaches).expect("fits");
        let [left, right] = [view.point([-1.0, 0.0])[0] - 10.0, view.point([1.0, 0.5])[0] + 30.0];
        assert!(left.abs() < 1e-9 && (right - 200.0).abs() < 1e-9, "{left} {right}");
        let [top, bottom] = [view.point([1.0, 0.5])[1], view.point([-1.0, 0.0])[1]];
        assert!((top + bottom - 100.0).abs() < 1e-9, "in the middle of the height");
    }

    #[test]
    fn a_single_place_is_in_the_middle() {
        let view = View::new(WINDOW, [0.0; 3], &[reach([3.0, 4.0], [0.0, 0.0], 5.0)]).expect("fits");
        assert_eq!(view.point([3.0, 4.0]), [100.0, 50.0]);
    }

    #[test]
    fn places_far_from_the_origin_are_where_they_are_seen() {
        let reaches = [[1e12, 3e12], [1e12 + 8.0, 3e12]].map(|at| reach(at, [0.0, 0.0], 10.0));
        let view = View::new(WINDOW, [0.0; 3], &reaches).expect("fits");
        let [left, right] = reaches.each_ref().map(|reach| view.point(reach.at));
        assert!((left[0] - 10.0).abs() < 1e-9 && (right[0] - 190.0).abs() < 1e-9, "{left:?} {right:?}");
        assert_eq!([left[1], right[1]], [50.0, 50.0]);
    }

    #[test]
    fn a_window_is_never_narrower_than_what_numbers_can_tell_apart() {
        let near = 1e9_f64.next_up();
        for places in
            [[[1e300, 1e300]; 2], [[1e9, 0.0], [near, 0.0]], [[5e-324, 0.0], [0.0, 0.0]], [[-1e9, 1e9]; 2]]
        {
            let view =
                View::new(WINDOW, [0.0; 3], &places.map(|at| reach(at, [0.0, 0.0], 5.0))).expect("fits");
            let points = places.map(|at| view.point(at));
            assert!(
                points.iter().all(|p| (p[0] - 100.0).abs() < 1.0 && (p[1] - 50.0).abs() < 1.0),
                "{points:?}"
            );
        }
        let ends = [[1e9, 0.0], [1e9 + 1.0, 0.0]].map(|at| reach(at, [0.0, 0.0], 5.0));
        let view = View::new(WINDOW, [0.0; 3], &ends).expect("fits");
        assert!((view.point([1e9, 0.0])[0] - 5.0).abs() < 1e-6, "what can be told apart is as large as ever");
    }

    #[test]
    fn what_needs_more_pixels_than_there_are_is_refused() {
        let result = View::new(WINDOW, [0.0; 3], &[reach([0.0, 0.0], [0.0, 0.0], 60.0)]);
        assert!(matches!(result, Err(DrawError::Size(_))), "{result:?}");
        assert!(matches!(View::new(WINDOW, [0.0; 3], &[]), Err(DrawError::NothingToDraw)));
    }
}
