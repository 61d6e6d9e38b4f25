#!/usr/bin/env python3
"""Reference accelerations: derives a `.lag` declaration with SymPy and evaluates it with 60 digits.

    python3 generate.py [--check] [NAME ...]        (needs: pip install sympy mpmath)

Writes NAME.json for each NAME.lag beside this file, or for the named ones. Existing times and states in a
NAME.json are kept, so that a new digit means a new derivation; a system without one gets
random states, the same on every run. With --check nothing is written: the files are compared with a
fresh derivation to 25 digits.

The mathematics, for a Lagrangian L(q, v, t) and generalised forces Q(q, v, t):

    p = dL/dv,    h = v . p - L,    M = d2L/dv dv,
    M a = dL/dq - (dp/dq) v - dp/dt + Q.

Q collects `force x = e`, the virtual work of `force F at P` (F . dP/dq) and of `torque m on angle`
(m dangle/dq), and -dR/dv of the dissipation R. Piecewise functions are differentiated branch by branch.

This is not the library's algorithm and shares no code with it: full second derivatives of unexpanded
expressions, then a dense LU solve. It reads the part of the language that the files here use and stops
at anything else; constraints, outputs and vector algebra are not covered.
"""

import argparse
import json
import pathlib
import random
import re
import sys

import mpmath
import sympy

HERE = pathlib.Path(__file__).resolve().parent
STATES = 3
DIGITS_PRINTED = 32
DIGITS_CHECKED = 25

mpmath.mp.dps = 60


class DeclarationError(Exception):
    """The declaration is outside the language subset, or meaningless."""


# --- Expressions ---------------------------------------------------------------------------------


def choose(condition, then, otherwise):
    return sympy.Piecewise((then, condition), (otherwise, True))


FUNCTIONS = {
    "sin": sympy.sin,
    "cos": sympy.cos,
    "tan": sympy.tan,
    "asin": sympy.asin,
    "acos": sympy.acos,
    "atan": sympy.atan,
    "atan2": sympy.atan2,
    "sinh": sympy.sinh,
    "cosh": sympy.cosh,
    "tanh": sympy.tanh,
    "exp": sympy.exp,
    "ln": sympy.log,
    "sqrt": sympy.sqrt,
    "pow": sympy.Pow,
    "hypot": lambda x, y: sympy.sqrt(x**2 + y**2),
    # SymPy's own Abs, sign, Min and Max differentiate to distributions; these do it branch by branch.
    "abs": lambda x: choose(x < 0, -x, x),
    "sign": lambda x: choose(x > 0, sympy.Integer(1), choose(x < 0, sympy.Integer(-1), sympy.Integer(0))),
    "min": lambda x, y: choose(x < y, x, y),
    "max": lambda x, y: choose(x < y, y, x),
}

RELATIONS = {"<": sympy.Lt, "<=": sympy.Le, ">": sympy.Gt, ">=": sympy.Ge}

TOKEN = re.compile(
    r"(?P<skip>\s+|//[^\n]*)|(?P<number>\d+(\.\d+)?(e[+-]?\d+)?)|(?P<name>[A-Za-z_]\w*)|(?P<mark><=|>=|[-+*/^(){}<>=,;])"
)


def tokens_of(text):
    position, tokens = 0, []
    while position < len(text):
        match = TOKEN.match(text, position)
        if match is None:
            raise DeclarationError(f"unexpected text: {text[position:position + 30]!r}")
        if match.lastgroup != "skip":
            tokens.append((match.lastgroup, match.group()))
        position = match.end()
    return tokens + [("end", "")]


