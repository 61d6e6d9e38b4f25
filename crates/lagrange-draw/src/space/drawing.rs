//! The drawing of a system in space.

use std::fmt::{Debug, Formatter};
use std::rc::Rc;

use super::camera::Direction;
use super::projector::{Look, Projector};
use super::recording::{Recording, Trace};
use super::size::Size;
use super::snapshot::SpatialSnapshot;
use super::stage::{self, Wanted};
use super::vector::Vector;
use crate::colour;
use crate::drawing::{Instant, Shot};
use crate::error::DrawError;
use crate::film::refusal;
use crate::picture::Picture;
use lagrange_runtime::scene::SpatialScene;
use lagrange_runtime::system::{OdeSystem, split};

type Point3<'a, M> =
    Rc<dyn Fn(&M, <M as OdeSystem>::Scalar, &<M as OdeSystem>::State) -> [<M as OdeSystem>::Scalar; 3] + 'a>;

/// Pictures of a system of bodies in space, as it declares itself.
///
/// Solids are shaded and hide what is behind them; bodies that are given by numbers only are drawn as rods between their joints. Joints,
/// springs, dampers and names are drawn; arrows and what else helps are asked for. One window shows all that ever moves, on one scale, and
/// arrows of one kind have one scale. z points upwards.
///
/// ```
/// use lagrange::draw::SpatialDrawing;
///
/// lagrange::system! {
///     /// A pendulum that swings in all directions.
///     pub struct Pendulum;
///
///     gravity = (0, 0, -9.81);
///     body bob { mass: 1.0; shape: solid_sphere(0.1); centroid: (0, 0, -1); }
///     universal (a, b) = ground to bob { at: (0, 0, 1); }
///     emit { drawing }
/// }
///
/// let pendulum = Pendulum::default();
/// let drawing = SpatialDrawing::of(&pendulum).title("A pendulum").view(-0.5, 0.3).velocities();
/// let picture = drawing.picture(0.0, &[0.3, 0.5, 1.0, 0.0])?;
/// assert!(picture.svg().contains("A pendulum"));
/// # Ok::<(), lagrange::draw::DrawError>(())
/// ```
pub struct SpatialDrawing<'a, M: SpatialScene> {
    system: &'a M,
    look: Look,
    wanted: Wanted,
    hidden: Vec<String>,
    traces: Vec<(String, Point3<'a, M>)>,
    paths: Vec<(String, Vec<Vector>)>,
    past: Vec<Instant<M>>,
}

/// Width and height of a picture in pixels of 1/96 inch.
const SIZE: [f64; 2] = [640.0, 480.0];

impl<'a, M: SpatialScene> SpatialDrawing<'a, M> {
    /// A drawing of a system.
    pub fn of(system: &'a M) -> Self {
        SpatialDrawing {
            system,
            look: Look { size: SIZE, title: String::new(), direction: Direction::default() },
            wanted: Wanted { names: true, ..Wanted::default() },
            hidden: Vec::new(),
            traces: Vec::new(),
            paths: Vec::new(),
            past: Vec::new(),
        }
    }

    /// Width and height in pixels of 1/96 inch; 640 by 480 without this.
    pub fn size(mut self, width: f64, height: f64) -> Self {
        self.look.size = [width, height];
        self
    }

    /// Sets the title.
    pub fn title(mut self, title: &str) -> Self {
        title.clone_into(&mut self.look.title);
        self
    }

    /// The direction in which the eye is, in radians: the azimuth from x towards y, and the elevation above the plane of both; −60° and 25°
    /// without this.
    pub fn view(mut self, azimuth: f64, elevation: f64) -> Self {
        self.look.direction = Direction { azimuth, elevation, ..self.look.direction };
        self
    }

    /// Selects perspective projection instead of parallel projection.
    pub fn perspective(mut self) -> Self {
        self.look.direction.is_perspective = true;
        self
    }

    /// The velocities of the centres of mass.
    pub fn velocities(mut self) -> Self {
        self.wanted.velocities = true;
        self
    }

    /// The accelerations of the centres of mass.
    pub fn accelerations(mut self) -> Self {
        self.wanted.accelerations = true;
        self
    }

    /// Forces and, with two heads, moments that have names: those that are declared, weights, and those of springs, dampers and pins. A line
    /// below the picture names what acts and cannot be drawn.
    pub fn forces(mut self) -> Self {
        self.wanted.forces = true;
        self
    }

    /// The own axes X, Y and Z of the bodies.
    pub fn frames(mut self) -> Self {
        self.wanted.frames = true;
        self
    }

    /// The axes x, y and z of the world.
    pub fn axes(mut self) -> Self {
        self.wanted.axes = true;
        self
    }

    /// A floor at a height, as a grid.
    pub fn floor(mut self, height: f64) -> Self {
        self.wanted.floor = Some(height);
        self
    }

    /// Without the body, frame, connector, joint or load of this name.
    pub fn hide(mut self, name: &str) -> Self {
        self.hidden.push(name.to_owned());
        self
    }

    /// Without the names of bodies and connectors.
    pub fn nameless(mut self) -> Self {
        self.wanted.names = false;
        self
    }

