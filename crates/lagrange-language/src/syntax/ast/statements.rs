//! Statements, one variant each, and their properties.
//!
//! Every traversal of statements obtains their names and expressions here, and therefore covers a
//! new variant as soon as it is listed.

mod enclosures;
mod events;
mod lines;
mod loops;
mod names;
mod parts;
mod reductions;

use proc_macro2::TokenStream;

use super::bodies::SceneStatement;
use super::callables::{
    ExternalFunction, FunctionDefinition, TableDefinition, TableSource, UnknownDefinition,
};
use super::definitions::{Definition, EmitItem, Mode, StateKind};
use super::keywords::{Keyword, Soft};
use super::quaternion::Quaternion;
use super::{AstId, Name, Reach};
pub use enclosures::{Enclosed, Enclosure};
pub use events::{Action, Assignment, Clock, Direction, Event, Friction};
use lagrange_expr::diagnostics::Origin;
pub use loops::{Block, Nested, Repetition, Selection, nested};
pub use parts::{PartArgument, PartDefinition, Placement};
pub use reductions::{Reduction, ReductionItem, ReductionKind, momentum_of};

/// A statement with its range in the source.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Kind and content.
    pub kind: StatementKind,
    /// Range from the keyword to the semicolon.
    pub origin: Origin,
    /// Documentation of the declared names, as attributes.
    pub docs: TokenStream,
}

