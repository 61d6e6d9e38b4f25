//! Functions of the user's crate where systems are interpreted.

use std::fmt;
use std::sync::Arc;

use crate::collections::HashMap;
use crate::opaque::Opaque;
use crate::program::{Op, Program};

type Callback = Arc<dyn Fn(&[f64]) -> f64 + Send + Sync>;

/// Functions by the names under which emitted code calls them.
#[derive(Clone, Default)]
pub(super) struct Callables(HashMap<String, Callback>);

impl fmt::Debug for Callables {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Callables({})", self.0.len())
    }
}

impl Callables {
    pub(super) fn define(&mut self, name: &str, value: impl Fn(&[f64]) -> f64 + Send + Sync + 'static) {
        self.0.insert(name.to_owned(), Arc::new(value));
    }

    /// The value of a function; NaN if nobody computes it.
    pub(super) fn call(&self, function: &Opaque, arguments: &[f64]) -> f64 {
        self.0.get(&function.rust_name()).map_or(f64::NAN, |value| value(arguments))
    }
}

/// Whether a program calls a function of that name.
pub(super) fn calls(program: &Program, name: &str) -> bool {
    let is_call = |op: &Op| matches!(op, Op::Opaque(function, _) if function.rust_name() == name);
    program.values().any(|(_, op)| is_call(op))
}
