mod attributes;
mod conserved;
mod frames;
mod ignored;
mod included;
mod limits;
mod noise;
mod numbers;
mod scenes;
mod spatial_scenes;
mod unresolved;

use quote::quote;

use super::{Derived, NumericSystem, expand, parse};
use crate::derive::{Conserved, Strategy, StrategyChoice};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::evaluate;

fn derived(text: &str) -> Derived {
    parse(text).expect("a correct declaration").derive(StrategyChoice::Cheapest).expect("a regular system")
}

const SPRING_PENDULUM: &str = "
    param m, k, l0, g;
    coord r, theta;
    let position = (r * sin(theta), -r * cos(theta));
    kinetic = kinetic_energy(m, dot(position));
    potential = gravitational_energy(m, g, position.y) + spring_energy(k, r - l0);
";

#[test]
fn polar_coordinates_by_way_of_cartesian_ones_are_uncoupled() {
    assert!(derived(SPRING_PENDULUM).equations.structure.mass.is_diagonal());
}

#[test]
fn tables_of_time_are_factors_of_potential_energies() {
    let spring = derived(
        "table stiffness(s) = [(0, 1), (1, 3), (2, 4)], interpolation: linear, outside: clamp;
         coord x; kinetic = 1/2 * dot(x)^2; potential = 1/2 * stiffness(t) * x^2;",
    );
    let acceleration = |t| NumericSystem::new(&spring).acceleration(t, &[2.0], &[0.0]);
    assert_eq!([0.5, 1.5, 3.0].map(acceleration), [[-4.0], [-7.0], [-8.0]]);
}

#[test]
fn systems_of_too_many_velocities_are_refused_at_once() {
    let text = "const n = 4001; coord x[n]; kinetic = sum(i in 0..n, 1/2 * dot(x[i])^2);";
    let report = parse(text).err().map_or_else(String::new, |report| report.to_string());
    assert!(report.contains("this system has 4001 velocities"), "{report}");
}

#[test]
fn a_turn_about_the_vertical_is_cyclic_however_it_is_written() {
    let top = "
        param m, l, g;
        coord theta, phi;
        let position = (l * sin(theta) * cos(phi), l * sin(theta) * sin(phi), l * cos(theta));
        kinetic = kinetic_energy(m, dot(position));
        potential = m * g * position.z;
    ";
    let structure = derived(top).equations.structure;
    assert_eq!(structure.cyclic, [1]);
    assert_eq!(structure.conserved, [Conserved::Momentum(1), Conserved::Energy]);
}

#[test]
fn nothing_is_called_conserved_that_constraints_contacts_or_events_change() {
    let conserved = |statements: &str| {
        let text = format!("coord x, y, z; kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2); {statements}");
        derived(&text).equations.structure.conserved
    };
    let [x, y, z] = [0, 1, 2].map(Conserved::Momentum);
    assert_eq!(conserved(""), [x, y, z, Conserved::Energy]);
    assert_eq!(conserved("constraint rod = x^2 + y^2 - 1;"), [z, Conserved::Energy]);
    assert_eq!(conserved("constraint skate = dot(x) * sin(z) - dot(y) * cos(z);"), [z, Conserved::Energy]);
    assert_eq!(conserved("constraint wire = y - x * sin(t);"), [z]);
    assert_eq!(conserved("constraint belt = dot(x) - 2;"), [y, z]);
    assert_eq!(conserved("event floor = y, falling => impact(1/2);"), [x, z]);
    assert_eq!(conserved("friction rub = dot(x) - dot(y), 3;"), [z]);
    assert_eq!(conserved("event gate = x - 1, rising => { dot(y) = 0; }"), []);
    assert_eq!(conserved("event gate = x - 1, rising => record;"), [x, y, z, Conserved::Energy]);
}

#[test]
fn equations_read_like_those_of_a_textbook() {
    let mut derived = derived(SPRING_PENDULUM);
    let documentation = derived.documentation().join("\n");
    let line = "m*r^2*ddot(theta) = -2*m*r*dot(r)*dot(theta) - m*g*r*sin(theta)";
    assert!(documentation.contains(line), "{documentation}");
    let line = r"m r^{2} \ddot{\theta} = -2 m r \dot{r} \dot{\theta} - m g r \sin\left(\theta\right)";
    assert_eq!(derived.equations_latex().lines().nth(1), Some(line));
}

