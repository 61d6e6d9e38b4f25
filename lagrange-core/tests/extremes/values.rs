//! Expressions of a graph in many digits.

use lagrange_core::collections::HashMap;
use lagrange_core::expr::{ExprId, Graph, Node, Relation};
use lagrange_core::number::Number;
use lagrange_core::symbol::Role;

use crate::digits::{Arithmetic, Real};

impl Arithmetic {
    /// Returns the values of `roots` where symbols have the values of `value_of`.
    pub(crate) fn evaluate(
        &mut self,
        graph: &Graph,
        roots: &[ExprId],
        value_of: impl Fn(Role, &mut Arithmetic) -> Real,
    ) -> Vec<Real> {
        let mut values: HashMap<ExprId, Real> = HashMap::default();
        for id in graph.reachable(roots) {
            let at = |child: &ExprId| values.get(child).cloned().expect("operands come first");
            let value = match graph.node(id) {
                Node::Number(number) => self.number(number),
                Node::Pi => self.pi(),
                Node::Symbol(symbol) => value_of(graph.symbols().get(*symbol).role, self),
                Node::Sum { constant, terms } => {
                    let terms = terms.iter().map(|(term, coefficient)| (at(term), coefficient));
                    self.sum(constant, terms)
                }
                Node::Product(factors) => {
                    let one = self.integer(1);
                    factors.iter().fold(one, |product, (base, exponent)| {
                        let factor = self.power(&at(base), exponent);
                        self.multiply(&product, &factor)
                    })
                }
                Node::Call(function, arguments) => {
                    let arguments = arguments.iter().map(at).collect::<Vec<_>>();
                    self.call(*function, &arguments)
                }
                Node::Opaque(function, _) => {
                    panic!("{} is known in double precision at most", function.text())
                }
                Node::Choose { relation, left, right, then, otherwise } => {
                    let chosen = if holds(*relation, &at(left), &at(right)) { then } else { otherwise };
                    at(chosen)
                }
            };
            values.insert(id, value);
        }
        roots.iter().map(|root| values.get(root).cloned().expect("roots are reachable")).collect()
    }

    fn sum<'a>(&mut self, constant: &Number, terms: impl Iterator<Item = (Real, &'a Number)>) -> Real {
        let constant = self.number(constant);
        terms.fold(constant, |sum, (term, coefficient)| {
            let term = if coefficient.is_one() {
                term
            } else {
                let coefficient = self.number(coefficient);
                self.multiply(&term, &coefficient)
            };
            self.add(&sum, &term)
        })
    }
}

fn holds(relation: Relation, left: &Real, right: &Real) -> bool {
    let order = left.cmp(right).expect("a comparison of numbers");
    relation.holds(order as f64, 0.0)
}
