//! Detection of energies with discontinuous momenta.
//!
//! d/dt ∂L/∂v requires second derivatives of L with respect to velocities. |v| alone has none where
//! v vanishes, and neither do `sign`, `min` and `max` where they switch; |v| v and |v|³ do. A
//! product is continuous if one factor vanishes where another jumps. This is determined from the
//! structure: jumps that only cancel between terms count as jumps. An `if` states its branches
//! explicitly and is not checked.

use super::elaborator::Elaborator;
use super::messages;
use lagrange_algebra::simplify::multiply_out;
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::elementary;
use lagrange_expr::expr::Dependencies;
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::Function;
use lagrange_expr::expr::Graph;
use lagrange_expr::expr::Node;
use lagrange_expr::number::Number;

/// Maximum number of monomials of an expanded energy with kinks.
const BUDGET: usize = 200;

/// Behaviour of an expression where a kink's argument vanishes.
#[derive(Clone, Copy, Default)]
struct Local {
    vanishes: bool,
    jumps: bool,
}

/// Reports the cause of a jump of the Lagrangian or one of its momenta.
pub(super) fn check_smoothness(elaborator: &mut Elaborator<'_>, lagrangian: ExprId, momenta: &[ExprId]) {
    let roots = [&[lagrangian], momenta].concat();
    let mut places = HashSet::default();
    for (kink, factors) in kinks(&mut elaborator.evaluator.graph, lagrangian) {
        let jumps = factors.into_iter().any(|factor| jumps(&mut elaborator.evaluator.graph, &roots, factor));
        if jumps && places.insert(kink) {
            report_kink(elaborator, kink);
        }
    }
}

fn report_kink(elaborator: &mut Elaborator<'_>, kink: ExprId) {
    let terms = elaborator.kinetic.iter().chain(&elaborator.lagrangian);
    let places =
        terms.filter_map(|term| elaborator.evaluator.place_of(term.syntax, kink)).collect::<Vec<_>>();
    let whole =
        elaborator.kinetic.iter().chain(&elaborator.lagrangian).next().map(|term| term.keyword.into());
    if let Some(place) = places.first().copied().or(whole) {
        elaborator.evaluator.report.error(place, messages::MOMENTA_JUMP).help(messages::MOMENTA_JUMP_HELP);
    }
}

/// Returns the Lagrangian, expanded if this leaves fewer kinks: (|v| + 1) (|v| − 1) is v² − 1.
pub(super) fn without_kinks(graph: &mut Graph, lagrangian: ExprId) -> ExprId {
    let before = kinks(graph, lagrangian).len();
    if before == 0 {
        return lagrangian;
    }
    let expanded = multiply_out(graph, &[lagrangian], BUDGET)[0];
    if kinks(graph, expanded).len() < before { expanded } else { lagrangian }
}

/// Returns magnitudes, signs and extrema that depend on velocities. Each has the velocity-dependent
/// factors of the expression that vanishes where it switches.
fn kinks(graph: &mut Graph, root: ExprId) -> Vec<(ExprId, Vec<ExprId>)> {
    let mut found = Vec::new();
    for id in graph.reachable(&[root]) {
        if !is_moving(graph, id) {
            continue;
        }
        if let Some(argument) = switch(graph, id) {
            found.push((id, moving_factors(graph, argument)));
        }
    }
    found
}

/// Returns the argument that vanishes where a function, or an indicator from its derivative,
/// switches.
fn switch(graph: &mut Graph, id: ExprId) -> Option<ExprId> {
    match *graph.node(id) {
        Node::Call(Function::Abs | Function::Sign | Function::MagnitudeSlope, ref arguments) => {
            Some(arguments[0])
        }
        Node::Call(Function::Min | Function::Max, ref arguments) => {
            let (a, b) = (arguments[0], arguments[1]);
            Some(graph.subtract(a, b))
        }
        _ => None,
    }
}

fn is_moving(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::VELOCITY)
}

