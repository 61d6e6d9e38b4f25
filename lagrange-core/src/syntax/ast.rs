//! The syntax tree of a declaration, as written: names unresolved, nothing simplified.
//!
//! Expressions live in an arena and refer to each other by [`AstId`], so that trees of any depth are
//! built, walked and dropped without recursion. Children have smaller ids than their parents.

mod bodies;
mod events;
mod expressions;

use proc_macro2::{Span, TokenStream};

use crate::collections::HashMap;
use crate::diagnostics::Origin;
pub use bodies::{Body, Connector, ConnectorKind, Joint, JointKind, Line, Part, SceneStatement, Shape};
pub use events::{Action, Assignment, Direction, Event, Friction};
pub use expressions::{AstId, BinaryOperator, Condition, Expression, Expressions};

/// A whole `system!` declaration.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Attributes to keep on the struct (docs, derives), without those of the language.
    pub attributes: TokenStream,
    /// Traits named in `#[derive(…)]` attributes.
    pub derives: Vec<Name>,
    /// Visibility of the struct, possibly empty.
    pub visibility: TokenStream,
    /// Where the word `struct` stands, before which the compiler proposes to write attributes.
    pub keyword: Span,
    /// Name of the struct.
    pub name: Name,
    /// The number type of the emitted code.
    pub scalar: ScalarType,
    /// The level of accuracy of the emitted code.
    pub accuracy: Accuracy,
    /// Statements in source order, without those that could not be read.
    pub statements: Vec<Statement>,
    /// Rigid bodies in source order; known also where plain statements have taken the place of theirs.
    pub bodies: Vec<DeclaredBody>,
    /// The expressions that statements refer to.
    pub expressions: Expressions,
    /// Words in places that could not be read: names that may have been declared there.
    pub unreadable_words: HashMap<String, ()>,
    /// Whether something was declared without a name, so that any unknown name may be meant for it.
    pub lacks_names: bool,
}

impl Declaration {
    /// Where a name that expressions may mention is declared, if it is, behind the number of that statement.
    pub fn find(&self, name: &str) -> Option<(usize, Span)> {
        let numbered = self.statements.iter().enumerate();
        let mut declared = numbered.flat_map(|(number, statement)| {
            statement.kind.declared_names().into_iter().map(move |declared| (number, declared))
        });
        declared.find(|(_, declared)| declared.text == name).map(|(number, declared)| (number, declared.span))
    }

    /// Traits in `#[derive(…)]` that types with fields of `f32` or `f64` cannot have.
    pub fn underivable(&self) -> Vec<&Name> {
        let is_field =
            |kind: &StatementKind| matches!(kind, StatementKind::Parameters(_) | StatementKind::Inputs(_));
        let has_fields = self.statements.iter().any(|statement| is_field(&statement.kind));
        let is_number = !matches!(self.scalar, ScalarType::Generic(_));
        let is_exact = |name: &&Name| ["Eq", "Ord", "Hash"].contains(&name.text.as_str());
        self.derives.iter().filter(is_exact).filter(|_| has_fields && is_number).collect()
    }

    /// The coordinates in their order.
    pub fn coordinates(&self) -> Vec<&Name> {
        let coordinates = self.statements.iter().filter_map(|statement| match &statement.kind {
            StatementKind::Coordinates(names) => Some(names),
            _ => None,
        });
        coordinates.flatten().collect()
    }

    /// The reduced types in their order, each with its documentation.
    pub fn reductions(&self) -> impl Iterator<Item = (&Reduction, &TokenStream)> {
        self.statements.iter().filter_map(|statement| match &statement.kind {
            StatementKind::Reduce(reduction) => Some((reduction, &statement.docs)),
            _ => None,
        })
    }

    /// The declaration of a reduced type: another name and documentation, frozen coordinates left out. What its
    /// statements say is still said of the whole system.
    pub fn reduced(&self, reduction: &Reduction, attributes: TokenStream) -> Declaration {
        let is_frozen = |name: &Name| {
            let frozen = reduction.items.iter().filter(|item| item.kind == ReductionKind::Frozen);
            frozen.into_iter().any(|item| item.coordinate.text == name.text)
        };
        let mut declaration = Declaration { attributes, name: reduction.name.clone(), ..self.clone() };
        declaration.statements.retain(|statement| !matches!(statement.kind, StatementKind::Reduce(_)));
        for statement in &mut declaration.statements {
            if let StatementKind::Coordinates(names) = &mut statement.kind {
                names.retain(|name| !is_frozen(name));
            }
        }
        declaration
    }
}

