//! Painter's algorithm: faces and lines from back to front, so that later ones hide those behind
//! them.
//!
//! The plane of a face divides all others into those on the side of the eye and those behind it,
//! which are painted first. Faces that intersect the plane are split. Both sides are then sorted in
//! the same way. An axis-aligned plane that separates objects without splitting any is preferred to
//! planes of faces. Visible faces of a convex body never hide each other, so their order is
//! irrelevant.
//!
//! Source: Fuchs, Kedem, Naylor, *On Visible Surface Generation by A Priori Tree Structures*,
//! SIGGRAPH 1980.

use super::camera::Camera;
use super::vector::Vector;
use crate::geometry::{add, dot, mix, subtract, times};

/// A face or a line in the world.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Fragment {
    pub(super) shape: FragmentShape,
    /// The index of the thing to which the fragment belongs.
    pub(super) thing: usize,
}

#[derive(Clone, PartialEq, Debug)]
pub(super) enum FragmentShape {
    /// A plane convex polygon, with flags for its drawn sides, and its unit normal.
    Face { corners: Vec<Vector>, drawn: Vec<bool>, normal: Vector },
    /// A straight line.
    Line([Vector; 2]),
}

/// Number of faces whose planes are tried.
const TRIED: usize = 6;
/// Penalty of splitting a piece relative to an uneven division.
const CUT: usize = 4;

/// A plane: n·r = d.
#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: Vector,
    distance: f64,
}

enum Task {
    Sort(Vec<Fragment>),
    Paint(Vec<Fragment>),
}

/// Sorts pieces; `is_convex` is true for each thing that is a convex body, and lengths below
/// `least` count as zero.
pub(super) fn back_to_front(
    pieces: Vec<Fragment>,
    camera: &Camera,
    is_convex: &[bool],
    least: f64,
) -> Vec<Fragment> {
    let mut painted = Vec::with_capacity(pieces.len());
    let mut tasks = vec![Task::Sort(pieces)];
    while let Some(task) = tasks.pop() {
        match task {
            Task::Paint(pieces) => painted.extend(pieces),
            Task::Sort(pieces) if is_in_order(&pieces, is_convex) => painted.extend(pieces),
            Task::Sort(pieces) => {
                let plane = separation(&pieces).or_else(|| best_plane(&pieces, least));
                let Some(plane) = plane else {
                    painted.extend(by_nearness(pieces, camera));
                    continue;
                };
                let count = pieces.len();
                let [front, within, behind] = divided(pieces, plane, least);
                let towards = camera.towards(times(plane.distance, plane.normal));
                let (near, far) =
                    if dot(plane.normal, towards) > 0.0 { (front, behind) } else { (behind, front) };
                // If faces are so thin that rounding moves them off their own planes, none of them
                // divides the others.
                if within.is_empty() && count <= near.len().max(far.len()) {
                    painted.extend(by_nearness(far, camera));
                    painted.extend(by_nearness(near, camera));
                    continue;
                }
                tasks.extend([Task::Sort(near), Task::Paint(within), Task::Sort(far)]);
            }
        }
    }
    painted
}

/// Sorts by the nearness of midpoints.
fn by_nearness(mut pieces: Vec<Fragment>, camera: &Camera) -> Vec<Fragment> {
    pieces.sort_by(|a, b| a.nearness(camera).total_cmp(&b.nearness(camera)));
    pieces
}

/// True if none of the pieces can hide another.
fn is_in_order(pieces: &[Fragment], is_convex: &[bool]) -> bool {
    let Some(first) = pieces.first() else { return true };
    pieces.len() == 1 || (is_convex[first.thing] && pieces.iter().all(|piece| piece.thing == first.thing))
}

