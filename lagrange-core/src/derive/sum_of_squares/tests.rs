//! Lagrange's identity in numbers: the remainder of squares is their minimum over the unknown.

use proptest::prelude::{ProptestConfig, Strategy, prop, prop_assert, proptest};

use super::composition::AffineExpansion;
use super::frame::frame;
use super::rotation::{Pull, eliminate};
use super::square::{Carried, Carriers, Square};
use crate::derive::algebra::{Algebra, LinearForm};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::functions::apply;
use lagrange_expr::symbol::Role;

/// Number of remaining variables: those of the carriers, then others.
const REMAINING: usize = 4;
const PARTS: usize = 2;

/// Numbers of carriers and squares, and true if squares contain variables besides the carriers.
type Shape = (usize, usize, bool);

fn shapes() -> impl Strategy<Value = Shape> {
    (1..=3_usize, 1..=4_usize, prop::bool::ANY)
}

/// Symbols for the coefficients, each a separate parameter, with values.
struct Coefficients {
    values: Vec<f64>,
    used: usize,
}

impl Coefficients {
    fn next(&mut self, graph: &mut Graph) -> ExprId {
        self.used += 1;
        let index = u32::try_from(self.used).expect("few coefficients");
        graph.symbol(&format!("c{index}"), Role::Parameter(index))
    }

    /// Returns the value of a coefficient; at zero a carrier does not depend on the unknown.
    fn value(&self, index: u32) -> f64 {
        self.values[index as usize % self.values.len()]
    }
}

fn variable(graph: &mut Graph, kind: &str, index: usize) -> ExprId {
    let number = u32::try_from(index).expect("few variables");
    let number = if kind == "y" { number + 10 } else { number };
    graph.symbol(&format!("{kind}{index}"), Role::Acceleration(number))
}

/// Carriers and squares with symbolic coefficients; a rod's carriers move along a unit vector.
struct Setting {
    ids: Vec<ExprId>,
    expansions: Vec<AffineExpansion>,
    squares: Vec<Square>,
}

impl Setting {
    fn new(
        graph: &mut Graph,
        coefficients: &mut Coefficients,
        (carriers, squares, others): Shape,
    ) -> Setting {
        let ids = (0..carriers).map(|k| variable(graph, "y", k)).collect::<Vec<_>>();
        let remaining = (0..REMAINING).map(|k| variable(graph, "p", k)).collect::<Vec<_>>();
        let mut form = |graph: &mut Graph, variables: &[ExprId]| -> LinearForm {
            variables.iter().map(|&id| (id, coefficients.next(graph))).collect()
        };
        let expansions = ids.iter().map(|_| {
            let rest = form(graph, &remaining[..PARTS]);
            let [slope, drift] = [ids[0], ids[0]].map(|id| form(graph, &[id])[0].1);
            AffineExpansion { slope, rest, drift }
        });
        let expansions = expansions.collect();
        let squares = (0..squares).map(|_| {
            let beside = if others { &remaining[PARTS..] } else { &[] };
            let form_of = form(graph, &[&ids, beside].concat());
            let [weight, linear] = [ids[0], ids[0]].map(|id| form(graph, &[id])[0].1);
            Square { weight: graph.square(weight), linear, form: form_of }
        });
        let squares = squares.collect();
        Setting { ids, expansions, squares }
    }

    /// Returns the setting with the first two carriers moved along a unit vector.
    fn with_rod(mut self, graph: &mut Graph, angle: ExprId) -> Setting {
        for (expansion, function) in self.expansions.iter_mut().zip([Function::Cos, Function::Sin]) {
            expansion.slope = apply(graph, function, &[angle]);
        }
        self
    }

    fn eliminated(&self, algebra: &mut Algebra<'_>) -> (Carriers, Vec<Carried>, Pull, Vec<Square>) {
        let carriers = Carriers::new(algebra, self.ids.clone(), self.expansions.clone());
        let carried = self.squares.iter().map(|square| carriers.carry(algebra, square.clone()));
        let carried = carried.collect::<Vec<_>>();
        let (pull, left) = eliminate(algebra, &carriers, &carried).expect("few squares");
        (carriers, carried, pull, left)
    }
}

/// Values of expressions at accelerations of the remaining variables.
struct Place<'a> {
    graph: &'a Graph,
    coefficients: &'a Coefficients,
    remaining: &'a [f64],
}

