//! Emission for a declaration with errors.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::base::members::{Lanes, Members, Prepared, PreparedFields, Regressed, Taylor};
use super::base::method::{ArgumentNames, Arguments, Method, Returns};
use super::base::shape::{Shape, identifier, local, method_of, motion_name};
use super::base::size::drop_excess;
use super::features::constants::{equations_latex, parameter_names, statements_constant};
use super::features::delays::lags_method;
use super::features::kernel::kernel_constants;
use super::features::prepared::METHODS_OF_PREPARED;
use super::features::product::signature;
use super::features::reduced::{placeholder_conversions, reduced_attributes};
use super::features::scene::motion_method;
use super::item::items;
use crate::elaborate::is_method_of_reduced;
use crate::model::{BodyMethod, Product};
use lagrange_expr::collections::HashSet;
use lagrange_language::inline::name_delays;
use lagrange_language::syntax::ast::{Action, Declaration, ScalarType, StatementKind};

/// Members that do not come from products; an output with such a name is an error.
const TAKEN: [&str; 12] = [
    "rhs",
    "EQUATIONS_LATEX",
    "KERNEL_F32",
    "KERNEL_F64",
    "PARAMETERS",
    "REGRESSOR_PARAMETERS",
    "regressor_parameters",
    "STATEMENTS",
    "project",
    "consistent_velocity",
    "reactions",
    "event_functions",
];

const NOT_DERIVED: &str = "Not derived: the declaration has errors.";

