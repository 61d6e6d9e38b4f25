#!/usr/bin/env python3
"""Adds one of each thing for which ARCHITECTURE.md has a recipe, in a scratch copy of the project.

An edit inserts a text after another, or replaces it. A file may only be edited if the recipe names
it, unless it is new, and every file that the recipe names must be edited, except in sentences that begin with "If" or
"Imitate". The copy is then compiled with the checks of `tools/recipes/checks.rs`, one for each
recipe, and with the tests of the copy that compare lists. A table shows the files and lines of each
recipe.

Usage: tools/recipes.py [--dry] [FOLDER]

FOLDER, by default `target/recipes`, keeps the copy and what is built: a second run is faster. With
`--dry`, nothing is compiled. What is built is never shared with the project: cargo gives the crates
of the copy the same names, and would take one for the other.
"""

import os
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OWN = ROOT / "tools" / "recipes"

EXPR = "crates/lagrange-expr/src"
LANGUAGE = "crates/lagrange-language/src"
RUNTIME = "crates/lagrange-runtime/src"
DRAW = "crates/lagrange-draw/src"
CORE = "lagrange-core/src"
GUIDE = "src/language.md"


def after(path, anchor, text):
    """Returns an insertion: the anchor stays, and the text follows it."""
    return path, anchor, anchor + text


def replace(path, old, new):
    """Returns a replacement."""
    return path, old, new


def new(path, source):
    """Returns a new file, a copy of one beside this tool."""
    return path, None, (OWN / source).read_text()


FUNCTION = [
    replace(f"{EXPR}/elementary.rs", "Abs, Acos, Asin, Atan, Atan2", "Abs, Acos, Asin, Asinh, Atan, Atan2"),
    after(f"{EXPR}/elementary.rs", "    Tanh,\n", "    Asinh,\n"),
    replace(f"{EXPR}/elementary.rs", "ROWS: [Row; 20]", "ROWS: [Row; 21]"),
    after(
        f"{EXPR}/elementary.rs",
        "|x| x[0].tanh(), &[Linear(1, -1, &Square(&Value))])\n    },\n",
        r"""    Row {
        parity: Parity::Odd,
        at_zero: Some(0),
        ..Row::new(
            Asinh,
            "asinh",
            r"\operatorname{arsinh}\left(#1\right)",
            |x| x[0].asinh(),
            &[ReciprocalRoot(&Linear(1, 1, &Square(&X)))],
        )
    },
""",
    ),
    after(
        "crates/lagrange-math/src/functions.rs",
        "                    Self::select(is_one, one, self.sinh() / self.cosh())\n                }\n            }\n",
        """
            asinh(x) C(asinh, asinhf) lanes() {
                /// Computes the number with this hyperbolic sine.
                fn(self) {
                    // One step of Newton's method, except where the sum does not cancel.
                    let size = self.abs();
                    let large = (size + self.hypot(Self::ONE)).ln();
                    let step = (large.sinh() - size) / large.cosh();
                    let small = Self::select(size.less(Self::ONE), large - step, large);
                    Self::select(self.less(Self::ZERO), -small, Self::select(size.less_equal(Self::ZERO), self, small))
                }
            }
""",
    ),
    after("crates/lagrange-jit/src/machine.rs", "Cosh(x), Tanh(x), ", "Asinh(x), "),
    after(
        "crates/lagrange-double/src/number.rs",
        "        self.hyperbolic_tangent()\n    }\n",
        """
    fn asinh(self) -> Self {
        let size = self.abs();
        let start = Double::from_f64(Number::asinh(size.upper));
        if size < Double::ONE {
            let start = start - (start.sinh() - size) / start.cosh();
            return if self < Double::ZERO { -start } else { start };
        }
        let value = (size + size.hypot(Double::ONE)).ln();
        if self < Double::ZERO { -value } else { value }
    }
""",
    ),
    replace(GUIDE, "sinh cosh tanh exp ln", "sinh cosh tanh asinh exp ln"),
    after(
        "lagrange-core/tests/common/digits.rs",
        "            Function::Tanh => x.tanh(bits, ROUNDING, constants),\n",
        "            Function::Asinh => x.asinh(bits, ROUNDING, constants),\n",
    ),
    replace(
        f"{LANGUAGE}/syntax/foreign/functions.rs",
        '    (&["asinh", "arcsinh"], 1, "ln(#1 + sqrt(#1^2 + 1))"),\n',
        '    (&["arcsinh"], 1, "asinh(#1)"),\n',
    ),
    replace("lagrange-core/tests/mistakes/advice.rs", '("asinh", 1, |x', '("arcsinh", 1, |x'),
]