impl Place<'_> {
    fn value(&self, id: ExprId) -> f64 {
        evaluate(self.graph, &[id], |role| match role {
            Role::Parameter(index) => self.coefficients.value(index),
            Role::Acceleration(index) => self.remaining.get(index as usize).copied().unwrap_or(f64::NAN),
            _ => f64::NAN,
        })[0]
    }

    fn form(&self, form: &LinearForm) -> f64 {
        form.iter().map(|&(id, coefficient)| self.value(coefficient) * self.value(id)).sum()
    }

    /// Computes ½ w r² + κ r for a square whose variables all remain.
    fn square(&self, square: &Square) -> f64 {
        let r = self.form(&square.form);
        self.value(square.weight) * r * r / 2.0 + self.value(square.linear) * r
    }

    /// Returns `(w, κ, a, b)` of a square with r = a x + b.
    fn in_unknown(&self, setting: &Setting, square: &Square) -> [f64; 4] {
        let (mut a, mut b) = (0.0, 0.0);
        for &(id, coefficient) in &square.form {
            let coefficient = self.value(coefficient);
            match setting.ids.iter().position(|carrier| *carrier == id) {
                Some(k) => {
                    let expansion = &setting.expansions[k];
                    a += coefficient * self.value(expansion.slope);
                    b += coefficient * (self.form(&expansion.rest) + self.value(expansion.drift));
                }
                None => b += coefficient * self.value(id),
            }
        }
        [self.value(square.weight), self.value(square.linear), a, b]
    }

    /// Returns the minimum over the unknown and its position.
    fn minimum(&self, setting: &Setting) -> (f64, f64) {
        let squares = setting.squares.iter().map(|square| self.in_unknown(setting, square));
        let squares = squares.collect::<Vec<_>>();
        let curvature = squares.iter().map(|[w, _, a, _]| w * a * a).sum::<f64>();
        let slope = squares.iter().map(|[w, load, a, b]| w * a * b + load * a).sum::<f64>();
        let x = -slope / curvature;
        let at = |[w, load, a, b]: &[f64; 4]| (a * x + b) * (w * (a * x + b) / 2.0 + load);
        (squares.iter().map(at).sum(), x)
    }
}

fn numbers(count: usize) -> impl Strategy<Value = Vec<f64>> {
    // Values stay away from zero, so that nothing is ill-conditioned.
    let number = (prop::bool::ANY, 0.3..2.0_f64).prop_map(|(minus, x)| if minus { -x } else { x });
    prop::collection::vec(number, count)
}

/// True if two functions of the remaining accelerations differ by a constant.
fn differ_by_a_constant(differences: [f64; 3], scale: f64) -> bool {
    differences.iter().all(|d| (d - differences[0]).abs() < 1e-9 * (1.0 + scale))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_remainder_of_squares_is_their_minimum(
        shape in shapes(),
        values in numbers(61),
        places in prop::array::uniform3(numbers(REMAINING)),
        is_rod in prop::bool::ANY,
    ) {
        let mut graph = Graph::new();
        let mut coefficients = Coefficients { values, used: 0 };
        let mut setting = Setting::new(&mut graph, &mut coefficients, shape);
        if is_rod {
            let angle = coefficients.next(&mut graph);
            setting = setting.with_rod(&mut graph, angle);
        }
        let mut algebra = Algebra::new(&mut graph);
        let (carriers, carried, pull, left) = setting.eliminated(&mut algebra);
        let factors = pull.factors(&mut algebra, &carriers);
        let frame = frame(&carriers, &mut algebra, &carried, pull.pivot);
        let in_frame = frame.map(|frame| frame.factors(&mut algebra));
        prop_assert!(in_frame.is_some() == (is_rod && shape.0 == 2 && !shape.2) || shape.0 == 1);
        let mut differences = [0.0; 3];
        let (mut largest, mut free) = (0.0_f64, [0.0; 3]);
        for ((remaining, difference), free) in places.iter().zip(&mut differences).zip(&mut free) {
            let place = Place { graph: &graph, coefficients: &coefficients, remaining };
            let (minimum, x) = place.minimum(&setting);
            *difference = minimum - left.iter().map(|square| place.square(square)).sum::<f64>();
            largest = largest.max(minimum.abs());
            *free = x + place.form(&factors);
            let other = in_frame.as_ref().map_or(place.form(&factors), |factors| place.form(factors));
            prop_assert!((other - place.form(&factors)).abs() < 1e-9 * (1.0 + x.abs()));
        }
        prop_assert!(differ_by_a_constant(differences, largest), "{differences:?} of {largest}");
        prop_assert!(differ_by_a_constant(free, 0.0), "{free:?}");
        let load = [pull.drifting, pull.applied].map(|load| {
            Place { graph: &graph, coefficients: &coefficients, remaining: &places[0] }.value(load)
        });
        let pivot = Place { graph: &graph, coefficients: &coefficients, remaining: &places[0] }.value(pull.pivot);
        prop_assert!((free[0] + (load[0] + load[1]) / pivot).abs() < 1e-8 * (1.0 + free[0].abs()));
    }
}
