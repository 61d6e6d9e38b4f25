//! Films of motions in space, as an HTML page with a rotatable view, or as glTF.

use std::borrow::Cow;

use super::glb;
use super::page;
use super::projector::Projector;
use crate::error::DrawError;
use crate::film::Film;
use crate::picture::Picture;
use crate::recorded::Recorded;
use crate::timeline::Timeline;
use lagrange_runtime::scene::Spatial;

impl Recorded for Projector {
    const FORMAT: &'static str = "glb";

    fn pictures(&self) -> Cow<'_, [Picture]> {
        Cow::Owned(self.project(0..self.recording.times.len()))
    }

    fn page(&self, timeline: &Timeline) -> String {
        page::html(self, timeline)
    }

    fn file(&self, timeline: &Timeline) -> Result<Vec<u8>, DrawError> {
        glb::file(&self.recording, &self.look.title, &timeline.elapsed())
    }
}

impl Film<Spatial> {
    /// Returns the bodies and their motion as binary glTF 2.0. Each mesh has a node that is
    /// rotated, moved and stretched at each moment. Traces have full length from the beginning.
    /// Nodes have the names of bodies, and other labels are omitted.
    ///
    /// # Errors
    /// If the file would be larger than its format allows.
    pub fn glb(&self) -> Result<Vec<u8>, DrawError> {
        self.recording.file(&self.timeline)
    }
}
