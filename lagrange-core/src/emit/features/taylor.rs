//! Taylor series of the motion: the coefficients of all orders at a state, in a loop over the
//! orders.
//!
//! Products of series are computed in groups of four, which fit vector registers
//! ([`Groups`]).

mod blocks;

use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};

use self::blocks::{acceleration_of, inverted, solved};
use super::series::{WithoutSeries, derived_series};
use super::tables::piece_name;
use crate::emit::base::members::{Members, Taylor};
use crate::emit::base::refusal::Refusal;
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::base::writer::MethodWriter;
use crate::model::Product;
use lagrange_algebra::code::{Names, Scalar};
use lagrange_algebra::program::{Op, Program, optimise};
use lagrange_algebra::series::{Groups, SeriesPrograms, Slot};
use lagrange_expr::symbol::{Role, Symbols};

/// Maximum number of groups whose sums share one loop; more would exhaust the registers.
const LOOP: usize = 4;
/// Maximum number of groups for numbers in lanes. Each takes 10 kB of a thread's stack.
const MAX_GROUPS_IN_LANES: usize = 32;

/// Writes the expansion of the motion, if it is requested.
pub(in crate::emit) fn write_taylor(writer: &mut MethodWriter<'_>) -> Result<(), Refusal> {
    if !writer.model.products.contains(&Product::Taylor) || writer.is_hopeless() {
        return Ok(());
    }
    let switches = &writer.equations.switches[..writer.shape.switches.len()];
    let programs =
        derived_series(writer.model, writer.equations, switches).map_err(WithoutSeries::refusal)?;
    if let Some(taylor) = written(writer, &programs) {
        writer.members.taylor = Some(taylor);
    }
    Ok(())
}

