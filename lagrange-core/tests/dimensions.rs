//! Units: their defaults, their conversion, and mistakes of dimension.

use lagrange_core::pipeline::parse;

/// Returns the errors reported for a declaration, without lines of help.
fn errors(text: &str) -> Vec<String> {
    let report = parse(text).err().map_or_else(String::new, |report| report.to_string());
    report.lines().filter(|line| line.starts_with("error")).map(str::to_owned).collect()
}

mod defaults {
    use super::errors;
    use lagrange_core::expr::evaluate;
    use lagrange_core::pipeline::{System, parse};

    /// Returns the default of the parameter with a name.
    fn default(system: &System, name: &str) -> f64 {
        let model = &system.model;
        let parameter = model.parameters.iter().chain(&model.inputs).find(|one| one.name == name);
        let value = parameter.and_then(|one| one.default).expect("it has a default");
        evaluate(&model.graph, &[value], |_| f64::NAN)[0]
    }

    fn system(statements: &str) -> System {
        let text = format!("{statements} coord x: m; kinetic = kinetic_energy(1 kg, dot(x));");
        parse(&text).unwrap_or_else(|report| panic!("{text}\n{report}"))
    }

    #[test]
    fn numbers_are_scaled_once_and_exactly() {
        let values = [
            ("l: mm = 500", 0.5),
            ("l: mm = -(1/3 + 2)", -7.0 / 3000.0),
            ("l: m = 0.1", 0.1),
            ("l: mm = 2 [inch]", 0.0508),
            ("l: mm = 2 [inch] + 1 [m]", 1.0508),
            ("l: deg = 180", std::f64::consts::PI),
            ("l: rad = 180 deg", std::f64::consts::PI),
            ("l: rad = pi/2", std::f64::consts::FRAC_PI_2),
            ("l: rpm = 30", std::f64::consts::PI),
            ("l: km/h = 36", 10.0),
            ("l: deg^-1 = 1", 180.0 / std::f64::consts::PI),
            ("l: g = 0.3", 0.0003),
            ("l: 1 = 3", 3.0),
        ];
        for (definition, value) in values {
            let system = system(&format!("param _{definition};"));
            assert!(default(&system, "_l").to_bits() == value.to_bits(), "{definition}");
        }
        let system =
            system("const _a: cm = 3; param _l: m = 2 * _a; input _u: kN = 2; param _k[2]: mm = [1, 2];");
        assert_eq!(default(&system, "_l"), 0.06);
        assert_eq!(default(&system, "_u"), 2000.0);
        assert_eq!(default(&system, "_k_1"), 0.002);
    }

    #[test]
    fn names_have_coherent_units() {
        let system = system(
            "param _l: mm = 500, _k: N/m, _n; input _u: kN = 2; coord theta: rad, y: m; velocity w: m/s = dot(y);
             kinetic = 1/2 * 1 [kg*m^2] * dot(theta)^2 + kinetic_energy(1 kg, w); output tip: m = y;",
        );
        let units = &system.model.units;
        let unit = |name: &str| units.get(name).map(|unit| (unit.unit.as_str(), unit.default.as_deref()));
        assert_eq!(unit("_l"), Some(("m", Some("500 mm"))));
        assert_eq!(unit("_k"), Some(("N/m", None)));
        assert_eq!(unit("_u"), Some(("N", Some("2 kN"))));
        assert_eq!(unit("theta"), Some(("rad", None)));
        assert_eq!(unit("theta_dot"), Some(("rad/s", None)));
        assert_eq!(unit("w"), Some(("m/s", None)));
        assert_eq!(unit("tip"), Some(("m", None)));
    }

    #[test]
    fn points_of_tables_are_scaled() {
        let table = "interpolation: linear, outside: clamp;";
        let text = format!(
            "table drive(speed: rpm): kN = [(0, 1), (30, 2 * 1.5)], {table} coord x: m;
             kinetic = kinetic_energy(1 kg, dot(x)); force x = drive(dot(x) / 1 [m]);"
        );
        let derived =
            parse(&text).and_then(|system| system.derive(lagrange_core::derive::StrategyChoice::Cheapest));
        let numeric =
            lagrange_core::pipeline::NumericSystem::new(&derived.expect("a declaration without mistakes"));
        let half = std::f64::consts::FRAC_PI_2;
        assert!((numeric.acceleration(0.0, &[0.0], &[half])[0] - 2000.0).abs() < 1e-9);
    }

