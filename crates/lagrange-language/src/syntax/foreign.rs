//! Words of other languages and of textbooks, with their equivalents in this language. None of them
//! is reserved: they are only looked up for undefined words.

mod functions;
mod rates;

pub use functions::{FUNCTIONS, function, without_counterpart};
pub use rates::{Rate, derives, is_word_for_rate, rate};

/// Words that begin no statement, with the intended keyword.
const STATEMENTS: &[(&[&str], &str)] = &[
    (&["T", "K", "KE", "Ek", "Ekin", "E_k", "E_kin", "T_kin", "kinetic_energy", "ke"], "kinetic"),
    (&["V", "U", "PE", "Ep", "Epot", "E_p", "E_pot", "V_pot", "potential_energy", "pe"], "potential"),
    (&["L", "lagrange", "Lagrange"], "lagrangian"),
    (&["damping", "rayleigh", "Rayleigh", "R", "D", "losses", "drag"], "dissipation"),
    (&["double", "float", "real", "Real", "f64", "f32", "int", "number", "symbol"], "param"),
    (
        &["var", "variable", "variables", "dof", "dofs", "q", "unknown", "dynamicsymbols", "coordinate"],
        "coord",
    ),
    (&["static", "constexpr"], "const"),
    (&["gear", "gears", "coupling", "couple", "transmission", "belt"], "constraint"),
    (&["control", "controls", "actuator"], "input"),
    (&["define", "auto", "set", "alias", "val", "local"], "let"),
    (&["F", "Q", "load", "external"], "force"),
    (&["moment", "M", "tau"], "torque"),
    (&["holonomic", "nonholonomic", "condition", "st", "subject", "restriction"], "constraint"),
    (&["stabilize", "baumgarte"], "stabilise"),
    (&["when", "trigger", "zero_crossing"], "event"),
    (
        &[
            "observe",
            "observable",
            "measure",
            "print",
            "println",
            "show",
            "plot",
            "disp",
            "record",
            "return",
            "yield",
        ],
        "output",
    ),
    (&["generate", "derive", "export", "produce"], "emit"),
    (&["freeze", "small", "linearize", "linearise"], "reduce"),
    (&["weight"], "gravity"),
    (
        &["rod", "link", "bar", "wheel", "rigid", "rigid_body", "particle", "mass", "point_mass", "disk"],
        "body",
    ),
    (&["wall", "floor", "ground", "slope", "rail", "track"], "line"),
    (&["dashpot"], "damper"),
    (&["torsional_spring", "rotational_spring", "spiral_spring"], "torsion_spring"),
    (&["torsional_damper", "rotational_damper"], "torsion_damper"),
    (&["joint", "hinge", "pivot", "connect"], "pin"),
    (&["continuous"], "revolute"),
    (&["spherical", "ball_joint", "socket"], "ball"),
    (&["floating", "freejoint", "free_joint"], "free"),
    (&["orientation", "quat"], "quaternion"),
    (&["slider", "translational"], "prismatic"),
    (&["fixed"], "weld"),
    (&["rolling"], "roll"),
    (&["touch", "touches", "collide"], "contact"),
];

