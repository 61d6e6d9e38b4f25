//! What the macro says about mistakes: each file of `ui/`, in the folder of the rule that it breaks.

#[test]
fn mistakes_are_explained_where_they_are() {
    trybuild::TestCases::new().compile_fail("tests/ui/*/*.rs");
}
