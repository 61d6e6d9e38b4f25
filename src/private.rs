//! What the expansion of [`system!`](crate::system!) may name and users may not: no stability is promised.

pub use lagrange_macro::system;
