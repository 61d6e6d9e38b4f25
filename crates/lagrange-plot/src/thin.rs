//! Reduction of a curve to distinguishable points.

use std::collections::BTreeSet;

/// Abscissa and ordinate.
pub(crate) type Point = (f64, f64);

/// Splits a curve at points that are not finite, and omits points that cannot be seen with this
/// line width.
///
/// For a curve over time, the first, the lowest, the highest and the last point within each column
/// remain, so that no extreme is lost. Other curves keep points in a different square than the
/// previous point. A segment that joins the same squares as an earlier one is omitted: where a
/// curve retraces itself, it is drawn once.
pub(crate) fn thin(points: impl Iterator<Item = Point>, width: f64) -> Vec<Vec<Point>> {
    let mut pieces = Vec::new();
    for piece in finite(points) {
        if piece.is_sorted_by(|a, b| a.0 <= b.0) || piece.is_sorted_by(|a, b| a.0 >= b.0) {
            pieces.push(by_columns(&piece, width));
        } else {
            by_squares(&piece, width, &mut pieces);
        }
    }
    pieces
}

/// Returns the finite pieces of a curve.
fn finite(points: impl Iterator<Item = Point>) -> Vec<Vec<Point>> {
    let mut pieces = Vec::from([Vec::new()]);
    for point in points {
        match pieces.last_mut() {
            Some(piece) if point.0.is_finite() && point.1.is_finite() => piece.push(point),
            _ => pieces.push(Vec::new()),
        }
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// Returns the interval of this width that contains a coordinate.
fn cell(coordinate: f64, width: f64) -> i64 {
    (coordinate / width).floor() as i64
}

/// Returns at most four points of each column.
fn by_columns(piece: &[Point], width: f64) -> Vec<Point> {
    let mut kept = Vec::new();
    for column in piece.chunk_by(|a, b| cell(a.0, width) == cell(b.0, width)) {
        let indices = || 0..column.len();
        let by_height = |a: &usize, b: &usize| column[*a].1.total_cmp(&column[*b].1);
        let extremes = [indices().min_by(by_height), indices().max_by(by_height)];
        let ends = [indices().next(), indices().next_back()];
        let wanted: BTreeSet<usize> = ends.into_iter().chain(extremes).flatten().collect();
        kept.extend(wanted.into_iter().map(|index| column[index]));
    }
    kept
}

/// Adds pieces in which no two segments join the same squares.
fn by_squares(piece: &[Point], width: f64, pieces: &mut Vec<Vec<Point>>) {
    let square = |point: &Point| (cell(point.0, width), cell(point.1, width));
    let mut seen = BTreeSet::new();
    let mut current: Vec<Point> = Vec::new();
    let mut last = None;
    for point in piece {
        let to = square(point);
        let Some((from, before)) = last.replace((to, *point)) else { continue };
        if from == to {
            // The previous point counts, so that squares are left from their entry points.
            last = Some((from, before));
        } else if seen.insert((from.min(to), from.max(to))) {
            if current.is_empty() {
                current.push(before);
            }
            current.push(*point);
        } else if !current.is_empty() {
            pieces.push(std::mem::take(&mut current));
        }
    }
    // A curve that stays within its square is a dot.
    if current.is_empty() && seen.is_empty() {
        current.extend(piece.first());
    }
    if !current.is_empty() {
        pieces.push(current);
    }
}
