//! Films: pictures of one scene at several times, as animated SVG, as GIF, or as an HTML page.
//!
//! | file | what it is for |
//! |---|---|
//! | `svg` | plays in any browser, without a script; sharp at any size |
//! | `gif` | plays wherever pictures are shown |
//! | `html` | one file without anything from elsewhere: play, pause, scrub, speed, and curves of energy with a cursor |
//!
//! All of them play in real time: one second of the motion, in its own unit of time, is a second of the film.
//!
//! [`layers`] finds out how each mark changes, which the files hold instead of whole pictures; [`motion`] finds marks that only
//! turn and move.

mod animation;
mod chart;
mod gif;
mod layers;
mod motion;
pub(crate) mod page;
mod palette;
pub(crate) mod timeline;
pub(crate) mod trajectory;

use std::path::Path;

use crate::error::DrawError;
use crate::film::timeline::Timeline;
use crate::picture::{Mark, Picture, Segment};
use lagrange_files::save_bytes;

/// Pictures of one scene, and when each is shown.
///
/// ```text
/// let film = Drawing::of(&system).film(&trajectory)?.with_columns(&trajectory, &["kinetic", "potential"])?;
/// film.save("pendulum.html")?;
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct Film {
    pub(super) pictures: Vec<Picture>,
    pub(super) timeline: Timeline,
}

impl Film {
    /// A film of pictures that are shown at these times, in seconds: rising, or falling if the motion ran backwards.
    ///
    /// # Errors
    /// If there is no picture, not one time for each picture, if times do not rise or fall throughout, if pictures differ in size or
    /// in their number of marks, or if a mark is not at a finite place.
    pub fn new(pictures: Vec<Picture>, times: Vec<f64>) -> Result<Film, DrawError> {
        check_count(&times, pictures.len())?;
        let timeline = Timeline::new(times)?;
        check_pictures(&pictures)?;
        Ok(Film { pictures, timeline })
    }

    /// Pictures whose marks may be others from picture to picture, for what shows them whole.
    pub(crate) fn of(pictures: Vec<Picture>, timeline: Timeline) -> Film {
        Film { pictures, timeline }
    }

    /// Adds a curve to the plot under the picture of a page: a value for each picture, in joule if it is an energy in SI units.
    /// Values that are not finite leave a gap.
    ///
    /// # Errors
    /// If there is not one value for each picture.
    pub fn with_values(self, name: &str, values: Vec<f64>) -> Result<Film, DrawError> {
        Ok(Film { timeline: self.timeline.with_values(name, values)?, ..self })
    }

    /// When its pictures are shown.
    pub fn times(&self) -> &[f64] {
        &self.timeline.times
    }

    /// Its pictures.
    pub fn pictures(&self) -> &[Picture] {
        &self.pictures
    }

    /// Saves it to a file: animated SVG, GIF or an HTML page, by the extension. An older file stays until the new one is whole.
    ///
    /// # Errors
    /// If the extension is none of `svg`, `gif`, `html`, or the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), DrawError> {
        let path = path.as_ref();
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let bytes = match extension.to_ascii_lowercase().as_str() {
            "svg" => self.svg().into_bytes(),
            "html" => self.html().into_bytes(),
            "gif" => self.gif()?,
            _ => return Err(DrawError::extension(path, &["svg", "gif", "html"])),
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
            return Err(refusal(&format!("picture {index} has another size than the first")));
        }
        if picture.marks.len() != pictures[0].marks.len() {
            return Err(refusal(&format!("picture {index} has other marks than the first")));
        }
        if !picture.marks.iter().all(is_finite) {
            return Err(refusal(&format!("a mark of picture {index} is not at a finite place")));
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

/// The points of a segment, in the order in which they are written.
fn points(segment: Segment) -> Vec<[f64; 2]> {
    match segment {
        Segment::Move(end) | Segment::Line(end) => vec![end],
        Segment::Curve(first, second, end) => vec![first, second, end],
        Segment::Close => Vec::new(),
    }
}

pub(crate) fn refusal(reason: &str) -> DrawError {
    DrawError::Film(reason.to_string())
}

#[cfg(test)]
mod tests;
