//! Translation of programs to the intermediate representation of Cranelift, operation by operation,
//! in the order of the program. Each result is bit-identical to the interpreter
//! (`lagrange-algebra`, `program/interpret.rs`).

use std::collections::HashMap;
use std::sync::Arc;

use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::types::F64;
use cranelift_codegen::ir::{
    AbiParam, InstBuilder, MemFlagsData, Signature, StackSlot, StackSlotData, StackSlotKind, Type, Value,
};
use cranelift_codegen::isa::TargetIsa;
use cranelift_frontend::FunctionBuilder;
use lagrange_core::elementary::multiply_add;
use lagrange_core::expr::{Function, Relation};
use lagrange_core::opaque::Opaque;
use lagrange_core::pipeline::{Call, LISTS, Layout, Place};
use lagrange_core::program::{Op, Program, ValueId, ValueTable};
use lagrange_core::symbol::Role;

use crate::machine::{Bound, Taken, address, elementary, sine_and_cosine, sines_and_cosines, values_of};

/// Size of a number in bytes.
const SIZE: i32 = 8;

/// Returns the signature of compiled code: time, starts of the lists of numbers, and outputs.
pub(crate) fn signature(isa: &dyn TargetIsa) -> Signature {
    let mut signature = Signature::new(isa.default_call_conv());
    let pointer = AbiParam::new(isa.pointer_type());
    signature.params = vec![AbiParam::new(F64), pointer, pointer];
    signature
}

/// The result of an operation.
#[derive(Clone, Copy)]
enum Kept {
    Number(Value),
    /// Several numbers on the stack.
    Row(Row),
}

/// Numbers on the stack: `count` from index `first` of a slot.
#[derive(Clone, Copy)]
struct Row {
    slot: StackSlot,
    first: usize,
    count: usize,
}

/// The translation of a program.
pub(crate) struct Translation<'a, 'b> {
    builder: &'a mut FunctionBuilder<'b>,
    program: &'a Program,
    layout: &'a Layout,
    call: &'a Call,
    /// Type of addresses.
    pointer: Type,
    t: Value,
    starts: Value,
    outputs: Value,
    /// Starts of lists that have been loaded.
    lists: [Option<Value>; LISTS],
    kept: ValueTable<Kept>,
    /// Results of jointly solved unknowns, keyed by the unknowns and their arguments.
    solved: HashMap<(&'a [String], &'a [ValueId]), Row>,
    is_fused: bool,
    taken: Taken,
}

impl<'a, 'b> Translation<'a, 'b> {
    /// Starts the only block of a function with [`signature`].
    pub(crate) fn new(
        builder: &'a mut FunctionBuilder<'b>,
        program: &'a Program,
        layout: &'a Layout,
        call: &'a Call,
    ) -> Self {
        let block = builder.create_block();
        builder.append_block_params_for_function_params(block);
        builder.switch_to_block(block);
        builder.seal_block(block);
        let parameters = builder.block_params(block);
        let (t, starts, outputs) = (parameters[0], parameters[1], parameters[2]);
        let pointer = builder.func.dfg.value_type(starts);
        let taken = Taken { lengths: [0; LISTS], outputs: program.outputs().len(), functions: Vec::new() };
        let kept = ValueTable::with_capacity(program.len());
        let (lists, solved, is_fused) = ([None; LISTS], HashMap::new(), is_fused());
        Translation {
            builder,
            program,
            layout,
            call,
            pointer,
            t,
            starts,
            outputs,
            lists,
            kept,
            solved,
            is_fused,
            taken,
        }
    }

    /// Translates all operations, and returns what the code takes.
    pub(crate) fn run(mut self) -> Taken {
        for (_, op) in self.program.values() {
            let kept = self.operation(op);
            self.kept.push(kept);
        }
        for (place, output) in (0..).zip(self.program.outputs()) {
            let (value, to) = (self.number(*output), self.outputs);
            self.builder.ins().store(MemFlagsData::trusted(), value, to, SIZE * place);
        }
        self.builder.ins().return_(&[]);
        self.taken
    }

    fn operation(&mut self, op: &'a Op) -> Kept {
        let value = match op {
            Op::SinCos(angle) => return self.sine_and_cosine(*angle),
            Op::SinCosEach(angles) => return self.sines_and_cosines(angles),
            Op::SinOf(pair) => self.in_row(*pair, 0),
            Op::CosOf(pair) => self.in_row(*pair, 1),
            Op::SinIn(batch, place) => self.in_row(*batch, 2 * *place as usize),
            Op::CosIn(batch, place) => self.in_row(*batch, 2 * *place as usize + 1),
            Op::Input(role) => self.input(*role),
            Op::Call(function, arguments) => self.elementary(*function, arguments),
            Op::Opaque(function, arguments) => self.opaque(function, arguments),
            Op::Power(base, exponent) => self.power(*base, *exponent),
            Op::Select { relation, left, right, then, otherwise } => {
                self.select(*relation, [*left, *right], [*then, *otherwise])
            }
            Op::MultiplyAdd(..) | Op::MultiplySubtract(..) | Op::SubtractProduct(..) => self.fused(op),
            _ => self.arithmetic(op),
        };
        Kept::Number(value)
    }

