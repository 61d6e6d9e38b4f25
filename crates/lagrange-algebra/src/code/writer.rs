//! Operands and variables of a body that is being written.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::body::Scalar;
use super::fragment::Fragment;
use super::names::Names;
use super::naming::VariableNames;
use super::parts::LetStatement;
use super::sine_cosine::{SinesAndCosines, sines_and_cosines};
use crate::program::{Op, Program, ValueId, ValueTable};
use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary::row;
use lagrange_expr::number::Number;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Symbols;

/// Maximum number of operations of an expression; longer ones are split by a `let`.
const MAX_OPERATIONS: usize = 10;
/// Maximum length of an expression in characters; longer ones are split by a `let` to fit on a
/// line.
const LONGEST_EXPRESSION: usize = 80;

/// Text of a value where it is used.
#[derive(Clone, Debug)]
pub(super) enum Written {
    /// Already consumed by its only use.
    Gone,
    /// An expression; one with operations is used only once.
    Expression(Fragment),
    /// A variable.
    Variable(Ident),
    /// Variables for a sine and a cosine, or for those of a batch.
    Pairs(Vec<[Ident; 2]>),
}

/// Body of a function under construction.
pub(super) struct BodyWriter<'a> {
    pub(super) program: &'a Program,
    pub(super) symbols: &'a Symbols,
    pub(super) scalar: &'a Scalar,
    pub(super) names: VariableNames<'a>,
    pub(super) uses: ValueTable<usize>,
    pub(super) sines_and_cosines: SinesAndCosines,
    /// The variables of unknowns that were computed with an earlier one.
    pub(super) solved: HashMap<ValueId, Ident>,
    pub(super) written: ValueTable<Written>,
    pub(super) statements: Vec<LetStatement>,
    /// The reciprocals that remain in the written order among calls of sine and cosine. Otherwise
    /// the optimiser would move eliminations behind all calls.
    pub(super) is_reciprocal: ValueTable<bool>,
    /// Functions that were called.
    pub(super) functions: BTreeSet<&'static str>,
}

