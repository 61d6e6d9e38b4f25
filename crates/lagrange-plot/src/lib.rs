//! Figures of curves over numbers, and the pixels and letters used by all pictures.
//!
//! This crate is independent of mechanics: plots consist of names and points. Without the feature
//! `figures`, it only contains axes, pixels and letters, which pictures of mechanisms also use.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

#[cfg(feature = "figures")]
mod axes;
pub mod axis;
#[cfg(feature = "figures")]
mod band;
#[cfg(feature = "figures")]
mod canvas;
#[cfg(feature = "figures")]
mod cells;
pub mod characters;
pub mod colours;
#[cfg(feature = "figures")]
mod document;
#[cfg(feature = "figures")]
mod figure;
#[cfg(feature = "figures")]
mod image;
pub mod label;
pub mod lettering;
#[cfg(feature = "figures")]
mod limit;
pub mod notation;
#[cfg(feature = "figures")]
mod panel;
#[cfg(feature = "figures")]
mod paper;
pub mod pixels;
#[cfg(all(test, feature = "figures"))]
mod tests;
#[cfg(feature = "figures")]
mod thin;

#[cfg(feature = "figures")]
pub use self::axis::Scale;
#[cfg(feature = "figures")]
pub use self::band::Band;
#[cfg(feature = "figures")]
pub use self::cells::Cells;
#[cfg(feature = "figures")]
pub use self::figure::{Figure, PlotError};
#[cfg(feature = "figures")]
pub use self::limit::Limit;
#[cfg(feature = "figures")]
pub use self::panel::{Curve, Panel};
