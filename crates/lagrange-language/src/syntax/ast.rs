//! The syntax tree of a declaration, as written: names unresolved, nothing simplified.
//!
//! Expressions live in an arena and refer to each other by [`AstId`], so that trees of any depth
//! are built, walked and dropped without recursion. Children have smaller ids than their parents.

mod array_shapes;
mod arrays;
pub mod bodies;
mod callables;
mod conditions;
mod contacts;
mod definitions;
mod expressions;
mod id;
mod keywords;
pub mod mobilizers;
mod quaternion;
mod reduced;
pub mod statements;
mod surfaces;

use lagrange_expr::accuracy::Accuracy;
use proc_macro2::{Span, TokenStream};

pub use array_shapes::ArrayShape;
pub use arrays::{ArrayElement, DeclaredArray};
pub use bodies::{Body, Connector, ConnectorKind, Joint, JointKind, Part, SceneStatement, Shape};
pub use callables::{
    ExternalDerivative, ExternalFunction, FunctionDefinition, TableDefinition, TableFile, TableGrid,
    TableSource, UnknownDefinition,
};
pub use conditions::{CombinedCondition, Comparison, ConditionTest, TestKind};
pub use contacts::{Compliance, Contact, ContactDefaults, FrictionNames};
pub use definitions::{AllowedRange, Definition, EmitItem, Limit, LimitedEntry, Mode, StateKind};
pub use expressions::{
    ArrayExpression, BinaryOperator, CONTACT_POINT, CONTACT_POINT_LENGTH, Condition, END, Expression,
    Expressions, Fold, IN_AXES, Range,
};
pub use id::AstId;
pub use keywords::{Keyword, Soft};
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::units::Unit;
pub use mobilizers::ElementaryMotion;
pub use mobilizers::JointLine;
pub use mobilizers::Mobilizer;
pub use mobilizers::MobilizerKind;
pub use quaternion::Quaternion;
pub use statements::{
    Action, Assignment, Block, Clock, Direction, Enclosed, Enclosure, Event, Friction, Nested, PartArgument,
    PartDefinition, Placement, Reduction, ReductionItem, ReductionKind, Repetition, Selection, Statement,
    StatementKind, momentum_of, nested,
};
pub use surfaces::{Surface, SurfaceKind};

/// A whole `system!` declaration.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Attributes to keep on the struct (docs, derives), without those of the language.
    pub attributes: TokenStream,
    /// Traits named in `#[derive(…)]` attributes.
    pub derives: Vec<Name>,
    /// Visibility of the struct, possibly empty.
    pub visibility: TokenStream,
    /// Place of the word `struct`, before which the compiler proposes to insert attributes.
    pub keyword: Span,
    /// Name of the struct.
    pub name: Name,
    /// The number type of the emitted code.
    pub scalar: ScalarType,
    /// The level of accuracy of the emitted code.
    pub accuracy: Accuracy,
    /// Statements in source order, without those that could not be read.
    pub statements: Vec<Statement>,
    /// The statement by which this is a reduced type of another declaration.
    pub reduction: Option<Statement>,
    /// Rigid bodies and frames in source order; kept after plain statements have replaced theirs.
    pub bodies: Vec<DeclaredBody>,
    /// True if these move in space; kept after plain statements have replaced theirs.
    pub is_in_space: bool,
    /// Arrays whose elements have replaced them among the statements, in source order.
    pub arrays: Vec<DeclaredArray>,
    /// Parts whose statements have replaced their placements, in order.
    pub placed: Vec<PlacedInstance>,
    /// False for a bare list of statements, without a struct.
    pub has_header: bool,
    /// Files of statements that were read.
    pub included: Vec<IncludedFile>,
    /// Names of parts without a placement, although they should have one.
    pub unplaced: Vec<Name>,
    /// Names of counting variables in expanded arrays.
    pub counted: HashSet<String>,
    /// The expressions that statements refer to.
    pub expressions: Expressions,
    /// Words in unreadable text: names that may have been declared there.
    pub unreadable_words: HashSet<String>,
    /// True if something was declared without a name, which any unknown name may refer to.
    pub lacks_names: bool,
    /// True if a unit of measurement is written anywhere.
    pub has_units: bool,
    /// True if one of these units is not that of plain numbers or angles, so that dimensions are
    /// checked.
    pub has_dimensions: bool,
}