#[test]
fn the_documentation_names_the_chosen_strategy_and_the_excluded_one() {
    let coupled = |inertia: &str| {
        let text =
            format!("coord x, y; let a = x + sin(y); kinetic = 1/2*dot(x)^2 + {inertia}; potential = x*y;");
        let documentation = |text: &str| derived(text).documentation().join("\n");
        [documentation(&text), documentation(&format!("#[accuracy(strict)] struct System; {text}"))]
    };
    let kept = "eliminated body by body, the kinetic energy kept a sum of squares";
    let closed = "the kinetic energy is no sum of squares";
    let [standard, strict] = coupled("1/2*dot(a)^2 + 1/2*dot(y)^2");
    assert!(standard.contains("sum of squares ") && !standard.contains(closed), "{standard}");
    assert!(strict.contains(kept), "{strict}");
    let [standard, strict] = coupled("1/3*dot(x)*dot(a) + dot(y)^2");
    assert!(
        standard.contains(&format!("; {closed})")) || standard.contains(&format!(", {closed})")),
        "{standard}"
    );
    assert!(strict.contains(&format!("the mass matrix is factorised ({closed})")), "{strict}");
}

#[test]
fn numbers_that_double_in_length_are_refused_before_they_fill_the_memory() {
    let mut text = "coord x; const c0 = 3;".to_owned();
    for i in 0..40 {
        text += &format!("const c{} = c{i}*c{i} + 1/7;", i + 1);
    }
    text += "kinetic = dot(x)^2; potential = c40*x;";
    let report = parse(&text).expect_err("too long");
    assert!(report.to_string().contains("too long to remain exact"), "{report}");
    assert_eq!(report.diagnostics().len(), 1);
}

#[test]
fn a_velocity_in_two_places_of_a_function_counts_twice_in_the_mass_matrix() {
    let system = derived("coord x; kinetic = pow(dot(x), dot(x)); force x = 1;");
    let v = 1.2_f64;
    let inertia = v.powf(v) * ((v.ln() + 1.0).powi(2) + 1.0 / v);
    let acceleration = NumericSystem::new(&system).acceleration(0.0, &[0.0], &[v])[0];
    assert!((acceleration * inertia - 1.0).abs() < 1e-12, "{acceleration}");
}

/// These forms are regular, but not positive.
#[test]
fn lagrangians_of_products_of_velocities_are_solved() {
    let declarations = [
        "coord x, y; lagrangian = dot(x)*dot(y)*(2 + sin(x)) - x*y^2;",
        "coord a, b, c, d;
         lagrangian = dot(a)*dot(b) + 3*dot(b)*dot(c)*cos(a) + 2*dot(c)*dot(d) - a*b + c*d - a*d;",
        // The squares of y and z vanish once x is eliminated.
        "coord x, y, z;
         lagrangian = 1/2*(dot(x) + dot(y) + dot(z))^2 + dot(y)*dot(z) - x*y - y*z - 2*z;",
    ];
    for text in declarations {
        let dense = StrategyChoice::Always(Strategy::MassMatrix);
        let derived = parse(text).expect("a correct declaration").derive(dense).expect("a regular system");
        let system = NumericSystem::new(&derived);
        let n = system.degrees_of_freedom();
        let [q, v] = [0.4, -0.7].map(|scale| (1..=n).map(|i| scale / i as f64).collect::<Vec<_>>());
        let a = system.acceleration(0.0, &q, &v);
        let residual = system.inverse_dynamics(0.0, &q, &v, &a).expect("derived by default");
        assert!(residual.iter().all(|force| force.abs() < 1e-14), "{text} {a:?} {residual:?}");
    }
}