class System:
    """A declaration, read and resolved: SymPy expressions in the symbols of q, v, t, parameters and inputs.

    Symbols are plain (complex), because SymPy would otherwise rewrite sqrt(x**2) as Abs(x).
    """

    def __init__(self, text):
        self.tokens, self.position = tokens_of(text), 0
        self.t = sympy.Symbol("t")
        self.q, self.v = [], []
        self.names = {"t": self.t, "pi": sympy.pi}
        self.values = {"param": {}, "input": {}}
        self.kinetic = self.potential = self.dissipation = sympy.Integer(0)
        self.lagrangian = None
        self.work = []
        while self.tokens[self.position][0] != "end":
            self.statement()
        if not self.q:
            raise DeclarationError("no coordinates")
        self.ranges = {
            name: (float(low), float(high))
            for name, low, high in re.findall(r"^// range (\w+) = (\S+), (\S+)$", text, re.MULTILINE)
        }

    # Tokens

    def take(self, text=None):
        kind, found = self.tokens[self.position]
        if text is not None and found != text:
            raise DeclarationError(f"expected {text!r}, found {found!r}")
        self.position += 1
        return kind, found

    def at(self, *texts):
        return self.tokens[self.position][1] in texts

    def took(self, text):
        if self.at(text):
            self.position += 1
            return True
        return False

    def name(self):
        kind, text = self.take()
        if kind != "name":
            raise DeclarationError(f"expected a name, found {text!r}")
        return text

    def names_until(self, end):
        names = [self.name()]
        while self.took(","):
            names.append(self.name())
        self.take(end)
        return names

    # Statements

    def declare(self, name, value):
        if name in self.names:
            raise DeclarationError(f"{name} is declared twice")
        self.names[name] = value

    def statement(self):
        keyword = self.name()
        reader = getattr(self, f"read_{keyword}", None)
        if reader is None:
            raise DeclarationError(f"statement {keyword!r} is not covered")
        reader()

    def read_values(self, kind):
        while True:
            name = self.name()
            self.take("=")
            self.values[kind][name] = self.expression()
            self.declare(name, sympy.Symbol(name))
            if not self.took(","):
                break
        self.take(";")

    def read_param(self):
        self.read_values("param")

    def read_input(self):
        self.read_values("input")

    def read_coord(self):
        for name in self.names_until(";"):
            self.q.append(sympy.Symbol(name))
            self.v.append(sympy.Symbol(f"dot({name})"))
            self.declare(name, self.q[-1])

    def read_let(self):
        if self.took("("):
            names = self.names_until(")")
            self.take("=")
            values = self.components()
            if len(names) != len(values):
                raise DeclarationError(f"{len(names)} names for {len(values)} components")
        else:
            names = [self.name()]
            self.take("=")
            values = [self.expression()]
        self.take(";")
        for name, value in zip(names, values):
            self.declare(name, value)

    read_const = read_let

    def assigned(self):
        self.take("=")
        value = self.expression()
        self.take(";")
        return value

    def read_kinetic(self):
        self.kinetic += self.assigned()

    def read_potential(self):
        self.potential += self.assigned()

    def read_lagrangian(self):
        self.lagrangian = (self.lagrangian or 0) + self.assigned()

    def read_dissipation(self):
        self.dissipation += self.assigned()

    def read_force(self):
        if self.at("("):
            force = self.components()
            self.take("at")
            point = self.components()
            if len(force) != len(point):
                raise DeclarationError("force and point differ in dimension")
            self.work += zip(force, point)
            self.take(";")
        else:
            coordinate = self.names[self.name()]
            if coordinate not in self.q:
                raise DeclarationError(f"{coordinate} is not a coordinate")
            self.work.append((self.assigned(), coordinate))

    def read_torque(self):
        moment = self.expression()
        self.take("on")
        self.work.append((moment, self.expression()))
        self.take(";")

    # Expressions, by falling precedence from the bottom up

    def components(self):
        self.take("(")
        values = [self.expression()]
        while self.took(","):
            values.append(self.expression())
        self.take(")")
        return values

    def expression(self):
        value = self.product()
        while self.at("+", "-"):
            _, sign = self.take()
            term = self.product()
            value = value + term if sign == "+" else value - term
        return value

    def product(self):
        value = self.unary()
        while self.at("*", "/"):
            _, sign = self.take()
            factor = self.unary()
            value = value * factor if sign == "*" else value / factor
        return value

    def unary(self):
        return -self.unary() if self.took("-") else self.power()

    def power(self):
        base = self.atom()
        return base ** self.unary() if self.took("^") else base

    def atom(self):
        kind, text = self.take()
        if kind == "number":
            return sympy.Rational(text)
        if text == "(":
            value = self.expression()
            self.take(")")
            return value
        if text == "if":
            return self.conditional()
        if kind == "name" and self.at("("):
            return self.call(text, self.components())
        if kind == "name" and text in self.names:
            return self.names[text]
        raise DeclarationError(f"unknown: {text!r}")

    def conditional(self):
        left = self.expression()
        _, relation = self.take()
        if relation not in RELATIONS:
            raise DeclarationError(f"expected a comparison, found {relation!r}")
        condition = RELATIONS[relation](left, self.expression())
        self.take("{")
        then = self.expression()
        self.take("}")
        self.take("else")
        if self.took("if"):
            return choose(condition, then, self.conditional())
        self.take("{")
        otherwise = self.expression()
        self.take("}")
        return choose(condition, then, otherwise)

    def call(self, name, arguments):
        if name == "dot" and len(arguments) == 1:
            return self.rate(arguments[0])
        if name not in FUNCTIONS:
            raise DeclarationError(f"function {name!r} is not covered")
        return FUNCTIONS[name](*arguments)

    def rate(self, e):
        """Returns the total time derivative of an expression free of velocities."""
        if e.free_symbols & set(self.v):
            raise DeclarationError("dot of an expression that holds velocities")
        return along(e, self.q, self.v) + e.diff(self.t)


