//! Laws for every expression: how it is built, differentiated, written and read.

use lagrange_core::calculus::{gradient, partial, substitute};
use lagrange_core::collections::HashMap;
use lagrange_core::expr::{ExprId, Graph};
use lagrange_core::formula::text::text;
use lagrange_core::number::Number;
use lagrange_core::pipeline::parse;
use proptest::prelude::{Strategy, any, prop, prop_assert, prop_assert_eq, prop_assume, proptest};

use crate::formulas::{
    DECLARATION, Point, build, has_undefined_part, largest_part, leaves, leeway, points, steps, value,
};

/// Length of text beyond which graphs share so much that the text nests too deeply to be read.
const LONGEST_TEXT: usize = 2_000;

/// Reads an expression from text and returns it with its graph, or the errors if the language
/// refuses it.
fn read(text: &str) -> Result<(Graph, ExprId), String> {
    let system = parse(&format!("{DECLARATION} output value = {text};"));
    let model = system.map_err(|report| report.to_string())?.model;
    let root = model.outputs[0].components[0];
    Ok((model.graph, root))
}

/// Returns operands with small weights, twice in different orders.
fn shuffled() -> impl Strategy<Value = [Vec<(u8, i8)>; 2]> {
    let operands = prop::collection::vec((any::<u8>(), -4..5_i8), 1..8).boxed();
    operands.prop_flat_map(|list| {
        let again = proptest::prelude::Just(list.clone()).prop_shuffle();
        again.prop_map(move |again| [list.clone(), again])
    })
}

/// Returns the letters and digits of a text, sorted.
fn words(text: &str) -> String {
    let mut words = text.chars().filter(|c| c.is_alphanumeric()).collect::<Vec<_>>();
    words.sort_unstable();
    words.into_iter().collect()
}

/// Returns ∂/∂symbol by central differences of fourth order, with an estimate of their error.
fn difference(graph: &Graph, root: ExprId, point: &Point, symbol: usize) -> (f64, f64) {
    let at = |step: f64| {
        let mut point = *point;
        point[symbol] += step;
        value(graph, root, &point)
    };
    let slope = |h: f64| (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
    let (coarse, fine) = (slope(2e-3), slope(1e-3));
    (fine, (coarse - fine).abs() + 1e-10 * largest_part(graph, root, point))
}

proptest! {
    #![proptest_config(crate::one_in(1))]

    #[test]
    fn operands_may_stand_in_any_order(steps in steps(30), orders in shuffled()) {
        let mut graph = Graph::new();
        let made = build(&mut graph, &steps);
        let pick = |k: u8| made[usize::from(k) % made.len()];
        let sums = orders.each_ref().map(|order| {
            graph.sum(Number::ONE, order.iter().map(|&(k, n)| (pick(k), Number::from(i64::from(n)))))
        });
        prop_assert_eq!(sums[0], sums[1]);
        let quarters = |n: i8| Number::ratio(i64::from(n), 4).expect("no zero");
        let products = orders.each_ref().map(|order| {
            graph.product(order.iter().map(|&(k, n)| (pick(k), quarters(n))))
        });
        prop_assert_eq!(products[0], products[1]);
    }

    #[test]
    fn rebuilding_changes_nothing(steps in steps(40)) {
        let mut graph = Graph::new();
        for expression in build(&mut graph, &steps) {
            let rebuilt = substitute(&mut graph, expression, &HashMap::default());
            let [before, after] = [expression, rebuilt].map(|id| text(&graph, id));
            prop_assert_eq!(rebuilt, expression, "{} became {}", before, after);
        }
    }

    #[test]
    fn derivatives_agree_with_each_other_and_with_differences(steps in steps(20), point in points()) {
        let mut graph = Graph::new();
        let root = *build(&mut graph, &steps).last().expect("leaves at least");
        prop_assume!(value(&graph, root, &point).is_finite());
        let written = text(&graph, root);
        let symbols = leaves(&mut graph)[..point.len()].to_vec();
        let backward = gradient(&mut graph, root, &symbols);
        for (i, (&symbol, &backward)) in symbols.iter().zip(&backward).enumerate() {
            let forward = partial(&mut graph, root, symbol);
            let leeway = leeway(&graph, forward, &point).max(leeway(&graph, backward, &point));
            if !leeway.is_finite() {
                continue;
            }
            let [forward, backward] = [forward, backward].map(|id| value(&graph, id, &point));
            prop_assert!((forward - backward).abs() <= leeway, "{forward} or {backward}: {written}");
            let (expected, error) = difference(&graph, root, &point, i);
            // Near a pole, or where terms of very different size meet, differences carry no
            // information.
            let tells = error <= 1e-6 * (1.0 + expected.abs());
            let tolerance = leeway + 1e-4 * (1.0 + expected.abs());
            prop_assert!(
                !tells || (forward - expected).abs() <= tolerance,
                "{forward} for {expected} ± {error}: {written}"
            );
        }
    }

    #[test]
    fn written_expressions_are_read_with_the_same_value(steps in steps(14), point in points()) {
        let mut graph = Graph::new();
        let root = *build(&mut graph, &steps).last().expect("leaves at least");
        let written = text(&graph, root);
        prop_assume!(written.len() <= LONGEST_TEXT);
        let (read_graph, read_root) = match read(&written) {
            Ok(read) => read,
            Err(complaints) => {
                prop_assert!(has_undefined_part(&graph, root), "{complaints}{written}");
                return Ok(());
            }
        };
        let (expected, found) = (value(&graph, root, &point), value(&read_graph, read_root, &point));
        let leeway = leeway(&graph, root, &point);
        prop_assert!(
            found == expected || (found - expected).abs() <= leeway || !leeway.is_finite(),
            "{found} for {expected}: {written}"
        );
    }

    /// The order of reading determines the order and the sign of a sum in a product.
    #[test]
    fn writing_what_was_read_changes_no_more_than_order_and_signs(steps in steps(14)) {
        let mut graph = Graph::new();
        let root = *build(&mut graph, &steps).last().expect("leaves at least");
        let written = text(&graph, root);
        prop_assume!(written.len() <= LONGEST_TEXT);
        let Ok((graph, root)) = read(&written) else { return Ok(()) };
        let again = text(&graph, root);
        let (graph, root) = read(&again).expect("it was readable");
        let third = text(&graph, root);
        prop_assert_eq!(words(&third), words(&again), "{} from {}", third, again);
    }
}