/// Returns the items of a system that could not be derived. They have the same types and methods,
/// so code that uses them causes no further errors. They never run, since compilation fails.
pub fn skeleton(declaration: &mut Declaration, krate: &TokenStream) -> TokenStream {
    name_delays(declaration);
    drop_excess(&mut declaration.statements);
    let (system, reduced) = (skeleton_of_type(declaration, krate), skeletons_of_reduced(declaration, krate));
    quote!(#system #reduced)
}

/// Emits the skeleton of one type.
fn skeleton_of_type(declaration: &Declaration, krate: &TokenStream) -> TokenStream {
    let shape = Shape::new(declaration, krate);
    let n = shape.velocities.len();
    let mut methods = vec![placeholder(local("acceleration"), Arguments::State, Returns::Vector(n))];
    if !shape.velocities_are_rates() {
        let rates = Returns::Vector(shape.coordinates.len());
        methods.push(placeholder(local("position_rates"), Arguments::State, rates));
    }
    let m = shape.constraints.len();
    if m > 0 {
        methods.push(placeholder(local("multipliers"), Arguments::State, Returns::Vector(m)));
    }
    let touching = shape.reactions().len();
    if touching > 0 {
        methods.push(placeholder(local("reactions"), Arguments::State, Returns::Vector(touching)));
    }
    let is_written = |product: &Product| m > 0 || !product.is_of_constraints();
    for product in Product::ALL.into_iter().filter(is_written) {
        if let Some((arguments, returns)) = signature(product, &shape, false) {
            methods.push(placeholder(local(product.name()), arguments, returns));
        }
    }
    let frames = skeleton_of_frames(&shape).into_iter();
    let frames = frames.filter(|frame| methods.iter().all(|method| method.name != frame.name));
    let frames = frames.collect::<Vec<_>>();
    methods.extend(frames);
    let motions = shape.bodies.iter().map(|body| motion_name(body)).collect::<Vec<_>>();
    for (name, count) in &shape.outputs {
        let returns = if *count == 1 { Returns::Scalar } else { Returns::Vector(*count) };
        let mut taken = methods.iter().map(|method| &method.name).chain(&motions);
        if !TAKEN.contains(&name.text.as_str()) && taken.all(|taken| *taken != name.text) {
            methods.push(placeholder(identifier(name), Arguments::State, returns));
        }
    }
    let is_derived = declaration.derives.iter().any(|name| name.text == "Default");
    let names = ArgumentNames::beside(&shape.user_names());
    let signals = skeleton_of_signals(&shape);
    let hidden = skeleton_of_events(&shape).into_iter().chain(signals.into_iter().flatten());
    let lags = (!shape.delays.is_empty()).then(|| lags_method(&shape, &quote!(::core::unreachable!())));
    let constants = [equations_latex(""), parameter_names(&shape), statements_constant("")];
    let members = Members {
        default: (!is_derived).then(|| quote!(::core::unreachable!())),
        methods,
        constrained: skeleton_of_constraints(n, m),
        are_holonomic: vec![true; m],
        terms: quote!(::core::unreachable!()),
        hidden: hidden.map(|method| method.of_trait(&shape, &names)).chain(lags).collect(),
        motions: skeleton_of_motions(&shape, &names),
        ranges: declaration.ranges().next().map(|_| quote!(::core::unreachable!())),
        start: declaration.has_start().then(|| quote!(::core::unreachable!())),
        items: shape.asks_for(Product::Drawing).then(TokenStream::new),
        prepared: shape.asks_for(Product::Prepared).then(|| skeleton_of_prepared(&shape)),
        kernel: shape.asks_for(Product::Kernel).then(|| kernel_constants("", "")),
        lanes: shape.asks_for(Product::Lanes).then(skeleton_of_lanes),
        regressor: shape.asks_for(Product::Regressor).then(skeleton_of_regressor),
        taylor: shape.asks_for(Product::Taylor).then(skeleton_of_taylor),
        constants: constants.into_iter().collect(),
        is_separable: shape.velocities_are_rates(),
        ..Members::new(names)
    };
    items(&shape, &members)
}

fn skeleton_of_constraints(n: usize, m: usize) -> Vec<Method> {
    if m == 0 {
        return Vec::new();
    }
    let residuals = placeholder(local("position_residuals"), Arguments::Positions, Returns::Vector(m));
    let [correction, mass_times] = [("correction", Arguments::Residuals), ("mass_times", Arguments::Motion)]
        .map(|(name, arguments)| placeholder(local(name), arguments, Returns::Vector(n)));
    vec![residuals, correction, mass_times]
}

fn skeleton_of_events(shape: &Shape<'_>) -> Vec<Method> {
    if shape.events.is_empty() {
        return Vec::new();
    }
    let functions = Returns::Vector(shape.events.len());
    let mut methods = vec![placeholder(local("event_functions"), Arguments::State, functions)];
    for (i, event) in shape.events.iter().enumerate() {
        if let Action::Assign(_) = event.action {
            let state = Returns::Vector(shape.coordinates.len() + shape.velocities.len());
            methods.push(placeholder(format_ident!("after_event_{i}"), Arguments::State, state));
        }
    }
    methods
}

fn skeleton_of_signals(shape: &Shape<'_>) -> [Option<Method>; 2] {
    let signals = Returns::Vector(shape.delays.len());
    let method = |name: &str| placeholder(local(name), Arguments::State, signals);
    let is_delayed = !shape.delays.is_empty();
    [
        is_delayed.then(|| method("signals_to_delay")),
        (is_delayed && shape.has_history).then(|| method("signals_before_start")),
    ]
}

fn skeleton_of_motions(shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
    let docs = quote!(#[doc = #NOT_DERIVED]);
    let nothing = quote!(::core::unreachable!());
    shape.bodies.iter().map(|body| motion_method(shape, names, body, &docs, &nothing)).collect()
}

fn skeleton_of_frames(shape: &Shape<'_>) -> Vec<Method> {
    let jacobian = Returns::Matrix(6, shape.velocities.len());
    let frames = shape
        .frames
        .iter()
        .map(|name| placeholder(method_of(name, BodyMethod::Frame), Arguments::Positions, Returns::Frame));
    let derivatives = shape.frames_with_jacobian.iter().flat_map(|name| {
        let [matrix, bias] =
            [BodyMethod::Jacobian, BodyMethod::BiasAcceleration].map(|method| method_of(name, method));
        [
            placeholder(matrix, Arguments::Positions, jacobian),
            placeholder(bias, Arguments::State, Returns::Vector(6)),
        ]
    });
    frames.chain(derivatives).collect()
}

/// Returns the skeleton of the prepared type, with all methods that it may have.
fn skeleton_of_prepared(shape: &Shape<'_>) -> Prepared {
    let accelerations = Returns::Vector(shape.velocities.len());
    let mut methods = vec![placeholder(local("acceleration"), Arguments::State, accelerations)];
    for product in METHODS_OF_PREPARED {
        if let Some((arguments, returns)) = signature(product, shape, false) {
            methods.push(placeholder(local(product.name()), arguments, returns));
        }
    }
    let values = (TokenStream::new(), Vec::new());
    Prepared { fields: PreparedFields::new(), values, methods, docs: NOT_DERIVED.to_owned() }
}

fn skeleton_of_lanes() -> Lanes {
    Lanes {
        rhs: quote!(::core::unreachable!()),
        derivatives: None,
        sides: None,
        docs: NOT_DERIVED.to_owned(),
    }
}

fn skeleton_of_regressor() -> Regressed {
    Regressed { names: Vec::new(), body: quote!([]) }
}

fn skeleton_of_taylor() -> Taylor {
    let body = quote!(::core::unreachable!());
    Taylor { shared: 0, groups: 0, followed: Vec::new(), is_in_lanes: false, body }
}

fn placeholder(name: Ident, arguments: Arguments, returns: Returns) -> Method {
    let docs = quote!(#[doc = #NOT_DERIVED]);
    Method { name, docs, arguments, returns, body: quote!(::core::unreachable!()) }
}

/// Emits the skeletons of the reduced types.
fn skeletons_of_reduced(declaration: &Declaration, krate: &TokenStream) -> TokenStream {
    let mut taken = HashSet::default();
    let mut is_new = |name: &str| {
        let mut insert = |name: String| taken.insert(name);
        insert(name.to_owned())
            & insert(format!("{name}State"))
            & insert(format!("{name}Columns"))
            & insert(format!("{name}Inputs"))
            & insert(format!("{name}Prepared"))
            & insert(format!("{name}Lanes"))
    };
    is_new(&declaration.name.text);
    if let ScalarType::Generic(name) = &declaration.scalar {
        is_new(&name.text);
    }
    let full = Shape::new(declaration, krate);
    let types = declaration.reductions().filter(|(reduction, _)| is_new(&reduction.name.text));
    let types = types.map(|(reduction, docs)| {
        let mut part = declaration.reduced(reduction, reduced_attributes(declaration, docs, &[]));
        let has_states = !Shape::new(&part, krate).velocities_are_rates();
        part.statements.retain(|statement| !is_reserved(&statement.kind, has_states));
        let conversions = placeholder_conversions(&full, &Shape::new(&part, krate));
        let system = skeleton_of_type(&part, krate);
        quote!(#system #conversions)
    });
    types.collect()
}

/// True if a statement is an output with the name of a method, which is reported.
fn is_reserved(statement: &StatementKind, has_states: bool) -> bool {
    matches!(statement, StatementKind::Output(name, _) if is_method_of_reduced(&name.text, has_states))
}
