//! Laws for the equations of every machine. The Lagrangian, the loads and the Rayleigh function of
//! the checked model are evaluated by reference code, and differentiated by finite differences. So
//! no part of the derivation is used to check itself.

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::expr::ExprId;
use lagrange_core::expr::evaluate;
use lagrange_core::model::{Model, Product};
use lagrange_core::pipeline::{NumericSystem, parse};
use lagrange_core::symbol::Role;
use proptest::prelude::{prop_assert, prop_assert_eq, prop_assume, proptest};

use crate::machines::{Machine, machines};
use crate::trees::trees;

/// Bounds the error of fourth-order finite differences and of their use in sums.
const DIFFERENCED: f64 = 1e-6;
/// Bounds rounding in differently ordered sums and eliminations.
const ROUNDED: f64 = 1e-9;
/// Bounds rounding in trees of well-conditioned bodies.
const ROUNDED_IN_TREES: f64 = 1e-11;

/// A machine's model beside the equations derived from it, at its state.
struct Laboratory {
    model: Model,
    strategy: Strategy,
    derived: NumericSystem,
    t: f64,
    q: Vec<f64>,
    v: Vec<f64>,
}

impl Laboratory {
    fn new(machine: &Machine, choice: StrategyChoice) -> Laboratory {
        let system = parse(&machine.text).unwrap_or_else(|report| panic!("{report}"));
        let model = system.model.clone();
        let derived = system.derive(choice).unwrap_or_else(|report| panic!("{report}"));
        let Machine { t, q, v, .. } = machine.clone();
        let strategy = derived.equations.strategy;
        Laboratory { model, strategy, derived: NumericSystem::new(&derived), t, q, v }
    }

    fn size(&self) -> usize {
        self.q.len()
    }

    fn product(&self, product: Product) -> Vec<f64> {
        self.derived.product(product, self.t, &self.q, &self.v).expect("it is emitted")
    }

    fn acceleration(&self) -> Vec<f64> {
        self.derived.acceleration(self.t, &self.q, &self.v)
    }

    fn inverse_dynamics(&self, a: &[f64]) -> Vec<f64> {
        self.derived.inverse_dynamics(self.t, &self.q, &self.v, a).expect("it is derived by default")
    }

    /// Returns the value of an expression of the model.
    fn value(&self, expression: ExprId) -> f64 {
        let graph = &self.model.graph;
        let constant = |default: Option<ExprId>| {
            evaluate(graph, &[default.expect("every parameter has a default")], |_| f64::NAN)[0]
        };
        evaluate(graph, &[expression], |role| match role {
            Role::Parameter(i) => constant(self.model.parameters[i as usize].default),
            Role::Input(i) => constant(self.model.inputs[i as usize].default),
            Role::Time => self.t,
            Role::Coordinate(i) => self.q[i as usize],
            Role::Velocity(i) => self.v[i as usize],
            Role::Acceleration(_)
            | Role::Multiplier(_)
            | Role::Reaction(_)
            | Role::Noise(_)
            | Role::Side(_)
            | Role::State(_)
            | Role::Discrete(_)
            | Role::Operand(_)
            | Role::Placeholder(_) => f64::NAN,
        })[0]
    }

    /// Returns the derivative of `f` while the state moves at a rate, by a central difference of
    /// fourth order.
    fn slope(&mut self, rate: &Rate, f: impl Fn(&Laboratory) -> f64) -> f64 {
        // No variable changes by more than 10⁻³.
        let step = 1e-3 / rate.q.iter().chain(&rate.v).fold(1.0, |largest: f64, r| largest.max(r.abs()));
        let (t, q, v) = (self.t, self.q.clone(), self.v.clone());
        let moved = |start: &[f64], rate: &[f64], step: f64| {
            start.iter().zip(rate).map(|(start, rate)| start + step * rate).collect::<Vec<_>>()
        };
        let mut at = |step: f64| {
            (self.t, self.q, self.v) =
                (t + step * rate.t, moved(&q, &rate.q, step), moved(&v, &rate.v, step));
            f(self)
        };
        let near = at(step) - at(-step);
        let far = at(2.0 * step) - at(-2.0 * step);
        (self.t, self.q, self.v) = (t, q, v);
        (8.0 * near - far) / (12.0 * step)
    }