/// Words that begin statements without an equivalent, with the message and the help.
const STRANGERS: &[(&[&str], &str, &str)] = &[
    (
        &["fn", "def", "function", "lambda", "macro"],
        "functions are declared differently here",
        "write `let f(x, y) = …;`",
    ),
    (
        &["for", "while", "loop", "repeat", "do"],
        "loops are written differently here",
        "write `for i in 0..n { … }`, with statements between the braces, or `sum(i in 0..n, e)`",
    ),
    (
        &["if", "else", "match", "switch", "case"],
        "conditions choose between values, not between statements",
        "write `let name = if a < b { … } else { … };`",
    ),
    (
        &["use", "import", "include", "from", "using", "extern"],
        "only files of parts, or of a whole declaration, are included here",
        "write `include \"parts/leg.lag\";` for these, or `param name;` for a number from outside",
    ),
    (
        &["impact", "collision", "bounce"],
        "contacts are declared as events",
        "write `event name = gap, falling => impact(e);`",
    ),
    (
        &["solve", "dsolve", "simulate", "integrate", "odeint", "ode45", "run"],
        "a declaration describes a system, not its simulation",
        "remove this and simulate the emitted type: `Name::default().simulate(start).until(10.0).run()`",
    ),
    (
        &["initial", "init", "start", "initially", "x0", "q0"],
        "initial values are declared differently here",
        "write `coord x = 1;` or `start x = 1, dot(x) = 2;`",
    ),
    (
        &["component", "block", "part", "parts", "subsystem", "connector", "instance"],
        "components are called parts here",
        "declare one, `part Wheel(r, on) { … }`, and place it: `front: Wheel { r: 0.3; on: axle; }`",
    ),
    (
        &["equation", "equations", "ode", "eom"],
        "equations of motion are derived, not declared",
        "write the energies they follow from, `kinetic = …;` and `potential = …;`",
    ),
    (
        &["model", "class", "system", "module", "mod", "enum", "type", "trait", "impl", "end", "begin"],
        "this keyword is not used here",
        "remove it: the declaration consists of `struct Name;` and statements",
    ),
];

/// Undefined names, with their replacements.
pub const NAMES: &[(&[&str], &str)] = &[
    (&["PI", "Pi", "M_PI", "π"], "pi"),
    (&["TAU", "two_pi", "twopi"], "2 * pi"),
    (&["e", "E", "euler"], "exp(1)"),
    (&["time", "Time"], "t"),
    (&["deg", "degree", "degrees"], "pi/180"),
    (&["INFINITY", "inf", "Inf", "infinity", "oo"], "1e300"),
];

/// Names of libraries before functions and constants.
const LIBRARIES: &[&str] = &["np", "numpy", "math", "Math", "sp", "sympy", "sym", "torch", "jnp", "cmath"];

/// Labels of bodies, lines, springs and dampers, with foreign words for them. A word may correspond
/// to several labels: the possible one is intended.
const LABELS: &[(&str, &[&str])] = &[
    ("mass", &["m", "M"]),
    ("inertia", &["J", "I", "j", "moment_of_inertia", "moment"]),
    (
        "center",
        &[
            "centre",
            "position",
            "pos",
            "place",
            "location",
            "at",
            "com",
            "center_of_mass",
            "cg",
            "point",
            "r",
        ],
    ),
    ("centroid", &["offset", "local_center"]),
    ("outside", &["extrapolation", "extrapolate", "beyond", "edges", "bounds"]),
    ("interpolation", &["method", "kind", "spline"]),
    ("start", &["guess", "initial", "x0"]),
    ("iterations", &["max_iterations", "maxiter", "steps"]),
    ("angle", &["orientation", "rotation", "direction", "theta", "phi", "slope", "inclination", "heading"]),
    ("shape", &["geometry", "solid", "form", "outline"]),
    ("compound", &["parts", "composite"]),
    ("through", &["point", "origin", "position", "at", "start", "from", "pos"]),
    ("on", &["body", "of", "parent", "carried_by", "attached_to"]),
    ("from", &["start", "begin", "first", "a", "p1", "A", "p", "P", "body1"]),
    ("to", &["end", "second", "b", "p2", "B", "q", "Q", "body2"]),
    ("stiffness", &["k", "K", "spring_constant", "constant", "rate", "c"]),
    ("damping", &["c", "d", "b", "coefficient", "viscosity", "damping_constant", "constant"]),
    ("dissipation", &["damping", "hunt_crossley_dissipation", "d", "c"]),
    ("stiction", &["stiction_tolerance", "stiction_speed", "regularization", "regularisation", "vs"]),
    ("friction", &["mu", "friction_coefficient"]),
    ("restitution", &["e", "bounce", "bounciness"]),
    ("rest", &["l0", "L0", "length", "free_length", "natural_length", "unstretched", "x0", "neutral", "l"]),
    ("radius", &["r", "R"]),
    ("at", &["center", "centre", "position", "pos", "origin"]),
    ("rising", &["up", "upwards", "increasing", "positive", "plus"]),
    ("falling", &["down", "downwards", "decreasing", "negative", "minus"]),
    ("crossing", &["both", "any", "either", "zero", "all"]),
    ("stop", &["end", "terminate", "halt", "finish", "terminal"]),
    ("record", &["log", "note", "save", "count"]),
    ("impact", &["bounce", "collide", "collision", "reflect", "hit", "contact"]),
    ("freeze", &["fix", "fixed", "hold", "lock", "constant", "set"]),
    ("small", &["linear", "linearize", "linearise", "near", "about"]),
    ("kinetic", &["mu_k", "sliding", "dynamic", "slip"]),
    ("static", &["mu_s", "sticking", "stick"]),
    ("smooth", &["width", "regularised", "regularized", "epsilon"]),
];