    #[test]
    fn units_without_a_number_are_coherent() {
        let mistakes = [
            (
                "param _l: mm; coord x;",
                "error at 1:11: there is no number here for this unit to scale: values of `_l` are in SI units",
            ),
            (
                "coord x: deg;",
                "error at 1:10: there is no number here for this unit to scale: values of `x` are in SI units",
            ),
            (
                "coord x[2]: deg;",
                "error at 1:13: there is no number here for this unit to scale: values of `x[0]` are in SI units",
            ),
            (
                "const a = 2; param _l: mm = 3 * a; coord x;",
                "error at 1:29: values computed from names are in SI units, not in `mm`",
            ),
        ];
        for (text, message) in mistakes {
            let rate = if text.contains('[') { "dot(x[0])^2 + dot(x[1])^2" } else { "dot(x)^2" };
            assert_eq!(errors(&format!("{text} kinetic = {rate};")), [message], "{text}");
        }
    }

    #[test]
    fn lengths_are_no_indices() {
        let messages = errors("const n: mm = 2; coord x[n]; kinetic = sum(i in 0..2, dot(x[i])^2);");
        assert_eq!(messages.len(), 1, "{messages:?}");
        let text = "const n: 1 = 2; coord x[n]; kinetic = sum(i in 0..n, dot(x[i])^2);";
        assert_eq!(errors(text), Vec::<String>::new());
    }
}

mod inference {
    use super::errors;
    use lagrange_core::pipeline::parse;

    /// Returns the inferred unit of a name, or `None` if there is none.
    fn unit(text: &str, name: &str) -> Option<String> {
        let system = parse(text).unwrap_or_else(|report| panic!("{text}\n{report}"));
        system.model.units.get(name).map(|unit| unit.unit.clone())
    }

    const PENDULUM: &str = "
        param m: kg = 1, l, g: m/s^2 = 9.81, c, k, n;
        coord theta;
        let h = -l * cos(theta);
        kinetic = 1/2 * m * l^2 * dot(theta)^2;
        potential = m * g * h + 1/2 * k * (theta - pi / 4)^2;
        dissipation = 1/2 * c * dot(theta)^2;
        input u;
        force theta = u * n;
        output period = 2 * pi * sqrt(l / g);
        output tip = (l * sin(theta), h);";

    #[test]
    fn units_of_names_are_found() {
        let units = [
            ("m", "kg"),
            ("l", "m"),
            ("theta", "1"),
            ("theta_dot", "1/s"),
            ("k", "J"),
            ("c", "J*s"),
            ("period", "s"),
            ("tip", "m"),
        ];
        for (name, found) in units {
            assert_eq!(unit(PENDULUM, name).as_deref(), Some(found), "{name}");
        }
        // A product alone determines none of its factors.
        assert_eq!(unit(PENDULUM, "u"), None);
        assert_eq!(unit(PENDULUM, "n"), None);
    }

    #[test]
    fn nothing_is_found_where_nothing_is_annotated() {
        let text = PENDULUM.replace(": kg", "").replace(": m/s^2", "").replace("* h +", "* h + theta +");
        assert_eq!(unit(&text, "l"), None);
    }

    /// Degrees imply nothing about masses and lengths: plain numbers beside them stay unchanged.
    #[test]
    fn units_of_angles_alone_only_scale() {
        let plain = PENDULUM.replace(": kg", "").replace(": m/s^2", "").replace("* h +", "* h + theta +");
        for (written, instead) in [
            ("pi / 4", "45 deg"),
            ("pi / 4", "1 [arcmin]"),
            ("param m", "param tilt: deg = 30, m"),
            ("coord theta", "coord theta: rad"),
            ("k, n", "k: 1, n"),
        ] {
            let text = plain.replace(written, instead);
            assert_ne!(text, plain);
            assert_eq!(unit(&text, "l"), None, "{instead}");
        }
        // A rate in degrees also has a unit of time.
        let text = format!("{} param spin: deg/s = 1;", PENDULUM.replace("* h +", "* h + theta +"));
        assert_eq!(errors(&text).len(), 1, "{:?}", errors(&text));
    }

    /// An error between two inferred units is reported with the chain of reasons.
    #[test]
    fn reasons_are_reported() {
        let text = "param m: kg = 1, k, c; coord x: m;\nkinetic = kinetic_energy(m, dot(x));\npotential = 1/2 * k * x^2;\n\
                    let f = c * k;\nforce x = f;\ndissipation = c;";
        let report = parse(text).err().map_or_else(String::new, |report| report.to_string());
        let expected = "error at 6:15: this is a length (m), but `dissipation` adds powers (W): a factor in N/s is missing
  note at 5:11: `c` is a length (m), since the force on `x` is a force (N)
  note at 3:13: `k` is a stiffness (N/m), since `potential` adds energies (J)
  help: compare the units of its parts: `c` is in m
";
        assert_eq!(report, expected);
    }

