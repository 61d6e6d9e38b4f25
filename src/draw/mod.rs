//! Pictures and films of systems of plane rigid bodies.
//!
//! A [`Drawing`] turns a [`Scene`](crate::scene::Scene) and states of it into [`Picture`]s. Nothing is computed of the motion
//! here, and nothing needs tuning: window, scales, colours and places of labels follow from what is drawn.

mod beside;
mod colour;
mod cut;
mod drawing;
mod element;
mod error;
mod files;
mod film;
mod geometry;
mod labels;
mod layout;
mod marks;
mod moment;
mod outline;
mod picture;
pub(crate) mod raster;
mod sketch;
mod snapshot;
mod stage;
mod stretch;
pub(crate) mod svg;
mod tag;
mod text;
mod view;

pub use drawing::Drawing;
pub use error::DrawError;
pub use film::Film;
pub use moment::Moment;
pub use picture::Picture;
pub use sketch::Sketch;