/// Solids, with foreign words for them.
const SOLIDS: &[(&str, &[&str])] = &[
    ("disk", &["circle", "disc", "cylinder", "wheel", "puck", "round"]),
    ("slender_rod", &["bar", "stick", "beam", "link", "line", "needle", "thin_rod"]),
    ("rectangle", &["square", "box", "block", "plate", "rect", "slab"]),
    ("solid_sphere", &["sphere", "ball"]),
    ("thin_sphere", &["shell", "spherical_shell", "hollow_ball"]),
    ("thin_ring", &["ring", "hoop", "rim", "circular_ring"]),
    ("hollow_cylinder", &["tube", "pipe", "annulus"]),
    (
        "semicircular_disk",
        &["half_disk", "semicircle", "half_circle", "half_disc", "semi_disk", "half_cylinder"],
    ),
    ("circular_sector", &["sector", "pie"]),
    ("point_mass", &["point", "particle", "mass"]),
    ("regular_polygon", &["hexagon", "pentagon", "octagon", "ngon"]),
];

/// Parts of bodies, connectors and joints, with their spelling here; `#1` is replaced by the
/// object, `#2` by the word.
const PARTS: &[(Owner, &[&str], &str)] = &[
    (Owner::Body, &["position", "pos", "centre", "com", "place", "location"], "#1.center"),
    (Owner::Body, &["x", "y"], "#1.center.#2"),
    (Owner::Body, &["velocity", "vel", "v", "speed"], "velocity(#1)"),
    (Owner::Body, &["acceleration", "acc", "a"], "acceleration(#1)"),
    (Owner::Body, &["omega", "angular_velocity", "w", "spin"], "angular_velocity(#1)"),
    (Owner::Body, &["alpha", "angular_acceleration"], "angular_acceleration(#1)"),
    (Owner::Body, &["theta", "phi", "orientation", "rotation"], "#1.angle"),
    (Owner::Body, &["m"], "#1.mass"),
    (Owner::Body, &["J", "I", "moment_of_inertia"], "#1.inertia"),
    (Owner::Body, &["momentum", "p"], "linear_momentum(#1)"),
    (Owner::Body, &["start", "end", "tip", "corner"], "#1.point(X, Y)"),
    (Owner::BodyInSpace, &["position", "pos", "centre", "com", "place", "location"], "#1.center"),
    (Owner::BodyInSpace, &["x", "y", "z"], "#1.center.#2"),
    (Owner::BodyInSpace, &["m"], "#1.mass"),
    (Owner::BodyInSpace, &["momentum", "p"], "linear_momentum(#1)"),
    (Owner::Frame, &["position", "pos", "center", "centre", "place", "location"], "#1.origin"),
    (Owner::Frame, &["x", "y", "z"], "#1.origin.#2"),
    (Owner::Connector, &["tension", "load", "F"], "#1.force"),
    (Owner::Connector, &["extension", "elongation", "stretch", "l"], "#1.length"),
    (Owner::Joint, &["reaction", "constraint_force", "F"], "#1.force"),
    (Owner::Joint, &["normal_force", "pressure", "N"], "#1.normal"),
];

