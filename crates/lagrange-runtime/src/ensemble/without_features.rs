//! Compiler messages for methods of ensembles that require a missing feature.
//!
//! The methods exist even without their features, with unsatisfiable bounds that name the feature.
//! They are never called.

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
use crate::simulate::without_feature;
use crate::system::MechanicalSystem;

#[cfg(not(feature = "parquet"))]
without_feature! {
    SavesParquet: "ensembles save to Parquet only with the feature `parquet` of `lagrange`",
    "needs the feature `parquet`",
    "in `Cargo.toml`: `lagrange = {{ …, features = [\"ensemble\", \"parquet\"] }}`; or once: `cargo run --features lagrange/parquet`";
    impl[M: MechanicalSystem, K, D, P] Ensemble<'_, M, K, D, P> {
        fn save_parquet(impl AsRef<Path>) -> Result<Infallible, EnsembleError>;
    }
}

#[cfg(not(feature = "plot"))]
without_feature! {
    DrawsPictures: "ensembles plot only with the feature `plot` of `lagrange`",
    "needs the feature `plot`",
    "in `Cargo.toml`: `lagrange = {{ …, features = [\"ensemble\", \"plot\"] }}`; or once: `cargo run --features lagrange/plot`";
    impl[M: MechanicalSystem] Ends<M> {
        fn map(&Grid, &str) -> Result<NoMap, core::fmt::Error>;
    }
    impl[M: MechanicalSystem] Samples<M> {
        fn plot_quantiles(&str, impl AsRef<Path>) -> Result<(), Infallible>;
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
