"""References of optimal controls and of Kapitza's pendulum for examples.

    python3 tools/optimal.py            prints them (some seconds)

Equations of motion are handwritten below; nothing comes from this project. SciPy solves the Riccati equations and computes the
characteristic values of Mathieu's equation. CasADi with Ipopt solves the optimal swing-up (`pip install casadi`), twice, by two
transcriptions: trapezoids and Hermite-Simpson with separate midpoints, each on several grids.

- cart_pole: gain of u = -K x about the upright, weights 10 1/m^2, 10 1/rad^2, 1, 1 and 0.1 1/N^2.
- quadcopter: gain about hovering of a rigid body under four thrusts, weights 10 1/m^2 of positions, 4 1/rad^2 of rotations, 1 of
  velocities and 1/N^2.
- both: the state of the nonlinear motion under that feedback, by DOP853.
- swing_up: Kelly, "An introduction to trajectory optimization", SIAM Review 59 (2017) 849-904, section 6 and appendix E.1: a cart of
  1 kg with a pole of 0.3 kg at 0.5 m that swings up within 2 s while the cart moves by 1 m, |u| <= 20 N, with the smallest integral of u^2.
- kapitza: the boundary of stability of the upright, by Mathieu's equation.
"""

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import solve_continuous_are
from scipy.special import mathieu_a, mathieu_b


def gain(a, b, q, r):
    return np.linalg.solve(r, b.T @ solve_continuous_are(a, b, q, r))


def cart_pole():
    """About the upright: (mc + mp) x'' - mp l d'' = u and mp l^2 d'' - mp l x'' = mp g l d - c d', with d = theta - pi."""
    mc, mp, l, c, g = 1.0, 0.1, 0.5, 0.01, 9.81
    m = np.array([[mc + mp, -mp * l], [-mp * l, mp * l * l]])
    k, d = np.diag([0.0, mp * g * l]), np.diag([0.0, -c])
    a = np.block([[np.zeros((2, 2)), np.eye(2)], [np.linalg.solve(m, k), np.linalg.solve(m, d)]])
    b = np.concatenate([np.zeros(2), np.linalg.solve(m, [1.0, 0.0])])[:, None]
    return gain(a, b, np.diag([10.0, 10.0, 1.0, 1.0]), np.array([[0.1]]))


def end(rates, y, until):
    return solve_ivp(lambda t, y: rates(y), (0, until), y, method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]


def balanced_cart_pole(k):
    """Returns x theta x' theta' 3 s after a start half a radian from the upright."""
    mc, mp, l, c, g = 1.0, 0.1, 0.5, 0.01, 9.81

    def rates(y):
        u = -(k @ (y - [0, np.pi, 0, 0]))[0]
        _, th, _, w = y
        m = [[mc + mp, mp * l * np.cos(th)], [mp * l * np.cos(th), mp * l * l]]
        f = [u + mp * l * w * w * np.sin(th), -mp * g * l * np.sin(th) - c * w]
        return np.concatenate([y[2:], np.linalg.solve(m, f)])

    return end(rates, np.array([0, np.pi - 0.5, 0, 0]), 3.0)


def hovering_quadcopter(k):
    """Returns position of the origin, quaternion, velocity of the origin and angular velocity along the body axes after 2 s. The start
    is at rest at (1, -0.5, 0.3), rotated by 0.4 rad about (2, -1, 2)/3."""
    arm, d, g, m, h = 0.25, 0.02, 9.81, 1.22, 0.003934426229508197
    inertia = np.array([0.008559448087431695, 0.008559448087431695, 0.016232666666666666])

    def matrix(q):
        w, x, y, z = q
        return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])

    def origin(y):
        rotation, w = matrix(y[3:7]), y[10:]
        return y[:3] - h * rotation[:, 2], y[7:10] - rotation @ np.cross(w, [0, 0, h])

    def rates(y):
        q, v, w = y[3:7], y[7:10], y[10:]
        place, velocity = origin(y)
        f = m * g / 4 - k @ np.concatenate([place, 2 * q[1:], velocity, w])
        moment = np.array([arm * (f[1] - f[3]), arm * (f[2] - f[0]), d * (f[0] - f[1] + f[2] - f[3])])
        turn = np.concatenate([[-q[1:] @ w], q[0] * w + np.cross(q[1:], w)]) / 2
        fall = matrix(q)[:, 2] * f.sum() / m - [0, 0, g]
        return np.concatenate([v, turn, fall, (moment - np.cross(w, inertia * w)) / inertia])

    axis = np.array([2, -1, 2]) / 3
    q = np.concatenate([[np.cos(0.2)], np.sin(0.2) * axis])
    start = np.concatenate([np.array([1, -0.5, 0.3]) + h * matrix(q)[:, 2], q, np.zeros(6)])
    found = end(rates, start, 2.0)
    place, velocity = origin(found)
    return np.concatenate([place, found[3:7], velocity, found[10:]])


