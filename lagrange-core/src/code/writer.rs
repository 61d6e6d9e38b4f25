//! Walks over a program and writes statements.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::fragment::Fragment;
use super::literal::Constant;
use super::parts::{LetStatement, assemble};
use super::sine_cosine::{SinesAndCosines, sines_and_cosines};
use super::{FunctionBody, Names, Scalar, Unrepresentable};
use crate::expr::Relation;
use crate::functions::row;
use crate::program::{Op, Program, ValueId, ValueTable, Variability};
use crate::symbol::{Role, Symbols};

/// Expressions with more operations than this are split by a `let`.
const MOST_OPERATIONS: usize = 10;
/// Expressions longer than this many characters are split by a `let`, so that it fits on a line.
const LONGEST_EXPRESSION: usize = 80;

/// How a value is written where it is used.
#[derive(Clone, Debug)]
pub(super) enum Written {
    /// Already used in the only place where it is.
    Gone,
    /// An expression; one that costs something is used once.
    Expression(Fragment),
    /// A variable.
    Variable(Ident),
    /// Variables for a sine and a cosine, or for those of a batch.
    Pairs(Vec<[Ident; 2]>),
}

pub(super) struct BodyWriter<'a> {
    pub(super) program: &'a Program,
    symbols: &'a Symbols,
    scalar: &'a Scalar,
    pub(super) names: &'a mut Names,
    uses: ValueTable<usize>,
    pub(super) variability: ValueTable<Variability>,
    /// Whether a value is used once, as a branch of a selection.
    is_branch: ValueTable<bool>,
    pub(super) sines_and_cosines: SinesAndCosines,
    /// Which values are in variables whose names only number them.
    pub(super) is_numbered: ValueTable<bool>,
    pub(super) written: ValueTable<Written>,
    pub(super) statements: Vec<LetStatement>,
    unrepresentable: Vec<String>,
    /// Functions that were called.
    functions: BTreeSet<&'static str>,
}

