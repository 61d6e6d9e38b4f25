use super::{Entry, Motion, Rate, SeriesPrograms, Slot, expand, function_rates, without_long_powers};
use crate::program::{Labels, Program, ValueId, lower, run};
use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Highest order in these tests.
const ORDER: usize = 24;

/// A motion as expressions.
struct Expressions {
    graph: Graph,
    state: Vec<(ExprId, Option<ExprId>)>,
    unexpanded: Vec<(ExprId, ExprId)>,
    residuals: Vec<ExprId>,
}

impl Expressions {
    fn programs(&mut self) -> (SeriesPrograms, Program) {
        let entries = self.state.iter().flat_map(|(entry, rate)| [Some(*entry), *rate]).flatten();
        let unexpanded = self.unexpanded.iter().map(|(_, of)| *of);
        let mut roots = entries.chain(unexpanded).collect::<Vec<_>>();
        roots.extend(&self.residuals);
        let functions = function_rates(&mut self.graph, &roots);
        roots.extend(functions.iter().flat_map(|(value, rate)| [*value, *rate]));
        let program = without_long_powers(&lower(&self.graph, &roots, &Labels::default()));
        let mut values = program.outputs().iter().copied();
        let mut next = || values.next().unwrap();
        let mut index = 0;
        let state = self.state.iter().map(|(_, rate)| Entry {
            value: next(),
            rate: match rate {
                Some(_) => Rate::Value(next()),
                None => {
                    index += 1;
                    Rate::Acceleration(index - 1)
                }
            },
        });
        let state = state.collect::<Vec<_>>();
        let role = |id: ExprId| self.graph.symbol_of(id).unwrap().role;
        let unexpanded =
            self.unexpanded.iter().map(|(symbol, _)| (role(*symbol), next())).collect::<Vec<_>>();
        let residuals = self.residuals.iter().map(|_| next()).collect::<Vec<_>>();
        let rates = functions.iter().map(|_| (next(), next())).collect::<Vec<(ValueId, ValueId)>>();
        let motion = Motion {
            program: &program,
            state: &state,
            rates: &rates,
            unexpanded: &unexpanded,
            residuals: &residuals,
        };
        (expand(&motion).unwrap(), program)
    }
}

/// Returns the coefficients of the state, order by order.
fn expanded(programs: &SeriesPrograms, value_of: impl Fn(Role) -> f64, state: &[f64]) -> Vec<Vec<f64>> {
    let initial = run(&programs.initial, &value_of);
    let (initial, matrix) = initial.split_at(programs.initials);
    let mut kept: Vec<Vec<f64>> = vec![Vec::new(); programs.kept];
    let mut coefficients = vec![state.to_vec()];
    for k in 0..ORDER {
        let convolution = |[a, b]: [usize; 2]| (0..k).map(|j| kept[a][j] * kept[b][k - 1 - j]).sum::<f64>();
        let sums = programs.sums.iter().map(|factors| convolution(*factors)).collect::<Vec<_>>();
        let carried = |index: usize| {
            let (place, first) = programs.carried[index];
            kept[place].last().copied().unwrap_or(initial[first])
        };
        let slot = |slot: Slot, partial: &[f64], accelerations: &[f64]| match slot {
            Slot::Initial(index) => initial[index],
            Slot::Carried(index) => carried(index),
            Slot::Integral(index) => carried(index) / (k + 1) as f64,
            Slot::Sum(index) => sums[index],
            Slot::Partial(index) => partial[index],
            Slot::Acceleration(index) => accelerations[index as usize],
            Slot::Velocity(index) => accelerations[index as usize] / (k + 1) as f64,
            Slot::Order => (k + 1) as f64,
            Slot::Reciprocal => 1.0 / (k + 1) as f64,
            Slot::First => f64::from(u8::from(k == 0)),
        };
        let with = |program: &Program, partial: &[f64], accelerations: &[f64]| {
            run(program, |role| match role {
                Role::Placeholder(index) => slot(programs.slots[index as usize], partial, accelerations),
                _ => value_of(role),
            })
        };
        let mut values = with(&programs.expansion, &[], &[]);
        if let Some(correction) = &programs.correction {
            let residuals = values.split_off(programs.kept);
            let accelerations = solved(matrix, &residuals);
            values = with(correction, &values, &accelerations);
        }
        kept.iter_mut().zip(&values).for_each(|(kept, value)| kept.push(*value));
        coefficients.push(values[..state.len()].to_vec());
    }
    coefficients
}

/// Solves M a = −r by Cramer's rule, for one or two unknowns.
fn solved(matrix: &[f64], residuals: &[f64]) -> Vec<f64> {
    match (matrix, residuals) {
        (&[m], &[r]) => vec![-r / m],
        (&[a, b, c, d], &[r, s]) => {
            let determinant = a * d - b * c;
            vec![(b * s - d * r) / determinant, (c * r - a * s) / determinant]
        }
        _ => panic!("more than two unknowns"),
    }
}

