//! Tests of the rules on small made-up crates.

use crate::circles::circles;
use crate::homonyms::homonyms;
use crate::imports::Crate;
use crate::layers::{misplaced_modules, upward_imports};
use crate::tables::{Layer, Library};

/// Reads a crate of files with these paths and texts.
fn made_up(files: &[(&str, &str)]) -> Crate {
    let text_of = |path: &str| {
        let mut texts = files.iter().filter(|(name, _)| *name == path);
        texts.next().map(|(_, text)| (*text).to_owned())
    };
    Crate::read("made-up", "lib.rs", &text_of)
}

const A_BELOW_B: Library = Library {
    name: "made-up",
    layers: &[Layer { modules: &["a"], purpose: "" }, Layer { modules: &["b"], purpose: "" }],
};

#[test]
fn a_circle_is_found_through_a_reexport() {
    let krate = made_up(&[
        ("lib.rs", "mod a;\nmod b;"),
        ("a.rs", "use crate::b::Thing;\npub struct Part;"),
        ("b.rs", "mod thing;\npub use thing::Thing;"),
        ("b/thing.rs", "\npub struct Thing(crate::a::Part);"),
    ]);
    let expected =
        "made-up: 2 files in circles\n  a.rs → b/thing.rs (`Thing` at line 1) → a.rs (`Part` at line 2)";
    assert_eq!(circles(&krate), [expected]);
}

#[test]
fn a_module_and_its_children_are_no_circle() {
    let parent = "mod b;\nmod c;\npub use b::B;\npub struct A;\nimpl A { fn f(&self) { self.g() } }";
    let krate = made_up(&[
        ("lib.rs", "mod a;"),
        ("a/mod.rs", parent),
        ("a/b.rs", "pub struct B(super::A);\nimpl super::A { pub fn g(&self) { super::c::f() } }"),
        ("a/c.rs", "pub fn f() {}"),
    ]);
    assert_eq!(circles(&krate), [""; 0]);
    assert!(krate.imports.iter().any(|import| import.item == "A::g" && import.line == 5));
}

#[test]
fn siblings_and_grandchildren_are_a_circle() {
    let krate = made_up(&[
        ("lib.rs", "mod a;"),
        ("a.rs", "mod b; mod c; pub struct A;"),
        ("a/b.rs", "mod d; pub use d::f; use super::c::C; pub struct B;"),
        ("a/c.rs", "use super::b::B; pub struct C;"),
        ("a/b/d.rs", "pub fn f(_: crate::a::A) {}"),
    ]);
    assert_eq!(circles(&krate).len(), 1);
    let calls_grandchild = made_up(&[
        ("lib.rs", "mod a;"),
        ("a.rs", "mod b; pub struct A; fn g() { b::f(A) }"),
        ("a/b.rs", "mod d; pub use d::f;"),
        ("a/b/d.rs", "pub fn f(_: crate::a::A) {}"),
    ]);
    assert_eq!(circles(&calls_grandchild).len(), 1);
}

#[test]
fn a_circle_is_found_through_methods() {
    let krate = made_up(&[
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", "pub struct A;\nimpl A { pub fn f(&self) { self.g(); } pub fn h(&self) {} }"),
        ("b.rs", "use crate::a::A;\nimpl A { pub fn g(&self) { Self::h(self) } }"),
        ("c.rs", "use crate::a::A;\nfn k(a: &A) { assert!(a.g() == ()); }"),
    ]);
    let expected = "made-up: 2 files in circles\n  a.rs → b.rs (`A::g` at line 2) → a.rs (`A` at line 1)";
    assert_eq!(circles(&krate), [expected]);
    assert!(
        krate.imports.iter().any(|import| krate.files[import.from].path == "c.rs" && import.item == "A::g")
    );
}

#[test]
fn a_method_of_several_types_is_ambiguous() {
    let krate = made_up(&[
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", "pub struct A; impl A { pub fn size(&self) {} }"),
        ("b.rs", "pub struct B; impl B { pub fn size(&self) {} }"),
        ("c.rs", "fn f(a: impl Fn() -> crate::a::A) { a().size(); a().other(); a().len() }"),
    ]);
    assert_eq!(krate.ambiguous_calls, 1);
}

