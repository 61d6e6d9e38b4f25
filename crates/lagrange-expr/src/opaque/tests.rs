mod surface;

use super::{Interpolation, Opaque, OpaqueFunction, Outside, Source, Table};

fn function(parameters: &[&str], derivatives: Option<Vec<(Vec<u8>, String)>>) -> Opaque {
    let parameters = parameters.iter().map(|parameter| (*parameter).to_owned()).collect();
    Opaque::value_of(OpaqueFunction {
        name: "lift".to_owned(),
        parameters,
        source: Source::Crate { derivatives },
    })
}

#[test]
fn derivatives_have_default_names() {
    let mut road = function(&["x"], None);
    let mut names = Vec::new();
    for _ in 0..5 {
        names.push(road.rust_name());
        road = road.derivative(0);
    }
    let expected =
        ["lift", "lift_derivative", "lift_second_derivative", "lift_third_derivative", "lift_derivative_4"];
    assert_eq!(names, expected);
    let of_two = function(&["alpha", "speed"], None);
    let mixed = of_two.derivative(1).derivative(0).derivative(0);
    assert_eq!(mixed.rust_name(), "lift_by_alpha_alpha_speed");
    assert_eq!(mixed.latex(), r"\partial_{1}^{2}\partial_{2}\operatorname{lift}");
}

#[test]
fn listed_derivatives_exclude_others() {
    let road = function(&["x"], Some(vec![(vec![1], "slope".to_owned())]));
    let [slope, curvature] = [road.derivative(0), road.derivative(0).derivative(0)];
    assert_eq!([road.rust_name(), slope.rust_name()], ["lift", "slope"]);
    assert_eq!([&road, &slope, &curvature].map(Opaque::is_missing), [false, false, true]);
    assert_eq!(curvature.describe(), "the second derivative of `lift`");
}

#[test]
fn the_order_in_which_a_function_is_differentiated_does_not_matter() {
    let lift = function(&["x", "y"], None);
    assert_eq!(lift.derivative(0).derivative(1), lift.derivative(1).derivative(0));
    assert_ne!(lift.derivative(0), lift.derivative(1));
}

const POINTS: [(f64, f64); 6] = [(0.0, 0.0), (1.0, 0.5), (1.5, 2.0), (3.0, 2.0), (3.5, 1.0), (6.0, -4.0)];

fn curve(points: &[(f64, f64)], interpolation: Interpolation, outside: Outside) -> Table {
    let (knots, values): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
    Table::new(vec![knots], &values, interpolation, outside)
}

fn central_difference(table: &Table, order: u8, x: f64) -> f64 {
    let h = 1e-5;
    (table.value(&[order], &[x + h]) - table.value(&[order], &[x - h])) / (2.0 * h)
}

#[test]
fn tables_go_through_their_points_and_have_the_derivatives_of_their_polynomials() {
    for (name, interpolation) in Interpolation::ALL {
        let table = curve(&POINTS, interpolation, Outside::Extend);
        for (x, y) in POINTS {
            assert!((table.value(&[0], &[x]) - y).abs() < 1e-15, "{name} at {x}");
        }
        for x in [-2.0, 0.3, 1.2, 2.9, 3.1, 5.0, 7.5] {
            for order in 0..3 {
                let (found, difference) =
                    (table.value(&[order + 1], &[x]), central_difference(&table, order, x));
                assert!((found - difference).abs() < 1e-8, "{name} at {x}: {found}, {difference}");
            }
        }
    }
}

/// Evaluates from both sides of every knot, including the ends.
#[test]
fn natural_splines_that_are_extended_have_continuous_second_derivatives() {
    let table = curve(&POINTS, Interpolation::Natural, Outside::Extend);
    for (x, _) in POINTS {
        for order in 0..3 {
            let [below, above] = [-1e-12, 1e-12].map(|by| table.value(&[order], &[x + by]));
            assert!((below - above).abs() < 1e-9, "order {order} at {x}: {below}, {above}");
        }
    }
}

#[test]
fn monotone_splines_never_overshoot() {
    let table = curve(&POINTS, Interpolation::Monotone, Outside::Error);
    let samples = (0..=6000).map(|i| f64::from(i) / 1000.0).collect::<Vec<_>>();
    for pair in samples.windows(2) {
        let [before, after] = [pair[0], pair[1]].map(|x| table.value(&[0], &[x]));
        let interval = POINTS.windows(2).find(|ends| pair[1] <= ends[1].0).expect("within the table");
        let rise = interval[1].1 - interval[0].1;
        assert!((after - before) * rise >= 0.0, "at {}: {before}, {after}", pair[0]);
        assert!(rise != 0.0 || before == after);
    }
}

#[test]
fn what_lies_outside_is_as_declared() {
    let value = |outside, order, x| curve(&POINTS, Interpolation::Monotone, outside).value(&[order], &[x]);
    assert!(value(Outside::Error, 0, -1e-9).is_nan() && value(Outside::Error, 1, 6.1).is_nan());
    assert_eq!([value(Outside::Error, 0, 0.0), value(Outside::Error, 0, 6.0)], [0.0, -4.0]);
    assert_eq!([value(Outside::Clamp, 0, -5.0), value(Outside::Clamp, 0, 7.0)], [0.0, -4.0]);
    assert_eq!([value(Outside::Clamp, 1, -5.0), value(Outside::Clamp, 1, 7.0)], [0.0, 0.0]);
    let slope = value(Outside::Error, 1, 0.0);
    assert_eq!([value(Outside::Extend, 0, -2.0), value(Outside::Extend, 0, 7.0)], [-2.0 * slope, -6.0]);
    assert!(value(Outside::Extend, 0, f64::NAN).is_nan() && value(Outside::Clamp, 3, f64::NAN).is_nan());
}