impl<'a> BodyWriter<'a> {
    pub(super) fn new(
        program: &'a Program,
        symbols: &'a Symbols,
        scalar: &'a Scalar,
        names: &'a mut Names,
    ) -> BodyWriter<'a> {
        BodyWriter {
            program,
            symbols,
            scalar,
            names,
            is_branch: branches(program),
            uses: program.uses(),
            variability: Variability::of_values(program),
            sines_and_cosines: sines_and_cosines(program),
            is_numbered: ValueTable::filled(program.len(), false),
            written: ValueTable::with_capacity(program.len()),
            statements: Vec::new(),
            unrepresentable: Vec::new(),
            functions: BTreeSet::new(),
        }
    }

    /// The statements, and an expression for each output.
    pub(super) fn write(mut self, used: Vec<Role>) -> Result<FunctionBody, Unrepresentable> {
        for (id, op) in self.program.values() {
            let written = self.value(id, op);
            self.written.push(written);
        }
        let outputs = self.program.outputs().iter().map(|&output| self.take(output).tokens).collect();
        if self.unrepresentable.is_empty() {
            let statements = assemble(self.program, &self.statements);
            Ok(FunctionBody { statements, outputs, used, functions: self.functions })
        } else {
            Err(Unrepresentable { constants: self.unrepresentable })
        }
    }

    fn value(&mut self, id: ValueId, op: &Op) -> Written {
        match op {
            Op::Input(role) => Written::Variable(self.names.role(self.symbols, *role)),
            Op::Constant(number) => self.constant(id, Constant::Exact(number)),
            Op::Float(value) => self.constant(id, Constant::Rounded(*value)),
            Op::SinCos(argument) => self.pair(id, *argument),
            Op::SinCosEach(arguments) => self.batch(id, arguments),
            Op::SinOf(pair) => self.part(*pair, 0, 0),
            Op::CosOf(pair) => self.part(*pair, 0, 1),
            Op::SinIn(batch, place) => self.part(*batch, *place, 0),
            Op::CosIn(batch, place) => self.part(*batch, *place, 1),
            Op::Select { relation, left, right, then, otherwise } => {
                let [left, right] = [*left, *right].map(|operand| self.take_variable(operand));
                let [then, otherwise] = [*then, *otherwise].map(|operand| self.take(operand));
                let chosen = self.selection(*relation, [left, right], [then, otherwise]);
                match self.is_branch[id] && self.program.hint(id).is_none() {
                    true => Written::Expression(Fragment::block(chosen)),
                    false => Written::Variable(self.bind(id, &chosen)),
                }
            }
            _ => {
                let expression = self.expression(op);
                if self.uses[id] > 1 || self.program.hint(id).is_some() {
                    Written::Variable(self.bind(id, &expression.tokens))
                } else {
                    Written::Expression(expression)
                }
            }
        }
    }

    /// An arithmetic operation or a call.
    fn expression(&mut self, op: &Op) -> Fragment {
        let mut operands = self.operands(op);
        let mut next = || operands.remove(0);
        match op {
            Op::Add(..) => Fragment::sum(next(), next()),
            Op::Subtract(..) => Fragment::difference(next(), next()),
            Op::Multiply(..) => Fragment::product(next(), next()),
            Op::Divide(..) => Fragment::quotient(next(), next()),
            Op::Negate(_) => next().negated(),
            Op::MultiplyAdd(..) => self.call("multiply_add", operands),
            Op::MultiplySubtract(..) => {
                let arguments = vec![next(), next(), next().negated()];
                self.call("multiply_add", arguments)
            }
            Op::SubtractProduct(..) => {
                let arguments = vec![next().negated(), next(), next()];
                self.call("multiply_add", arguments)
            }
            Op::Power(_, exponent) => {
                let literal = Literal::u32_unsuffixed(exponent.unsigned_abs());
                let magnitude = Fragment::atom(literal.into_token_stream(), 4);
                operands.push(if *exponent < 0 { magnitude.negated() } else { magnitude });
                self.call("powi", operands)
            }
            Op::Call(function, _) => self.call(row(*function).rust, operands),
            _ => unreachable!("{op:?} is not written as an expression"),
        }
    }

    /// The operands of an operation as they are written in it.
    pub(super) fn operands(&mut self, op: &Op) -> Vec<Fragment> {
        let mut ids = Vec::new();
        op.for_each_operand(|operand| ids.push(operand));
        let factors = match op {
            Op::Multiply(..) | Op::Divide(..) => ids.len(),
            Op::MultiplyAdd(..) | Op::MultiplySubtract(..) | Op::SubtractProduct(..) => ids.len() - 1,
            _ => 0,
        };
        let mut operands = Vec::new();
        for (position, &id) in ids.iter().enumerate() {
            // Squares read better under a name than between other factors.
            let named = position < factors && self.is_square_of_variable(id);
            operands.push(if named { self.take_variable(id) } else { self.take(id) });
        }
        // A sign makes nothing longer.
        if !matches!(op, Op::Negate(_)) {
            self.shorten(&ids, &mut operands, self.width_of_callee(op));
        }
        operands
    }

    /// Moves the longest operands to variables until what remains makes an expression of bounded size.
    fn shorten(&mut self, ids: &[ValueId], operands: &mut [Fragment], own_width: usize) {
        loop {
            let operations = operands.iter().map(|operand| operand.operations).sum::<usize>();
            let width = operands.iter().map(|operand| operand.width + 2).sum::<usize>() + own_width;
            let longest = (0..operands.len())
                .filter(|&i| !operands[i].is_free())
                .max_by_key(|&i| (operands[i].operations, operands[i].width));
            match longest {
                Some(i) if operations >= MOST_OPERATIONS || width > LONGEST_EXPRESSION => {
                    operands[i] = self.bind_operand(ids[i], &operands[i]);
                }
                _ => return,
            }
        }
    }

    /// The length of the name of the function that an operation calls.
    fn width_of_callee(&self, op: &Op) -> usize {
        match op {
            Op::Call(function, _) => row(*function).rust.len(),
            Op::MultiplyAdd(..) | Op::MultiplySubtract(..) | Op::SubtractProduct(..) => "multiply_add".len(),
            Op::SinCosEach(_) => "sin_cos_each".len(),
            _ => 0,
        }
    }

    fn is_square_of_variable(&self, id: ValueId) -> bool {
        matches!(self.program.op(id), Op::Multiply(a, b) if a == b && self.name_of(*a).is_some())
    }

    /// A value where it is used.
    pub(super) fn take(&mut self, id: ValueId) -> Fragment {
        match &self.written[id] {
            Written::Variable(name) => Fragment::name(name),
            Written::Expression(expression) if expression.is_free() => expression.clone(),
            _ => match std::mem::replace(&mut self.written[id], Written::Gone) {
                Written::Expression(expression) => expression,
                _ => unreachable!("{id:?} is used once and is no pair"),
            },
        }
    }

    /// A value where it is used twice.
    fn take_variable(&mut self, id: ValueId) -> Fragment {
        let expression = self.take(id);
        if expression.is_free() { expression } else { self.bind_operand(id, &expression) }
    }

    /// Moves the expression of an earlier value to a variable.
    fn bind_operand(&mut self, id: ValueId, expression: &Fragment) -> Fragment {
        let name = self.bind(id, &expression.tokens);
        self.written[id] = Written::Variable(name.clone());
        Fragment::name(&name)
    }

    /// Writes a `let` for a value.
    fn bind(&mut self, id: ValueId, expression: &TokenStream) -> Ident {
        let name = self.choose_name(id);
        let tokens = quote_spanned!(Span::mixed_site()=> let #name = #expression;);
        self.statements.push(LetStatement { tokens, variables: vec![(id, name.clone())] });
        name
    }

    fn constant(&mut self, id: ValueId, constant: Constant<'_>) -> Written {
        let text = match self.scalar {
            Scalar::F32 => constant.single(),
            Scalar::F64 | Scalar::Generic(_) => constant.double(),
        };
        let Some(text) = text else {
            let words = constant.describe();
            if !self.unrepresentable.contains(&words) {
                self.unrepresentable.push(words);
            }
            return Written::Expression(Fragment::number("0.0"));
        };
        let number = Fragment::number(&text);
        if !matches!(self.scalar, Scalar::Generic(_)) {
            return Written::Expression(number);
        }
        let converted = match text.as_str() {
            "0.0" => self.associated("ZERO"),
            "1.0" => self.associated("ONE"),
            _ => Fragment::call(&self.associated("from_f64"), vec![number]).free(),
        };
        if self.uses[id] > 1 {
            Written::Variable(self.bind(id, &converted.tokens))
        } else {
            Written::Expression(converted)
        }
    }

    /// Both comparisons fail where an operand is not a number; that must not pick a branch.
    fn selection(&self, relation: Relation, sides: [Fragment; 2], values: [Fragment; 2]) -> TokenStream {
        let [left, right] = sides.map(|side| side.tokens);
        let [then, otherwise] = values.map(|value| value.tokens);
        let nan = self.associated("NAN").tokens;
        let (holds, fails) = match relation {
            Relation::Less => {
                (quote_spanned!(Span::mixed_site()=> <), quote_spanned!(Span::mixed_site()=> >=))
            }
            Relation::LessEqual => {
                (quote_spanned!(Span::mixed_site()=> <=), quote_spanned!(Span::mixed_site()=> >))
            }
            Relation::Greater => {
                (quote_spanned!(Span::mixed_site()=> >), quote_spanned!(Span::mixed_site()=> <=))
            }
            Relation::GreaterEqual => {
                (quote_spanned!(Span::mixed_site()=> >=), quote_spanned!(Span::mixed_site()=> <))
            }
        };
        quote_spanned! {Span::mixed_site()=>
            if #left #holds #right { #then } else if #left #fails #right { #otherwise } else { #nan }
        }
    }

    pub(super) fn call(&mut self, function: &'static str, arguments: Vec<Fragment>) -> Fragment {
        Fragment::call(&self.function(function), arguments)
    }

    /// A function of the scalar, imported under its bare name.
    fn function(&mut self, name: &'static str) -> Fragment {
        self.functions.insert(name);
        let function = Ident::new(name, Span::mixed_site());
        Fragment::atom(quote_spanned!(Span::mixed_site()=> #function), name.len())
    }

    /// An associated constant or function of the scalar, for where inference has nothing to go by.
    fn associated(&self, item: &str) -> Fragment {
        let item = Ident::new(item, Span::mixed_site());
        let scalar = match self.scalar {
            Scalar::F64 => quote_spanned!(Span::mixed_site()=> f64),
            Scalar::F32 => quote_spanned!(Span::mixed_site()=> f32),
            Scalar::Generic(scalar) => scalar.to_token_stream(),
        };
        Fragment::atom(
            quote_spanned!(Span::mixed_site()=> #scalar::#item),
            "S::".len() + item.to_string().len(),
        )
    }
}

/// Which values are used once, as a branch of a selection: they are computed only where they are wanted.
fn branches(program: &Program) -> ValueTable<bool> {
    let uses = program.uses();
    let mut is_branch = ValueTable::filled(program.len(), false);
    for (_, op) in program.values() {
        if let Op::Select { then, otherwise, .. } = op {
            [*then, *otherwise].into_iter().for_each(|branch| is_branch[branch] = uses[branch] == 1);
        }
    }
    is_branch
}
