//! Compiler messages for methods of trajectories that require a missing feature.
//!
//! The methods exist even without their features, with unsatisfiable bounds that name the feature.
//! They are never called.

use std::convert::Infallible;
use std::path::Path;

use super::trajectory::Trajectory;
use crate::system::MechanicalSystem;

/// Declares methods that require a trait that no type implements, and the compiler's message for
/// it.
macro_rules! without_feature {
    (
        $required:tt: $message:literal, $label:literal, $note:literal;
        $(impl[$($generics:tt)*] $owner:ty {
            $(fn $method:ident($($argument:ty),*) -> $result:ty;)*
        })*
    ) => {
        /// A type with this feature; no type implements this.
        #[doc(hidden)]
        #[diagnostic::on_unimplemented(message = $message, label = $label, note = $note)]
        pub trait $required {
            /// Stands for a method that cannot be called.
            fn never<T>(&self) -> T;
        }

        $(#[doc(hidden)]
        impl<$($generics)*> $owner {
            $(pub fn $method(&self $(, _: $argument)*) -> $result
            where
                Self: $required,
            {
                self.never()
            })*
        })*
    };
}

#[cfg(feature = "ensemble")]
pub(crate) use without_feature;

#[cfg(not(feature = "plot"))]
without_feature! {
    HasFeaturePlot: "trajectories plot only with the feature `plot` of `lagrange`",
    "needs the feature `plot`",
    "in `Cargo.toml`: `lagrange = {{ …, features = [\"plot\"] }}`; or once: `cargo run --features lagrange/plot`";
    impl[M: MechanicalSystem] Trajectory<M> {
        fn plot_states(impl AsRef<Path>) -> Result<(), Infallible>;
        fn plot_columns(&[&str], impl AsRef<Path>) -> Result<(), Infallible>;
        fn plot_phase(&str, impl AsRef<Path>) -> Result<(), Infallible>;
        fn plot_pair(&str, &str, impl AsRef<Path>) -> Result<(), Infallible>;
        fn plot_against(&str, &[&str], impl AsRef<Path>) -> Result<(), Infallible>;
        fn plot_energy(impl AsRef<Path>) -> Result<(), Infallible>;
    }
}

#[cfg(not(feature = "parquet"))]
without_feature! {
    HasFeatureParquet: "trajectories save to Parquet only with the feature `parquet` of `lagrange`",
    "needs the feature `parquet`",
    "in `Cargo.toml`: `lagrange = {{ …, features = [\"parquet\"] }}`; or once: `cargo run --features lagrange/parquet`";
    impl[M: MechanicalSystem] Trajectory<M> {
        fn save_parquet(impl AsRef<Path>) -> Result<(), Infallible>;
        fn write_parquet(impl std::io::Write) -> Result<(), Infallible>;
    }
}
