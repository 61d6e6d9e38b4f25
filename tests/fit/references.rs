//! Fits beside those of `least_squares` of SciPy, by `tools/fit.py`.

use lagrange::Simulate;
use lagrange::fit::{Data, Fits};
use lagrange::integrate::RungeKutta4;

lagrange::system! {
    #[derive(Clone, Debug)]
    struct DoublePendulum;
    param m1 = 0.3, m2 = 0.5, l1 = 0.5, l2 = 0.4, g = 9.81, c1 = 0.02, c2 = 0.001;
    coord theta1, theta2;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    dissipation = 1/2 * c1 * dot(theta1)^2 + 1/2 * c2 * (dot(theta2) - dot(theta1))^2;
    output tip = x2;
    emit { jacobian }
}

const DATA: &str = include_str!("../../examples/data/double_pendulum.csv");

const FREE: [(&str, f64, f64); 5] = [
    ("m2", 2.003295515e-01, 6.80157e-04),
    ("c1", 9.877319796e-03, 4.58226e-04),
    ("c2", 4.014156225e-03, 5.28283e-05),
    ("theta1", 1.001369796e+00, 1.47036e-03),
    ("theta2", -4.988166474e-01, 1.66183e-03),
];

/// Five variables take two runs for each evaluation.
#[test]
fn a_fit_without_bounds() {
    let data = Data::parse_csv(DATA).unwrap();
    let pendulum = DoublePendulum::default();
    let fit = pendulum.fit([1.1, -0.4, 0.0, 0.0], data).noise("theta1", 0.01).noise("theta2", 0.02);
    let fit = FREE.iter().fold(fit, |fit, (name, ..)| fit.vary(name, ..));
    let fitted = fit.run().unwrap();
    for (name, value, error) in FREE {
        let (found, found_error) = (fitted.value(name).unwrap(), fitted.standard_error(name).unwrap());
        assert!((found - value).abs() < 1e-3 * error, "{name}: {found} {value}");
        assert!((found_error / error - 1.0).abs() < 1e-4, "{name}: {found_error} {error}");
    }
    assert!((fitted.chi_square() - 327.1606108785).abs() < 1e-5, "{}", fitted.chi_square());
    assert_eq!(fitted.degrees_of_freedom(), 385);
    let text = fitted.to_string();
    assert!(text.starts_with("5 variables fitted to 390 values"), "{text}");
    assert!(text.contains("c2 = 0.004014 ± 0.000053\n"), "{text}");
}

const BOUNDED: [(&str, f64, f64); 2] =
    [("m2", 2.029576507e-01, 4.88565e-04), ("c1", 2.638491823e-02, 1.61987e-04)];

#[test]
fn a_fit_that_a_bound_ends() {
    let data = Data::parse_csv(DATA).unwrap();
    let fitted = DoublePendulum::default()
        .fit([1.0, -0.5, 0.0, 0.0], data)
        .noise("theta1", 0.01)
        .noise("theta2", 0.02)
        .vary("m2", 0.01..=5.0)
        .vary("c1", 0.0..=1.0)
        .vary("c2", 0.0..=0.002)
        .run()
        .unwrap();
    assert!((fitted.chi_square() - 1819.8088027146).abs() < 1e-4, "{}", fitted.chi_square());
    for (name, value, error) in BOUNDED {
        assert!((fitted.value(name).unwrap() - value).abs() < 1e-3 * error, "{name}");
        assert!((fitted.standard_error(name).unwrap() / error - 1.0).abs() < 1e-4, "{name}");
    }
    let [.., bounded] = fitted.values() else { panic!() };
    assert_eq!((bounded.value, bounded.standard_error, bounded.is_at_bound), (0.002, None, true));
    assert!(fitted.to_string().contains("c2 = 0.002, at its bound"), "{fitted}");
}

/// Noise-free data as a run saves them: columns of states and of an output, by another method.
#[test]
fn a_saved_run_is_recovered() {
    let wanted = DoublePendulum { m2: 0.2, c2: 0.004, ..DoublePendulum::default() };
    let start = [1.0, -0.5, 0.0, 0.0];
    let motion = wanted.simulate(start).until(2.0).every(0.05).tolerance(1e-12).outputs().run().unwrap();
    let mut file = Vec::new();
    motion.write_csv(&mut file).unwrap();
    let data = Data::parse_csv(std::str::from_utf8(&file).unwrap()).unwrap().only(["tip", "theta1_dot"]);
    let pendulum = DoublePendulum::default();
    let fit = || {
        let fit = pendulum.fit(start, data.clone()).outputs().noise("tip", 0.01).noise("theta1_dot", 0.1);
        fit.vary("m2", 0.01..=2.0).vary("c2", 0.0..).vary("l2", 0.1..)
    };
    let adaptive = fit().tolerance(1e-11).run().unwrap();
    let fixed = fit().method(RungeKutta4 { step: 5e-4 }).run().unwrap();
    for fitted in [adaptive, fixed] {
        for (name, value) in [("m2", 0.2), ("c2", 0.004), ("l2", 0.4)] {
            let found = fitted.value(name).unwrap();
            assert!((found / value - 1.0).abs() < 1e-7, "{name}: {found}");
        }
        let table = fitted.table();
        assert_eq!(table.names()[..3], ["theta1_dot", "theta1_dot (fit)", "theta1_dot (residual)"]);
        assert!(table.column("tip (residual)").unwrap().iter().all(|residual| residual.abs() < 1e-7));
        assert_eq!(fitted.system().m2, fitted.value("m2").unwrap());
    }
}
