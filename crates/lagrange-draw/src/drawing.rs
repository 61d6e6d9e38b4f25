//! The drawing of a system.

use std::fmt::{Debug, Formatter};
use std::rc::Rc;

use crate::error::DrawError;
use crate::load_label::omitted_loads;
use crate::look::{Direction, Look, Wanted};
use crate::moment::Moment;
use crate::picture::Picture;
use crate::recorded::Recorded;
use crate::remainder::{MOMENT, REMAINDER};
use crate::sketch::Sketch;
use crate::snapshot::Snapshot;
use crate::snapshot::Stored;
use lagrange_runtime::scene::Plane;
use lagrange_runtime::scene::Scene;
use lagrange_runtime::scene::Space;
use lagrange_runtime::scene::Spatial;
use lagrange_runtime::system::{OdeSystem, split};

/// Note on contacts in a state from which no motion can start, for example if bodies overlap.
const WITHOUT_MOTION: &str = "forces of contacts that overlap";

/// A time and a state.
pub(super) type Instant<M> = (<M as OdeSystem>::Scalar, <M as OdeSystem>::State);
/// An instant with the system at that time, if it differs from the drawn one, for example in
/// inputs.
pub(super) type Shot<M> = (Instant<M>, Option<M>);
type Sketched<'a, M> = Rc<dyn Fn(&mut Sketch, &Moment<'_, M>) + 'a>;
type Vector<M> = <<M as Scene>::Space as Space>::Vector<<M as OdeSystem>::Scalar>;
type Point<'a, M> = Rc<dyn Fn(&M, <M as OdeSystem>::Scalar, &<M as OdeSystem>::State) -> Vector<M> + 'a>;

/// A space whose scenes can be drawn: the [`Plane`] or [`Spatial`].
pub trait DrawnSpace: Stored {
    /// Default width and height of a picture in pixels of 1/96 inch.
    #[doc(hidden)]
    const SIZE: [f64; 2];

    /// Type of recorded motions.
    #[doc(hidden)]
    type Recording: Recorded;

    /// Records a motion in which the system may differ between instants.
    #[doc(hidden)]
    fn record<M: Scene<Space = Self>>(
        drawing: &Drawing<'_, M>,
        shots: &[Shot<M>],
    ) -> Result<Self::Recording, DrawError>
    where
        M::Scalar: Into<f64>;
}

/// Pictures of a declared system of rigid bodies, in the plane or in space.
///
/// Bodies, surfaces, connectors, joints and names are always drawn; arrows and other additions are
/// optional. All pictures share one window and one scale, and all arrows of one kind share one
/// scale.
///
/// In the plane x points to the right and y upwards. Springs and dampers whose end is at rest on no
/// body get a short wall there. Connectors between the same points are drawn next to each other.
/// The longest arrow is a quarter of the picture. Positions, angles and vectors are those of the
/// declaration.
///
/// In space z points upwards. Solids are shaded and hide everything behind them; bodies given only
/// by numbers are drawn as rods between their joints.
///
/// ```
/// use lagrange::draw::Drawing;
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
/// let drawing = Drawing::of(&pendulum).title("A pendulum").view(-0.5, 0.3).velocities();
/// let picture = drawing.picture(0.0, &[0.3, 0.5, 1.0, 0.0])?;
/// assert!(picture.svg().contains("A pendulum"));
/// # Ok::<(), lagrange::draw::DrawError>(())
/// ```
pub struct Drawing<'a, M: Scene<Space: DrawnSpace>> {
    system: &'a M,
    pub(super) look: Look,
    pub(super) wanted: Wanted,
    pub(super) hidden: Vec<String>,
    /// Labels of loads, by names.
    letters: Vec<(String, String)>,
    pub(super) traces: Vec<(String, Point<'a, M>)>,
    pub(super) past: Vec<Instant<M>>,
    pub(super) free_body: Option<String>,
    pub(super) sketches: Vec<Sketched<'a, M>>,
    pub(super) paths: Vec<(String, Vec<[f64; 3]>)>,
}

impl<'a, M: Scene<Space: DrawnSpace>> Drawing<'a, M> {
    /// Creates a drawing of a system.
    pub fn of(system: &'a M) -> Self {
        Drawing {
            system,
            look: Look { size: M::Space::SIZE, title: String::new(), direction: Direction::default() },
            wanted: Wanted { names: true, ..Wanted::default() },
            hidden: Vec::new(),
            letters: Vec::new(),
            traces: Vec::new(),
            past: Vec::new(),
            free_body: None,
            sketches: Vec::new(),
            paths: Vec::new(),
        }
    }

