//! A derived system as items: every requested product is lowered and written as a method.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::base::docs;
use super::base::fields::entries;
use super::base::method::{Arguments, Method, Returns};
use super::base::refusal::{Refusal, report_refusal};
use super::base::shape::{doc, identifier};
use super::base::size::{Size, report_cost};
use super::base::writer::MethodWriter;
use super::features::clocks::write_clocks;
use super::features::constants::{equations_latex, parameter_names, statements_constant};
use super::features::constrained::write_constrained;
use super::features::contacts::{default_modes, write_touching};
use super::features::delays::write_delays;
use super::features::events::write_events;
use super::features::frames::write_frames;
use super::features::indefinite::write_indefinite;
use super::features::kernel::{self as kernels, write_kernel};
use super::features::lanes::write_lanes;
use super::features::laws::write_tests;
use super::features::missing::missing_derivatives;
use super::features::noise::write_diffusion;
use super::features::orientations::write_position_rates;
use super::features::prepared::write_prepared;
use super::features::product::{Plan, plan};
use super::features::ranges::write_ranges;
use super::features::regressor::write_regressor;
use super::features::scene::write_scene;
use super::features::solvers::{write_solvers, write_unknowns};
use super::features::sparse::{Sparse, lowered_sparse};
use super::features::start::write_start;
use super::features::switches::{derived_shape, free_switches, report_unlocated, write_switches};
use super::features::taylor::write_taylor;
use super::item::items;
use crate::derive::Equations;
use crate::model::{Model, Product};
use lagrange_algebra::code::Precision;
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::expr::ExprId;
use lagrange_expr::opaque::Opaque;
use lagrange_language::syntax::ast::Declaration;

/// Writes the items of a derived system; `None` if this fails, which is reported.
///
/// `statements` are the plain statements, if they replace rigid bodies; `krate` is the path of the
/// crate `lagrange` as seen from the items.
pub fn system(
    declaration: &Declaration,
    model: &mut Model,
    equations: &Equations,
    statements: Option<&str>,
    krate: &TokenStream,
    report: &mut Report,
) -> Option<TokenStream> {
    let refused = |refusal: &Refusal| report_refusal(declaration, refusal, report);
    let (items, size) =
        assembled(declaration, model, equations, statements, krate).inspect_err(refused).ok()?;
    report_cost(declaration, size, report);
    report_unlocated(declaration, equations, report);
    Some(items)
}

/// Writes the equations of motion as C, as stored by `emit { kernel }`; `None` if this fails, which
/// is reported.
pub fn kernel(
    (declaration, model, equations): (&Declaration, &Model, &Equations),
    precision: Precision,
    report: &mut Report,
) -> Option<String> {
    let refused = |refusal: &Refusal| report_refusal(declaration, refusal, report);
    kernels::kernel(model, equations, precision).inspect_err(refused).ok()
}

/// Returns the items, and the sizes of the methods.
fn assembled(
    declaration: &Declaration,
    model: &mut Model,
    equations: &Equations,
    statements: Option<&str>,
    krate: &TokenStream,
) -> Result<(TokenStream, Size), Refusal> {
    let shape = derived_shape(declaration, krate, model, equations);
    let mut writer = MethodWriter::new(&shape, model, equations);
    write_start(&mut writer);
    write_ranges(&mut writer);
    let counts = write_acceleration(&mut writer);
    write_position_rates(&mut writer);
    write_events(&mut writer);
    write_switches(&mut writer);
    write_clocks(&mut writer);
    write_diffusion(&mut writer);
    write_delays(&mut writer);
    write_products(&mut writer);
    write_outputs(&mut writer);
    write_scene(&mut writer);
    write_frames(&mut writer);
    write_unknowns(&mut writer);
    write_prepared(&mut writer)?;
    write_kernel(&mut writer)?;
    write_lanes(&mut writer)?;
    write_taylor(&mut writer)?;
    write_regressor(&mut writer)?;
    write_tests(&mut writer)?;
    write_solvers(&mut writer);
    if !writer.is_hopeless() {
        describe(&mut writer, statements, counts);
    }
    let missing = missing_derivatives(&mut writer);
    if !missing.is_empty() {
        return Err(Refusal::Derivatives(missing));
    }
    let (members, size) = writer.finish()?;
    Ok((items(&shape, &members), size))
}

