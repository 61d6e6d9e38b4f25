//! Motions in space, recorded as moving meshes.

use super::projector::Projector;
use super::recording::{Recording, Trace};
use super::size::Size;
use super::snapshot::difference;
use super::stage;
use super::surroundings::{Surroundings, path, sample_terrain};
use crate::colour;
use crate::drawing::{Drawing, DrawnSpace, Instant, Shot};
use crate::error::{DrawError, refusal};
use lagrange_runtime::scene::{Scene, Spatial};
use lagrange_runtime::system::split;

impl DrawnSpace for Spatial {
    const SIZE: [f64; 2] = [640.0, 480.0];
    type Recording = Projector;

    fn record<M: Scene<Space = Spatial>>(
        drawing: &Drawing<'_, M>,
        shots: &[Shot<M>],
    ) -> Result<Projector, DrawError>
    where
        M::Scalar: Into<f64>,
    {
        let snapshot = |shot| Ok(drawing.snapshot(shot)?.without(&drawing.hidden));
        let mut snapshots = shots.iter().map(snapshot).collect::<Result<Vec<_>, DrawError>>()?;
        let differing = snapshots.iter().find_map(|snapshot| difference(&snapshots[0], snapshot));
        if let Some(name) = differing {
            return Err(refusal(&format!("`{name}` changes from moment to moment")));
        }
        // Past motion is visible only in traces.
        let size = Size::of(&snapshots);
        sample_terrain(&mut snapshots, &size, false, |moment, keep| {
            let ((t, y), system) = (&shots[moment].0, drawing.system_in(&shots[moment]));
            let (q, v) = split::<M>(y);
            system.items(*t, &q, &v, keep);
        });
        let surroundings = Surroundings { film: &snapshots, size: &size, is_live: false };
        let mut things = stage::things(&surroundings, drawing.wanted);
        let paths = drawing.paths.iter().enumerate().filter(|(_, (_, points))| points.len() > 1);
        things
            .extend(paths.map(|(index, (label, points))| {
                path(label, points, colour::ink(index + 1), snapshots.len())
            }));
        let traces = drawing.traces.iter().enumerate().map(|(index, (label, point))| {
            let place = |system: &M, (t, y): &Instant<M>| point(system, *t, y).map(Into::into);
            Trace {
                label: label.clone(),
                colour: colour::trace(index),
                past: drawing.past.iter().map(|instant| place(drawing.system(), instant)).collect(),
                points: shots.iter().map(|shot| place(drawing.system_in(shot), &shot.0)).collect(),
            }
        });
        let traces = traces.collect();
        let times = shots.iter().map(|((t, _), _)| (*t).into()).collect();
        let recording = Recording { times, things, traces, note: drawing.note(&snapshots) };
        Projector::new(recording.checked()?, drawing.look.clone())
    }
}
