#!/usr/bin/env python3
"""Measures what a pendulum chain adds to an unoptimised `cargo check` of a crate that declares it.

A fresh crate that depends on this one is checked with and without the declaration, in turns; its source
changes before every run. Prints medians. `tools/compile_time.py [REPETITIONS]`
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from chains import declaration

ROOT = Path(__file__).resolve().parent.parent
CHAINS = [("absolute", 10), ("relative", 8), ("absolute", 20)]
MANIFEST = f"""[package]
name = "user"
version = "0.1.0"
edition = "2024"

[dependencies]
lagrange = {{ path = "{ROOT}" }}

[workspace]
"""


def source(chain, revision):
    """The crate's only file."""
    lines = [f"pub const REVISION: u32 = {revision};"]
    if chain is not None:
        lines += ["lagrange::system! {", *declaration(*chain), "}"]
    return "\n".join(lines).replace("pub(crate)", "pub") + "\n"


def check(folder):
    """Seconds of one `cargo check`."""
    environment = os.environ | {"CARGO_TARGET_DIR": str(folder / "target")}
    start = time.perf_counter()
    subprocess.run(["cargo", "check", "--quiet", "--offline"], cwd=folder, env=environment, check=True)
    return time.perf_counter() - start


def measure(folder, repetitions):
    """Seconds by chain, None for the crate without one."""
    seconds = {chain: [] for chain in [None, *CHAINS]}
    for revision in range(repetitions + 1):
        for chain in seconds:
            (folder / "src" / "lib.rs").write_text(source(chain, revision))
            elapsed = check(folder)
            if revision > 0:  # The first round compiles the dependencies.
                seconds[chain].append(elapsed)
    return {chain: median(times) for chain, times in seconds.items()}


def main():
    repetitions = int(sys.argv[1]) if len(sys.argv) > 1 else 9
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "src").mkdir()
        (folder / "Cargo.toml").write_text(MANIFEST)
        medians = measure(folder, repetitions)
    print(f"without a chain: {medians[None]:.2f} s")
    for kind, n in CHAINS:
        print(f"{n:>3} links, {kind:<8} angles: {medians[kind, n] - medians[None]:+.2f} s")


if __name__ == "__main__":
    main()