PRODUCT = [
    after(f"{CORE}/model/product.rs", "    Momenta,\n", "    Virial,\n"),
    replace(f"{CORE}/model/product/rows.rs", "ROWS: [ProductRow; 41]", "ROWS: [ProductRow; 42]"),
    after(
        f"{CORE}/model/product/rows.rs",
        '&["Generalised momenta ∂L/∂v."])\n        .in_unit(Over("J")),\n',
        """    ProductRow::new(Product::Virial, "virial", Demand)
        .with_method(State, Scalar, &["Sum v·∂L/∂v of the velocities times the momenta."])
        .in_unit(Same("J")),
""",
    ),
    after(
        f"{CORE}/derive/products.rs",
        "            Product::Energy => vec![energy_function(model)],\n",
        """            Product::Virial => {
                let energy = energy_function(model);
                vec![model.graph.add(energy, model.lagrangian)]
            }
""",
    ),
    after(
        "src/private/hints.rs",
        '        "add `emit {{ bias }}` to the declaration";\n',
        """    pub trait EmitsVirial {} for fn virial in Virial:
        "the declaration of `{Self}` does not emit `virial`",
        "add `emit {{ virial }}` to the declaration";
""",
    ),
    replace("src/private/hints.rs", "            Taylor as _,\n", "            Taylor as _, Virial as _,\n"),
    after(
        GUIDE,
        "| `emit { … }` | adds |\n|---|---|\n",
        "| `virial` | `virial(t, q, v)`, `S`: the sum v·∂L/∂v of the velocities times the momenta |\n",
    ),
]

JOINT = [
    after(
        f"{LANGUAGE}/syntax/ast/mobilizers.rs",
        '                "write `universal (a, b) = shaft to fork { at: p; }`";\n',
        """            /// `gimbal (a, b, c)`: turns about x, about the rotated y and about the rotated z.
            Gimbal "gimbal" "(a, b, c)" [Turn(Frame(0)), Turn(Frame(1)), Turn(Frame(2))] Coordinates:
                "write `gimbal (a, b, c) = ground to rotor { at: p; }`";
""",
    ),
    replace(f"{LANGUAGE}/syntax/ast/mobilizers.rs", '| "universal" | "planar" )', '| "universal" | "gimbal" | "planar" )'),
    after(
        f"{RUNTIME}/scene/spatial.rs",
        "    /// Rotation about two axes at right angles.\n    Universal,\n",
        "    /// Rotation about three axes, each at right angles to the next.\n    Gimbal,\n",
    ),
    replace(
        f"{DRAW}/space/stage.rs",
        "            SpatialJointKind::Ball | SpatialJointKind::Pin =>",
        "            SpatialJointKind::Ball | SpatialJointKind::Gimbal | SpatialJointKind::Pin =>",
    ),
    after(
        GUIDE,
        "turns about x by a, then about the rotated y by b |\n",
        "| `gimbal (a, b, c) = a to b { … }` | turns about x by a, then about the rotated y by b, then about the rotated z by c |\n",
    ),
    replace(f"{LANGUAGE}/syntax/messages.rs", "`universal`, `planar`, `ball` and", "`universal`, `gimbal`, `planar`, `ball` and"),
    replace(f"{LANGUAGE}/syntax/tests/mistakes.rs", "`universal`, `planar`,", "`universal`, `gimbal`, `planar`,"),
    replace("lagrange-core/tests/spatial/drawing.rs", "MobilizerKind::Universal | ", "MobilizerKind::Universal | MobilizerKind::Gimbal | "),
    replace("lagrange-core/tests/spatial/drawing.rs", "Ball, Free, Universal};", "Ball, Free, Gimbal, Universal};"),
    replace("lagrange-core/tests/spatial/drawing.rs", "Mobilizer(Ball | Free |", "Mobilizer(Ball | Free | Gimbal |"),
]

