//! Order of the values in a step: each follows the values of the same step that it depends on.

use super::kinds::{Kind, NoSeries, kinds, reason};
use super::{Entry, Motion, Rate};
use crate::program::{Op, Program, ValueId, ValueTable};
use lagrange_expr::collections::{HashMap, HashSet};
use lagrange_expr::elementary::row;
use lagrange_expr::expr::Function;
use lagrange_expr::symbol::Role;

/// Kinds and rates of the values of a motion, and the order of their computation.
pub(super) struct Schedule {
    pub(super) kinds: ValueTable<Kind>,
    /// Rates of entries of the state.
    entries: HashMap<ValueId, Rate>,
    /// Rates of values of functions.
    functions: HashMap<ValueId, ValueId>,
    /// Values whose rates are represented by placeholders.
    unexpanded: HashMap<ValueId, ValueId>,
    /// Accelerations that are functions of the state, by their symbols.
    accelerations: HashMap<Role, ValueId>,
    /// Values with coefficients of every order.
    pub(super) order: Vec<ValueId>,
}

/// Source of the newest coefficient of a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Source {
    /// Time.
    Time,
    /// The integral of another value.
    Integral(ValueId),
    /// The integral of an unknown acceleration.
    Velocity(u32),
    /// An unknown acceleration or multiplier.
    Acceleration(u32),
    /// The rate of another value.
    Rate(ValueId),
    /// Another value, one order below its newest.
    Previous(ValueId),
    /// Its operands.
    Operands,
}

/// Returns the name of the function that an operation calls, unless it has its own recurrence.
fn called(op: &Op) -> Option<&str> {
    match op {
        Op::Call(Function::Sqrt, _) => None,
        Op::Call(function, _) => Some(row(*function).name),
        Op::Power(..) => Some(row(Function::Power).name),
        Op::Opaque(function, _) => Some(&function.function().name),
        _ => None,
    }
}

/// Returns the acceleration of a velocity as a function of the state.
fn explicit(program: &Program, entry: &Entry) -> Option<(Role, ValueId)> {
    match (program.op(entry.value), entry.rate) {
        (Op::Input(Role::Velocity(index)), Rate::Value(rate)) => Some((Role::Acceleration(*index), rate)),
        _ => None,
    }
}

impl Schedule {
    pub(super) fn new(motion: &Motion<'_>) -> Result<Schedule, NoSeries> {
        let program = motion.program;
        let placeholder = |value: ValueId| match program.op(value) {
            Op::Input(role) => motion.unexpanded.iter().find(|(known, _)| known == role).map(|(_, of)| *of),
            _ => None,
        };
        let unexpanded = program.values().filter_map(|(id, _)| Some((id, placeholder(id)?)));
        let mut schedule = Schedule {
            kinds: kinds(program),
            entries: motion.state.iter().map(|entry| (entry.value, entry.rate)).collect(),
            functions: motion.rates.iter().copied().collect(),
            unexpanded: unexpanded.collect(),
            accelerations: motion.state.iter().filter_map(|entry| explicit(program, entry)).collect(),
            order: Vec::new(),
        };
        let entries = motion.state.iter().map(|entry| entry.value);
        let roots = entries.chain(motion.residuals.iter().copied()).collect::<Vec<_>>();
        schedule.order = schedule.sorted(motion, &schedule.needed(motion, &roots)?);
        Ok(schedule)
    }

    /// Returns the source of the newest coefficient of a value that is not fixed.
    pub(super) fn source(&self, motion: &Motion<'_>, value: ValueId) -> Source {
        if let Some(rate) = self.entries.get(&value) {
            return match *rate {
                Rate::Value(rate) => Source::Integral(rate),
                Rate::Acceleration(index) => Source::Velocity(index),
            };
        }
        if let Some(rate) = self.functions.get(&value) {
            return Source::Integral(*rate);
        }
        if let Some(of) = self.unexpanded.get(&value) {
            return Source::Rate(*of);
        }
        match motion.program.op(value) {
            Op::Input(role @ Role::Acceleration(index)) => self
                .accelerations
                .get(role)
                .map_or(Source::Acceleration(*index), |&known| Source::Previous(known)),
            Op::Input(Role::Multiplier(index)) => {
                Source::Acceleration(motion.unknown_accelerations() + index)
            }
            Op::Input(_) => Source::Time,
            _ => Source::Operands,
        }
    }

    /// Returns the values that are not fixed and from which another one is computed, in this step
    /// or an earlier one.
    fn inputs(&self, motion: &Motion<'_>, value: ValueId) -> Vec<ValueId> {
        let mut inputs = Vec::new();
        match self.source(motion, value) {
            Source::Time | Source::Velocity(_) | Source::Acceleration(_) => {}
            Source::Integral(of) | Source::Rate(of) | Source::Previous(of) => inputs.push(of),
            Source::Operands => match motion.program.op(value) {
                Op::Select { then, otherwise, .. } => inputs.extend([*then, *otherwise]),
                op => op.for_each_operand(|operand| inputs.push(operand)),
            },
        }
        if let Op::Opaque(function, arguments) = motion.program.op(value)
            && function.table().is_some()
        {
            inputs.extend(arguments);
        }
        inputs.retain(|&input| self.kinds[input] != Kind::Fixed);
        inputs
    }

    /// Returns the inputs that must be computed before the value in the same step.
    fn inputs_of_this_step(&self, motion: &Motion<'_>, value: ValueId) -> Vec<ValueId> {
        let mut inputs = self.inputs(motion, value);
        let newest = match self.source(motion, value) {
            Source::Integral(_) => Kind::Accelerated,
            Source::Rate(_) => Kind::Moving,
            Source::Previous(_) => return Vec::new(),
            _ => self.kinds[value],
        };
        inputs.retain(|&input| self.kinds[input] == newest);
        inputs
    }

    /// Returns everything that is computed for these values.
    fn needed(&self, motion: &Motion<'_>, roots: &[ValueId]) -> Result<Vec<ValueId>, NoSeries> {
        let mut found = HashSet::default();
        let mut pending = roots.to_vec();
        let mut needed = Vec::new();
        pending.retain(|&root| self.kinds[root] != Kind::Fixed);
        while let Some(value) = pending.pop() {
            if !found.insert(value) {
                continue;
            }
            if self.kinds[value] == Kind::Unknown {
                return Err(reason(motion.program, &self.kinds, value));
            }
            if let Some(name) = called(motion.program.op(value)).filter(|_| !self.functions.contains(&value))
            {
                return Err(NoSeries::Function(name.to_owned()));
            }
            pending.extend(self.inputs(motion, value));
            needed.push(value);
        }
        needed.sort_unstable();
        Ok(needed)
    }

    fn sorted(&self, motion: &Motion<'_>, needed: &[ValueId]) -> Vec<ValueId> {
        let (mut begun, mut done) = (HashSet::default(), HashSet::default());
        let mut order = Vec::with_capacity(needed.len());
        for &root in needed {
            let mut pending = vec![root];
            while let Some(&value) = pending.last() {
                if begun.insert(value) {
                    let inputs = self.inputs_of_this_step(motion, value);
                    pending.extend(inputs.into_iter().rev().filter(|input| !begun.contains(input)));
                    continue;
                }
                pending.pop();
                if done.insert(value) {
                    order.push(value);
                }
            }
        }
        order
    }
}
