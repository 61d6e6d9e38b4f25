//! Pictures and films of systems of plane rigid bodies.

mod error;
mod files;
mod picture;
pub(crate) mod raster;
pub(crate) mod svg;
mod text;

pub use error::DrawError;
pub use picture::Picture;