    /// A wrong declaration of a name is one mistake, and two wrong formulas are two.
    #[test]
    fn one_mistake_is_one_error() {
        let wrong_name =
            "param m: N = 1, g: m/s^2 = 1, l: m = 1; coord x: m; kinetic = kinetic_energy(m, dot(x));
             potential = m * g * x; force x = m * g;";
        assert_eq!(errors(wrong_name).len(), 1, "{:?}", errors(wrong_name));
        let wrong_formulas = "param m: kg = 1, g: m/s^2 = 1; coord x: m; kinetic = kinetic_energy(m, dot(x));
             potential = m * g; force x = m * g * t;";
        assert_eq!(errors(wrong_formulas).len(), 2, "{:?}", errors(wrong_formulas));
    }

    #[test]
    fn many_radians_are_doubted() {
        let doubts = |angle: &str| {
            let text = format!(
                "param m: kg = 1; coord x: m; kinetic = kinetic_energy(m, dot(x)); force x = 1 N * sin({angle});"
            );
            let system = parse(&text).unwrap_or_else(|report| panic!("{text}\n{report}"));
            system.report.to_string().contains("30 radians")
        };
        assert!(doubts("30"));
        assert!(!doubts("30 deg") && !doubts("30 rad") && !doubts("3") && !doubts("30 * t / 1 s"));
    }

    #[test]
    fn zero_and_numbers_behind_names_fit() {
        let text = "param m: kg = 1, a = 3, b: N = 0; coord x: m; let c = 2; let p = (0, 4);
            kinetic = kinetic_energy(m, dot(x)); potential = 0; force x = if t < 0 { b + 0 } else { 0 };
            output d = x + a; output e = x / c + 1; output f = (x, x) + p;";
        assert_eq!(errors(text), Vec::<String>::new());
        assert_eq!(unit(text, "a").as_deref(), Some("m"));
    }

    #[test]
    fn states_have_units() {
        let text = "param m: kg = 1, r: ohm = 2, h: H = 0.1, k: N/A = 3; coord x: m; state i: A, q; input w: V;
            kinetic = kinetic_energy(m, dot(x)); force x = k * i; dot(i) = (w - r * i - k * dot(x)) / h; dot(q) = i;";
        assert_eq!(errors(text), Vec::<String>::new());
        assert_eq!(unit(text, "i").as_deref(), Some("A"));
        assert_eq!(unit(text, "q").as_deref(), Some("C"));
    }

    #[test]
    fn bodies_have_units() {
        let plane = "
            param m: kg = 2, l: m = 1.5, k: N/m = 30, c: N*s/m = 1, g: m/s^2 = 9.81, slope: deg = 17, d = 3;
            coord x: m, y: m, a: rad;
            input u: N;
            gravity = (0, -g);
            body rod {
                compound { rectangle(l, l / 5), mass: m; hole disk(l / 20), mass: m / 10, at: (l / 4, 0); }
                center: (x, y); angle: a;
            }
            line floor { through: (0, -2); angle: slope; }
            pin hinge = rod.point(-l / 2, 0) to (0, 1);
            spring { from: rod.point(l / 2, 0); to: (2, 1); stiffness: k; rest: 0.5; }
            damper { from: rod.point(l / 2, 0); to: (2, 1); damping: c; }
            torsion_spring { from: ground; to: rod; stiffness: 2; rest: 0.1; }
            torsion_damper { from: ground; to: rod; damping: d; }
            force (u, 0) at rod;
            output e = rod.point(0, 0).x + 1 [m];
            emit { motion, drawing }";
        assert_eq!(errors(plane), Vec::<String>::new());
        assert_eq!(unit(plane, "d").as_deref(), Some("J*s"));
        let space = "
            param m: kg = 2, l: m = 0.5, r: m = 0.05;
            gravity = (0, 0, -9.81);
            body base { mass: 3 * m; inertia: (0.02, 0.02, 0.01); }
            body arm { mass: m; inertia: (m * l^2 / 12, m * l^2 / 12, 0); centroid: (0, 0, l / 2); }
            frame tool;
            revolute turn = ground to base { at: (0, 0, 0.3); damping: 0.1; }
            revolute lift = base to arm { at: (r, 0, 0.1); axis: (0, 1, 0); }
            weld arm to tool { at: (0, 0, l); turned: (pi / 2, 0, 0); }
            force lift = 2 [N*m];
            emit { frames, frame_jacobians, motion }";
        assert_eq!(errors(space), Vec::<String>::new());
        assert_eq!(unit(space, "lift").as_deref(), Some("rad"));
        let free = "
            param m: kg = 2, l: m = 0.5;
            gravity = (0, 0, -9.81);
            body trunk { mass: m; shape: cuboid(l, l, l / 2); }
            body leg { mass: m / 4; shape: solid_cylinder(l / 9, l); }
            free trunk;
            ball hip = trunk to leg { at: (0, 0, -l); damping: 0.2; }
            prismatic foot = leg to ground { }
            output height = trunk_z;";
        let free = free.replace("prismatic foot = leg to ground { }", "");
        assert_eq!(errors(&free), Vec::<String>::new());
        assert_eq!(unit(&free, "height").as_deref(), Some("m"));
    }
}
