"""Steps of a standing quadruped by this crate and by MuJoCo in alternation, for docs/contacts.md.

    pip install mujoco numpy example-robot-data
    python3 tools/contact_peers.py

builds the benchmark `standing` and prints two tables. The argument `target/release/deps/standing-…` spares the build.

Both sides compute a Go2 with springs and dampers in its joints, on 4, 8 or 16 balls, in steps of 2 ms. MuJoCo reads the robot from its URDF
file; accelerations of a state in the air are compared first. It uses elliptic cones and Newton's method, with its default tolerance and
with the least one, and is stepped in C. Both sides take the same number of steps in turns, from the start of a motion of 1 s. Times are
those of a step in chunks of 25.

- The residual is the velocity by which impulses miss Coulomb's law, with the velocities at the end of the step.
- The penetration and the slip are the largest depth, and the largest slip velocity of a contact within its cone, in the second half.
- The energy error is its largest rise in a step: apart from springs and weights, only dampers, impacts and friction act.
"""

import re
import statistics
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import mujoco
import numpy as np

ROOT = Path(__file__).resolve().parent.parent
ROBOT = "cmeel.prefix/share/example-robot-data/robots/go2_description/urdf/go2.urdf"
STEP, CHUNK, CHUNKS, TURNS = 2e-3, 25, 20, 25
JOINTS = np.tile([0, 0.8, -1.5], 4)
HEIGHT = 0.33330991498254225
STIFFNESS, DAMPING, RADIUS = 60, 2, 0.022
TOE, HEEL = (0.0152968437457, -0.2258843537447538), (-0.0152968437457, -0.2001156462552462)
BALLS = {
    4: [(0, 0, -0.213)],
    8: [(x, 0, z) for x, z in (TOE, HEEL)],
    16: [(x, y, z) for x, z in (TOE, HEEL) for y in (0.02, -0.02)],
}
SPEEDS = {"stands": 0.0, "slides": 1.0}
TOLERANCES = {"MuJoCo": 1e-8, "MuJoCo, tight": 1e-14}
HERE = "`Stepped`"


def robot():
    """Returns the text of the URDF file without shapes."""
    found = [path / ROBOT for path in map(Path, sys.path) if (path / ROBOT).exists()]
    tree = ElementTree.parse(found[0])
    for link in tree.getroot().findall("link"):
        for shape in link.findall("visual") + link.findall("collision"):
            link.remove(shape)
    return ElementTree.tostring(tree.getroot(), encoding="unicode")


def model(text, count, speed, tolerance):
    spec = mujoco.MjSpec.from_string(text)
    spec.compiler.inertiafromgeom, spec.compiler.fusestatic = 0, 1
    spec.option.timestep, spec.option.tolerance = STEP, tolerance
    spec.option.cone, spec.option.solver = mujoco.mjtCone.mjCONE_ELLIPTIC, mujoco.mjtSolver.mjSOL_NEWTON
    spec.worldbody.first_body().add_freejoint()
    for joint in spec.joints:
        if joint.type == mujoco.mjtJoint.mjJNT_HINGE:
            joint.stiffness[0], joint.damping[0] = STIFFNESS, DAMPING
            joint.springref, joint.limited, joint.frictionloss, joint.armature = relaxed(joint.name), 0, 0, 0
    friction = [0.8 if speed == 0 else 0.2, 0, 0]
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[5, 5, 0.1], friction=friction, condim=3)
    for leg in ["FL", "FR", "RL", "RR"]:
        for place in BALLS[count]:
            kind = {"type": mujoco.mjtGeom.mjGEOM_SPHERE, "contype": 0, "conaffinity": 1}
            spec.body(f"{leg}_calf").add_geom(size=[RADIUS, 0, 0], pos=place, mass=0, friction=friction, condim=3, **kind)
    return spec.compile()


def relaxed(name):
    """Returns the relaxed angle of a joint, at which its spring carries a quarter of the weight."""
    left = 1 if "L_" in name else -1
    return next(angle for part, angle in [("hip", -0.0627 * left), ("thigh", 0.7898), ("calf", -1.41)] if part in name)


def start(model, speed):
    data = mujoco.MjData(model)
    data.qpos[:] = [0, 0, HEIGHT, 1, 0, 0, 0, *JOINTS]
    data.qvel[0] = speed
    return data


def accelerations(model):
    """Returns the accelerations in the state in the air that the benchmark has, too."""
    data = mujoco.MjData(model)
    state = 0.3 + 0.1 * np.sin(np.arange(37))
    state[3:7] = np.cos(0.5), np.sin(0.5), 0, 0
    state[2] += 5
    data.qpos[:], data.qvel[:] = state[:19], state[19:]
    mujoco.mj_forward(model, data)
    return data.qacc.copy()


def energy(model, data):
    mujoco.mj_energyPos(model, data)
    mujoco.mj_energyVel(model, data)
    return data.energy.sum()


def residual(impulse, rate, mu):
    """Returns by how much scaled impulses and velocities of a contact miss the law."""
    pressing = max(impulse[0] - rate[0], 0)
    pull = impulse[1:] - rate[1:]
    size = np.linalg.norm(pull)
    target = pull * min(mu * pressing / size, 1) if size > 0 else 0 * pull
    return max(abs(pressing - impulse[0]), np.linalg.norm(target - impulse[1:]))


