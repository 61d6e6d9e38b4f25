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
mod words;

use proc_macro2::TokenStream;

use super::bodies::SceneStatement;
use super::callables::{ExternalFunction, FunctionDefinition, TableDefinition, UnknownDefinition};
use super::definitions::{Definition, EmitItem, LimitedEntry, Mode, StateKind};
use super::quaternion::Quaternion;
use super::{AstId, Name, Reach};
pub use enclosures::{Enclosed, Enclosure};
pub use events::{Action, Assignment, Clock, Direction, Event, Friction};
use lagrange_expr::diagnostics::Origin;
pub use loops::{Block, Nested, Repetition, Selection, nested};
pub use parts::{PartArgument, PartDefinition, Placement};
pub use reductions::{Reduction, ReductionItem, ReductionKind, momentum_of};
pub use words::KEYWORDS;

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
///           | ( "coord" | "state" | "discrete" ) named limited [ "=" sum ] { "," named limited [ "=" sum ] } ";"
///           | "mode" NAME "=" NAME "|" NAME { "|" NAME } ";"
///           | ( "start" | "history" ) sum "=" sum { "," sum "=" sum } ";"
///           | "range" sum limited { "," sum limited } ";"
///           | "dot" "(" NAME ")" "=" sum ";"
///           | "quaternion" NAME ";"
///           | "velocity" named "=" sum ";"
///           | "let" ( named | "(" named "," named [ "," named ] ")" ) "=" sum ";"
///           | "let" NAME "(" NAME { "," NAME } ")" "=" sum ";"
///           | "function" NAME "(" named { "," named } ")" [ ":" unit ] ( ";" | "{" { derivative } "}" [ ";" ] )
///           | "table" NAME "(" named [ "," named ] ")" [ ":" unit ] "=" ( STRING | "[" point { "," point } "]" | "[" row { "," row } "]" ) { "," option } ";"
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
/// limited   = [ allowed ] [ "nominal" sum ]
/// derivative = ( "derivative" | "second_derivative" | "third_derivative" | "by" NAME { "," NAME } ) ":" NAME ";"
/// point     = "(" sum "," sum [ "," sum ] ")"
/// row       = "[" sum { "," sum } "]"
/// option    = ( "rows" | "columns" ) ":" row | "interpolation" ":" ( "linear" | "monotone" | "natural" ) | "outside" ":" ( "error" | "clamp" | "extend" )
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
    /// `history theta = cos(t);`: entries of the state before the start, as functions of time
    History(Vec<Assignment>),
    /// `range x in 0..=1, dot(x) nominal 10;`
    Ranges(Vec<LimitedEntry>),
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

impl StatementKind {
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
            StatementKind::Start(assignments) | StatementKind::History(assignments) => {
                assignments.iter_mut().flat_map(Assignment::parts).collect()
            }
            StatementKind::Ranges(entries) => {
                entries.iter_mut().flat_map(LimitedEntry::expressions_mut).collect()
            }
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
            StatementKind::Table(table) => {
                table.source.numbers_mut().into_iter().map(|(_, number)| number).collect()
            }
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
