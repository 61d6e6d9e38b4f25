//! Items to draw as plain data, and the expressions that place them.

use crate::model::{BodyMotion, OutlinedPart, Scene};
use lagrange_algebra::program::Program;
use lagrange_expr::expr::ExprId;
use lagrange_language::bodies::DrawnKind;

/// All items to draw, loads included.
#[derive(Clone, Debug)]
pub struct DrawnScene {
    /// True if vectors have three components.
    pub is_in_space: bool,
    /// Items in drawing order.
    pub items: Vec<PlacedItem>,
    /// Program for the consecutive numbers of all items.
    pub program: Program,
}

/// An item; its kind determines its numbers.
///
/// The numbers of a body are its centroid in its own coordinates, its centre, and its angle or, in
/// space, its rotation in rows. The numbers of its parts follow: dimensions, position, and angle or
/// rotation.
#[derive(Clone, Debug)]
pub struct PlacedItem {
    /// Kind of the item.
    pub kind: DrawnKind,
    /// Name of a body; empty for other items, whose kinds have the name.
    pub body: String,
    /// Parts of a body's shape.
    pub parts: Vec<PlacedPart>,
}

/// A part of a body's shape.
#[derive(Clone, PartialEq, Debug)]
pub struct PlacedPart {
    /// Variant of `lagrange::scene::Outline`, or in space of `lagrange::scene::Solid`.
    pub variant: &'static str,
    /// True if the dimensions are corners, with two numbers each.
    pub has_corners: bool,
    /// Number of dimensions.
    pub dimension_count: usize,
    /// True if the part is cut out.
    pub is_hole: bool,
}

/// Returns the items of a scene, and their expressions.
pub(super) fn placed_items(scene: &Scene, is_in_space: bool) -> (Vec<PlacedItem>, Vec<ExprId>) {
    let (mut items, mut roots) = (Vec::new(), Vec::new());
    for item in &scene.drawing {
        let motion = match item.kind {
            DrawnKind::Body { body, .. } => scene.motions.get(body),
            _ => None,
        };
        roots.extend(motion.into_iter().flat_map(|motion| pose(motion, is_in_space)));
        roots.extend(&item.values);
        roots.extend(item.parts.iter().flat_map(|part| &part.values));
        let body = motion.map(|motion| motion.body.text.clone()).unwrap_or_default();
        let parts = item.parts.iter().map(placed_part).collect();
        items.push(PlacedItem { kind: item.kind.clone(), body, parts });
    }
    (items, roots)
}

/// Returns the centroid, centre, and angle or rotation of a body.
fn pose(motion: &BodyMotion, is_in_space: bool) -> &[ExprId] {
    // Mass and moment of inertia precede these values, rates follow.
    &motion.values[if is_in_space { 10..25 } else { 2..7 }]
}

fn placed_part(part: &OutlinedPart) -> PlacedPart {
    let &OutlinedPart { variant, has_corners, dimension_count, is_hole, .. } = part;
    PlacedPart { variant, has_corners, dimension_count, is_hole }
}
