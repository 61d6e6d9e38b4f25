//! What the compiler says where an ensemble is to do what only a feature lets it.
//!
//! The method is there without its feature, too, with a bound that nothing fulfils and that names the feature; it is never called.

use core::convert::Infallible;
use std::path::Path;

use super::builder::Ensemble;
use super::error::EnsembleError;
use crate::system::MechanicalSystem;

/// Something that writes Parquet.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "ensembles save to Parquet with the feature `parquet` of `lagrange` only",
    label = "needs the feature `parquet`",
    note = "in `Cargo.toml`: `lagrange = {{ …, features = [\"ensemble\", \"parquet\"] }}`; or once: `cargo run --features lagrange/parquet`"
)]
pub trait SavesParquet {}

#[doc(hidden)]
impl<M: MechanicalSystem, K, D, P> Ensemble<'_, M, K, D, P> {
    pub fn save_parquet(self, _: impl AsRef<Path>) -> Result<Infallible, EnsembleError>
    where
        Self: SavesParquet,
    {
        Err(EnsembleError::Setting("ensembles save to Parquet with the feature `parquet` only".into()))
    }
}
