"""Newton's and Euler's equations of rigid bodies in the world, with many digits: the basis of `tools/spatial_trees.py`.

Nothing here is recursive in the axes of bodies, and nothing is derived from energies. A pose is a homogeneous transformation
whose entries are power series in time, truncated after the square. Their coefficients are velocities and accelerations. Along
q + e_k s at a fixed time they are the columns J_k of the Jacobians of points and of angular velocities. Along q + v s + 0 s^2 they are
the accelerations without q''. With them

    sum of J_S^T (m a_S - F) + J_w^T (J w' + w x J w - M) = A^T lambda,    A q'' = -gamma,

which are linear in q'' and lambda (Kane, Levinson, *Dynamics: Theory and Applications*, sections 4.11 and 6.1).

Orientations may be unit quaternions r, the scalar part first, which rotate v to r v r*. Their velocities are an angular velocity u in the
rotated axes, r' = r u / 2. Along them J_k is a partial velocity, for u = e_k, and q'' stands for u'.
"""

from mpmath import cos, mpf, sin, sqrt

ORDERS = range(3)


class Series:
    """x0 + x1 s + x2 s^2."""

    def __init__(self, *coefficients):
        coefficients = [mpf(c) for c in coefficients]
        self.c = coefficients + [mpf(0)] * (3 - len(coefficients))

    @staticmethod
    def of(value):
        return value if isinstance(value, Series) else Series(value)

    def __add__(self, other):
        return Series(*(a + b for a, b in zip(self.c, Series.of(other).c)))

    def __neg__(self):
        return Series(*(-a for a in self.c))

    def __sub__(self, other):
        return self + -Series.of(other)

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        a, b = self.c, Series.of(other).c
        return Series(a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1] + a[2] * b[0])

    def __truediv__(self, number):
        return Series(*(a / mpf(number) for a in self.c))

    __radd__, __rmul__ = __add__, __mul__

    def composed(self, value, first, second):
        """Returns f of the series, from f(x0), f'(x0), f''(x0)."""
        _, x1, x2 = self.c
        return Series(value, first * x1, first * x2 + second * x1**2 / 2)

    def sin(self):
        return self.composed(sin(self.c[0]), cos(self.c[0]), -sin(self.c[0]))

    def cos(self):
        return self.composed(cos(self.c[0]), -sin(self.c[0]), -cos(self.c[0]))


def product(a, b):
    """Multiplies matrices in rows, of numbers or of series; zeros cost nothing."""
    def entry(row, column):
        total = 0
        for x, other in zip(row, b):
            y = other[column]
            if not (isinstance(x, int) and x == 0 or isinstance(y, int) and y == 0):
                total = total + x * y
        return total

    return [[entry(row, column) for column in range(len(b[0]))] for row in a]


def transposed(a):
    return [list(column) for column in zip(*a)]


def homogeneous(rotation, place):
    return [[*row, p] for row, p in zip(rotation, place)] + [[0, 0, 0, 1]]


IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def translation(x, y, z):
    return homogeneous(IDENTITY, [x, y, z])


def cross(a, b):
    return [a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3)]


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), mpf(0))


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def times(factor, a):
    return [factor * x for x in a]


def applied(m, a):
    return [dot(row, a) for row in m]


def direction(a):
    length = sqrt(dot(a, a))
    return [x / length for x in a]


def rotation(axis, angle):
    """Returns the rotation about a unit vector, c 1 + s n x + (1 - c) n n^T (Rodrigues)."""
    angle = Series.of(angle)
    c, s = angle.cos(), angle.sin()
    x, y, z = axis
    skew = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    return [
        [c * IDENTITY[i][j] + s * skew[i][j] + (1 - c) * (axis[i] * axis[j]) for j in range(3)]
        for i in range(3)
    ]


def turned(axis, angle):
    return homogeneous(rotation(axis, angle), [0, 0, 0])


def hamilton(a, b):
    """Multiplies quaternions: a0 b0 - a.b and a0 b + b0 a + a x b."""
    (scalar, *left), (other, *right) = a, b
    inner = left[0] * right[0] + left[1] * right[1] + left[2] * right[2]
    return [scalar * other - inner, *(scalar * y + other * x + z for x, y, z in zip(left, right, cross(left, right)))]