impl<'a> BodyWriter<'a> {
    pub(super) fn new(
        program: &'a Program,
        symbols: &'a Symbols,
        scalar: &'a Scalar,
        names: &'a mut Names,
    ) -> BodyWriter<'a> {
        let (mut uses, mut is_reciprocal) = (program.uses(), ValueTable::filled(program.len(), false));
        if !matches!(scalar, Scalar::SideBySide { .. }) {
            for (id, one) in pivots(program, &uses) {
                is_reciprocal[id] = true;
                uses[one] -= 1;
            }
        }
        BodyWriter {
            program,
            symbols,
            scalar,
            names: VariableNames::new(program, names),
            uses,
            is_reciprocal,
            solved: HashMap::default(),
            sines_and_cosines: sines_and_cosines(program),
            written: ValueTable::with_capacity(program.len()),
            statements: Vec::new(),
            functions: BTreeSet::new(),
        }
    }

    /// Records the text of the next value.
    pub(super) fn push(&mut self, id: ValueId, written: Written) {
        if let Written::Variable(name) = &written {
            self.names.keep(id, name);
        }
        self.written.push(written);
    }

    /// Returns the operands of an operation as fragments.
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
        // A sign adds no operation.
        if !matches!(op, Op::Negate(_)) {
            self.shorten(&ids, &mut operands, self.width_of_callee(op));
        }
        operands
    }

    /// Moves the longest operands to variables until the remaining expression has a bounded size.
    fn shorten(&mut self, ids: &[ValueId], operands: &mut [Fragment], own_width: usize) {
        loop {
            let operations = operands.iter().map(|operand| operand.operations).sum::<usize>();
            let width = operands.iter().map(|operand| operand.width + 2).sum::<usize>() + own_width;
            let longest = (0..operands.len())
                .filter(|&i| !operands[i].is_free())
                .max_by_key(|&i| (operands[i].operations, operands[i].width));
            match longest {
                Some(i) if operations >= MAX_OPERATIONS || width > LONGEST_EXPRESSION => {
                    operands[i] = self.bind_operand(ids[i], &operands[i]);
                }
                _ => return,
            }
        }
    }

    /// Returns the length of the name of the function that an operation calls.
    fn width_of_callee(&self, op: &Op) -> usize {
        match op {
            Op::Call(function, _) => row(*function).rust.len(),
            Op::Opaque(function, _) => function.rust_name().len(),
            Op::MultiplyAdd(..) | Op::MultiplySubtract(..) | Op::SubtractProduct(..) => "multiply_add".len(),
            Op::SinCosEach(_) => "sin_cos_each".len(),
            Op::Select { .. } => "if_less_equal".len(),
            _ => 0,
        }
    }

    fn is_square_of_variable(&self, id: ValueId) -> bool {
        matches!(self.program.op(id), Op::Multiply(a, b) if a == b && self.names.name_of(*a).is_some())
    }

    /// Returns the text of a value where it is used.
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

    /// Returns the text of a value that is used twice.
    pub(super) fn take_variable(&mut self, id: ValueId) -> Fragment {
        let expression = self.take(id);
        if expression.is_free() { expression } else { self.bind_operand(id, &expression) }
    }

    /// Moves the expression of an earlier value to a variable.
    fn bind_operand(&mut self, id: ValueId, expression: &Fragment) -> Fragment {
        let name = self.bind(id, &expression.tokens);
        self.names.keep(id, &name);
        self.written[id] = Written::Variable(name.clone());
        Fragment::name(&name)
    }

    /// Writes a `let` for a value.
    pub(super) fn bind(&mut self, id: ValueId, expression: &TokenStream) -> Ident {
        let name = self.names.choose(id);
        let tokens = quote_spanned!(Span::mixed_site()=> let #name = #expression;);
        self.statements.push(LetStatement { tokens, variables: vec![(id, name.clone())] });
        name
    }

    /// True if a choice may be an `if`.
    pub(super) fn may_branch(&self) -> bool {
        !matches!(self.scalar, Scalar::SideBySide { .. })
    }

    pub(super) fn call(&mut self, function: &'static str, arguments: Vec<Fragment>) -> Fragment {
        Fragment::call(&self.function(function), arguments)
    }

    /// Writes a call of a function of the user's crate.
    pub(super) fn call_opaque(&mut self, function: &Opaque, arguments: Vec<Fragment>) -> Fragment {
        Fragment::call(&Fragment::name(&self.names.callee(function)), arguments)
    }

    /// Returns a function of the scalar, imported under its bare name.
    fn function(&mut self, name: &'static str) -> Fragment {
        self.functions.insert(name);
        let function = Ident::new(name, Span::mixed_site());
        Fragment::atom(quote_spanned!(Span::mixed_site()=> #function), name.len())
    }

    /// Returns an associated constant or function of the scalar, for places without type inference.
    pub(super) fn associated(&self, item: &str) -> Fragment {
        let item = Ident::new(item, Span::mixed_site());
        let scalar = match self.scalar {
            Scalar::F64 => quote_spanned!(Span::mixed_site()=> f64),
            Scalar::F32 => quote_spanned!(Span::mixed_site()=> f32),
            Scalar::Generic(scalar) | Scalar::SideBySide { number: scalar, .. } => scalar.to_token_stream(),
        };
        Fragment::atom(
            quote_spanned!(Span::mixed_site()=> #scalar::#item),
            "S::".len() + item.to_string().len(),
        )
    }
}

/// Returns the reciprocals with several uses, as the pivots of an elimination have, each with its
/// dividend one. There are none without several sines and cosines.
fn pivots(program: &Program, uses: &ValueTable<usize>) -> Vec<(ValueId, ValueId)> {
    let calls = program.values().filter(|(_, op)| matches!(op, Op::SinCos(_))).count();
    let pivot = |(id, op): (ValueId, &Op)| match op {
        Op::Divide(one, _) if *program.op(*one) == Op::Constant(Number::ONE) => Some((id, *one)),
        _ => None,
    };
    let pivots = program.values().filter_map(pivot).filter(|(id, _)| calls > 1 && uses[*id] > 1);
    pivots.collect()
}
