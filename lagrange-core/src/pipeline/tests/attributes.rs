//! Effects of the struct's attributes on all emitted items.

use proc_macro2::TokenStream;
use quote::quote;

use crate::pipeline::expand;

const BODY: &str = "param m = 1.0, lost = 2.0; coord x, y; kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = pi * x; reduce Part { freeze y = 0; }";

/// Returns the emitted items, with their attributes.
fn items(head: &str) -> Vec<syn::Item> {
    let tokens = format!("{head} {BODY}").parse::<TokenStream>().expect("tokens");
    syn::parse2::<syn::File>(expand(tokens, &quote!(::lagrange))).expect("items").items
}

fn attributes(item: &syn::Item) -> Vec<String> {
    let attributes = match item {
        syn::Item::Struct(item) => &item.attrs,
        syn::Item::Const(item) => &item.attrs,
        syn::Item::Macro(item) => &item.attrs,
        _ => panic!("an item of another kind is emitted, too"),
    };
    let shown = attributes.iter().map(|attribute| quote!(#attribute).to_string());
    shown.filter(|shown| !shown.starts_with("# [doc")).collect()
}

fn has(item: &syn::Item, text: &str) -> bool {
    attributes(item).iter().any(|attribute| attribute.contains(text))
}

fn name(item: &syn::Item) -> String {
    match item {
        syn::Item::Struct(item) => item.ident.to_string(),
        _ => "_".to_owned(),
    }
}

#[test]
fn conditions_hold_for_every_item() {
    for head in ["#[cfg(any())] struct Whole;", "#[cfg(any())] #[cfg(test)] struct Whole<S>;"] {
        let items = items(head);
        assert!(
            items.len() >= 10,
            "two types with states and columns, implementations, conversions, a warning"
        );
        for item in &items {
            assert!(has(item, "cfg (any ())"), "{}: {:?}", name(item), attributes(item));
            assert_eq!(has(item, "cfg (test)"), head.contains("test"));
        }
    }
    let wrong = items("#[cfg(any())] struct Whole; coord x = 1; force z = 2;");
    assert!(wrong.iter().any(|item| matches!(item, syn::Item::Macro(_))));
    assert!(wrong.iter().all(|item| has(item, "cfg (any ())")));
    assert!(items("struct Whole;").iter().all(|item| !has(item, "cfg")));
}

#[test]
fn emitted_items_may_use_a_deprecated_struct() {
    for item in items("#[deprecated] struct Whole;") {
        let makes_types = matches!(&item, syn::Item::Const(_)) && !has(&item, "dead_code");
        assert_eq!(has(&item, "allow (deprecated"), makes_types, "{:?}", attributes(&item));
    }
}

#[test]
fn expectations_are_of_what_fulfils_them() {
    let heads = [
        ("#[expect(unused_variables)]", "unused_variables"),
        ("#[expect(dead_code, unused_variables, reason = \"a test\")]", "unused_variables"),
        ("#[expect(unused)]", "unused"),
    ];
    for (attribute, lint) in heads {
        let items = items(&format!("{attribute} struct Whole;"));
        let expecting = items
            .iter()
            .filter(|item| attributes(item).iter().any(|one| one.contains("expect (") && one.contains(lint)));
        let expecting = expecting.collect::<Vec<_>>();
        assert_eq!(expecting.len(), 1, "{attribute}");
        assert!(has(expecting[0], "generated to warn"), "{attribute}: {:?}", attributes(expecting[0]));
        let of_struct = items.iter().find(|item| name(item) == "Whole").expect("the struct");
        assert!(has(of_struct, &format!("allow ({lint}")), "{attribute}: {:?}", attributes(of_struct));
        assert_eq!(has(of_struct, "expect (dead_code"), attribute.contains("dead_code"));
    }
    // Nothing is deprecated here, which the compiler reports.
    let items = items("#[expect(deprecated)] struct Whole;");
    let expecting = items.iter().filter(|item| has(item, "expect (deprecated")).collect::<Vec<_>>();
    assert!(matches!(expecting.as_slice(), [syn::Item::Const(_)]));
}

#[test]
fn only_the_struct_is_warned_of_for_its_name() {
    for (name_of_type, is_camel_case) in
        [("whole_thing", false), ("whole", false), ("Whole_Thing", false), ("Whole", true)]
    {
        for item in items(&format!("struct {name_of_type};")) {
            let is_companion = name(&item).starts_with(name_of_type) && name(&item) != name_of_type;
            assert_eq!(has(&item, "non_camel_case_types"), is_companion && !is_camel_case, "{}", name(&item));
        }
    }
}