/// Returns an axis-aligned plane with things on both sides and none across: the one that divides
/// them most evenly.
fn separation(pieces: &[Fragment]) -> Option<Plane> {
    let things = 1 + pieces.iter().map(|piece| piece.thing).max()?;
    let mut best: Option<(usize, Plane)> = None;
    for axis in 0..3 {
        let mut spans = vec![[f64::INFINITY, f64::NEG_INFINITY]; things];
        for piece in pieces {
            let [low, high] = &mut spans[piece.thing];
            for corner in piece.corners() {
                (*low, *high) = (low.min(corner[axis]), high.max(corner[axis]));
            }
        }
        spans.retain(|[low, high]| low <= high);
        spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut reached = f64::NEG_INFINITY;
        for (index, [low, high]) in spans.iter().enumerate() {
            let evenness = index.min(spans.len() - index);
            if index > 0 && *low > reached && best.is_none_or(|(most, _)| evenness > most) {
                let mut normal = [0.0; 3];
                normal[axis] = 1.0;
                best = Some((evenness, Plane { normal, distance: 0.5 * (low + reached) }));
            }
            reached = reached.max(*high);
        }
    }
    best.map(|(_, plane)| plane)
}

/// Returns the plane of a face that splits few others and divides them evenly; none if there are no
/// faces.
fn best_plane(pieces: &[Fragment], least: f64) -> Option<Plane> {
    let faces: Vec<Plane> = pieces.iter().filter_map(Fragment::plane).collect();
    let cost = |plane: &Plane| {
        let mut counts = [0; 3];
        for piece in pieces {
            let [above, below] = piece.sides(*plane, least);
            counts[0] += usize::from(above && !below);
            counts[1] += usize::from(below && !above);
            counts[2] += usize::from(above && below);
        }
        CUT * counts[2] + counts[0].abs_diff(counts[1])
    };
    faces.iter().step_by(faces.len().div_ceil(TRIED).max(1)).min_by_key(|plane| cost(plane)).copied()
}

/// Divides pieces into those on the side of the normal, in the plane, and on the other side.
fn divided(pieces: Vec<Fragment>, plane: Plane, least: f64) -> [Vec<Fragment>; 3] {
    let mut parts = [Vec::new(), Vec::new(), Vec::new()];
    for piece in pieces {
        match piece.sides(plane, least) {
            [false, false] => parts[1].push(piece),
            [true, false] => parts[0].push(piece),
            [false, true] => parts[2].push(piece),
            [true, true] => {
                let [above, below] = piece.cut(plane, least);
                parts[0].push(above);
                parts[2].push(below);
            }
        }
    }
    // Lines are in front of the faces in their plane.
    parts[1].sort_by_key(|piece| matches!(piece.shape, FragmentShape::Line(_)));
    parts
}

impl Plane {
    fn height(&self, place: Vector) -> f64 {
        dot(self.normal, place) - self.distance
    }
}

impl Fragment {
    pub(super) fn corners(&self) -> &[Vector] {
        match &self.shape {
            FragmentShape::Face { corners, .. } => corners,
            FragmentShape::Line(ends) => ends,
        }
    }

    fn plane(&self) -> Option<Plane> {
        match &self.shape {
            FragmentShape::Face { corners, normal, .. } => {
                Some(Plane { normal: *normal, distance: dot(*normal, corners[0]) })
            }
            FragmentShape::Line(_) => None,
        }
    }

    fn nearness(&self, camera: &Camera) -> f64 {
        let corners = self.corners();
        let middle = times(1.0 / corners.len() as f64, corners.iter().copied().fold([0.0; 3], add));
        camera.seen(middle).1
    }

    /// Returns true for a part above the plane, and for a part below.
    fn sides(&self, plane: Plane, least: f64) -> [bool; 2] {
        let mut sides = [false; 2];
        for corner in self.corners() {
            let height = plane.height(*corner);
            sides[0] |= height > least;
            sides[1] |= height < -least;
        }
        sides
    }

