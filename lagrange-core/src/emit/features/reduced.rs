//! Reduced types: documentation, and conversion of systems and states to the whole system and back.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::reconstruction::{Ignored, constructor, rate_of, rates_at, values_of};
use super::switches::{derived_shape, free_switches};
use crate::derive::Equations;
use crate::emit::base::attributes::{conditions, deprecated_exception, split_attributes};
use crate::emit::base::bindings::field_bindings;
use crate::emit::base::fields::{entries, places};
use crate::emit::base::lints::{looks_rounded, rounded_exception};
use crate::emit::base::refusal::{Refusal, report_refusal};
use crate::emit::base::shape::{Shape, doc, identifier, local};
use crate::model::{Model, Pinned, Reduced};
use lagrange_algebra::code::{Names, body};
use lagrange_algebra::formula::text;
use lagrange_algebra::program::{Labels, lower, optimise};
use lagrange_expr::diagnostics::Report;
use lagrange_language::syntax::ast::Declaration;

/// Maximum length of a value that documentation writes out.
const LONGEST_VALUE: usize = 60;

/// Returns the documented declarations of reduced types, in the order of their `reduce` statements.
pub fn reduced_declarations(declaration: &Declaration, reduced: &[Reduced]) -> Vec<Declaration> {
    let pairs = declaration.reductions().zip(reduced);
    let documented = pairs.map(|((syntax, docs), reduced)| {
        let summary = summary(declaration, reduced);
        declaration.reduced(syntax, reduced_attributes(declaration, docs, &summary))
    });
    documented.collect()
}