def law(model, speed, steps):
    """Returns loaded contacts, residual, penetration, slip and rise of the energy, and the final position."""
    data, worst, loaded = start(model, speed), np.zeros(4), 0
    for step in range(steps):
        mujoco.mj_forward(model, data)
        before, loaded, rows = energy(model, data), 0, []
        for index, contact in enumerate(data.contact):
            force, place = np.zeros(6), np.zeros((3, model.nv))
            mujoco.mj_contactForce(model, data, index, force)
            body = model.geom_bodyid[max(contact.geom)]
            mujoco.mj_jac(model, data, place, None, contact.pos, body)
            row = contact.frame.reshape(3, 3) @ place
            response = np.zeros_like(row)
            mujoco.mj_solveM(model, data, response, row)
            weight = np.sum(row * response) / 3
            rows.append((row, weight * force[:3] * STEP, contact.dist, contact.friction[0]))
        mujoco.mj_step(model, data)
        for row, impulse, gap, mu in rows:
            rate = row @ data.qvel
            slip, loaded = np.linalg.norm(rate[1:]), loaded + (impulse[0] > 0)
            rate[0] += max(gap, 0) / STEP
            worst[0] = max(worst[0], residual(impulse, rate, mu))
            if step > steps / 2:
                worst[1] = max(worst[1], -gap)
                sticks = np.linalg.norm(impulse[1:]) < 0.999 * mu * impulse[0]
                worst[2] = max(worst[2], slip if sticks else 0)
        mujoco.mj_fwdPosition(model, data)
        worst[3] = max(worst[3], energy(model, data) - before)
    return [loaded, *worst, data.qpos[0], data.qpos[2]]


class Benchmark:
    """The benchmark in a process of its own."""

    def __init__(self, path):
        self.process = subprocess.Popen([path, "serve"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, *words):
        print(*words, file=self.process.stdin, flush=True)
        line = self.process.stdout.readline()
        assert line, "the benchmark ended"
        return [float(number) for number in line.split()]


def built():
    """Builds the benchmark and returns its path."""
    command = ["cargo", "bench", "-p", "lagrange-benches", "--bench", "standing", "--no-run"]
    report = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stderr
    return ROOT / re.search(r"\((\S*standing-\w+)\)", report)[1]


def peer_time(model, data):
    """Returns the time of a step in ns, in a chunk of them."""
    began = time.perf_counter_ns()
    mujoco.mj_step(model, data, nstep=CHUNK)
    return (time.perf_counter_ns() - began) / CHUNK


def main():
    benchmark, text = Benchmark(sys.argv[1] if len(sys.argv) > 1 else built()), robot()
    peers = {
        (count, motion, name): model(text, count, speed, tolerance)
        for count in BALLS
        for motion, speed in SPEEDS.items()
        for name, tolerance in TOLERANCES.items()
    }
    theirs, ours = accelerations(peers[4, "stands", "MuJoCo"]), np.array(benchmark.ask("check", 4))
    print(f"Accelerations differ by {np.max(np.abs(theirs - ours)) / np.max(np.abs(ours)):.1e} of the largest.\n")
    times = alternated(benchmark, peers)
    print("| contacts | motion | by | least µs | median µs | ratio of least | of medians |\n|---|---|---|---|---|---|---|")
    for count, motion in ((count, motion) for count in BALLS for motion in SPEEDS):
        here = times[count, motion, HERE]
        for name in [HERE, *TOLERANCES]:
            there = times[count, motion, name]
            least, median = min(there), statistics.median(there)
            ratios = ["", ""] if name == HERE else [f"{min(here) / least:.2f}", f"{statistics.median(here) / median:.2f}"]
            print(f"| {count} | {motion} | {name} | {least / 1e3:.2f} | {median / 1e3:.2f} | {' | '.join(ratios)} |")
    print("\n| contacts | motion | by | loaded | residual, m/s | penetration, m | slip, m/s | energy, J | x, m | height, m |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for count, motion in ((count, motion) for count in BALLS for motion in SPEEDS):
        for name in [HERE, *TOLERANCES]:
            print(f"| {count} | {motion} | {name} | {quality(benchmark, peers, count, motion, name)} |")


def quality(benchmark, peers, count, motion, name):
    speed, steps = SPEEDS[motion], CHUNK * CHUNKS
    if name == HERE:
        numbers = benchmark.ask("law", count, speed, steps)
        numbers = [*numbers[:5], numbers[5], numbers[7]]
    else:
        numbers = law(peers[count, motion, name], speed, steps)
    return " | ".join([f"{numbers[0]:.0f}", *(f"{number:.1e}" for number in numbers[1:5]), *(f"{number:.4f}" for number in numbers[5:])])


def alternated(benchmark, peers):
    """Returns the times of a step in ns, in all chunks."""
    times = {}
    for _ in range(TURNS):
        for count, motion in ((count, motion) for count in BALLS for motion in SPEEDS):
            speed = SPEEDS[motion]
            benchmark.ask("start", count, speed)
            moving = {name: start(peers[count, motion, name], speed) for name in TOLERANCES}
            for _ in range(CHUNKS):
                own = benchmark.ask(count, speed, CHUNK)[0] / CHUNK
                times.setdefault((count, motion, HERE), []).append(own)
                for name, data in moving.items():
                    times.setdefault((count, motion, name), []).append(peer_time(peers[count, motion, name], data))
    return times


if __name__ == "__main__":
    main()
