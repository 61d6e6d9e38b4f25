//! Motions in the plane, recorded as pictures with the same marks in the same order.

use std::borrow::Cow;

use crate::anchored::anchored;
use crate::colour;
use crate::drawing::{Drawing, DrawnSpace, Instant, Shot};
use crate::element::Element;
use crate::error::DrawError;
use crate::film::animation::animated;
use crate::film::{check_pictures, page};
use crate::layout;
use crate::moment::Moment;
use crate::paper::Paper;
use crate::parallel::lanes;
use crate::picture::{Picture, Point};
use crate::recorded::Recorded;
use crate::sketch::Sketch;
use crate::snapshot::{Form, Snapshot, sampled};
use crate::stage::{self, Fixed};
use crate::stretch::{Stretches, samples, stretches};
use crate::timeline::Timeline;
use lagrange_runtime::scalar::{Number, Scalar};
use lagrange_runtime::scene::{Item, Plane, Scene};
use lagrange_runtime::system::split;

/// Length of the longest arrows relative to the smaller side.
const LONGEST: f64 = 0.25;
/// Length of the longest arrows on a free body, where they are the main content.
const LONGEST_FREE: f64 = 0.35;

impl DrawnSpace for Plane {
    const SIZE: [f64; 2] = [640.0, 400.0];
    type Recording = Vec<Picture>;

    fn record<M: Scene<Space = Plane>>(
        drawing: &Drawing<'_, M>,
        shots: &[Shot<M>],
    ) -> Result<Vec<Picture>, DrawError>
    where
        M::Scalar: Into<f64>,
    {
        let past: Vec<Shot<M>> = drawing.past.iter().map(|instant| (*instant, None)).collect();
        let shots: Vec<&Shot<M>> = past.iter().chain(shots).collect();
        let snapshots = shots.iter().map(|shot| drawing.shown(shot));
        let mut snapshots: Vec<Snapshot> = snapshots.collect::<Result<_, _>>()?;
        let elsewhere = shots.first().map(|(first, _)| drawing.elsewhere(first));
        let anchored = elsewhere.as_ref().map(|elsewhere| anchored(&snapshots, elsewhere));
        let stretches = stretches(&snapshots);
        for (shot, snapshot) in shots.iter().zip(&mut snapshots) {
            drawing.sample_terrain(shot, snapshot, &stretches);
        }
        let fixed = Fixed {
            stretches,
            anchored: anchored.unwrap_or_default(),
            lanes: lanes(&snapshots, elsewhere.as_ref()),
        };
        let turning = |snapshot: &Snapshot| {
            let rates = snapshot.bodies.iter().map(|body| body.motion.angular_velocity.abs());
            rates.fold(0.0, f64::max)
        };
        let fastest = snapshots.iter().map(turning).fold(0.0, f64::max);
        let mut paths: Vec<Vec<Point>> = vec![Vec::new(); drawing.traces.len()];
        let mut film = Vec::new();
        for (shot, snapshot) in shots.iter().zip(&snapshots) {
            let mut elements = stage::elements(snapshot, drawing.wanted, &fixed, fastest);
            elements.extend(drawing.traced(shot, &mut paths));
            elements.extend(drawing.sketched(shot, snapshot));
            film.push((shot.0.0.into(), elements));
        }
        let longest = if drawing.free_body.is_some() { LONGEST_FREE } else { LONGEST };
        let paper = Paper::new(&drawing.look, &drawing.note(&snapshots));
        let mut pictures = layout::pictures(&film, &paper, longest)?;
        pictures.drain(..past.len());
        check_pictures(&pictures)?;
        Ok(pictures)
    }
}

impl Recorded for Vec<Picture> {
    const FORMAT: &'static str = "svg";

    fn pictures(&self) -> Cow<'_, [Picture]> {
        Cow::Borrowed(self)
    }

    fn page(&self, timeline: &Timeline) -> String {
        page::of_pictures(self, timeline)
    }

    fn file(&self, timeline: &Timeline) -> Result<Vec<u8>, DrawError> {
        Ok(animated(self, timeline).into_bytes())
    }
}

impl<M: Scene<Space = Plane>> Drawing<'_, M>
where
    M::Scalar: Into<f64>,
{
    /// Returns the scene of a shot without hidden items, reduced to the free body if one is
    /// selected.
    fn shown(&self, shot: &Shot<M>) -> Result<Snapshot, DrawError> {
        let snapshot = self.snapshot(shot)?;
        let Some(name) = &self.free_body else { return Ok(snapshot.without(&self.hidden)) };
        // Hidden forces have names; they are not part of the resultant.
        let remainder = snapshot.remainder_of(name, M::Scalar::epsilon().into());
        let snapshot = snapshot.without(&self.hidden);
        if snapshot.body(name).is_none() {
            return Err(DrawError::UnknownBody(name.clone()));
        }
        Ok(Snapshot { remainder, ..snapshot.free_body(name) })
    }

    /// Samples the heights of terrain along its drawn stretches.
    fn sample_terrain(&self, shot: &Shot<M>, snapshot: &mut Snapshot, stretches: &Stretches) {
        let ((t, y), system) = (&shot.0, self.system_in(shot));
        let (q, v) = split::<M>(y);
        for support in &mut snapshot.supports {
            if let (Form::Terrain(_), Some(stretches)) = (&support.form, stretches.get(&support.name)) {
                let visit = |keep: &mut dyn FnMut(Item<'_, M::Scalar>)| system.items(*t, &q, &v, keep);
                support.form = sampled(visit, &support.name, samples(stretches));
            }
        }
    }

    /// Returns the scene in a different configuration at a different time. Items in the same place
    /// there are fixed.
    fn elsewhere(&self, (t, y): &Instant<M>) -> Snapshot {
        let (mut q, v) = split::<M>(y);
        // No period is a multiple or fraction of these steps.
        for (index, coordinate) in q.as_mut().iter_mut().enumerate() {
            let step = M::Scalar::from_f64(0.739 + 0.107 * index as f64);
            *coordinate = M::Scalar::from_f64(1.31) * *coordinate + step;
        }
        M::normalise(&mut q);
        Snapshot::of(self.system(), *t + M::Scalar::from_f64(0.577), &q, &v)
    }

    /// Adds the current points to the paths.
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
        let mut sketch = Sketch::new();
        for draw in &self.sketches {
            sketch.ink(0);
            draw(&mut sketch, &Moment::new(system, *t, *y, snapshot));
        }
        sketch.elements
    }
}