    fn arithmetic(&mut self, op: &Op) -> Value {
        match op {
            Op::Add(a, b) => {
                let (a, b) = (self.number(*a), self.number(*b));
                self.builder.ins().fadd(a, b)
            }
            Op::Subtract(a, b) => {
                let (a, b) = (self.number(*a), self.number(*b));
                self.builder.ins().fsub(a, b)
            }
            Op::Multiply(a, b) => {
                let (a, b) = (self.number(*a), self.number(*b));
                self.builder.ins().fmul(a, b)
            }
            Op::Divide(a, b) => {
                let (a, b) = (self.number(*a), self.number(*b));
                self.builder.ins().fdiv(a, b)
            }
            Op::Negate(a) => {
                let a = self.number(*a);
                self.builder.ins().fneg(a)
            }
            Op::Constant(number) => self.constant(number.to_f64()),
            Op::Float(number) => self.constant(number.value()),
            other => unreachable!("{other:?} is translated elsewhere"),
        }
    }

    /// Translates products with a sum, rounded as by `elementary::multiply_add`.
    fn fused(&mut self, op: &Op) -> Value {
        let (Op::MultiplyAdd(a, b, c) | Op::MultiplySubtract(a, b, c) | Op::SubtractProduct(a, b, c)) = op
        else {
            unreachable!("{op:?} is translated elsewhere")
        };
        let [mut a, b, mut c] = [*a, *b, *c].map(|id| self.number(id));
        match op {
            Op::MultiplySubtract(..) => c = self.builder.ins().fneg(c),
            Op::SubtractProduct(..) => a = self.builder.ins().fneg(a),
            _ => {}
        }
        if self.is_fused {
            return self.builder.ins().fma(a, b, c);
        }
        let product = self.builder.ins().fmul(a, b);
        self.builder.ins().fadd(product, c)
    }

    /// Translates a power by repeated squaring from the lowest bit of the exponent.
    fn power(&mut self, base: ValueId, exponent: i32) -> Value {
        let (mut product, mut square) = (self.constant(1.0), self.number(base));
        let mut remaining = exponent.unsigned_abs();
        while remaining > 0 {
            if remaining % 2 == 1 {
                product = self.builder.ins().fmul(product, square);
            }
            remaining /= 2;
            if remaining > 0 {
                square = self.builder.ins().fmul(square, square);
            }
        }
        if exponent >= 0 {
            return product;
        }
        let one = self.constant(1.0);
        self.builder.ins().fdiv(one, product)
    }

    /// Selects one of two numbers by a relation; NaN if an operand of the relation is NaN.
    fn select(&mut self, relation: Relation, operands: [ValueId; 2], choices: [ValueId; 2]) -> Value {
        let condition = match relation {
            Relation::Less => FloatCC::LessThan,
            Relation::LessEqual => FloatCC::LessThanOrEqual,
            Relation::Greater => FloatCC::GreaterThan,
            Relation::GreaterEqual => FloatCC::GreaterThanOrEqual,
        };
        let [left, right] = operands.map(|id| self.number(id));
        let [then, otherwise] = choices.map(|id| self.number(id));
        let undefined = self.constant(f64::NAN);
        let holds = self.builder.ins().fcmp(condition, left, right);
        let chosen = self.builder.ins().select(holds, then, otherwise);
        let is_undefined = self.builder.ins().fcmp(FloatCC::Unordered, left, right);
        self.builder.ins().select(is_undefined, undefined, chosen)
    }

    fn elementary(&mut self, function: Function, arguments: &[ValueId]) -> Value {
        let arguments = arguments.iter().map(|id| self.number(*id)).collect::<Vec<_>>();
        match function {
            Function::Sqrt => self.builder.ins().sqrt(arguments[0]),
            Function::Abs => self.builder.ins().fabs(arguments[0]),
            _ => {
                let (address, arity) = elementary(function);
                self.calling(address, &arguments[..arity], true).expect("functions return a number")
            }
        }
    }

    fn sine_and_cosine(&mut self, angle: ValueId) -> Kept {
        let (angle, slot) = (self.number(angle), self.slot(2));
        let pair = self.start_of(slot, 0);
        self.calling(sine_and_cosine as *const () as usize, &[angle, pair], false);
        Kept::Row(Row { slot, first: 0, count: 2 })
    }

    fn sines_and_cosines(&mut self, angles: &[ValueId]) -> Kept {
        let (slot, first) = (self.slot(3 * angles.len()), angles.len());
        self.store(angles, slot);
        let (from, to) = (self.start_of(slot, 0), self.start_of(slot, first));
        let count = self.builder.ins().iconst(self.pointer, angles.len() as i64);
        self.calling(sines_and_cosines as *const () as usize, &[from, to, count], false);
        Kept::Row(Row { slot, first, count: 2 * angles.len() })
    }

