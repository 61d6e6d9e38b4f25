//! Compiler messages for methods of trajectories behind a missing feature.
//!
//! The methods are there without their features, too, with bounds that nothing fulfils and that name the feature; none is ever called.

use std::convert::Infallible;
use std::path::Path;

use super::trajectory::Trajectory;
use crate::system::MechanicalSystem;

/// Something that plots.
#[cfg(not(feature = "plot"))]
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "trajectories plot with the feature `plot` of `lagrange` only",
    label = "needs the feature `plot`",
    note = "in `Cargo.toml`: `lagrange = {{ …, features = [\"plot\"] }}`; or once: `cargo run --features lagrange/plot`"
)]
pub trait HasFeaturePlot {}

/// Something that writes Parquet.
#[cfg(not(feature = "parquet"))]
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "trajectories save to Parquet with the feature `parquet` of `lagrange` only",
    label = "needs the feature `parquet`",
    note = "in `Cargo.toml`: `lagrange = {{ …, features = [\"parquet\"] }}`; or once: `cargo run --features lagrange/parquet`"
)]
pub trait HasFeatureParquet {}

#[cfg(not(feature = "plot"))]
#[doc(hidden)]
impl<M: MechanicalSystem> Trajectory<M> {
    pub fn plot_states(&self, _: impl AsRef<Path>) -> Result<(), Infallible>
    where
        Self: HasFeaturePlot,
    {
        Ok(())
    }

    pub fn plot_columns(&self, _: &[&str], _: impl AsRef<Path>) -> Result<(), Infallible>
    where
        Self: HasFeaturePlot,
    {
        Ok(())
    }

    pub fn plot_phase(&self, _: &str, _: impl AsRef<Path>) -> Result<(), Infallible>
    where
        Self: HasFeaturePlot,
    {
        Ok(())
    }

    pub fn plot_pair(&self, _: &str, _: &str, _: impl AsRef<Path>) -> Result<(), Infallible>
    where
        Self: HasFeaturePlot,
    {
        Ok(())
    }

    pub fn plot_against(&self, _: &str, _: &[&str], _: impl AsRef<Path>) -> Result<(), Infallible>
    where
        Self: HasFeaturePlot,
    {
        Ok(())
    }

    pub fn plot_energy(&self, _: impl AsRef<Path>) -> Result<(), Infallible>
    where
        Self: HasFeaturePlot,
    {
        Ok(())
    }
}

#[cfg(not(feature = "parquet"))]
#[doc(hidden)]
impl<M: MechanicalSystem> Trajectory<M> {
    pub fn save_parquet(&self, _: impl AsRef<Path>) -> Result<(), Infallible>
    where
        Self: HasFeatureParquet,
    {
        Ok(())
    }

    pub fn write_parquet(&self, _: impl std::io::Write) -> Result<(), Infallible>
    where
        Self: HasFeatureParquet,
    {
        Ok(())
    }
}
