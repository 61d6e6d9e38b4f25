//! Every product has a hint for where it is not emitted, and a line in the description of the
//! language.

use lagrange_core::model::{Availability, Extent, Product, ProductArguments, ProductMethod, ProductShape};

const HINTS: &str = include_str!("../../src/private/hints.rs");
const LANGUAGE: &str = include_str!("../../src/language.md");

/// Returns the name of the member that a product adds to the emitted type. Products of bodies add
/// no member of that name.
fn member(product: Product) -> Option<&'static str> {
    match product {
        Product::Kernel => Some("KERNEL_F64"),
        Product::Latex => Some("EQUATIONS_LATEX"),
        Product::Statements => Some("STATEMENTS"),
        Product::Conserved
        | Product::Power
        | Product::Tests
        | Product::Motion
        | Product::Frames
        | Product::FrameJacobians
        | Product::Drawing => None,
        product => Some(product.name()),
    }
}

/// Returns the advice that a hint must contain.
fn advice(product: Product) -> String {
    let name = product.name();
    match product.row().when {
        Availability::Always | Availability::SeparateEnergies => {
            format!("take `no {name}` out of its `emit {{{{ … }}}}`")
        }
        Availability::Constraints => "systems with constraints emit it".to_owned(),
        Availability::Demand | Availability::Events | Availability::With(_) | Availability::Bodies => {
            format!("add `emit {{{{ {name} }}}}` to the declaration")
        }
    }
}

#[test]
fn every_product_has_a_hint_where_it_is_not_emitted() {
    let (rows, imports) = HINTS.split_once("macro_rules! __hints").expect("a macro at the end");
    for product in Product::ALL {
        let Some(member) = member(product) else { continue };
        let message = format!("does not emit `{member}`\"");
        let (before, hint) = rows.split_once(&message).unwrap_or_else(|| panic!("no hint for {member}"));
        let (hint, _) = hint.split_once(';').expect("the end of the row");
        assert!(hint.contains(&advice(product)), "{member}: {hint}");
        let (_, row) = before.rsplit_once("pub trait Emits").expect("the beginning of the row");
        let items = [format!(" for fn {member} in "), format!(" for const {member} in ")];
        let end = items.iter().find_map(|item| row.split_once(item)).map(|(_, end)| end);
        let (name, _) = end.and_then(|end| end.split_once(':')).unwrap_or_else(|| panic!("{member}: {row}"));
        assert!(imports.contains(&format!(" {name} as _")), "{name} is not brought into scope");
    }
}

fn arguments(method: &ProductMethod) -> &'static str {
    match method.arguments {
        ProductArguments::Configuration | ProductArguments::Positions => "t, q",
        ProductArguments::State => "t, q, v",
        ProductArguments::Motion => "t, q, v, a",
        ProductArguments::Whole => "t, y",
    }
}

fn size(extent: Extent) -> &'static str {
    match extent {
        Extent::Velocities => "N",
        Extent::State | Extent::Tangent => "2N",
        Extent::Constraints => "M",
        Extent::Fields => "P",
        Extent::Regressed => "K",
        Extent::Axes => "3",
        Extent::Motions => "6",
        Extent::Events => "E",
        Extent::StateAndTime => "2N + 1",
        Extent::LinearColumns => "2N + K",
        Extent::LinearRows => "2N + L + M",
    }
}

fn returned(method: &ProductMethod) -> String {
    match method.returns {
        ProductShape::Scalar => "`S`".to_owned(),
        ProductShape::Vector(length) => format!("`[S; {}]`", size(length)),
        ProductShape::Matrix(rows, columns) => format!("`[[S; {}]; {}]`", size(columns), size(rows)),
    }
}

#[test]
fn the_description_of_the_language_has_a_line_for_every_product() {
    for product in Product::ALL {
        let row = product.row();
        let is_on_demand = match row.when {
            Availability::Always | Availability::SeparateEnergies | Availability::Constraints => false,
            Availability::Demand | Availability::Events | Availability::With(_) | Availability::Bodies => {
                true
            }
        };
        let first = if is_on_demand { format!("| `{}`", row.name) } else { format!("| `{}(", row.name) };
        let line = LANGUAGE.lines().find(|line| line.starts_with(&first));
        let line = line.unwrap_or_else(|| panic!("no line for {}", row.name));
        if let Some(method) = &row.method {
            let call = format!("`{}({})`", row.name, arguments(method));
            assert!(line.contains(&call) && line.contains(&returned(method)), "{call}: {line}");
        } else if let Some(member) = member(product) {
            assert!(line.contains(&format!("`{member}`")), "{member}: {line}");
        }
    }
}
