"""Times at which a row of dominoes falls, for tests/trajectories/walls.rs.

    pip install numpy scipy
    python3 tools/dominoes.py

Dominoes of height h and thickness d stand at distances s from each other. Each turns about its front edge by the angle a. The top edge of
a domino touches the face of the next one, which it reaches at sin a = s/h. Without friction and restitution they stay in touch, so that
one angle determines all angles behind it:

    h sin(a - b) = (s + d) cos b - d,

where b is the angle of the next domino. Between impacts the energy is constant. An impact projects the velocities onto those of the
longer row, in the metric of the kinetic energy. Source: van Leeuwen, "The domino effect", Am. J. Phys. 78 (2010) 721-727, without friction.
"""

import numpy as np
from scipy.integrate import quad

G, HEIGHT, THICKNESS, DISTANCE, COUNT, SPEED = 9.81, 0.5, 0.1, 0.2, 8, 1.5
INERTIA = (HEIGHT**2 + THICKNESS**2) / 3


def angles(front, count):
    """Returns the angles of the last `count` dominoes from the front, and their derivatives by the angle of the front."""
    found, slopes = [front], [1.0]
    for _ in range(count - 1):
        b = found[-1]
        lean = ((DISTANCE + THICKNESS) * np.cos(b) - THICKNESS) / HEIGHT
        found.append(b + np.arcsin(lean))
        slopes.append(slopes[-1] * (1 - (DISTANCE + THICKNESS) * np.sin(b) / HEIGHT / np.sqrt(1 - lean**2)))
    return np.array(found), np.array(slopes)


def potential(front, count):
    found, _ = angles(front, count)
    return G / 2 * np.sum(HEIGHT * np.cos(found) + THICKNESS * np.sin(found))


def moment(front, count):
    _, slopes = angles(front, count)
    return INERTIA * np.sum(slopes**2)


def front_rate(angle, count, energy):
    return np.sqrt(2 * (energy - potential(angle, count)) / moment(angle, count))


def main():
    end = np.arcsin(DISTANCE / HEIGHT)
    time, rate, times = 0.0, SPEED, []
    for count in range(1, COUNT):
        energy = moment(0, count) * rate**2 / 2 + potential(0, count)
        time += quad(lambda angle: 1 / front_rate(angle, count, energy), 0, end, epsabs=1e-13, epsrel=1e-13)[0]
        times.append(time)
        # The impact projects velocities onto those of the row with the next domino.
        before = np.append(0, angles(end, count)[1] * front_rate(end, count, energy))
        after = angles(0, count + 1)[1]
        rate = before @ after / (after @ after)
        print(f"domino {count} hits the next at {time:.9f} s, which then turns at {rate:.9f}/s")
    speeds = (DISTANCE + THICKNESS) / np.diff(times)
    print("speeds of the wave:", speeds, "m/s")


main()