    /// Returns ∂f/∂v.
    fn velocity_slopes(&mut self, f: impl Fn(&Laboratory) -> f64) -> Vec<f64> {
        (0..self.size()).map(|i| self.slope(&Rate::of_velocity(self.size(), i), &f)).collect()
    }

    /// Returns ∂f/∂q.
    fn position_slopes(&mut self, f: impl Fn(&Laboratory) -> f64) -> Vec<f64> {
        (0..self.size()).map(|i| self.slope(&Rate::of_position(self.size(), i), &f)).collect()
    }

    fn lagrangian(&self) -> f64 {
        self.value(self.model.lagrangian)
    }

    /// Returns the generalised forces of loads and dissipation. Velocities of loads are affine, so
    /// their coefficients are plain differences.
    fn applied_forces(&mut self) -> Vec<f64> {
        let mut forces = self.velocity_slopes(|laboratory| -laboratory.value(laboratory.model.dissipation));
        let v = std::mem::take(&mut self.v);
        for load in self.model.loads.clone() {
            self.v.clone_from(&v);
            let force = self.value(load.force);
            self.v = vec![0.0; v.len()];
            let offset = self.value(load.velocity);
            for (i, total) in forces.iter_mut().enumerate() {
                self.v[i] = 1.0;
                *total += force * (self.value(load.velocity) - offset);
                self.v[i] = 0.0;
            }
        }
        self.v = v;
        forces
    }
}

/// A direction in the space of time and states.
struct Rate {
    t: f64,
    q: Vec<f64>,
    v: Vec<f64>,
}

impl Rate {
    fn of_time(n: usize) -> Rate {
        Rate { t: 1.0, q: vec![0.0; n], v: vec![0.0; n] }
    }

    fn of_position(n: usize, i: usize) -> Rate {
        Rate { t: 0.0, q: unit(n, i), v: vec![0.0; n] }
    }

    fn of_velocity(n: usize, i: usize) -> Rate {
        Rate { t: 0.0, q: vec![0.0; n], v: unit(n, i) }
    }
}

