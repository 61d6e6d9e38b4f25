//! Files of a trade.

use std::format;
use std::fs;
use std::path::Path;

use super::diagram::diagram;
use super::report::Report;
use crate::simulate::PlotError;
use lagrange_files::save_bytes;

impl Report {
    /// Writes the runs (CSV), the diagrams (SVG) and the recommendation (Markdown) into a
    /// directory, in files named after the title. The directory is created if it does not exist.
    ///
    /// # Errors
    /// If the operating system cannot write a file, or the diagram could not be drawn.
    pub fn save(&self, directory: impl AsRef<Path>) -> Result<(), PlotError> {
        let directory = directory.as_ref();
        let at = |path: &Path| {
            let path = path.to_path_buf();
            move |error| PlotError::Io { path, error }
        };
        fs::create_dir_all(directory).map_err(at(directory))?;
        let name = self.file_name();
        for (extension, text) in [("csv", self.csv()), ("md", self.recommendation())] {
            let path = directory.join(format!("{name}.{extension}"));
            save_bytes(&path, text).map_err(at(&path))?;
        }
        diagram(self).save(&directory.join(format!("{name}.svg")))
    }
}