impl StatementKind {
    /// The names that expressions behind the statement may mention.
    pub fn declared_names(&self) -> Vec<&Name> {
        match self {
            StatementKind::Parameters(list)
            | StatementKind::Inputs(list)
            | StatementKind::Constants(list) => list.iter().map(|definition| &definition.name).collect(),
            StatementKind::Coordinates(names) | StatementKind::LetTuple(names, _) => names.iter().collect(),
            StatementKind::Let(name, _) | StatementKind::Constraint(name, _) => vec![name],
            StatementKind::Event(event) => vec![&event.name],
            StatementKind::Friction(friction) => vec![&friction.name],
            StatementKind::Scene(statement) => statement.declared_name().into_iter().collect(),
            _ => Vec::new(),
        }
    }
}

/// A rigid body by its name.
#[derive(Clone, Debug)]
pub struct DeclaredBody {
    /// Its name.
    pub name: Name,
    /// Its documentation, as attributes.
    pub docs: TokenStream,
}

/// A name and where it stands.
#[derive(Clone, Debug)]
pub struct Name {
    /// The identifier, without a raw prefix.
    pub text: String,
    /// Where it stands.
    pub span: Span,
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

/// `#[accuracy(…)]`: how rounding errors of the emitted code are weighed against its speed.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Accuracy {
    /// Sines and cosines within an ulp, several at a time.
    Fast,
    /// Elementary functions of the platform.
    #[default]
    Standard,
    /// Differences of nearly equal terms are avoided where that is possible.
    Strict,
}

impl Accuracy {
    /// Every level.
    pub const ALL: [Accuracy; 3] = [Accuracy::Fast, Accuracy::Standard, Accuracy::Strict];

    /// Its name in the attribute.
    pub fn name(self) -> &'static str {
        match self {
            Accuracy::Fast => "fast",
            Accuracy::Standard => "standard",
            Accuracy::Strict => "strict",
        }
    }
}

/// A statement and the stretch of source it covers.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What it says.
    pub kind: StatementKind,
    /// From the keyword to the semicolon.
    pub origin: Origin,
    /// Documentation of the declared names, as attributes.
    pub docs: TokenStream,
}

impl StatementKind {
    /// Whether it declares something that is emitted and can be documented.
    pub fn is_documented(&self) -> bool {
        use StatementKind::{
            Constraint, Coordinates, Event, Friction, Inputs, Output, Parameters, Reduce, Scene,
        };
        matches!(self, Parameters(_) | Inputs(_) | Coordinates(_) | Constraint(..) | Event(_))
            || matches!(self, Friction(_) | Output(..) | Reduce(_) | Scene(SceneStatement::Body(_)))
    }
}

/// What a statement says.
#[derive(Clone, Debug)]
pub enum StatementKind {
    /// `param a, b = 1.0;`
    Parameters(Vec<Definition>),
    /// `input u;`
    Inputs(Vec<Definition>),
    /// `const k = 1/2;`
    Constants(Vec<Definition>),
    /// `coord x, theta;`
    Coordinates(Vec<Name>),
    /// `let n = e;`
    Let(Name, AstId),
    /// `let (a, b) = e;`
    LetTuple(Vec<Name>, AstId),
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
        /// A vector of two or three components.
        force: AstId,
        /// The point it acts on, a vector of as many components.
        point: AstId,
    },
    /// `torque m on angle;`
    Torque {
        /// The moment.
        moment: AstId,
        /// The angle it turns.
        angle: AstId,
    },
    /// `constraint name = e;`
    Constraint(Name, AstId),
    /// `stabilise = e;`
    Stabilise(AstId),
    /// `event name = e, falling => stop;`
    Event(Event),
    /// `friction name = e, e;`
    Friction(Friction),
    /// `output name = e;`
    Output(Name, AstId),
    /// `emit { a, no b }`
    Emit(Vec<EmitItem>),
    /// `reduce Name { freeze x = e; small theta; }`
    Reduce(Reduction),
    /// Of plane rigid bodies.
    Scene(SceneStatement),
}

/// A second type with fewer or simpler motions.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// Its name.
    pub name: Name,
    /// What is done to which coordinates.
    pub items: Vec<ReductionItem>,
}

/// What is done to one coordinate of a reduced type.
#[derive(Clone, Debug)]
pub struct ReductionItem {
    /// The coordinate.
    pub coordinate: Name,
    /// What is done to it.
    pub kind: ReductionKind,
    /// The value behind `=`, if there is one; 0 is meant if there is none.
    pub value: Option<AstId>,
}

/// What can be done to a coordinate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ReductionKind {
    /// `freeze x = e;`: held at a value.
    Frozen,
    /// `small theta = e;`: stays near a value.
    Small,
}

/// One `name = value` of a `param`, `input` or `const` statement.
#[derive(Clone, Debug)]
pub struct Definition {
    /// The declared name.
    pub name: Name,
    /// The value behind `=`, if there is one.
    pub value: Option<AstId>,
}

/// One entry of `emit { … }`: a product to add, or with `no` in front one to leave out.
#[derive(Clone, Debug)]
pub struct EmitItem {
    /// The product.
    pub product: Name,
    /// Whether it is wanted.
    pub wanted: bool,
}