/// A polynomial with the form of products of splines is its own interpolation.
#[test]
fn tables_of_several_arguments_are_products_of_splines() {
    let axes = [vec![0.0, 1.0, 2.5, 4.0], vec![-1.0, 0.0, 2.0], vec![10.0, 11.0, 13.0]];
    let factors = |x: &[f64]| [1.0 + 2.0 * x[0], 3.0 - x[1], 0.5 * x[2] - 1.0];
    let slopes = [2.0, -1.0, 0.5];
    for (count, interpolation) in [2, 3]
        .into_iter()
        .flat_map(|count| [Interpolation::Linear, Interpolation::Natural].map(|way| (count, way)))
    {
        let at = |x: &[f64]| factors(&[x, &[4.0]].concat())[..count].iter().product::<f64>();
        let points = axes[..count].iter().fold(vec![vec![]], |points, axis| {
            let extended =
                points.iter().flat_map(|point| axis.iter().map(move |knot| [&point[..], &[*knot]].concat()));
            extended.collect::<Vec<Vec<f64>>>()
        });
        let values = points.iter().map(|point| at(point)).collect::<Vec<_>>();
        let table = |outside| Table::new(axes[..count].to_vec(), &values, interpolation, outside);
        let extended = table(Outside::Extend);
        assert!(extended.goes_through(&values) && extended.is_finite());
        for x in [[0.5, 0.5, 10.5], [2.5, 2.0, 13.0], [3.9, -0.9, 12.0], [-1.0, 1.0, 9.0], [5.0, 4.0, 14.0]] {
            let factors = factors(&x);
            for choice in 0..1 << count {
                let orders = (0..count).map(|axis| choice >> axis & 1).collect::<Vec<u8>>();
                let expected =
                    (0..count).map(|i| if orders[i] > 0 { slopes[i] } else { factors[i] }).product::<f64>();
                let found = extended.value(&orders, &x[..count]);
                assert!((found - expected).abs() < 1e-12, "{found} at {x:?} is not {expected}, {orders:?}");
            }
        }
        let strict = table(Outside::Error);
        for outside in [[1.0, 3.0, 11.0], [-0.1, 1.0, 11.0]] {
            assert!(strict.value(&vec![0; count], &outside[..count]).is_nan());
        }
        assert_eq!(strict.value(&vec![0; count], &[1.0, 1.0, 9.0][..count]).is_nan(), count == 3);
    }
}

#[test]
fn even_grids_are_recognised_and_give_the_same_values() {
    let knots = (0..50).map(|i| 0.1 * f64::from(i) - 1.0).collect::<Vec<_>>();
    let points = knots.iter().map(|x| (*x, x.sin())).collect::<Vec<_>>();
    let even = curve(&points, Interpolation::Natural, Outside::Error);
    assert!((even.axes[0].density - 10.0).abs() < 1e-12);
    let mut searched = even.clone();
    searched.axes[0].density = 0.0;
    for i in 0..=490 {
        let x = knots[0] + 0.01 * f64::from(i);
        let [a, b] = [&even, &searched].map(|table| table.value(&[0], &[x.min(knots[49])]));
        assert!((a - b).abs() < 1e-14, "{a} or {b} at {x}");
    }
}

/// If a spline varies by many orders of magnitude between its points, their values are lost to
/// rounding.
#[test]
fn pieces_that_miss_the_next_point_by_rounding_are_found() {
    let (even, values) = POINTS.into_iter().unzip::<_, _, Vec<_>, Vec<_>>();
    let uneven = |scale: f64| vec![1.0, 2.0, 3.0 * scale, 6.0 * scale, 7.0 * scale, 8.0 * scale];
    for (name, interpolation) in Interpolation::ALL {
        let curve = |knots: Vec<f64>| {
            Table::new(vec![knots], &values, interpolation, Outside::Error).goes_through(&values)
        };
        assert!(curve(even.clone()) && curve(uneven(1e3)), "{name}");
        assert_eq!(curve(uneven(1e18)), interpolation != Interpolation::Natural, "{name}");
        let surface = |knots: Vec<f64>| {
            let rows = [values.clone(), values.clone(), values.iter().rev().copied().collect()].concat();
            let table = Table::new(vec![vec![0.0, 1.0, 3.0], knots], &rows, interpolation, Outside::Error);
            table.goes_through(&rows)
        };
        assert!(surface(even.clone()), "{name}");
        assert_eq!(surface(uneven(1e18)), interpolation != Interpolation::Natural, "{name}");
    }
}

#[test]
fn tables_with_points_at_the_limits_of_numbers_hold_finite_numbers_or_are_refused() {
    let least = f64::MIN_POSITIVE;
    // One piece in a length of 2^-1024 exceeds the range of numbers.
    let close = [(least, 1.0), (1.25 * least, 1.0)];
    let table = curve(&close, Interpolation::Linear, Outside::Extend);
    assert_eq!((table.axes[0].density, table.is_finite()), (0.0, true));
    assert_eq!(table.value(&[0], &[1.125 * least]), 1.0);
    // Values rise by 1e300 from one row to the next, slopes after the last column by 1.25e300.
    // Three times this in a length of 1.8e-8 only exceeds the range of numbers for the slopes.
    let surface = |outside| {
        let knots = vec![vec![0.0, 1.8e-8], vec![0.0, 1.0, 2.0]];
        let rows = [0.0, 0.0, 0.0, 0.0, 0.0, 1e300];
        Table::new(knots, &rows, Interpolation::Natural, outside).is_finite()
    };
    assert_eq!(Outside::ALL.map(|(_, outside)| surface(outside)), [true, true, false]);
}
