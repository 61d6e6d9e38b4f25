#!/bin/sh
# Checks crates/lagrange-jit, which is a workspace of its own: formatting, lints, documentation, the bits of compiled code, and the command.
set -eu
cd "$(dirname "$0")/.."
# The module for Python compiles the same crates.
export CARGO_TARGET_DIR="$PWD/target/beside" CARGO_INCREMENTAL=0
cd crates/lagrange-jit
cargo fmt --check
cargo clippy --quiet --locked --all-targets --all-features -- -D warnings
RUSTDOCFLAGS="-D warnings" cargo doc --quiet --locked --no-deps
cargo test --quiet --locked --all-features
