//! Pictures of scenes that are written by hand: what they consist of, and that it is all in them.
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
