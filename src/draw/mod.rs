//! Pictures and films of systems of plane rigid bodies.

mod picture;

pub use picture::Picture;