UNIT = [
    after(
        f"{EXPR}/units/table.rs",
        '    scaled(&["nmi"], ("1852", "1", 0), &[("m", 1)]),\n',
        '    scaled(&["furlong"], ("201.168", "1", 0), &[("m", 1)]),\n',
    ),
    replace(f"{EXPR}/units/table.rs", "SCALED: [Scaled; 43]", "SCALED: [Scaled; 44]"),
    after(
        f"{EXPR}/units/tests.rs",
        '    ("nmi", "1852", "1", 0, [0, 1, 0, 0, 0, 0, 0]),\n',
        '    ("furlong", "201.168", "1", 0, [0, 1, 0, 0, 0, 0, 0]),\n',
    ),
    replace(f"{EXPR}/units/tests.rs", "i32, [i8; 7]); 53]", "i32, [i8; 7]); 54]"),
    replace(GUIDE, "yd mi nmi au ha", "yd mi nmi furlong au ha"),
]

PLANE = [
    after(
        f"{EXPR}/solids.rs",
        '    Solid::new("ellipse", &["a", "b"], "Ellipse", |g, x| sum_of_squares(g, x, 1, 4)),\n',
        '    Solid::new("rhombus", &["a", "b"], "Rhombus", |g, x| sum_of_squares(g, x, 1, 24)),\n',
    ),
    replace(f"{EXPR}/solids.rs", "SOLIDS: [Solid; 19]", "SOLIDS: [Solid; 20]"),
    after(
        f"{RUNTIME}/scene/plane.rs",
        "    Ellipse(a: S, b: S);\n",
        "    /// A rhombus about the origin: diagonals along X and along Y.\n    Rhombus(a: S, b: S);\n",
    ),
    replace(
        f"{RUNTIME}/inertia/solids.rs",
        "/// Returns the moment of inertia of an ellipse with semi-axes",
        """/// Returns the moment of inertia of a rhombus with diagonals a and b: m (a² + b²)/24.
pub fn rhombus<S: Scalar>(mass: S, a: S, b: S) -> S {
    mass * squares([a, b], 1.0, 24.0)
}

/// Returns the moment of inertia of an ellipse with semi-axes""",
    ),
    replace(f"{RUNTIME}/inertia.rs", "regular_polygon, right_triangle,", "regular_polygon, rhombus, right_triangle,"),
    after(
        f"{DRAW}/outline.rs",
        "        Outline::Ellipse(a, b) => Form::Area(vec![ellipse([a.into(), b.into()])]),\n",
        """        Outline::Rhombus(a, b) => {
            let (x, y) = (0.5 * a.into(), 0.5 * b.into());
            polygon(vec![[x, 0.0], [0.0, y], [-x, 0.0], [0.0, -y]])
        }
""",
    ),
    after(
        "crates/lagrange-page/src/plane.js",
        "    Ellipse: (half, a, b) => ({ rings: [arc(a, 0, 2 * Math.PI, [a, b])] }),\n",
        "    Rhombus: (half, a, b) => ({ rings: [[[a / 2, 0], [0, b / 2], [-a / 2, 0], [0, -b / 2]]] }),\n",
    ),
    after(
        "tests/api/inertia/formulas.rs",
        '        ("ellipse", &[a, b]) => (inertia::ellipse(1.0, a, b), origin),\n',
        '        ("rhombus", &[a, b]) => (inertia::rhombus(1.0, a, b), origin),\n',
    ),
    after(
        "tests/api/inertia/derived.rs",
        "    let mut cases = Vec::new();\n",
        """    let [right, left] = [0.6, -0.6].map(|x| [x, 0.0]);
    let halves = [triangle([right, [0.0, 0.35], left]), triangle([right, left, [0.0, -0.35]])];
    let halves = halves.each_ref().map(|half| half as &dyn Fn([f64; 3]) -> Element);
    cases.push(Case { name: "rhombus", dimensions: vec![1.2, 0.7], measured: measure(&halves) });
""",
    ),
    after(GUIDE, "| `ellipse(a, b)` | half axes |\n", "| `rhombus(a, b)` | diagonals |\n"),
]

