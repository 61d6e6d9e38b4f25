//! Pictures of handwritten scenes: their elements, and that they fit inside.
#![cfg(feature = "draw")]

mod anchors;
mod contacts;
mod files;
mod films;
mod free_bodies;
mod marks;
mod parallel;
mod refusals;
mod scenes;
mod surfaces;
