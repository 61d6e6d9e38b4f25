//! Planted faults: a reference in which a number is slightly different, or a term is missing, must
//! disagree.

use crate::compare::{Verdict, derived, is_visible, verdict};
use crate::generate::case;
use crate::tree::{Declaration, Expr, Statement, Values};

/// Relative change of numbers.
const CHANGE: f64 = 1e-9;
/// Cases in which faults are planted.
const CASES: u64 = if cfg!(debug_assertions) { 3 } else { 60 };
/// One in this many faults of a case is planted.
const SHARE: usize = 4;

/// Returns declarations with one fault each.
fn faulty(declaration: &Declaration) -> Vec<Declaration> {
    let mut found = Vec::new();
    for index in 0..declaration.statements.len() {
        let mut changed = declaration.clone();
        match &mut changed.statements[index] {
            Statement::Values { values: Values::One(value) | Values::All(_, value), .. } => {
                *value = off(value);
            }
            Statement::Energy(_, _) | Statement::Force(_, _) | Statement::ForceAt(_, _) => {
                changed.statements.remove(index);
            }
            Statement::Solve { residual, .. } => {
                let factor = Expr::Number(off("1"), None);
                let Expr::Binary(operator, rising, known) = residual.clone() else { continue };
                let known = crate::tree::multiply(factor, *known);
                *residual = Expr::Binary(operator, rising, Box::new(known));
            }
            Statement::Table(_, table) => {
                let (_, y) = &mut table.points[1];
                *y = off(y);
            }
            _ => continue,
        }
        found.push(changed);
    }
    found
}

fn off(decimal: &str) -> String {
    let value: f64 = decimal.parse().expect("a decimal");
    format!("{:e}", value * (1.0 + CHANGE))
}

/// All faults that affect the results of the reference are found, and many do. Others are
/// invisible: accelerations at one state are independent of the parameters of outputs, for example.
#[test]
fn planted_faults_are_found() {
    let (mut planted, mut visible, mut missed) = (0, 0, Vec::new());
    for number in 0..CASES {
        let case = case(number);
        let system = derived(&case.declaration, case.choice).unwrap_or_else(|report| panic!("{report}"));
        let state = &case.states[0];
        if !matches!(verdict(&system, &case.declaration, state), Verdict::Agrees(_)) {
            continue;
        }
        for faulty in faulty(&case.declaration).into_iter().step_by(SHARE) {
            planted += 1;
            if !is_visible(&case.declaration, &faulty, state) {
                continue;
            }
            visible += 1;
            if !verdict(&system, &faulty, state).differs() {
                missed.push(format!("case {number}:\n{faulty}"));
            }
        }
    }
    println!("{planted} faults, {visible} of them visible, {} missed", missed.len());
    assert!(missed.is_empty(), "{}", missed.join("\n"));
    assert!(visible * 3 > planted, "{visible} of {planted} show");
}
