//! Declarations with noise, compared with the same declarations with inputs.

use super::derived;
use crate::derive::DiffusionKind;
use crate::pipeline::{NumericSystem, parse};

/// Systems without the declaration of `w` and `v`, with a state [q…, v…], the number of positions,
/// and the kind of diffusion.
const SYSTEMS: [(&str, &[f64], usize, DiffusionKind); 4] = [
    (
        "param m = 2; coord x, y; kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2); force x = w - dot(x);
         force y = (1 + t) * v + w / 3;",
        &[0.3, -0.2, 0.5, 0.7],
        2,
        DiffusionKind::Additive,
    ),
    (
        "coord x, theta[4];
         let p[0] = (x, 0);
         for i in 0..4 { let p[i + 1] = p[i] + (sin(theta[i]), -cos(theta[i])); }
         kinetic = 1/2 * dot(x)^2 + 1/2 * sum(i in 1..=4, inner(dot(p[i]), dot(p[i])));
         potential = 9.81 * sum(i in 1..=4, p[i].y);
         force (w, 2 * v) at p[3];
         torque w * x on theta[1] - theta[0];",
        &[0.3, 0.2, -0.5, 0.7, 1.1, 0.4, -0.3, 0.2, 0.6, -0.9],
        5,
        DiffusionKind::Unambiguous,
    ),
    (
        "gravity = (0, 0, -9.81);
         body rotor { mass: 2; centroid: (0, 0, 0.1); inertia: (0.02, 0.03, 0.01); }
         ball tip = ground to rotor;
         force (w, v, 0) at rotor.point(0, 0, 0.2);",
        &[0.5, 0.5, -0.5, 0.5, 1.0, 2.0, -0.7],
        4,
        DiffusionKind::Unambiguous,
    ),
    (
        "state a, b; coord x; kinetic = 1/2 * dot(x)^2; force x = b * w;
         dot(a) + 2 * dot(b) = a * w - b;
         dot(a) - dot(b) = v;",
        &[0.4, 0.6, -0.3, 0.8],
        3,
        DiffusionKind::Multiplicative,
    ),
];

/// The rates are linear in noise, so a unit of an input in its place adds the diffusion.
#[test]
fn diffusions_are_what_a_unit_of_an_input_adds() {
    for (statements, state, positions, kind) in SYSTEMS {
        let noisy =
            derived(&format!("param s = 0.3; noise w, density: s^2; noise v, density: 4 * s; {statements}"));
        assert_eq!(noisy.equations.diffusion.kind, kind, "{statements}");
        let noisy = NumericSystem::new(&noisy);
        let mut driven = NumericSystem::new(&derived(&format!("param _s; input w, v; {statements}")));
        assert!(driven.set("_s", 0.3));
        let (t, (q, v)) = (0.7, state.split_at(positions));
        let at_rest = driven.rhs(t, state);
        let drift = noisy.rhs(t, state);
        assert!(drift.iter().zip(&at_rest).all(|(a, b)| (a - b).abs() < 1e-12), "{drift:?} {at_rest:?}");
        let diffusion = noisy.evaluate(&noisy.programs().diffusion, t, q, v);
        for (column, (input, root)) in diffusion.chunks(state.len()).zip([("w", 0.3), ("v", 1.2_f64.sqrt())])
        {
            assert!(driven.set(input, 1.0));
            let pushed = driven.rhs(t, state);
            assert!(driven.set(input, 0.0));
            for (i, found) in column.iter().enumerate() {
                let expected = root * (pushed[i] - at_rest[i]);
                assert!((found - expected).abs() < 1e-12, "{statements}: {input} {i}: {found} {expected}");
            }
        }
    }
}

#[test]
fn parts_have_noises_of_their_own() {
    let text = |derived: &crate::pipeline::Derived| {
        let (graph, columns) = (&derived.model.graph, &derived.equations.diffusion.columns);
        let show = |entry: &lagrange_expr::expr::ExprId| lagrange_algebra::formula::text::text(graph, *entry);
        columns.iter().map(|column| column.iter().map(show).collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    let placed = derived(
        "coord x, y;
         kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
         part Gust(size, along) { noise w, density: size; force w along dot(along); }
         first: Gust { size: 2; along: x; }
         second: Gust { size: 3; along: y; }",
    );
    let flat = derived(
        "coord x, y;
         kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
         noise a, density: 2;
         noise b, density: 3;
         force x = a;
         force y = b;",
    );
    assert_eq!(text(&placed), text(&flat));
    assert_eq!(text(&flat)[0][2], "sqrt(2)");
}

#[test]
fn noise_is_a_name_like_any_other() {
    let named = "param noise = 2; coord x; state density; kinetic = 1/2 * noise * dot(x)^2;
                 noise * dot(density) = -x; force x = noise - density;";
    let found = NumericSystem::new(&derived(named)).rhs(0.0, &[4.0, 1.0, 0.0]);
    assert_eq!(found, [0.0, -2.0, 0.5]);
}

/// Without noise nothing is emitted for it; with noise no quantity is documented as conserved.
#[test]
fn noise_leaves_nothing_conserved() {
    let spring = |more: &str| derived(&format!("coord x; kinetic = 1/2 * dot(x)^2; potential = x^2; {more}"));
    assert_eq!(spring("").equations.structure.conserved.len(), 1);
    assert!(spring("").equations.diffusion.columns.is_empty());
    assert!(spring("noise w, density: 1; force x = w;").equations.structure.conserved.is_empty());
}

#[test]
fn products_that_integrate_no_noise_are_refused() {
    for product in ["kernel", "lanes", "prepared", "taylor"] {
        let text = format!(
            "struct A; coord x; kinetic = 1/2 * dot(x)^2; noise w, density: 1; force x = w; emit {{ {product} }}"
        );
        let tokens = text.parse().expect("tokens");
        let said = super::expand(tokens, &quote::quote!(::lagrange)).to_string();
        assert!(said.contains("cannot be combined with noise"), "{product}: {said}");
    }
    assert!(parse("coord x; kinetic = 1/2 * dot(x)^2; noise w, density: 1; force x = w;").is_ok());
}
