#!/bin/sh
# Checks examples/device, which is a workspace of its own: formatting, lints with each feature, and motions on a device.
# `tools/device_check.sh install` first installs PoCL, which computes OpenCL on processors (Debian, Ubuntu).
set -eu
if [ "${1:-}" = install ]; then
    ${SUDO:-} apt-get update
    ${SUDO:-} apt-get install --yes pocl-opencl-icd ocl-icd-libopencl1
fi
cd "$(dirname "$0")/../examples/device"
cargo fmt --check
for features in opencl cuda opencl,cuda; do
    cargo clippy --all-targets --no-default-features --features "$features" -- -D warnings
done
RUSTDOCFLAGS="-D warnings" cargo doc --no-deps
# Without a device tests compare nothing, unless one is required.
LAGRANGE_DEVICE=required cargo test
cargo run --release --example device 1024
