//! The layers of every crate: the one place to edit when a module is added, removed or moved. After
//! a change, `UPDATE_ARCHITECTURE=1 cargo test -p lagrange-tests --test house` writes the tables to
//! `ARCHITECTURE.md`.

/// The layers of one package, lowest first; empty if the crate is one file.
pub(crate) struct Library {
    pub(crate) name: &'static str,
    pub(crate) layers: &'static [Layer],
}

/// Modules that do not import each other, and their purpose.
pub(crate) struct Layer {
    pub(crate) modules: &'static [&'static str],
    pub(crate) purpose: &'static str,
}

pub(crate) const LIBRARIES: [Library; 21] = [
    Library { name: "lagrange", layers: LAGRANGE },
    Library { name: "lagrange-algebra", layers: ALGEBRA },
    Library { name: "lagrange-c", layers: C },
    Library { name: "lagrange-cli", layers: CLI },
    Library { name: "lagrange-core", layers: CORE },
    Library { name: "lagrange-double", layers: DOUBLE },
    Library { name: "lagrange-draw", layers: DRAW },
    Library { name: "lagrange-dynamic", layers: DYNAMIC },
    Library { name: "lagrange-expr", layers: EXPR },
    Library { name: "lagrange-files", layers: &[] },
    Library { name: "lagrange-fmi", layers: FMI },
    Library { name: "lagrange-import", layers: IMPORT },
    Library { name: "lagrange-jit", layers: JIT },
    Library { name: "lagrange-language", layers: LANGUAGE },
    Library { name: "lagrange-macro", layers: &[] },
    Library { name: "lagrange-math", layers: MATH },
    Library { name: "lagrange-page", layers: PAGE },
    Library { name: "lagrange-plot", layers: PLOT },
    Library { name: "lagrange-python", layers: PYTHON },
    Library { name: "lagrange-runtime", layers: RUNTIME },
    Library { name: "xtask", layers: XTASK },
];

const LAGRANGE: &[Layer] = &[
    Layer {
        modules: &["event", "integrate"],
        purpose: "re-exports of `lagrange-runtime`, with the heap-free loops",
    },
    Layer { modules: &["private"], purpose: "the names that emitted code uses" },
];

const EXPR: &[Layer] = &[
    Layer {
        modules: &["accuracy", "keywords", "limits"],
        purpose: "levels of accuracy; keywords of Rust; limits on numbers and sizes in a declaration",
    },
    Layer {
        modules: &["collections", "diagnostics", "number"],
        purpose: "containers with a fixed order; diagnostics with spans and help; exact rationals",
    },
    Layer {
        modules: &["elementary", "symbol", "units"],
        purpose: "elementary functions, one row each; names with roles; units, their dimensions and \
                  exact factors",
    },
    Layer {
        modules: &["opaque"],
        purpose: "functions without a formula: user functions, tables, algebraic unknowns",
    },
    Layer {
        modules: &["expr"],
        purpose: "the expression graph, typed ids, the only constructors of sums, products and \
                  conditionals, and evaluation",
    },
    Layer { modules: &["functions"], purpose: "function values as expressions, and their derivatives" },
    Layer {
        modules: &["solids"],
        purpose: "solids, one row each: dimensions, moment of inertia, centre of mass, outline",
    },
];

const ALGEBRA: &[Layer] = &[
    Layer {
        modules: &["calculus", "formula"],
        purpose: "derivatives, expansion and substitution; output as text and LaTeX",
    },
    Layer {
        modules: &["simplify"],
        purpose: "named rewrite rules, `collect` and `quotient` for equations, `present` for readers, \
                  `proves_zero`",
    },
    Layer {
        modules: &["program"],
        purpose: "straight-line programs: lowering, passes, verifier, interpreter, operation counts",
    },
    Layer {
        modules: &["code", "series"],
        purpose: "programs as source text of a target language; programs for Taylor series of motions",
    },
];

const LANGUAGE: &[Layer] = &[
    Layer { modules: &["syntax"], purpose: "tokens to syntax tree and back to text" },
    Layer { modules: &["expand"], purpose: "expansion of arrays, loops, sums and parts" },
    Layer {
        modules: &["inline", "tables"],
        purpose: "inlining of functions that a declaration defines; files of tables and of parts, read \
                  through a reader supplied by the caller",
    },
    Layer {
        modules: &["bodies", "dimensions"],
        purpose: "rigid bodies, springs, joints and contacts, in the plane and in space, rewritten as \
                  plain statements; conversion to coherent units, dimension checks",
    },
];

