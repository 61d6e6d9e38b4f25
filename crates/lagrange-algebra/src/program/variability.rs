//! Variability of values: the quantities on which they depend, and thus how often they change.

use super::ir::{Op, Program, ValueTable};
use lagrange_expr::expr::{Dependencies, ExprId, Graph};
use lagrange_expr::symbol::Role;

/// Kind of quantity on which a value depends. Only the strongest one counts: a value that depends
/// on a coordinate and on a velocity varies with velocities.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Variability {
    /// Numbers and parameters only.
    Constant,
    /// Inputs.
    Input,
    /// Time, coordinates or states, including discrete ones.
    Position,
    /// Velocities.
    Velocity,
    /// Accelerations.
    Acceleration,
}

impl Variability {
    /// Returns the variability of a symbol.
    pub fn of_role(role: Role) -> Variability {
        match role {
            Role::Parameter(_) => Variability::Constant,
            Role::Input(_) | Role::Noise(_) => Variability::Input,
            Role::Time
            | Role::Coordinate(_)
            | Role::State(_)
            | Role::Discrete(_)
            | Role::Operand(_)
            | Role::Placeholder(_) => Variability::Position,
            Role::Velocity(_) | Role::Side(_) => Variability::Velocity,
            Role::Acceleration(_) | Role::Multiplier(_) | Role::Reaction(_) => Variability::Acceleration,
        }
    }

    /// Returns the variability of an expression.
    pub fn of_expression(graph: &Graph, id: ExprId) -> Variability {
        let state = Dependencies::COORDINATE | Dependencies::STATE | Dependencies::DISCRETE;
        let position = Dependencies::TIME | state | Dependencies::PLACEHOLDER;
        let kinds = [
            (Dependencies::ACCELERATION, Variability::Acceleration),
            (Dependencies::VELOCITY, Variability::Velocity),
            (position, Variability::Position),
            (Dependencies::INPUT | Dependencies::NOISE, Variability::Input),
        ];
        let dependencies = graph.dependencies(id);
        let strongest = kinds.iter().find(|(kind, _)| dependencies.intersects(*kind));
        strongest.map_or(Variability::Constant, |(_, variability)| *variability)
    }

    /// Returns the variability of every value of a program.
    pub fn of_values(program: &Program) -> ValueTable<Variability> {
        let mut found = ValueTable::with_capacity(program.len());
        for (_, op) in program.values() {
            let mut strongest = match op {
                Op::Input(role) => Variability::of_role(*role),
                _ => Variability::Constant,
            };
            op.for_each_operand(|operand| strongest = strongest.max(found[operand]));
            found.push(strongest);
        }
        found
    }
}
