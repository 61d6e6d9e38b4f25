#!/bin/sh
# Checks crates/lagrange-jit, which is a workspace of its own: formatting, lints, documentation, and the bits of compiled code.
set -eu
cd "$(dirname "$0")/.."
export CARGO_TARGET_DIR="$PWD/target/jit" CARGO_INCREMENTAL=0
cd crates/lagrange-jit
cargo fmt --check
cargo clippy --quiet --locked --all-targets -- -D warnings
RUSTDOCFLAGS="-D warnings" cargo doc --quiet --locked --no-deps
cargo test --quiet --locked
