//! Random declarations through the macro and the Rust compiler. Emitted code must compute the bits
//! of the interpreter, and these must agree with the energies, as judged by `compare`.
//!
//! The crate takes minutes to compile, so cases are taken on demand, numbered as all others:
//!
//! ```sh
//! LAGRANGE_COMPILED=48 cargo test -p lagrange-core --test systems compiled -- --nocapture
//! ```

use std::collections::BTreeMap;
use std::env;
use std::fmt::Write;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::parse;
use quote::quote;
use syn::{File, ImplItem, Item, ItemImpl, Type, Visibility};

use crate::compare::{Verdict, derived, found, verdict};
use crate::generate::{Case, case};
use crate::numbered::numbered;
use crate::project::project;
use crate::tree::Declaration;
use crate::world::State;

/// Results known to both, with the methods of emitted types for them, beside outputs.
const METHODS: [(&str, &str); 10] = [
    ("accelerations", "acceleration"),
    ("multipliers", "multipliers"),
    ("state rates", "rhs"),
    ("energy", "energy"),
    ("momenta", "momenta"),
    ("mass matrix", "mass_matrix"),
    ("forcing", "forcing"),
    ("kinetic energy", "kinetic_energy"),
    ("potential energy", "potential_energy"),
    ("inverse dynamics", "inverse_dynamics"),
];

