//! A printed declaration keeps its meaning: it is printed again alike, and the same code is emitted
//! for it.

use std::fs;
use std::path::Path;

use lagrange_core::bodies::plain;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::elaborate::elaborate;
use lagrange_core::expand::without_arrays;
use lagrange_core::inline::name_delays;
use lagrange_core::pipeline::System;
use lagrange_core::syntax::ast::{Declaration, Statement};
use lagrange_core::syntax::{parse_text, print};
use proptest::prelude::{prop_assert_eq, proptest};
use quote::quote;

use crate::machines::machines;
use crate::trees::trees;

pub(crate) fn read(text: &str) -> Declaration {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report);
    assert!(!report.has_errors(), "{text}\n{report}");
    declaration.expect("tokens")
}

/// Returns the code for a declaration, or its errors.
pub(crate) fn emitted(declaration: Declaration) -> Result<String, String> {
    let mut report = Report::default();
    let mut declaration = without_arrays(declaration, &mut report);
    name_delays(&mut declaration);
    let plain = plain(declaration, &mut report);
    let Some(model) = elaborate(&plain, &mut report) else { return Err(messages(&report)) };
    let system = System { declaration: plain.without(&model.implied), model, report };
    let derived = system.derive(StrategyChoice::Cheapest);
    match derived.and_then(|derived| derived.emit(&quote!(::lagrange))) {
        Ok(tokens) => Ok(tokens.to_string()),
        Err(report) => Err(messages(&report)),
    }
}

/// Returns the messages of a report without their locations.
fn messages(report: &Report) -> String {
    report.diagnostics().iter().map(|diagnostic| format!("{}\n", diagnostic.message)).collect()
}

/// Returns the declaration with its statements printed and read. Head and documentation are not
/// printed.
pub(crate) fn printed_and_read(declaration: &Declaration) -> Declaration {
    let again = read(&print::statements(declaration));
    assert_eq!(again.statements.len(), declaration.statements.len());
    let documented = again.statements.into_iter().zip(&declaration.statements);
    let documented = documented.map(|(new, old)| Statement { docs: old.docs.clone(), ..new });
    let (statements, expressions) = (documented.collect(), again.expressions);
    Declaration { statements, expressions, ..declaration.clone() }
}

#[test]
fn golden_declarations_are_printed_as_what_they_say() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let directories = fs::read_dir(root).expect("a directory").map(|entry| entry.expect("an entry").path());
    let mut count = 0;
    for directory in directories {
        let text = fs::read_to_string(directory.join("declaration.lag")).expect("a declaration");
        let declaration = read(&text);
        let again = printed_and_read(&declaration);
        assert_eq!(print::statements(&again), print::statements(&declaration), "{}", directory.display());
        let code = emitted(declaration).expect("a correct declaration");
        assert_eq!(emitted(again).as_ref(), Ok(&code), "{}", directory.display());
        count += 1;
    }
    assert!(count >= 11);
}

/// Bodies, connectors and joints of every kind.
pub(crate) const SCENE: &str = "
    param m = 1.0, l = 0.5, k = 3.0, c = 0.1, r = 0.2, g = 9.81;
    coord x, y, a, b, phi;
    gravity = (0, -g);
    body cart { mass: 2 * m; center: (x, 0); shape: rectangle(2 * r, r); }
    body rod { mass: m; origin: (x, y); angle: a; shape: slender_rod(l); }
    body wheel {
        origin: rod.point(l/2, 0) + (0, phi);
        angle: b;
        compound { disk(r), mass: m; hole disk(r/2), mass: m/4, at: (r/4, 0), angle: -pi/6; }
    }
    line floor { through: (0, -1); angle: 0.1; }
    line deck { on: cart; through: (0, r); }
    spring s { from: cart; to: rod.point(-l/2, 0); stiffness: k; rest: l; }
    spring { from: (0, 1); to: rod; stiffness: k; }
    damper { from: cart; to: wheel; damping: c; }
    torsion_spring { from: rod; to: wheel; stiffness: k; rest: pi/2; }
    torsion_damper { from: ground; to: rod; damping: c; }
    pin hinge = cart to rod.point(-l/2, 0);
    roll contact = wheel on floor, radius: r;
    circle bowl { on: cart; center: (0, 1); radius: 4 * r; }
    contact touch = rod.point(l/2, 0) inside bowl { radius: r; kinetic: 0.2; static: 0.3; restitution: 0.5; }
    contact tip = rod.corner(0) on deck { friction: 0.1; }
    force (1, 0) at rod.point(l/2, 0);
    torque 0.1 on rod;
    output strain = s.length;
    output speed = velocity(rod.point(l/2, 0));
    output load = hinge.force;
    output push = touch.force;";

/// Histories of one and of several entries, also in loops and parts.
const LATE: &str = "
    param w: 1/s = 2, lag: s = 0.1, x_rest: m = 0.5;
    coord x: m = 1, y[2]: m;
    history x = cos(w * t) * 1[m], y[0] = -(1 - w * t) * 2[m];
    for i in 1..2 { history y[i] = x_rest * i; }
    part Lag(k, lag) { state z = 1; history z = exp(-k * t / 1[s]); dot(z) = -k * delay(z, lag) / 1[s]; }
    lag_a: Lag { k: 1; lag: lag; }
    lag_b: Lag { k: 2; lag: 2 * lag; }
    kinetic = 1/2 * (dot(x)^2 + dot(y[0])^2 + dot(y[1])^2) * 1[kg];
    force x = -delay(x + y[0] + y[1], lag) * 1[N/m];";

#[test]
fn histories_are_printed_with_the_same_meaning() {
    let declaration = read(LATE);
    let again = printed_and_read(&declaration);
    let printed = print::statements(&declaration);
    assert!(printed.contains("history x = cos(w * t)"), "{printed}");
    assert_eq!(print::statements(&again), printed);
    let code = emitted(declaration).expect("a correct declaration");
    assert_eq!(emitted(again).as_ref(), Ok(&code));
    assert!(code.contains("signals_before"), "histories are emitted");
    // Without one of its histories the code is another one.
    let without = LATE.replace("history z = exp(-k * t / 1[s]);", "");
    assert_ne!(emitted(read(&without)).as_ref(), Ok(&code));
}

#[test]
fn expanded_bodies_are_printed_with_the_same_meaning() {
    let mut report = Report::default();
    let of_bodies = plain(read(SCENE), &mut report).declaration;
    assert!(!report.has_errors(), "{report}");
    let again = printed_and_read(&of_bodies);
    assert_eq!(print::statements(&again), print::statements(&of_bodies));
    let code = emitted(of_bodies).expect("a correct declaration");
    assert_eq!(emitted(again).as_ref(), Ok(&code));
    let code = emitted(read(SCENE)).expect("a correct declaration");
    assert_eq!(emitted(printed_and_read(&read(SCENE))).as_ref(), Ok(&code));
}

proptest! {
    #![proptest_config(crate::one_in(32))]

    #[test]
    fn random_machines_are_printed_as_what_they_say(machine in machines()) {
        let declaration = read(&machine.text);
        let again = printed_and_read(&declaration);
        prop_assert_eq!(print::statements(&again), print::statements(&declaration));
        prop_assert_eq!(emitted(again), emitted(declaration));
    }

    #[test]
    fn random_trees_are_printed_as_what_they_say(tree in trees()) {
        let declaration = read(&tree.text);
        prop_assert_eq!(emitted(printed_and_read(&declaration)), emitted(declaration));
    }
}