/// The kind and content of a statement.
///
/// ```text
/// statement = attribute* "param" named [ allowed ] [ "=" sum ] { "," named [ allowed ] [ "=" sum ] } ";"
///           | "input" named [ "=" sum ] { "," named [ "=" sum ] } ";"
///           | "noise" named "," "density" ":" sum ";"
///           | "const" named "=" sum { "," named "=" sum } ";"
///           | ( "coord" | "state" | "discrete" ) named [ "=" sum ] { "," named [ "=" sum ] } ";"
///           | "mode" NAME "=" NAME "|" NAME { "|" NAME } ";"
///           | "start" sum "=" sum { "," sum "=" sum } ";"
///           | "dot" "(" NAME ")" "=" sum ";"
///           | "quaternion" NAME ";"
///           | "velocity" named "=" sum ";"
///           | "let" ( named | "(" named "," named [ "," named ] ")" ) "=" sum ";"
///           | "let" NAME "(" NAME { "," NAME } ")" "=" sum ";"
///           | "function" NAME "(" named { "," named } ")" [ ":" unit ] ( ";" | "{" { derivative } "}" [ ";" ] )
///           | "table" NAME "(" named [ "," named ] ")" [ ":" unit ] "=" ( STRING | "[" point { "," point } "]" ) { "," option } ";"
///           | "solve" ( named | "(" named "," named { "," named } ")" ) ":" "0" "=" sum { "," "0" "=" sum } { "," ( "start" | "iterations" ) ":" sum } ";"
///           | ( "kinetic" | "potential" | "lagrangian" | "dissipation" ) "=" sum ";"
///           | "gibbs" "=" sum "," "for" ":" sum ";"
///           | "force" NAME "=" sum ";"
///           | "force" sum ( "at" | "along" ) sum ";"
///           | "torque" sum "on" sum ";"
///           | "constraint" NAME "=" sum ";"
///           | "output" named "=" sum ";"
///           | "stabilise" "=" sum ";"
///           | "event" NAME "=" sum "," ( "rising" | "falling" | "crossing" ) "=>" action
///           | "every" sum "=>" assignments [ ";" ]
///           | "friction" NAME "=" sum "," limits ";"
///           | "emit" "{" { [ "no" ] NAME "," } "}" [ ";" ]
///           | "reduce" NAME "{" { lines<reduction> } "}" [ ";" ]
///           | loop | choice | part | placement | include | scene
/// named     = NAME [ ":" unit ]
/// allowed   = "in" [ sum ] ".." [ [ "=" ] sum ] | ( ">" | ">=" | "<" | "<=" ) sum
/// derivative = ( "derivative" | "second_derivative" | "third_derivative" | "by" NAME { "," NAME } ) ":" NAME ";"
/// point     = "(" sum "," sum [ "," sum ] ")"
/// option    = "interpolation" ":" ( "linear" | "monotone" | "natural" ) | "outside" ":" ( "error" | "clamp" | "extend" )
/// reduction = "freeze" NAME "=" sum { "," NAME "=" sum } ";"
///           | "small" NAME [ "=" sum ] { "," NAME [ "=" sum ] } ";"
/// action    = ( "stop" | "record" | "impact" "(" sum ")" ) ";"
///           | assignments [ ";" ]
/// assignments = "{" { lines<assignment> } "}"
/// assignment = sum "=" sum ";"
/// lines<L>  = L | "for" NAME "in" range "{" { lines<L> } "}" | "if" condition "{" { lines<L> } "}" [ "else" … ]
/// limits    = sum [ "," "smooth" ":" sum ] | "kinetic" ":" sum "," "static" ":" sum
/// ```
///
/// `NAME { "[" sum "]" }` is possible wherever a statement has `NAME`, except for names of
/// functions of the crate, parameters and types. After the name of an array, a value may be a
/// `list`.
///
/// ```text
/// loop      = "for" NAME "in" range "{" { statement } "}" [ ";" ]
/// choice    = "if" condition "{" { statement } "}" [ "else" ( "{" { statement } "}" [ ";" ] | choice ) ]
/// range     = sum ".." [ "=" ] sum
/// condition = tests { "||" tests }
/// tests     = test { "&&" test }
/// test      = { "!" } ( "(" condition ")" | sum ( "<" | "<=" | ">" | ">=" | "==" | "!=" ) sum )
/// part      = "part" NAME [ "(" argument { "," argument } ")" ] "{" { statement } "}" [ ";" ]
/// argument  = NAME [ "=" sum ]
/// placement = NAME { "[" sum "]" } [ "[" NAME "in" range "]" ] ":" NAME "{" { NAME ":" ( sum | list ) ";" } "}" [ ";" ]
/// include   = "include" STRING ";"
/// list      = "[" ( sum | list ) { "," ( sum | list ) } [ "," ] "]"
/// ```
///
/// The documentation of [`syntax`](crate::syntax) defines `sum`, that of [`SceneStatement`] defines
/// `scene`.
#[derive(Clone, Debug)]
pub enum StatementKind {
    /// `param a, b > 0 = 1.0;`
    Parameters(Vec<Definition>),
    /// `input u;`
    Inputs(Vec<Definition>),
    /// `noise w, density: e;`: one noise, with its density as its value
    Noises(Vec<Definition>),
    /// `const k = 1/2;`
    Constants(Vec<Definition>),
    /// `coord x, theta = 0.1;`, with initial values
    Coordinates(Vec<Definition>),
    /// `state current = 2;` or `discrete count = 0;`, with initial values
    States(StateKind, Vec<Definition>),
    /// `mode clutch = open | closed;`
    Mode(Mode),
    /// `start dot(theta) = 2, x = 1;`: initial values of entries of the state
    Start(Vec<Assignment>),
    /// `dot(current) = e;`
    StateRate(Name, AstId),
    /// `l * dot(current) = e;`, as the difference of both sides
    RateEquation(AstId),
    /// `quaternion hip;`
    Quaternion(Box<Quaternion>),
    /// `velocity u = dot(x);`
    Velocity(Name, AstId),
    /// `let n = e;`
    Let(Name, AstId),
    /// `let (a, b) = e;`
    LetTuple(Vec<Name>, AstId),
    /// `let n = delay(e, tau);`, and a name for every other call of `delay`
    Delay {
        /// Name of the delayed value.
        name: Name,
        /// Delayed signal.
        signal: AstId,
        /// Time by which it is delayed.
        lag: AstId,
    },
    /// `let f(x, y) = e;`
    Function(Box<FunctionDefinition>),
    /// `function f(x, y);`
    External(Box<ExternalFunction>),
    /// `table f(x) = [(a, b), (c, d)], interpolation: natural, outside: extend;`
    Table(Box<TableDefinition>),
    /// `solve y: 0 = e, start: e, iterations: n;`
    Solve(UnknownDefinition),
    /// `kinetic = e;`
    Kinetic(AstId),
    /// `potential = e;`
    Potential(AstId),
    /// `lagrangian = e;`
    Lagrangian(AstId),
    /// `gibbs = e, for: e;`
    Gibbs {
        /// The Gibbs function, at most quadratic in the accelerations.
        function: AstId,
        /// Part of the Lagrangian whose equations of motion it states.
        stated: AstId,
    },
    /// `dissipation = e;`
    Dissipation(AstId),
    /// `force x = e;`
    ForceOn(Name, AstId),
    /// `force f at p;`
    ForceAt {
        /// A vector with the same number of components as the point.
        force: AstId,
        /// Point of application.
        point: AstId,
    },
    /// `force f along u;`
    ForceAlong {
        /// A scalar or a vector.
        force: AstId,
        /// Velocities along which it does work, one for each component.
        velocity: AstId,
    },
    /// `torque m on angle;`
    Torque {
        /// The moment.
        moment: AstId,
        /// The angle on which it acts.
        angle: AstId,
    },
    /// `constraint name = e;`
    Constraint(Name, AstId),
    /// `stabilise = e;`
    Stabilise(AstId),
    /// `event name = e, falling => stop;`
    Event(Event),
    /// `every 0.01 => { a = e; }`
    Every(Clock),
    /// `friction name = e, e;`
    Friction(Friction),
    /// `output name = e;`
    Output(Name, AstId),
    /// `emit { a, no b }`
    Emit(Vec<EmitItem>),
    /// `reduce Name { freeze x = e; small theta; }`
    Reduce(Reduction),
    /// `for i in 0..n { … }`, `if i > 0 { … } else { … }`, `part Leg { … }` or `leg: Leg { … }`
    Block(Block),
    /// A statement about rigid bodies.
    Scene(SceneStatement),
}

