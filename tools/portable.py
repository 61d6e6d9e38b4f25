#!/usr/bin/env python3
"""The bits of `Portable` numbers on every target: builds and runs `tests/crates/portable`, unoptimised and optimised.

    tools/portable.py              all targets that this machine can build and run
    tools/portable.py --install    first installs Rust targets, and with apt a linker and an emulator for aarch64, and node
    tools/portable.py --native     only x86-64, optimised, with the instruction sets of this processor; tests run unoptimised

A target that cannot run here is only compiled, which is reported. Fails if a hash differs from the constant in the sources.
"""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
X86, WASM, ARM = "x86_64-unknown-linux-gnu", "wasm32-unknown-unknown", "aarch64-unknown-linux-gnu"
THUMB = "thumbv7em-none-eabihf"
PACKAGES = ["gcc-aarch64-linux-gnu", "qemu-user", "nodejs"]
NODE = """
const bytes = require("fs").readFileSync(process.argv[1]);
process.exit(new WebAssembly.Instance(new WebAssembly.Module(bytes), {}).exports.main(0, 0));
"""


def install():
    root = [] if os.geteuid() == 0 else ["sudo", "-n"]
    subprocess.run(["rustup", "target", "add", WASM, ARM, THUMB], check=True)
    subprocess.run([*root, "apt-get", "update", "-qq"], check=True)
    subprocess.run([*root, "apt-get", "install", "--yes", "-qq", *PACKAGES], check=True)


def processor_has(*features):
    known = Path("/proc/cpuinfo").read_text().split()
    return all(feature in known for feature in features)


def build(target, level, flags, arguments):
    environment = {
        **os.environ,
        "CARGO_INCREMENTAL": "0",
        "CARGO_PROFILE_DEV_OPT_LEVEL": str(level),
        "CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER": "aarch64-linux-gnu-gcc",
        "RUSTFLAGS": flags,
    }
    # With a target, flags do not apply to macros, which all builds share. The macro is named so that tests share it, too.
    command = ["cargo", "build", "--quiet", "-p", "portable", "-p", "lagrange-macro", "--target", target, *arguments]
    subprocess.run(command, cwd=ROOT, env=environment, check=True)
    return ROOT / "target" / target / "debug"


def run(name, target, level, flags="", arguments=(), command=()):
    """Builds and, if there is a command, runs. The command ends with the suffix of the program."""
    folder = build(target, level, flags, arguments)
    if not command:
        print(f"compiled only  {name}, opt-level {level}", flush=True)
        return True
    *before, suffix = command
    done = subprocess.run([*before, f"{folder}/portable{suffix}"], capture_output=True, text=True)
    print(f"{'same bits' if done.returncode == 0 else 'DIFFERENT'}      {name}, opt-level {level}", flush=True)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
    return done.returncode == 0


def native(levels):
    avx512 = ["avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"]
    processors = [
        ("x86-64", "", []),
        ("x86-64-v3", "-C target-cpu=x86-64-v3", ["avx2", "fma", "bmi2"]),
        ("x86-64-v4", "-C target-cpu=x86-64-v4", avx512),
    ]
    for name, flags, _ in (processor for processor in processors if processor_has(*processor[2])):
        for level in levels:
            yield run(name, X86, level, flags, command=[""])


def all_targets():
    yield from native([3, 0])
    yield run("x86-64 with std", X86, 3, arguments=["--features", "std"], command=[""])
    for level in [3, 0]:
        yield run("wasm32 by node", WASM, level, command=["node", "-e", NODE, ".wasm"])
        yield run("aarch64 by qemu", ARM, level, command=["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu", ""])
    yield run("thumbv7em", THUMB, 3, arguments=["--lib"])


def main():
    match sys.argv[1:]:
        case ["--native"]:
            results = native([3])
        case ["--install"]:
            install()
            results = all_targets()
        case []:
            results = all_targets()
        case _:
            sys.exit(__doc__)
    sys.exit(0 if all([*results]) else 1)


if __name__ == "__main__":
    main()
