//! Figures of curves, areas and coloured cells, saved as SVG or PNG.
//!
//! A [`Figure`] is a grid of panels with separate axes; a [`Panel`] contains curves. No settings
//! are required: ranges, marks, labels and colours follow from the numbers. Colours follow Okabe
//! and Ito, *Color Universal Design* (2008), and are distinguishable with any colour vision. The
//! colours of more than seven curves range from blue to yellow.

use std::fmt::{Debug, Display, Formatter};
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

use lagrange_files::{save, save_bytes};

use crate::axes::{FINENESS, Frame};
use crate::canvas::Canvas;
use crate::document::Document;
use crate::image::Placed;
use crate::panel::Panel;
use crate::paper::Paper;
use crate::pixels::Pixels;

/// Panels arranged in a grid.
#[derive(Clone, PartialEq, Debug)]
pub struct Figure {
    /// The panels, row by row.
    pub panels: Vec<Panel>,
    /// Number of panels in a row.
    pub columns: usize,
    /// Width and height of a panel with its labels, in screen pixels of 1/96 inch.
    pub size: (u32, u32),
}

/// Number of points per pixel of PNG files, which have twice the resolution of a screen with 96
/// dots per inch.
const POINTS_A_PIXEL: u32 = 5;

impl Figure {
    /// Creates a figure of one panel, with a size at which each of its cells has a whole number of
    /// pixels in a PNG file.
    pub fn of_cells(panel: Panel) -> Figure {
        let size = panel.size_of_cells(FINENESS / POINTS_A_PIXEL);
        Figure { panels: vec![panel], columns: 1, size }
    }

    /// Saves the figure as SVG or PNG, depending on the extension of the file. An older file
    /// remains until the new one is complete.
    ///
    /// # Errors
    /// If the extension differs from both, an image cannot be encoded, or the file cannot be
    /// written.
    pub fn save(&self, path: &Path) -> Result<(), PlotError> {
        let written =
            |result: io::Result<()>| result.map_err(|error| PlotError::Io { path: path.to_owned(), error });
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        match extension.to_ascii_lowercase().as_str() {
            "svg" => written(save_bytes(path, self.svg()?)),
            "png" => {
                let pixels = self.pixels()?;
                written(save(path, |error| error, |file| pixels.save(&mut BufWriter::new(file))))
            }
            _ => Err(PlotError::Extension(path.to_owned())),
        }
    }

    /// Returns the figure as SVG.
    ///
    /// # Errors
    /// If an image cannot be encoded.
    pub fn svg(&self) -> Result<String, PlotError> {
        let document = Document::new(self.points(), &self.title(), &self.images());
        let mut document = document.map_err(|error| PlotError::Backend(error.into()))?;
        self.draw(&mut document);
        Ok(document.finish())
    }

    /// Returns a description of the panels.
    fn title(&self) -> String {
        let titles = self.panels.iter().map(Panel::title).filter(|title| !title.is_empty());
        titles.collect::<Vec<_>>().join("; ")
    }

    /// Draws the figure in pixels.
    pub(crate) fn pixels(&self) -> Result<Pixels, PlotError> {
        let size = self.points();
        let too_large = || PlotError::Backend(format!("{} by {} are too many pixels", size.0, size.1).into());
        let mut canvas = Canvas::new(size, POINTS_A_PIXEL).ok_or_else(too_large)?;
        self.images().iter().for_each(|image| canvas.place(image));
        self.draw(&mut canvas);
        Ok(canvas.pixels)
    }

    /// Returns the images below all other content.
    fn images(&self) -> Vec<Placed> {
        self.frames().flat_map(|(panel, frame)| panel.images(&frame)).collect()
    }

    fn draw(&self, paper: &mut dyn Paper) {
        self.frames().for_each(|(panel, frame)| panel.draw(paper, &frame));
    }

    /// Returns the panels with their places.
    fn frames(&self) -> impl Iterator<Item = (&Panel, Frame)> {
        self.panels.iter().enumerate().map(|(index, panel)| {
            let (row, column) = (index / self.columns, index % self.columns);
            let corner = (column as u32 * self.size.0, row as u32 * self.size.1);
            (panel, Frame::new(corner, self.size))
        })
    }

    /// Returns its size in points.
    pub(crate) fn points(&self) -> (u32, u32) {
        let columns = self.columns.min(self.panels.len()) as u32;
        let rows = self.panels.len().div_ceil(self.columns) as u32;
        (FINENESS * columns * self.size.0, FINENESS * rows * self.size.1)
    }
}

/// The reason why a plot could not be made.
#[non_exhaustive]
pub enum PlotError {
    /// There is no column with this name.
    UnknownColumn {
        /// The unknown name.
        name: String,
        /// The names of all columns.
        known: Vec<String>,
    },
    /// No column was requested.
    NoColumns,
    /// An energy is requested but not recorded.
    NoEnergy,
    /// The number of cells differs from the number of values, or is zero.
    Cells {
        /// Number of values.
        values: usize,
        /// Number of cells.
        cells: usize,
    },
    /// The range of the quantity with this name does not extend from a finite number to a larger
    /// one.
    Range(String),
    /// The extension of the file is neither `svg` nor `png`.
    Extension(PathBuf),
    /// A file could not be written.
    Io {
        /// The file.
        path: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
    /// The picture is too large, or an image cannot be encoded.
    Backend(Box<dyn std::error::Error + Send + Sync>),
}

impl Display for PlotError {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            PlotError::UnknownColumn { name, known } => {
                write!(f, "there is no column `{name}`; the columns are `{}`", known.join("`, `"))
            }
            PlotError::NoColumns => {
                f.write_str("there is nothing to plot: name at least one column, such as a coordinate")
            }
            PlotError::NoEnergy => {
                f.write_str("the trajectory has no column `energy`; add `.energy()` to the simulation")
            }
            PlotError::Cells { values, cells } => {
                write!(f, "a map of {cells} cells needs a value for each; there are {values}")
            }
            PlotError::Range(name) => {
                write!(f, "the range of `{name}` must go from a finite number to a larger one")
            }
            PlotError::Extension(path) => {
                write!(f, "plots are saved as .svg or .png, but `{}` ends in neither", path.display())
            }
            PlotError::Io { path, error } => write!(f, "cannot write `{}`: {error}", path.display()),
            PlotError::Backend(error) => write!(f, "the plot could not be drawn: {error}"),
        }
    }
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl Debug for PlotError {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        write!(f, "PlotError({self})")
    }
}

impl std::error::Error for PlotError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            PlotError::Io { error, .. } => Some(error),
            PlotError::Backend(error) => Some(&**error),
            _ => None,
        }
    }
}
