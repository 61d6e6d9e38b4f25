//! Names in parts: the meaning of `leg[0].hip`, or of an argument that refers to it.

use super::counting::{Counting, IndexFault};
use super::scopes::{Meaning, PlacedId, ScopeId};
use crate::syntax::ast::{ArrayExpression, AstId, Expression, Expressions, Name};
use proc_macro2::Span;

/// Maximum number of members after a name, more than the nesting depth of parts.
const MAX_MEMBERS: usize = 100;

/// A name with its members, `leg[0].hip`.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// Scope of the first name.
    scope: ScopeId,
    first: Segment,
    members: Vec<Segment>,
}

/// An index and the scope of its names.
pub(super) type ScopedIndex = (AstId, ScopeId);

/// A name with its indices.
#[derive(Clone, Debug)]
pub(super) struct Segment {
    pub(super) text: String,
    pub(super) span: Span,
    pub(super) indices: Vec<ScopedIndex>,
}

/// The meaning of a path.
#[derive(Debug)]
pub(super) enum Target {
    /// A variable of a loop.
    Value(i64),
    /// A parameter of a function.
    Hidden,
    /// An argument with an expression as its value.
    Expression(AstId, ScopeId),
    /// An entry of a parameter of a function.
    HiddenEntry(Segment),
    /// An entry of the value of an argument.
    Entry(AstId, ScopeId, Vec<ScopedIndex>),
    /// Something declared: its name in the expanded declaration, without its indices.
    Declared(Segment),
    /// A part, which is not a value.
    Part(PlacedId),
    /// A member of something other than a part, such as a component of a vector.
    Beyond,
}

/// Reason why a path is undefined.
#[derive(Debug)]
pub(super) enum PathFault {
    /// A name that is unknown in the part.
    Outside(Segment),
    /// A name that is not declared in a placed part.
    NoMember(PlacedId, Segment),
    /// A placed part without these indices.
    NoElement(Option<PlacedId>, Segment, Vec<i64>),
    /// A part without a placement at this place.
    Unplaced(Segment),
    /// An invalid index, in this scope.
    Index(IndexFault, ScopeId),
}

impl Segment {
    pub(super) fn of(name: &Name, scope: ScopeId) -> Segment {
        let indices = name.indices.iter().map(|index| (*index, scope)).collect();
        Segment { text: name.text.clone(), span: name.span, indices }
    }
}

impl Path {
    /// Returns the path of a name outside of expressions.
    pub(super) fn of_name(name: &Name, scope: ScopeId) -> Path {
        let members = name.members.iter().map(|member| Segment::of(member, scope)).collect();
        Path { scope, first: Segment::of(name, scope), members }
    }

    /// Returns the path of an expression, if it is one.
    pub(super) fn of(expressions: &Expressions, id: AstId, scope: ScopeId) -> Option<Path> {
        let mut members = Vec::new();
        let mut id = id;
        while members.len() <= MAX_MEMBERS {
            let first = match expressions.get(id) {
                Expression::Component(of, name) => {
                    members.push(Segment::of(name, scope));
                    id = *of;
                    continue;
                }
                Expression::Name(text) => Name::new(text.as_str(), expressions.origin(id).start),
                Expression::Array(ArrayExpression::Element(name)) => name.clone(),
                _ => return None,
            };
            members.reverse();
            return Some(Path { scope, first: Segment::of(&first, scope), members });
        }
        None
    }

    fn is_bare(&self) -> bool {
        self.first.indices.is_empty() && self.members.is_empty()
    }

    /// Returns this path, extended by the indices and members of the argument that refers to it.
    fn followed_by(mut self, argument: Segment, members: Vec<Segment>) -> Path {
        self.members.last_mut().unwrap_or(&mut self.first).indices.extend(argument.indices);
        self.members.extend(members);
        self
    }