/// Words that begin statements, except those of [`SceneStatement`].
pub const KEYWORDS: [Keyword; 33] = [
    Keyword::new("param", "write `param m = 1.0, l;`"),
    Keyword::new("const", "write `const k = 1/2;`"),
    Keyword::new("coord", "write `coord x, theta;`, or `coord x = 1;` with an initial value"),
    Keyword::new("state", "write `state a, b;`, and `dot(a) = e;` for the rate of each").before(Soft::List),
    Keyword::new("discrete", "write `discrete count = 0;`, and `{ count = count + 1; }` in an event").before(Soft::List),
    Keyword::new("mode", "write `mode clutch = open | closed;`, and `{ clutch = closed; }` in an event")
        .before(Soft::Definition),
    Keyword::new("start", "write `start x = 1, dot(x) = 2;` for initial values of coordinates and velocities")
        .before(Soft::Assignment),
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
        "write `table f(x) = [(0, 1), (2, 5)], interpolation: natural, outside: error;`, or `\"points.csv\"` for the list",
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

impl StatementKind {
    /// Returns the names that a statement declares, and their scope.
    fn names(&self) -> (Vec<&Name>, Reach) {
        match self {
            StatementKind::Parameters(list) | StatementKind::Inputs(list) => (defined(list), Reach::Both),
            StatementKind::Constants(list) | StatementKind::Noises(list) => {
                (defined(list), Reach::Expressions)
            }
            StatementKind::Coordinates(list) | StatementKind::States(_, list) => (defined(list), Reach::Both),
            StatementKind::Mode(mode) => (mode.names(), Reach::Both),
            StatementKind::Quaternion(quaternion) => (quaternion.names(), Reach::Both),
            StatementKind::Velocity(name, _) | StatementKind::Delay { name, .. } => (vec![name], Reach::Both),
            StatementKind::Let(name, _) => (vec![name], Reach::Expressions),
            StatementKind::Solve(unknowns) => (unknowns.names.iter().collect(), Reach::Expressions),
            StatementKind::LetTuple(names, _) => (names.iter().collect(), Reach::Expressions),
            // Its name can be called, but has no value.
            StatementKind::Function(_) | StatementKind::External(_) | StatementKind::Table(_) => {
                (Vec::new(), Reach::Expressions)
            }
            StatementKind::Constraint(name, _) => (vec![name], Reach::Both),
            StatementKind::Event(event) => (vec![&event.name], Reach::Both),
            StatementKind::Friction(friction) => (vec![&friction.name], Reach::Both),
            StatementKind::Output(name, _) => (vec![name], Reach::Members),
            StatementKind::Reduce(reduction) => (vec![&reduction.name], Reach::Types),
            StatementKind::Scene(scene) => scene.names(),
            StatementKind::Kinetic(_)
            | StatementKind::Potential(_)
            | StatementKind::Lagrangian(_)
            | StatementKind::Gibbs { .. }
            | StatementKind::Dissipation(_)
            | StatementKind::StateRate(..)
            | StatementKind::RateEquation(_)
            | StatementKind::ForceOn(..)
            | StatementKind::ForceAt { .. }
            | StatementKind::ForceAlong { .. }
            | StatementKind::Torque { .. }
            | StatementKind::Stabilise(_)
            | StatementKind::Every(_)
            | StatementKind::Start(_)
            | StatementKind::Block(_)
            | StatementKind::Emit(_) => (Vec::new(), Reach::Expressions),
        }
    }

    /// Returns mutable references to all expressions in a statement.
    pub fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        match self {
            StatementKind::Parameters(list)
            | StatementKind::Inputs(list)
            | StatementKind::Noises(list)
            | StatementKind::Constants(list)
            | StatementKind::Coordinates(list)
            | StatementKind::States(_, list) => {
                list.iter_mut().flat_map(Definition::expressions_mut).collect()
            }
            StatementKind::Start(assignments) => assignments.iter_mut().flat_map(Assignment::parts).collect(),
            StatementKind::Velocity(_, value)
            | StatementKind::Let(_, value)
            | StatementKind::LetTuple(_, value)
            | StatementKind::Kinetic(value)
            | StatementKind::Potential(value)
            | StatementKind::Lagrangian(value)
            | StatementKind::Dissipation(value)
            | StatementKind::StateRate(_, value)
            | StatementKind::RateEquation(value)
            | StatementKind::ForceOn(_, value)
            | StatementKind::Constraint(_, value)
            | StatementKind::Stabilise(value)
            | StatementKind::Output(_, value) => vec![value],
            StatementKind::Function(function) => vec![&mut function.value],
            StatementKind::Table(table) => match &mut table.source {
                TableSource::Points(points) => points.iter_mut().flat_map(|(point, _)| point).collect(),
                TableSource::File { .. } => Vec::new(),
            },
            StatementKind::Solve(UnknownDefinition { residuals, starts, iterations, .. }) => {
                starts.iter_mut().chain(iterations).chain(residuals).collect()
            }
            StatementKind::Gibbs { function, stated } => vec![function, stated],
            StatementKind::Delay { signal, lag, .. } => vec![signal, lag],
            StatementKind::ForceAt { force, point } => vec![force, point],
            StatementKind::ForceAlong { force, velocity } => vec![force, velocity],
            StatementKind::Torque { moment, angle } => vec![moment, angle],
            StatementKind::Event(event) => event.expressions_mut(),
            StatementKind::Every(clock) => clock.expressions_mut(),
            StatementKind::Friction(friction) => friction.expressions_mut(),
            StatementKind::Reduce(reduction) => {
                reduction.items.iter_mut().flat_map(ReductionItem::expressions_mut).collect()
            }
            StatementKind::Block(block) => block.expressions_mut(),
            StatementKind::Scene(scene) => scene.expressions_mut(),
            StatementKind::Mode(_)
            | StatementKind::Quaternion(_)
            | StatementKind::External(_)
            | StatementKind::Emit(_) => Vec::new(),
        }
    }

    /// Returns all expressions in a statement.
    pub fn expressions(&self) -> Vec<AstId> {
        // A copy is used so that expressions are only listed in one place.
        self.clone().expressions_mut().into_iter().map(|id| *id).collect()
    }

    /// Returns the name used in calls, if it declares a function.
    pub fn declared_function(&self) -> Option<&Name> {
        match self {
            StatementKind::Function(function) => Some(&function.name),
            StatementKind::External(function) => Some(&function.name),
            StatementKind::Table(table) => Some(&table.name),
            _ => None,
        }
    }

    /// Returns names with the expressions that define them, including defaults.
    pub fn definitions(&self) -> Vec<(&Name, AstId)> {
        match self {
            StatementKind::Parameters(list)
            | StatementKind::Inputs(list)
            | StatementKind::Constants(list) => {
                list.iter().filter_map(|d| Some((&d.name, d.value?))).collect()
            }
            StatementKind::Let(name, value) => vec![(name, *value)],
            StatementKind::LetTuple(names, value) => names.iter().map(|name| (name, *value)).collect(),
            _ => Vec::new(),
        }
    }

    /// Returns the names that a statement declares, each with the expression for its value or
    /// initial value.
    pub fn declarations_mut(&mut self) -> Vec<(&Name, Option<&mut AstId>)> {
        match self {
            StatementKind::Parameters(list)
            | StatementKind::Inputs(list)
            | StatementKind::Constants(list)
            | StatementKind::Coordinates(list)
            | StatementKind::States(_, list) => {
                list.iter_mut().map(|definition| (&definition.name, definition.value.as_mut())).collect()
            }
            StatementKind::Let(name, value) | StatementKind::Output(name, value) => vec![(name, Some(value))],
            StatementKind::Solve(UnknownDefinition { names, starts, .. }) => {
                let starts = starts.iter_mut().map(Some).chain(std::iter::repeat_with(|| None));
                names.iter().zip(starts).collect()
            }
            // The density of a noise is not its value.
            kind => kind.names().0.into_iter().map(|name| (name, None)).collect(),
        }
    }

    /// True if it declares whole arrays rather than elements.
    pub fn declares_arrays(&self) -> bool {
        matches!(
            self,
            StatementKind::Parameters(_)
                | StatementKind::Inputs(_)
                | StatementKind::Noises(_)
                | StatementKind::Constants(_)
                | StatementKind::Coordinates(_)
                | StatementKind::States(..)
                | StatementKind::Mode(_)
                | StatementKind::Quaternion(_)
        )
    }

    /// True if the names that it declares have values.
    pub fn declares_values(&self) -> bool {
        match self {
            StatementKind::Velocity(..)
            | StatementKind::Let(..)
            | StatementKind::LetTuple(..)
            | StatementKind::Delay { .. }
            | StatementKind::Solve(_)
            | StatementKind::Constraint(..)
            | StatementKind::Friction(_) => true,
            StatementKind::Scene(scene) => matches!(scene, SceneStatement::Mobilizer(_)),
            _ => self.declares_arrays(),
        }
    }

    /// True if the names that it declares can be called.
    pub fn declares_callables(&self) -> bool {
        matches!(self, StatementKind::Function(_) | StatementKind::External(_) | StatementKind::Table(_))
    }

    /// True if the names that it declares in a loop, without indices, are local to an iteration.
    pub fn is_local_in_loops(&self) -> bool {
        matches!(
            self,
            StatementKind::Let(..)
                | StatementKind::LetTuple(..)
                | StatementKind::Delay { .. }
                | StatementKind::Function(_)
                | StatementKind::Table(_)
                | StatementKind::Solve(_)
                | StatementKind::Constants(_)
        )
    }

    /// Returns the names that expressions after the statement may refer to.
    pub fn declared_names(&self) -> Vec<&Name> {
        self.names_within(&[Reach::Expressions, Reach::Both])
    }

    /// Returns the names of members of the emitted type.
    pub fn member_names(&self) -> Vec<&Name> {
        self.names_within(&[Reach::Members, Reach::Both])
    }

    /// True if it declares an emitted item that can be documented.
    pub fn is_documented(&self) -> bool {
        let is_part = matches!(self, StatementKind::Block(Block::Part(_) | Block::Place(_)));
        // This includes statements with unreadable names.
        is_part || self.names().1 != Reach::Expressions
    }

    fn names_within(&self, reaches: &[Reach]) -> Vec<&Name> {
        let (names, reach) = self.names();
        if reaches.contains(&reach) { names } else { Vec::new() }
    }
}

fn defined(list: &[Definition]) -> Vec<&Name> {
    list.iter().map(|definition| &definition.name).collect()
}
