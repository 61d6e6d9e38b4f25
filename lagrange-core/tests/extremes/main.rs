//! Digits that accelerations and energies keep when numbers of very different size meet.
//!
//! `cargo test -p lagrange-core --test extremes -- --nocapture --test-threads=1` prints the errors.

mod cases;
#[path = "../common/digits.rs"]
mod digits;
#[path = "../common/linear.rs"]
mod linear;
mod oracle;
#[path = "../common/random.rs"]
#[allow(dead_code, reason = "other tests draw otherwise")]
mod random;
mod reference;
mod scenes;
mod space;
mod sweep;
mod trees;
mod trial;
mod undefined;
mod values;
