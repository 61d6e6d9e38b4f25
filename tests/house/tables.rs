//! The layers of every crate, the one place to edit when a module comes, goes or moves. After a change
//! `UPDATE_ARCHITECTURE=1 cargo test -p lagrange-tests --test house` writes the tables to `ARCHITECTURE.md`.

/// Layers of one package with sources, from the ground up. None, if the crate is one file.
pub(crate) struct Library {
    pub(crate) name: &'static str,
    pub(crate) layers: &'static [Layer],
}

/// Modules that do not import each other, and what they are for.
pub(crate) struct Layer {
    pub(crate) modules: &'static [&'static str],
    pub(crate) purpose: &'static str,
}

pub(crate) const LIBRARIES: [Library; 11] = [
    Library { name: "lagrange", layers: LAGRANGE },
    Library { name: "lagrange-core", layers: CORE },
    Library { name: "lagrange-device", layers: DEVICE },
    Library { name: "lagrange-draw", layers: DRAW },
    Library { name: "lagrange-import", layers: IMPORT },
    Library { name: "lagrange-macro", layers: &[] },
    Library { name: "lagrange-math", layers: MATH },
    Library { name: "lagrange-mpi", layers: MPI },
    Library { name: "lagrange-plot", layers: PLOT },
    Library { name: "lagrange-runtime", layers: RUNTIME },
    Library { name: "xtask", layers: XTASK },
];

const LAGRANGE: &[Layer] = &[
    Layer {
        modules: &["event", "integrate"],
        purpose: "what `lagrange-runtime` has of these, with the loops without heap beside",
    },
    Layer {
        modules: &["adapt", "private", "trade"],
        purpose: "systems handed to `differential-equations` and `diffsol`; what emitted code names; methods, \
                  numbers and variants of a system measured against each other",
    },
];

const CORE: &[Layer] = &[
    Layer {
        modules: &["collections", "diagnostics", "number"],
        purpose: "containers in a fixed order; mistakes with places and help; exact rationals",
    },
    Layer {
        modules: &["elementary", "symbol", "units"],
        purpose: "one row per elementary function; names with roles; units of measurement, what they measure and their exact factors",
    },
    Layer {
        modules: &["opaque"],
        purpose: "functions without a formula: those of the user's crate, tables, algebraic unknowns",
    },
    Layer {
        modules: &["expr"],
        purpose: "the graph, typed ids, and the only constructors of sums, products and choices",
    },
    Layer { modules: &["functions"], purpose: "function values as expressions, and their derivatives" },
    Layer {
        modules: &["calculus", "formula", "solids"],
        purpose: "derivatives, expansion, substitution and evaluation; text, LaTeX and Graphviz; one row per \
                  solid: dimensions, moment of inertia, centre of mass, outline",
    },
    Layer {
        modules: &["simplify", "syntax"],
        purpose: "named rules, `collect` and `quotient` for equations, `present` for readers, `proves_zero`; \
                  tokens to syntax tree, and back to text",
    },
    Layer { modules: &["expand"], purpose: "arrays, loops and sums, written out" },
    Layer {
        modules: &["inline", "tables"],
        purpose: "functions that a declaration defines, put in the place of their calls; files of tables, read by who can",
    },
    Layer {
        modules: &["bodies", "dimensions", "program"],
        purpose: "rigid bodies, springs and joints, in the plane and in space, to plain statements, syntax to syntax; numbers in \
                  coherent units, and what has which dimension; straight-line programs: lowering, passes, verifier, interpreter, operation counts",
    },
    Layer {
        modules: &["code", "model"],
        purpose: "programs as source text of a target; what is known of a system, in expressions",
    },
    Layer {
        modules: &["derive", "elaborate"],
        purpose: "model to equations: quadratic form, elimination, structure; declaration to model, reduced \
                  models",
    },
    Layer { modules: &["emit"], purpose: "types, methods and documentation for a system" },
    Layer { modules: &["pipeline"], purpose: "the whole of it" },
];

const MATH: &[Layer] = &[
    Layer {
        modules: &["fused", "platform"],
        purpose: "products and sums in one rounding, where the target can; functions of the standard library or `libm`",
    },
    Layer {
        modules: &["pair", "reduction"],
        purpose: "sums of two doubles; angles to a multiple of π/2 and a rest",
    },
    Layer {
        modules: &["angle", "arc", "exponential", "length"],
        purpose: "functions of one number, without a branch: sine and cosine; their inverses; powers of e and hyperbolic functions; lengths",
    },
    Layer { modules: &["logarithm", "tangent"], purpose: "made of parts of those: logarithm; tangent" },
    Layer { modules: &["batch"], purpose: "sine and cosine of several angles at a time" },
    Layer { modules: &["elementary"], purpose: "the other functions of several numbers at a time" },
];

