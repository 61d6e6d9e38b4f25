//! The surroundings of bodies in space: surfaces that they touch, floors and fixed lines.
//!
//! Planes have no ends. They are drawn as a grid below everything that moves. They are left out if
//! nothing comes near them, so that they hardly change the size of a picture. A sphere or cylinder
//! that is far larger than everything else is drawn as a plane that touches it. A closed surface
//! that bodies touch from inside faces inwards, and its side towards the eye is invisible.

use super::mesh::{Corner, Mesh, Placement};
use super::recording::{Kind, Label, MovingMesh};
use super::size::{LARGE, Size};
use super::solids::{cylinder, large_sphere};
use super::vector::{NONE, Rotation, UPRIGHT, Vector, apply, apply_back, axes_along};
use crate::colour::{GROUND, HATCHING};
use crate::geometry::{add, bounds, mix, subtract, times, unit};
use crate::picture::Colour;
use crate::snapshot::{Form, Snapshot, Support, sampled};
use lagrange_plot::notation::formula;
use lagrange_runtime::scalar::Scalar;
use lagrange_runtime::scene::{Item, Spatial};

/// Surfaces around a motion.
pub(super) struct Surroundings<'a> {
    pub(super) film: &'a [Snapshot<Spatial>],
    pub(super) size: &'a Size,
    /// True if the motion goes on after these moments, beyond its present extent.
    pub(super) is_live: bool,
}

/// Number of grid fields along the longer side of a grid.
const FIELDS: f64 = 8.0;
/// Minimum side of a grid relative to the diagonal of a motion.
const LEAST: f64 = 0.2;
/// Distance of a plane from a motion beyond which it is not drawn, relative to the diagonal.
const FAR: f64 = 2.0;
/// Extent of surfaces beyond the present extent of a live motion, relative to the diagonal.
const BEYOND: f64 = 3.0;
/// Number of corners around a cylinder.
const ROUND: usize = 48;
/// Number of fields of terrain along each side.
const PIECES: usize = 24;

/// A surface as drawn: a mesh about a place in the axes of the surface.
struct Patch {
    mesh: Mesh,
    at: Vector,
    colour: Colour,
}