/// Writes the expansion; `None` if a constant is too large, which is recorded.
fn written(writer: &mut MethodWriter<'_>, programs: &SeriesPrograms) -> Option<Taylor> {
    let groups = Groups::new(programs);
    let is_in_lanes = groups.groups.len() <= MAX_GROUPS_IN_LANES && are_for_lanes(writer, programs);
    let initial = optimise(&programs.initial, writer.model.accuracy);
    let start = writer.lowered_program(&initial, is_in_lanes, |values| quote!([#(#values),*]));
    let next = newest(writer, programs, &groups, is_in_lanes)?;
    let inversion = if writer.model.constraints.is_empty() { "definite" } else { "new" };
    let scalar = if is_in_lanes {
        writer.shape.lanes_number().to_token_stream()
    } else {
        writer.shape.scalar().to_token_stream()
    };
    let body = expansion((writer.shape, &scalar), programs, &groups, inversion, (&start, &next));
    let followed =
        programs.arguments.iter().map(|argument| (argument.table.clone(), argument.axis)).collect();
    let (shared, groups) = (groups.shared.len(), groups.groups.len());
    Some(Taylor { shared, groups, followed, is_in_lanes, body })
}

/// True if the series are written for numbers in lanes, which cannot stop at the ends of pieces of
/// tables. Values of tables and solutions of equations are computed one by one.
fn are_for_lanes(writer: &MethodWriter<'_>, programs: &SeriesPrograms) -> bool {
    let mut all = [&programs.initial, &programs.expansion].into_iter().chain(&programs.correction);
    let is_opaque = |program: &Program| program.values().any(|(_, op)| matches!(op, Op::Opaque(..)));
    writer.members.lanes.is_some() && writer.shape.switches.is_empty() && !all.any(is_opaque)
}

/// A block with the values of a program of a step.
struct Step {
    block: TokenStream,
    /// True if it calls `multiply_add`.
    has_product_sums: bool,
}

/// Returns a block with the stored values of one order.
fn newest(
    writer: &mut MethodWriter<'_>,
    programs: &SeriesPrograms,
    groups: &Groups,
    is_in_lanes: bool,
) -> Option<Step> {
    let scalar = if is_in_lanes { writer.shape.lanes_computed_with() } else { writer.shape.computed_with() };
    let expansion = step(writer, programs, groups, (&programs.expansion, &scalar))?;
    let Some(correction) = &programs.correction else { return Some(expansion) };
    let correction = step(writer, programs, groups, (correction, &scalar))?;
    let has_product_sums = expansion.has_product_sums || correction.has_product_sums;
    let [expansion, correction] = [expansion, correction].map(|step| step.block);
    let unknowns = writer.model.speeds.len() + writer.model.constraints.len();
    let [partial, acceleration, velocity, order] =
        ["partial", "acceleration", "velocity", "present"].map(local);
    let solved = solved(programs, &partial);
    let accelerations = (0..unknowns).map(acceleration_of);
    let block = quote!({
        let #partial = #expansion;
        #solved
        let #acceleration = [#(#accelerations),*];
        let #velocity = #order.divide(&#acceleration);
        #correction
    });
    Some(Step { block, has_product_sums })
}

/// Returns the loop over the orders.
fn expansion(
    (shape, scalar): (&Shape<'_>, &TokenStream),
    programs: &SeriesPrograms,
    groups: &Groups,
    inversion: &str,
    (start_values, step): (&TokenStream, &Step),
) -> TokenStream {
    let (krate, all) = (shape.krate, shape.state_length());
    let [start, now, next, sum] = ["start", "now", "next", "sum"].map(local);
    let [order, integral, k] = ["present", "integral", "k"].map(local);
    let [series, coefficients, newest] = ["series", "coefficients", "newest"].map(local);
    let factors = |side: &[[usize; 4]]| {
        let of_group = |places: &[usize; 4]| {
            let places = places.map(length);
            quote!([#(#next[#places]),*])
        };
        let all = side.iter().map(of_group);
        quote!([#(#all),*])
    };
    let [of_shared, of_groups] = [&groups.shared, &groups.groups].map(|side| factors(side));
    let shared = groups.of_group.iter().map(|&place| length(place)).collect::<Vec<_>>();
    let loops = shared.chunks(LOOP).enumerate().map(|(index, shared)| {
        let (count, group) = (length(shared.len()), length(index * LOOP));
        quote!(#series.add_up::<FUSED, #count>(#k, #group, [#(#shared),*]);)
    });
    let places = |(kept, initial): &(usize, usize)| (length(*kept), length(*initial));
    let (kept, initial): (Vec<_>, Vec<_>) = programs.carried.iter().map(places).unzip();
    let carried = length(programs.carried.len());
    let inverted = inverted(krate, programs, inversion);
    let Step { block: next_values, has_product_sums } = step;
    let product_sums = has_product_sums.then(|| {
        let multiply_add = local("multiply_add");
        quote! {
            let #multiply_add = |factor: #scalar, other: #scalar, addend: #scalar| match FUSED {
                true => #krate::Number::fused_multiply_add(factor, other, addend),
                false => #multiply_add(factor, other, addend),
            };
        }
    });
    let (starts, all_kept) = (length(programs.initial.outputs().len()), length(programs.kept));
    let [follow, keep_arguments] = followed(programs);
    quote! {
        let #start: [#scalar; #starts] = { #start_values };
        #inverted
        #product_sums
        #series.begin();
        #follow
        let mut #newest = <Self::Series>::NONE;
        let mut #now: [#scalar; #carried] = [#(#start[#initial]),*];
        for (#k, #coefficients) in #coefficients.iter_mut().enumerate() {
            let #order = #krate::private::Order::<#scalar>::after(#k);
            let #integral = #order.divide(&#now);
            #(#loops)*
            let #sum = #series.sums::<FUSED>([#(#shared),*], &#newest);
            let #next: [#scalar; #all_kept] = #next_values;
            #newest = (#of_shared, #of_groups);
            #series.keep(#k, &#newest);
            #keep_arguments
            #now = [#(#next[#kept]),*];
            #coefficients.copy_from_slice(&#next[..#all]);
        }
    }
}

/// Returns statements that start to track the arguments of tables, and that store their newest
/// coefficients.
fn followed(programs: &SeriesPrograms) -> [Option<TokenStream>; 2] {
    let [series, start, next, k] = ["series", "start", "next", "k"].map(local);
    let starts = programs.arguments.iter().map(|argument| {
        let place = length(argument.initial);
        quote!(#start[#place])
    });
    let starts = starts.collect::<Vec<_>>();
    let pieces = programs.arguments.iter().map(|argument| piece_name(&argument.table, argument.axis));
    let kept = programs.arguments.iter().map(|argument| length(argument.kept));
    let follow = quote!(#series.follow([#(#starts),*], [#(#pieces(#starts)),*]););
    let keep = quote!(#series.keep_arguments(#k, [#(#next[#kept]),*]););
    [follow, keep].map(|statement| (!starts.is_empty()).then_some(statement))
}

/// Returns a block with the outputs of the program of a step.
fn step(
    writer: &mut MethodWriter<'_>,
    programs: &SeriesPrograms,
    groups: &Groups,
    (program, scalar): (&Program, &Scalar),
) -> Option<Step> {
    let program = optimise(program, writer.model.accuracy);
    let mut names = Names::new(ARRAYS);
    for (index, slot) in programs.slots.iter().enumerate() {
        names.assign(Role::Placeholder(index as u32), &variable(*slot));
    }
    let body = writer.lowered_apart(&program, scalar, &mut names)?;
    let symbols = Symbols::default();
    let bindings = body.used.iter().filter_map(|&role| {
        let Role::Placeholder(index) = role else { return None };
        let (slot, variable) = (programs.slots[index as usize], names.role(&symbols, role));
        let (array, place) = match source(slot) {
            Source::Array(array, place) => (local(array), place),
            Source::Order(field) => {
                let (order, field) = (local("present"), format_ident!("{field}"));
                return Some(quote!(let #variable = #order.#field;));
            }
        };
        if let Slot::Sum(index) = slot {
            let [group, lane] = groups.of_product[index].map(length);
            return Some(quote!(let #variable = #array[#group][#lane];));
        }
        let place = length(place);
        Some(quote!(let #variable = #array[#place];))
    });
    let bindings = bindings.collect::<TokenStream>();
    let (statements, outputs) = (body.statements, body.outputs);
    let block = quote!({ #bindings #statements [#(#outputs),*] });
    Some(Step { block, has_product_sums: body.functions.contains("multiply_add") })
}

/// Arrays in the loop over the orders.
const ARRAYS: [&str; 8] = ["start", "sum", "now", "integral", "partial", "acceleration", "velocity", "next"];

/// The place of a slot in the loop over the orders.
enum Source {
    /// An array and an index.
    Array(&'static str, usize),
    /// A field of the order.
    Order(&'static str),
}

fn source(slot: Slot) -> Source {
    match slot {
        Slot::Initial(index) => Source::Array("start", index),
        Slot::Carried(index) => Source::Array("now", index),
        Slot::Integral(index) => Source::Array("integral", index),
        Slot::Sum(index) => Source::Array("sum", index),
        Slot::Partial(index) => Source::Array("partial", index),
        Slot::Acceleration(index) => Source::Array("acceleration", index as usize),
        Slot::Velocity(index) => Source::Array("velocity", index as usize),
        Slot::Order => Source::Order("number"),
        Slot::Reciprocal => Source::Order("reciprocal"),
        Slot::First => Source::Order("first"),
    }
}

/// Returns the variable that holds a slot.
fn variable(slot: Slot) -> String {
    match source(slot) {
        Source::Array(array, place) => format!("{array}_{place}"),
        Source::Order("number") => "order".to_owned(),
        Source::Order(field) => field.to_owned(),
    }
}

/// Implements `TaylorSystem`, if series are requested.
pub(in crate::emit) fn taylor_impl(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let taylor = members.taylor.as_ref()?;
    let (name, generics, bounds, krate) = (shape.name(), shape.generics(), shape.bounds(), shape.krate);
    let (scalar, all) = (shape.scalar(), shape.state_length());
    let reach = (!taylor.followed.is_empty()).then(|| {
        quote! {
            fn reach(series: &Self::Series, h: #scalar) -> #scalar {
                series.reach(h)
            }
        }
    });
    let (time, state) = (&members.names.time, &members.names.state);
    let [series, coefficients] = ["series", "coefficients"].map(local);
    let (products, own) = (products(krate, &scalar.to_token_stream(), taylor), &taylor.body);
    let groups = length(taylor.groups);
    let in_lanes = taylor.is_in_lanes.then(|| {
        quote!(
            const IN_LANES: ::core::primitive::bool = true;
        )
    });
    let of_lanes = quote! {
        let lanes = #krate::system::LanesSystem::lanes(self, |number| number);
        #krate::system::Equations::expand::<FUSED>(&lanes, #time, #state, #series, #coefficients);
    };
    let body = if taylor.is_in_lanes { &of_lanes } else { own };
    Some(quote! {
        #[automatically_derived]
        impl #bounds #krate::system::TaylorSystem for #name #generics {
            type Series = #products;
            #in_lanes
            fn series() -> Self::Series {
                #krate::private::Products::EMPTY
            }
            #[inline]
            fn product_groups(&self) -> ::core::primitive::usize {
                #groups
            }
            // Compiled once for each instruction set that the method selects from.
            #[inline(always)]
            fn expand<const FUSED: ::core::primitive::bool>(
                &self,
                #time: #scalar,
                #state: &[#scalar; #all],
                #series: &mut Self::Series,
                #coefficients: &mut [[#scalar; #all]],
            ) {
                #body
            }
            #reach
        }
    })
}

/// Returns the storage for products of series of these numbers.
fn products(krate: &TokenStream, number: &TokenStream, taylor: &Taylor) -> TokenStream {
    let [shared, groups, followed] = [taylor.shared, taylor.groups, taylor.followed.len()].map(length);
    quote!(#krate::private::Products<#number, #shared, #groups, #followed>)
}

/// Returns the members of `Equations` for series of numbers in lanes.
pub(in crate::emit) fn series_in_lanes(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let Some(taylor) = members.taylor.as_ref().filter(|taylor| taylor.is_in_lanes) else {
        return quote!(
            type Series = ();
        );
    };
    let (number, all) = (shape.lanes_number().to_token_stream(), shape.state_length());
    let (time, state, body) = (&members.names.time, &members.names.state, &taylor.body);
    let [series, coefficients] = ["series", "coefficients"].map(local);
    let products = products(shape.krate, &number, taylor);
    quote! {
        type Series = #products;
        #[inline(always)]
        fn expand<const FUSED: ::core::primitive::bool>(
            &self,
            #time: #number,
            #state: &[#number; #all],
            #series: &mut Self::Series,
            #coefficients: &mut [[#number; #all]],
        ) {
            #body
        }
    }
}