    /// Returns the parts above and below an intersecting plane.
    fn cut(self, plane: Plane, least: f64) -> [Fragment; 2] {
        let thing = self.thing;
        let shapes = match self.shape {
            FragmentShape::Face { corners, drawn, normal } => {
                let heights: Vec<f64> = corners.iter().map(|corner| plane.height(*corner)).collect();
                [1.0, -1.0].map(|sign| {
                    let heights = heights.iter().map(|height| sign * height).collect::<Vec<_>>();
                    let (corners, drawn) = clipped(&corners, &drawn, &heights, least);
                    FragmentShape::Face { corners, drawn, normal }
                })
            }
            FragmentShape::Line([a, b]) => {
                let heights = [a, b].map(|end| plane.height(end));
                let between = crossing([a, b], heights);
                let (above, below) = if heights[0] > 0.0 { (a, b) } else { (b, a) };
                [above, below].map(|end| FragmentShape::Line([end, between]))
            }
        };
        shapes.map(|shape| Fragment { shape, thing })
    }
}

/// Returns the part of a convex polygon at heights above zero. The side along the cut is not drawn.
fn clipped(corners: &[Vector], drawn: &[bool], heights: &[f64], least: f64) -> (Vec<Vector>, Vec<bool>) {
    let (mut kept, mut sides) = (Vec::new(), Vec::new());
    for (index, &is_drawn) in drawn.iter().enumerate() {
        let next = (index + 1) % corners.len();
        let ends = [index, next].map(|end| corners[end]);
        let at = [index, next].map(|end| heights[end]);
        if at[0] >= -least {
            kept.push(ends[0]);
            // The cut starts at a corner in the plane whose next corner is below it.
            sides.push(is_drawn && !(at[0] <= least && at[1] < -least));
        }
        if at[0].abs() > least && at[1].abs() > least && (at[0] > 0.0) != (at[1] > 0.0) {
            kept.push(crossing(ends, at));
            sides.push(is_drawn && at[1] > 0.0);
        }
    }
    (kept, sides)
}

/// Returns the zero of a line between two heights of opposite sign.
fn crossing([a, b]: [Vector; 2], [from, to]: [f64; 2]) -> Vector {
    debug_assert!(from != to, "a line along the plane does not cross it");
    mix(a, b, from / (from - to))
}

/// True if all corners are behind all faces, as for a convex body.
pub(super) fn is_convex(faces: &[(Vec<Vector>, Vector)], least: f64) -> bool {
    let corners = || faces.iter().flat_map(|(corners, _)| corners);
    faces
        .iter()
        .all(|(face, normal)| corners().all(|corner| dot(*normal, subtract(*corner, face[0])) <= least))
}

#[cfg(test)]
mod tests {
    use super::{Fragment, FragmentShape, back_to_front};
    use crate::geometry::{add, dot, length, subtract};
    use crate::look::Direction;
    use crate::space::camera::Camera;
    use crate::space::mesh::normal;
    use crate::space::vector::{Vector, cross};

    fn face(corners: Vec<Vector>, thing: usize) -> Fragment {
        let drawn = vec![true; corners.len()];
        let normal = normal(&corners).expect("has an area");
        Fragment { shape: FragmentShape::Face { corners, drawn, normal }, thing }
    }

    /// A multiplicative congruential generator: Park, Miller, *Random Number Generators: Good Ones
    /// Are Hard to Find* (1988).
    struct Random(u64);

    impl Random {
        fn number(&mut self) -> f64 {
            self.0 = self.0 * 48271 % 2_147_483_647;
            2.0 * self.0 as f64 / 2_147_483_647.0 - 1.0
        }

        fn vector(&mut self) -> Vector {
            [self.number(), self.number(), self.number()]
        }
    }

    /// Returns the distance along a ray towards the eye at which it meets a face.
    fn met(piece: &Fragment, from: Vector, ray: Vector) -> Option<f64> {
        let FragmentShape::Face { corners, normal, .. } = &piece.shape else { return None };
        let along = dot(*normal, subtract(corners[0], from)) / dot(*normal, ray);
        let at = [0, 1, 2].map(|k| from[k] + along * ray[k]);
        let is_left = |k: usize| {
            let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
            dot(cross(subtract(b, a), subtract(at, a)), *normal) > 1e-6
        };
        (0..corners.len()).all(is_left).then_some(along)
    }

