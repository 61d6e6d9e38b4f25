//! Contacts on terrain z = h(x, y), in the plane y = h(x), in coordinates of its carrier.
//!
//! Terrain has the normal n = (−∇h, 1)/w with w = √(1 + |∇h|²). A ball of radius r about c touches
//! at the foot f with c = f + r n. In x and y, this is the equation f − r ∇h/w = c of the foot of
//! any c, near and far. Without a radius, the foot is directly below c. The gap is the height of c
//! over that of a touching ball, (c_z − h − r/w)/w. It is exact to first order in the gap, and so
//! is its gradient, which is n where the ball touches.
//!
//! A ball fits where 1 − r κ is positive for both curvatures κ at its foot, the eigenvalues of the
//! Jacobian of the equation. A ball that is too large for a hollow would touch at two points.
//! There, one of the equations has no solution, and the gap is NaN.
//!
//! In the plane, Newton's method takes full steps, starting below c. Each step approaches the foot
//! if the values of 1 − r κ on the way differ by less than a factor of two. This is true on ridges
//! that are blunter than the ball. On sharper ones, the method may fail, and the gap is NaN
//! although the foot is unique. In space, steps are damped.
//!
//! On h = x²/2, a ball of radius √2 touches at the foot x = 1 where its centre is (0, 3/2).
//!
//! Source: do Carmo, *Differential Geometry of Curves and Surfaces*, 2nd ed., §3.5, exercise 11, on
//! parallel surfaces.

use super::geometry::{ContactGeometry, tangents_at};
use crate::bodies::object::{Height, Surface};
use crate::bodies::space::vectors::{Triple, inner, minus, scale};
use crate::bodies::surfaces::bind_vector;
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId, StatementKind, UnknownDefinition};

/// The foot of a ball, given by names of its coordinates, with the slopes there.
struct Foot {
    coordinates: Vec<AstId>,
    slopes: Vec<AstId>,
    /// √(1 + |∇h|²)
    steepness: AstId,
}

/// Computes gap, normal and tangents at a point with a radius over terrain.
pub(super) fn over_terrain(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    (surface, height): (&Surface, &Height),
    (center, radius): (Triple, AstId),
) -> ContactGeometry {
    let name = &statement.name.text;
    let axes = &surface.tangents[..height.coordinates.len()];
    let mut terms = translation.terms();
    let arm = minus(&mut terms, center, surface.place);
    let level = inner(&mut terms, surface.direction, arm);
    let over = axes.iter().map(|&axis| inner(&mut terms, axis, arm)).collect::<Vec<_>>();
    let over = ["x", "y"].iter().zip(over);
    let over = over.map(|(axis, value)| translation.bind(&format!("{name}_{axis}"), value));
    let over = over.collect::<Vec<_>>();
    let coordinates = match translation.terms().is_zero(radius) {
        true => over,
        false => foot_of_ball(translation, name, height, (&over, radius)),
    };
    let foot = with_slopes(translation, name, height, coordinates);
    let gap = gap_over(translation, height, &foot, (level, radius));
    let normal = normal_at(&mut translation.terms(), &foot, (surface.direction, axes));
    let normal = bind_vector(translation, &format!("{name}_normal"), normal);
    let is_spatial = translation.space.is_some();
    let tangents = tangents_at(&mut translation.terms(), is_spatial, normal);
    let rising = rising(translation, surface, height, &foot);
    ContactGeometry { center, radius, gap, normal, tangents, rising }
}

/// Returns (c_z − h − r/w)/w.
fn gap_over(
    translation: &mut Translation<'_>,
    height: &Height,
    foot: &Foot,
    (level, radius): (AstId, AstId),
) -> AstId {
    let ground = height_at(translation, height, &foot.coordinates);
    let mut terms = translation.terms();
    let lift = terms.divide(radius, foot.steepness);
    let above = terms.minus(level, ground);
    let above = terms.minus(above, lift);
    terms.divide(above, foot.steepness)
}

/// Returns (−∇h, 1)/w in the world.
fn normal_at(terms: &mut TermWriter<'_>, foot: &Foot, (up, axes): (Triple, &[Triple])) -> Triple {
    let mut normal = up;
    for (&slope, &axis) in foot.slopes.iter().zip(axes) {
        let back = scale(terms, slope, axis);
        normal = minus(terms, normal, back);
    }
    normal.map(|component| terms.divide(component, foot.steepness))
}