    /// Sets width and height in pixels of 1/96 inch; the default is 640 by 400, in space 640 by
    /// 480.
    pub fn size(mut self, width: f64, height: f64) -> Self {
        self.look.size = [width, height];
        self
    }

    /// Sets the title.
    pub fn title(mut self, title: &str) -> Self {
        title.clone_into(&mut self.look.title);
        self
    }

    /// Adds the velocities of the centres of mass.
    pub fn velocities(mut self) -> Self {
        self.wanted.velocities = true;
        self
    }

    /// Adds the accelerations of the centres of mass.
    pub fn accelerations(mut self) -> Self {
        self.wanted.accelerations = true;
        self
    }

    /// Adds the forces and moments that have names: declared ones, weights, constraint forces of
    /// joints, and those of springs, dampers and contacts of bodies. Forces of contacts,
    /// `touch.normal` and `touch.friction`, are those of a motion that starts from the state. The
    /// force of a contact is within its friction cone, `touch.cone`, which is as high as the normal
    /// force. In space, arrows of moments have two heads. Torques on angles act on the bodies that
    /// rotate by these angles. A line below the picture names the omitted ones: forces of joints
    /// that the coordinates satisfy, and torques on angles that determine no body.
    /// [`hide`](Self::hide) removes a name from it. Hand-written constraints and potentials,
    /// impacts and dry friction of events also act, but have no names. In the plane,
    /// [`free_body`](Self::free_body) shows their resultant.
    pub fn forces(mut self) -> Self {
        self.wanted.forces = true;
        self
    }

    /// Adds the body-fixed axes X, Y and, in space, Z.
    pub fn frames(mut self) -> Self {
        self.wanted.frames = true;
        self
    }

    /// Hides the body, frame, line, connector, joint or load of this name.
    pub fn hide(mut self, name: &str) -> Self {
        self.hidden.push(name.to_owned());
        self
    }

    /// Labels the force or moment of this name by another letter, such as `("hinge", "A")` or
    /// `("foot.normal", "N_1")`. Weights are named `gravity` and keep the names of bodies as
    /// subscripts, unless the label has one. The resultants of a free body are `R` and `M_R`.
    pub fn letter(mut self, load: &str, label: &str) -> Self {
        self.letters.push((load.to_owned(), label.to_owned()));
        self
    }

    /// Hides the names of bodies and connectors.
    pub fn nameless(mut self) -> Self {
        self.wanted.names = false;
        self
    }

    /// Adds the path of a point, a function of time and state `[q…, v…]`, through all moments up to
    /// the current one.
    pub fn trace(
        mut self,
        label: &str,
        point: impl Fn(&M, M::Scalar, &M::State) -> <M::Space as Space>::Vector<M::Scalar> + 'a,
    ) -> Self {
        self.traces.push((label.to_owned(), Rc::new(point)));
        self
    }

    /// Adds moments before the pictures, for traces. In the plane, the window then includes the
    /// positions at these moments.
    pub fn past(mut self, states: impl IntoIterator<Item = (M::Scalar, M::State)>) -> Self {
        self.past.extend(states);
        self
    }
}

impl<'a, M: Scene<Space = Plane>> Drawing<'a, M> {
    /// Draws only one body and the forces and moments that act on it.
    ///
    /// Loads not listed in [`forces`](Self::forces) follow from the motion. Their resultant is
    /// drawn in dark grey at the centre of mass. It is the force R = m a − Σ F, with the moment M_R
    /// = J α − Σ M about the centre of mass. It is omitted if it is zero up to rounding.
    /// [`Moment::force`] returns it under the name R.
    pub fn free_body(mut self, body: &str) -> Self {
        self.free_body = Some(body.to_owned());
        self.wanted.is_free = true;
        self.forces()
    }

    /// Adds the instantaneous centres of rotation M, each with a ray from the centre of mass. A
    /// body that does not turn has none; a distant one is indicated by its ray.
    pub fn centers(mut self) -> Self {
        self.wanted.centers = true;
        self
    }

    /// Adds user-drawn elements at each moment.
    pub fn annotate(mut self, sketch: impl Fn(&mut Sketch, &Moment<'_, M>) + 'a) -> Self {
        self.sketches.push(Rc::new(sketch));
        self
    }
}

impl<M: Scene<Space = Spatial>> Drawing<'_, M> {
    /// Sets the viewing direction in radians: the azimuth from x towards y, and the elevation above
    /// the xy-plane. The default is −60° and 25°.
    pub fn view(mut self, azimuth: f64, elevation: f64) -> Self {
        self.look.direction = Direction { azimuth, elevation, ..self.look.direction };
        self
    }

