//! Films: motions as HTML pages, as GIF, and as animated SVG or glTF.
//!
//! [`layers`] determines how each mark of a picture changes, since files store changes instead of
//! whole pictures. [`motion`] detects marks that only rotate and move.

mod animation;
mod chart;
mod gif;
mod layers;
mod motion;
pub(crate) mod page;
mod palette;
mod plane;
pub(crate) mod trajectory;

use std::borrow::Cow;
use std::path::Path;

use crate::drawing::DrawnSpace;
use crate::error::{DrawError, refusal};
use crate::picture::{Mark, Picture, Segment};
use crate::recorded::Recorded;
use crate::timeline::{Curve, Timeline};
use lagrange_files::save_bytes;
use lagrange_runtime::scene::Plane;

/// A motion in the plane or in space, with the display time of each moment.
///
/// | file | what it is for |
/// |---|---|
/// | `html` | one file without anything from elsewhere: play, pause, scrub, speed, and curves of energy with a cursor; in space turned and zoomed with the mouse |
/// | `gif` | plays wherever pictures are shown, in space seen as [`view`](crate::Drawing::view) says |
/// | `svg` | in the plane: plays in any browser, without a script; sharp at any size |
/// | `glb` | in space: bodies and their motion as glTF 2.0, for viewers and Blender |
///
/// All formats play in real time: one unit of time of the motion is one second of the film.
///
/// ```text
/// let film = Drawing::of(&system).film(&trajectory)?.with_columns(&trajectory, &["kinetic", "potential"])?;
/// film.save("pendulum.html")?;
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct Film<D: DrawnSpace = Plane> {
    pub(super) recording: D::Recording,
    pub(super) timeline: Timeline,
    /// The time of the system in each picture.
    pub(super) instants: Vec<f64>,
}

impl Film {
    /// Creates a film of pictures displayed at these times, in seconds. They rise, or fall if the
    /// motion ran backwards.
    ///
    /// # Errors
    /// If any of these holds:
    /// - there is no picture, or not one time for each picture;
    /// - times neither rise nor fall throughout;
    /// - pictures differ in size or in their number of marks;
    /// - a mark is not at a finite place.
    pub fn new(pictures: Vec<Picture>, times: Vec<f64>) -> Result<Film, DrawError> {
        check_count(&times, pictures.len())?;
        let timeline = Timeline::new(times.clone())?;
        check_pictures(&pictures)?;
        Ok(Film { recording: pictures, timeline, instants: times })
    }
}

impl<D: DrawnSpace> Film<D> {
    /// Adds a curve to the plot below the picture of a page, with a value for each picture.
    /// Energies are in joule if they are in SI units. Values that are not finite leave a gap.
    ///
    /// # Errors
    /// If there is not one value for each picture.
    pub fn with_values(mut self, name: &str, values: Vec<f64>) -> Result<Self, DrawError> {
        if values.len() != self.times().len() {
            let (values, pictures) = (values.len(), self.times().len());
            return Err(refusal(&format!("`{name}` has {values} values for {pictures} pictures")));
        }
        self.timeline.curves.push(Curve { name: name.to_owned(), values });
        Ok(self)
    }

    /// Returns the display times of the pictures.
    pub fn times(&self) -> &[f64] {
        &self.timeline.times
    }

    /// Returns the pictures, in space from the viewpoint of the drawing.
    pub fn pictures(&self) -> Cow<'_, [Picture]> {
        self.recording.pictures()
    }

    /// Returns the film as a self-contained HTML page, with curves below the picture. It can be
    /// played, paused and scrubbed; in space it can be turned with the mouse and zoomed. Without
    /// scripts, or in space without WebGL 2, it shows the first picture. If the reader prefers
    /// reduced motion, it does not start automatically.
    pub fn html(&self) -> String {
        self.recording.page(&self.timeline)
    }

    /// Saves the film to a file. The extension selects an HTML page, GIF, animated SVG in the
    /// plane, or glTF in space. An older file stays until the new one is complete.
    ///
    /// # Errors
    /// If the extension is not `html`, `gif`, `svg` in the plane or `glb` in space, or the file
    /// cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), DrawError> {
        let path = path.as_ref();
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let bytes = match extension.to_ascii_lowercase().as_str() {
            "html" => self.html().into_bytes(),
            "gif" => self.gif()?,
            own if own == D::Recording::FORMAT => self.recording.file(&self.timeline)?,
            _ => return Err(DrawError::extension(path, &[D::Recording::FORMAT, "gif", "html"])),
        };
        DrawError::written(path, save_bytes(path, bytes))
    }
}

fn check_count(times: &[f64], pictures: usize) -> Result<(), DrawError> {
    if pictures == 0 {
        return Err(refusal("a film needs at least one picture"));
    }
    if times.len() != pictures {
        return Err(refusal(&format!("{pictures} pictures have {} times", times.len())));
    }
    Ok(())
}

fn check_pictures(pictures: &[Picture]) -> Result<(), DrawError> {
    for (index, picture) in pictures.iter().enumerate() {
        if picture.size != pictures[0].size {
            return Err(refusal(&format!("picture {index} differs in size from the first")));
        }
        if picture.marks.len() != pictures[0].marks.len() {
            return Err(refusal(&format!("picture {index} differs in its marks from the first")));
        }
        if !picture.marks.iter().all(is_finite) {
            return Err(refusal(&format!("a mark of picture {index} is not at a finite position")));
        }
    }
    Ok(())
}

fn is_finite(mark: &Mark) -> bool {
    match mark {
        Mark::Path { segments, .. } => {
            segments.iter().copied().flat_map(points).flatten().all(f64::is_finite)
        }
        Mark::Text { at, .. } => at.iter().all(|coordinate| coordinate.is_finite()),
    }
}

/// Returns the points of a segment, in writing order.
fn points(segment: Segment) -> Vec<[f64; 2]> {
    match segment {
        Segment::Move(end) | Segment::Line(end) => vec![end],
        Segment::Curve(first, second, end) => vec![first, second, end],
        Segment::Close => Vec::new(),
    }
}

#[cfg(test)]
mod tests;
