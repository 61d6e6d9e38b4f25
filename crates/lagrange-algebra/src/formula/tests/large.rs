use super::polish;
use crate::formula::{latex, text};
use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Applies `x -> x·(x + sin x)` repeatedly: the text doubles with each step, the graph does not.
fn doublings(g: &mut Graph, steps: usize) -> ExprId {
    let mut x = polish(g, "x");
    for _ in 0..steps {
        let sin = apply(g, Function::Sin, &[x]);
        let sum = g.add(x, sin);
        x = g.multiply(x, sum);
    }
    x
}

#[test]
fn short_texts_need_no_names() {
    let mut g = Graph::new();
    let root = doublings(&mut g, 2);
    let (names, texts) = text::definitions(&g, &[root], 1000);
    assert!(names.is_empty());
    assert_eq!(texts, [text::text(&g, root)]);
}

#[test]
fn shared_parts_get_names_where_the_text_is_too_long() {
    let mut g = Graph::new();
    let root = doublings(&mut g, 3);
    let (names, texts) = text::definitions(&g, &[root], 50);
    let names = names.iter().map(|(name, text)| format!("{name} = {text}")).collect::<Vec<_>>();
    let expected = ["c1 = x*(x + sin(x))*(x*(x + sin(x)) + sin(x*(x + sin(x))))"];
    assert_eq!(names, expected);
    assert_eq!(texts, ["c1*(c1 + sin(c1))"]);
}

#[test]
fn a_root_that_is_part_of_another_is_written_by_name() {
    let mut g = Graph::new();
    let part = polish(&mut g, "m1 m2 + l * theta sin * x +");
    let whole = apply(&mut g, Function::Cos, &[part]);
    let (names, texts) = text::definitions(&g, &[part, whole], 10);
    assert_eq!(names.len(), 1);
    assert_eq!(texts, ["c1", "cos(c1)"]);
}

#[test]
fn names_differ_from_those_of_symbols() {
    let mut g = Graph::new();
    let c = g.symbol("c12", Role::Parameter(40));
    let x = doublings(&mut g, 4);
    let root = g.multiply(c, x);
    let (names, _) = text::definitions(&g, &[root], 10);
    assert!(names.iter().all(|(name, _)| name.starts_with("cc")));
    let (names, _) = latex::definitions(&g, &[root], 10);
    assert_eq!(names[0].0, r"\mathrm{cc}_{1}");
}

#[test]
fn sixty_doublings_are_written_in_proportion_to_the_graph() {
    let mut g = Graph::new();
    let root = doublings(&mut g, 60);
    for (names, texts) in [text::definitions(&g, &[root], 500), latex::definitions(&g, &[root], 500)] {
        let length = names.iter().map(|(name, text)| name.len() + text.len()).sum::<usize>() + texts[0].len();
        assert!(length < 60 * 200, "{length}");
    }
}

#[test]
fn a_hundred_thousand_levels_and_terms_need_no_stack() {
    let walk = || {
        let mut g = Graph::new();
        let mut deep = polish(&mut g, "x");
        let mut negated = polish(&mut g, "theta");
        for _ in 0..100_000 {
            deep = apply(&mut g, Function::Tanh, &[deep]);
            let one = g.sum(Number::ONE, [(negated, Number::TWO)]);
            negated = apply(&mut g, Function::Sqrt, &[one]);
        }
        let both = g.multiply(deep, negated);
        assert!(text::text(&g, both).len() > 1_000_000);
        assert!(latex::latex(&g, both).len() > 1_000_000);
        assert!(!text::definitions(&g, &[both], 100).1.is_empty());
        let wide = (0..100_000).map(|i| g.symbol(&format!("k{i}"), Role::Parameter(100 + i)));
        let wide = wide.map(|id| (id, Number::MINUS_ONE)).collect::<Vec<_>>();
        let wide = g.sum(Number::ZERO, wide);
        assert!(text::text(&g, wide).starts_with("-k0 - k1 - k2"));
    };
    let small = std::thread::Builder::new().stack_size(256 * 1024);
    small.spawn(walk).expect("a thread").join().expect("no overflow");
}
