#!/usr/bin/env bash
# Compiles what is published with the oldest toolchain that the manifest allows.
set -euo pipefail
cd "$(dirname "$0")/.."

oldest=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
rustup toolchain install --profile minimal "$oldest"
for package in "" "--package lagrange-cli"; do
    cargo "+$oldest" check $package --all-features --target-dir target/msrv
done
cargo "+$oldest" check --no-default-features --target-dir target/msrv