/// Returns the attributes of the whole system with different documentation.
pub(in crate::emit) fn reduced_attributes(
    declaration: &Declaration,
    docs: &TokenStream,
    summary: &[String],
) -> TokenStream {
    let (_, kept) = split_attributes(&declaration.attributes);
    let blank = (!docs.is_empty()).then(|| doc(""));
    let summary = summary.iter().map(|line| doc(line));
    quote!(#docs #blank #(#summary)* #(#kept)*)
}

fn summary(declaration: &Declaration, reduced: &Reduced) -> Vec<String> {
    let names = declaration.coordinates();
    let graph = &reduced.model.graph;
    let name = |pinned: &Pinned| names.get(pinned.coordinate).map_or("", |name| name.text.as_str());
    let value = |pinned: &Pinned| match text::definitions(graph, &[pinned.value], LONGEST_VALUE) {
        (abbreviations, texts) if abbreviations.is_empty() => texts.concat(),
        _ => "an expression of parameters".to_owned(),
    };
    let list = |all: &[Pinned], relation: &str| {
        let item = |pinned: &Pinned| format!("`{} {relation} {}`", name(pinned), value(pinned));
        all.iter().map(item).collect::<Vec<_>>().join(", ")
    };
    let (frozen, small) = (&reduced.reduction.frozen, &reduced.reduction.small);
    let frozen = (!frozen.is_empty()).then(|| format!("{} frozen", list(frozen, "=")));
    let nearby = (!small.is_empty()).then(|| format!("{} small", list(small, "≈")));
    let ignored = reduced.reduction.ignored.iter().map(|pinned| format!("`{}`", name(pinned)));
    let ignored = ignored.collect::<Vec<_>>().join(", ");
    let cyclic = (!ignored.is_empty()).then(|| format!("{ignored} ignored"));
    let parts = frozen.into_iter().chain(nearby).chain(cyclic).collect::<Vec<_>>().join(", ");
    let mut lines = vec![format!("Reduced from [`{}`]: {parts}.", declaration.name.text)];
    if !ignored.is_empty() {
        lines.extend(["".to_owned(), IGNORED[0].to_owned(), IGNORED[1].to_owned()]);
    }
    if !small.is_empty() {
        lines.extend(["".to_owned(), EXPANDED[0].to_owned(), EXPANDED[1].to_owned()]);
    }
    lines
}

const EXPANDED: [&str; 2] = [
    "Energies and dissipation are expanded to second order in what is small and its rates together, forces on",
    "it to first order. Outputs are exact.",
];

const IGNORED: [&str; 2] = [
    "Momenta of ignored coordinates are parameters, from which their velocities follow. The Lagrangian is the",
    "Routhian; energies are those of the whole system.",
];

/// Writes conversions between a system and a reduced type; `None` if a value is too large for the
/// scalar, which is reported.
pub fn conversions(
    (full, model, equations): (&Declaration, &Model, &Equations),
    (part, reduced, reduced_equations): (&Declaration, &Reduced, &Equations),
    krate: &TokenStream,
    report: &mut Report,
) -> Option<TokenStream> {
    let refused = |refusal: &Refusal| report_refusal(part, refusal, report);
    let full = derived_shape(full, krate, model, equations);
    let shape = derived_shape(part, krate, &reduced.model, reduced_equations);
    let state_methods = state_methods(&full, &shape, reduced).inspect_err(refused).ok()?;
    Some(items(&full, &shape, &state_methods))
}

/// Writes conversions without values, for a declaration with errors.
pub(in crate::emit) fn placeholder_conversions(full: &Shape<'_>, part: &Shape<'_>) -> TokenStream {
    let nothing = StateBody { statements: TokenStream::new(), fields: TokenStream::new(), is_rounded: false };
    items(full, part, &inherent_impl(full, part, &nothing, &nothing))
}

fn items(full: &Shape<'_>, part: &Shape<'_>, state_methods: &TokenStream) -> TokenStream {
    // The momenta of ignored coordinates only follow from a state.
    let of_whole = Ignored::of(full, part).is_empty().then(|| system_conversion(full, part));
    let systems = [of_whole, Some(system_conversion(part, full))].into_iter().flatten();
    let states = state_conversion(full, part);
    let scalar = part.scalar_path();
    let import = part.generics().is_empty().then(|| quote!(use #scalar;));
    let attributes = &full.declaration.attributes;
    let (conditions, deprecated) = (conditions(attributes), deprecated_exception(attributes));
    quote! {
        #conditions
        #deprecated
        const _: () = {
            #import
            #(#systems)*
            #states
            #state_methods
        };
    }
}

/// Writes a conversion that keeps parameters, inputs and the modes of contacts and friction.
fn system_conversion(from: &Shape<'_>, to: &Shape<'_>) -> TokenStream {
    let (source, target, generics, bounds) = (from.name(), to.name(), to.generics(), to.bounds());
    let system = local("system");
    let modes = to.fields_of_modes().map(identifier);
    let fields = to.number_identifiers().into_iter().chain(modes).collect::<Vec<_>>();
    let switches = free_switches(to);
    let marker = to.needs_marker().then(|| quote!(scalar: ::core::marker::PhantomData));
    quote! {
        #[automatically_derived]
        impl #bounds ::core::convert::From<&#source #generics> for #target #generics {
            #[inline]
            fn from(#system: &#source #generics) -> Self {
                Self { #(#fields: #system.#fields,)* #switches #marker }
            }
        }
    }
}

/// Writes a conversion of states that omits frozen coordinates.
fn state_conversion(full: &Shape<'_>, part: &Shape<'_>) -> TokenStream {
    let (source, target, generics) = (full.state_name(), part.state_name(), part.generics());
    let (state, full_fields, fields) = (local("state"), full.state_fields(), part.state_fields());
    let copied = full.copied_generics(&full_fields);
    let values = values_of(part, (full, &full_fields), &state);
    let entries = entries(&fields, &values);
    quote! {
        #[automatically_derived]
        impl #copied ::core::convert::From<#source #generics> for #target #generics {
            #[inline]
            fn from(#state: #source #generics) -> Self {
                Self { #(#entries),* }
            }
        }
    }
}

/// Writes the methods that need the values of coordinates, which may depend on parameters.
fn state_methods(full: &Shape<'_>, part: &Shape<'_>, reduced: &Reduced) -> Result<TokenStream, Refusal> {
    let (frozen, small) = (&reduced.reduction.frozen, &reduced.reduction.small);
    let ignored = Ignored::of(full, part);
    let expand = with_values(part, reduced, frozen, |state, values, zero| {
        let kept = values_of(full, (part, &part.state_fields()), state);
        let all_entries =
            kept.into_iter().enumerate().map(|(i, kept)| match pinned(frozen, values, i, full) {
                None => rate_of(&ignored, i, full).unwrap_or(kept),
                Some(value) => value.unwrap_or(zero).clone(),
            });
        let entries = entries(&full.state_fields(), &all_entries.collect::<Vec<_>>());
        quote!(#(#entries),*)
    })?;
    let state = local("state");
    let expand = expand.after(rates_at(&ignored, &quote!(#state)));
    let all = frozen.iter().chain(small).cloned().collect::<Vec<_>>();
    let deviation = with_values(part, reduced, &all, |state, values, zero| {
        let own = places(&full.state_fields()).into_iter().enumerate();
        let all_entries = own.map(|(i, place)| match pinned(&all, values, i, full) {
            None => rate_of(&ignored, i, full).map_or(zero.clone(), |rate| quote!(#state.#place - #rate)),
            Some(None) => quote!(#state.#place),
            Some(Some(value)) => quote!(#state.#place - #value),
        });
        let entries = entries(&full.state_fields(), &all_entries.collect::<Vec<_>>());
        quote!(#(#entries),*)
    })?;
    let own = part.state_name();
    let deviation = deviation.after(rates_at(&ignored, &quote!(#own::from(#state))));
    Ok(inherent_impl(full, part, &expand, &deviation))
}

/// Returns the value of an entry of the state, if the entry belongs to one of `all`; `Some(None)`
/// is a value of zero.
fn pinned<'v>(
    all: &[Pinned],
    values: &'v [Option<TokenStream>],
    entry: usize,
    full: &Shape<'_>,
) -> Option<Option<&'v TokenStream>> {
    let is_pinned = |coordinate| all.iter().position(|pinned| pinned.coordinate == coordinate);
    let Some(velocity) = entry.checked_sub(full.coordinates.len()) else {
        return Some(values.get(is_pinned(entry)?).and_then(Option::as_ref));
    };
    is_pinned(full.position_of(&full.velocities[velocity])?).map(|_| None)
}

/// Returns a body that computes values and puts them into a state of the whole system. `fields`
/// receives the state, the nonzero values, and zero.
fn with_values(
    part: &Shape<'_>,
    reduced: &Reduced,
    all: &[Pinned],
    fields: impl Fn(&Ident, &[Option<TokenStream>], &TokenStream) -> TokenStream,
) -> Result<StateBody, Refusal> {
    let mut graph = reduced.model.graph.clone();
    let mut roots = all.iter().map(|pinned| pinned.value).collect::<Vec<_>>();
    let is_zero = roots.iter().map(|&value| graph.is_zero(value)).collect::<Vec<_>>();
    roots.push(graph.number(0));
    let mut labels = Labels::default();
    all.iter().for_each(|pinned| labels.insert(pinned.value, "held"));
    let program = optimise(&lower(&graph, &roots, &labels), reduced.model.accuracy);
    let is_rounded = program.values().any(|(_, op)| looks_rounded(op));
    let (state, mut names) = (local("state"), Names::new(["state", "rates", "reduced", "t"]));
    let written = body(&program, graph.symbols(), &part.computed_with(), &mut names)
        .map_err(|error| Refusal::Constants(error.constants))?;
    let bindings = field_bindings(part, &reduced.model, &written.used, &mut names);
    let values = written.outputs.iter().zip(&is_zero);
    let values = values.map(|(value, is_zero)| (!is_zero).then(|| value.clone())).collect::<Vec<_>>();
    let zero = written.outputs.last().cloned().unwrap_or_default();
    let (statements, fields) = (&written.statements, fields(&state, &values, &zero));
    let krate = part.krate;
    let functions = written.functions.iter().map(|name| local(name));
    let functions = (!written.functions.is_empty()).then(|| quote!(use #krate::private::{#(#functions),*};));
    Ok(StateBody { statements: quote!(#functions #bindings #statements), fields, is_rounded })
}

/// Statements, and the fields of the returned state.
struct StateBody {
    statements: TokenStream,
    fields: TokenStream,
    /// True if the body contains rounded values of irrational constants.
    is_rounded: bool,
}

impl StateBody {
    /// Prepends a statement.
    fn after(mut self, statement: Option<TokenStream>) -> StateBody {
        self.statements = statement.into_iter().chain([self.statements]).collect();
        self
    }
}

fn inherent_impl(
    full: &Shape<'_>,
    part: &Shape<'_>,
    expand: &StateBody,
    deviation: &StateBody,
) -> TokenStream {
    let (name, generics, bounds) = (part.name(), part.generics(), part.bounds());
    let (whole, reduced, state) = (full.state_name(), part.state_name(), local("state"));
    let rounded = rounded_exception(expand.is_rounded || deviation.is_rounded);
    let constructor = constructor(full, part, !expand.fields.is_empty());
    let (expand, deviation) = (returning(&whole, expand), returning(&whole, deviation));
    let (scalar, time_name) = (part.scalar(), local("t"));
    let time = constructor.is_some().then(|| quote!(#time_name: #scalar,));
    let velocities = constructor.is_some().then(|| {
        quote! {
            /// Ignored coordinates have the velocities that follow from their momenta.
        }
    });
    let differences = constructor.is_some().then(|| {
        quote! {
            /// Velocities of ignored coordinates differ from those that follow from the momenta.
        }
    });
    let system = &full.declaration.name.text;
    let expand_docs = doc(&format!("State of [`{system}`] that belongs to a state of this system:"));
    let deviation_docs =
        doc(&format!("Deviation of a state of [`{system}`] from those that this system stands for:"));
    quote! {
        #rounded
        impl #bounds #name #generics {
            #constructor

            #expand_docs
            /// frozen coordinates have their values, and no velocity.
            #velocities
            #[must_use]
            #[inline]
            pub fn expand(&self, #time #state: #reduced #generics) -> #whole #generics {
                #expand
            }

            #deviation_docs
            /// differences from their values for coordinates that are frozen or small, their
            /// velocities, and zero for everything else. What is frozen is lost in the reduced
            /// state; of what is small, the third power is neglected in energies.
            #differences
            #[must_use]
            #[inline]
            pub fn deviation(&self, #time #state: #whole #generics) -> #whole #generics {
                #deviation
            }
        }
    }
}

fn returning(state: &Ident, StateBody { statements, fields, .. }: &StateBody) -> TokenStream {
    match fields.is_empty() {
        true => quote!(::core::unreachable!()),
        false => quote!(#statements #state { #fields }),
    }
}
