//! Naming of delayed signals.
//!
//! `delay(e, tau)` is the value of e at a time tau ago. Every call becomes the name of a separate
//! statement, which precedes the statement that contains it. Identical calls share one statement. A
//! `let` that consists only of such a call is itself this statement.
//!
//! ```text
//! force x = -k * delay(x, tau);      let delayed_1 = delay(x, tau);   force x = -k * delayed_1;
//! ```

use crate::syntax::ast::{AstId, Declaration, Expression, Expressions, Name, Statement, StatementKind};
use crate::syntax::print;
use lagrange_expr::collections::{HashMap, HashSet};

/// The function of the language that delays signals.
const DELAY: &str = "delay";

/// Gives names to the delayed signals of a declaration. Calls in statements that cannot delay, or
/// with other numbers of arguments, remain.
pub fn name_delays(declaration: &mut Declaration) {
    if !delays_signals(declaration) {
        return;
    }
    let names = declaration.statements.iter().flat_map(|statement| statement.kind.declared_names());
    let taken = names.map(|name| name.text.clone()).collect();
    let expressions = std::mem::take(&mut declaration.expressions);
    let mut delays = Delays { expressions, taken, known: HashMap::default(), added: Vec::new() };
    for mut statement in std::mem::take(&mut declaration.statements) {
        delays.replace_in(&mut statement);
        declaration.statements.append(&mut delays.added);
        declaration.statements.push(statement);
    }
    declaration.expressions = delays.expressions;
}

/// True if a declaration calls the function of the language, and does not define its own.
fn delays_signals(declaration: &Declaration) -> bool {
    let is_own = |statement: &Statement| {
        statement.kind.declared_function().is_some_and(|function| function.text == DELAY)
    };
    let is_call =
        |expression: &Expression| matches!(expression, Expression::Call(name, _) if name.text == DELAY);
    declaration.expressions.iter().any(|(_, expression)| is_call(expression))
        && !declaration.statements.iter().any(is_own)
}

struct Delays {
    expressions: Expressions,
    /// Names already in use.
    taken: HashSet<String>,
    /// Names of the delayed signals so far, keyed by the text of their calls.
    known: HashMap<String, String>,
    /// Statements to be inserted before the current one.
    added: Vec<Statement>,
}

impl Delays {
    fn replace_in(&mut self, statement: &mut Statement) {
        if !can_delay(&statement.kind) {
            return;
        }
        if let StatementKind::Let(name, value) = &statement.kind
            && let Some([signal, lag]) = self.delayed(*value)
        {
            let (name, call) = (name.clone(), print::expression(&self.expressions, *value));
            let [signal, lag] = [signal, lag].map(|part| self.replaced(part, statement));
            self.known.get_or_insert_with(call, || name.text.clone());
            statement.kind = StatementKind::Delay { name, signal, lag };
            return;
        }
        let mut kind = statement.kind.clone();
        for id in kind.expressions_mut() {
            *id = self.replaced(*id, statement);
        }
        statement.kind = kind;
    }

    /// Returns the signal and the delay of a call.
    fn delayed(&self, call: AstId) -> Option<[AstId; 2]> {
        match self.expressions.get(call) {
            Expression::Call(name, arguments) if name.text == DELAY => arguments[..].try_into().ok(),
            _ => None,
        }
    }

    /// Returns the expression with calls replaced by names, inner calls first.
    fn replaced(&mut self, root: AstId, statement: &Statement) -> AstId {
        let mut replaced: HashMap<AstId, AstId> = HashMap::default();
        for id in self.expressions.parts(root) {
            let expression = self.expressions.get(id).clone();
            let operands = expression.operands();
            let new = |operand: &AstId| replaced.get(operand).copied().unwrap_or(*operand);
            let parts = operands.iter().map(new).collect::<Vec<_>>();
            let origin = self.expressions.origin(id);
            let replacement = match self.delayed(id) {
                Some(_) => {
                    let call = print::expression(&self.expressions, id);
                    Expression::Name(self.name_of(call, [parts[0], parts[1]], id, statement))
                }
                None if parts == operands => continue,
                None => expression.with_operands(&parts),
            };
            replaced.insert(id, self.expressions.add(replacement, origin));
        }
        replaced.get(&root).copied().unwrap_or(root)
    }

    /// Returns the name of a delayed signal, and declares a new one.
    fn name_of(&mut self, text: String, [signal, lag]: [AstId; 2], call: AstId, at: &Statement) -> String {
        if let Some(name) = self.known.get(&text) {
            return name.clone();
        }
        let numbered = (1..).map(|number| format!("delayed_{number}"));
        let name = numbered.into_iter().find(|name| !self.taken.contains(name)).unwrap_or_default();
        self.taken.insert(name.clone());
        self.known.insert(text, name.clone());
        let span = self.expressions.origin(call).start;
        let kind = StatementKind::Delay { name: Name::new(name.clone(), span), signal, lag };
        self.added.push(Statement { kind, origin: at.origin, docs: at.docs.clone() });
        name
    }
}

/// True for statements whose expressions may depend on more than the current state.
fn can_delay(kind: &StatementKind) -> bool {
    matches!(
        kind,
        StatementKind::Let(..)
            | StatementKind::LetTuple(..)
            | StatementKind::Solve(_)
            | StatementKind::StateRate(..)
            | StatementKind::RateEquation(_)
            | StatementKind::ForceOn(..)
            | StatementKind::ForceAt { .. }
            | StatementKind::ForceAlong { .. }
            | StatementKind::Torque { .. }
            | StatementKind::Event(_)
            | StatementKind::Every(_)
            | StatementKind::Friction(_)
            | StatementKind::Output(..)
            | StatementKind::Scene(_)
    )
}