    /// Returns the meaning of the path.
    pub(super) fn target(self, counting: Counting<'_>) -> Result<Target, PathFault> {
        let mut path = self;
        loop {
            let (value, scope, argument, members) =
                match counting.scopes.meaning(path.scope, &path.first.text) {
                    Meaning::Value(value) if path.is_bare() => return Ok(Target::Value(value)),
                    Meaning::Hidden if path.is_bare() => return Ok(Target::Hidden),
                    Meaning::Argument(value, scope) if path.is_bare() => {
                        return Ok(Target::Expression(value, scope));
                    }
                    Meaning::Hidden if path.members.is_empty() => {
                        return Ok(Target::HiddenEntry(path.first));
                    }
                    Meaning::Argument(value, scope) => (value, scope, path.first, path.members),
                    Meaning::Declared(text) if path.members.is_empty() => {
                        return Ok(Target::Declared(Segment { text, ..path.first }));
                    }
                    Meaning::Outside => return Err(PathFault::Outside(path.first)),
                    Meaning::Placed => match path.walk(counting)? {
                        Walk::Ended(target) => return Ok(target),
                        Walk::Argument(value, scope, argument, members) => (value, scope, argument, members),
                    },
                    Meaning::Value(_) | Meaning::Hidden | Meaning::Declared(_) => return Ok(Target::Beyond),
                };
            // The argument refers to an outer path, which continues with the same members.
            match Path::of(counting.expressions, value, scope) {
                Some(outside) => path = outside.followed_by(argument, members),
                None if members.is_empty() && !argument.indices.is_empty() => {
                    return Ok(Target::Entry(value, scope, argument.indices));
                }
                None => return Ok(Target::Beyond),
            }
        }
    }

    /// Follows placed parts up to the first member that is not a part.
    fn walk(self, counting: Counting<'_>) -> Result<Walk, PathFault> {
        let mut part = counting.scopes.part_of(self.scope);
        let mut segments = [self.first].into_iter().chain(self.members);
        let mut is_first = true;
        while let Some(segment) = segments.next() {
            match counting.scopes.member(part, &segment.text) {
                Meaning::Placed => part = Some(placed(part, segment, counting)?),
                Meaning::Argument(value, scope) => {
                    let members = segments.collect::<Vec<_>>();
                    return Ok(match segment.indices.is_empty() && members.is_empty() {
                        true => Walk::Ended(Target::Expression(value, scope)),
                        false => Walk::Argument(value, scope, segment, members),
                    });
                }
                Meaning::Declared(text) if is_built_in_of(&text, &segment) => {
                    return Err(no_member(part, segment));
                }
                Meaning::Declared(text) => {
                    let is_last = segments.next().is_none();
                    let declared = Target::Declared(Segment { text, ..segment });
                    return Ok(Walk::Ended(if is_last { declared } else { Target::Beyond }));
                }
                Meaning::Value(_) | Meaning::Hidden | Meaning::Outside if is_first => {
                    return Err(PathFault::Outside(segment));
                }
                Meaning::Value(_) | Meaning::Hidden | Meaning::Outside => {
                    return Err(no_member(part, segment));
                }
            }
            is_first = false;
        }
        Ok(Walk::Ended(part.map_or(Target::Beyond, Target::Part)))
    }
}

/// The result of following members.
enum Walk {
    Ended(Target),
    /// An argument, with its indices and members.
    Argument(AstId, ScopeId, Segment, Vec<Segment>),
}

/// True for a name that is known everywhere, and therefore not a member.
fn is_built_in_of(text: &str, segment: &Segment) -> bool {
    text == segment.text
}

fn no_member(part: Option<PlacedId>, segment: Segment) -> PathFault {
    match part {
        Some(part) => PathFault::NoMember(part, segment),
        None => PathFault::Outside(segment),
    }
}

/// Returns the part that is placed under a name with indices.
fn placed(outer: Option<PlacedId>, segment: Segment, counting: Counting<'_>) -> Result<PlacedId, PathFault> {
    let index = |(index, scope): &(AstId, ScopeId)| {
        counting.integer(*index, *scope).map_err(|fault| PathFault::Index(fault, *scope))
    };
    let indices = segment.indices.iter().map(index).collect::<Result<Vec<_>, _>>()?;
    match counting.scopes.elements(outer, &segment.text) {
        None => Err(PathFault::Unplaced(segment)),
        Some(elements) => match elements.get(&indices) {
            Some(part) => Ok(*part),
            None => Err(PathFault::NoElement(outer, segment, indices)),
        },
    }
}
