//! Random programs of all operations, and random declarations, have the bits of the interpreter.
//! Too few numbers, and programs that are too large, are refused.

mod equality;

use equality::{Checked, Random, are_same, solving};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::elementary::ROWS;
use lagrange_core::expr::Relation;
use lagrange_core::number::Number;
use lagrange_core::pipeline::{Code, Layout, Numbers, NumericSystem, Programs, parse};
use lagrange_core::program::{Builder, Float, Op, Program, ValueId};
use lagrange_core::symbol::Role;
use lagrange_jit::{CompileError, Compiler, LARGEST_PROGRAM};

const LAYOUT: Layout =
    Layout { positions: 3, velocities: 2, parameters: 2, inputs: 1, sides: 2, multipliers: 1, reactions: 2 };
const ROLES: [Role; 12] = [
    Role::Time,
    Role::Coordinate(1),
    Role::State(2),
    Role::Discrete(0),
    Role::Velocity(1),
    Role::Parameter(1),
    Role::Input(0),
    Role::Side(1),
    Role::Multiplier(0),
    Role::Acceleration(1),
    Role::Reaction(1),
    // This role has no number, so it is NaN.
    Role::Noise(0),
];
const RELATIONS: [Relation; 4] =
    [Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual];

/// Returns a program of random operations on earlier values.
fn random_program(random: &mut Random, length: usize) -> Program {
    let mut builder = Builder::new();
    let mut values = ROLES.map(|role| builder.push(Op::Input(role))).to_vec();
    while values.len() < length {
        let value = random_operation(random, &values, &mut builder);
        values.push(value);
    }
    builder.finish(&values)
}

fn random_operation(random: &mut Random, values: &[ValueId], builder: &mut Builder) -> ValueId {
    let mut pick = || values[random.next() as usize % values.len()];
    let [a, b, c, d] = [pick(), pick(), pick(), pick()];
    let (choice, detail) = (random.next() % 18, random.next() as usize);
    match choice {
        0 => builder.push(Op::Add(a, b)),
        1 => builder.push(Op::Subtract(a, b)),
        2 => builder.push(Op::Multiply(a, b)),
        3 => builder.push(Op::Divide(a, b)),
        4 => builder.push(Op::Negate(a)),
        5 => builder.push(Op::MultiplyAdd(a, b, c)),
        6 => builder.push(Op::MultiplySubtract(a, b, c)),
        7 => builder.push(Op::SubtractProduct(a, b, c)),
        8 => builder.push(Op::Power(a, detail as i32 % 40)),
        9 => builder.constant(Number::from((detail % 1000) as i64)),
        10 => builder.push(Op::Float(Float::new(0.1 * (detail % 100) as f64))),
        11 => {
            let pair = builder.push(Op::SinCos(a));
            builder.push(if detail % 2 == 0 { Op::SinOf(pair) } else { Op::CosOf(pair) })
        }
        12 => {
            // Batches of one to six angles, where four are computed at a time.
            let angles = [a, b, c, d, a, b][..1 + detail % 6].into();
            let (batch, place) = (builder.push(Op::SinCosEach(angles)), (detail % (1 + detail % 6)) as u32);
            builder.push(if detail % 2 == 0 { Op::SinIn(batch, place) } else { Op::CosIn(batch, place) })
        }
        13 => {
            let relation = RELATIONS[detail % RELATIONS.len()];
            builder.push(Op::Select { relation, left: a, right: b, then: c, otherwise: d })
        }
        _ => {
            let row = &ROWS[detail % ROWS.len()];
            builder.call(row.function, &[a, b][..row.arity])
        }
    }
}

#[test]
fn random_programs_have_the_bits_of_the_interpreter() {
    let (mut checked, mut random, call) = (Checked::default(), Random(1), solving(&[]));
    for _ in 0..100 {
        let length = 12 + random.next() as usize % 100;
        let program = random_program(&mut random, length);
        checked.compare(&program, &LAYOUT, &call).unwrap_or_else(|message| panic!("{message}"));
    }
    assert_eq!(
        checked.kinds.len(),
        20,
        "all operations but functions without a formula: {:?}",
        checked.kinds
    );
    assert!(checked.finite * 4 > checked.outputs, "{checked:?}");
}