def oriented(r):
    """Returns the rotation of a unit quaternion: its columns are r e r* for the axes e."""
    conjugate = [r[0], *(-c for c in r[1:])]
    return transposed([hamilton(hamilton(r, [0, *axis]), conjugate)[1:] for axis in IDENTITY])


def moved(q, u, orientations):
    """Returns positions along constant velocities: q + u s, and r exp(u s / 2) for quaternions, which begin at some indices."""
    places, rest = [], iter(u)
    while len(places) < len(q):
        first = len(places)
        if first not in orientations:
            places.append(Series(q[first], next(rest)))
            continue
        r, turn = q[first : first + 4], [mpf(0), *(mpf(next(rest)) for _ in range(3))]
        once = hamilton(r, turn)
        places += [Series(c, a / 2, b / 8) for c, a, b in zip(r, once, hamilton(once, turn))]
    return places


def normalised(q, orientations):
    """Returns positions with unit quaternions."""
    q = list(q)
    for first in orientations:
        q[first : first + 4] = direction(q[first : first + 4])
    return q


def of_numbers(m):
    """Returns the constant parts."""
    return [[Series.of(entry).c[0] for entry in row] for row in m]


def roll_pitch_yaw(roll, pitch, yaw):
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    x, y, z = IDENTITY
    return of_numbers(product(product(rotation(z, yaw), rotation(y, pitch)), rotation(x, roll)))


def coefficient(m, order):
    return [[Series.of(entry).c[order] for entry in row] for row in m]


class Placed:
    """Pose of a frame along one motion, up to second order."""

    def __init__(self, pose):
        orders = [coefficient(pose, order) for order in ORDERS]
        self.rotations = [[row[:3] for row in m[:3]] for m in orders]
        self.places = [[row[3] for row in m[:3]] for m in orders]

    def point(self, own, order):
        """Returns a derivative of the position of a point."""
        factor = mpf(2) if order == 2 else mpf(1)
        return times(factor, plus(self.places[order], applied(self.rotations[order], own)))

    def angular_velocity(self):
        return axial(product(self.rotations[1], transposed(self.rotations[0])))

    def angular_acceleration(self):
        """Returns the angular acceleration: the axial vector of R'' R^T + R' R'^T."""
        r0, r1, r2 = self.rotations
        twice = [[2 * entry for entry in row] for row in r2]
        terms = product(twice, transposed(r0)), product(r1, transposed(r1))
        return axial([plus(a, b) for a, b in zip(*terms)])


def axial(m):
    return [(m[2][1] - m[1][2]) / 2, (m[0][2] - m[2][0]) / 2, (m[1][0] - m[0][1]) / 2]


def placed(poses):
    return {name: Placed(pose) for name, pose in poses.items()}


class Kinematics:
    """All frames at a state: `poses(q, t)` maps series to series. Quaternions begin at the indices `orientations`."""

    def __init__(self, poses, t, q, v, orientations=()):
        self.t, self.v = mpf(t), [mpf(x) for x in v]
        self.q = normalised([mpf(x) for x in q], orientations)
        self.size = len(v)
        moving = moved(self.q, self.v, orientations)
        units = ([int(k == column) for k in range(self.size)] for column in range(self.size))
        shifted = [moved(self.q, unit, orientations) for unit in units]
        # Series of the positions, and their derivatives by the velocities.
        self.rates = [x.c[1] for x in moving]
        self.rate_columns = [[x.c[1] for x in column] for column in shifted]
        self.motion = placed(poses(moving, Series(self.t, 1)))
        self.columns = [placed(poses(column, Series(self.t))) for column in shifted]

    def place(self, frame, own):
        return self.motion[frame].point(own, 0)

    def velocity(self, frame, own):
        return self.motion[frame].point(own, 1)

    def jacobian(self, frame, own):
        """Returns a list of columns."""
        return [column[frame].point(own, 1) for column in self.columns]

    def spin(self, frame):
        return self.motion[frame].angular_velocity()

    def spin_jacobian(self, frame):
        return [column[frame].angular_velocity() for column in self.columns]

    def acceleration(self, frame, own, q2):
        return along(self.jacobian(frame, own), q2, self.motion[frame].point(own, 2))

    def angular_acceleration(self, frame, q2):
        return along(self.spin_jacobian(frame), q2, self.motion[frame].angular_acceleration())

    def in_world(self, frame, own):
        return applied(self.motion[frame].rotations[0], own)

    def in_axes(self, frame, vector):
        return applied(transposed(self.motion[frame].rotations[0]), vector)


