#!/usr/bin/env python3
"""Runs an ensemble over the processes of an MPI job and kills one of them: `tools/mpi_check.py [--motions 20000] [--parts 40]`

The program `examples/mpi` saves double pendulums and sums them, with 1, 2 and 4 processes. Then one of four
processes is killed (SIGKILL) midway, which ends the others. The job resumes with four, and another one with two. All files must have
the SHA-256 of those of a single process, and all sums its bits. Before that an error in one process must end the others.

Needs Python 3, Rust, Open MPI with its headers, and libclang, which Rust uses to read them. On Debian missing ones are installed if
this runs as root. The machine may have fewer processors than processes.
"""

import argparse
import hashlib
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGES = ["libopenmpi-dev", "openmpi-bin", "libclang-dev"]
LAUNCHER = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-n"]
# An error for which nobody waits ends the job; one that is awaited ends nothing.
SECONDS = 300


def install():
    """Installs Open MPI and libclang where they are missing."""
    if shutil.which("mpicc") and shutil.which("mpirun") and list(pathlib.Path("/usr/lib").glob("**/libclang*.so*")):
        return
    if not shutil.which("apt-get") or os.geteuid() != 0:
        sys.exit(f"install an MPI with its headers, and libclang; on Debian: apt-get install {' '.join(PACKAGES)}")
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    subprocess.run(["apt-get", "update", "-qq"], check=True, env=environment)
    command = ["apt-get", "install", "--yes", "-qq", "--no-install-recommends", *PACKAGES]
    subprocess.run(command, check=True, env=environment)


def build():
    """Builds the optimised program, and returns its path."""
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "mpi"
    folder = ROOT / "examples" / "mpi"
    for command in (["fmt", "--check"], ["clippy", "--release", "--locked", "--target-dir", target, "--", "-D", "warnings"]):
        subprocess.run(["cargo", *command], check=True, cwd=folder)
    subprocess.run(["cargo", "build", "--release", "--locked", "--target-dir", target], check=True, cwd=folder)
    return target / "release" / "lagrange-example-mpi"


class Job:
    """Runs of the program, with given numbers of motions and parts."""

    def __init__(self, program, motions, parts):
        self.program, self.motions, self.parts = program, motions, parts

    def start(self, processes, folder):
        command = [*LAUNCHER, str(processes), self.program, folder, str(self.motions), str(self.parts)]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def run(self, processes, folder):
        """Returns the sums as printed by the first process."""
        began = time.monotonic()
        job = self.start(processes, folder)
        output, errors = job.communicate(timeout=SECONDS)
        if job.returncode != 0:
            sys.exit(f"{processes} processes failed:\n{output}{errors}")
        lines = output.splitlines()
        shares = sorted(line for line in lines if line.startswith("rank"))
        print(f"{processes} processes: {time.monotonic() - began:.1f} s; {'; '.join(shares)}")
        return [line for line in lines if not line.startswith("rank")]


def digests(folder):
    """Returns the SHA-256 of all parts by name; nothing else may exist."""
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir()}


def saved(folder):
    return len(list(folder.glob("part-*.parquet")))


def kill_one(job, folder):
    """Kills one of four processes when a quarter of all parts exists, which must end the others."""
    running = job.start(4, folder)
    while saved(folder) < job.parts // 4:
        if running.poll() is not None:
            sys.exit(f"ended before it could be killed:\n{running.communicate()[1]}")
        time.sleep(0.01)
    # "process 4711 on host"
    victim = int((folder / "shard-2-of-4.lock").read_text().split()[1])
    os.kill(victim, signal.SIGKILL)
    began = time.monotonic()
    _, errors = running.communicate(timeout=SECONDS)
    seconds = time.monotonic() - began
    left = saved(folder)
    if running.returncode == 0 or not job.parts // 4 <= left < job.parts:
        sys.exit(f"was not stopped: {running.returncode}, {left} parts")
    word = next((line for line in errors.splitlines() if "signal 9" in line), "nothing")
    print(f"rank 2 killed: the others ended within {seconds:.1f} s, {left} of {job.parts} parts are there; mpirun says: {word}")


def error_in_one(job, folder):
    """Checks that a failing process is an error in all."""
    folder.mkdir()
    # A folder instead of the lock of rank 1 of 2.
    (folder / "shard-1-of-2.lock").mkdir()
    running = job.start(2, folder)
    _, errors = running.communicate(timeout=SECONDS)
    if running.returncode == 0 or "rank 1 failed" not in errors:
        sys.exit(f"an error in one process was not told: {running.returncode}\n{errors}")
    print(f"an error in rank 1: both ended with {running.returncode}, {saved(folder)} parts are there")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--motions", type=int, default=20_000)
    parser.add_argument("--parts", type=int, default=40)
    arguments = parser.parse_args()
    install()
    job = Job(build(), arguments.motions, arguments.parts)
    with tempfile.TemporaryDirectory() as scratch:
        folders = {name: pathlib.Path(scratch) / name for name in ["1", "2", "4", "killed", "shrunk", "failed"]}
        error_in_one(job, folders["failed"])
        sums = {name: job.run(int(name), folders[name]) for name in ["1", "2", "4"]}
        kill_one(job, folders["killed"])
        shutil.copytree(folders["killed"], folders["shrunk"])
        sums["killed"] = job.run(4, folders["killed"])
        sums["shrunk"] = job.run(2, folders["shrunk"])
        files = {name: digests(folders[name]) for name in sums}
        size = sum(path.stat().st_size for path in folders["1"].iterdir())
    for name, found in files.items():
        if found != files["1"] or sums[name] != sums["1"]:
            sys.exit(f"{name} differs from a single process: {sums[name]} instead of {sums['1']}")
    everything = hashlib.sha256("".join(f"{name} {files['1'][name]}\n" for name in sorted(files["1"])).encode())
    print("\n".join(sums["1"]))
    print(f"{len(files['1'])} files of {size} bytes are the same in all {len(files)} folders: {everything.hexdigest()}")


if __name__ == "__main__":
    main()