/// Returns the factors through which a product changes its sign with the velocities.
fn moving_factors(graph: &Graph, id: ExprId) -> Vec<ExprId> {
    let (_, core) = graph.split_coefficient(id);
    let (mut found, mut pending) = (Vec::new(), vec![core]);
    while let Some(id) = pending.pop() {
        match graph.node(id) {
            _ if !is_moving(graph, id) => {}
            Node::Product(factors) => {
                let odd = factors.iter().filter(|(_, exponent)| !exponent.is_even());
                pending.extend(odd.map(|(base, _)| *base));
            }
            _ => found.push(id),
        }
    }
    found
}

/// True if one of these expressions may jump where `factor` vanishes.
fn jumps(graph: &mut Graph, roots: &[ExprId], factor: ExprId) -> bool {
    let mut known: HashMap<ExprId, Local> = HashMap::default();
    for id in graph.reachable_until(roots, |id| !is_moving(graph, id)) {
        let local = if id == factor || graph.is_zero(id) {
            Local { vanishes: true, jumps: false }
        } else {
            local(graph, id, factor, &known)
        };
        known.insert(id, local);
    }
    roots.iter().any(|root| known.get(root).is_some_and(|local| local.jumps))
}

fn local(graph: &mut Graph, id: ExprId, factor: ExprId, known: &HashMap<ExprId, Local>) -> Local {
    let of = |id: &ExprId| known.get(id).copied().unwrap_or_default();
    match graph.node(id).clone() {
        Node::Number(_) | Node::Pi | Node::Symbol(_) => Local::default(),
        Node::Sum { constant, terms } => Local {
            vanishes: constant.is_zero() && terms.iter().all(|(term, _)| of(term).vanishes),
            jumps: terms.iter().any(|(term, _)| of(term).jumps),
        },
        Node::Product(factors) => of_product(&factors, of),
        Node::Call(function, arguments) => {
            let switches =
                switch(graph, id).is_some_and(|argument| moving_factors(graph, argument).contains(&factor));
            let all_vanish = arguments.iter().all(|argument| of(argument).vanishes);
            let is_step = matches!(function, Function::Sign | Function::MagnitudeSlope);
            let is_zero_at_zero = elementary::row(function).at_zero == Some(0)
                || matches!(function, Function::Min | Function::Max | Function::Hypot);
            // A power with an exponent that is only known at run time is assumed to be smooth.
            let is_power = function == Function::Power && of(&arguments[0]).vanishes;
            Local {
                vanishes: all_vanish && is_zero_at_zero && !is_step || is_power,
                jumps: arguments.iter().any(|argument| of(argument).jumps) || switches && is_step,
            }
        }
        // It is assumed to be smooth, and not to vanish where its arguments do.
        Node::Opaque(_, arguments) => {
            Local { vanishes: false, jumps: arguments.iter().any(|argument| of(argument).jumps) }
        }
        Node::Choose { left, right, then, otherwise, .. } => {
            let difference = graph.subtract(left, right);
            let switches = moving_factors(graph, difference).contains(&factor);
            let [then, otherwise] = [of(&then), of(&otherwise)];
            let vanishes = then.vanishes && otherwise.vanishes;
            Local { vanishes, jumps: then.jumps || otherwise.jumps || switches && !vanishes }
        }
    }
}

fn of_product(factors: &[(ExprId, Number)], of: impl Fn(&ExprId) -> Local) -> Local {
    let vanishing = factors.iter().filter(|(base, _)| of(base).vanishes);
    let is_singular = vanishing.clone().any(|(_, exponent)| exponent.is_negative());
    let others_vanish =
        |at: usize| factors.iter().enumerate().any(|(n, (base, _))| n != at && of(base).vanishes);
    let is_step = |(n, (base, _)): (usize, &(ExprId, Number))| of(base).jumps && !others_vanish(n);
    Local {
        vanishes: !is_singular && vanishing.count() > 0,
        jumps: is_singular || factors.iter().enumerate().any(is_step),
    }
}
