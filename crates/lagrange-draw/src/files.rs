//! Pictures as files.

use std::path::Path;

use crate::error::DrawError;
use crate::picture::Picture;
use crate::raster;
use crate::svg;
use lagrange_files::save_bytes;

impl Picture {
    /// Returns the picture as an SVG document.
    pub fn svg(&self) -> String {
        svg::document(self)
    }

    /// Saves the picture to a file; an older one stays until the new one is complete. Its extension
    /// selects the format: `svg`, or `png` with two pixels per screen pixel in each direction.
    ///
    /// # Errors
    /// If the extension is not supported, the picture is too large for an image, or the operating
    /// system cannot write the file.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), DrawError> {
        let path = path.as_ref();
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        match extension.to_ascii_lowercase().as_str() {
            "svg" => DrawError::written(path, save_bytes(path, self.svg())),
            "png" => raster::save(self, path),
            _ => Err(DrawError::extension(path, &["svg", "png"])),
        }
    }
}