impl Surroundings<'_> {
    /// Returns a grid at a height that covers the extent of the motion.
    pub(super) fn floor(&self, height: f64) -> MovingMesh {
        let Size { low, high } = *self.size;
        let Patch { mesh, at, colour } = self.grid([low, high]);
        let placement = Placement::rigid([0.0, 0.0, height], UPRIGHT);
        thing("floor", (mesh.placed(at, &UPRIGHT), colour), vec![placement; self.film.len()])
    }

    /// Returns a surface, if it is near the motion: one mesh for each shape that it has in turn,
    /// hidden at all other moments. Only terrain changes its shape.
    pub(super) fn surfaces(&self, index: usize) -> Vec<MovingMesh> {
        let supports = self.film.iter().map(|snapshot| &snapshot.supports[index]).collect::<Vec<_>>();
        let mut end = 0;
        let shapes = supports.chunk_by(|a, b| has_same_shape(&a.form, &b.form)).filter_map(|shape| {
            let moments = end..end + shape.len();
            end = moments.end;
            let Patch { mesh, at, colour } = self.patch(index, shape[0])?;
            let track = supports.iter().enumerate().map(|(moment, Support { at: origin, rotation, .. })| {
                let placement = Placement::rigid(add(*origin, apply(rotation, at)), *rotation);
                Placement { scale: if moments.contains(&moment) { 1.0 } else { 0.0 }, ..placement }
            });
            Some(thing(&shape[0].name, (mesh, colour), track.collect()))
        });
        shapes.collect()
    }

    fn patch(&self, index: usize, support: &Support<Spatial>) -> Option<Patch> {
        let faced = |mesh: Mesh| if support.is_inside { mesh.inverted() } else { mesh };
        let own = self.extent(index, &UPRIGHT);
        match &support.form {
            Form::Flat => self.near(own).map(|own| self.grid(own)),
            Form::Round(radius) | Form::Cylinder(radius) if *radius > LARGE * self.size.diagonal() => {
                self.tangent_plane(index, support, *radius)
            }
            Form::Round(radius) => {
                Some(Patch { mesh: faced(large_sphere(*radius)), at: NONE, colour: GROUND })
            }
            Form::Cylinder(radius) => {
                let [low, high] = own.map(|corner| corner[2]);
                let half = 0.5 * (high - low) + self.margin();
                let mut mesh = cylinder(*radius, [-half, half], ROUND);
                if support.is_inside {
                    mesh.faces.retain(|face| face.len() < ROUND);
                }
                Some(Patch { mesh: faced(mesh), at: [0.0, 0.0, 0.5 * (low + high)], colour: GROUND })
            }
            Form::Terrain(heights) => Some(terrain(heights)),
        }
    }

    /// Returns the length by which surfaces extend beyond the motion.
    fn margin(&self) -> f64 {
        if self.is_live { BEYOND * self.size.diagonal() } else { 0.1 * self.size.diagonal() }
    }

    /// Returns the corners of the motion in axes that a surface carries.
    fn extent(&self, index: usize, axes: &Rotation) -> [Vector; 2] {
        let own = self.film.iter().flat_map(|snapshot| {
            let Support { at, rotation, .. } = &snapshot.supports[index];
            snapshot.places().flat_map(|(place, room)| {
                let own = apply_back(axes, apply_back(rotation, subtract(place, *at)));
                [own.map(|part| part - room), own.map(|part| part + room)]
            })
        });
        let [low, high] = bounds(own);
        if low[0] <= high[0] { [low, high] } else { [NONE; 2] }
    }

    /// Returns the corners of a motion unless it stays far above or below the plane z = 0.
    fn near(&self, [low, high]: [Vector; 2]) -> Option<[Vector; 2]> {
        let distance = low[2].max(-high[2]);
        (self.is_live || distance <= FAR * self.size.diagonal()).then_some([low, high])
    }

    /// Returns a grid in the plane z = 0 below corners.
    fn grid(&self, [low, high]: [Vector; 2]) -> Patch {
        let more = if self.is_live { self.margin() } else { 0.0 };
        let (low, high) = (low.map(|part| part - more), high.map(|part| part + more));
        let field = (high[0] - low[0]).max(high[1] - low[1]).max(LEAST * self.size.diagonal()) / FIELDS;
        let from = [0, 1].map(|axis| (low[axis] / field).floor() - 1.0);
        let count = |axis: usize| ((high[axis] / field).ceil() + 1.0 - from[axis]).min(FIELDS + 4.0) as u32;
        let [across, along] = [count(0), count(1)].map(f64::from);
        let mut mesh = Mesh::default();
        let mut line = |ends: [[f64; 2]; 2]| {
            let start = mesh.corners.len();
            let corner = |[x, y]: [f64; 2]| Corner { at: [x * field, y * field, 0.0], share: 0.0 };
            mesh.corners.extend(ends.map(corner));
            mesh.lines.push(vec![start, start + 1]);
        };
        (0..=count(0)).map(f64::from).for_each(|x| line([[x, 0.0], [x, along]]));
        (0..=count(1)).map(f64::from).for_each(|y| line([[0.0, y], [across, y]]));
        Patch { mesh, at: [from[0] * field, from[1] * field, 0.0], colour: HATCHING }
    }

    /// Returns a grid in the plane that touches a large round surface where the motion begins.
    fn tangent_plane(&self, index: usize, support: &Support<Spatial>, radius: f64) -> Option<Patch> {
        let [low, high] = self.extent(index, &UPRIGHT);
        let mut outwards = mix(low, high, 0.5);
        if let Form::Cylinder(_) = support.form {
            outwards[2] = 0.0;
        }
        let outwards = unit(outwards).unwrap_or([0.0, 0.0, 1.0]);
        let normal = if support.is_inside { times(-1.0, outwards) } else { outwards };
        let (axes, foot) = (axes_along(normal), times(radius, outwards));
        let height = apply_back(&axes, foot);
        let own = self.extent(index, &axes).map(|corner| subtract(corner, height));
        let Patch { mesh, at, colour } = self.grid(self.near(own)?);
        let at = add(foot, apply(&axes, at));
        Some(Patch { mesh: mesh.placed(NONE, &axes), at, colour })
    }

    /// Returns the places over which terrain is sampled, in rows.
    pub(super) fn samples(&self, index: usize) -> Vec<[f64; 2]> {
        let [low, high] = self.extent(index, &UPRIGHT);
        let side = (high[0] - low[0]).max(high[1] - low[1]).max(LEAST * self.size.diagonal());
        let more = self.margin().max(0.2 * side);
        let place = |axis: usize, k: usize| {
            let (from, to) = (low[axis] - more, high[axis] + more);
            from + (to - from) * k as f64 / PIECES as f64
        };
        (0..=PIECES).flat_map(|y| (0..=PIECES).map(move |x| [place(0, x), place(1, y)])).collect()
    }
}