impl Declaration {
    /// Returns the index of the statement that first declares each name, and the position of the
    /// name.
    pub fn places(&self) -> HashMap<String, (usize, Span)> {
        let mut places = HashMap::default();
        for (number, statement) in self.statements.iter().enumerate() {
            for declared in statement.kind.declared_names() {
                places.get_or_insert_with(declared.text.clone(), || (number, declared.span));
            }
        }
        places
    }

    /// Returns the parameters and inputs in their order.
    pub fn fields(&self) -> impl Iterator<Item = &Name> {
        let fields = self.statements.iter().filter_map(|statement| match &statement.kind {
            StatementKind::Parameters(list) | StatementKind::Inputs(list) => Some(list),
            _ => None,
        });
        fields.flatten().map(|definition| &definition.name)
    }

    /// Returns the positions in their order: coordinates and components of quaternions, then
    /// states.
    pub fn coordinates(&self) -> Vec<&Name> {
        let positions = self.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Coordinates(list) => list.iter().map(|definition| &definition.name).collect(),
            StatementKind::Quaternion(quaternion) => quaternion.positions.iter().collect(),
            _ => Vec::new(),
        });
        positions.chain(self.states()).collect()
    }

    /// Returns the states in their order.
    pub fn states(&self) -> impl Iterator<Item = &Name> {
        self.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::States(_, list) => list.iter().map(|definition| &definition.name).collect(),
            StatementKind::Mode(mode) => vec![&mode.name],
            _ => Vec::new(),
        })
    }

    /// True if there is an equation of the state of this name, even an invalid one.
    pub fn states_rate_of(&self, state: &str) -> bool {
        self.statements.iter().any(|statement| match &statement.kind {
            StatementKind::StateRate(name, _) => name.text == state,
            StatementKind::RateEquation(difference) => self.mentions_rate_of(*difference, state),
            _ => false,
        })
    }

    /// True if an expression contains `dot` of an expression that contains a state.
    pub fn mentions_rate_of(&self, expression: AstId, state: &str) -> bool {
        let parts = |id: AstId| self.expressions.parts(id).into_iter().map(|part| self.expressions.get(part));
        let is_state = |part: &Expression| matches!(part, Expression::Name(name) if name == state);
        parts(expression).any(|part| match part {
            Expression::Call(function, of) => {
                function.text == "dot" && of.iter().any(|&of| parts(of).any(is_state))
            }
            _ => false,
        })
    }

    /// Returns the velocities in their order.
    pub fn velocities(&self) -> Vec<StateVelocity<'_>> {
        let named = self.named_velocities();
        let velocities = self.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Coordinates(list) => {
                list.iter().map(|definition| rate_of(&definition.name, &named)).collect()
            }
            StatementKind::Quaternion(quaternion) => {
                let component = |name: &Name| StateVelocity { name: name.clone(), coordinate: None };
                quaternion.velocities.iter().map(component).collect()
            }
            _ => Vec::new(),
        });
        velocities.collect()
    }

    /// Returns the names that `velocity` statements give to the rates of coordinates, by the names
    /// of these.
    pub fn named_velocities(&self) -> HashMap<String, &Name> {
        let mut named = HashMap::default();
        for Statement { kind, .. } in &self.statements {
            if let StatementKind::Velocity(name, value) = kind
                && let Some(coordinate) = self.expressions.rate_of_name(*value)
            {
                named.get_or_insert_with(coordinate.to_owned(), || name);
            }
        }
        named
    }

    /// True if a product emitted on demand is requested.
    pub fn asks_for(&self, product: &str) -> bool {
        self.demand(product).is_some()
    }

    /// Returns the name of a product where it is requested; the last request applies.
    pub fn demand(&self, product: &str) -> Option<&Name> {
        let items = self.statements.iter().filter_map(|statement| match &statement.kind {
            StatementKind::Emit(items) => Some(items),
            _ => None,
        });
        let mut asked = items.flatten().filter(|item| item.product.text == product);
        asked.next_back().filter(|item| item.wanted).map(|item| &item.product)
    }

    /// Returns the ranges of parameters that have one.
    pub fn ranges(&self) -> impl Iterator<Item = (&Name, &AllowedRange)> {
        let definitions = self.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Parameters(list) => &list[..],
            _ => &[],
        });
        let ranges = definitions.map(|definition| (&definition.name, &definition.range));
        ranges.filter(|(_, range)| range.limits().next().is_some())
    }

    /// True if it gives initial values of the state.
    pub fn has_start(&self) -> bool {
        self.statements.iter().any(|statement| match &statement.kind {
            StatementKind::Start(_) => true,
            StatementKind::Coordinates(list) | StatementKind::States(_, list) => {
                list.iter().any(|definition| definition.value.is_some())
            }
            _ => false,
        })
    }

    /// Returns the names of outputs in their order.
    pub fn outputs(&self) -> impl Iterator<Item = &Name> {
        self.statements.iter().filter_map(|statement| match &statement.kind {
            StatementKind::Output(name, _) => Some(name),
            _ => None,
        })
    }
}