/// The beginning of the crate: numbers of any shape, printed as bits.
const PRELUDE: &str = "#![allow(unused)]
pub trait Bits { fn print(&self); }
impl Bits for f64 { fn print(&self) { print!(\" {:x}\", self.to_bits()); } }
impl<T: Bits, const N: usize> Bits for [T; N] { fn print(&self) { self.iter().for_each(Bits::print); } }
pub fn line(case: usize, state: usize, method: &str, value: &dyn Bits) {
    print!(\"\\n= {case} {state} {method}\");
    value.print();
    println!();
}
";

/// Returns the methods of the emitted type, each with the number of its arguments.
fn methods(declaration: &Declaration) -> Result<Vec<(String, usize)>, String> {
    let emitted = parse(&declaration.to_string())
        .and_then(|system| system.derive(StrategyChoice::Cheapest))
        .and_then(|derived| derived.emit(&quote!(::lagrange)))
        .map_err(|report| report.to_string())?;
    let file = syn::parse2::<File>(emitted).map_err(|error| error.to_string())?;
    let mut methods = Vec::new();
    file.items.iter().for_each(|item| add_methods(item, &mut methods));
    Ok(methods)
}

fn add_methods(item: &Item, methods: &mut Vec<(String, usize)>) {
    match item {
        Item::Const(item) => {
            let syn::Expr::Block(block) = &*item.expr else { return };
            for statement in &block.block.stmts {
                if let syn::Stmt::Item(item) = statement {
                    add_methods(item, methods);
                }
            }
        }
        Item::Impl(ItemImpl { trait_: None, self_ty, items, .. }) => {
            let Type::Path(path) = &**self_ty else { return };
            let public = items.iter().filter_map(|item| match item {
                ImplItem::Fn(method) if matches!(method.vis, Visibility::Public(_)) => Some(&method.sig),
                _ => None,
            });
            if path.path.is_ident("Random") {
                methods.extend(public.map(|method| (method.ident.to_string(), method.inputs.len() - 1)));
            }
        }
        _ => {}
    }
}

/// Writes a module that prints the results of the emitted type at the states of a case.
fn module(number: usize, case: &Case) -> Result<String, String> {
    let declaration = case.declaration.to_string().replace("struct Random", "pub struct Random");
    let mut code =
        format!("mod case_{number} {{\nlagrange::system! {{\n{declaration}}}\n#[test] fn results() {{\n");
    let methods = methods(&case.declaration)?;
    for (index, (State { t, q, v }, a)) in case.states.iter().enumerate() {
        let y = [&q[..], v].concat();
        write!(code, "{{ let (t, q, v, a, y) = ({t:?}_f64, {q:?}, {v:?}, {a:?}, {y:?});").expect("a string");
        for (method, count) in &methods {
            let arguments = match method.as_str() {
                "rhs" => "t, &y".to_owned(),
                _ => ["t", "&q", "&v", "&a"][..*count].join(", "),
            };
            let is_known = METHODS.iter().any(|(_, known)| known == method) || method.starts_with("out");
            if is_known {
                let call = format!("Random::default().{method}({arguments})");
                writeln!(code, "crate::line({number}, {index}, {method:?}, &{call});").expect("a string");
            }
        }
        code += "}\n";
    }
    Ok(code + "}\n}\n")
}

/// Parses the output of the compiled crate: bits by case, state and method.
fn results(printed: &str) -> BTreeMap<(usize, usize, String), Vec<u64>> {
    let lines = printed.lines().filter_map(|line| line.strip_prefix("= "));
    let result = |line: &str| {
        let mut words = line.split(' ');
        let key = (words.next()?.parse().ok()?, words.next()?.parse().ok()?, words.next()?.to_owned());
        Some((key, words.map_while(|bits| u64::from_str_radix(bits, 16).ok()).collect()))
    };
    lines.filter_map(result).collect()
}

/// Compares the printed results of a case with the interpreter, and the interpreter with the
/// energies. Returns the number of compared values.
fn compared(
    number: usize,
    case: &Case,
    results: &BTreeMap<(usize, usize, String), Vec<u64>>,
) -> Result<usize, String> {
    let system = derived(&case.declaration, StrategyChoice::Cheapest)?;
    let (mut count, mut differences) = (0, String::new());
    for (index, state) in case.states.iter().enumerate() {
        if let Verdict::Differs(what) = verdict(&system, &case.declaration, state) {
            return Err(what);
        }
        let of_state = results.iter().filter(|((case, state, _), _)| (*case, *state) == (number, index));
        for ((_, _, method), compiled) in of_state {
            let name = METHODS.iter().find(|(_, known)| known == method);
            let name = name.map_or_else(|| format!("output {method}"), |(name, _)| (*name).to_owned());
            let interpreted = match name.as_str() {
                "state rates" => Some(system.rhs(state.0.t, &[&state.0.q[..], &state.0.v].concat())),
                _ => found(&system, state, &name, 0),
            };
            let interpreted = interpreted.ok_or_else(|| format!("the interpreter has no {name}"))?;
            let bits = |value: f64| if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() };
            let interpreted = interpreted.into_iter().map(bits).collect::<Vec<_>>();
            let compiled = compiled.iter().map(|&value| bits(f64::from_bits(value))).collect::<Vec<_>>();
            if compiled != interpreted {
                writeln!(
                    differences,
                    "state {index}, {name}: {compiled:x?} compiled, {interpreted:x?} interpreted"
                )
                .expect("a string");
            }
            count += compiled.len();
        }
    }
    if differences.is_empty() { Ok(count) } else { Err(differences) }
}

#[test]
fn compiled_code_computes_the_bits_of_the_interpreter() {
    if env::var("LAGRANGE_COMPILED").is_err() {
        return;
    }
    let cases = numbered("LAGRANGE_COMPILED", 0).map(|number| (number, case(number as u64)));
    let cases = cases.collect::<Vec<_>>();
    let modules = cases.iter().map(|(number, case)| module(*number, case));
    let modules = modules.collect::<Result<Vec<_>, _>>().expect("every case is derived");
    let code = format!("{PRELUDE}{}", modules.concat());
    let output = project("systems", &code)
        .args(["test", "--offline", "--", "--nocapture", "--test-threads=1"])
        .output();
    let output = output.expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let results = results(&String::from_utf8_lossy(&output.stdout));
    let compared = cases.iter().map(|(number, case)| {
        compared(*number, case, &results)
            .map_err(|what| format!("case {number}: {what}\n{}", case.declaration))
    });
    let (counts, failures): (Vec<_>, Vec<_>) = compared.partition(Result::is_ok);
    let values: usize = counts.into_iter().flatten().sum();
    println!("{} systems, {values} values with equal bits", cases.len());
    let failures = failures.into_iter().filter_map(Result::err).collect::<Vec<_>>();
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n\n"));
    assert!(values >= 10 * cases.len(), "each system has two states with accelerations and more");
}
