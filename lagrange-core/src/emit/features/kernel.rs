//! The equations of motion as C, for graphics processors: constants with the text, and the trait by
//! which a driver finds the related data.
//!
//! A text is self-contained: it compiles for OpenCL, CUDA or a processor without further files.
//! Conditions, kinks and jumps follow the state, since no run locates their changes there.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::derive::Equations;
use crate::emit::base::exclusion::Exclusion;
use crate::emit::base::fields::places;
use crate::emit::base::members::Members;
use crate::emit::base::refusal::Refusal;
use crate::emit::base::shape::{Shape, length};
use crate::emit::base::writer::MethodWriter;
use crate::model::{Model, Product};
use lagrange_algebra::code::{Precision, Surroundings, Target, Unrepresentable, prelude, statements};
use lagrange_algebra::program::{Labels, lower, optimise};
use lagrange_expr::expr::ExprId;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// Features that a kernel does not support.
const EXCLUSIONS: [Exclusion; 7] = [
    Exclusion::Contacts,
    Exclusion::Constraints,
    Exclusion::Events,
    Exclusion::Indefinite,
    Exclusion::Noise,
    Exclusion::Functions,
    Exclusion::Delays,
];

/// Writes the constants of the kernel, if requested.
pub(in crate::emit) fn write_kernel(writer: &mut MethodWriter<'_>) -> Result<(), Refusal> {
    if !writer.model.products.contains(&Product::Kernel) || writer.is_hopeless() {
        return Ok(());
    }
    let text = |precision| kernel(writer.model, writer.equations, precision);
    let (double, single) = (text(Precision::Double)?, text(Precision::Single)?);
    writer.members.kernel = Some(kernel_constants(&double, &single));
    Ok(())
}

/// Returns the whole text: prelude, sizes, accelerations, rates of the positions, normalisation.
pub(in crate::emit) fn kernel(
    model: &Model,
    equations: &Equations,
    precision: Precision,
) -> Result<String, Refusal> {
    if let Some(exclusion) = Exclusion::first(&EXCLUSIONS, model, equations) {
        return Err(Refusal::Exclusion(Product::Kernel, exclusion));
    }
    let mut out = prelude(precision);
    let fields = model.parameters.iter().chain(&model.inputs).map(|field| field.name.escape_default());
    let fields = fields.map(|name| name.to_string()).collect::<Vec<_>>();
    let sizes = [
        ("POSITIONS", model.coordinates.len()),
        ("VELOCITIES", model.speeds.len()),
        ("PARAMETERS", fields.len()),
    ];
    for (what, count) in sizes {
        out += &format!("\n#define LAGRANGE_{what} {count}");
    }
    let fields = if fields.is_empty() { "of which there are none".to_owned() } else { fields.join(", ") };
    out += &format!("\n\n// p: parameters, then inputs: {fields}\n");
    let mut function = |name: &str, result: &str, docs: &str, roots: &[ExprId]| {
        let body = body(model, equations, roots, precision, result);
        let body = body.map_err(|error| Refusal::KernelConstants(precision, error.constants))?;
        out += &format!(
            "\n// {docs}\nLAGRANGE_FUNCTION void {name}(REAL t, const REAL *q, const REAL *v, const REAL *p, REAL *{result})\n\
             {{\n    (void)t, (void)q, (void)v, (void)p;\n{body}}}\n"
        );
        Ok(())
    };
    function(
        "lagrange_acceleration",
        "a",
        "Accelerations in the order of the velocities.",
        &equations.accelerations,
    )?;
    function("lagrange_position_rates", "rates", "Rates of the positions.", &model.position_rates())?;
    out.push_str(&normalise(model));
    Ok(out)
}

