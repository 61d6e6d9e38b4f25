//! Compiler messages for methods of ensembles behind a missing feature.
//!
//! The methods are there without their features, too, with bounds that nothing fulfils and that name the feature; none is ever called.

use core::convert::Infallible;
use std::path::Path;

#[cfg(not(feature = "parquet"))]
use super::builder::Ensemble;
#[cfg(not(feature = "plot"))]
use super::ends::Ends;
#[cfg(not(feature = "parquet"))]
use super::error::EnsembleError;
#[cfg(not(feature = "plot"))]
use super::grid::Grid;
#[cfg(not(feature = "plot"))]
use super::samples::Samples;
use crate::system::MechanicalSystem;

/// Something that writes Parquet.
#[cfg(not(feature = "parquet"))]
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "ensembles save to Parquet with the feature `parquet` of `lagrange` only",
    label = "needs the feature `parquet`",
    note = "in `Cargo.toml`: `lagrange = {{ …, features = [\"ensemble\", \"parquet\"] }}`; or once: `cargo run --features lagrange/parquet`"
)]
pub trait SavesParquet {}

/// Something that draws pictures.
#[cfg(not(feature = "plot"))]
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "ensembles plot with the feature `plot` of `lagrange` only",
    label = "needs the feature `plot`",
    note = "in `Cargo.toml`: `lagrange = {{ …, features = [\"ensemble\", \"plot\"] }}`; or once: `cargo run --features lagrange/plot`"
)]
pub trait DrawsPictures {}

#[cfg(not(feature = "parquet"))]
#[doc(hidden)]
impl<M: MechanicalSystem, K, D, P> Ensemble<'_, M, K, D, P> {
    pub fn save_parquet(self, _: impl AsRef<Path>) -> Result<Infallible, EnsembleError>
    where
        Self: SavesParquet,
    {
        Err(EnsembleError::Setting("ensembles save to Parquet with the feature `parquet` only".into()))
    }
}

/// Return type of `map`, which can never be called.
#[cfg(not(feature = "plot"))]
#[doc(hidden)]
#[derive(Debug)]
pub enum NoMap {}

#[cfg(not(feature = "plot"))]
#[doc(hidden)]
impl NoMap {
    pub fn save(&self, _: impl AsRef<Path>) -> Result<(), Infallible> {
        match *self {}
    }
}

#[cfg(not(feature = "plot"))]
#[doc(hidden)]
impl<M: MechanicalSystem> Ends<M> {
    pub fn map(&self, _: &Grid, _: &str) -> Result<NoMap, core::fmt::Error>
    where
        Self: DrawsPictures,
    {
        Err(core::fmt::Error)
    }
}

#[cfg(not(feature = "plot"))]
#[doc(hidden)]
impl<M: MechanicalSystem> Samples<M> {
    pub fn plot_quantiles(&self, _: &str, _: impl AsRef<Path>) -> Result<(), Infallible>
    where
        Self: DrawsPictures,
    {
        Ok(())
    }
}
