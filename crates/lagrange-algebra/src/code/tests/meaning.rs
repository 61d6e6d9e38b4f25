//! Written code has the meaning of the program, to the bit.

use lagrange_math::sin_cos_each;
use proptest::prelude::{ProptestConfig, prop_assert, proptest};
use quote::quote;
use syn::{BinOp, Block, Expr, ExprIf, Lit, Local, Pat, PatSlice, PatTuple, Stmt, UnOp};

use super::{generic, side_by_side};
use crate::code::{Names, Scalar, body};
use crate::program::tests::random::{at, build, same_bits, steps};
use crate::program::tests::{letters, lowered};
use crate::program::{Program, integer_power, optimise, run};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary::ROWS;
use lagrange_expr::expr::{Function, Graph};
use lagrange_expr::functions::apply;

/// Runs emitted statements in double precision.
#[derive(Clone, Default)]
struct Machine {
    variables: HashMap<String, f64>,
}

impl Machine {
    fn statement(&mut self, statement: &Stmt) {
        let Stmt::Local(Local { pat, init: Some(init), .. }) = statement else { panic!("only `let`s") };
        match (pat, &*init.expr) {
            (Pat::Ident(name), value) => {
                let value = self.value(value);
                self.define(&name.ident.to_string(), value);
            }
            (Pat::Tuple(pair), Expr::Call(call)) => {
                let angle = self.value(&call.args[0]);
                self.define_pair(pair, angle.sin_cos());
            }
            (Pat::Slice(pairs), Expr::Call(call)) => {
                let Expr::Array(angles) = &call.args[0] else { panic!("no array") };
                let angles = angles.elems.iter().map(|angle| self.value(angle)).collect::<Vec<_>>();
                for (pair, angle) in pairs.elems.iter().zip(angles) {
                    let Pat::Tuple(pair) = pair else { panic!("no pair") };
                    self.define_pair(pair, sin_cos_each([angle])[0]);
                }
            }
            (Pat::Slice(kept), Expr::Block(part)) => self.part(kept, &part.block),
            _ => panic!("neither a name nor pairs nor a part"),
        }
    }

