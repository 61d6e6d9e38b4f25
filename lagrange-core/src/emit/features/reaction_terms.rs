//! The terms of contacts and friction, as expressions and in emitted code.

use proc_macro2::TokenStream;
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
    let ReactionTerms { fields, slopes, inertia } = &terms;
    let (krate, scalar) = (writer.shape.krate, writer.shape.scalar());
    let (body, _) = writer.lowered(&terms.roots(), Arguments::State, |mut results| {
        let fields = fields.iter().map(|(name, returns, roots)| {
            let (own, others) = results.split_at(roots.len());
            results = others;
            let is_present = roots.iter().map(|&root| root != zero).collect::<Vec<_>>();
            let value = match returns {
                Returns::Matrix(rows, columns) => matrix_of(own, &is_present, [*rows, *columns], &quote!(<#scalar as #krate::Number>::ZERO)),
                _ => returns.collect(own),
            };
            let name = format_ident!("{name}");
            quote!(#name: #value)
        });
        let fields = fields.collect::<Vec<_>>();
        let entries = slopes.iter().map(|([limited, reaction], _)| {
            let (own, others) = results.split_at(2);
            results = others;
            let (kinetic, fixed) = (&own[0], &own[1]);
            let [limited, reaction] = [limited, reaction].map(|index| length(*index));
            quote!(#krate::contact::LimitSlope { limited: #limited, reaction: #reaction, kinetic: #kinetic, fixed: #fixed })
        });
        let entries = entries.collect::<Vec<_>>();
        let terms = quote!(#krate::contact::Terms { #(#fields,)* slopes: [#(#entries),*] });
        let matrices = inertia.iter().map(|roots| {
            let (own, others) = results.split_at(roots.len());
            results = others;
            Returns::Matrix(n, n).collect(own)
        });
        let (matrices, step) = (matrices.collect::<Vec<_>>(), local("step"));
        match &matrices[..] {
            [] => terms,
            [mass] => quote!(#krate::contact::ForcedTerms::new(#terms, #mass)),
            [mass, damping, ..] => {
                quote!(#krate::contact::ForcedTerms::damped(#terms, #mass, &#damping, #step))
            }
        }
    });
    body
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

/// Writes a matrix. If most of it is zero, only the other entries are written.
fn matrix_of(
    results: &[TokenStream],
    is_present: &[bool],
    [rows, columns]: [usize; 2],
    zero: &TokenStream,
) -> TokenStream {
    let count = is_present.iter().filter(|is_present| **is_present).count();
    if 2 * count > results.len() {
        return Returns::Matrix(rows, columns).collect(results);
    }
    let name = local("matrix");
    let all = {
        let [rows, columns] = [rows, columns].map(length);
        quote!([[#zero; #columns]; #rows])
    };
    if count == 0 {
        return all;
    }
    let entries = results.iter().zip(is_present).enumerate().filter(|(_, (_, is_present))| **is_present);
    let entries = entries.map(|(place, (value, _))| {
        let [row, column] = [place / columns, place % columns].map(length);
        quote!(#name[#row][#column] = #value;)
    });
    quote!({ let mut #name = #all; #(#entries)* #name })
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