    /// The path of a point, given at a time and a state, through all moments so far.
    pub fn trace(
        mut self,
        label: &str,
        point: impl Fn(&M, M::Scalar, &M::State) -> [M::Scalar; 3] + 'a,
    ) -> Self {
        self.traces.push((label.to_owned(), Rc::new(point)));
        self
    }

    /// A line through at least two points that do not move, such as a path to follow.
    pub fn path(mut self, label: &str, points: impl IntoIterator<Item = [f64; 3]>) -> Self {
        self.paths.push((label.to_owned(), points.into_iter().collect()));
        self
    }

    /// Moments before those of the pictures, for traces.
    pub fn past(mut self, states: impl IntoIterator<Item = Instant<M>>) -> Self {
        self.past.extend(states);
        self
    }
}

impl<M: SpatialScene> SpatialDrawing<'_, M>
where
    M::Scalar: Into<f64>,
{
    /// The picture at a time and a state, with forces under the inputs that the system has.
    ///
    /// # Errors
    /// If a number is not finite, the scene lacks what is to be hidden, there is nothing to draw, or the picture is too small.
    pub fn picture(&self, t: M::Scalar, y: &M::State) -> Result<Picture, DrawError> {
        self.pictures([(t, *y)])?.pop().ok_or(DrawError::NothingToDraw)
    }

    /// Pictures at several times and states, from one place and on one scale.
    ///
    /// # Errors
    /// Those of [`picture`](Self::picture).
    pub fn pictures(&self, states: impl IntoIterator<Item = Instant<M>>) -> Result<Vec<Picture>, DrawError> {
        let shots: Vec<Shot<M>> = states.into_iter().map(|instant| (instant, None)).collect();
        let recording = self.recording(&shots)?;
        Ok(Projector::new(&recording, &self.look)?.pictures(0..recording.times.len()))
    }

    /// Records a motion in which the system may change between instants.
    pub(super) fn recording(&self, shots: &[Shot<M>]) -> Result<Recording, DrawError> {
        let snapshots = shots.iter().map(|shot| self.snapshot(shot)).collect::<Result<Vec<_>, _>>()?;
        let differing = snapshots.iter().find_map(|snapshot| snapshots[0].difference(snapshot));
        if let Some(name) = differing {
            return Err(refusal(&format!("`{name}` is not the same at all moments")));
        }
        // What moves in the past only is seen by its traces.
        let mut things = stage::things(&snapshots, self.wanted, &Size::of(&snapshots));
        let paths = self.paths.iter().enumerate().filter(|(_, (_, points))| points.len() > 1);
        things.extend(paths.map(|(index, (label, points))| {
            stage::path(label, points, colour::ink(index + 1), snapshots.len())
        }));
        let trace = |(index, (label, point)): (usize, &(String, Point3<'_, M>))| {
            let place = |system: &M, (t, y): &Instant<M>| point(system, *t, y).map(Into::into);
            Trace {
                label: label.clone(),
                colour: colour::trace(index),
                past: self.past.iter().map(|instant| place(self.system, instant)).collect(),
                points: shots.iter().map(|shot| place(self.system_in(shot), &shot.0)).collect(),
            }
        };
        let traces = self.traces.iter().enumerate().map(trace).collect();
        let times = shots.iter().map(|((t, _), _)| (*t).into()).collect();
        Recording { times, things, traces, note: self.note(snapshots.first()) }.checked()
    }

    /// The system that is drawn, and what its pictures look like.
    pub(super) fn system(&self) -> &M {
        self.system
    }

    pub(super) fn look(&self) -> &Look {
        &self.look
    }

    fn system_in<'s>(&'s self, (_, other): &'s Shot<M>) -> &'s M {
        other.as_ref().unwrap_or(self.system)
    }

    fn snapshot(&self, shot: &Shot<M>) -> Result<SpatialSnapshot, DrawError> {
        let (t, y) = &shot.0;
        let (q, v) = split::<M>(y);
        let snapshot = SpatialSnapshot::of(self.system_in(shot), *t, &q, &v);
        for name in &self.hidden {
            if !snapshot.names().any(|known| known == name) {
                return Err(DrawError::UnknownItem(name.clone()));
            }
        }
        Ok(snapshot.without(&self.hidden))
    }

    /// Returns the note about loads that act but cannot be drawn, if loads are drawn.
    fn note(&self, first: Option<&SpatialSnapshot>) -> String {
        let omitted = first.map(|snapshot| snapshot.omitted.as_slice()).unwrap_or_default();
        if omitted.is_empty() || !self.wanted.forces {
            return String::new();
        }
        let names: Vec<String> =
            omitted.iter().map(|name| name.replace(['`'], "").replace('_', " ")).collect();
        format!("not drawn: {}", names.join(", "))
    }
}

impl<M: SpatialScene> Clone for SpatialDrawing<'_, M> {
    fn clone(&self) -> Self {
        SpatialDrawing {
            look: self.look.clone(),
            hidden: self.hidden.clone(),
            traces: self.traces.clone(),
            paths: self.paths.clone(),
            past: self.past.clone(),
            ..*self
        }
    }
}

impl<M: SpatialScene> Debug for SpatialDrawing<'_, M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SpatialDrawing").field("look", &self.look).finish_non_exhaustive()
    }
}
