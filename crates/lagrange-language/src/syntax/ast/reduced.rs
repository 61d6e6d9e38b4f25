//! Declarations of reduced types.

use proc_macro2::TokenStream;
use quote::quote;

use super::definitions::{Definition, StateKind};
use super::statements::{Reduction, ReductionKind, momentum_of};
use super::statements::{Statement, StatementKind};
use super::{Declaration, Name, ScalarType};
use lagrange_expr::diagnostics::Origin;

impl Declaration {
    /// Returns the reduced types in order, each with its documentation.
    pub fn reductions(&self) -> impl Iterator<Item = (&Reduction, &TokenStream)> {
        self.statements.iter().filter_map(|statement| match &statement.kind {
            StatementKind::Reduce(reduction) => Some((reduction, &statement.docs)),
            _ => None,
        })
    }

    /// Returns the traits in `#[derive(…)]` that types with fields of `f32` or `f64` cannot have.
    pub fn underivable(&self) -> Vec<&Name> {
        let has_fields =
            self.reductions().any(|(reduction, _)| reduction.has_momenta()) || self.fields().next().is_some();
        let is_number = !matches!(self.scalar, ScalarType::Generic(_));
        let is_exact = |name: &&Name| ["Eq", "Ord", "Hash"].contains(&name.text.as_str());
        self.derives.iter().filter(is_exact).filter(|_| has_fields && is_number).collect()
    }

    /// Returns the declaration of a reduced type, with a different name and documentation. It has
    /// no frozen coordinates, and ignored ones are states after the others. Its statements still
    /// describe the whole system.
    pub fn reduced(&self, reduction: &Reduction, attributes: TokenStream) -> Declaration {
        let is = |kind: ReductionKind, name: &Name| {
            reduction.of_kind(kind).any(|item| item.coordinate.text == name.text)
        };
        let mut declaration = Declaration { attributes, name: reduction.name.clone(), ..self.clone() };
        let is_this = |kind: &StatementKind| matches!(kind, StatementKind::Reduce(other) if other.name.text == reduction.name.text);
        declaration.reduction = self.statements.iter().find(|statement| is_this(&statement.kind)).cloned();
        declaration.statements.retain(|statement| !matches!(statement.kind, StatementKind::Reduce(_)));
        let mut ignored = Vec::new();
        for statement in &mut declaration.statements {
            if let StatementKind::Coordinates(list) | StatementKind::States(_, list) = &mut statement.kind {
                list.retain(|definition| !is(ReductionKind::Frozen, &definition.name));
            }
            if let StatementKind::Coordinates(list) = &mut statement.kind {
                let moved =
                    list.extract_if(.., |of| is(ReductionKind::Ignored, &of.name)).collect::<Vec<_>>();
                ignored.extend(moved.into_iter().map(|coordinate| (coordinate, statement.docs.clone())));
            }
        }
        let added = ignored.into_iter().flat_map(|(state, docs)| ignored_statements(state, docs));
        declaration.statements.extend(added);
        declaration
    }
}

/// Returns the momentum of an ignored coordinate as a parameter, and the coordinate as a state.
fn ignored_statements(coordinate: Definition, docs: TokenStream) -> [Statement; 2] {
    let origin = Origin::from(coordinate.name.span);
    let words = format!("Momentum ∂L/∂v of the ignored coordinate `{}`.", coordinate.name.text);
    let momentum = StatementKind::Parameters(vec![Definition::of(momentum_of(&coordinate.name))]);
    let state = StatementKind::States(StateKind::FirstOrder, vec![coordinate]);
    [
        Statement { kind: momentum, origin, docs: quote!(#[doc = #words]) },
        Statement { kind: state, origin, docs },
    ]
}
