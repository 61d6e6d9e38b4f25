//! Arrows: velocities, accelerations, axes, forces and moments.

use super::mesh::{Mesh, Placement};
use super::recording::{Kind, Label, MovingMesh};
use super::size::Size;
use super::snapshot::Link;
use super::solids::{self, SHORTEST_ARROW};
use super::vector::{NONE, Rotation, UPRIGHT, Vector};
use crate::colour::{FORCE, PALE, PAPER};
use crate::geometry::{length, times};
use crate::load::Value;
use crate::load_label::{contact_label, given_label};
use crate::picture::Colour;
use crate::snapshot::{Cone, Snapshot};
use lagrange_plot::notation::formula;
use lagrange_plot::notation::symbol;
use lagrange_runtime::body::SpatialMotion;
use lagrange_runtime::scene::{LoadOrigin, Spatial};

/// Length of the longest arrows of a kind, relative to the diagonal of the motion.
pub(super) const LONGEST: f64 = 0.3;
/// Fraction of the background colour in the colour of friction cones.
const CONE: f64 = 0.5;
/// Length of axes, relative to the diagonal of the motion.
const AXIS: f64 = 0.12;

/// The arrows of a motion.
pub(super) struct Arrows<'a> {
    pub(super) film: &'a [Snapshot<Spatial>],
    pub(super) size: &'a Size,
}

