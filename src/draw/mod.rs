//! Pictures and films of systems of plane rigid bodies.

mod error;
mod files;
mod film;
mod picture;
pub(crate) mod raster;
pub(crate) mod svg;
mod text;

pub use error::DrawError;
pub use film::Film;
pub use picture::Picture;