/// Three parallel cranks a, b, c: the coupler of the first two has one constraint too many.
#[test]
fn dependent_constraints_share_their_force() {
    let system = derived(
        "param l = 0.5; coord a, b, c;
         kinetic = 1/2 * (dot(a)^2 + dot(b)^2 + dot(c)^2);
         force a = 6;
         constraint one = l * sin(a) - l * sin(b);
         constraint two = l * cos(a) - l * cos(b);
         constraint three = l * sin(b) - l * sin(c);",
    );
    let system = NumericSystem::new(&system);
    let (angle, at_rest) = (0.7_f64, [0.0; 3]);
    let acceleration = system.acceleration(0.0, &[angle; 3], &at_rest);
    assert!(acceleration.iter().all(|a| (a - 2.0).abs() < 1e-13), "{acceleration:?}");
    // The moment of 4 between a and b is shared in the ratio of the gradients. The moment of 2
    // between b and c is not shared.
    let (sine, cosine) = angle.sin_cos();
    let wanted = [-4.0 / 0.5 * cosine, 4.0 / 0.5 * sine, -2.0 / (0.5 * cosine)];
    let multipliers = system.multipliers(0.0, &[angle; 3], &at_rest);
    let is_near = |(found, wanted): (&f64, &f64)| (found - wanted).abs() < 1e-12;
    assert!(multipliers.iter().zip(&wanted).all(is_near), "{multipliers:?} for {wanted:?}");
}

/// Three massless velocities move two points on a line with them: some combination moves nothing.
#[test]
fn what_no_square_moves_is_refused_at_every_level() {
    for level in Accuracy::ALL {
        let text = format!(
            "#[accuracy({})] struct Rods; param m = 1, l = 1, s = 2; coord a, b, d;
            let x0 = 2 * sin(a - b); let x1 = x0 + (l + s) * sin(d - b);
            kinetic = 1/2 * m * (dot(x0)^2 + dot(x1)^2);",
            level.name()
        );
        let refused = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let report = refused.expect_err("two squares cannot hold three velocities").to_string();
        assert!(report.contains("singular"), "{report}");
    }
}

/// ½ m (ẋ + ẏ)² − ½ m (ẋ − ẏ)² = 2 m ẋ ẏ
#[test]
fn squares_of_both_signs_are_no_obstacle_at_any_level() {
    for level in Accuracy::ALL {
        let text = format!(
            "#[accuracy({})] struct Product; param m = 2; coord x, y;
            kinetic = 1/2 * m * (dot(x) + dot(y))^2 - 1/2 * m * (dot(x) - dot(y))^2; force x = 1; force y = 3;",
            level.name()
        );
        let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let system = NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}")));
        assert_eq!(system.acceleration(0.0, &[0.1, 0.2], &[0.0; 2]), [0.75, 0.25]);
    }
}

/// Every step is roughly linear in the declaration; a quadratic one would take minutes here.
#[test]
fn twenty_thousand_terms_are_derived_and_emitted() {
    let terms = (2..=20_000).map(|k| format!("sin({k}*x)")).collect::<Vec<_>>();
    let text = format!("coord x; kinetic = dot(x)^2; potential = {};", terms.join(" + "));
    let derived = derived(&text);
    let value = derived.equations.accelerations[0];
    let at_rest = evaluate(&derived.model.graph, &[value], |_| 0.0)[0];
    // −Σ k / 2
    assert_eq!(at_rest, -(20_000.0 * 20_001.0 / 2.0 - 1.0) / 2.0);
    assert!(derived.emit(&quote!(::lagrange)).is_ok());
}

/// Expands a struct with these statements, which may be large.
fn expanded(statements: &str) -> String {
    let tokens = format!("#[allow(deprecated)] struct Large; {statements}").parse().expect("tokens");
    expand(tokens, &quote!(::lagrange)).to_string()
}

#[test]
fn a_mass_matrix_of_two_million_entries_is_refused_before_it_is_derived() {
    let names = (0..1415).map(|i| format!("x{i}")).collect::<Vec<_>>();
    let (list, sum) = (names.join(", "), names.join(" + "));
    let refused = expanded(&format!("coord {list}; kinetic = dot({sum})^2;"));
    assert!(refused.contains("compile_error") && refused.contains("more than 2000000 operations"));
    assert!(refused.contains("struct Large"), "the skeleton stands in for it");
}

