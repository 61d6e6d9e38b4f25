//! Unrequested products cost nothing, neither expressions nor emitted code.

use std::collections::BTreeMap;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::parse;
use quote::{ToTokens, quote};

/// A pendulum on a spring on a damped cart, so that no product is trivial.
const SYSTEM: &str = "
    param mc, mp, k, l0, c, g; coord x, r, theta; input u;
    let p = (x + r*sin(theta), -r*cos(theta));
    kinetic = 1/2*mc*dot(x)^2;
    gravity = (0, -g);
    body bob { mass: mp; center: p; }
    potential = spring_energy(k, r - l0);
    dissipation = 1/2*c*dot(x)^2; force x = u;
";

/// A bob on a boom in space, with a force whose point needs the names of all axes. Statements that
/// only products need also name parts of the equations.
const IN_SPACE: &str = "
    param m = 2, l = 1; gravity = (0, 0, -9.81);
    body bob { mass: m; inertia: (1, 1, 2); centroid: (0, 0, -l); }
    revolute q = ground to bob { axis: (1, 0, 0); }
    force (1, 2, 3) at bob.point(1, 2, 3);
";

/// An oscillator, which conserves its energy.
const CONSERVATIVE: &str = "param k = 1; coord x; kinetic = 1/2*dot(x)^2; potential = spring_energy(k, x);";

/// A cart that stops.
const STOPPING: &str = "coord x; kinetic = 1/2*dot(x)^2; force x = -x; event wall = x - 1, rising => stop;";

/// A derivation with some products.
struct Emission {
    expressions: usize,
    methods: BTreeMap<String, String>,
}

fn emission(declared: &str, wanted: &[Product]) -> Emission {
    let choices = Product::ALL.map(|product| match wanted.contains(&product) {
        true => product.name().to_owned(),
        false => format!("no {}", product.name()),
    });
    let text = format!("struct S; {declared} emit {{ {} }}", choices.join(", "));
    let system = parse(&text).unwrap_or_else(|report| panic!("{report}"));
    let derived = system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}"));
    let expressions = derived.model.graph.len();
    let items = derived.emit(&quote!(::lagrange)).unwrap_or_else(|report| panic!("{report}"));
    Emission { expressions, methods: methods(&syn::parse2(items).expect("valid Rust")) }
}

/// Returns the methods and constants of the emitted struct, by name.
fn methods(file: &syn::File) -> BTreeMap<String, String> {
    let mut methods = BTreeMap::new();
    for item in &file.items {
        let syn::Item::Const(scope) = item else { continue };
        let syn::Expr::Block(block) = &*scope.expr else { continue };
        for statement in &block.block.stmts {
            if let syn::Stmt::Item(syn::Item::Impl(implementation)) = statement
                && implementation.trait_.is_none()
                && implementation.self_ty.to_token_stream().to_string() == "S"
            {
                let named = implementation.items.iter().filter_map(|item| match item {
                    syn::ImplItem::Fn(method) => Some((&method.sig.ident, item)),
                    syn::ImplItem::Const(constant) => Some((&constant.ident, item)),
                    _ => None,
                });
                methods
                    .extend(named.map(|(name, item)| (name.to_string(), item.to_token_stream().to_string())));
            }
        }
    }
    methods
}

#[test]
fn a_product_adds_its_method_and_nothing_to_the_others() {
    for declared in [SYSTEM, IN_SPACE] {
        let bare = emission(declared, &[]);
        assert_eq!(bare.methods.keys().collect::<Vec<_>>(), ["acceleration", "rhs"]);
    }
    for product in Product::ALL.into_iter().filter(|product| !product.is_of_constraints()) {
        let (declared, needed) = (system_with(product), needed_by(product));
        let without = emission(declared, needed);
        let mut with = emission(declared, &[needed, &[product]].concat());
        for name in added_by(product) {
            assert!(with.methods.remove(name).is_some(), "{name}");
        }
        assert_eq!(with.methods, without.methods, "with {product:?}");
    }
}

/// Returns a system that can have a product.
fn system_with(product: Product) -> &'static str {
    match product {
        Product::Frames | Product::FrameJacobians => IN_SPACE,
        Product::Conserved | Product::Tests => CONSERVATIVE,
        Product::EventJacobian => STOPPING,
        _ => SYSTEM,
    }
}

/// Returns the methods and constants of a product.
fn added_by(product: Product) -> Vec<&'static str> {
    match product {
        Product::Kernel => vec!["KERNEL_F32", "KERNEL_F64"],
        Product::Latex => vec!["EQUATIONS_LATEX"],
        Product::ParameterJacobian => vec![product.name(), "PARAMETERS"],
        Product::Motion => vec!["bob_motion"],
        Product::Frames => vec!["bob_frame"],
        Product::FrameJacobians => vec!["bob_jacobian", "bob_bias_acceleration"],
        // These are traits.
        Product::Drawing | Product::Lanes | Product::Taylor => Vec::new(),
        Product::Tests => Vec::new(),
        Product::Regressor => vec![product.name(), "REGRESSOR_PARAMETERS", "regressor_parameters"],
        Product::Statements => vec!["STATEMENTS"],
        Product::Conserved => vec!["conserved_energy"],
        Product::Power => vec!["power_x", "power_dissipation", "power_balance"],
        _ => vec![product.name()],
    }
}

/// Returns the products on which another depends.
fn needed_by(product: Product) -> &'static [Product] {
    match product {
        Product::MomentumRates => &[Product::MassMatrix, Product::Momenta],
        _ => &[],
    }
}

#[test]
fn unrequested_products_are_not_derived() {
    // The other products are built from the expressions that lead to the accelerations.
    let [bare, with] =
        [vec![], vec![Product::InverseDynamics]].map(|products| emission(SYSTEM, &products).expressions);
    assert!(with > bare, "{with} expressions with inverse dynamics, {bare} without");
}