const RUNTIME: &[Layer] = &[
    Layer { modules: &["scalar"], purpose: "numbers that emitted code can compute with" },
    Layer {
        modules: &["tolerance"],
        purpose: "how many roundings count as none: one table, with reasons and the tests that tell",
    },
    Layer {
        modules: &["body", "inertia", "linalg", "root", "table"],
        purpose: "how a rigid body moves; how its mass is distributed; small matrices and vectors; tables and algebraic unknowns of declarations",
    },
    Layer {
        modules: &["system"],
        purpose: "traits that emitted types implement, and the plain data in their methods",
    },
    Layer {
        modules: &["constraint", "scene"],
        purpose: "residuals of constraints, projection onto them, motion where they depend on each other; what \
                  there is to draw of a system: names and numbers only",
    },
    Layer {
        modules: &["integrate"],
        purpose: "methods, one family a file: settings (`Method`) start what changes from step to step \
                  (`Stepper`), which needs no heap",
    },
    Layer {
        modules: &["contact", "event"],
        purpose: "modes of contacts and friction: forces, impacts, what follows upon an event; zeros of \
                  functions of time and state within a step, one by one in the order of time",
    },
    Layer { modules: &["run"], purpose: "one loop over any `Stepper`: steps, events, restarts" },
    Layer {
        modules: &["simulate"],
        purpose: "the front door (`std`): a builder, what is kept in columns, CSV and Parquet",
    },
    Layer {
        modules: &["ensemble"],
        purpose: "many runs of the front door: over threads, in an order that does not show; ends, sums, files that are gone on with",
    },
];

const DEVICE: &[Layer] = &[
    Layer { modules: &["error"], purpose: "why a device computes nothing" },
    Layer {
        modules: &["backend"],
        purpose: "OpenCL and CUDA: columns of motions to a device, calls of a kernel, and back",
    },
    Layer { modules: &["number"], purpose: "`f64` and `f32`: what is different in them" },
    Layer { modules: &["ends"], purpose: "where motions ended, and which failed" },
    Layer { modules: &["ensemble"], purpose: "what is asked of motions, and the text of methods" },
    Layer { modules: &["device"], purpose: "devices, and how one is found" },
];

const MPI: &[Layer] = &[
    Layer { modules: &["error", "sum"], purpose: "failures; what all processes come down to" },
    Layer { modules: &["processes"], purpose: "the share of a process" },
    Layer { modules: &["collect"], purpose: "parts of all processes, merged in their order" },
];

const PLOT: &[Layer] = &[
    Layer {
        modules: &["axis", "lettering", "thin"],
        purpose: "what axes span and where their marks are; letters as outlines of a font that is embedded; as many points of a curve as can be \
                  told apart",
    },
    Layer {
        modules: &["axes", "pixels"],
        purpose: "axes on paper; areas, lines, images and letters in pixels, for all pictures; PNG files",
    },
    Layer { modules: &["band", "image"], purpose: "areas between curves; images within figures" },
    Layer {
        modules: &["canvas", "cells"],
        purpose: "what `plotters` draws, in pixels; values as coloured cells",
    },
    Layer { modules: &["panel"], purpose: "one pair of axes with what is over them" },
    Layer { modules: &["figure"], purpose: "panels on any backend of plotters, as SVG or PNG" },
];

const DRAW: &[Layer] = &[
    Layer {
        modules: &["error", "picture", "text"],
        purpose: "failures; marks in pixels; the notation of formulas",
    },
    Layer {
        modules: &["colour", "geometry", "load", "raster"],
        purpose: "colours; vectors of the plane; forces and moments as handed out; pixels",
    },
    Layer {
        modules: &["beside", "cut", "outline", "remainder"],
        purpose: "pictures side by side; holes; shapes of bodies; what named forces leave open",
    },
    Layer {
        modules: &["element", "snapshot", "svg"],
        purpose: "what a picture consists of in the world; a scene at one moment; SVG documents",
    },
    Layer {
        modules: &["files", "load_label", "moment", "parallel", "sketch", "stretch", "view"],
        purpose: "files; what is written beside loads; what users add and what they see; lines on each other; \
                  reach of lines and the window of a film",
    },
    Layer { modules: &["anchored", "marks"], purpose: "ends on the ground; elements as marks on paper" },
    Layer {
        modules: &["stage", "tag"],
        purpose: "scenes to elements; where the label of an element belongs",
    },
    Layer { modules: &["heading", "labels"], purpose: "titles and notes; labels that lie on nothing" },
    Layer { modules: &["layout"], purpose: "all moments of a film with the same marks in the same order" },
    Layer { modules: &["drawing"], purpose: "what is drawn of a system" },
    Layer { modules: &["film"], purpose: "animated SVG, GIF, HTML pages" },
    Layer { modules: &["space"], purpose: "pictures and films of bodies in space, from meshes that move" },
];

const IMPORT: &[Layer] = &[
    Layer {
        modules: &["decimal", "mistakes"],
        purpose: "numbers as people wrote them; mistakes with line and element",
    },
    Layer {
        modules: &["names", "robot", "rotation"],
        purpose: "identifiers; links and joints as data; quarter turns",
    },
    Layer { modules: &["declaration"], purpose: "robots as text to be read and edited" },
    Layer { modules: &["urdf"], purpose: "URDF files to robots, with all mistakes; the front door" },
];

const XTASK: &[Layer] = &[Layer {
    modules: &["performance", "size", "urdf"],
    purpose: "measures, and rewrites the tables of `docs/performance.md`; counts lines of code; imports robots",
}];