SPACE = [
    after(
        f"{LANGUAGE}/bodies/space/solids.rs",
        "pub(super) const SOLIDS_IN_SPACE: &[SolidInSpace] = &[\n",
        """    // Its base is at z = 0.
    SolidInSpace {
        centroid: |t, x| {
            let [_, _, up] = zero_triple(t);
            let (three, eight) = (t.number(3), t.number(8));
            let part = t.divide(three, eight);
            [up, up, t.times(part, x[0])]
        },
        ..SolidInSpace::new("hemisphere", "Hemisphere", &["r"], |t, x| {
            about_axis(t, &[(83, 320, x[0])], &[(2, 5, x[0])])
        })
    },
""",
    ),
    after(
        f"{RUNTIME}/scene/spatial.rs",
        "    Sphere(radius: S);\n",
        "    /// Half a sphere of this radius, with its base at z = 0.\n    Hemisphere(radius: S);\n",
    ),
    after(
        f"{DRAW}/space/solids.rs",
        "        Solid::Sphere(radius) => ellipsoid([radius; 3], ROUND, RINGS),\n",
        """        Solid::Hemisphere(radius) => {
            let circle = |ring: usize| (0.5 * PI * ring as f64 / RINGS as f64).sin_cos();
            let circles = (0..RINGS).map(circle).map(|(sin, cos)| (radius * cos, radius * sin, 0.0));
            pointed(&circles.collect::<Vec<_>>(), (radius, 0.0), ROUND)
        }
""",
    ),
    after(GUIDE, "| `cone(r, h)` | radius of its base at Z = 0, and height of its tip |\n", "| `hemisphere(r)` | radius; base at Z = 0 |\n"),
]

INTEGRATOR = [
    new(f"{RUNTIME}/integrate/ralston.rs", "ralston.rs"),
    after(f"{RUNTIME}/integrate/mod.rs", "mod radau;\n", "mod ralston;\n"),
    after(f"{RUNTIME}/integrate/mod.rs", "pub use self::radau::{Radau5, RadauStepper};\n", "pub use self::ralston::Ralston;\n"),
    replace(f"{RUNTIME}/trade/methods.rs", "Radau5,\n", "Radau5, Ralston,\n"),
    after(
        f"{RUNTIME}/trade/methods.rs",
        "        self.by_tolerance(name, system, Verner98::tolerance)\n",
        "            .by_step(name, system, |step| Ralston { step })\n",
    ),
    after(
        "src/integrate.rs",
        "4 evaluations | fixed frame rates, forces with jumps |\n",
        "//! | [`Ralston`] | any that is not stiff | 2 | no | 2 evaluations | coarse motions |\n",
    ),
    replace("src/integrate.rs", "RadauStepper, RungeKutta4,", "RadauStepper, Ralston, RungeKutta4,"),
]

# The title of the recipe in ARCHITECTURE.md, its edits, and the check.
RECIPES = [
    ("a function", FUNCTION, "function"),
    ("a product", PRODUCT, "product_of_the_model"),
    ("a joint in space", JOINT, "joint_in_space"),
    ("a unit", UNIT, "unit"),
    ("a solid of the plane", PLANE, "solid_of_the_plane"),
    ("a solid in space", SPACE, "solid_in_space"),
    ("an integrator", INTEGRATOR, "integrator"),
]

MANIFEST = """[workspace]

[package]
name = "recipes"
version = "0.0.0"
edition = "2024"

[lib]
path = "checks.rs"

[dependencies]
lagrange = { path = "..", features = ["ensemble"] }
lagrange-core = { path = "../lagrange-core" }
lagrange-double = { path = "../crates/lagrange-double" }
lagrange-dynamic = { path = "../crates/lagrange-dynamic", features = ["draw"] }
lagrange-runtime = { path = "../crates/lagrange-runtime" }

[profile.dev]
debug = "none"
"""

# Tests of the copy that compare lists with rows, and tests that name each row.
TESTS = [
    "--package lagrange-expr --package lagrange-language --lib",
    "--package lagrange-core --test mistakes --test spatial",
    "--package lagrange-tests --test api -- function product inertia",
]


def recipes():
    """Returns the paragraphs of the recipes in ARCHITECTURE.md by their titles."""
    text = (ROOT / "ARCHITECTURE.md").read_text()
    part = text.split("## Where do I add …")[1].split("\n## ")[0]
    paragraphs = re.split(r"\n- \*\*", part)[1:]
    return dict(paragraph.split("**", 1) for paragraph in paragraphs)


def named(paragraph):
    """Returns the files that a recipe names: those to edit always, and those to edit in some cases."""
    always, sometimes = set(), set()
    for sentence in re.split(r"(?<=[.:;])\s+(?=[A-Z])", " ".join(paragraph.split())):
        files = set(re.findall(r"`([\w./-]+/[\w.-]+\.(?:rs|md|js))`", sentence))
        if sentence.startswith("Imitate"):
            continue
        (sometimes if sentence.startswith("If ") else always).update(files)
    return always, sometimes


