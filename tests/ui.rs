//! What the compiler says about mistakes: each file of `ui/`, in the folder of the rule that it breaks.

#[test]
fn mistakes_are_explained_where_they_are() {
    trybuild::TestCases::new().compile_fail("tests/ui/*/*.rs");
}

/// Features that are missing; `cargo test --test ui`, without any.
#[cfg(not(any(feature = "plot", feature = "parquet", feature = "draw")))]
#[test]
fn missing_features_are_named() {
    trybuild::TestCases::new().compile_fail("tests/ui_without_features/*.rs");
}
