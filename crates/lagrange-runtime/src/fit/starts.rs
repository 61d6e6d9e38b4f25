//! Points from which to search for minima.

use std::vec::Vec;

use crate::spread::spread;

/// Without a bound, starts are within this factor of a nonzero value.
const DECADE: f64 = 10.0;
/// Without a bound, starts are within this distance of a value of zero.
const UNIT: f64 = 1.0;

/// Returns points between bounds; the first point is these values. Points are computed as searches
/// begin: many starts do not delay the first.
pub(super) fn starts(values: &[f64], bounds: &[(f64, f64)], count: usize) -> impl Iterator<Item = Vec<f64>> {
    let point = move |index: usize| {
        let places = values.iter().zip(bounds).enumerate();
        let part = |place: usize| 0.5 + 0.5 * spread::<f64>(index, place);
        places.map(|(place, (value, bounds))| within(*value, *bounds, part(place))).collect()
    };
    (0..count.max(1)).map(move |index| if index == 0 { values.to_vec() } else { point(index) })
}

/// Returns the point at a fraction of the way between the bounds. Between bounds of one sign parts
/// are those of logarithms if the larger is more than ten times the smaller.
fn within(value: f64, (low, high): (f64, f64), part: f64) -> f64 {
    let (near, far) = match value {
        0.0 => (-UNIT, UNIT),
        _ if value > 0.0 => (value / DECADE, value * DECADE),
        _ => (value * DECADE, value / DECADE),
    };
    let low = if low.is_finite() { low } else { near.min(high) };
    let high = if high.is_finite() { high } else { far.max(low) };
    let is_wide = low * high > 0.0 && !(1.0 / DECADE..=DECADE).contains(&(low / high));
    if is_wide { low * (high / low).powf(part) } else { low + part * (high - low) }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::starts;

    #[test]
    fn points_lie_between_the_bounds_and_in_every_quarter() {
        let bounds = [(0.0, 1.0), (1e-3, 1e3)];
        let points = starts(&[0.2, 1.0], &bounds, 17).collect::<Vec<_>>();
        assert_eq!(points[0], [0.2, 1.0]);
        let mut quarters = [0; 4];
        for point in &points[1..] {
            assert!(point.iter().zip(bounds).all(|(x, (low, high))| (low..=high).contains(x)));
            quarters[usize::from(point[0] > 0.5) + 2 * usize::from(point[1] > 1.0)] += 1;
        }
        assert!(quarters.iter().all(|count| *count >= 2), "{quarters:?}");
    }

    #[test]
    fn without_bounds_points_are_within_a_decade() {
        for point in starts(
            &[2.0, -3.0, 0.0],
            &[(0.0, f64::INFINITY), (f64::NEG_INFINITY, -1.0), (f64::NEG_INFINITY, f64::INFINITY)],
            20,
        ) {
            assert!(
                (0.0..=20.0).contains(&point[0])
                    && (-30.0..=-1.0).contains(&point[1])
                    && point[2].abs() <= 1.0
            );
        }
    }
}