    /// Executes statements in a separate block, from which only the results remain known.
    fn part(&mut self, kept: &PatSlice, block: &Block) {
        let Some((Stmt::Expr(Expr::Array(given), None), statements)) = block.stmts.split_last() else {
            panic!("a part gives an array")
        };
        let mut inner = self.clone();
        statements.iter().for_each(|statement| inner.statement(statement));
        assert_eq!(kept.elems.len(), given.elems.len());
        for (name, value) in kept.elems.iter().zip(&given.elems) {
            self.define(&quote!(#name).to_string(), inner.value(value));
        }
    }

    fn define_pair(&mut self, names: &PatTuple, (sine, cosine): (f64, f64)) {
        for (name, value) in names.elems.iter().zip([sine, cosine]) {
            if !matches!(name, Pat::Wild(_)) {
                self.define(&quote!(#name).to_string(), value);
            }
        }
    }

    fn define(&mut self, name: &str, value: f64) {
        assert_eq!(self.variables.insert(name.to_owned(), value), None, "{name} is defined twice");
    }

    fn value(&self, expression: &Expr) -> f64 {
        match expression {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Float(float) => float.base10_parse().expect("a float"),
                Lit::Int(int) => int.base10_parse().expect("an exponent"),
                _ => panic!("no number"),
            },
            Expr::Path(path) => {
                let name = path.path.segments.last().expect("a name").ident.to_string();
                match name.as_str() {
                    "NAN" => f64::NAN,
                    "ZERO" => 0.0,
                    "ONE" => 1.0,
                    _ => *self.variables.get(&name).expect("defined before use"),
                }
            }
            Expr::Paren(inner) => self.value(&inner.expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => -self.value(&unary.expr),
            Expr::Binary(binary) => {
                let (left, right) = (self.value(&binary.left), self.value(&binary.right));
                match binary.op {
                    BinOp::Add(_) => left + right,
                    BinOp::Sub(_) => left - right,
                    BinOp::Mul(_) => left * right,
                    BinOp::Div(_) => left / right,
                    _ => panic!("no arithmetic"),
                }
            }
            Expr::Call(call) => {
                let Expr::Path(path) = &*call.func else { panic!("no path") };
                let name = path.path.segments.last().expect("a name").ident.to_string();
                call_function(
                    &name,
                    &call.args.iter().map(|argument| self.value(argument)).collect::<Vec<_>>(),
                )
            }
            Expr::If(choice) => self.choice(choice),
            Expr::Block(block) => self.block(&block.block),
            _ => panic!("unexpected expression"),
        }
    }

    fn choice(&self, choice: &ExprIf) -> f64 {
        let Expr::Binary(condition) = &*choice.cond else { panic!("no comparison") };
        let (left, right) = (self.value(&condition.left), self.value(&condition.right));
        let holds = match condition.op {
            BinOp::Lt(_) => left < right,
            BinOp::Le(_) => left <= right,
            BinOp::Gt(_) => left > right,
            BinOp::Ge(_) => left >= right,
            _ => panic!("no order relation"),
        };
        let (_, otherwise) = choice.else_branch.as_ref().expect("an else");
        if holds { self.block(&choice.then_branch) } else { self.value(otherwise) }
    }

    fn block(&self, block: &Block) -> f64 {
        let [Stmt::Expr(value, None)] = block.stmts.as_slice() else { panic!("more than a value") };
        self.value(value)
    }
}

fn call_function(name: &str, x: &[f64]) -> f64 {
    match name {
        "multiply_add" if cfg!(target_feature = "fma") => x[0].mul_add(x[1], x[2]),
        "multiply_add" => x[0] * x[1] + x[2],
        "reciprocal" => 1.0 / x[0],
        "powi" => integer_power(x[0], x[1] as i32),
        "from_f64" | "from_sum" => x[0],
        "if_less" if x[0] < x[1] => x[2],
        "if_less" if x[1] <= x[0] => x[3],
        "if_less_equal" if x[0] <= x[1] => x[2],
        "if_less_equal" if x[1] < x[0] => x[3],
        "if_less" | "if_less_equal" => f64::NAN,
        _ => (ROWS.iter().find(|row| row.rust == name).expect("a function of the language").value)(x),
    }
}

fn execute(graph: &Graph, program: &Program, scalar: &Scalar) -> Option<Vec<f64>> {
    let mut names = Names::default();
    let body = body(program, graph.symbols(), scalar, &mut names).ok()?;
    let mut machine = Machine::default();
    for &role in &body.used {
        machine.define(&names.role(graph.symbols(), role).to_string(), at(role, 0.0));
    }
    let statements = &body.statements;
    let block: Block = syn::parse2(quote!({ #statements })).expect("statements");
    block.stmts.iter().for_each(|statement| machine.statement(statement));
    let value = |output| machine.value(&syn::parse2(output).expect("an expression"));
    Some(body.outputs.into_iter().map(value).collect())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn emitted_code_computes_what_the_interpreter_computes(steps in steps()) {
        let (mut graph, parameters, coordinates) = letters();
        let outputs = build(&mut graph, &[parameters.as_slice(), &coordinates].concat(), &steps);
        let lowered = lowered(&graph, &outputs);
        let optimised = Accuracy::ALL.map(|accuracy| optimise(&lowered, accuracy));
        for program in optimised.into_iter().chain([lowered]) {
            let expected = run(&program, |role| at(role, 0.0));
            for scalar in [Scalar::F64, generic(), side_by_side()] {
                // Constants out of range are an error in the formula.
                let Some(written) = execute(&graph, &program, &scalar) else { return Ok(()) };
                prop_assert!(written.iter().zip(&expected).all(same_bits), "{written:?} for {expected:?}: {program:?}");
            }
        }
    }
}

#[test]
fn long_bodies_in_parts_compute_what_the_interpreter_computes() {
    let (mut graph, parameters, coordinates) = letters();
    let letters = [parameters.as_slice(), &coordinates].concat();
    // Every step uses the previous value, a much earlier one, and a pair of a sine and a cosine.
    let mut values = letters.clone();
    for step in 0..4000 {
        let (last, early) = (values[values.len() - 1], values[step * step % values.len()]);
        let angle = graph.subtract(last, letters[step % letters.len()]);
        let [sine, cosine] = [Function::Sin, Function::Cos].map(|f| apply(&mut graph, f, &[angle]));
        let product = graph.multiply(sine, early);
        values.push(graph.add(product, cosine));
    }
    let outputs = values[values.len() - 3..].iter().chain(&values[100..103]).copied().collect::<Vec<_>>();
    for accuracy in Accuracy::ALL {
        let program = optimise(&lowered(&graph, &outputs), accuracy);
        let body = body(&program, graph.symbols(), &Scalar::F64, &mut Names::default());
        let statements = body.expect("moderate numbers").statements;
        let block: Block = syn::parse2(quote!({ #statements })).expect("statements");
        assert!(block.stmts.len() > 2 && longest_block(&block) <= 1001);
        let expected = run(&program, |role| at(role, 0.0));
        let written = execute(&graph, &program, &Scalar::F64).expect("moderate numbers");
        assert!(written.iter().zip(&expected).all(same_bits), "{written:?} for {expected:?}");
    }
}

/// Returns the largest number of statements in a block of a body.
fn longest_block(block: &Block) -> usize {
    let inner = block.stmts.iter().map(|statement| match statement {
        Stmt::Local(Local { init: Some(init), .. }) => match &*init.expr {
            Expr::Block(part) => longest_block(&part.block),
            _ => 0,
        },
        _ => 0,
    });
    inner.max().unwrap_or(0).max(block.stmts.len())
}