/// Returns a term of the language in x, y, their rates, a parameter and the time.
fn random_term(random: &mut Random, depth: u32) -> String {
    const LEAVES: [&str; 7] = ["x", "y", "dot(x)", "k", "t", "0.7", "3"];
    const FUNCTIONS: [&str; 12] =
        ["sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "ln", "sqrt"];
    let choice = random.next();
    if depth == 0 {
        return LEAVES[choice as usize % LEAVES.len()].to_owned();
    }
    let (a, b) = (random_term(random, depth - 1), random_term(random, depth - 1));
    match choice % 8 {
        0 => format!("({a} + {b})"),
        1 => format!("{a} * {b}"),
        2 => format!("({a}) / (2 + ({b})^2)"),
        3 => format!("max({a}, {b})"),
        4 => format!("(if {a} < {b} {{ {a} }} else {{ {b} }})"),
        5 => format!("abs({a}) * hypot({a}, {b})"),
        _ => format!("{}({a})", FUNCTIONS[(choice >> 8) as usize % FUNCTIONS.len()]),
    }
}

#[test]
fn random_declarations_have_the_bits_of_the_interpreter() {
    let (mut checked, mut random, mut systems) = (Checked::default(), Random(2), 0);
    for _ in 0..60 {
        let [force, along] = [3, 2].map(|depth| random_term(&mut random, depth));
        let text = format!(
            "emit {{ jacobian }} param k = 2; coord x, y; kinetic = 1/2 * (dot(x)^2 + (2 + cos(x)) * dot(y)^2);
             potential = k * sin(x) * y^2; force x = {force}; force y = {along}; output pushed = {force};"
        );
        let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        // Some terms are undefined everywhere, which is an error.
        let Ok(derived) = derived else { continue };
        systems += 1;
        checked.check(&Programs::new(&derived)).unwrap_or_else(|message| panic!("{text}: {message}"));
    }
    assert!(systems > 40, "{systems} systems");
    assert!(checked.finite * 4 > checked.outputs, "{checked:?}");
}

/// A system in which one call solves for both unknowns, and a table provides a value.
const COUPLED: &str =
    "coord x = 0.2; table lift(s) = [(0, 0), (1, 2), (2, 3)], interpolation: natural, outside: extend;
    solve (a, b): 0 = a + 0.1 * sin(b) - x, 0 = b + 0.1 * cos(a) - 2 * x;
    kinetic = 1/2 * dot(x)^2; force x = lift(x) + a * b + a;";

#[test]
fn callbacks_return_the_values_of_the_interpreter() {
    let derived = parse(COUPLED).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let interpreted = NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    let compiler = Compiler::for_this_processor().expect("a known processor");
    let compiled = interpreted.clone().compiled_by(compiler);
    for x in [0.0, 0.2, 0.7, 1.5] {
        let (wanted, found) = (interpreted.rhs(0.0, &[x, 0.1]), compiled.rhs(0.0, &[x, 0.1]));
        assert!(wanted.iter().all(|rate| rate.is_finite()));
        assert_eq!(found, wanted);
    }
}

#[test]
fn functions_that_are_defined_later_are_interpreted() {
    let text = "function height(x); coord x; kinetic = 1/2 * dot(x)^2; potential = height(x);";
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let numeric = NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    let mut system = numeric.compiled_by(Compiler::for_this_processor().expect("a known processor"));
    assert!(system.acceleration(0.0, &[0.5], &[0.0])[0].is_nan());
    system.define("height_derivative", |x| 3.0 * x[0]);
    assert_eq!(system.acceleration(0.0, &[0.5], &[0.0]), [-1.5]);
}

#[test]
fn short_lists_and_other_lengths_of_outputs_are_refused() {
    let mut builder = Builder::new();
    let (x, k) = (builder.push(Op::Input(Role::Coordinate(2))), builder.push(Op::Input(Role::Input(0))));
    let sum = builder.add(x, k);
    let compiler = Compiler::for_this_processor().expect("a known processor");
    let code = compiler.code(&builder.finish(&[sum]), &LAYOUT, &solving(&[])).expect("it is small");
    let run = |positions: &[f64], fields: &[f64], outputs: &mut [f64]| {
        let [velocities, sides, multipliers, accelerations, reactions] = [&[][..]; 5];
        code.run(
            &Numbers { t: 0.0, positions, velocities, fields, sides, multipliers, accelerations, reactions },
            outputs,
        )
    };
    let mut output = [7.0];
    assert!(!run(&[1.0; 2], &[1.0; 3], &mut output) && !run(&[1.0; 3], &[1.0; 2], &mut output));
    assert!(!run(&[1.0; 3], &[1.0; 3], &mut []) && !run(&[1.0; 3], &[1.0; 3], &mut [0.0; 2]));
    assert_eq!(output, [7.0]);
    assert!(run(&[1.0; 3], &[1.0; 3], &mut output) && are_same(output[0], 2.0));
}

/// Returns a program of sums of earlier values.
fn sums(length: usize) -> Program {
    let mut builder = Builder::new();
    let mut values = vec![builder.push(Op::Input(Role::Time))];
    while values.len() < length {
        let (last, earlier) = (values[values.len() - 1], values[values.len() / 2]);
        values.push(builder.add(last, earlier));
    }
    builder.finish(&values[length - 1..])
}

#[test]
fn large_programs_are_refused_and_those_within_the_limit_run() {
    let (largest, call) = (LARGEST_PROGRAM / 3, solving(&[]));
    Checked::default().compare(&sums(largest), &LAYOUT, &call).unwrap_or_else(|message| panic!("{message}"));
    let compiler = Compiler::for_this_processor().expect("a known processor");
    let refused = compiler.code(&sums(largest + 2), &LAYOUT, &call);
    assert!(matches!(refused, Err(CompileError::TooLarge(_))));
}
