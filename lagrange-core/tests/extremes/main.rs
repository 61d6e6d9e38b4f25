//! What is left of the digits of accelerations and energies where numbers of very different size meet.
//!
//! `cargo test -p lagrange-core --test extremes -- --nocapture --test-threads=1` prints the errors that were found.

mod digits;
mod oracle;
mod random;
mod reference;
mod scenes;
mod space;
mod sweep;
mod trees;
mod trial;
mod undefined;
