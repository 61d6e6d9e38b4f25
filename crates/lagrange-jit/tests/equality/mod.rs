//! Compiled code compared with the interpreter.

use std::collections::BTreeSet;
use std::sync::{Arc, LazyLock};

use lagrange_core::opaque::Opaque;
use lagrange_core::pipeline::{Call, Code, LISTS, Layout, Numbers, Place, Programs};
use lagrange_core::program::{NewtonProgram, Op, Program, run_with};
use lagrange_jit::{CompileError, Compiler};

/// Numbers at which operations may differ.
const CORNERS: [f64; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    f64::MIN_POSITIVE,
    5e-324,
    f64::MAX,
    1e308,
    1e22,
];
/// Number of random vectors; the second half contains corners.
const VECTORS: u64 = 16;

/// A single compiler for all programs.
static COMPILER: LazyLock<Arc<Compiler>> =
    LazyLock::new(|| Compiler::for_this_processor().expect("a known processor"));

/// Counts of compared items.
#[derive(Default, Debug)]
pub(crate) struct Checked {
    /// Programs.
    pub(crate) programs: usize,
    /// Programs left to the interpreter.
    pub(crate) too_large: usize,
    /// Compared outputs.
    pub(crate) outputs: usize,
    /// Compared outputs that are finite.
    pub(crate) finite: usize,
    /// Names of the operations in the programs.
    pub(crate) kinds: BTreeSet<String>,
}

impl Checked {
    /// Compares all programs of a system.
    pub(crate) fn check(&mut self, programs: &Programs) -> Result<(), String> {
        let call = solving(&programs.solutions);
        let mut computing = programs.all().filter(|program| !program.outputs().is_empty());
        computing.try_for_each(|program| self.compare(program, &programs.layout, &call))?;
        let series = programs.known_series();
        series.map_or(Ok(()), |series| self.compare(&series.step, &series.layout, &call))
    }

    /// Compares the outputs of a program at random numbers.
    pub(crate) fn compare(&mut self, program: &Program, layout: &Layout, call: &Call) -> Result<(), String> {
        let code = match COMPILER.code(program, layout, call) {
            Err(CompileError::TooLarge(_)) => {
                self.too_large += 1;
                return Ok(());
            }
            code => code.map_err(|error| error.to_string())?,
        };
        self.programs += 1;
        self.kinds.extend(program.values().map(|(_, op)| kind(op)));
        for seed in 0..VECTORS {
            let mut random = Random(seed);
            let t = random.number(seed);
            let lists =
                lengths(layout).map(|length| (0..length).map(|_| random.number(seed)).collect::<Vec<_>>());
            let numbers = numbers(t, &lists);
            let wanted = interpreted(program, layout, call, &numbers);
            let mut found = vec![f64::NAN; wanted.len()];
            assert!(code.run(&numbers, &mut found), "lists are long enough");
            if !found.iter().zip(&wanted).all(|(a, b)| are_same(*a, *b)) {
                return Err(format!("{found:?} instead of {wanted:?} at {numbers:?}: {program:?}"));
            }
            self.outputs += found.len();
            self.finite += found.iter().filter(|value| value.is_finite()).count();
        }
        Ok(())
    }
}

/// True if bits are the same; signs and payloads of NaN may differ.
pub(crate) fn are_same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Returns functions that solve equations.
pub(crate) fn solving(solutions: &[NewtonProgram]) -> Call {
    let solutions = solutions.to_vec();
    let none = |_: &Opaque, _: &[f64]| vec![f64::NAN];
    Arc::new(move |function, arguments| {
        let solution = solutions.iter().find(|solution| solution.functions.contains(function));
        solution.map_or_else(|| none(function, arguments), |solution| solution.solve(arguments, none))
    })
}

fn lengths(layout: &Layout) -> [usize; LISTS] {
    let Layout { positions, velocities, sides, multipliers, reactions, .. } = *layout;
    [positions, velocities, layout.fields(), sides, multipliers, velocities, reactions]
}

fn numbers(t: f64, lists: &[Vec<f64>; LISTS]) -> Numbers<'_> {
    let [positions, velocities, fields, sides, multipliers, accelerations, reactions] = lists;
    Numbers { t, positions, velocities, fields, sides, multipliers, accelerations, reactions }
}

fn interpreted(program: &Program, layout: &Layout, call: &Call, numbers: &Numbers<'_>) -> Vec<f64> {
    let value_of = |role| match layout.place(role) {
        None => f64::NAN,
        Some(Place::Time) => numbers.t,
        Some(place) => layout.entry(place).map_or(f64::NAN, |(list, index)| numbers.lists()[list][index]),
    };
    run_with(program, value_of, |function, arguments| call(function, arguments))
}

fn kind(op: &Op) -> String {
    let debug = format!("{op:?}");
    debug.split(['(', ' ', '{']).next().unwrap_or_default().to_owned()
}

/// Numbers by the generator SplitMix64 of Steele, Lea and Flood (2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Draws a number of order one or, for later vectors, sometimes a corner.
    fn number(&mut self, vector: u64) -> f64 {
        let (choice, fraction) = (self.next(), (self.next() >> 11) as f64 / (1_u64 << 53) as f64);
        if vector >= VECTORS / 2 && choice % 4 < vector % 4 {
            return CORNERS[(choice >> 8) as usize % CORNERS.len()];
        }
        4.0 * fraction - 2.0
    }
}
