//! The drawing of a system.

use std::fmt::{Debug, Formatter};
use std::rc::Rc;

use crate::anchored::anchored;
use crate::colour;
use crate::element::Element;
use crate::error::DrawError;
use crate::layout::{self, Paper};
use crate::moment::Moment;
use crate::parallel::lanes;
use crate::picture::{Picture, Point};
use crate::sketch::Sketch;
use crate::snapshot::Snapshot;
use crate::stage::{self, Fixed, Wanted};
use crate::stretch::stretches;
use lagrange_plot::label::Label;
use lagrange_plot::notation::formula;
use lagrange_runtime::scalar::{Number, Scalar};
use lagrange_runtime::scene::Scene;
use lagrange_runtime::system::{OdeSystem, split};

/// A time and a state.
pub(super) type Instant<M> = (<M as OdeSystem>::Scalar, <M as OdeSystem>::State);
/// An instant with the system at that time, if it differs from the drawn one, for example in
/// inputs.
pub(super) type Shot<M> = (Instant<M>, Option<M>);
type Sketched<'a, M> = Rc<dyn Fn(&mut Sketch, &Moment<'_, M>) + 'a>;
type Point2<'a, M> =
    Rc<dyn Fn(&M, <M as OdeSystem>::Scalar, &<M as OdeSystem>::State) -> [<M as OdeSystem>::Scalar; 2] + 'a>;

/// Pictures of a system of plane rigid bodies, as it declares itself.
///
/// Bodies, connectors, joints, lines and names are drawn; arrows and what else helps are asked for. Springs and dampers that end where
/// nothing is and nothing moves get a short wall there, and those between the same points lie side by side. One window shows all that is ever
/// drawn, on one scale, and arrows of one kind have one scale, the longest a quarter of the picture. Positions, angles and vectors
/// are those of the declaration, x to the right, y upwards.
pub struct Drawing<'a, M: Scene> {
    system: &'a M,
    size: [f64; 2],
    title: String,
    wanted: Wanted,
    free_body: Option<String>,
    hidden: Vec<String>,
    traces: Vec<(String, Point2<'a, M>)>,
    sketches: Vec<Sketched<'a, M>>,
    past: Vec<Instant<M>>,
}

/// Width and height of a picture in pixels of 1/96 inch.
const SIZE: [f64; 2] = [640.0, 400.0];
/// The longest arrows take this part of the smaller side; on a free body they are the matter itself.
const LONGEST: f64 = 0.25;
const LONGEST_FREE: f64 = 0.35;

impl<'a, M: Scene> Drawing<'a, M> {
    /// A drawing of a system.
    pub fn of(system: &'a M) -> Self {
        Drawing {
            system,
            size: SIZE,
            title: String::new(),
            wanted: Wanted { names: true, ..Wanted::default() },
            free_body: None,
            hidden: Vec::new(),
            traces: Vec::new(),
            sketches: Vec::new(),
            past: Vec::new(),
        }
    }

    /// Width and height in pixels of 1/96 inch; 640 by 400 without this.
    pub fn size(mut self, width: f64, height: f64) -> Self {
        self.size = [width, height];
        self
    }