/// Compares both sides at points: the coefficient of order k of the rate equals (k + 1) times that
/// of order k + 1 of the state.
fn defect(coefficients: &[Vec<f64>], h: f64, rhs: impl Fn(f64, &[f64]) -> Vec<f64>) -> f64 {
    let size = coefficients[0].len();
    let polynomial = |i: usize| coefficients.iter().rev().fold(0.0, |value, row| value * h + row[i]);
    let slope = |i: usize| {
        let orders = coefficients.iter().enumerate().skip(1).rev();
        orders.fold(0.0, |value, (order, row)| value * h + order as f64 * row[i])
    };
    let state = (0..size).map(polynomial).collect::<Vec<_>>();
    let rates = rhs(h, &state);
    (0..size).map(|i| (slope(i) - rates[i]).abs()).fold(0.0, f64::max)
}

fn pendulum_graph() -> (Graph, ExprId, ExprId) {
    let mut graph = Graph::new();
    let theta = graph.symbol("theta", Role::Coordinate(0));
    let omega = graph.symbol("theta", Role::Velocity(0));
    (graph, theta, omega)
}

fn value_of(state: &[f64]) -> impl Fn(Role) -> f64 {
    let n = state.len() / 2;
    move |role| match role {
        Role::Coordinate(i) => state[i as usize],
        Role::Velocity(i) => state[n + i as usize],
        Role::Time => 0.0,
        _ => f64::NAN,
    }
}

#[test]
fn the_worked_pendulum_has_these_coefficients() {
    let (mut graph, theta, omega) = pendulum_graph();
    let sine = apply(&mut graph, Function::Sin, &[theta]);
    let acceleration = graph.scale(Number::from(-10), sine);
    let state = vec![(theta, Some(omega)), (omega, Some(acceleration))];
    let mut motion = Expressions { graph, state, unexpanded: Vec::new(), residuals: Vec::new() };
    let (programs, _) = motion.programs();
    let start = [0.6_f64.asin(), 1.0];
    let found = expanded(&programs, value_of(&start), &start);
    let expected = [[1.0, -6.0], [-3.0, -4.0]];
    for (found, expected) in found[1..].iter().zip(expected) {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }
    assert!(defect(&found, 0.1, |_, y| vec![y[1], -10.0 * y[0].sin()]) < 1e-13);
}

/// Returns the rates of a state with one coordinate and its velocity, evaluated from the
/// acceleration as an expression.
fn rates(graph: &Graph, acceleration: ExprId) -> impl Fn(f64, &[f64]) -> Vec<f64> {
    move |t, y| {
        let value = lagrange_expr::expr::evaluate(graph, &[acceleration], |role| match role {
            Role::Coordinate(_) => y[0],
            Role::Velocity(_) => y[1],
            Role::Time => t,
            _ => f64::NAN,
        });
        vec![y[1], value[0]]
    }
}

fn check_explicit(name: &str, acceleration: impl Fn(&mut Graph, ExprId, ExprId, ExprId) -> ExprId) {
    let (mut graph, x, v) = pendulum_graph();
    let t = graph.symbol("t", Role::Time);
    let acceleration = acceleration(&mut graph, x, v, t);
    let state = vec![(x, Some(v)), (v, Some(acceleration))];
    let mut motion = Expressions { graph, state, unexpanded: Vec::new(), residuals: Vec::new() };
    let (programs, _) = motion.programs();
    let start = [0.4, -0.3];
    let found = expanded(&programs, value_of(&start), &start);
    let error = defect(&found, 0.1, rates(&motion.graph, acceleration));
    assert!(error < 1e-12, "{name}: {error:e}");
}

#[test]
fn every_function_has_its_series() {
    for row in &lagrange_expr::elementary::ROWS {
        // Arguments within all domains, away from kinks, as functions of position, velocity and
        // time.
        check_explicit(row.name, |graph, x, v, t| {
            let constant = graph.number(Number::HALF);
            let scaled = [(x, Number::HALF), (v, Number::HALF), (t, Number::HALF)];
            let first = graph.sum(Number::HALF, scaled);
            let second = graph.product([(first, Number::TWO), (constant, Number::ONE)]);
            let arguments = [first, second];
            apply(graph, row.function, &arguments[..row.arity])
        });
    }
}