    fn opaque(&mut self, function: &'a Opaque, arguments: &'a [ValueId]) -> Value {
        let key = (function.unknowns(), arguments);
        let known = self.solved.get(&key).copied().filter(|_| !key.0.is_empty());
        let results = known.unwrap_or_else(|| self.values_of(function, arguments));
        self.solved.insert(key, results);
        self.number_in(results, function.place())
    }

    /// Calls a function without a formula, and stores all its values.
    fn values_of(&mut self, function: &Opaque, arguments: &[ValueId]) -> Row {
        let (first, count) = (arguments.len(), function.unknowns().len().max(1));
        let (function, call) = (function.clone(), self.call.clone());
        let bound = Arc::new(Bound { function, call, arguments: first, results: count });
        let slot = self.slot(first + count);
        self.store(arguments, slot);
        let (from, to) = (self.start_of(slot, 0), self.start_of(slot, first));
        let function = self.builder.ins().iconst(self.pointer, address(&bound) as i64);
        self.taken.functions.push(bound);
        self.calling(values_of as *const () as usize, &[function, from, to], false);
        Row { slot, first, count }
    }

    fn input(&mut self, role: Role) -> Value {
        let place = match self.layout.place(role) {
            Some(Place::Time) => return self.t,
            place => place.and_then(|place| self.layout.entry(place)),
        };
        let Some((list, index)) = place else { return self.constant(f64::NAN) };
        // Indices beyond the range of an instruction's offset exceed any list.
        let offset = i32::try_from(index).ok().and_then(|index| index.checked_mul(SIZE));
        let length = &mut self.taken.lengths[list];
        *length = (*length).max(offset.map_or(usize::MAX, |_| index + 1));
        let (pointer, starts) = (self.pointer, self.starts);
        let start = *self.lists[list].get_or_insert_with(|| {
            let place = pointer.bytes() as i32 * list as i32;
            self.builder.ins().load(pointer, MemFlagsData::trusted(), starts, place)
        });
        self.builder.ins().load(F64, MemFlagsData::trusted(), start, offset.unwrap_or(0))
    }

    fn constant(&mut self, number: f64) -> Value {
        self.builder.ins().f64const(number)
    }

    /// Returns the number that results from an operation.
    fn number(&self, id: ValueId) -> Value {
        match self.kept[id] {
            Kept::Number(value) => value,
            Kept::Row(..) => unreachable!("pairs and batches are taken apart before they are used"),
        }
    }

    fn in_row(&mut self, row: ValueId, place: usize) -> Value {
        match self.kept[row] {
            Kept::Row(row) => self.number_in(row, place),
            Kept::Number(_) => unreachable!("only pairs and batches are taken apart"),
        }
    }

    /// Returns the number at an index of a row; NaN beyond its end.
    fn number_in(&mut self, row: Row, place: usize) -> Value {
        if place >= row.count {
            return self.constant(f64::NAN);
        }
        let offset = SIZE * (row.first + place) as i32;
        self.builder.ins().stack_load(self.pointer, F64, row.slot, offset)
    }

    /// Allocates stack space for numbers.
    fn slot(&mut self, numbers: usize) -> StackSlot {
        let bytes = SIZE as u32 * numbers.max(1) as u32;
        self.builder.create_sized_stack_slot(StackSlotData::new(StackSlotKind::ExplicitSlot, bytes, 3))
    }

    fn start_of(&mut self, slot: StackSlot, place: usize) -> Value {
        self.builder.ins().stack_addr(self.pointer, slot, SIZE * place as i32)
    }

    fn store(&mut self, numbers: &[ValueId], slot: StackSlot) {
        for (place, number) in (0..).zip(numbers) {
            let number = self.number(*number);
            self.builder.ins().stack_store(self.pointer, number, slot, SIZE * place);
        }
    }

    /// Calls a function by its address, without a symbol.
    fn calling(&mut self, address: usize, arguments: &[Value], has_result: bool) -> Option<Value> {
        let mut signature = Signature::new(self.builder.func.signature.call_conv);
        let parameter = |argument: &Value| AbiParam::new(self.builder.func.dfg.value_type(*argument));
        signature.params = arguments.iter().map(parameter).collect();
        signature.returns = has_result.then(|| AbiParam::new(F64)).into_iter().collect();
        let signature = self.builder.import_signature(signature);
        let address = self.builder.ins().iconst(self.pointer, address as i64);
        let call = self.builder.ins().call_indirect(signature, address, arguments);
        self.builder.inst_results(call).first().copied()
    }
}

/// True if `multiply_add` rounds only once: (1 + ε)(1 − ε) − 1 = −ε² vanishes if the product is
/// rounded.
fn is_fused() -> bool {
    multiply_add(1.0 + f64::EPSILON, 1.0 - f64::EPSILON, -1.0) != 0.0
}
