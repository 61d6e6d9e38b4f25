//! Switches: surfaces in time and state on which the equations of motion are not smooth.
//!
//! They are the surfaces where a condition of `if` changes, and the kinks of `abs`, `sign`, `min`
//! and `max`. Integration methods retain their order only if no step crosses such a surface. A run
//! fixes the side of every switch, so that the equations are smooth, and changes it where the
//! surface is reached. [`one_sided`] writes expressions with symbols for the sides. |x| has the
//! switch x with the side s and becomes s x. `if t < 1 { 0 } else { f }` has the switch t − 1 and
//! becomes `if s < 0 { 0 } else { f }`. Steps evaluate states beyond a surface before it is
//! located, so a base with a fractional power keeps its magnitude, see [`domains`].
//!
//! Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, §II.6,
//! "discontinuous equations".

mod domains;
mod one_sided;
mod poles;

pub use one_sided::one_sided;

use crate::model::{Model, ReactionKind};
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{Dependencies, ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::{Role, SymbolId};

/// A surface on which the equations of motion are not smooth.
#[derive(Clone, Debug)]
pub struct Switch {
    /// Function of t, q, v and inputs that is zero on the surface. It increases with time if it
    /// only depends on time.
    pub value: ExprId,
    /// The symbol of its side: the sign of `value`.
    pub side: ExprId,
    /// Statement that declares the switch.
    pub statement: Option<String>,
    /// Time at which the surface is crossed, if the value is t minus a term that is constant in
    /// motion.
    pub time: Option<ExprId>,
}

/// Surface of a nonsmooth expression, which switches with the sign of `value` or with the opposite
/// sign.
#[derive(Clone, Copy)]
struct Surface {
    value: ExprId,
    is_opposite: bool,
}

/// The side of a located surface on which a node is written.
#[derive(Clone, Copy)]
struct Side {
    /// Function that is zero on the surface.
    value: ExprId,
    /// Sign of `value`, a symbol.
    sign: ExprId,
    /// True if the node switches with the opposite of `value`.
    is_opposite: bool,
}

impl Side {
    /// Returns the slope of a magnitude on this side: its sign.
    fn slope(self, graph: &mut Graph) -> ExprId {
        if self.is_opposite { graph.negate(self.sign) } else { self.sign }
    }
}

impl Switch {
    /// Finds the switches of the expressions that determine a motion. Conditions on `guards` are
    /// ignored, since both branches have the same value there.
    pub(super) fn find(model: &mut Model, roots: &[ExprId], guards: &[ExprId]) -> Vec<Switch> {
        let statements = statements(model);
        let mut found: OrderedMap<ExprId, Switch> = OrderedMap::default();
        for id in model.graph.reachable(roots) {
            if let Some(Surface { value, .. }) = surface(&mut model.graph, id, guards)
                && !found.contains(&value)
            {
                let index = found.len() as u32;
                let side = model.graph.symbol(&format!("side_{index}"), Role::Side(index));
                let statement = statements.get(&value).cloned();
                let time = passed_at(&mut model.graph, value);
                found.insert(value, Switch { value, side, statement, time });
            }
        }
        found.iter().map(|(_, switch)| switch.clone()).collect()
    }
}

/// Returns the surface on which a node is not smooth, if a motion may cross it.
fn surface(graph: &mut Graph, id: ExprId, guards: &[ExprId]) -> Option<Surface> {
    let difference = match graph.node(id).clone() {
        Node::Choose { left, right, .. } if graph.is_zero(right) && guards.contains(&left) => return None,
        Node::Choose { left, right, .. } => graph.subtract(left, right),
        Node::Call(Function::Abs | Function::Sign | Function::MagnitudeSlope, arguments) => arguments[0],
        Node::Call(Function::Min | Function::Max, arguments) => graph.subtract(arguments[0], arguments[1]),
        _ => return None,
    };
    let dependencies = graph.dependencies(difference);
    let unknown = Dependencies::ACCELERATION | Dependencies::MULTIPLIER | Dependencies::REACTION;
    let may_pass = dependencies.intersects(moving()) && !dependencies.intersects(unknown);
    // A nonnegative expression, such as a length, touches its surface but never crosses it.
    may_pass.then(|| normalised(graph, difference)).filter(|surface| !graph.is_nonnegative(surface.value))
}

/// Normalises the surface of a difference so that all its multiples have the same one. The time, or
/// else the first term that changes in motion, has the coefficient one.
fn normalised(graph: &mut Graph, difference: ExprId) -> Surface {
    let (scale, core) = graph.split_coefficient(difference);
    let leading = match graph.node(core) {
        Node::Sum { terms, .. } => {
            let moves = |(term, _): &&(ExprId, Number)| !graph.dependencies(*term).is_constant_in_motion();
            let timed = terms.iter().find(|(term, _)| is_time(graph, *term));
            timed.or(terms.iter().find(moves)).map(|(_, coefficient)| coefficient.clone())
        }
        _ => None,
    };
    let leading = leading.unwrap_or(Number::ONE);
    let value = match leading.reciprocal() {
        Some(inverse) => graph.scale(inverse, core),
        None => core,
    };
    Surface { value, is_opposite: leading.is_negative() != scale.is_negative() }
}

fn is_time(graph: &Graph, id: ExprId) -> bool {
    let role = |symbol: SymbolId| graph.symbols().get(symbol).role;
    matches!(graph.node(id), Node::Symbol(symbol) if role(*symbol) == Role::Time)
}

/// Returns the time at which a surface is crossed, if time is a separate term and all others are
/// constant in motion.
fn passed_at(graph: &mut Graph, value: ExprId) -> Option<ExprId> {
    let time = graph.symbol("t", Role::Time);
    let rest = graph.subtract(time, value);
    (!graph.dependencies(rest).intersects(moving())).then_some(rest)
}

/// Returns the dependencies that may change in motion. Inputs are among them, since a control may
/// compute them from the state.
fn moving() -> Dependencies {
    let state = Dependencies::COORDINATE | Dependencies::STATE | Dependencies::VELOCITY;
    Dependencies::TIME | state | Dependencies::INPUT
}

/// Returns the first statement that contains each surface of the declaration.
fn statements(model: &mut Model) -> HashMap<ExprId, String> {
    let mut roots: Vec<(ExprId, String)> = Vec::new();
    for load in &model.loads {
        let on = model.speeds.iter().position(|speed| speed.velocity == load.velocity);
        let statement =
            on.map_or("force".to_owned(), |index| format!("force {}", model.name_of_freedom(index)));
        roots.extend([(load.force, statement.clone()), (load.velocity, statement)]);
    }
    roots.push((model.dissipation, "dissipation".to_owned()));
    match model.energies.parts() {
        Some([kinetic, potential]) => {
            roots.extend([(potential, "potential".to_owned()), (kinetic, "kinetic".to_owned())]);
        }
        None => roots.push((model.lagrangian, "lagrangian".to_owned())),
    }
    for state in model.states() {
        roots.push((state.rate, format!("dot({})", state.name)));
    }
    for constraint in &model.constraints {
        roots.push((constraint.value, format!("constraint {}", constraint.name)));
    }
    for reaction in &model.reactions {
        let (statement, parts) = match reaction.kind {
            ReactionKind::Contact { gap, .. } => ("event", vec![gap]),
            ReactionKind::Friction { kinetic, fixed } | ReactionKind::Across { kinetic, fixed } => {
                ("friction", vec![kinetic, fixed])
            }
            ReactionKind::Smooth { limit, .. } => ("friction", vec![limit]),
        };
        let statement = format!("{statement} {}", reaction.name);
        roots.extend(parts.into_iter().chain([reaction.velocity]).map(|part| (part, statement.clone())));
    }
    let mut found = HashMap::default();
    for (root, statement) in roots {
        for id in model.graph.reachable(&[root]) {
            if let Some(surface) = surface(&mut model.graph, id, &[]) {
                found.get_or_insert_with(surface.value, || statement.clone());
            }
        }
    }
    found
}
