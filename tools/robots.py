"""Pinocchio's results for the robots in `examples/panda.rs` and `examples/quadruped.rs`.

    pip install pin example-robot-data
    python3 tools/robots.py

Models are those of `tools/spatial_models.py`. For the arm: torques that hold it, torques for accelerations in motion (`rnea`; Featherstone,
*Rigid Body Dynamics Algorithms*, chapter 5), position and velocity of its hand, and its acceleration at constant velocities of the joints.
For the quadruped in the air: accelerations (`aba`, chapter 7) under the moments in the joints, and energy. Numbers are printed in the form
of Rust.
"""

import numpy as np
import pinocchio as pin

import spatial_models as models

# The arm: its hand in the last link, a posture, and a state with accelerations.
HAND = np.array([0.0, 0.0, 0.2104])
HOME = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
ARM = [
    [0.25, -0.5, 0.375, -2.125, -0.25, 1.75, 0.5],
    [0.5, -0.25, 0.75, 1.0, -1.25, 0.5, 2.0],
    [1.0, 2.0, -1.5, 0.5, 3.0, -2.5, 1.25],
]

# The quadruped: posture, stiffness and damping of its joints.
LEG, ELASTIC, DAMPING = np.array([0.0, 0.8, -1.5]), 60.0, 4.0
PLACE = [0.0625, -0.125, 0.5]  # of the trunk
ORIENTATION = np.array([4.0, 1.0, -2.0, 2.0]) / 5.0  # scalar part first
JOINTS = [0.25, 0.75, -1.25, -0.125, 1.0, -1.5, 0.125, 0.5, -1.75, -0.25, 0.875, -1.0]
SPEEDS = [0.25, -0.5, 0.125, 0.75, -0.25, 1.5, 1, -2, 3, -1, 0.5, 2, -0.75, 1.25, -3, 1.5, -0.5, 0.25]


def show(name, numbers):
    print(f"{name}: [{', '.join(repr(float(x)) for x in numbers)}]")


def panda():
    model = models.rebuilt(models.joints_of(models.panda()))
    data = model.createData()
    q, v, a = (np.array(numbers) for numbers in ARM)
    show("holding torques", pin.rnea(model, data, HOME, 0 * v, 0 * v))
    show("torques", pin.rnea(model, data, q, v, a))
    last = model.njoints - 1
    frame = model.addFrame(pin.Frame("tip", last, 0, pin.SE3(np.eye(3), HAND), pin.FrameType.OP_FRAME))
    data = model.createData()
    pin.forwardKinematics(model, data, q, v)
    pin.updateFramePlacements(model, data)
    velocity = pin.getFrameVelocity(model, data, frame, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED)
    show("hand", data.oMf[frame].translation)
    show("its velocity", velocity.linear)
    show("its angular velocity", velocity.angular)
    pin.forwardKinematics(model, data, q, v, 0 * a)
    bias = pin.getFrameClassicalAcceleration(model, data, frame, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED)
    show("its bias acceleration, angular", bias.angular)
    show("its bias acceleration, linear", bias.linear)


def quadruped():
    model = models.rebuilt(models.joints_of(models.go2_free()))
    data = model.createData()
    w, x, y, z = ORIENTATION
    q, v = np.array([*PLACE, x, y, z, w, *JOINTS]), np.array(SPEEDS, float)
    own, drift = models.turning(model, q, v)
    torques = -ELASTIC * (q[7:] - np.tile(LEG, 4)) - DAMPING * v[6:]
    u = own @ v
    a = pin.aba(model, data, q, u, np.concatenate([np.zeros(6), torques]))
    show("accelerations", own.T @ (a - drift))
    elastic = ELASTIC * np.sum((q[7:] - np.tile(LEG, 4)) ** 2) / 2
    potential = pin.computePotentialEnergy(model, data, q) + elastic
    show("energy", [pin.computeKineticEnergy(model, data, q, u) + potential])


if __name__ == "__main__":
    panda()
    quadruped()