def along(columns, factors, start):
    total = start
    for column, factor in zip(columns, factors):
        total = plus(total, times(factor, column))
    return total


class Body:
    """Mass, centre of mass in body coordinates, tensor of inertia about it in body axes."""

    def __init__(self, frame, mass, centroid, tensor):
        self.frame, self.mass, self.centroid, self.tensor = frame, mass, centroid, tensor

    def tensor_in_world(self, kinematics):
        r = kinematics.motion[self.frame].rotations[0]
        return product(product(r, self.tensor), transposed(r))

    def kinetic_energy(self, kinematics):
        v, w = kinematics.velocity(self.frame, self.centroid), kinematics.spin(self.frame)
        return (self.mass * dot(v, v) + dot(w, applied(self.tensor_in_world(kinematics), w))) / 2

    def linear_momentum(self, kinematics):
        return times(self.mass, kinematics.velocity(self.frame, self.centroid))

    def angular_momentum(self, kinematics, about):
        arm = minus(kinematics.place(self.frame, self.centroid), about)
        own = applied(self.tensor_in_world(kinematics), kinematics.spin(self.frame))
        return plus(cross(arm, self.linear_momentum(kinematics)), own)


def undivided(kinematics, bodies):
    """Returns M and c of M q'' + c = Q."""
    n = kinematics.size
    mass_matrix, bias = [[mpf(0)] * n for _ in range(n)], [mpf(0)] * n
    for body in bodies:
        tensor = body.tensor_in_world(kinematics)
        moving, spinning = kinematics.jacobian(body.frame, body.centroid), kinematics.spin_jacobian(body.frame)
        zero = [mpf(0)] * n
        w = kinematics.spin(body.frame)
        force = times(body.mass, kinematics.acceleration(body.frame, body.centroid, zero))
        moment = applied(tensor, kinematics.angular_acceleration(body.frame, zero))
        moment = plus(moment, cross(w, applied(tensor, w)))
        turning = [applied(tensor, column) for column in spinning]
        for i in range(n):
            bias[i] += dot(moving[i], force) + dot(spinning[i], moment)
            for j in range(n):
                mass_matrix[i][j] += body.mass * dot(moving[i], moving[j]) + dot(spinning[i], turning[j])
    return mass_matrix, bias


def solved(mass_matrix, right, constraints, drifts):
    """Returns q'' and lambda of M q'' = right + A^T lambda, A q'' = -drifts, and the condition number of the combined matrix."""
    n, m = len(right), len(constraints)
    rows = [[*row, *(-constraint[i] for constraint in constraints)] for i, row in enumerate(mass_matrix)]
    rows += [[*constraint, *[mpf(0)] * m] for constraint in constraints]
    ends = [*right, *(-drift for drift in drifts)]
    units = [[mpf(i == j) for j in range(n + m)] for i in range(n + m)]
    columns = transposed(eliminated([[*row, end, *unit] for row, end, unit in zip(rows, ends, units)]))
    condition = largest_column(transposed(rows)) * largest_column(columns[1:])
    return columns[0][:n], columns[0][n:], condition


def eliminated(rows):
    """Solves for the columns behind a square matrix by Gauss-Jordan elimination; a singular matrix has no pivot."""
    rows = [list(row) for row in rows]
    for k in range(len(rows)):
        pivot = max(range(k, len(rows)), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i, row in enumerate(rows):
            if i != k and row[k]:
                rows[i] = [x - row[k] * y for x, y in zip(row, rows[k])]
    return [row[len(rows) :] for row in rows]


def largest_column(columns):
    return max(sum(abs(x) for x in column) for column in columns)