def along(e, variables, direction):
    """Returns the derivative of e along a direction in the space of the variables."""
    return sympy.Add(*(e.diff(x) * d for x, d in zip(variables, direction)))


# --- Derivation and evaluation -------------------------------------------------------------------


def evaluator(system):
    """Returns f(t, q, v) -> the numbers of one state, as 60-digit floats."""
    q, v, t = system.q, system.v, system.t
    separate = system.lagrangian is None
    lagrangian = system.kinetic - system.potential if separate else system.lagrangian
    momenta = [lagrangian.diff(v_i) for v_i in v]
    mass = [[p.diff(v_j) if j <= i else None for j, v_j in enumerate(v)] for i, p in enumerate(momenta)]
    forcing = [
        lagrangian.diff(q_i)
        - along(p, q, v)
        - p.diff(t)
        - system.dissipation.diff(v_i)
        + sympy.Add(*(force * place.diff(q_i) for force, place in system.work))
        for q_i, v_i, p in zip(q, v, momenta)
    ]
    scalars = [lagrangian, system.kinetic, system.potential]
    lower = [mass[i][j] for i in range(len(q)) for j in range(i + 1)]

    given = {**system.values["param"], **system.values["input"]}
    constants = [number(value) for value in given.values()]
    arguments = [t, *q, *v, *map(sympy.Symbol, given)]
    compiled = sympy.lambdify(arguments, momenta + lower + forcing + scalars, "mpmath", cse=True)

    def evaluate(time, position, velocity):
        numbers = [real(x) for x in compiled(time, *position, *velocity, *constants)]
        n = len(q)
        p, numbers = numbers[:n], numbers[n:]
        entries, f = iter(numbers[: len(lower)]), numbers[len(lower) : len(lower) + n]
        m = mpmath.matrix(n, n)
        for i in range(n):
            for j in range(i + 1):
                m[i, j] = m[j, i] = next(entries)
        value, kinetic, potential = numbers[-3:]
        record = {
            "acceleration": list(mpmath.lu_solve(m, mpmath.matrix(f))),
            "multipliers": [],
            "mass_matrix": m.tolist(),
            "momenta": p,
            "energy": mpmath.fdot(p, velocity) - value,
        }
        if separate:
            record |= {"kinetic": kinetic, "potential": potential}
        return record

    return evaluate


def number(e):
    return mpmath.mpf(sympy.Rational(e).p) / sympy.Rational(e).q


def real(x):
    if mpmath.im(x) != 0 or not mpmath.isfinite(x):
        raise DeclarationError(f"a state leaves the domain of the energies: {x}")
    return mpmath.re(x)


