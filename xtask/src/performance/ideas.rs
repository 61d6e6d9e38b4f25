//! The value of each idea of derivation and code generation: accelerations of chains with one idea
//! disabled, counted and written as functions.

use std::fs;
use std::path::Path;

use lagrange_core::accuracy::Accuracy;
use lagrange_core::code::{Names, Scalar, body};
use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::pipeline::{Derived, parse};
use lagrange_core::program::{Labels, OperationCounts, Pass, Program, lower, passes};
use lagrange_core::symbol::Role;

use super::undo::{divide_each, split_batches};

/// A variant of deriving and writing the accelerations.
pub(super) struct Idea {
    /// Title of the table row for the disabled idea; empty for the reference.
    pub(super) title: &'static str,
    pub(super) accuracy: Accuracy,
    strategy: StrategyChoice,
    change: Change,
}

/// The change to the passes.
#[derive(Clone, Copy)]
enum Change {
    Nothing,
    Without(&'static str),
    /// Adds this pass after the first one, which joins sines and cosines.
    With(fn(&Program) -> Program),
}

/// Returns all ideas. Ideas of a level follow their base.
pub(super) fn ideas() -> Vec<Idea> {
    use Accuracy::{Fast, Standard};
    use StrategyChoice::{Always, Cheapest};
    let idea = |title, accuracy, strategy, change| Idea { title, accuracy, strategy, change };
    vec![
        idea("", Standard, Cheapest, Change::Nothing),
        idea("mass matrix formed and factorised", Standard, Always(Strategy::MassMatrix), Change::Nothing),
        idea(
            "eliminated body by body, no squares kept",
            Standard,
            Always(Strategy::ArticulatedBody),
            Change::Nothing,
        ),
        idea("a division for each quotient", Standard, Cheapest, Change::With(divide_each)),
        idea("no fused multiply-adds", Standard, Cheapest, Change::Without("fuse multiply-adds")),
        idea("sines and cosines apart", Standard, Cheapest, Change::Without("pair sines and cosines")),
        idea("no schedule", Standard, Cheapest, Change::Without("schedule")),
        idea("", Fast, Cheapest, Change::Nothing),
        idea("`fast` without batches", Fast, Cheapest, Change::With(split_batches)),
    ]
}

impl Change {
    fn passes(self, accuracy: Accuracy) -> Vec<Pass> {
        let mut passes = passes(accuracy).to_vec();
        match self {
            Change::Nothing => {}
            Change::Without(name) => passes.retain(|pass| pass.name != name),
            Change::With(run) => passes.insert(1, Pass { name: "undo", run }),
        }
        passes
    }
}

/// A chain of the benchmarks.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Chain {
    pub(super) kind: &'static str,
    pub(super) links: usize,
}

impl Chain {
    pub(super) fn title(self) -> String {
        format!("{} {}", self.kind, self.links)
    }

    /// Returns the declaration, adapted from benches/.
    pub(super) fn declaration(self, root: &Path, accuracy: Accuracy) -> Result<String, String> {
        let path = root.join(format!("benches/chains/{}.lag", self.kind));
        let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let level = if accuracy == Accuracy::Fast { "#[accuracy(fast)]\n" } else { "" };
        let text = text.replace("n = N", &format!("n = {}", self.links));
        Ok(text.replace("struct Chain", &format!("{level}struct Chain")))
    }
}

/// The accelerations of a chain as a program.
pub(super) struct Derivation {
    derived: Derived,
    program: Program,
}

impl Derivation {
    pub(super) fn of(root: &Path, chain: Chain, idea: &Idea) -> Result<Derivation, String> {
        let text = chain.declaration(root, idea.accuracy)?;
        let derived = parse(&text).and_then(|system| system.derive(idea.strategy));
        let derived = derived.map_err(|report| report.to_string())?;
        let mut labels = Labels::default();
        for (expression, name) in &derived.equations.labels {
            labels.insert(*expression, name.as_str());
        }
        let lowered = lower(&derived.model.graph, &derived.equations.accelerations, &labels);
        let passes = idea.change.passes(idea.accuracy);
        let program = passes.iter().fold(lowered, |program, pass| (pass.run)(&program));
        Ok(Derivation { derived, program })
    }

    pub(super) fn operations(&self) -> usize {
        OperationCounts::of(&self.program).total()
    }

    /// Returns the Rust function `fn acceleration(parameters, q, v)`.
    pub(super) fn function(&self) -> Result<String, String> {
        let model = &self.derived.model;
        let symbols = model.graph.symbols();
        let mut names = Names::new(["parameters", "q", "v"]);
        let body =
            body(&self.program, symbols, &Scalar::F64, &mut names).map_err(|error| error.to_string())?;
        let mut pattern = |role: fn(u32) -> Role, count: usize| {
            let names = (0..count as u32).map(|i| match body.used.contains(&role(i)) {
                true => names.role(symbols, role(i)).to_string(),
                false => "_".to_owned(),
            });
            names.collect::<Vec<_>>().join(", ")
        };
        let (fields, n) = (model.parameters.len(), model.coordinates.len());
        let [p, q, v] =
            [pattern(Role::Parameter, fields), pattern(Role::Coordinate, n), pattern(Role::Velocity, n)];
        let functions = body.functions.iter().copied().collect::<Vec<_>>().join(", ");
        let outputs = body.outputs.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        Ok(format!(
            "use lagrange::private::{{{functions}}};\n\
             #[inline(never)]\n\
             pub(crate) fn acceleration(parameters: &[f64; {fields}], q: &[f64; {n}], v: &[f64; {n}]) -> [f64; {n}] {{\n\
             let [{p}] = *parameters; let [{q}] = *q; let [{v}] = *v;\n\
             {}\n[{outputs}]\n}}",
            body.statements
        ))
    }
}