const CORE: &[Layer] = &[
    Layer {
        modules: &["editor", "files", "model"],
        purpose: "names of a declaration for editors; reading of table files; models of systems, as \
                  expressions",
    },
    Layer {
        modules: &["derive", "elaborate"],
        purpose: "model to equations: quadratic form, elimination, structure; declaration to model, \
                  reduced models",
    },
    Layer { modules: &["emit"], purpose: "the types, methods and documentation generated for a system" },
    Layer { modules: &["pipeline"], purpose: "all phases, in order" },
];

const DYNAMIC: &[Layer] = &[
    Layer {
        modules: &["reactions", "watch"],
        purpose: "forces of contacts and friction, and room for them; computations that are watched",
    },
    Layer {
        modules: &["inline", "items", "names", "refusal", "rust_file"],
        purpose: "vectors of a length known at run time; items to draw from their numbers; interned names; \
                  unsupported systems; declarations in files of Rust",
    },
    Layer { modules: &["source"], purpose: "texts with declarations" },
    Layer { modules: &["system"], purpose: "a system read at run time, with its switches" },
    Layer { modules: &["contacts"], purpose: "the forces and the trait of contacts and friction" },
    Layer { modules: &["constraints", "mechanics"], purpose: "the traits of constraints and of mechanics" },
    Layer {
        modules: &["linearised", "motion", "series"],
        purpose: "derivatives for linear models; differential equations, events and sides of switches; Taylor \
                  series",
    },
    Layer {
        modules: &["declared"],
        purpose: "systems with values for their parameters, dispatched to arrays of sufficient capacity",
    },
    Layer {
        modules: &["analysis", "film", "method"],
        purpose: "equilibria and linear models; films of motions; methods of integration by name",
    },
    Layer { modules: &["trade"], purpose: "the cost of accuracy of a motion, by method" },
    Layer {
        modules: &["ensemble", "fixed", "run"],
        purpose: "motions over threads; systems with arrays as states; settings of runs",
    },
    Layer { modules: &["fit"], purpose: "parameters from data" },
];

const PYTHON: &[Layer] = &[
    Layer {
        modules: &["columns", "error", "interrupt", "values"],
        purpose: "columns by name; exceptions; computations that Ctrl-C interrupts; values by name",
    },
    Layer {
        modules: &["derivation", "picture", "product"],
        purpose: "systems from declarations, with derivatives; plots and films for notebooks; products by name",
    },
    Layer { modules: &["motion"], purpose: "motions by column" },
    Layer {
        modules: &["ensemble", "fit", "linear", "simulation"],
        purpose: "final states of many motions; parameters from data; equilibria and linear models; runs, with Python functions as inputs",
    },
    Layer { modules: &["system"], purpose: "declared systems" },
];

const JIT: &[Layer] = &[
    Layer { modules: &["machine"], purpose: "calls of machine code, and functions that it calls" },
    Layer { modules: &["translate"], purpose: "programs as intermediate representation of Cranelift" },
];

const C: &[Layer] = &[
    Layer {
        modules: &["names", "refusal"],
        purpose: "names and numbers as C; systems that C and JavaScript do not support",
    },
    Layer { modules: &["syntax"], purpose: "syntax that differs between the two languages" },
    Layer { modules: &["functions"], purpose: "the functions of a module, with programs and shapes" },
    Layer { modules: &["callables"], purpose: "tables and solutions of equations" },
    Layer { modules: &["bodies"], purpose: "bodies of functions of the state" },
    Layer { modules: &["arrays"], purpose: "names, units and defaults as arrays" },
    Layer { modules: &["header"], purpose: "the header" },
    Layer { modules: &["script", "source"], purpose: "functions of JavaScript; the source file" },
];

const PAGE: &[Layer] = &[
    Layer {
        modules: &["error", "model"],
        purpose: "systems that pages do not support; names, units and ranges for the page",
    },
    Layer { modules: &["scene"], purpose: "the picture of a page, and the script that animates it" },
];

const FMI: &[Layer] = &[
    Layer {
        modules: &["archive", "dependencies", "quantities", "version"],
        purpose: "archives; variables that rates and outputs depend on; units of measurement as defined by the \
                  standard; the versions of the standard",
    },
    Layer { modules: &["error"], purpose: "reasons why a unit cannot be built" },
    Layer { modules: &["compile", "variables"], purpose: "compiled libraries; the variables of a unit" },
    Layer {
        modules: &["binding", "description"],
        purpose: "constants of one system for the common C code; the description in XML",
    },
    Layer { modules: &["unit"], purpose: "units: description, sources and archive" },
];

