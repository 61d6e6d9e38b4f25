//! Messages about the syntax of arrays and loops.

pub(in crate::syntax) const EMPTY_BRACKETS: &str = "these brackets are empty";
pub(in crate::syntax) const INDEX_FORM_HELP: &str = "write one index: `p[i]`, or `A[i][j]` of a matrix";
pub(in crate::syntax) const RANGE: &str =
    "a loop runs over a range of integers, with two dots between its ends";
pub(in crate::syntax) const RANGE_HELP: &str = "write `0..n` for 0 up to n - 1, or `1..=n` for 1 up to n";
pub(in crate::syntax) const NO_FOLD: &str = "only `sum`, `product`, `min` and `max` run over a range";
pub(in crate::syntax) const RANGE_OF_FOLD: &str = "the range of a sum or a product begins with `i in`";
pub(in crate::syntax) const LOOP_HELP: &str = "write `for i in 0..n { … }`";
pub(in crate::syntax) const SELECTION_HELP: &str =
    "write `if i > 0 { … }`, with statements between the braces";
pub(in crate::syntax) const COMPARISON: &str = "`<`, `<=`, `>`, `>=`, `==` or `!=`";
pub(in crate::syntax) const LIST_END: &str = "`,` or `]`";
pub(in crate::syntax) const LIST_HELP: &str =
    "write one value for each element: `param l[3] = [1, 0.5, 0.25];`";
pub(in crate::syntax) const NO_SIZE: &str = "this list of values needs a number of elements";
pub(in crate::syntax) const FUNCTIONS: &str = "functions of the crate and parameters have no elements";
pub(in crate::syntax) const FUNCTIONS_HELP: &str =
    "make the index another parameter, or write the expression out in a loop";

pub(in crate::syntax) const TOO_MANY_INDICES_HELP: &str =
    "merge indices, `k[2 * 3]`, or remove indices of size one";

pub(in crate::syntax) fn too_many_indices(name: &str, given: usize, most: usize) -> String {
    format!("`{name}` has {given} indices, more than {most}")
}

pub(in crate::syntax) fn size_help(name: &str, sizes: &[i64]) -> String {
    let sizes = sizes.iter().map(|size| format!("[{size}]")).collect::<String>();
    format!("write it after the name, `{name}{sizes} = […]`; vectors are `(a, b)`, in parentheses")
}

/// Returns the form of a function over a range.
pub(in crate::syntax) fn fold_help(function: &str) -> String {
    format!("write `{function}(i in 0..n, e)`")
}

/// Returns advice for a function over a range without a range.
pub(in crate::syntax) fn other_fold(function: &str) -> String {
    match function {
        "prod" => fold_help("product"),
        "minimum" => fold_help("min"),
        "maximum" => fold_help("max"),
        _ => fold_help("sum"),
    }
}
