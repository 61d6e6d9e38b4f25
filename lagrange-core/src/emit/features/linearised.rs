//! The linearised system: its system matrix as expressions, and the trait that provides it.

use proc_macro2::TokenStream;
use quote::quote;

use super::jacobian::linearised;
use super::ports::has_outputs;
use crate::derive::{Equations, along_displacements};
use crate::emit::base::members::Members;
use crate::emit::base::method::{ArgumentNames, Arguments, Method, Returns};
use crate::emit::base::shape::{Shape, length};
use crate::model::{Model, Product};
use lagrange_algebra::calculus::{jacobian, substitute_all};
use lagrange_expr::expr::ExprId;

/// Returns the system matrix [A B; C D; G 0] in rows, where G differentiates the constraint
/// velocities. It follows from the derivatives of the accelerations with respect to the state and
/// the inputs.
pub fn system_matrix(model: &mut Model, equations: &Equations, accelerations: &[ExprId]) -> Vec<ExprId> {
    let inputs = model.inputs.iter().map(|input| input.symbol).collect::<Vec<_>>();
    let arguments = [model.positions(), model.velocities(), inputs.clone()].concat();
    let mut entries = linearised(model, accelerations, &inputs);
    let mut rows = outputs(model, equations, accelerations, &arguments);
    let velocities = model.constraints.iter().map(|constraint| constraint.velocity).collect::<Vec<_>>();
    rows.extend(jacobian(&mut model.graph, &velocities, &arguments).concat());
    entries.extend(along_displacements(model, &rows, arguments.len()));
    entries
}

/// Returns derivatives of the rates and of the outputs with respect to the state and the inputs, in
/// rows, from those of the accelerations.
pub fn by_state_and_inputs(
    model: &mut Model,
    equations: &Equations,
    accelerations: &[ExprId],
) -> Vec<ExprId> {
    let inputs = model.inputs.iter().map(|input| input.symbol).collect::<Vec<_>>();
    let arguments = [model.positions(), model.velocities(), inputs].concat();
    let rates = model.position_rates();
    let mut entries = jacobian(&mut model.graph, &rates, &arguments).concat();
    entries.extend(accelerations);
    entries.extend(outputs(model, equations, accelerations, &arguments));
    entries
}

/// Returns the rows of the outputs. If these contain accelerations or multipliers, the chain rule
/// is applied.
fn outputs(
    model: &mut Model,
    equations: &Equations,
    accelerations: &[ExprId],
    arguments: &[ExprId],
) -> Vec<ExprId> {
    let outputs = model.outputs.iter().flat_map(|output| output.components.clone()).collect::<Vec<_>>();
    let mut unknowns = model.speeds.iter().map(|speed| speed.acceleration).collect::<Vec<_>>();
    unknowns.extend(model.multipliers());
    let graph = &mut model.graph;
    let direct = jacobian(graph, &outputs, arguments);
    let through = jacobian(graph, &outputs, &unknowns);
    let mut slopes = accelerations.to_vec();
    let multipliers = &equations.constraints.multipliers;
    // Only what an output contains is differentiated.
    let contains = |index: usize| through.iter().any(|row| !graph.is_zero(row[index]));
    let wanted = (0..multipliers.len()).map(|i| contains(equations.accelerations.len() + i));
    let wanted = wanted.collect::<Vec<_>>();
    for (&multiplier, is_wanted) in multipliers.iter().zip(wanted) {
        match is_wanted {
            true => slopes.extend(jacobian(graph, &[multiplier], arguments).concat()),
            false => slopes.extend(vec![graph.number(0); arguments.len()]),
        }
    }
    let mut entries = Vec::new();
    for (direct, through) in direct.into_iter().zip(through) {
        for (column, slope) in direct.into_iter().enumerate() {
            let by_unknowns = slopes.iter().skip(column).step_by(arguments.len());
            let products =
                through.iter().zip(by_unknowns).map(|(&factor, &slope)| graph.multiply(factor, slope));
            let terms = products.chain([slope]).collect::<Vec<_>>();
            entries.push(graph.total(terms));
        }
    }
    let values = equations.accelerations.iter().chain(multipliers).copied();
    substitute_all(graph, &entries, &unknowns.into_iter().zip(values).collect())
}

/// Writes `LinearisedSystem`, if the system matrix is requested.
pub(in crate::emit) fn linearised_impl(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let is_matrix = |method: &&Method| method.name == Product::SystemMatrix.name();
    let Returns::Matrix(rows, columns) = members.methods.iter().find(is_matrix)?.returns else { return None };
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, all) = (shape.krate, shape.state_length());
    let [rows, columns] = [rows, columns].map(length);
    let ArgumentNames { time, state, .. } = &members.names;
    let (layout, residuals) = (layout(shape, members), residuals(shape, members));
    Some(quote! {
        #[automatically_derived]
        impl #bounds #krate::system::LinearisedSystem for #name #generics {
            type Row = [#scalar; #columns];
            type SystemMatrix = [[#scalar; #columns]; #rows];
            const LAYOUT: #krate::system::MatrixLayout = #layout;
            #[inline]
            fn system_matrix(&self, #time: #scalar, #state: &[#scalar; #all]) -> [[#scalar; #columns]; #rows] {
                self.system_matrix(#time, #state)
            }
            #residuals
        }
    })
}

/// Writes the names of the columns for inputs, and of the rows for outputs and constraints.
fn layout(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let krate = shape.krate;
    let inputs = match shape.inputs.is_empty() {
        true => quote!(&[]),
        false => quote!(<Self as #krate::system::ControlledSystem>::INPUTS),
    };
    let outputs = match has_outputs(shape, members) {
        false => quote!(&[]),
        true => quote!(<Self as #krate::system::OutputSystem>::OUTPUTS),
    };
    let constraints = match members.constrained.is_empty() {
        true => quote!(&[]),
        false => quote!(<Self as #krate::constraint::ConstrainedSystem>::CONSTRAINTS),
    };
    let are_holonomic = &members.are_holonomic;
    quote! {
        #krate::system::MatrixLayout {
            inputs: #inputs,
            outputs: #outputs,
            constraints: #constraints,
            are_holonomic: &[#(#are_holonomic),*],
        }
    }
}

/// Writes `LinearisedSystem::residuals`, if there are constraints.
fn residuals(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, scalar, ArgumentNames { time, positions, .. }) =
        (shape.krate, shape.scalar(), &members.names);
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    (!members.constrained.is_empty()).then(|| {
        quote! {
            fn residuals(&self, #parameters) -> [impl ::core::convert::AsRef<[#scalar]>; 2] {
                let of_positions = #krate::constraint::ConstrainedSystem::position_residuals(self, #time, #positions);
                [of_positions, self.constraint_velocity(#passed)]
            }
        }
    })
}