const CLI: &[Layer] = &[
    Layer {
        modules: &["arguments", "console", "help"],
        purpose: "the command line, read into a command; text for the user; its description",
    },
    Layer { modules: &["meter"], purpose: "progress on a terminal" },
    Layer { modules: &["source"], purpose: "files with declarations, and the standard input" },
    Layer {
        modules: &["mistakes", "values"],
        purpose: "mistakes as the compiler shows them, and as JSON; numbers with units",
    },
    Layer { modules: &["motions"], purpose: "simulations, from settings to output files" },
    Layer {
        modules: &["analyses", "ensembles", "trades"],
        purpose: "linear models at states or equilibria, as text and as JSON; ends of many motions; the method \
                  for a wanted error",
    },
    Layer { modules: &["commands"], purpose: "the commands" },
    Layer { modules: &["watch"], purpose: "commands that run again when files change" },
];

const MATH: &[Layer] = &[
    Layer {
        modules: &["functions", "fused", "quarters"],
        purpose: "the list of elementary functions; products and sums in one rounding; angles of any size in \
                  quarter turns",
    },
    Layer { modules: &["pair"], purpose: "double-double sums" },
    Layer { modules: &["reduction"], purpose: "reduction of angles modulo π/2" },
    Layer {
        modules: &["angle", "arc", "exponential", "length"],
        purpose: "branch-free functions of one number: sine and cosine; their inverses; exponential \
                  and hyperbolic functions; `hypot`",
    },
    Layer {
        modules: &["logarithm", "precise", "tangent"],
        purpose: "the logarithm, sine and cosine to 0.54 ulp and the tangent, built from those",
    },
    Layer { modules: &["beyond"], purpose: "functions outside the domains of the formulas" },
    Layer { modules: &["batch"], purpose: "sine and cosine of several angles at once" },
    Layer { modules: &["elementary"], purpose: "all other functions of several numbers at once" },
];

const DOUBLE: &[Layer] = &[
    Layer { modules: &["exact"], purpose: "sums and products of doubles with their rounding errors" },
    Layer { modules: &["double"], purpose: "the number and its arithmetic" },
    Layer { modules: &["wide"], purpose: "numbers of 192 bits in integers" },
    Layer {
        modules: &["elementary", "reduction"],
        purpose: "series of wide numbers; reduction of angles of any size",
    },
    Layer { modules: &["functions"], purpose: "functions of the number, with zeros, infinities and NaN" },
    Layer { modules: &["number", "text"], purpose: "the traits `Number` and `Scalar`; decimal text" },
];

const RUNTIME: &[Layer] = &[
    Layer { modules: &["scalar"], purpose: "the number types that emitted code computes with" },
    Layer {
        modules: &["random", "spread", "tolerance"],
        purpose: "random numbers by key and counter; quasi-random points; rounding tolerances: one \
                  table, with reasons and the tests that depend on them",
    },
    Layer {
        modules: &["inertia", "linalg", "root", "table"],
        purpose: "mass distributions; small matrices and vectors; algebraic unknowns and tables of \
                  declarations",
    },
    Layer { modules: &["differences"], purpose: "derivatives of functions by differences of order four" },
    Layer { modules: &["body", "manifold"], purpose: "motion of a rigid body; contact points of blocks" },
    Layer {
        modules: &["system"],
        purpose: "the traits that emitted types implement, and the plain data in their methods",
    },
    Layer {
        modules: &["constraint", "scene"],
        purpose: "constraint residuals, projection onto constraints, redundant constraints; a \
                  description of what to draw: names and numbers, no graphics",
    },
    Layer {
        modules: &["kinematics"],
        purpose: "inverse kinematics: joint positions at which frames reach their goals",
    },
    Layer {
        modules: &["integrate"],
        purpose: "integration methods, one family per file: the settings (`Method`) start a heap-free \
                  integration (`Stepper`)",
    },
    Layer {
        modules: &["contact", "event"],
        purpose: "contact and friction modes, forces, impacts and the transitions that events cause; \
                  zeros of functions of time and state within a step, in the order of time",
    },
    Layer { modules: &["run"], purpose: "one loop over any `Stepper`: steps, events, restarts" },
    Layer { modules: &["laws"], purpose: "laws of mechanics, checked by finite differences (`std`)" },
    Layer {
        modules: &["simulate"],
        purpose: "the simulation builder (`std`); recorded columns, CSV and Parquet",
    },
    Layer {
        modules: &["linear"],
        purpose: "equilibria and steady motions, linear models with names, modes, controllers",
    },
    Layer {
        modules: &["fit"],
        purpose: "parameters from data: least squares with bounds, standard errors, identifiability",
    },
    Layer {
        modules: &["identification"],
        purpose: "inertial parameters from forces: base parameters, weighted least squares",
    },
    Layer { modules: &["orbits"], purpose: "periodic orbits by shooting, Lyapunov exponents" },
    Layer {
        modules: &["ensemble"],
        purpose: "many simulations on threads, with results independent of scheduling; final states, \
                  reductions, resumable files",
    },
    Layer {
        modules: &["trade"],
        purpose: "comparison of methods, number types and variants of a system by error and time",
    },
];