/// Writes `acceleration` and its helpers, and returns its operations without active contacts or
/// friction.
fn write_acceleration(writer: &mut MethodWriter<'_>) -> OperationCounts {
    let docs = ["Accelerations in the order of the velocities."];
    match (writer.model.constraints.is_empty(), writer.model.reactions.is_empty()) {
        (true, true) => match writer.equations.pivot_growth {
            Some(growth) => write_indefinite(writer, &docs, growth),
            None => {
                let roots = writer.equations.accelerations.clone();
                add(writer, "acceleration", &docs, (Arguments::State, Returns::Vector(roots.len())), &roots)
            }
        },
        (false, true) => write_constrained(writer, &docs),
        (_, false) => write_touching(writer, &docs),
    }
}

fn write_products(writer: &mut MethodWriter<'_>) {
    for product in writer.model.products.clone() {
        if let Some(Plan { docs, arguments, returns, roots }) =
            plan(product, writer.model, writer.equations, writer.shape)
        {
            add(writer, product.name(), docs, (arguments, returns), &roots);
        }
    }
    // Jacobians are among the products. Series call all derivatives of tables, even vanishing ones.
    writer.members.has_kinks = writer.members.callees.iter().any(Opaque::jumps);
}

fn write_outputs(writer: &mut MethodWriter<'_>) {
    for output in writer.model.outputs.clone() {
        let returns = match output.components.len() {
            1 => Returns::Scalar,
            count => Returns::Vector(count),
        };
        let unit = writer.shape.in_unit(&output.name);
        let line = match &output.description {
            Some(description) => format!("{description}{unit}."),
            None => format!("Output `{}`{unit}.", output.name),
        };
        add(writer, &output.name, &[&line], (Arguments::State, returns), &output.components);
    }
}

/// Lowers and writes a method, unless the previous ones are already too large.
fn add(
    writer: &mut MethodWriter<'_>,
    name: &str,
    docs: &[&str],
    (arguments, returns): (Arguments, Returns),
    roots: &[ExprId],
) -> OperationCounts {
    let (body, counts) = match Sparse::of(&writer.model.graph, returns, roots) {
        Some(sparse) => lowered_sparse(writer, &sparse, arguments),
        None => writer.lowered(roots, arguments, |results| returns.collect(results)),
    };
    let output = writer.shape.outputs.iter().find(|(output, _)| output.text == name);
    let (name, docs) = match output {
        Some((output, _)) => (identifier(output), writer.shape.docs(output, &docs.concat())),
        None => (format_ident!("{name}"), docs.iter().map(|line| doc(line)).collect()),
    };
    let docs = writer.shape.method_docs((&name.to_string(), returns), &docs, counts);
    writer.members.methods.push(Method { name, docs, arguments, returns, body });
    counts
}

/// Writes documentation, defaults and constants of the type, and data for its traits.
fn describe(writer: &mut MethodWriter<'_>, statements: Option<&str>, counts: OperationCounts) {
    writer.members.default = default_body(writer);
    writer.members.constants = constants(writer, statements);
    let mut docs = docs::system_docs(writer.model, writer.equations, counts);
    docs.extend(statements.into_iter().flat_map(docs::statements));
    writer.members.docs = docs;
    writer.members.is_separable = writer.equations.is_separable(writer.model);
    let constraints = writer.model.constraints.iter();
    writer.members.are_holonomic = constraints.map(|constraint| constraint.is_holonomic).collect();
}

/// Returns a value of the struct with its defaults, if every field has one.
fn default_body(writer: &mut MethodWriter<'_>) -> Option<TokenStream> {
    let fields = writer.model.parameters.iter().chain(&writer.model.inputs);
    let defaults = fields.map(|field| field.default).collect::<Option<Vec<_>>>()?;
    let body = writer.constants(&defaults)?;
    let shape = writer.shape;
    let (fields, statements) = (entries(&shape.number_fields(), &body.outputs), body.statements);
    let (modes, switches) = (default_modes(shape), free_switches(shape));
    let marker = shape.needs_marker().then(|| quote!(scalar: ::core::marker::PhantomData));
    Some(quote!(#statements Self { #(#fields,)* #modes #switches #marker }))
}

fn constants(writer: &mut MethodWriter<'_>, statements: Option<&str>) -> TokenStream {
    let wants = |product: Product| writer.model.products.contains(&product);
    let (latex, parameters) = (wants(Product::Latex), wants(Product::ParameterJacobian));
    let statements = statements.filter(|_| wants(Product::Statements)).map(statements_constant);
    let latex = latex.then(|| equations_latex(&docs::equations_latex(writer.model, writer.equations)));
    let parameters = parameters.then(|| parameter_names(writer.shape));
    quote!(#latex #parameters #statements)
}
