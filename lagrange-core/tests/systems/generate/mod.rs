//! Random declarations with states.

mod expressions;
mod lattices;
mod machines;
mod plane;
mod quantities;
mod space;
mod states;

use lagrange_core::derive::{Strategy, StrategyChoice};

use crate::layout::Layout;
use crate::random::Random;
use crate::tree::{Declaration, Expr, Statement, Values};
use crate::world::State;

use quantities::Dimension;

/// A declaration, the way of deriving it, and states, each with accelerations that forces should
/// produce.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) declaration: Declaration,
    pub(crate) choice: StrategyChoice,
    pub(crate) states: Vec<(State, Vec<f64>)>,
}

const LEVELS: [&str; 5] = ["standard", "standard", "standard", "fast", "strict"];
const CHOICES: [StrategyChoice; 6] = [
    StrategyChoice::Cheapest,
    StrategyChoice::Cheapest,
    StrategyChoice::Cheapest,
    StrategyChoice::Always(Strategy::MassMatrix),
    StrategyChoice::Always(Strategy::ArticulatedBody),
    StrategyChoice::Always(Strategy::SumOfSquares),
];

/// Returns the case of a number, which is the same in every run.
pub(crate) fn case(number: u64) -> Case {
    let mut generator = Generator::new(number);
    if generator.chance(2) {
        generator.input();
    }
    match generator.random.below(10) {
        0..5 => generator.machine(),
        5 => generator.lattice(),
        6 => generator.plane_scene(),
        _ => generator.space_scene(),
    }
    let mut random = generator.random;
    let declaration =
        Declaration { level: LEVELS[random.below(LEVELS.len())], statements: generator.statements };
    let choice = *random.choice(&CHOICES);
    let layout = Layout::of(&declaration.statements);
    let states = [false, true].map(|is_special| states::state(&layout, is_special, &mut random)).into();
    Case { declaration, choice, states }
}

/// The quantities on which an expression may depend.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Level {
    /// Coordinates and time, smoothly.
    Shape,
    /// First-order states, too.
    Potential,
    /// Everything, with kinks and jumps.
    Force,
}

/// A quantity from which expressions are built.
#[derive(Clone, Debug)]
struct Atom {
    expression: Expr,
    dimension: Dimension,
    level: Level,
}

/// A declaration under construction.
struct Generator {
    random: Random,
    statements: Vec<Statement>,
    /// True if units are written.
    with_units: bool,
    names: usize,
    atoms: Vec<Atom>,
    /// Functions and tables of one plain number, and the lowest level at which they may be called.
    functions: Vec<(String, Level)>,
}

impl Generator {
    fn new(number: u64) -> Generator {
        let mut random = Random::of_case(number);
        let with_units = random.below(3) == 0;
        let atom = Atom { expression: Expr::Time, dimension: Dimension::TIME, level: Level::Shape };
        Generator {
            random,
            statements: Vec::new(),
            with_units,
            names: 0,
            atoms: vec![atom],
            functions: Vec::new(),
        }
    }

    fn chance(&mut self, one_in: usize) -> bool {
        self.random.below(one_in) == 0
    }

    /// Declares a quantity that may change from outside.
    fn input(&mut self) {
        let name = self.fresh("u");
        let values = Values::One(self.decimal(-2.0, 2.0));
        self.say(Statement::Values { word: "input", name: name.clone(), unit: None, values });
        let expression = Expr::Name(name);
        self.atoms.push(Atom { expression, dimension: Dimension::NONE, level: Level::Force });
    }

    /// Returns an unused name.
    fn fresh(&mut self, stem: &str) -> String {
        self.names += 1;
        format!("{stem}{}", self.names)
    }

    fn say(&mut self, statement: Statement) {
        self.statements.push(statement);
    }

    /// Declares a coordinate.
    fn coordinate(&mut self, stem: &str, dimension: Dimension) -> Expr {
        let name = self.fresh(stem);
        let unit = self.coherent_unit(dimension);
        self.say(Statement::Coordinate { name: name.clone(), unit, count: None });
        let expression = Expr::Name(name);
        self.remember_coordinate(&expression, dimension);
        expression
    }

    /// Makes a coordinate and its rate available to expressions.
    fn remember_coordinate(&mut self, expression: &Expr, dimension: Dimension) {
        let rate = crate::tree::rate(expression.clone());
        self.atoms.push(Atom { expression: expression.clone(), dimension, level: Level::Shape });
        self.atoms.push(Atom { expression: rate, dimension: dimension.rate(), level: Level::Force });
    }
}
