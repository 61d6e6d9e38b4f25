//! Words that begin statements, with the form of each.

#[cfg(doc)]
use crate::syntax::ast::bodies::SceneStatement;
use crate::syntax::ast::keywords::{Keyword, Soft};

/// Words that begin statements, except those of [`SceneStatement`].
pub const KEYWORDS: [Keyword; 35] = [
    Keyword::new("param", "write `param m = 1.0, l;`"),
    Keyword::new("const", "write `const k = 1/2;`"),
    Keyword::new("coord", "write `coord x, theta;`, or `coord x = 1;` with an initial value"),
    Keyword::new("state", "write `state a, b;`, and `dot(a) = e;` for the rate of each").before(Soft::List),
    Keyword::new("discrete", "write `discrete count = 0;`, and `{ count = count + 1; }` in an event").before(Soft::List),
    Keyword::new("mode", "write `mode clutch = open | closed;`, and `{ clutch = closed; }` in an event")
        .before(Soft::Definition),
    Keyword::new("start", "write `start x = 1, dot(x) = 2;` for initial values of coordinates and velocities")
        .before(Soft::Assignment),
    Keyword::new("history", "write `history x = cos(t);` for coordinates and states before the start, as delays see them")
        .before(Soft::Assignment),
    Keyword::new("range", "write `range x in 0..=1 nominal 0.1, dot(x) nominal 10;` for coordinates and velocities")
        .before(Soft::Joint),
    Keyword::new("quaternion", "write `quaternion hip;`").before(Soft::Alone),
    Keyword::new("velocity", "write `velocity u = dot(x);`").before(Soft::Definition),
    Keyword::new("input", "write `input u;`"),
    Keyword::new("noise", "write `noise w, density: d;`, with the spectral density d of the white noise w")
        .before(Soft::List),
    Keyword::new(
        "let",
        "write `let name = e;`, `let (a, b) = (e, f);` for the components of a vector, or `let f(x, y) = e;` for a function",
    ),
    Keyword::new(
        "function",
        "write `function f(x, y);` for a function of your crate, or `function f(x) { derivative: slope; second_derivative: curvature; }`",
    )
    .before(Soft::Function),
    Keyword::new(
        "table",
        "write `table f(x) = [(0, 1), (2, 5)], interpolation: natural, outside: error;`, or `\"points.csv\"` for the list; for `f(x, y)`, points `(x, y, z)` or `[[1, 2], [3, 4]], rows: [0, 1], columns: [0, 1]`",
    )
    .before(Soft::Function),
    Keyword::new(
        "solve",
        "write `solve y: 0 = e;`, or `solve y: 0 = e, start: s, iterations: 50;`, for the y that makes e zero; `solve (y, z): 0 = e, 0 = f;` for y and z that make both zero",
    )
    .before(Soft::Equation),
    Keyword::new("kinetic", "write `kinetic = e;`"),
    Keyword::new("potential", "write `potential = e;`"),
    Keyword::new("lagrangian", "write `lagrangian = e;`"),
    Keyword::new(
        "gibbs",
        "write `gibbs = S, for: F;`, F being the part of the Lagrangian whose equations of motion are ∂S/∂a",
    ),
    Keyword::new("dissipation", "write `dissipation = e;`, the Rayleigh function"),
    Keyword::new(
        "force",
        "write `force x = e;` for a coordinate, `force (fx, fy) at (px, py);` for a point or `force f along u;` for a velocity",
    ),
    Keyword::new("torque", "write `torque m on angle;`"),
    Keyword::new("constraint", "write `constraint name = e;`, with the quantity that is to be zero after the name"),
    Keyword::new("stabilise", "write `stabilise = rate;`"),
    Keyword::new("event", "write `event name = e, falling => stop;`"),
    Keyword::new("every", "write `every 0.01 => { held = e; }`, with the time between two ticks"),
    Keyword::new(
        "friction",
        "write `friction name = slip, limit;`, `… = slip, kinetic: a, static: b;` or `… = slip, limit, smooth: width;`",
    )
    .before(Soft::Definition),
    Keyword::new("output", "write `output name = e;`"),
    Keyword::new("emit", "write `emit { product, no product }`"),
    Keyword::new("reduce", "write `reduce Name { freeze x = 0; small theta; }`"),
    Keyword::new("for", "write `for i in 0..n { kinetic = e; }`, with any statements between the braces")
        .before(Soft::Loop),
    Keyword::new("part", "write `part Wheel(r, on) { param m; }`, and place it: `front: Wheel { r: 0.3; on: axle; }`")
        .before(Soft::Part),
    Keyword::new("include", "write `include \"parts/wheel.lag\";`, with the path from the folder of your `Cargo.toml`")
        .before(Soft::Path),
];
