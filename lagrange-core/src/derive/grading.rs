//! Grades of parameters: the power of the unit of inertia in each of them.
//!
//! Lagrange's equations do not change if the Lagrangian, the dissipation and all forces are
//! multiplied by one number. The consequences for parameters follow from sums: all terms of a sum
//! have the same grade. This yields linear equations between the grades of parameters, which are
//! solved one after the other. An equation that contradicts earlier ones indicates a number that
//! carries a unit, and is skipped. Grades that remain undetermined are zero.

use std::collections::BTreeMap;

use crate::model::Model;
use lagrange_algebra::calculus::keeps_units;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// A grade as `known + Σ coefficient · grade of a symbol`.
#[derive(Clone, Debug)]
struct GradeForm {
    known: Number,
    open: BTreeMap<ExprId, Number>,
}

impl GradeForm {
    fn number(known: Number) -> GradeForm {
        GradeForm { known, open: BTreeMap::new() }
    }

    fn symbol(symbol: ExprId) -> GradeForm {
        GradeForm { known: Number::ZERO, open: BTreeMap::from([(symbol, Number::ONE)]) }
    }

    fn plus(mut self, other: &GradeForm, factor: &Number) -> GradeForm {
        self.known = &self.known + &(&other.known * factor);
        for (symbol, coefficient) in &other.open {
            let sum = self.open.get(symbol).map_or(Number::ZERO, Clone::clone);
            let sum = &sum + &(coefficient * factor);
            match sum.is_zero() {
                true => drop(self.open.remove(symbol)),
                false => drop(self.open.insert(*symbol, sum)),
            }
        }
        self
    }
}

/// Determines the grades of parameters and inputs, and stores them in the graph.
pub(super) fn grade_parameters(model: &mut Model) {
    let of_degree_one = [model.lagrangian, model.dissipation].into_iter();
    let energies = of_degree_one.filter(|id| !model.graph.is_zero(*id)).collect::<Vec<_>>();
    let forces = model.loads.iter().map(|load| load.force).filter(|id| !model.graph.is_zero(*id));
    let roots = energies.iter().copied().chain(forces).collect::<Vec<_>>();
    let mut solver = GradeSolver::default();
    solver.read(&model.graph, &roots);
    for root in roots {
        let found = solver.form(root);
        solver.equate(&found, &GradeForm::number(Number::ONE));
    }
    let parameters = model.parameters.iter().chain(&model.inputs).map(|parameter| parameter.symbol);
    let grades = parameters.map(|symbol| (symbol, solver.resolved(&GradeForm::symbol(symbol)).known));
    let grades = grades.filter(|(_, grade)| !grade.is_zero()).collect::<Vec<_>>();
    model.graph.set_grades(grades);
}

#[derive(Default)]
struct GradeSolver {
    forms: HashMap<ExprId, GradeForm>,
    solved: HashMap<ExprId, GradeForm>,
}

impl GradeSolver {
    /// Collects the equations of all nodes below the roots.
    fn read(&mut self, graph: &Graph, roots: &[ExprId]) {
        for id in graph.reachable(roots) {
            let form = self.of_node(graph, id);
            self.forms.insert(id, form);
        }
    }

    fn form(&self, id: ExprId) -> GradeForm {
        self.resolved(&self.forms.get(&id).cloned().unwrap_or_else(|| GradeForm::number(Number::ZERO)))
    }

    fn of_node(&mut self, graph: &Graph, id: ExprId) -> GradeForm {
        match graph.node(id) {
            Node::Number(_) | Node::Pi => GradeForm::number(Number::ZERO),
            Node::Symbol(_) => match graph.symbol_of(id).map(|symbol| symbol.role) {
                Some(Role::Parameter(_) | Role::Input(_)) => GradeForm::symbol(id),
                _ => GradeForm::number(Number::ZERO),
            },
            Node::Sum { constant, terms } => {
                let first = self.form(terms[0].0);
                terms[1..].iter().for_each(|(term, _)| self.equate_with(*term, &first));
                if !constant.is_zero() {
                    self.equate(&first, &GradeForm::number(Number::ZERO));
                }
                first
            }
            Node::Product(factors) => {
                factors.iter().fold(GradeForm::number(Number::ZERO), |sum, (base, exponent)| {
                    sum.plus(&self.form(*base), exponent)
                })
            }
            Node::Call(function, arguments) => {
                let compares = keeps_units(*function) || *function == Function::Atan2;
                let first = if compares { self.form(arguments[0]) } else { GradeForm::number(Number::ZERO) };
                let is_free = matches!(function, Function::Sign | Function::MagnitudeSlope);
                let others = arguments.iter().filter(|_| !is_free);
                others.for_each(|argument| self.equate_with(*argument, &first));
                if keeps_units(*function) { first } else { GradeForm::number(Number::ZERO) }
            }
            Node::Opaque(..) => GradeForm::symbol(id),
            Node::Choose { left, right, then, otherwise, .. } => {
                for [a, b] in [[left, right], [then, otherwise]] {
                    if !graph.is_zero(*a) && !graph.is_zero(*b) {
                        let form = self.form(*a);
                        self.equate_with(*b, &form);
                    }
                }
                self.form(if graph.is_zero(*then) { *otherwise } else { *then })
            }
        }
    }

    fn equate_with(&mut self, id: ExprId, other: &GradeForm) {
        let form = self.form(id);
        self.equate(&form, other);
    }

    /// Solves an equation for a symbol of first power if there is one: in m l², for the mass.
    fn equate(&mut self, a: &GradeForm, b: &GradeForm) {
        let difference = self.resolved(&a.clone().plus(b, &Number::MINUS_ONE));
        let plain = difference.open.iter().find(|(_, coefficient)| coefficient.abs().is_one());
        let Some((&symbol, coefficient)) = plain.or(difference.open.first_key_value()) else { return };
        let Some(inverse) = coefficient.reciprocal() else { return };
        let mut rest = difference.clone();
        rest.open.remove(&symbol);
        let form = GradeForm::number(Number::ZERO).plus(&rest, &-&inverse);
        self.solved.insert(symbol, form);
    }

    /// Returns the form without symbols that have been solved. A solution may itself contain
    /// symbols that were solved later.
    fn resolved(&self, form: &GradeForm) -> GradeForm {
        let mut form = form.clone();
        while let Some((symbol, solution)) =
            form.open.keys().find_map(|symbol| Some((*symbol, self.solved.get(symbol)?)))
        {
            let coefficient = form.open.remove(&symbol).unwrap_or(Number::ZERO);
            form = form.plus(solution, &coefficient);
        }
        form
    }
}