#[test]
fn receivers_are_known_by_what_declares_them() {
    let calls = "fn by_field(c: C) { c.a.g() } fn by_return() { f()?.g() } fn new() { A::new().g() }
        fn by_variable() { let (a, _) = (crate::a::f(), 1); a.g(); vec![a.g()] }
        fn by_name() { each(|a| a.g()) } fn hidden(a: &A) { each(|a| a.len()) }";
    let krate = made_up(&[
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", "pub struct A; pub fn f() -> Option<A> {} impl A { pub fn new() -> Self {} }"),
        ("b.rs", "impl crate::a::A { pub fn g(&self) {} pub fn len(&self) {} }"),
        ("c.rs", &format!("use crate::a::A; use crate::a::f; struct C {{ a: A }}\n{calls}")),
    ]);
    let calls = krate.imports.iter().filter(|import| krate.files[import.to].path == "b.rs");
    let calls = calls.map(|call| format!("{} {}", call.line, call.item)).collect::<Vec<_>>();
    assert_eq!(calls, ["2 A::g", "3 A::g", "4 .g()"]);
}

#[test]
fn upward_imports_are_found_by_name_and_by_what_they_lead_to() {
    let krate = made_up(&[
        ("lib.rs", "mod a;\nmod b;\npub use b::B;"),
        ("a.rs", "mod inner;\npub struct A;\nuse crate::B;\nfn f() -> B {}"),
        ("a/inner.rs", "use crate::b::A;"),
        ("b.rs", "pub use crate::a::A;\npub struct B;"),
    ]);
    let expected = ["a.rs:3 imports upward: `B` of b.rs", "a/inner.rs:1 imports upward: `b`"];
    assert_eq!(upward_imports(&krate, &A_BELOW_B), expected);
}

#[test]
fn a_module_does_not_pass_on_what_is_above() {
    let krate = made_up(&[
        ("lib.rs", "mod a; mod b;"),
        ("a.rs", "pub mod inner;\npub use inner::A;\npub use crate::b::B;"),
        ("a/inner.rs", "pub struct A;\npub use crate::b;"),
        ("b.rs", "pub struct B;"),
    ]);
    let expected = ["a.rs:3 imports upward: `B` of b.rs", "a/inner.rs:2 imports upward: `b`"];
    assert_eq!(upward_imports(&krate, &A_BELOW_B), expected);
}

#[test]
fn modules_of_one_layer_do_not_import_each_other() {
    let krate = made_up(&[
        ("lib.rs", "mod a; mod b; pub struct Root;"),
        ("a.rs", "pub struct A;"),
        ("b.rs", "use crate::a::A;\n#[cfg(test)] mod tests { use crate::Root; }"),
    ]);
    let one_layer = Library { name: "made-up", layers: &[Layer { modules: &["a", "b"], purpose: "" }] };
    let found = upward_imports(&krate, &one_layer);
    assert_eq!(found, ["b.rs:1 imports upward: `A` of a.rs"]);
    assert_eq!(upward_imports(&krate, &A_BELOW_B), [""; 0]);
}

#[test]
fn modules_do_not_import_from_the_root() {
    let krate =
        made_up(&[("lib.rs", "mod a; mod b; pub struct Root;"), ("a.rs", "use crate::Root;"), ("b.rs", "")]);
    assert_eq!(upward_imports(&krate, &A_BELOW_B), ["a.rs:1 imports upward: `Root` of lib.rs"]);
}

#[test]
fn every_module_has_one_place() {
    let krate = made_up(&[("lib.rs", "mod a; mod c;"), ("a.rs", ""), ("c.rs", "")]);
    let expected = ["made-up has no module `b`", "made-up: `c` is in 0 layers"];
    assert_eq!(misplaced_modules(&krate, &A_BELOW_B), expected);
}

#[test]
fn homonyms_are_types_of_several_files() {
    let krate = made_up(&[
        ("lib.rs", "mod a; mod b; trait Step { type Error; }"),
        ("a.rs", "\nstruct Step; struct Error; fn twice() {} mod inner { struct Error; }"),
        ("b.rs", "fn twice() {} #[cfg(test)] mod tests { struct Error; }"),
    ]);
    assert_eq!(homonyms(&krate), ["Step: a.rs:2, lib.rs:1"]);
}
