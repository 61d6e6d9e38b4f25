//! The procedural macro of `lagrange`.
//!
//! A shell: everything is done by `lagrange-core`, which works on the same tokens and can be tested
//! from text. Use the macro as `lagrange::system!`, which is where its language is documented.
#![forbid(unsafe_code)]

use std::path::PathBuf;

use lagrange_core::editor;
use lagrange_core::files;
use lagrange_core::tables::FileText;
use proc_macro2::{TokenStream, TokenTree};

/// Expands `system! { (path of the crate lagrange) declaration }`, as written by
/// `lagrange::system!`.
#[proc_macro]
pub fn system(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let mut tokens = TokenStream::from(input).into_iter();
    let krate = match tokens.next() {
        Some(TokenTree::Group(group)) => group.stream(),
        _ => TokenStream::new(),
    };
    let declaration = tokens.collect::<TokenStream>();
    // They come first: errors after them have another length while a word is completed.
    let mut items = if is_in_editor() { editor::names(&declaration) } else { TokenStream::new() };
    items.extend(lagrange_core::pipeline::expand_with(declaration, &krate, &file));
    items.into()
}

/// True in rust-analyzer, which expands macros in a process of its own.
fn is_in_editor() -> bool {
    let program = std::env::current_exe().unwrap_or_default();
    program.file_stem().is_some_and(|name| name.to_string_lossy().starts_with("rust-analyzer"))
}

/// Returns a file of the crate that is compiled, by its path from where that crate is.
fn file(path: &str) -> Result<FileText, String> {
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    files::read(&folder, path)
}