    /// Sets the title.
    pub fn title(mut self, title: &str) -> Self {
        title.clone_into(&mut self.title);
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

    /// Forces and moments that have names: those that are declared, weights, those of springs and dampers, and those by which joints
    /// uphold their constraints. Torques on angles act on the bodies that turn as the angles do. A line below the picture names what of
    /// this cannot be drawn: the forces of joints that the coordinates fulfil by themselves, and torques on angles that do not tell
    /// which bodies they turn; [`hide`](Self::hide) takes a name out of it. Hand-written constraints and potentials, contacts and dry
    /// friction act, too, without having such names; [`free_body`](Self::free_body) shows what all of them amount to.
    pub fn forces(mut self) -> Self {
        self.wanted.forces = true;
        self
    }

    /// Nothing but one body and the forces and moments that act on it.
    ///
    /// What acts besides those of [`forces`](Self::forces) follows from the motion. Its resultant is drawn in dark grey at the centre
    /// of mass: the force R = m a − Σ F, and the moment M_R = J α − Σ M about the centre of mass, unless only rounding is left of
    /// them. [`Moment::force`] knows R by this name.
    pub fn free_body(mut self, body: &str) -> Self {
        self.free_body = Some(body.to_owned());
        self.wanted.is_free = true;
        self.forces()
    }

    /// The instantaneous centres of rotation M, each with a ray from the centre of mass. Where a body does not turn there is
    /// none; one that is far away is indicated by its ray.
    pub fn centers(mut self) -> Self {
        self.wanted.centers = true;
        self
    }

    /// The own axes X and Y of the bodies.
    pub fn frames(mut self) -> Self {
        self.wanted.frames = true;
        self
    }

    /// Without the body, line, connector, joint or load of this name.
    pub fn hide(mut self, name: &str) -> Self {
        self.hidden.push(name.to_owned());
        self
    }

    /// Without the names of bodies and connectors.
    pub fn nameless(mut self) -> Self {
        self.wanted.names = false;
        self
    }

    /// The path of a point, given at a time and a state `[q…, v…]`, through all moments so far.
    pub fn trace(
        mut self,
        label: &str,
        point: impl Fn(&M, M::Scalar, &M::State) -> [M::Scalar; 2] + 'a,
    ) -> Self {
        self.traces.push((label.to_owned(), Rc::new(point)));
        self
    }

    /// Moments before those of the pictures, for traces; the window shows what is drawn then, too.
    pub fn past(mut self, states: impl IntoIterator<Item = (M::Scalar, M::State)>) -> Self {
        self.past.extend(states);
        self
    }

    /// Whatever else is to be drawn at a moment.
    pub fn annotate(mut self, sketch: impl Fn(&mut Sketch, &Moment<'_, M>) + 'a) -> Self {
        self.sketches.push(Rc::new(sketch));
        self
    }
}

impl<M: Scene> Drawing<'_, M>
where
    M::Scalar: Into<f64>,
{
    /// The picture at a time and a state `[q…, v…]`.
    ///
    /// # Errors
    /// If a number is not finite, the scene lacks the free body or what is to be hidden, there is nothing to draw, or the picture is too small.
    pub fn picture(&self, t: M::Scalar, y: &M::State) -> Result<Picture, DrawError> {
        self.pictures([(t, *y)])?.pop().ok_or(DrawError::NothingToDraw)
    }

    /// Pictures at several times and states, with one window and one scale of arrows.
    ///
    /// # Errors
    /// Those of [`picture`](Self::picture).
    pub fn pictures(
        &self,
        states: impl IntoIterator<Item = (M::Scalar, M::State)>,
    ) -> Result<Vec<Picture>, DrawError> {
        self.pictures_of(states.into_iter().map(|instant| (instant, None)))
    }

    /// Pictures of a system that may be another one from instant to instant.
    pub(super) fn pictures_of(
        &self,
        shots: impl IntoIterator<Item = Shot<M>>,
    ) -> Result<Vec<Picture>, DrawError> {
        let past = self.past.iter().map(|instant| (*instant, None));
        let shots: Vec<Shot<M>> = past.chain(shots).collect();
        let snapshots = shots.iter().map(|shot| self.snapshot(shot));
        let snapshots: Vec<Snapshot> = snapshots.collect::<Result<_, _>>()?;
        let elsewhere = shots.first().map(|(first, _)| self.elsewhere(first));
        let anchored = elsewhere.as_ref().map(|elsewhere| anchored(&snapshots, elsewhere));
        let fixed = Fixed {
            stretches: stretches(&snapshots),
            anchored: anchored.unwrap_or_default(),
            lanes: lanes(&snapshots, elsewhere.as_ref()),
        };
        let turning = |snapshot: &Snapshot| {
            let rates = snapshot.bodies.iter().map(|body| body.motion.angular_velocity.abs());
            rates.fold(0.0, f64::max)
        };
        let fastest = snapshots.iter().map(turning).fold(0.0, f64::max);
        let mut paths: Vec<Vec<Point>> = vec![Vec::new(); self.traces.len()];
        let mut film = Vec::new();
        for (shot, snapshot) in shots.iter().zip(&snapshots) {
            let mut elements = stage::elements(snapshot, self.wanted, &fixed, fastest);
            elements.extend(self.traced(shot, &mut paths));
            elements.extend(self.sketched(shot, snapshot));
            film.push((shot.0.0.into(), elements));
        }
        let longest = if self.free_body.is_some() { LONGEST_FREE } else { LONGEST };
        let note = self.note(&snapshots);
        let paper = Paper { size: self.size, title: &self.title, note: &note, longest };
        let pictures = layout::pictures(&film, paper)?;
        Ok(pictures.into_iter().skip(self.past.len()).collect())
    }

    /// The system that is drawn.
    pub(super) fn system(&self) -> &M {
        self.system
    }

    /// The system as it is in this shot.
    fn system_in<'s>(&'s self, (_, other): &'s Shot<M>) -> &'s M {
        other.as_ref().unwrap_or(self.system)
    }

    fn snapshot(&self, shot: &Shot<M>) -> Result<Snapshot, DrawError> {
        let (t, y) = &shot.0;
        let (q, v) = split::<M>(y);
        let snapshot = Snapshot::of(self.system_in(shot), *t, &q, &v);
        for name in &self.hidden {
            if !snapshot.names().any(|known| known == name) {
                return Err(DrawError::UnknownItem(name.clone()));
            }
        }
        let Some(name) = &self.free_body else { return Ok(snapshot.without(&self.hidden)) };
        // Hidden forces have names; they are not missing.
        let remainder = snapshot.remainder_of(name, M::Scalar::epsilon().into());
        let snapshot = snapshot.without(&self.hidden);
        if snapshot.body(name).is_none() {
            return Err(DrawError::UnknownBody(name.clone()));
        }
        Ok(Snapshot { remainder, ..snapshot.free_body(name) })
    }

    /// Returns the note about loads that act but cannot be drawn, if loads are drawn.
    fn note(&self, snapshots: &[Snapshot]) -> String {
        let omitted = snapshots.first().map(|snapshot| snapshot.omitted.as_slice()).unwrap_or_default();
        if omitted.is_empty() || !self.wanted.forces {
            return String::new();
        }
        let of = |name: &String| match name.split_once(" on `") {
            Some((load, angle)) => {
                format!("{load} on {}", Label::parse(&formula(angle.trim_end_matches('`'))).plain())
            }
            None if name.contains(' ') => name.clone(),
            None => format!("force of {}", name.replace('_', " ")),
        };
        format!("not drawn: {}", omitted.iter().map(of).collect::<Vec<_>>().join(", "))
    }

    /// The scene in another configuration at another time: what is in the same place there does not move.
    fn elsewhere(&self, (t, y): &Instant<M>) -> Snapshot {
        let (mut q, v) = split::<M>(y);
        // No period is a fraction of such steps.
        for (index, coordinate) in q.as_mut().iter_mut().enumerate() {
            let step = M::Scalar::from_f64(0.739 + 0.107 * index as f64);
            *coordinate = M::Scalar::from_f64(1.31) * *coordinate + step;
        }
        M::normalise(&mut q);
        Snapshot::of(self.system, *t + M::Scalar::from_f64(0.577), &q, &v)
    }

    /// Adds the present points to the paths.
    fn traced(&self, shot: &Shot<M>, paths: &mut [Vec<Point>]) -> Vec<Element> {
        let ((t, y), system) = (&shot.0, self.system_in(shot));
        let mut elements = Vec::new();
        for (index, ((label, point), path)) in self.traces.iter().zip(paths).enumerate() {
            path.push(point(system, *t, y).map(Into::into));
            elements.extend(stage::trace(label, path, colour::trace(index)));
        }
        elements
    }

    fn sketched(&self, shot: &Shot<M>, snapshot: &Snapshot) -> Vec<Element> {
        let ((t, y), system) = (&shot.0, self.system_in(shot));
        let mut elements = Vec::new();
        for draw in &self.sketches {
            let mut sketch = Sketch::new();
            draw(&mut sketch, &Moment::new(system, *t, *y, snapshot));
            elements.extend(sketch.elements);
        }
        elements
    }
}

impl<M: Scene> Clone for Drawing<'_, M> {
    fn clone(&self) -> Self {
        Drawing {
            title: self.title.clone(),
            free_body: self.free_body.clone(),
            hidden: self.hidden.clone(),
            traces: self.traces.clone(),
            sketches: self.sketches.clone(),
            past: self.past.clone(),
            ..*self
        }
    }
}

impl<M: Scene> Debug for Drawing<'_, M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Drawing")
            .field("size", &self.size)
            .field("title", &self.title)
            .finish_non_exhaustive()
    }
}
