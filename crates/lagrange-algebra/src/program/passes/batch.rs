//! Joint computation of sines and cosines of several values, for the accuracy level `fast`.

use crate::program::{Builder, Op, Program, ValueId, ValueTable};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::Function;

/// Maximum number of angles that are computed together. With 8 to 32, chains take the same time;
/// with 4, they take longer. More would only keep sines and cosines in memory.
const MAX_ANGLES: usize = 32;

/// Batches sines and cosines. One operation computes those whose arguments depend on no other sine
/// or cosine. The next one computes those whose arguments depend on these, and so on.
///
/// The values agree with those of other accuracy levels up to an ulp, since they are computed by a
/// different function.
pub fn batch_sines_and_cosines(program: &Program) -> Program {
    let rounds = rounds(program);
    let batches = Batches::of(program, &rounds);
    let mut order = program.values().map(|(id, _)| id).collect::<Vec<_>>();
    // The sort is stable: operands still come first, and all arguments of a round come before their
    // sines and cosines.
    order.sort_by_key(|id| rounds[*id]);
    Rebuilding::new(program, &batches).run(&order)
}

/// Returns, for each value, the length of the longest chain of sines and cosines that it depends
/// on.
fn rounds(program: &Program) -> ValueTable<usize> {
    let mut rounds: ValueTable<usize> = ValueTable::with_capacity(program.len());
    for (_, op) in program.values() {
        let mut round = 0;
        op.for_each_operand(|operand| round = round.max(rounds[operand]));
        rounds.push(round + usize::from(wave(op).is_some()));
    }
    rounds
}

type BatchPart = fn(ValueId, u32) -> Op;

/// Returns the argument of a sine or a cosine, and the operation that extracts it from a batch.
fn wave(op: &Op) -> Option<(ValueId, BatchPart)> {
    match op {
        Op::Call(Function::Sin, argument) => Some((argument[0], Op::SinIn)),
        Op::Call(Function::Cos, argument) => Some((argument[0], Op::CosIn)),
        _ => None,
    }
}

/// Arguments of sines and cosines.
struct Batches {
    arguments: Vec<Vec<ValueId>>,
    /// The batch of each argument, and its place in it.
    places: HashMap<ValueId, (usize, u32)>,
}

impl Batches {
    fn of(program: &Program, rounds: &ValueTable<usize>) -> Batches {
        let waves = program.values().filter_map(|(_, op)| wave(op));
        let mut arguments = waves.map(|(argument, _)| argument).collect::<Vec<_>>();
        arguments.sort_by_key(|argument| (rounds[*argument], *argument));
        arguments.dedup();
        let of_rounds = arguments.chunk_by(|a, b| rounds[*a] == rounds[*b]);
        let arguments = of_rounds.flat_map(|round| round.chunks(MAX_ANGLES)).map(<[_]>::to_vec);
        let arguments = arguments.collect::<Vec<_>>();
        let mut places = HashMap::default();
        for (index, batch) in arguments.iter().enumerate() {
            for (place, argument) in batch.iter().enumerate() {
                places.insert(*argument, (index, place as u32));
            }
        }
        Batches { arguments, places }
    }
}

/// The program with batches, under construction.
struct Rebuilding<'a> {
    program: &'a Program,
    batches: &'a Batches,
    builder: Builder,
    /// The new values of old ones, so far.
    image: HashMap<ValueId, ValueId>,
    /// The new value of each batch.
    made: HashMap<usize, ValueId>,
}

impl<'a> Rebuilding<'a> {
    fn new(program: &'a Program, batches: &'a Batches) -> Rebuilding<'a> {
        let (builder, image, made) = (Builder::new(), HashMap::default(), HashMap::default());
        Rebuilding { program, batches, builder, image, made }
    }

    fn run(mut self, order: &[ValueId]) -> Program {
        for &id in order {
            let op = self.replaced(self.program.op(id));
            let new = self.builder.push(op);
            if let Some(name) = self.program.hint(id) {
                self.builder.propose_name(new, name);
            }
            self.image.insert(id, new);
        }
        let outputs = self.program.outputs().iter().map(|&output| self.moved(output)).collect::<Vec<_>>();
        self.builder.finish(&outputs)
    }

    fn moved(&self, id: ValueId) -> ValueId {
        self.image.get(&id).copied().unwrap_or(id)
    }

    fn replaced(&mut self, op: &Op) -> Op {
        let place = |(argument, part)| Some((part, self.batches.places.get(&argument).copied()?));
        let Some((part, (batch, place))) = wave(op).and_then(place) else {
            return op.map_operands(|operand| self.moved(operand));
        };
        part(self.batch(batch), place)
    }

    fn batch(&mut self, index: usize) -> ValueId {
        if let Some(made) = self.made.get(&index) {
            return *made;
        }
        let arguments = self.batches.arguments[index].iter().map(|argument| self.moved(*argument)).collect();
        let made = self.builder.push(Op::SinCosEach(arguments));
        self.made.insert(index, made);
        made
    }
}
