use super::{
    AccelerationTerms, Degree, Degrees, Rates, gradient, homogeneity, partial, partials, second_partials,
};
use lagrange_expr::elementary::ROWS;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function, Graph, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

fn coordinates(g: &mut Graph) -> [ExprId; 2] {
    [g.symbol("x", Role::Coordinate(0)), g.symbol("y", Role::Coordinate(1))]
}

/// Returns values inside the domain of every function.
fn at(x: f64, y: f64) -> impl Fn(Role) -> f64 {
    move |role| match role {
        Role::Coordinate(0) => x,
        Role::Coordinate(1) => y,
        Role::Velocity(0) => 0.7,
        Role::Velocity(1) => -1.3,
        _ => f64::NAN,
    }
}

fn central_difference(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let h = 1e-5;
    (f(x + h) - f(x - h)) / (2.0 * h)
}

#[test]
fn derivatives_of_every_function_agree_with_differences_and_with_the_adjoint() {
    for row in &ROWS {
        let mut g = Graph::new();
        let variables = coordinates(&mut g);
        let f = apply(&mut g, row.function, &variables[..row.arity]);
        let adjoints = gradient(&mut g, f, &variables);
        for (i, &variable) in variables.iter().enumerate().take(row.arity) {
            let derivative = partial(&mut g, f, variable);
            let exact = evaluate(&g, &[derivative, adjoints[i]], at(0.6, 0.4));
            let difference = central_difference(
                |h| evaluate(&g, &[f], if i == 0 { at(h, 0.4) } else { at(0.6, h) })[0],
                [0.6, 0.4][i],
            );
            assert!((exact[0] - difference).abs() < 1e-9, "{}: {} or {difference}", row.name, exact[0]);
            assert!((exact[0] - exact[1]).abs() < 1e-14, "{}: {exact:?}", row.name);
        }
    }
}

#[test]
fn second_derivatives_of_every_function_agree_with_repeated_ones() {
    // Square roots are products; their second derivatives are those of powers.
    for row in ROWS.iter().filter(|row| row.function != Function::Sqrt) {
        let mut g = Graph::new();
        let variables = coordinates(&mut g);
        // An argument with a coefficient, which the constructors absorb in the first derivative.
        let doubled = g.scale(Number::TWO, variables[0]);
        let arguments = [doubled, variables[1]];
        let f = apply(&mut g, row.function, &arguments[..row.arity]);
        let second = second_partials(&mut g, f);
        let of_first = second.iter().filter(|(a, b, _)| *a == doubled && *b == doubled);
        let local = g.total(of_first.map(|(_, _, value)| *value).collect::<Vec<_>>());
        let first = partial(&mut g, f, variables[0]);
        let repeated = partial(&mut g, first, variables[0]);
        let values = evaluate(&g, &[local, repeated], at(0.2, 0.4));
        assert!((4.0 * values[0] - values[1]).abs() < 1e-12, "{}: {values:?}", row.name);
    }
}

/// An operand may occur twice in a node: in a call, or under roots that must stay separate.
#[test]
fn second_derivatives_count_an_operand_in_two_places() {
    let mut g = Graph::new();
    let [x, _] = coordinates(&mut g);
    let power = apply(&mut g, Function::Power, &[x, x]);
    let hypotenuse = apply(&mut g, Function::Hypot, &[x, x]);
    let half = Number::ratio(1, 2).expect("no zero");
    let roots = g.product([(x, half.clone()), (x, half)]);
    for f in [power, hypotenuse, roots] {
        let slopes = partials(&mut g, f);
        assert!(slopes.iter().all(|(operand, _)| *operand == x) && slopes.len() == 1);
        let second = second_partials(&mut g, f);
        let local = g.total(second.iter().map(|(_, _, value)| *value).collect::<Vec<_>>());
        let first = partial(&mut g, f, x);
        let repeated = partial(&mut g, first, x);
        let values = evaluate(&g, &[local, repeated], at(0.7, 0.4));
        assert!((values[0] - values[1]).abs() < 1e-12, "{values:?}");
    }
}

