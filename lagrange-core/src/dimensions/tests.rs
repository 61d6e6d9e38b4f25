use crate::pipeline::parse;

/// What is reported of a declaration, lines of help left out.
fn errors(text: &str) -> Vec<String> {
    let report = parse(text).err().map_or_else(String::new, |report| report.to_string());
    report.lines().filter(|line| line.starts_with("error")).map(str::to_owned).collect()
}

mod defaults {
    use super::errors;
    use crate::calculus::evaluate;
    use crate::pipeline::{System, parse};

    /// Of a parameter of this name, the default.
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
        let derived = parse(&text).and_then(|system| system.derive(crate::derive::StrategyChoice::Cheapest));
        let numeric = crate::pipeline::NumericSystem::new(&derived.expect("a declaration without mistakes"));
        let half = std::f64::consts::FRAC_PI_2;
        assert!((numeric.acceleration(0.0, &[0.0], &[half])[0] - 2000.0).abs() < 1e-9);
    }

    #[test]
    fn units_without_a_number_are_coherent() {
        let mistakes = [
            (
                "param _l: mm; coord x;",
                "error at 1:11: there is no number here for this unit to scale: values of `_l` are in units of the SI",
            ),
            (
                "coord x: deg;",
                "error at 1:10: there is no number here for this unit to scale: values of `x` are in units of the SI",
            ),
            (
                "coord x[2]: deg;",
                "error at 1:13: there is no number here for this unit to scale: values of `x_0` are in units of the SI",
            ),
            (
                "const a = 2; param _l: mm = 3 * a; coord x;",
                "error at 1:29: values made of names are in units of the SI, not in `mm`",
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