fn unit(n: usize, i: usize) -> Vec<f64> {
    (0..n).map(|j| f64::from(u8::from(i == j))).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn sum(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

/// Returns the product of a matrix, in rows, and a vector.
fn times(matrix: &[f64], vector: &[f64]) -> Vec<f64> {
    matrix.chunks(vector.len()).map(|row| dot(row, vector)).collect()
}

/// True if two vectors agree relative to their largest entry and to `scale`.
fn agree(a: &[f64], b: &[f64], tolerance: f64, scale: f64) -> bool {
    let largest = a.iter().chain(b).fold(1.0 + scale, |largest, x| largest.max(x.abs()));
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance * largest)
}

/// True if a symmetric matrix has a Cholesky factor.
fn is_positive_definite(matrix: &[f64], n: usize) -> bool {
    let mut factor = vec![0.0; n * n];
    (0..n).all(|i| {
        for j in 0..=i {
            let known = dot(&factor[i * n..i * n + j], &factor[j * n..j * n + j]);
            let rest = matrix[i * n + j] - known;
            factor[i * n + j] = if i == j { rest.sqrt() } else { rest / factor[j * n + j] };
        }
        factor[i * n + i] > 0.0
    })
}

/// Sliders on an arm in space. Eliminating any one of them first leaves squares of all others.
const SLIDERS_ON_AN_ARM: &str = "
    param m1 = 0.2, l1 = 0.3; coord q1;
    let p1 = (l1*sin(q1), -l1*cos(q1), 0);
    kinetic = kinetic_energy(m1, dot(p1));
    param m2 = 0.2; coord q2;
    let p2 = p1 + (q2*sin(q1), -q2*cos(q1), q2/3);
    kinetic = kinetic_energy(m2, dot((p2 + p1)/2)) + kinetic_energy(1/4, dot(p2));
    param m4 = 1.4; coord q4;
    let p4 = p2 + (q4*sin(q1), -q4*cos(q1), q4/3);
    kinetic = kinetic_energy(m4*5, dot(p4)) + 1/2*m4*dot(q4)^2;
    param m5 = 1.7, l5 = 0.8; coord q5;
    let p5 = p4 + (q5*sin(q1), -q5*cos(q1), q5/3);
    kinetic = kinetic_energy(m5, dot((p5 + p4)/2)) + 1/2*m5*l5^2/12*dot(q1)^2 + kinetic_energy(1/4, dot(p5));
";

#[test]
fn squares_that_fill_in_leave_the_mass_matrix_to_be_solved() {
    let (q, v) = (vec![0.3, 0.5, -0.4, 0.7], vec![1.0, -0.2, 0.6, 0.1]);
    let machine = Machine { text: SLIDERS_ON_AN_ARM.to_owned(), t: 0.0, q, v };
    let [squares, dense] = [Strategy::SumOfSquares, Strategy::MassMatrix]
        .map(|strategy| Laboratory::new(&machine, StrategyChoice::Always(strategy)));
    assert_eq!(squares.strategy, Strategy::MassMatrix);
    assert_eq!(squares.acceleration(), dense.acceleration());
}

proptest! {
    #![proptest_config(crate::one_in(5))]

    #[test]
    fn the_mass_matrix_is_symmetric_and_positive_definite(machine in machines()) {
        let laboratory = Laboratory::new(&machine, StrategyChoice::Cheapest);
        let (matrix, n) = (laboratory.product(Product::MassMatrix), laboratory.size());
        for i in 0..n {
            for j in 0..i {
                prop_assert_eq!(matrix[i * n + j].to_bits(), matrix[j * n + i].to_bits());
            }
        }
        prop_assert!(is_positive_definite(&matrix, n), "{matrix:?}");
    }

    #[test]
    fn articulated_bodies_lead_to_the_same_accelerations(machine in machines()) {
        let strategies = [Strategy::MassMatrix, Strategy::ArticulatedBody].map(StrategyChoice::Always);
        let [dense, recursive] = strategies.map(|strategy| Laboratory::new(&machine, strategy).acceleration());
        prop_assert!(agree(&dense, &recursive, ROUNDED, 0.0), "{dense:?} or {recursive:?}");
    }

    #[test]
    fn the_strict_level_leads_to_the_same_accelerations(machine in machines()) {
        let dense = Laboratory::new(&machine, StrategyChoice::Always(Strategy::MassMatrix)).acceleration();
        let strict = Laboratory::new(&machine.strict(), StrategyChoice::Cheapest).acceleration();
        prop_assert!(agree(&dense, &strict, ROUNDED, 0.0), "{dense:?} or {strict:?}");
    }

    #[test]
    fn sums_of_squares_lead_to_the_same_accelerations(tree in trees()) {
        let dense = Laboratory::new(&tree, StrategyChoice::Always(Strategy::MassMatrix)).acceleration();
        let squares = StrategyChoice::Always(Strategy::SumOfSquares);
        for machine in [tree.strict(), tree] {
            let laboratory = Laboratory::new(&machine, squares);
            // For a few trees the squares fill in so much that the mass matrix is shorter.
            prop_assume!(laboratory.strategy == Strategy::SumOfSquares);
            let found = laboratory.acceleration();
            prop_assert!(agree(&dense, &found, ROUNDED_IN_TREES, 0.0), "{dense:?} or {found:?}");
        }
    }

    /// dh/dt = v·Q − ∂L/∂t
    #[test]
    fn energy_changes_by_power_and_by_explicit_time(machine in machines()) {
        let mut laboratory = Laboratory::new(&machine, StrategyChoice::Cheapest);
        let flow = Rate { t: 1.0, q: laboratory.v.clone(), v: laboratory.acceleration() };
        let change = laboratory.slope(&flow, |laboratory| laboratory.product(Product::Energy)[0]);
        let power = dot(&laboratory.applied_forces(), &machine.v);
        let explicit = laboratory.slope(&Rate::of_time(laboratory.size()), Laboratory::lagrangian);
        let scale = dot(&laboratory.product(Product::Forcing), &machine.v).abs();
        prop_assert!(agree(&[change], &[power - explicit], DIFFERENCED, scale), "{change} for {power} - {explicit}");
    }

    #[test]
    fn inverse_dynamics_and_accelerations_undo_each_other(machine in machines()) {
        let laboratory = Laboratory::new(&machine, StrategyChoice::Cheapest);
        let (matrix, forcing) = (laboratory.product(Product::MassMatrix), laboratory.product(Product::Forcing));
        let acceleration = laboratory.acceleration();
        let scale = forcing.iter().fold(0.0_f64, |largest, f| largest.max(f.abs()));
        let nothing = laboratory.inverse_dynamics(&acceleration);
        prop_assert!(agree(&nothing, &vec![0.0; forcing.len()], ROUNDED, scale), "{nothing:?}");
        // Any other acceleration needs the additional force M (a' − a).
        let change = machine.q.iter().map(|q| 3.0 * q - 1.0).collect::<Vec<_>>();
        let other = acceleration.iter().zip(&change).map(|(a, change)| a + change).collect::<Vec<_>>();
        let (found, needed) = (laboratory.inverse_dynamics(&other), times(&matrix, &change));
        prop_assert!(agree(&found, &needed, ROUNDED, scale), "{found:?} for {needed:?}");
    }

    #[test]
    fn momenta_and_masses_are_slopes_of_the_lagrangian(machine in machines()) {
        let mut laboratory = Laboratory::new(&machine, StrategyChoice::Cheapest);
        let momenta = laboratory.product(Product::Momenta);
        let slopes = laboratory.velocity_slopes(Laboratory::lagrangian);
        prop_assert!(agree(&momenta, &slopes, DIFFERENCED, 0.0), "{momenta:?} for {slopes:?}");
        let matrix = laboratory.product(Product::MassMatrix);
        for (i, row) in matrix.chunks(momenta.len()).enumerate() {
            let slopes = laboratory.velocity_slopes(|laboratory| laboratory.product(Product::Momenta)[i]);
            prop_assert!(agree(row, &slopes, DIFFERENCED, 0.0), "{row:?} for {slopes:?}");
        }
        let energy = laboratory.product(Product::Energy);
        let function = dot(&momenta, &machine.v) - laboratory.lagrangian();
        prop_assert!(agree(&energy, &[function], ROUNDED, 0.0), "{energy:?} for {function}");
    }

    /// f = ∂L/∂q − (∂p/∂q) v − ∂p/∂t + Q
    #[test]
    fn forcing_is_that_of_euler_and_lagrange(machine in machines()) {
        let mut laboratory = Laboratory::new(&machine, StrategyChoice::Cheapest);
        let n = laboratory.size();
        let drift = Rate { t: 1.0, q: machine.v.clone(), v: vec![0.0; n] };
        let slopes = laboratory.position_slopes(Laboratory::lagrangian);
        let applied = laboratory.applied_forces();
        let expected = (0..n).map(|i| {
            let momentum = |laboratory: &Laboratory| laboratory.product(Product::Momenta)[i];
            slopes[i] - laboratory.slope(&drift, momentum) + applied[i]
        });
        let expected = expected.collect::<Vec<_>>();
        let forcing = laboratory.product(Product::Forcing);
        prop_assert!(agree(&forcing, &expected, DIFFERENCED, 0.0), "{forcing:?} for {expected:?}");
        let (rates, sum) = (laboratory.product(Product::MomentumRates), sum(&slopes, &applied));
        prop_assert!(agree(&rates, &sum, DIFFERENCED, 0.0), "{rates:?} for {sum:?}");
        let bias = laboratory.product(Product::Bias);
        let rest = applied.iter().zip(&forcing).map(|(applied, f)| applied - f).collect::<Vec<_>>();
        prop_assert!(agree(&bias, &rest, DIFFERENCED, 0.0), "{bias:?} for {rest:?}");
    }
}

proptest! {
    #![proptest_config(crate::one_in(16))]

    /// Compares both ways, whichever is cheaper, in every direction of the state.
    #[test]
    fn jacobians_are_slopes_of_the_accelerations(machine in machines()) {
        let differentiated = Machine { text: format!("{} emit {{ jacobian }}", machine.text), ..machine };
        let choices = [StrategyChoice::Cheapest, StrategyChoice::Always(Strategy::MassMatrix), StrategyChoice::Always(Strategy::ArticulatedBody)];
        for choice in choices {
            let mut laboratory = Laboratory::new(&differentiated, choice);
            let (jacobian, n) = (laboratory.product(Product::Jacobian), laboratory.size());
            let found = (0..n).map(|i| {
                let component = |laboratory: &Laboratory| laboratory.acceleration()[i];
                [laboratory.position_slopes(component), laboratory.velocity_slopes(component)].concat()
            });
            let slopes = found.collect::<Vec<_>>().concat();
            prop_assert!(agree(&jacobian, &slopes, DIFFERENCED, 0.0), "{jacobian:?} for {slopes:?}");
        }
    }

    #[test]
    fn parameter_jacobians_are_slopes_of_the_accelerations(machine in machines()) {
        let differentiated = Machine { text: format!("{} emit {{ jacobian }}", machine.text), ..machine };
        let mut laboratory = Laboratory::new(&differentiated, StrategyChoice::Cheapest);
        let jacobian = laboratory.product(Product::ParameterJacobian);
        let fields = laboratory.model.parameters.iter().chain(&laboratory.model.inputs).cloned();
        let fields = fields.collect::<Vec<_>>();
        for (j, field) in fields.iter().enumerate() {
            let value = evaluate(&laboratory.model.graph, &[field.default.expect("a default")], |_| f64::NAN)[0];
            let mut at = |value: f64| {
                assert!(laboratory.derived.set(&field.name, value), "{} is declared", field.name);
                laboratory.acceleration()
            };
            let step = 1e-3;
            let [before, near, after, far] = [-2.0, -1.0, 1.0, 2.0].map(|steps| at(value + steps * step));
            at(value);
            let slopes = (0..near.len()).map(|i| (8.0 * (after[i] - near[i]) - (far[i] - before[i])) / (12.0 * step));
            let column = jacobian.iter().skip(j).step_by(fields.len()).copied().collect::<Vec<_>>();
            let slopes = slopes.collect::<Vec<_>>();
            prop_assert!(agree(&column, &slopes, DIFFERENCED, 0.0), "{}: {column:?} for {slopes:?}", field.name);
        }
    }
}

/// Configurations in which single squares lack an unknown that others contain.
#[test]
fn squares_that_lose_an_unknown_somewhere_do_no_harm() {
    let rising = "param l = 0.3; coord a, b;
        let p = (l*sin(a), -l*cos(a), 0);
        let q = p + (l*cos(b)*sin(a), -l*cos(b)*cos(a), l*sin(b));
        kinetic = kinetic_energy(1, dot(p)) + kinetic_energy(2, dot(q));
        kinetic = kinetic_energy(3, dot(q + (cos(a), sin(a), 1)/5)); potential = 9.81*q.y + q.z;";
    let swinging = "param l = 0.3; coord a, b;
        let p = (a, -l, a/2);
        let q = p + (l*sin(b), -l*cos(b), 0);
        kinetic = kinetic_energy(1, dot(p)) + kinetic_energy(1 + sin(b)^2, dot(q)); potential = 9.81*q.y + p.z;";
    for text in [rising, swinging] {
        let machine = Machine { text: text.to_owned(), t: 0.0, q: vec![0.0; 2], v: vec![0.5, -2.0] };
        let strategies = [Strategy::MassMatrix, Strategy::SumOfSquares].map(StrategyChoice::Always);
        let [dense, squares] = strategies.map(|strategy| Laboratory::new(&machine, strategy).acceleration());
        assert!(agree(&dense, &squares, ROUNDED_IN_TREES, 0.0), "{dense:?} or {squares:?}: {text}");
    }
}