def random_states(name, system):
    """Returns states of six decimals; velocities of x are bounded by `// range d_x`."""
    generator = random.Random(name)

    def draw(key, low, high):
        return mpmath.mpf(f"{generator.uniform(*system.ranges.get(key, (low, high))):.6f}")

    return [
        (
            draw("t", 0.0, 2.0),
            [draw(str(q), -1.2, 1.2) for q in system.q],
            [draw(f"d_{q}", -1.5, 1.5) for q in system.q],
        )
        for _ in range(STATES)
    ]


# --- Files ---------------------------------------------------------------------------------------


def printed(x):
    if isinstance(x, list):
        return [printed(y) for y in x]
    # After cancellation an exact zero is noise of the working precision.
    return "0.0" if abs(x) < mpmath.mpf(10) ** -45 else mpmath.nstr(x, DIGITS_PRINTED, strip_zeros=False)


def derive(name, committed):
    """Returns the contents of NAME.json, at the states of the committed file if there is one."""
    system = System((HERE / f"{name}.lag").read_text())
    evaluate = evaluator(system)
    if committed is None:
        states = random_states(name, system)
    else:
        states = [
            (mpmath.mpf(s["t"]), [mpmath.mpf(x) for x in s["q"]], [mpmath.mpf(x) for x in s["v"]])
            for s in committed["states"]
        ]
    return {
        "name": name,
        "params": {name: mpmath.nstr(number(value), 30) for name, value in system.values["param"].items()},
        "inputs": {name: mpmath.nstr(number(value), 30) for name, value in system.values["input"].items()},
        "coords": [str(q) for q in system.q],
        "constraints": [],
        "states": [
            {key: printed(value) for key, value in {"t": t, "q": q, "v": v, **evaluate(t, q, v)}.items()}
            for t, q, v in states
        ],
    }


def differences(derived, committed, place=""):
    """Returns the places where two records differ in structure, or in numbers beyond |a - b| <= 1e-25 (1 + max|b|)."""
    if isinstance(derived, dict) and isinstance(committed, dict) and list(derived) == list(committed):
        return [d for key in derived for d in differences(derived[key], committed[key], f"{place}.{key}")]
    if is_array(derived) and is_array(committed):
        a, b = flat(derived), flat(committed)
        scale = 1 + max((abs(x) for x in b), default=0)
        close = len(a) == len(b) and all(abs(x - y) <= scale * mpmath.mpf(10) ** -DIGITS_CHECKED for x, y in zip(a, b))
        return [] if close else [place]
    if isinstance(derived, list) and isinstance(committed, list) and len(derived) == len(committed):
        return [d for i, pair in enumerate(zip(derived, committed)) for d in differences(*pair, f"{place}[{i}]")]
    return [] if derived == committed else [place]


def is_array(x):
    """True if x is a number in a string, or (nested) lists of them."""
    if isinstance(x, list):
        return all(is_array(y) for y in x)
    return isinstance(x, str) and re.fullmatch(r"-?\d+\.\d+(e[+-]?\d+)?", x) is not None


def flat(x):
    return [z for y in x for z in flat(y)] if isinstance(x, list) else [mpmath.mpf(x)]


def main():
    parser = argparse.ArgumentParser(description="Reference accelerations for the declarations in this folder.")
    parser.add_argument("--check", action="store_true", help="compare with the files instead of writing them")
    parser.add_argument("names", nargs="*", metavar="NAME", help="systems; all of them if none is named")
    options = parser.parse_args()
    wrong = 0
    for name in options.names or sorted(path.stem for path in HERE.glob("*.lag")):
        file = HERE / f"{name}.json"
        committed = json.loads(file.read_text()) if file.exists() else None
        derived = derive(name, committed)
        if not options.check:
            file.write_text(json.dumps(derived, indent=1) + "\n")
            print(f"{name}: written")
            continue
        found = ["no JSON file"] if committed is None else differences(derived, committed)
        wrong += bool(found)
        print(f"{name}: {', '.join(found) if found else 'agrees'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