    #[test]
    fn the_nearest_of_intersecting_triangles_is_painted_last() {
        let mut random = Random(7);
        for is_perspective in [false, true] {
            let camera = Camera::new(Direction { is_perspective, ..Direction::default() }, [0.0; 3], 2.0);
            let triangles: Vec<Fragment> = (0..40)
                .map(|thing| face(vec![random.vector(), random.vector(), random.vector()], thing))
                .collect();
            let sorted = back_to_front(triangles.clone(), &camera, &[false; 40], 1e-12);
            assert!(sorted.len() > 40, "they intersect");
            let mut seen = 0;
            for _ in 0..2000 {
                let from = random.vector();
                let ray = camera.towards(from);
                let hits = sorted.iter().filter_map(|piece| Some((met(piece, from, ray)?, piece.thing)));
                let hits: Vec<(f64, usize)> = hits.collect();
                let nearest = hits.iter().max_by(|a, b| a.0.total_cmp(&b.0));
                let whole = triangles.iter().filter_map(|piece| Some((met(piece, from, ray)?, piece.thing)));
                let whole = whole.max_by(|a, b| a.0.total_cmp(&b.0));
                if let (Some(last), Some(nearest), Some(whole)) = (hits.last(), nearest, whole) {
                    assert!((last.0 - nearest.0).abs() < 1e-6, "what is painted last is the nearest");
                    assert_eq!(last.1, whole.1, "and is what is the nearest of whole triangles");
                    seen += 1;
                }
            }
            assert!(seen > 500, "{seen} rays met something");
        }
    }

    #[test]
    fn faces_too_thin_for_their_planes_come_to_an_end() {
        let camera = Camera::new(Direction::default(), [0.0; 3], 1.0);
        let mut random = Random(11);
        let sliver = |thing: usize, random: &mut Random| {
            let [a, b, normal] = [random.vector(), random.vector(), random.vector()];
            let corners = vec![a, b, [b[0] + 1e-9, b[1], b[2]]];
            let shape = FragmentShape::Face { drawn: vec![true; 3], corners, normal };
            Fragment { shape, thing }
        };
        let pieces: Vec<Fragment> = (0..30).map(|thing| sliver(thing, &mut random)).collect();
        let area = |pieces: &[Fragment]| {
            let arms = |piece: &Fragment| {
                let from = |corner: Vector| subtract(corner, piece.corners()[0]);
                piece.corners().windows(2).map(|ends| cross(from(ends[0]), from(ends[1]))).collect::<Vec<_>>()
            };
            pieces.iter().map(|piece| length(arms(piece).into_iter().fold([0.0; 3], add))).sum::<f64>()
        };
        let sorted = back_to_front(pieces.clone(), &camera, &[false; 30], 1e-15);
        assert!((area(&sorted) / area(&pieces) - 1.0).abs() < 1e-3, "nothing is lost");
    }

    #[test]
    fn a_line_through_a_face_is_hidden_behind_it_only() {
        let camera =
            Camera::new(Direction { azimuth: 0.0, elevation: 0.0, is_perspective: false }, [0.0; 3], 1.0);
        let square = face(vec![[0.0, -1.0, -1.0], [0.0, 1.0, -1.0], [0.0, 1.0, 1.0], [0.0, -1.0, 1.0]], 0);
        let line = Fragment { shape: FragmentShape::Line([[-1.0, 0.0, 0.0], [1.0, 0.2, 0.0]]), thing: 1 };
        let sorted = back_to_front(vec![line, square], &camera, &[true, false], 1e-12);
        let kinds: Vec<bool> =
            sorted.iter().map(|piece| matches!(piece.shape, FragmentShape::Line(_))).collect();
        assert_eq!(kinds, [true, false, true]);
        assert!(sorted[0].corners().iter().all(|corner| corner[0] <= 0.0), "the part behind comes first");
        assert!(sorted[2].corners().iter().all(|corner| corner[0] >= 0.0));
    }
}
