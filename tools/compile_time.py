#!/usr/bin/env python3
"""Measures the time that a declaration adds to the compilation of a crate.

A fresh crate that depends on this one is compiled with and without the declaration, in alternation; its source changes
before every run. Prints medians, in the form of the tables of docs/performance.md.

    tools/compile_time.py [REPETITIONS]           chains, checked and optimised, beside handwritten chains
    tools/compile_time.py --large [REPETITIONS]   large declarations, with the memory that they take
    tools/compile_time.py --pinned [REPETITIONS]  chains of pinned bodies, checked, with the memory that they take
"""

import os
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from chains import declaration, type_name

ROOT = Path(__file__).resolve().parent.parent
# Seconds that a chain may add to `cargo check`.
MARKS = {
    ("absolute", 10): 0.25,
    ("relative", 8): 0.25,
    ("absolute", 20): 0.8,
    ("absolute", 30): 2.0,
    ("relative", 20): 1.5,
    ("absolute", 100): 3.0,
    ("relative", 100): 3.0,
    ("absolute", 200): None,
    ("relative", 200): None,
}
# Chains of benches/handwritten.rs, with the functions there.
BY_HAND = [
    ("absolute", 10, "absolute_chain"),
    ("absolute", 20, "absolute_chain"),
    ("relative", 8, "relative_chain_articulated"),
]
MANIFEST = f"""[package]
name = "user"
version = "0.1.0"
edition = "2024"

[dependencies]
lagrange = {{ path = "{ROOT}" }}

[workspace]
"""
CHECK, DEBUG, RELEASE = ["check"], ["build"], ["build", "--release"]


def springs(n):
    """Returns a wide potential: n particles in the plane with a spring between every two. The result is the declaration as lines,
    the name of its type and the number of coordinates."""
    lines = ["pub struct Springs;", "param k, l0, m;", f"coord {', '.join(f'x{i}, y{i}' for i in range(n))};"]
    lines += [f"kinetic = 1/2 * m * (dot(x{i})^2 + dot(y{i})^2);" for i in range(n)]
    pairs = [(i, j) for i in range(n) for j in range(i)]
    lines += [f"potential = spring_energy(k, hypot(x{i} - x{j}, y{i} - y{j}) - l0);" for i, j in pairs]
    return lines, "Springs", 2 * n


def nested(n):
    """Returns a deep potential: n definitions, each in terms of the previous one."""
    lines = ["pub struct Nested;", "param a;", "coord x;", "let z0 = x;"]
    lines += [f"let z{i} = sin(z{i - 1}) + a * z{i - 1};" for i in range(1, n + 1)]
    return lines + ["kinetic = 1/2 * dot(x)^2;", f"potential = z{n};"], "Nested", 1


def product(n):
    """Returns a potential with n distinct factors."""
    factors = " * ".join(f"(x + {i})" for i in range(1, n + 1))
    return ["pub struct Product;", "coord x;", "kinetic = 1/2 * dot(x)^2;", f"potential = {factors};"], "Product", 1


def pinned(n):
    """Returns a chain of n rods pinned to each other, each with its position and its angle as coordinates."""
    lines = ["pub struct Pinned;", "param m, l, g;", "gravity = (0, -g);"]
    for i in range(n):
        lines += [
            f"coord x{i}, y{i}, a{i};",
            f"body b{i} {{ mass: m; center: (x{i}, y{i}); angle: a{i}; shape: slender_rod(l); }}",
            f"pin p{i} = {f'b{i - 1}.point(l/2, 0)' if i else '(0, 0)'} to b{i}.point(-l/2, 0);",
        ]
    return lines, "Pinned", 3 * n


def chain(kind, n):
    lines = [line.replace("pub(crate)", "pub") for line in declaration(kind, n)]
    return lines, type_name(kind, n), n


LARGE = {
    "200 links, absolute angles": chain("absolute", 200),
    "200 links, relative angles": chain("relative", 200),
    "50 particles, a spring between every two": springs(50),
    "116 particles, a spring between every two": springs(116),
    "16,700 nested definitions": nested(16_700),
    "20,000 distinct factors": product(20_000),
}


# Numbers of bodies of chains with pins.
PINNED = [24, 48, 96, 192, 384, 768]


def declared(system, methods):
    """Returns a crate that declares a system and calls its acceleration, or all of its methods, or none."""
    lines, name, n = system
    calls = {
        None: "",
        "acceleration": "o.extend(s.acceleration(0.0, q, v));",
        "all": "let a = s.acceleration(0.0, q, v); o.extend(a);"
        " o.extend(s.mass_matrix(0.0, q).as_flattened()); o.extend(s.forcing(0.0, q, v));"
        " o.extend(s.momenta(0.0, q, v)); o.extend(s.inverse_dynamics(0.0, q, v, &a));"
        " o.extend([s.kinetic_energy(0.0, q, v), s.potential_energy(0.0, q), s.energy(0.0, q, v)]);",
    }[methods]
    call = f"pub fn f(s: &{name}, q: &[f64; {n}], v: &[f64; {n}], o: &mut Vec<f64>) {{ {calls} }}" if calls else ""
    return "\n".join(["lagrange::system! {", *lines, "}", call])