/// Samples the heights of terrain at each moment, in the scene that `visit` visits then.
pub(super) fn sample_terrain<S: Scalar + Into<f64>>(
    film: &mut [Snapshot<Spatial>],
    size: &Size,
    is_live: bool,
    visit: impl Fn(usize, &mut dyn FnMut(Item<'_, S, Spatial>)),
) {
    let count = film.first().map_or(0, |first| first.supports.len());
    let is_terrain =
        |film: &[Snapshot<Spatial>], index: usize| matches!(film[0].supports[index].form, Form::Terrain(_));
    for index in (0..count).filter(|&index| is_terrain(film, index)).collect::<Vec<_>>() {
        let places = Surroundings { film, size, is_live }.samples(index);
        for (moment, snapshot) in film.iter_mut().enumerate() {
            let Support { name, form, .. } = &mut snapshot.supports[index];
            *form = sampled(|keep| visit(moment, keep), name, places.clone());
        }
    }
}

/// True unless terrain has other heights. Those beyond its domain are the same.
fn has_same_shape(one: &Form, other: &Form) -> bool {
    let (Form::Terrain(one), Form::Terrain(other)) = (one, other) else { return true };
    let heights = one.iter().zip(other).map(|((_, one), (_, other))| (one, other));
    { heights }.all(|(one, other)| one == other || !(one.is_finite() || other.is_finite()))
}

/// Returns terrain through heights over places in rows. Faces at heights that are not finite are
/// left out. Without any finite height, the place of the terrain is not finite.
fn terrain(heights: &[([f64; 2], f64)]) -> Patch {
    let finite = heights.iter().filter(|(_, height)| height.is_finite());
    let places: Vec<Vector> = finite.map(|([x, y], height)| [*x, *y, *height]).collect();
    let middle = places.get(places.len() / 2).copied().unwrap_or([f64::NAN; 3]);
    let corners = places.iter().map(|place| Corner { at: subtract(*place, middle), share: 0.0 }).collect();
    let mut mesh = Mesh { corners, ..Mesh::default() };
    let mut next = 0..;
    let corners: Vec<Option<usize>> =
        heights.iter().map(|(_, height)| height.is_finite().then(|| next.next()).flatten()).collect();
    let row = PIECES + 1;
    for start in (0..PIECES).flat_map(|y| (0..PIECES).map(move |x| row * y + x)) {
        // Halves of a field are plane.
        let halves = [[start, start + 1, start + row + 1], [start, start + row + 1, start + row]];
        let face = |half: [usize; 3]| half.iter().map(|&k| corners.get(k).copied().flatten()).collect();
        mesh.faces.extend(halves.into_iter().filter_map(face));
    }
    Patch { mesh, at: middle, colour: GROUND }
}

fn thing(name: &str, (mesh, colour): (Mesh, Colour), track: Vec<Placement>) -> MovingMesh {
    MovingMesh { name: name.to_owned(), label: None, colour, kind: Kind::Surroundings, mesh, track }
}

/// Returns a fixed line through points, in a film of this many moments.
pub(super) fn path(label: &str, points: &[Vector], colour: Colour, moments: usize) -> MovingMesh {
    let corners = points.iter().map(|&at| Corner { at, share: 0.0 }).collect();
    let placement = Placement::rigid(NONE, UPRIGHT);
    MovingMesh {
        name: label.to_owned(),
        label: points.last().and_then(|&at| Label::new(formula(label), at, 0.0)),
        colour,
        kind: Kind::Surroundings,
        mesh: Mesh { corners, faces: Vec::new(), lines: vec![(0..points.len()).collect()], is_closed: false },
        track: vec![placement; moments],
    }
}
