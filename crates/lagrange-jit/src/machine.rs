//! The boundary between Rust and machine code, with everything that the Rust compiler cannot check.
//! It consists of the call of compiled code, and the functions called by compiled code.
//!
//! Compiled code only accesses its stack, the lists of numbers and the outputs. It reads each list
//! up to the length found by the translation, and writes exactly the outputs of the program:
//! [`Machine::run`] checks both.
#![allow(unsafe_code, reason = "machine code is called by its address")]

use std::fmt::{self, Debug, Formatter};
use std::mem::transmute;
use std::slice::{from_raw_parts, from_raw_parts_mut};
use std::sync::{Arc, Mutex, PoisonError};

use cranelift_jit::JITModule;
use cranelift_module::FuncId;
use lagrange_core::elementary::row;
use lagrange_core::expr::Function;
use lagrange_core::opaque::Opaque;
use lagrange_core::pipeline::{Call, Code, LISTS, Numbers};
use lagrange_math::sin_cos_each;

/// Compiled code: a function of the time, the starts of the lists of numbers, and the outputs.
type Entry = unsafe extern "C" fn(f64, *const *const f64, *mut f64);

/// The machine code of a program.
pub(crate) struct Machine {
    /// Owner of the memory that holds the code; only `drop` takes it out.
    module: Mutex<Option<JITModule>>,
    entry: Entry,
    /// Arguments of the code, and functions that it calls by their addresses.
    taken: Taken,
}

/// Arguments of compiled code, and functions that it calls.
pub(crate) struct Taken {
    /// Minimum lengths of the lists of numbers.
    pub(crate) lengths: [usize; LISTS],
    /// Number of outputs.
    pub(crate) outputs: usize,
    /// Functions without a formula.
    pub(crate) functions: Vec<Arc<Bound>>,
}

/// A function without a formula, as called by compiled code.
pub(crate) struct Bound {
    pub(crate) function: Opaque,
    pub(crate) call: Call,
    /// Number of arguments.
    pub(crate) arguments: usize,
    /// Number of results: one, or the number of jointly solved unknowns.
    pub(crate) results: usize,
}

impl Debug for Machine {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "Machine({} outputs)", self.taken.outputs)
    }
}

impl Machine {
    /// Takes over a module; `taken` describes its function `entry`.
    pub(crate) fn new(module: JITModule, entry: FuncId, taken: Taken) -> Machine {
        let address = module.get_finalized_function(entry);
        // SAFETY: the function has the signature of `Entry`, by `translate::signature`, and the
        // calling convention of C on this machine, for which the module compiles.
        let entry = unsafe { transmute::<*const u8, Entry>(address) };
        Machine { module: Mutex::new(Some(module)), entry, taken }
    }
}

impl Code for Machine {
    fn run(&self, numbers: &Numbers<'_>, outputs: &mut [f64]) -> bool {
        let lists = numbers.lists();
        let is_long = |(list, length): (&&[f64], &usize)| list.len() >= *length;
        let suffices =
            outputs.len() == self.taken.outputs && lists.iter().zip(&self.taken.lengths).all(is_long);
        if suffices {
            let starts: [*const f64; LISTS] = lists.map(<[f64]>::as_ptr);
            // SAFETY: the code is in memory as long as `self`, which owns it. Nobody writes there
            // after it was made, so that threads may share it. It reads `starts`, and lists within
            // the lengths checked above. It writes `taken.outputs` numbers to `outputs`, which is
            // exclusive. Functions that it calls are kept in `taken`. They do not unwind: a panic
            // in a function with the calling convention of C ends the process.
            unsafe { (self.entry)(numbers.t, starts.as_ptr(), outputs.as_mut_ptr()) };
        }
        suffices
    }
}

impl Drop for Machine {
    fn drop(&mut self) {
        let module = self.module.get_mut().unwrap_or_else(PoisonError::into_inner).take();
        if let Some(module) = module {
            // SAFETY: nobody runs the code, since `self` is exclusive, and `entry`, the only
            // address of it, was given to nobody.
            unsafe { module.free_memory() };
        }
    }
}

/// Writes sine and cosine of an angle, in this order.
pub(crate) extern "C" fn sine_and_cosine(angle: f64, pair: *mut f64) {
    // SAFETY: compiled code passes a place on its stack for two numbers.
    let pair = unsafe { from_raw_parts_mut(pair, 2) };
    pair.copy_from_slice(&[angle.sin(), angle.cos()]);
}

/// Writes sines and cosines of several angles, in pairs. The pair of an angle does not depend on
/// the other angles.
pub(crate) extern "C" fn sines_and_cosines(angles: *const f64, pairs: *mut f64, count: usize) {
    // SAFETY: compiled code passes places on its stack: `count` angles, and room for twice as many
    // numbers behind them.
    let (angles, pairs) = unsafe { (from_raw_parts(angles, count), from_raw_parts_mut(pairs, 2 * count)) };
    let (angles, last_angles) = angles.as_chunks::<4>();
    let (pairs, last_pairs) = pairs.split_at_mut(8 * angles.len());
    for (angles, pairs) in angles.iter().zip(pairs.chunks_exact_mut(8)) {
        let found = sin_cos_each(*angles).map(|(sine, cosine)| [sine, cosine]);
        pairs.copy_from_slice(found.as_flattened());
    }
    for (angle, pair) in last_angles.iter().zip(last_pairs.chunks_exact_mut(2)) {
        let [(sine, cosine)] = sin_cos_each([*angle]);
        pair.copy_from_slice(&[sine, cosine]);
    }
}

/// Writes the values of a function without a formula, and NaN where it has fewer than expected.
pub(crate) extern "C" fn values_of(bound: *const Bound, arguments: *const f64, results: *mut f64) {
    // SAFETY: compiled code passes the address of a function in its `Taken`. It has places on its
    // stack for as many arguments and results.
    let (bound, arguments, results) = unsafe {
        let bound = &*bound;
        (bound, from_raw_parts(arguments, bound.arguments), from_raw_parts_mut(results, bound.results))
    };
    results.fill(f64::NAN);
    match bound.function.known_value(arguments) {
        Some(value) => results.fill(value),
        None => {
            let found = (bound.call)(&bound.function, arguments);
            results.iter_mut().zip(found).for_each(|(result, found)| *result = found);
        }
    }
}

/// Addresses of functions called by compiled code. The list names each elementary function.
macro_rules! addresses {
    ($($function:ident($($argument:ident),+),)+) => {
        /// Returns the address of an elementary function, and the number of its arguments.
        pub(crate) fn elementary(function: Function) -> (usize, usize) {
            match function {
                $(Function::$function => {
                    extern "C" fn value($($argument: f64),+) -> f64 {
                        (row(Function::$function).value)(&[$($argument),+])
                    }
                    (value as *const () as usize, row(function).arity)
                })+
            }
        }
    };
}

addresses! {
    Sin(x), Cos(x), Tan(x), Asin(x), Acos(x), Atan(x), Atan2(x, y), Sinh(x), Cosh(x), Tanh(x), Exp(x), Ln(x),
    Sqrt(x), Abs(x), Sign(x), Min(x, y), Max(x, y), Power(x, y), Hypot(x, y), MagnitudeSlope(x),
}

/// Returns the address of a function without a formula, which must live as long as the code.
pub(crate) fn address(bound: &Arc<Bound>) -> usize {
    Arc::as_ptr(bound).expose_provenance()
}