    /// Selects perspective projection instead of parallel projection.
    pub fn perspective(mut self) -> Self {
        self.look.direction.is_perspective = true;
        self
    }

    /// Adds the axes x, y and z of the world.
    pub fn axes(mut self) -> Self {
        self.wanted.axes = true;
        self
    }

    /// Adds a floor at a height, drawn as a grid.
    pub fn floor(mut self, height: f64) -> Self {
        self.wanted.floor = Some(height);
        self
    }

    /// Adds a fixed line through at least two points, such as a path to follow.
    pub fn path(mut self, label: &str, points: impl IntoIterator<Item = [f64; 3]>) -> Self {
        self.paths.push((label.to_owned(), points.into_iter().collect()));
        self
    }
}

impl<M: Scene<Space: DrawnSpace>> Drawing<'_, M>
where
    M::Scalar: Into<f64>,
{
    /// Draws the picture at a time and a state `[q…, v…]`, with forces for the current inputs of
    /// the system.
    ///
    /// # Errors
    /// If a number is not finite, there is nothing to draw, or the picture is too small. Also if
    /// the scene lacks the free body, a hidden name or a load with a letter.
    pub fn picture(&self, t: M::Scalar, y: &M::State) -> Result<Picture, DrawError> {
        self.pictures([(t, *y)])?.pop().ok_or(DrawError::NothingToDraw)
    }

    /// Draws pictures at several times and states, with a common window and scale of arrows.
    ///
    /// # Errors
    /// As for [`picture`](Self::picture).
    pub fn pictures(
        &self,
        states: impl IntoIterator<Item = (M::Scalar, M::State)>,
    ) -> Result<Vec<Picture>, DrawError> {
        let shots: Vec<Shot<M>> = states.into_iter().map(|instant| (instant, None)).collect();
        Ok(M::Space::record(self, &shots)?.pictures().into_owned())
    }

    /// Returns the drawn system.
    pub(super) fn system(&self) -> &M {
        self.system
    }

    /// Returns the system in this shot.
    pub(super) fn system_in<'s>(&'s self, (_, other): &'s Shot<M>) -> &'s M {
        other.as_ref().unwrap_or(self.system)
    }

    /// Returns the scene of a shot without hidden items, which must exist.
    pub(super) fn snapshot(&self, shot: &Shot<M>) -> Result<Snapshot<M::Space>, DrawError> {
        let ((t, y), system) = (&shot.0, self.system_in(shot));
        let (q, v) = split::<M>(y);
        // The forces of contacts, and the resulting accelerations, are those of a motion from this
        // state.
        let begun = system.begin(*t, y);
        let in_modes = begun.as_ref().ok().and_then(Option::as_ref).unwrap_or(system);
        let mut snapshot = Snapshot::of(in_modes, *t, &q, &v);
        if begun.is_err() {
            snapshot.omitted.push(WITHOUT_MOTION.to_owned());
        }
        snapshot.letters.clone_from(&self.letters);
        let is_unknown = |name: &&String| snapshot.names().all(|known| known != name.as_str());
        let is_lost = |name: &&String| !self.has_load(name, &snapshot);
        let letters = self.letters.iter().map(|(load, _)| load);
        match self.hidden.iter().find(is_unknown).or_else(|| letters.into_iter().find(is_lost)) {
            Some(name) => Err(DrawError::UnknownItem(name.clone())),
            None => Ok(snapshot),
        }
    }

    /// True if the scene has a load of this name, or a free body this resultant.
    fn has_load(&self, name: &str, snapshot: &Snapshot<M::Space>) -> bool {
        let is_resultant = self.wanted.is_free && [REMAINDER, MOMENT].contains(&name);
        is_resultant || snapshot.loads.iter().any(|load| load.name == name)
    }

    /// Returns the note about loads that act but cannot be drawn, if loads are drawn.
    pub(super) fn note(&self, snapshots: &[Snapshot<M::Space>]) -> String {
        if self.wanted.forces { omitted_loads(snapshots) } else { String::new() }
    }
}

impl<M: Scene<Space: DrawnSpace>> Clone for Drawing<'_, M> {
    fn clone(&self) -> Self {
        Drawing {
            look: self.look.clone(),
            hidden: self.hidden.clone(),
            letters: self.letters.clone(),
            traces: self.traces.clone(),
            past: self.past.clone(),
            free_body: self.free_body.clone(),
            sketches: self.sketches.clone(),
            paths: self.paths.clone(),
            ..*self
        }
    }
}

impl<M: Scene<Space: DrawnSpace>> Debug for Drawing<'_, M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Drawing").field("look", &self.look).finish_non_exhaustive()
    }
}