/// A rigid body or a frame by its name.
#[derive(Clone, Debug)]
pub struct DeclaredBody {
    /// Name of the body or frame.
    pub name: Name,
    /// True for a frame, which has no mass.
    pub is_frame: bool,
    /// Documentation, as attributes.
    pub docs: TokenStream,
}

/// Returns the bodies and frames that statements declare.
pub fn declared_bodies(statements: &[Statement]) -> Vec<DeclaredBody> {
    let bodies = statements.iter().filter_map(|statement| {
        let (name, is_frame) = match &statement.kind {
            StatementKind::Scene(SceneStatement::Body(body)) => (&body.name, false),
            StatementKind::Scene(SceneStatement::Frame(name)) => (name, true),
            _ => return None,
        };
        Some(DeclaredBody { name: name.clone(), is_frame, docs: statement.docs.clone() })
    });
    bodies.collect()
}

/// A file of statements that was read.
#[derive(Clone, Debug)]
pub struct IncludedFile {
    /// Path as written.
    pub path: String,
    /// Path under which the compiler finds it; empty if changes are not tracked.
    pub watched: String,
    /// Name of the file in the spans of its tokens, if these have locations.
    pub span_file: Option<String>,
    /// Position in the declaration that includes it, directly or through other files.
    pub root: Origin,
}

/// A placed part.
#[derive(Clone, Debug)]
pub struct PlacedInstance {
    /// Name of the part.
    pub part: String,
    /// Declaration of the part.
    pub definition: Origin,
    /// Name as written, prefixed by the enclosing parts: `leg[0].foot`.
    pub name: String,
    /// Position of the placement.
    pub origin: Origin,
}

/// A velocity of the state.
#[derive(Clone, Debug)]
pub struct StateVelocity<'d> {
    /// Name in the state.
    pub name: Name,
    /// Coordinate whose rate it is; `None` for a component of an angular velocity.
    pub coordinate: Option<&'d Name>,
}

/// Returns the name of the rate of a velocity: `x_ddot` of `x_dot`, `w_dot` of `w`.
pub fn acceleration_name(velocity: &str) -> String {
    match velocity.strip_suffix("_dot") {
        Some(coordinate) => format!("{coordinate}_ddot"),
        None => format!("{velocity}_dot"),
    }
}

/// A name and its position.
#[derive(Clone, Debug)]
pub struct Name {
    /// The identifier, without a raw prefix.
    pub text: String,
    /// Position in the declaration.
    pub span: Span,
    /// Expressions in square brackets: the sizes of a declared array, or the index of one element.
    pub indices: Vec<AstId>,
    /// Unit of measurement after the colon in a declaration; for a function, the unit of its value.
    pub unit: Option<Box<Unit>>,
    /// Members after dots, each with its indices: `.hip[1]` of `leg[0].hip[1]`.
    pub members: Vec<Name>,
}

impl Name {
    /// Creates a name without square brackets, unit and members.
    pub fn new(text: impl Into<String>, span: Span) -> Name {
        Name { text: text.into(), span, indices: Vec::new(), unit: None, members: Vec::new() }
    }
}

/// The scope of a declared name.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reach {
    /// In expressions after the statement.
    Expressions,
    /// In emitted code, as the name of a member.
    Members,
    /// In both.
    Both,
    /// In emitted code, as the name of a type.
    Types,
}

/// The number type of the emitted code.
#[derive(Clone, Debug)]
pub enum ScalarType {
    /// `pub struct Name;`
    F64,
    /// `#[scalar(f32)]`
    F32,
    /// `pub struct Name<S>;` with the name of the type parameter.
    Generic(Name),
}

fn rate_of<'d>(coordinate: &'d Name, named: &HashMap<String, &Name>) -> StateVelocity<'d> {
    let rate = || Name::new(format!("{}_dot", coordinate.text), coordinate.span);
    let name = named.get(&coordinate.text).map_or_else(rate, |name| (*name).clone());
    StateVelocity { name, coordinate: Some(coordinate) }
}