/// Returns statements that store the values of `roots`.
fn body(
    model: &Model,
    equations: &Equations,
    roots: &[ExprId],
    precision: Precision,
    results: &str,
) -> Result<String, Unrepresentable> {
    let mut labels = Labels::default();
    equations.labels.iter().for_each(|(id, name)| labels.insert(*id, name.as_str()));
    let program = optimise(&lower(&model.graph, roots, &labels), model.accuracy);
    statements(&program, Target::C(precision), &Arguments(model), results)
}

/// The arguments of the functions of a kernel.
struct Arguments<'a>(&'a Model);

impl Surroundings for Arguments<'_> {
    fn place(&self, role: Role) -> String {
        match role {
            Role::Time => "t".to_owned(),
            Role::Coordinate(index) | Role::State(index) | Role::Discrete(index) => format!("q[{index}]"),
            Role::Velocity(index) => format!("v[{index}]"),
            Role::Parameter(index) => format!("p[{index}]"),
            Role::Input(index) => format!("p[{}]", self.0.parameters.len() + index as usize),
            _ => {
                unreachable!("accelerations are found in one way, of the state and the parameters: {role:?}")
            }
        }
    }

    fn name(&self, role: Role) -> Option<String> {
        let symbols = self.0.graph.symbols();
        symbols.find(role).map(|symbol| symbols.get(symbol).identifier())
    }

    fn call(&self, function: &Opaque, _arguments: &[&str]) -> String {
        unreachable!("kernels exclude functions: {function:?}")
    }
}

/// Returns the function that normalises quaternions, whose rates do not preserve their length.
fn normalise(model: &Model) -> String {
    let mut out = "\n// Brings quaternions among the positions to length one.\nLAGRANGE_FUNCTION void lagrange_normalise(REAL *q)\n{\n    (void)q;\n".to_owned();
    for (number, orientation) in model.orientations.iter().enumerate() {
        let [w, x, y, z] = [0, 1, 2, 3].map(|part| format!("q[{}]", orientation.position + part));
        out += &format!(
            "    const REAL length{number} = LAGRANGE_HYPOT(LAGRANGE_HYPOT({w}, {x}), LAGRANGE_HYPOT({y}, {z}));\n"
        );
        for part in [w, x, y, z] {
            out += &format!("    {part} /= length{number};\n");
        }
    }
    out.push_str("}\n");
    out
}

/// Returns the constants with the text.
pub(in crate::emit) fn kernel_constants(double: &str, single: &str) -> TokenStream {
    let [double, single] = [double, single].map(raw);
    quote! {
        /// The equations of motion as C in double precision, for OpenCL, CUDA and processors.
        pub const KERNEL_F64: &'static ::core::primitive::str = #double;
        /// The equations of motion as C in single precision, for OpenCL, CUDA and processors.
        pub const KERNEL_F32: &'static ::core::primitive::str = #single;
    }
}

/// Returns text as a multi-line raw literal. Names and prelude are ASCII, without a quotation mark
/// followed by a hash.
fn raw(text: &str) -> Literal {
    format!("r#\"{text}\"#").parse().unwrap_or_else(|_| Literal::string(text))
}

/// Implements `KernelSystem`, if there is a kernel.
pub(in crate::emit) fn kernel_impl(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    members.kernel.as_ref()?;
    let (name, generics, bounds, krate) = (shape.name(), shape.generics(), shape.bounds(), shape.krate);
    let (scalar, count) = (shape.scalar(), length(shape.fields.len()));
    let names = shape.fields.iter().map(|name| shape.written(name));
    let fields = places(&shape.number_fields());
    Some(quote! {
        #[automatically_derived]
        impl #bounds #krate::system::KernelSystem for #name #generics {
            type Parameters = [#scalar; #count];
            const KERNEL_F64: &'static ::core::primitive::str = Self::KERNEL_F64;
            const KERNEL_F32: &'static ::core::primitive::str = Self::KERNEL_F32;
            const PARAMETERS: &'static [&'static ::core::primitive::str] = &[#(#names),*];
            fn parameters(&self) -> [#scalar; #count] {
                [#(self.#fields),*]
            }
        }
    })
}