def complaints():
    """Yields what differs between the recipes and the edits."""
    paragraphs = recipes()
    for title, edits, _ in RECIPES:
        if title not in paragraphs:
            yield f"ARCHITECTURE.md has no recipe for {title}"
            continue
        always, sometimes = named(paragraphs[title])
        edited = {path for path, old, _ in edits if old is not None}
        for path in sorted(edited - always - sometimes):
            yield f"{title}: the recipe does not name {path}"
        for path in sorted(always - edited):
            yield f"{title}: {path} need not be edited"


def tracked():
    """Returns the tracked files, and new ones that are not ignored."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True).stdout
    return [name for name in listed.decode().split("\0") if name and (ROOT / name).is_file()]


def edited_texts():
    """Returns the texts of the edited files, and the number of added lines of each recipe."""
    texts, added = {}, {}
    for title, edits, _ in RECIPES:
        added[title] = 0
        for path, old, text in edits:
            if old is None:
                texts[path] = text
                added[title] += text.count("\n")
                continue
            before = texts.get(path) or (ROOT / path).read_text()
            if before.count(old) != 1:
                sys.exit(f"{title}: {path} has {before.count(old)} times\n{old}")
            texts[path] = before.replace(old, text)
            more = text.count("\n") - old.count("\n")
            # A changed line counts as one line.
            added[title] += more if more > 0 else 1
    return texts, added


def write(path, content):
    """Writes a file unless it has this content, so that cargo sees no change."""
    if path.is_file() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def copy(folder, texts):
    """Makes the copy with the edits, and the crate of checks in it."""
    files = {name: (ROOT / name).read_bytes() for name in tracked()}
    files.update({path: text.encode() for path, text in texts.items()})
    files["recipes/Cargo.toml"] = MANIFEST.encode()
    files["recipes/checks.rs"] = (OWN / "checks.rs").read_bytes()
    files["recipes/Cargo.lock"] = files["Cargo.lock"]
    for stale in folder.rglob("*.rs"):
        if str(stale.relative_to(folder)) not in files:
            stale.unlink()
    for name, content in files.items():
        write(folder / name, content)


def cargo(arguments, folder, target):
    """Runs tests in a folder; returns True if all pass, and the output."""
    environment = {
        **os.environ,
        "CARGO_TARGET_DIR": str(target),
        "CARGO_INCREMENTAL": "0",
        "CARGO_PROFILE_DEV_DEBUG": "none",
        "CARGO_PROFILE_DEV_BUILD_OVERRIDE_DEBUG": "none",
    }
    command = ["cargo", "test", *arguments.split()]
    done = subprocess.run(command, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode == 0, done.stdout


def compiled(folder, texts):
    """Runs the checks and the tests of the copy; returns the results of the checks, and whether all passed."""
    target = folder / "build"
    copy(folder / "copy", texts)
    all_passed, output = cargo("--lib --offline", folder / "copy" / "recipes", target)
    results = {title: f"test {check} ... ok" in output for title, _, check in RECIPES}
    if not all_passed:
        print(output)
    for tests in TESTS:
        passed, output = cargo(tests, folder / "copy", target)
        all_passed &= passed
        print(f"cargo test {tests}: {'passed' if passed else output}", flush=True)
    return results, all_passed


def main():
    words = [word for word in sys.argv[1:] if word != "--dry"]
    folder = Path(words[0]).resolve() if words else ROOT / "target" / "recipes"
    begin = time.time()
    found = list(complaints())
    if found:
        sys.exit("\n".join(found))
    texts, added = edited_texts()
    results, all_passed = ({}, True) if "--dry" in sys.argv else compiled(folder, texts)
    print(f"{'recipe':22} {'files':>5} {'lines':>5}  check")
    for title, edits, _ in RECIPES:
        files = len({path for path, _, _ in edits})
        result = {None: "not run", True: "passed", False: "FAILED"}[results.get(title)]
        print(f"{title:22} {files:5} {added[title]:5}  {result}")
    print(f"{time.time() - begin:.0f} s")
    sys.exit(not all_passed)


if __name__ == "__main__":
    main()