def written(function, n):
    """Returns a crate with the handwritten chains, one of which is called."""
    source = (ROOT / "benches" / "handwritten.rs").read_text()
    body = "\n".join(line for line in source.splitlines() if not line.startswith(("//!", "#![")))
    arguments = ", ".join(f"{name}: &[f64; {n}]" for name in "qvml")
    call = f"pub fn f({arguments}, g: f64) -> [f64; {n}] {{ {function}::<Platform, {n}>(q, v, m, l, g) }}"
    return "\n".join(["#![allow(dead_code)]", body, call])


class Crate:
    """A crate in a folder that is compiled repeatedly."""

    def __init__(self, folder):
        self.folder = folder
        self.revision = 0
        (folder / "src").mkdir()
        (folder / "Cargo.toml").write_text(MANIFEST)
        for command in [CHECK, DEBUG, RELEASE]:
            self.compile("", command)  # The dependencies.

    def compile(self, source, command):
        """Returns seconds and gigabytes of one run of cargo."""
        self.revision += 1
        (self.folder / "src" / "lib.rs").write_text(f"{source}\npub const REVISION: u32 = {self.revision};\n")
        environment = os.environ | {"CARGO_TARGET_DIR": str(self.folder / "target")}
        manifest = f"--manifest-path={self.folder / 'Cargo.toml'}"
        start = time.perf_counter()
        cargo = os.posix_spawnp("cargo", ["cargo", *command, "--quiet", "--offline", manifest], environment)
        _, status, usage = os.wait4(cargo, 0)
        if status != 0:
            sys.exit(f"cargo {' '.join(command)} failed")
        return time.perf_counter() - start, usage.ru_maxrss * 1024 / 1e9

    def measure(self, runs, repetitions):
        """Returns the medians of seconds beyond those of an empty crate, and the gigabytes, by name of the run."""
        results = {name: [] for name in runs}
        for _ in range(repetitions):
            empty = {}
            for name, (source, command) in runs.items():
                mode = tuple(command)
                if mode not in empty:
                    empty[mode], _ = self.compile("", command)
                seconds, memory = self.compile(source, command)
                results[name].append((seconds - empty[mode], memory))
        return {name: tuple(map(median, zip(*pairs))) for name, pairs in results.items()}


def measure_chains(crate, repetitions):
    runs = {("check", *key): (declared(chain(*key), None), CHECK) for key in MARKS}
    runs |= {("release", *key): (declared(chain(*key), "acceleration"), RELEASE) for key in MARKS}
    runs |= {("hand", kind, n): (written(function, n), RELEASE) for kind, n, function in BY_HAND}
    results = crate.measure(runs, repetitions)
    print("| chain | `cargo check` | goal | `cargo build --release` | written by hand |")
    print("|---|---|---|---|---|")
    for (kind, n), mark in MARKS.items():
        seconds = lambda mode: f"{results[mode, kind, n][0]:.2f} s" if (mode, kind, n) in results else ""
        limit = f"{mark} s" if mark else ""
        print(f"| {n}, {kind} angles | {seconds('check')} | {limit} | {seconds('release')} | {seconds('hand')} |")


def measure_large(crate, repetitions):
    modes = {"check": (None, CHECK), "debug": ("all", DEBUG), "release": ("acceleration", RELEASE)}
    runs = {
        (title, mode): (declared(system, methods), command)
        for title, system in LARGE.items()
        for mode, (methods, command) in modes.items()
    }
    results = crate.measure(runs, repetitions)
    print("| declaration | `cargo check` | `cargo build`, every method called | `… --release`, `acceleration` called |")
    print("|---|---|---|---|")
    for title in LARGE:
        cells = [results[title, mode] for mode in modes]
        print(f"| {title} | " + " | ".join(f"{seconds:.1f} s, {memory:.1f} GB" for seconds, memory in cells) + " |")


def measure_pinned(crate, repetitions):
    results = crate.measure({n: (declared(pinned(n), None), CHECK) for n in PINNED}, repetitions)
    print("| pinned bodies | coordinates | constraints | `cargo check` |")
    print("|---|---|---|---|")
    for n, (seconds, memory) in results.items():
        print(f"| {n} | {3 * n} | {2 * n} | {seconds:.1f} s, {memory:.1f} GB |")


def main():
    arguments = sys.argv[1:]
    modes = {"--large": (measure_large, 1), "--pinned": (measure_pinned, 1)}
    measure, usual = next((modes[word] for word in arguments if word in modes), (measure_chains, 9))
    repetitions = next((int(word) for word in arguments if word.isdigit()), usual)
    with tempfile.TemporaryDirectory() as name:
        crate = Crate(Path(name))
        measure(crate, repetitions)


if __name__ == "__main__":
    main()