const PLOT: &[Layer] = &[
    Layer {
        modules: &["characters"],
        purpose: "the characters that pictures can show, and their escapes in documents",
    },
    Layer {
        modules: &["colours", "lettering", "thin"],
        purpose: "colours of pictures and pages, light and dark; glyph outlines of the embedded font; \
                  reduction of curves to distinguishable points",
    },
    Layer {
        modules: &["label", "pixels"],
        purpose: "lines of text with symbols and subscripts; areas, lines, images and letters as \
                  pixels, for all pictures; PNG files",
    },
    Layer {
        modules: &["notation", "paper"],
        purpose: "names and units as in formulas; the surface of a figure",
    },
    Layer { modules: &["axis"], purpose: "ranges and ticks of axes" },
    Layer { modules: &["axes"], purpose: "axes on paper" },
    Layer {
        modules: &["band", "image", "limit"],
        purpose: "areas between curves; images within figures; limits of quantities",
    },
    Layer {
        modules: &["canvas", "cells", "document"],
        purpose: "figures in pixels; values as coloured cells; figures as SVG documents",
    },
    Layer { modules: &["panel"], purpose: "one pair of axes and its contents" },
    Layer { modules: &["figure"], purpose: "panels side by side, as SVG or PNG" },
];

const DRAW: &[Layer] = &[
    Layer {
        modules: &["error", "look", "picture"],
        purpose: "errors; requests to a drawing; marks in pixels",
    },
    Layer {
        modules: &["colour", "geometry", "load", "raster", "timeline"],
        purpose: "colours; plane vectors; forces and moments; pixels; times and curves of a film",
    },
    Layer {
        modules: &["beside", "cut", "outline", "recorded", "remainder"],
        purpose: "pictures side by side; holes; outlines of bodies; recorded motions; the resultant of \
                  unnamed forces",
    },
    Layer {
        modules: &["element", "snapshot", "svg"],
        purpose: "elements of a picture in world coordinates; a scene at one moment; SVG documents",
    },
    Layer {
        modules: &["files", "load_label", "moment", "parallel", "plane", "sketch", "stretch", "view"],
        purpose: "files; labels of loads; user additions and their moment; offsets of coincident \
                  lines; stored bodies of the plane; extents and the window of a film",
    },
    Layer {
        modules: &["anchored", "marks"],
        purpose: "ends fixed to the ground; elements as marks on paper",
    },
    Layer {
        modules: &["stage", "tag"],
        purpose: "scenes to elements; label positions relative to their elements",
    },
    Layer {
        modules: &["heading", "labels"],
        purpose: "titles and notes; placement of labels without overlap",
    },
    Layer { modules: &["paper"], purpose: "sheets with title, note and labels, which finish pictures" },
    Layer { modules: &["layout"], purpose: "the same marks in the same order for all moments of a film" },
    Layer { modules: &["drawing"], purpose: "the drawing of a system in the plane or in space" },
    Layer {
        modules: &["film"],
        purpose: "films: pictures of the plane as layers, animated SVG, GIF, HTML pages",
    },
    Layer { modules: &["space"], purpose: "pictures and films of bodies in space, from moving meshes" },
];

const IMPORT: &[Layer] = &[
    Layer {
        modules: &["decimal", "mistakes"],
        purpose: "decimal numbers as written; mistakes with line and element",
    },
    Layer {
        modules: &["names", "robot", "rotation"],
        purpose: "identifiers; links and joints as data; quarter turns",
    },
    Layer { modules: &["mobility"], purpose: "directions in which points of links can move" },
    Layer { modules: &["declaration"], purpose: "robots as readable declarations" },
    Layer { modules: &["urdf"], purpose: "URDF files to robots, reporting every mistake; the entry point" },
];

const XTASK: &[Layer] = &[
    Layer {
        modules: &["package", "performance", "prose", "size", "step"],
        purpose: "contents of published packages; measurements, written to `docs/performance.md`; paragraphs \
                  of comments and pages; lines of code by crate; commands of cargo",
    },
    Layer {
        modules: &["interface", "name", "wrap"],
        purpose: "public items, and their changes; the name of the package on the registry; wrapping of comments \
                  and pages, long sentences",
    },
];
