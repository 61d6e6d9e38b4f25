//! The terms of contacts and friction, as expressions and in emitted code.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::derive::{Affine, Equations};
use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::{length, local};
use crate::emit::base::writer::MethodWriter;
use crate::model::{Model, ReactionKind};
use lagrange_algebra::calculus::gradient;
use lagrange_expr::expr::ExprId;

/// The expressions of the terms of contacts and friction. Their program computes the roots in the
/// order in which they are written here.
pub struct ReactionTerms {
    /// Name, shape and expressions of each field.
    fields: [(&'static str, Returns, Vec<ExprId>); 9],
    /// The limited reaction, the reaction on which its limits depend, and the slopes of both
    /// limits.
    pub slopes: Vec<([usize; 2], [ExprId; 2])>,
    /// The mass matrix and, if there are dampers, the matrix of their resistances. There is none
    /// with constraints.
    pub inertia: Vec<Vec<ExprId>>,
}

impl ReactionTerms {
    /// Collects the expressions of a model with contacts or friction.
    pub fn new(model: &mut Model, equations: &Equations) -> ReactionTerms {
        let (n, k) = (model.speeds.len(), model.reactions.len());
        let zero = model.graph.number(0);
        let parts = |pick: fn(&ReactionKind) -> Option<ExprId>| {
            model.reactions.iter().map(|reaction| pick(&reaction.kind).unwrap_or(zero)).collect::<Vec<_>>()
        };
        let gaps = parts(|kind| match kind {
            ReactionKind::Contact { gap, .. } => Some(*gap),
            _ => None,
        });
        let restitutions = parts(|kind| match kind {
            ReactionKind::Contact { restitution, .. } => Some(*restitution),
            _ => None,
        });
        let rates = model.reactions.iter().map(|reaction| reaction.velocity).collect::<Vec<_>>();
        let reactions = &equations.reactions;
        let without = |list: &[Affine]| list.iter().map(|affine| affine.free).collect::<Vec<_>>();
        let (vector, matrix) = (Returns::Vector(k), Returns::Matrix(k, n));
        let is_constrained = !model.constraints.is_empty();
        // Accelerations and responses follow from forces and rows by one factorisation at run time.
        let (free, responses) = match is_constrained {
            true => (equations.accelerations.clone(), reactions.responses.concat()),
            false => (equations.forcing.clone(), vec![zero; k * n]),
        };
        let fields = [
            ("free", Returns::Vector(n), free),
            ("responses", matrix, responses),
            ("rows", matrix, reactions.rows.concat()),
            ("gaps", vector, gaps),
            ("rates", vector, rates),
            ("drifts", vector, reactions.drifts.clone()),
            ("restitutions", vector, restitutions),
            ("kinetic", vector, without(&reactions.kinetic)),
            ("fixed", vector, without(&reactions.fixed)),
        ];
        let slopes = slopes(&reactions.kinetic, &reactions.fixed, zero);
        let inertia = if is_constrained { Vec::new() } else { inertia(model, equations) };
        ReactionTerms { fields, slopes, inertia }
    }

    /// Returns all expressions: those of the fields, the slopes and the matrices.
    pub fn roots(&self) -> Vec<ExprId> {
        let of_fields = self.fields.iter().flat_map(|(_, _, roots)| roots);
        let of_slopes = self.slopes.iter().flat_map(|(_, roots)| roots);
        of_fields.chain(of_slopes).chain(self.inertia.iter().flatten()).copied().collect()
    }
}

/// Returns the body of `ContactSystem::terms` if there are constraints, and otherwise that of
/// `step_terms`.
pub(super) fn touching_terms(writer: &mut MethodWriter<'_>) -> TokenStream {
    let terms = ReactionTerms::new(writer.model, writer.equations);
    let (n, zero) = (writer.model.speeds.len(), writer.model.graph.number(0));
    writer.members.slopes = terms.slopes.len();
    writer.members.is_forced = !terms.inertia.is_empty();
    writer.members.is_damped = terms.inertia.len() > 1;
    let (krate, scalar) = (writer.shape.krate, writer.shape.scalar());
    let [name, matrix, forced, step] = ["terms", "inertia", "forced", "step"].map(local);
    let (body, _) = writer.lowered(&terms.roots(), Arguments::State, |results| {
        let mut results = Results { left: results };
        let fields = terms.fields.iter().map(|field| filled(&name, field, results.take(field.2.len()), zero));
        let mut statements = fields.collect::<TokenStream>();
        let slopes = terms.slopes.iter().map(|([limited, reaction], _)| {
            let (own, [limited, reaction]) = (results.take(2), [limited, reaction].map(|index| length(*index)));
            let (kinetic, fixed) = (&own[0], &own[1]);
            quote!(#krate::contact::LimitSlope { limited: #limited, reaction: #reaction, kinetic: #kinetic, fixed: #fixed })
        });
        statements.extend(quote!(#name.slopes = [#(#slopes),*];));
        let [mass, damping @ ..] = &terms.inertia[..] else {
            return quote!(let mut #name = #krate::contact::Terms::zeros(); #statements #name);
        };
        let values = results.take(mass.len());
        statements.extend(entries(mass, zero, n, |index, place| {
            let value = &values[place];
            quote!(#matrix #index = #value;)
        }));
        for damping in damping {
            let values = results.take(damping.len());
            let damped = entries(damping, zero, n, |index, place| {
                let value = &values[place];
                quote!(#matrix #index = #krate::Number::multiply_add(#step, #value, #matrix #index);)
            });
            // Damping without bounds does not matter at an instant.
            statements.extend(quote!(if #step != <#scalar as #krate::Number>::ZERO { #damped }));
        }
        quote! {
            let mut #forced = #krate::contact::ForcedTerms::zeros();
            let (#name, #matrix) = #forced.parts();
            #statements
            #forced
        }
    });
    body
}

/// Values of the expressions, in their order.
struct Results<'a> {
    left: &'a [TokenStream],
}

impl<'a> Results<'a> {
    fn take(&mut self, count: usize) -> &'a [TokenStream] {
        let (taken, left) = self.left.split_at(count);
        self.left = left;
        taken
    }
}

/// Writes assignments of these values to a field of the terms, which holds zeros.
fn filled(
    terms: &Ident,
    (field, returns, roots): &(&str, Returns, Vec<ExprId>),
    values: &[TokenStream],
    zero: ExprId,
) -> TokenStream {
    let field = format_ident!("{field}");
    match returns {
        Returns::Matrix(_, columns) => entries(roots, zero, *columns, |index, place| {
            let value = &values[place];
            quote!(#terms.#field #index = #value;)
        }),
        _ => {
            let value = returns.collect(values);
            quote!(#terms.#field = #value;)
        }
    }
}

/// Writes a statement for each entry of a matrix that is not zero, from its indices and its place.
fn entries(
    roots: &[ExprId],
    zero: ExprId,
    columns: usize,
    statement: impl Fn(TokenStream, usize) -> TokenStream,
) -> TokenStream {
    let present = roots.iter().enumerate().filter(|(_, root)| **root != zero);
    let statements = present.map(|(place, _)| {
        let [row, column] = [place / columns, place % columns].map(length);
        statement(quote!([#row][#column]), place)
    });
    statements.collect()
}

/// Returns the slopes of limits that are not zero, with the indices of the limited reactions and of
/// those on which the limits depend.
fn slopes(kinetic: &[Affine], fixed: &[Affine], zero: ExprId) -> Vec<([usize; 2], [ExprId; 2])> {
    let limits = kinetic.iter().zip(fixed).enumerate();
    let of_limit = |(limited, (kinetic, fixed)): (usize, (&Affine, &Affine))| {
        let pairs = kinetic.slopes.clone().into_iter().zip(fixed.slopes.clone()).enumerate();
        pairs.map(move |(reaction, (kinetic, fixed))| ([limited, reaction], [kinetic, fixed]))
    };
    limits.flat_map(of_limit).filter(|(_, slopes)| *slopes != [zero; 2]).collect()
}

/// Returns the mass matrix and, if there is dissipation, the matrix of its second derivatives.
fn inertia(model: &mut Model, equations: &Equations) -> Vec<Vec<ExprId>> {
    let mass = equations.mass_matrix.concat();
    let (velocities, dissipation) = (model.velocities(), model.dissipation);
    let graph = &mut model.graph;
    let forces = gradient(graph, dissipation, &velocities);
    let damping = forces.into_iter().flat_map(|force| gradient(graph, force, &velocities));
    let damping = damping.collect::<Vec<_>>();
    let zero = graph.number(0);
    if damping.iter().all(|&entry| entry == zero) { vec![mass] } else { vec![mass, damping] }
}
