//! Films of systems in space, as GIF, as an HTML page in which they can be turned, or as glTF.

use std::path::Path;

use super::drawing::SpatialDrawing;
use super::glb;
use super::page;
use super::projector::{Look, Projector};
use super::recording::Recording;
use crate::drawing::Shot;
use crate::error::DrawError;
use crate::film::Film;
use crate::film::timeline::Timeline;
use crate::film::trajectory::{ENERGY, samples, samples_at};
use crate::picture::Picture;
use lagrange_files::save_bytes;
use lagrange_runtime::scene::SpatialScene;
use lagrange_runtime::simulate::Trajectory;
use lagrange_runtime::system::MechanicalSystem;

/// A motion in space, and when each of its moments is shown.
///
/// | file | what it is for |
/// |---|---|
/// | `html` | one file without anything from elsewhere: play, pause, scrub, turn with the mouse, zoom, and curves with a cursor |
/// | `gif` | plays wherever pictures are shown, seen as [`view`](SpatialDrawing::view) says |
/// | `glb` | bodies and their motion as glTF 2.0, for viewers and Blender |
///
/// All of them play in real time: one second of the motion, in its own unit of time, is a second of the film.
#[derive(Clone, PartialEq, Debug)]
pub struct SpatialFilm {
    pub(super) recording: Recording,
    pub(super) look: Look,
    pub(super) timeline: Timeline,
}

impl<M: SpatialScene> SpatialDrawing<'_, M>
where
    M::Scalar: Into<f64>,
{
    /// A film of the samples of a trajectory, as [`Drawing::film`](crate::Drawing::film) makes it of a system in the plane.
    ///
    /// # Errors
    /// If a picture cannot be made, as [`picture`](SpatialDrawing::picture) says.
    pub fn film(&self, trajectory: &Trajectory<M>) -> Result<SpatialFilm, DrawError> {
        let film = self.film_of(&samples(trajectory, self.system())?)?;
        if trajectory.column(ENERGY).is_some() { film.with_columns(trajectory, &[ENERGY]) } else { Ok(film) }
    }

    /// A film of about this many pictures a second from a run that was
    /// [`dense`](lagrange_runtime::simulate::Simulation::dense), as [`Drawing::film_at`](crate::Drawing::film_at) makes it.
    ///
    /// # Errors
    /// If the run was not dense, the number is not positive and finite, or a picture cannot be made.
    pub fn film_at(
        &self,
        pictures_a_second: f64,
        trajectory: &Trajectory<M>,
    ) -> Result<SpatialFilm, DrawError> {
        self.film_of(&samples_at(pictures_a_second, trajectory, self.system())?)
    }

    pub(super) fn film_of(&self, shots: &[Shot<M>]) -> Result<SpatialFilm, DrawError> {
        let recording = self.recording(shots)?;
        let timeline = Timeline::new(recording.times.clone())?;
        // What cannot be drawn is refused here, and not when it is written.
        let look = self.look().clone();
        Projector::new(&recording, &look)?;
        Ok(SpatialFilm { recording, look, timeline })
    }
}

impl SpatialFilm {
    /// When its moments are.
    pub fn times(&self) -> &[f64] {
        &self.timeline.times
    }

    /// Its pictures, seen as the drawing says.
    ///
    /// # Errors
    /// If they are too small for their margins.
    pub fn pictures(&self) -> Result<Vec<Picture>, DrawError> {
        Ok(Projector::new(&self.recording, &self.look)?.pictures(0..self.recording.times.len()))
    }

    /// Adds a curve to the plot under the picture of a page, as [`Film::with_values`] does.
    ///
    /// # Errors
    /// If there is not one value for each moment.
    pub fn with_values(self, name: &str, values: Vec<f64>) -> Result<SpatialFilm, DrawError> {
        Ok(SpatialFilm { timeline: self.timeline.with_values(name, values)?, ..self })
    }

    /// Adds columns of the trajectory that the film was made of to what pages plot.
    ///
    /// # Errors
    /// If there is no such column, or no sample at the time of one of the moments.
    pub fn with_columns<M: MechanicalSystem>(
        self,
        trajectory: &Trajectory<M>,
        names: &[&str],
    ) -> Result<SpatialFilm, DrawError>
    where
        M::Scalar: Into<f64>,
    {
        Ok(SpatialFilm { timeline: self.timeline.with_columns(trajectory, names)?, ..self })
    }

    /// Adds a quantity to what pages plot, from times and states of the trajectory that the film was made of.
    ///
    /// # Errors
    /// If the trajectory does not know the state at the time of one of the moments.
    pub fn with_energy<M: MechanicalSystem>(
        self,
        name: &str,
        trajectory: &Trajectory<M>,
        energy: impl Fn(M::Scalar, &M::State) -> M::Scalar,
    ) -> Result<SpatialFilm, DrawError>
    where
        M::Scalar: Into<f64>,
    {
        Ok(SpatialFilm { timeline: self.timeline.with_energy(name, trajectory, energy)?, ..self })
    }

    /// The film as an HTML page that needs nothing else: to turn with the mouse and to zoom, to play, pause and scrub, with curves under the
    /// picture. Where scripts or WebGL 2 are missing it shows the first picture; where less motion is preferred, it waits to be started.
    ///
    /// # Errors
    /// If pictures are too small for their margins.
    pub fn html(&self) -> Result<String, DrawError> {
        let first = Projector::new(&self.recording, &self.look)?.pictures(0..1).pop();
        let first = first.ok_or(DrawError::NothingToDraw)?;
        Ok(page::html(&self.recording, &self.look, &self.timeline, &first))
    }

    /// The bodies and their motion as glTF 2.0, binary: a node for each thing, turned, moved and stretched as it is at each moment. Traces are
    /// there in full length from the beginning; names of bodies are those of nodes, and other labels are left out.
    ///
    /// # Errors
    /// If the file would be larger than its format can tell.
    pub fn glb(&self) -> Result<Vec<u8>, DrawError> {
        glb::file(&self.recording, &self.look.title, &self.timeline.elapsed())
    }

    /// The film as a GIF, as [`Film::gif`] makes it.
    ///
    /// # Errors
    /// Those of [`Film::gif`].
    pub fn gif(&self) -> Result<Vec<u8>, DrawError> {
        Film::of(self.pictures()?, self.timeline.clone()).gif()
    }

    /// Saves it to a file: HTML page, GIF or glTF, by the extension. An older file stays until the new one is whole.
    ///
    /// # Errors
    /// If the extension is none of `html`, `gif`, `glb`, or the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), DrawError> {
        let path = path.as_ref();
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let bytes = match extension.to_ascii_lowercase().as_str() {
            "html" => self.html()?.into_bytes(),
            "gif" => self.gif()?,
            "glb" => self.glb()?,
            _ => return Err(DrawError::extension(path, &["html", "gif", "glb"])),
        };
        DrawError::written(path, save_bytes(path, bytes))
    }
}