/// Parts of bodies in space and of frames.
const PARTS_IN_SPACE: &[(&[&str], &str)] = &[
    (&["velocity", "vel", "v", "speed"], "velocity(#1)"),
    (&["acceleration", "acc", "a"], "acceleration(#1)"),
    (&["omega", "angular_velocity", "w", "spin"], "angular_velocity(#1)"),
    (&["alpha", "angular_acceleration"], "angular_acceleration(#1)"),
    (
        &["theta", "phi", "angle", "angles", "orientation", "rotation", "direction", "axis", "normal"],
        "#1.vector(X, Y, Z)",
    ),
    (&["start", "end", "tip", "corner"], "#1.point(X, Y, Z)"),
];

/// Kind of object that has parts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Owner {
    /// A rigid body in the plane.
    Body,
    /// A rigid body in space.
    BodyInSpace,
    /// A frame in space.
    Frame,
    /// A spring or damper.
    Connector,
    /// A joint.
    Joint,
}

/// Greek letters with their names.
const LETTERS: &[(char, &str)] = &[
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('µ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('φ', "phi"),
    ('ϕ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Ω', "Omega"),
];

/// Returns the keyword that is intended by a word that begins no statement.
pub(super) fn statement(word: &str) -> Option<&'static str> {
    STATEMENTS.iter().find(|(words, _)| words.contains(&word)).map(|(_, keyword)| *keyword)
}

/// Returns the message for a word that begins a statement without an equivalent, and advice.
pub(super) fn stranger(word: &str) -> Option<(&'static str, &'static str)> {
    STRANGERS.iter().find(|(words, ..)| words.contains(&word)).map(|(_, message, help)| (*message, *help))
}

/// Returns the spelling here of an undefined name.
pub fn name(word: &str) -> Option<&'static str> {
    NAMES.iter().find(|(words, _)| words.contains(&word)).map(|(_, meant)| *meant)
}

/// True if a name is that of a library that contains functions in other languages.
pub fn is_library(word: &str) -> bool {
    LIBRARIES.contains(&word)
}

/// Returns a name with Greek letters written out, or with names of letters replaced by letters;
/// `None` if it has neither.
pub fn letter(word: &str) -> Option<String> {
    let written_out =
        LETTERS.iter().fold(word.to_owned(), |text, (letter, name)| text.replace(*letter, name));
    let is_other = written_out != word;
    let as_letter = || {
        let row = LETTERS.iter().find(|(_, name)| word.starts_with(name));
        row.map(|(letter, name)| format!("{letter}{}", &word[name.len()..]))
    };
    if is_other { Some(written_out) } else { as_letter() }
}

/// Returns the known word that was probably intended by another one.
pub fn label<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    known.into_iter().find(|label| is_row_of(LABELS, label, word))
}

/// Returns the solid that was probably intended by a word.
pub fn solid(word: &str) -> Option<&'static str> {
    SOLIDS.iter().find(|(_, words)| words.contains(&word)).map(|(solid, _)| *solid)
}

/// Returns the spelling here of a part of an object, given by its kind and name.
pub fn part((kind, object): (Owner, &str), word: &str) -> Option<String> {
    let in_space = PARTS_IN_SPACE.iter().filter(|_| matches!(kind, Owner::BodyInSpace | Owner::Frame));
    let own = PARTS.iter().filter(|(owner, ..)| *owner == kind).map(|(_, words, template)| (words, template));
    let mut rows = own.chain(in_space.map(|(words, template)| (words, template)));
    let (_, template) = rows.find(|(words, _)| words.contains(&word))?;
    Some(filled(template, &[object.to_owned(), word.to_owned()]))
}

fn is_row_of(rows: &[(&str, &[&str])], key: &str, word: &str) -> bool {
    rows.iter().any(|(row, words)| *row == key && words.contains(&word))
}

/// Fills a template with texts at `#1`, `#2`, ….
fn filled(template: &str, texts: &[String]) -> String {
    let places = texts.iter().enumerate();
    places.fold(template.to_owned(), |text, (i, filler)| text.replace(&format!("#{}", i + 1), filler))
}

#[cfg(test)]
mod tests;