#[test]
fn degrees_of_homogeneity_that_are_out_of_range_are_not_found() {
    let mut g = Graph::new();
    let (k, v) = (g.symbol("k", Role::Parameter(0)), g.symbol("x", Role::Velocity(0)));
    let mut f = v;
    for degree in [Some(1), Some(2_000_000_000), Some(4_000_000_000_000_000_000), None] {
        assert_eq!(homogeneity(&g, f), degree);
        let weighted = g.multiply(k, f);
        f = g.power(weighted, Number::from(2_000_000_000));
    }
}

#[test]
fn rate_of_a_position_is_its_gradient_times_the_velocity() {
    let mut g = Graph::new();
    let [x, y] = coordinates(&mut g);
    let sin = apply(&mut g, Function::Sin, &[x]);
    let f = g.multiply(sin, y);
    let rate = Rates::new(AccelerationTerms::Dropped).of(&mut g, f);
    let slopes = gradient(&mut g, f, &[x, y]);
    let values = evaluate(&g, &[rate, slopes[0], slopes[1]], at(0.3, 0.8));
    assert!((values[0] - (0.7 * values[1] - 1.3 * values[2])).abs() < 1e-15);
}

#[test]
fn second_rates_hold_accelerations_only_when_they_are_kept() {
    let mut g = Graph::new();
    let [x, _] = coordinates(&mut g);
    let square = g.square(x);
    for terms in [AccelerationTerms::Kept, AccelerationTerms::Dropped] {
        let mut rates = Rates::new(terms);
        let first = rates.of(&mut g, square);
        let second = rates.of(&mut g, first);
        let acceleration = g.symbol("x", Role::Acceleration(0));
        let found = g.reachable(&[second]).contains(&acceleration);
        assert_eq!(found, terms == AccelerationTerms::Kept);
    }
}

#[test]
fn degrees_in_the_velocities() {
    let mut g = Graph::new();
    let [x, y] = coordinates(&mut g);
    let (vx, vy) = (g.symbol("x", Role::Velocity(0)), g.symbol("y", Role::Velocity(1)));
    let sin = apply(&mut g, Function::Sin, &[x]);
    let affine = {
        let product = g.multiply(sin, vx);
        g.add(product, y)
    };
    let quadratic = g.multiply(affine, vy);
    let choice = g.choose(Relation::Less, x, y, affine, vx);
    let switched = g.choose(Relation::Less, vx, y, affine, vx);
    let mut degrees = Degrees::default();
    degrees.classify(&g, &[sin, affine, quadratic, choice, switched]);
    let found = [sin, affine, quadratic, choice, switched].map(|id| degrees.of(&g, id));
    use Degree::{Affine, Free, Nonlinear};
    assert_eq!(found, [Free, Affine, Nonlinear, Affine, Nonlinear]);
}

#[test]
fn twenty_thousand_levels_and_terms_need_no_stack() {
    let small_stack = std::thread::Builder::new().stack_size(256 * 1024);
    let walk = || {
        let mut g = Graph::new();
        let [x, y] = coordinates(&mut g);
        let mut deep = x;
        for _ in 0..20_000 {
            deep = apply(&mut g, Function::Sin, &[deep]);
        }
        let terms = (1..=20_000).map(|k| {
            let power = g.scale(Number::from(k), y);
            (apply(&mut g, Function::Cos, &[power]), Number::ONE)
        });
        let terms = terms.collect::<Vec<_>>();
        let wide = g.sum(Number::ZERO, terms);
        let both = g.multiply(deep, wide);
        let slopes = gradient(&mut g, both, &[x, y]);
        let rate = Rates::new(AccelerationTerms::Dropped).of(&mut g, both);
        let forward = partial(&mut g, both, x);
        let values = evaluate(&g, &[rate, slopes[0], slopes[1], forward], at(1.0, 1.0));
        assert!(values.iter().all(|value| value.is_finite()));
    };
    small_stack.spawn(walk).expect("a thread").join().expect("no overflow");
}