#[test]
fn the_skeleton_of_a_system_that_is_too_large_is_within_the_limits() {
    let outputs = (0..=5_000).map(|i| format!("output y{i} = x;")).collect::<String>();
    let refused = expanded(&format!("coord x; kinetic = dot(x)^2; {outputs} param k;"));
    assert!(refused.contains("compile_error") && refused.contains("more than 5000"));
    assert!(refused.contains("fn y4999 ") && !refused.contains("fn y5000 ") && refused.contains("pub k "));
}

#[test]
fn zeros_of_a_large_mass_matrix_count_for_nothing() {
    let coordinates = (0..300).map(|i| format!("coord x{i}; kinetic = dot(x{i})^2;")).collect::<String>();
    let emitted = expanded(&coordinates);
    assert!(emitted.contains("fn mass_matrix") && !emitted.contains("LargeSystem"));
}

#[test]
fn only_large_systems_are_warned_of_and_the_struct_can_allow_it() {
    let nested = |depth: usize, emitted: &str| {
        let steps = (1..=depth).map(|i| format!("let z{i} = sin(z{}) + 2 * z{};", i - 1, i - 1));
        let steps = steps.collect::<String>();
        expanded(&format!("coord x; let z0 = x; {steps} kinetic = dot(x)^2; potential = z{depth}; {emitted}"))
    };
    assert!(!nested(10, "").contains("LargeSystem"));
    let large = nested(4000, "");
    assert!(
        large.contains("# [allow (deprecated)] const _ : () = { # [deprecated"),
        "under the struct's levels"
    );
    let without = nested(4000, "emit { no forcing, no energy, no inverse_dynamics }");
    assert!(!without.contains("LargeSystem"));
}

#[test]
fn the_level_of_accuracy_reaches_the_derived_system() {
    for level in Accuracy::ALL {
        let head = format!("#[accuracy({})] struct Named;", level.name());
        assert_eq!(derived(&format!("{head} {SPRING_PENDULUM}")).model.accuracy, level);
    }
    assert_eq!(derived(SPRING_PENDULUM).model.accuracy, Accuracy::Standard);
}

#[test]
fn reduced_types_keep_attributes_but_not_documentation() {
    let text = "
        /// The whole.
        #[doc(hidden)]
        #[derive(Clone)]
        pub struct Whole;
        coord x, y;
        kinetic = 1/2*dot(x)^2 + 1/2*dot(y)^2;
        /// A part.
        reduce Part { freeze x = 0; }";
    let derived = derived(text);
    let part = derived.reduced[0].declaration.attributes.to_string().replace(' ', "");
    assert!(part.contains("hidden") && part.contains("derive(Clone)"), "{part}");
    assert!(part.contains("Apart.") && part.contains("Reducedfrom[`Whole`]:`x=0`frozen."), "{part}");
    assert!(!part.contains("Thewhole."), "{part}");
    let items = derived.emit(&quote!(::lagrange)).expect("constants that fit").to_string();
    assert_eq!(items.matches("hidden").count(), 2);
}

#[test]
fn documentation_of_names_is_kept_in_emitted_code() {
    let text = "
        /// Documents a parameter.
        param m = 1, mu = 1/2;
        /// Documents an input.
        input u;
        /// Documents a coordinate.
        coord x, y;
        kinetic = 1/2*m*(dot(x)^2 + dot(y)^2);
        potential = 9.81*m*y;
        force x = u;
        /// Documents a contact.
        event floor = y, falling => impact(0);
        /// Documents friction.
        friction rub = dot(x), mu*floor;
        /// Documents an output.
        output height = y;";
    let items = derived(text).emit(&quote!(::lagrange)).expect("constants that fit").to_string();
    for of in ["a parameter", "an input", "a coordinate", "a contact", "friction", "an output"] {
        assert!(items.contains(&format!("\" Documents {of}.\"")), "{of}: {items}");
    }
}

/// Roots follow one rule: real from zero upwards, whether odd or even.
#[test]
fn roots_of_odd_powers_are_real_where_their_radicands_are_not_negative() {
    let text = "coord x; kinetic = dot(x)^2; output a = (x^3)^(1/3); output b = (x^5)^(1/5) + (x^2)^(1/2);";
    let system = NumericSystem::new(&derived(text));
    for (name, expected) in [("a", 0.7), ("b", 1.4)] {
        let [below, above] =
            [-0.7, 0.7].map(|x| system.output(name, 0.0, &[x], &[0.0]).expect("declared")[0]);
        assert!(below.is_nan() && (above - expected).abs() < 1e-15, "{name}: {below}, {above}");
    }
}

