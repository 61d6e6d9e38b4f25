#!/usr/bin/env bash
# Compiles what is published with the oldest toolchain that the manifest allows.
set -euo pipefail
cd "$(dirname "$0")/.."

oldest=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
rustup toolchain install --profile minimal "$oldest"
cargo "+$oldest" check --package lagrange --package lagrange-cli --all-features --target-dir target/msrv
cargo "+$oldest" check --package lagrange --no-default-features --target-dir target/msrv