#[test]
fn quotients_powers_and_choices_have_theirs() {
    let one_plus_square = |graph: &mut Graph, x: ExprId| {
        let square = graph.square(x);
        graph.sum(Number::ONE, [(square, Number::ONE)])
    };
    check_explicit("x/(1 + v²)", |graph, x, v, _| {
        let below = one_plus_square(graph, v);
        graph.divide(x, below)
    });
    check_explicit("(1 + x²)^(-5/2) v", |graph, x, v, _| {
        let base = one_plus_square(graph, x);
        let exponent = &Number::from(-5) * &Number::HALF;
        graph.product([(base, exponent), (v, Number::ONE)])
    });
    check_explicit("x³ v^7 t", |graph, x, v, t| {
        graph.product([(x, Number::from(3)), (v, Number::from(7)), (t, Number::ONE)])
    });
    check_explicit("if x < v { x } else { x v }", |graph, x, v, _| {
        let product = graph.multiply(x, v);
        graph.choose(lagrange_expr::expr::Relation::Less, x, v, x, product)
    });
    check_explicit("(1 + x²)^(-17/10) v^(4/3) of a positive v", |graph, x, v, _| {
        let bases = [one_plus_square(graph, x), one_plus_square(graph, v)];
        let exponents = [(-17, 10), (4, 3)]
            .map(|(above, below)| &Number::from(above) * &Number::from(below).reciprocal().unwrap());
        graph.product(bases.into_iter().zip(exponents).collect::<Vec<_>>())
    });
    check_explicit("(2 x + v)^71", |graph, x, v, _| {
        let base = graph.sum(Number::ZERO, [(x, Number::TWO), (v, Number::ONE)]);
        graph.power(base, Number::from(71))
    });
    check_explicit("(1 + x²)^-71", |graph, x, _, _| {
        let base = one_plus_square(graph, x);
        graph.power(base, Number::from(-71))
    });
    check_explicit("2", |graph, _, _, _| graph.number(2));
    check_explicit("0", |graph, _, _, _| graph.number(0));
    check_explicit("t", |_, _, _, t| t);
}

/// A double pendulum with unit masses and lengths under unit gravity, with the rates of its
/// velocities as unknowns.
#[test]
fn accelerations_follow_from_residuals() {
    let mut graph = Graph::new();
    let angles = [0, 1].map(|i| graph.symbol(["a", "b"][i], Role::Coordinate(i as u32)));
    let speeds = [0, 1].map(|i| graph.symbol(["a", "b"][i], Role::Velocity(i as u32)));
    let sines = angles.map(|angle| apply(&mut graph, Function::Sin, &[angle]));
    let cosines = angles.map(|angle| apply(&mut graph, Function::Cos, &[angle]));
    let x = [0, 1].map(|i| graph.multiply(cosines[i], speeds[i]));
    let y = [0, 1].map(|i| graph.multiply(sines[i], speeds[i]));
    let velocities = [x[0], y[0], graph.add(x[0], x[1]), graph.add(y[0], y[1])];
    let names = ["x1", "y1", "x2", "y2"];
    let rates = [0, 1, 2, 3].map(|i| graph.symbol(names[i], Role::Placeholder(i as u32)));
    let [x1, y1, x2, y2] = rates;
    let [y1, y2] = [y1, y2].map(|rate| graph.sum(Number::ONE, [(rate, Number::ONE)]));
    let across = [graph.add(x1, x2), x2];
    let along = [graph.add(y1, y2), y2];
    let residuals = [0, 1].map(|i| {
        let terms = [graph.multiply(cosines[i], across[i]), graph.multiply(sines[i], along[i])];
        graph.total(terms)
    });
    let state = vec![
        (angles[0], Some(speeds[0])),
        (angles[1], Some(speeds[1])),
        (speeds[0], None),
        (speeds[1], None),
    ];
    let unexpanded = rates.into_iter().zip(velocities).collect();
    let mut motion = Expressions { graph, state, unexpanded, residuals: residuals.to_vec() };
    let (programs, _) = motion.programs();
    // Four products for each angle: the components of its velocity, which are the rates of sine and
    // cosine, and those of the force.
    assert_eq!(programs.sums.len(), 8);
    assert_eq!(programs.blocks, [[0, 1]]);
    let start = [2.0, 1.5, 0.3, -0.2];
    let found = expanded(&programs, value_of(&start), &start);
    let error = defect(&found, 0.1, |_, y| {
        let ((s, c), (sb, cb)) = ((y[0] - y[1]).sin_cos(), (y[1].sin(), y[0].sin()));
        let forces = [-s * y[3] * y[3] - 2.0 * cb, s * y[2] * y[2] - sb];
        let determinant = 2.0 - c * c;
        vec![
            y[2],
            y[3],
            (forces[0] - c * forces[1]) / determinant,
            (2.0 * forces[1] - c * forces[0]) / determinant,
        ]
    });
    assert!(error < 1e-12, "{error:e}");
}