def quadcopter():
    """Rows f1..f4; columns x y z, rotations about X Y Z, velocities of the centre of mass, angular velocities.

    The state of the model refers to the origin of the body, which is below the centre of mass by h: x_c = x + h rotation_y, y_c = y - h rotation_x.
    """
    arm, d, g = 0.25, 0.02, 9.81
    m, h, jx, jz = 1.22, 0.003934426229508197, 0.008559448087431695, 0.016232666666666666
    a, b = np.zeros((12, 12)), np.zeros((12, 4))
    a[:6, 6:] = np.eye(6)
    a[6, 4], a[7, 3] = g, -g
    b[8] = 1 / m
    b[9], b[10], b[11] = np.array([0, arm, 0, -arm]) / jx, np.array([-arm, 0, arm, 0]) / jx, d * np.array([1, -1, 1, -1]) / jz
    # From states of the centre of mass to those of the origin.
    s = np.eye(12)
    s[0, 4], s[1, 3], s[6, 10], s[7, 9] = -h, h, -h, h
    a, b = s @ a @ np.linalg.inv(s), s @ b
    return gain(a, b, np.diag([10.0] * 3 + [4.0] * 3 + [1.0] * 6), np.eye(4))


def rates(y, u):
    """Kelly's equations (6.1) and (6.2); q2 = 0 hangs."""
    m1, m2, l, g = 1.0, 0.3, 0.5, 9.81
    _, q, v, w = y[0], y[1], y[2], y[3]
    s, c = ca.sin(q), ca.cos(q)
    den = m1 + m2 * s * s
    return ca.vertcat(v, w, (l * m2 * s * w**2 + u + m2 * g * c * s) / den,
                      -(l * m2 * c * s * w**2 + u * c + (m1 + m2) * g * s) / (l * den))


def swing_up(n, scheme):
    opti, duration, distance = ca.Opti(), 2.0, 1.0
    h = duration / n
    points = n + 1 if scheme == "trapezoid" else 2 * n + 1
    y, u = opti.variable(4, points), opti.variable(points)
    f = [rates(y[:, k], u[k]) for k in range(points)]
    if scheme == "trapezoid":
        for k in range(n):
            opti.subject_to(y[:, k + 1] == y[:, k] + h / 2 * (f[k] + f[k + 1]))
        cost = h * sum((u[k]**2 + u[k + 1]**2) / 2 for k in range(n))
    else:
        for k in range(0, 2 * n, 2):
            opti.subject_to(y[:, k + 2] == y[:, k] + h / 6 * (f[k] + 4 * f[k + 1] + f[k + 2]))
            opti.subject_to(y[:, k + 1] == (y[:, k] + y[:, k + 2]) / 2 + h / 8 * (f[k] - f[k + 2]))
        cost = h / 6 * sum(u[k]**2 + 4 * u[k + 1]**2 + u[k + 2]**2 for k in range(0, 2 * n, 2))
    opti.minimize(cost)
    opti.subject_to(y[:, 0] == [0, 0, 0, 0])
    opti.subject_to(y[:, points - 1] == [distance, ca.pi, 0, 0])
    opti.subject_to(opti.bounded(-20, u, 20))
    opti.subject_to(opti.bounded(-2 * distance, y[0, :], 2 * distance))
    line = np.linspace(0, 1, points)
    opti.set_initial(y[0, :], line * distance)
    opti.set_initial(y[1, :], line * np.pi)
    opti.solver("ipopt", {"print_time": False}, {"print_level": 0, "tol": 1e-12, "sb": "yes"})
    found = opti.solve()
    return found.value(cost), found.value(u), found.value(y)


def kapitza(ratio):
    """Returns the drive w/w0 at which the upright becomes stable for a/l = ratio, w0^2 = g/l. With 2 s = w t, the deviation obeys
    d'' + (a - 2 q cos 2 s) d = 0, a = -4 (w0/w)^2 and q = 2 ratio. It is stable between a_0(q) and b_1(q)."""
    q = 2 * ratio
    low = -4 / mathieu_a(0, q)
    high = -4 / mathieu_b(1, q) if mathieu_b(1, q) < 0 else np.inf
    return np.sqrt(low), np.sqrt(high)


def main():
    np.set_printoptions(precision=15, linewidth=160)
    k = cart_pole()
    print("cart_pole", k, balanced_cart_pole(k))
    k = quadcopter()
    print("quadcopter", k, hovering_quadcopter(k), sep="\n")
    for ratio in (0.1, 0.2, 0.4, 0.5, 0.6):
        print("kapitza", ratio, *kapitza(ratio), np.sqrt(2) / ratio)
    for scheme in ("trapezoid", "hermite"):
        for n in (30, 50, 100, 200):
            cost, u, y = swing_up(n, scheme)
            print("swing_up", scheme, n, repr(cost), u[0], u[-1], y[0].min(), u.min(), u.max())


if __name__ == "__main__":
    main()