#[test]
fn rates_of_places_at_rest_are_read_as_they_are_printed() {
    let text = "
        param m, l, c;
        coord phi;
        body arm { mass: m; center: (l, 0); angle: phi; inertia: m; }
        damper { from: arm; to: arm.point(l, 0); damping: c; }
        torsion_damper { from: ground; to: arm; damping: c; }
        output still = velocity(arm);
        output momentum = linear_momentum(arm);
    ";
    let system = parse(text).expect("a correct declaration");
    let printed = system.statements();
    assert_eq!(parse(&printed).expect(&printed).statements(), printed);
}

#[test]
fn momenta_and_parameters_have_units_where_any_are_declared() {
    let declared = "param m: kg, k[2]: N/m, ratio: 1; coord x[2]: m, phi: rad; input f: N;
                    kinetic = 1/2 * m * (dot(x[0])^2 + dot(x[1])^2) + 1/2 * ratio * (1 [kg*m^2]) * dot(phi)^2;
                    potential = 1/2 * (k[0] * x[0]^2 + k[1] * x[1]^2); force x[0] = f;";
    let emit = "emit { jacobian, momentum_rates }";
    let text = expanded(&format!("{declared} {emit}"));
    let has = |text: &str, part: &str| text.replace(' ', "").contains(part);
    for part in [r#"("p_x","N*s"),("p_phi","J*s")"#, "Units:`m`inkg,`k`inN/m,`f`inN.", "constPARAMETERS"] {
        assert!(has(&text, part), "{part}: {text}");
    }
    // Without momenta their units are absent, and without declared units none are listed.
    assert!(!has(&expanded(declared), "p_phi"));
    let plain = expanded(&format!("param m; coord x; kinetic = 1/2 * m * dot(x)^2; {emit}"));
    assert!(has(&plain, "constPARAMETERS") && !has(&plain, "Units:") && !has(&plain, "p_x"));
}

#[test]
fn documentation_says_defaults_in_the_units_they_are_written_in_if_all_elements_have_them() {
    let statements = "param l: mm = 500, even[2]: cm = 4, lever[2]: cm = [4, -2.5]; coord x: m; kinetic = 1/2 * (1 kg) * dot(x)^2; \
                      output s = l + sum(i in 0..2, even[i] + lever[i]);";
    let text = expanded(statements);
    for line in ["`l` in m, 500 mm by default.", "`even` in m, 4 cm by default.", "`lever` in m."] {
        assert!(text.contains(line), "{line}: {text}");
    }
}

#[test]
fn documentation_says_the_units_of_results_if_those_of_the_velocities_are_known() {
    let emit = "emit { jacobian, inverse_mass_matrix }";
    let statements = |mass: &str, x: &str| {
        format!(
            "param m{mass} = 1, l = 2; coord x{x}, phi{}; kinetic = 1/2 * m * (dot(x)^2 + (l * dot(phi))^2); {emit}",
            if x.is_empty() { "" } else { ": rad" }
        )
    };
    let text = expanded(&statements(": kg", ": m").replace("l = 2", "l: m = 2"));
    for line in [
        "In J.",
        "Each is in the unit of its entry of the state over s.",
        "Units by those of the velocities: m/s^2 for m/s, rad/s^2 for rad/s.",
        "Units by those of the velocities: N for m/s, N*m for rad/s.",
        "Units by those of the velocities: kg for m/s, kg*m for m/s and rad/s, kg*m^2 for rad/s.",
        "1/kg for m/s, 1/(kg*m) for m/s and rad/s, 1/(kg*m^2) for rad/s.",
        "Each entry has the unit of its row over that of its column.",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
    let plain = expanded(&statements("", ""));
    for line in ["In J.", "Units by", "Each entry has", "Each is in"] {
        assert!(!plain.contains(line), "{line}: {plain}");
    }
}