impl Arrows<'_> {
    /// Returns an arrow at the centre of mass of each body, labelled with a letter.
    pub(super) fn rates(
        &self,
        first: &Snapshot<Spatial>,
        letter: &str,
        colour: Colour,
        rate: fn(&SpatialMotion<f64>) -> Vector,
    ) -> Vec<MovingMesh> {
        let bodies: Vec<(usize, &Link)> = bodies(first).collect();
        let vectors = bodies.iter().map(|(index, link)| {
            let vector = |snapshot: &Snapshot<Spatial>| {
                let motion = snapshot.bodies[*index].motion;
                motion.map_or([NONE; 2], |motion| [motion.center, rate(&motion)])
            };
            let text = symbol(letter, &link.name, bodies.len() > 1);
            (&*link.name, text, self.film.iter().map(vector).collect())
        });
        self.arrows(vectors.collect(), colour, &solids::arrow(self.size.thin()))
    }

    /// Returns the body-fixed axes of bodies.
    pub(super) fn own_axes(&self, first: &Snapshot<Spatial>) -> Vec<MovingMesh> {
        let axes = |(index, link): (usize, &Link)| {
            let pose = |snapshot: &Snapshot<Spatial>| {
                let link = &snapshot.bodies[index];
                (link.origin, link.rotation)
            };
            self.axes(&link.name, pose, ["X", "Y", "Z"])
        };
        bodies(first).flat_map(axes).collect()
    }

    /// Returns the axes of the world, which bodies may hide.
    pub(super) fn axes_of_world(&self) -> Vec<MovingMesh> {
        let axes = self.axes("", |_| (NONE, UPRIGHT), ["x", "y", "z"]).into_iter();
        axes.map(|axis| MovingMesh { kind: Kind::Surroundings, ..axis }).collect()
    }

    /// Returns forces, followed by moments, each kind with its own scale.
    pub(super) fn loads(&self, first: &Snapshot<Spatial>) -> Vec<MovingMesh> {
        let contacts = first.loads.iter().filter(|load| load.cause == LoadOrigin::Contact);
        let contacts = contacts.map(|load| &*load.name);
        let of_kind = |is_moment: bool| {
            let loads = first.loads.iter().enumerate().filter(|(_, load)| load.is_moment() == is_moment);
            let vectors = loads.map(|(index, load)| {
                let vector = |snapshot: &Snapshot<Spatial>| {
                    let load = &snapshot.loads[index];
                    let (Value::Force(value) | Value::Moment(value)) = load.value;
                    [load.at, value]
                };
                let usual = || match (load.cause, &load.body) {
                    (LoadOrigin::Gravity, Some(body)) => symbol("G", body, true),
                    (LoadOrigin::Applied, _) if ["force", "torque"].contains(&&*load.name) => {
                        if is_moment { "M" } else { "F" }.to_owned()
                    }
                    (LoadOrigin::Contact, _) => contact_label(&load.name, contacts.clone()),
                    _ => formula(&load.name),
                };
                let text = given_label(load, first, true).unwrap_or_else(usual);
                (&*load.name, text, self.film.iter().map(vector).collect())
            });
            let thin = self.size.thin();
            let mesh = if is_moment { solids::double_arrow(thin) } else { solids::arrow(thin) };
            self.arrows(vectors.collect(), FORCE, &mesh)
        };
        [of_kind(false), of_kind(true)].concat()
    }

    /// Returns arrows from their names, labels, and origins and vectors at each moment; the longest
    /// has a readable length.
    fn arrows(
        &self,
        vectors: Vec<(&str, String, Vec<[Vector; 2]>)>,
        colour: Colour,
        mesh: &Mesh,
    ) -> Vec<MovingMesh> {
        let all = vectors.iter().flat_map(|(_, _, track)| track.iter().map(|[_, vector]| *vector));
        let scale = self.scale(all);
        let thing = |(name, text, track): (&str, String, Vec<[Vector; 2]>)| MovingMesh {
            name: name.to_owned(),
            label: Label::new(text, NONE, 1.0),
            colour,
            kind: Kind::Arrow,
            mesh: mesh.clone(),
            track: self.track(track.into_iter().map(|[at, vector]| [at, times(scale, vector)])),
        };
        vectors.into_iter().map(thing).collect()
    }

    /// Returns the scale at which the longest of vectors has a readable length.
    fn scale(&self, vectors: impl Iterator<Item = Vector>) -> f64 {
        let scale = LONGEST * self.size.diagonal() / vectors.map(length).fold(0.0, f64::max);
        if scale.is_finite() { scale } else { 0.0 }
    }

    /// Returns the outlines of friction cones, as high as the arrows of normal forces. Their height
    /// is a stretch, and their width, which depends on the coefficient, a scale.
    pub(super) fn cones(&self, first: &Snapshot<Spatial>) -> Vec<MovingMesh> {
        let loads = self.film.iter().flat_map(|snapshot| &snapshot.loads);
        let scale = self.scale(loads.filter_map(|load| match load.value {
            Value::Force(force) => Some(force),
            Value::Moment(_) => None,
        }));
        let outline = |(index, cone): (usize, &Cone<Spatial>)| {
            let cones = || self.film.iter().map(|snapshot| &snapshot.cones[index]);
            let radius = |cone: &Cone<Spatial>| cone.coefficient * scale * length(cone.normal);
            let widest = cones().map(radius).fold(0.0, f64::max);
            let spans = cones().map(|cone| [cone.at, times(scale, cone.normal)]);
            let sized = |(placement, cone): (Placement, &Cone<Spatial>)| {
                let part = if widest > 0.0 { radius(cone) / widest } else { 0.0 };
                Placement { scale: part, ..placement }
            };
            MovingMesh {
                name: cone.name.clone(),
                label: None,
                colour: FORCE.mixed(PAPER, CONE),
                kind: Kind::Arrow,
                mesh: solids::cone_outline(widest),
                track: Placement::spanned(spans).into_iter().zip(cones()).map(sized).collect(),
            }
        };
        first.cones.iter().enumerate().map(outline).collect()
    }

    /// Returns placements of arrows. Short arrows are scaled down as a whole, and invisibly short
    /// ones are hidden.
    fn track(&self, vectors: impl Iterator<Item = [Vector; 2]>) -> Vec<Placement> {
        const SEEN: f64 = 0.05;
        let sized = |placement: Placement| {
            let part = placement.stretch / (SHORTEST_ARROW * self.size.thin());
            Placement { scale: if part < SEEN { 0.0 } else { part.min(1.0) }, ..placement }
        };
        Placement::spanned(vectors).into_iter().map(sized).collect()
    }

    /// Returns three axes.
    fn axes(
        &self,
        name: &str,
        pose: impl Fn(&Snapshot<Spatial>) -> (Vector, Rotation),
        letters: [&str; 3],
    ) -> Vec<MovingMesh> {
        let length = AXIS * self.size.diagonal();
        let axis = |(axis, letter): (usize, &str)| {
            let track = self.film.iter().map(|snapshot| {
                let (origin, rotation) = pose(snapshot);
                [origin, rotation.map(|row| length * row[axis])]
            });
            MovingMesh {
                name: format!("{letter} {name}").trim_end().to_owned(),
                label: Label::new(letter.to_owned(), NONE, 1.0),
                colour: PALE,
                kind: Kind::Arrow,
                mesh: solids::arrow(0.6 * self.size.thin()),
                track: Placement::spanned(track),
            }
        };
        letters.into_iter().enumerate().map(axis).collect()
    }
}

/// Returns the links with mass, and their indices.
fn bodies(snapshot: &Snapshot<Spatial>) -> impl Iterator<Item = (usize, &Link)> {
    snapshot.bodies.iter().enumerate().filter(|(_, link)| link.motion.is_some())
}