/// Adds the equation of the foot of a ball; returns the names of its coordinates.
fn foot_of_ball(
    translation: &mut Translation<'_>,
    name: &str,
    height: &Height,
    (over, radius): (&[AstId], AstId),
) -> Vec<AstId> {
    let names = ["foot_x", "foot_y"].iter().take(over.len());
    let names = names.map(|part| translation.new_name(&format!("{name}_{part}"))).collect::<Vec<_>>();
    let mut mentioned = || names.iter().map(|name| translation.terms().name(&name.text)).collect::<Vec<_>>();
    // The unknowns in their equations, and their values after these.
    let (foot, solved) = (mentioned(), mentioned());
    let slopes = slopes_at(translation, height, &foot);
    let steepness = steepness(translation, &slopes);
    let mut terms = translation.terms();
    let mut residuals = Vec::new();
    for ((&over, &foot), &slope) in over.iter().zip(&foot).zip(&slopes) {
        let aside = terms.minus(over, foot);
        let back = terms.times(radius, slope);
        let back = terms.divide(back, steepness);
        residuals.push(terms.plus(aside, back));
    }
    let fitting = fitting(&mut terms, &residuals, &foot);
    residuals[0] = terms.if_positive(fitting, residuals[0], radius);
    let (starts, iterations) = (over.to_vec(), None);
    translation.push(StatementKind::Solve(UnknownDefinition { names, residuals, starts, iterations }));
    solved
}

/// Returns a number that is positive if the Jacobian of the negative residuals has positive
/// eigenvalues.
fn fitting(terms: &mut TermWriter<'_>, residuals: &[AstId], foot: &[AstId]) -> AstId {
    let mut entry = |row: usize, column: usize| terms.call("partial", &[residuals[row], foot[column]]);
    if foot.len() == 1 {
        let slope = entry(0, 0);
        return terms.negative(slope);
    }
    let [[a, b], [c, d]] = [0, 1].map(|row| [0, 1].map(|column| entry(row, column)));
    let (trace, determinant) = (terms.plus(a, d), terms.cross([a, b], [c, d]));
    let trace = terms.negative(trace);
    terms.call("min", &[trace, determinant])
}

/// Names the slopes at a foot.
fn with_slopes(
    translation: &mut Translation<'_>,
    name: &str,
    height: &Height,
    coordinates: Vec<AstId>,
) -> Foot {
    let slopes = slopes_at(translation, height, &coordinates);
    let names = ["slope_x", "slope_y"].iter().zip(slopes);
    let slopes = names.map(|(part, slope)| translation.bind(&format!("{name}_{part}"), slope));
    let slopes = slopes.collect::<Vec<_>>();
    let steepness = steepness(translation, &slopes);
    let steepness = translation.bind(&format!("{name}_steepness"), steepness);
    Foot { coordinates, slopes, steepness }
}

fn height_at(translation: &mut Translation<'_>, height: &Height, foot: &[AstId]) -> AstId {
    translation.terms().with_values(height.value, &height.coordinates, foot)
}

fn slopes_at(translation: &mut Translation<'_>, height: &Height, foot: &[AstId]) -> Vec<AstId> {
    let slopes = foot.iter().map(|&by| {
        let value = height_at(translation, height, foot);
        translation.terms().call("partial", &[value, by])
    });
    slopes.collect()
}

fn steepness(translation: &mut Translation<'_>, slopes: &[AstId]) -> AstId {
    let mut terms = translation.terms();
    let mut sum = terms.number(1);
    for &slope in slopes {
        let square = terms.square(slope);
        sum = terms.plus(sum, square);
    }
    terms.call("sqrt", &[sum])
}

/// Returns the velocity at which time-dependent terrain rises: ∂h/∂t, which is ḣ − ∇h·ḟ.
fn rising(
    translation: &mut Translation<'_>,
    surface: &Surface,
    height: &Height,
    foot: &Foot,
) -> Option<Triple> {
    if height.is_fixed {
        return None;
    }
    let ground = height_at(translation, height, &foot.coordinates);
    let mut terms = translation.terms();
    let mut speed = terms.rate(ground);
    for (&slope, &coordinate) in foot.slopes.iter().zip(&foot.coordinates) {
        let rate = terms.rate(coordinate);
        let along = terms.times(slope, rate);
        speed = terms.minus(speed, along);
    }
    Some(scale(&mut terms, speed, surface.direction))
}
