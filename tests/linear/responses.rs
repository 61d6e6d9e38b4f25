//! Transfer functions and responses, against closed forms.

use lagrange::linear::{DenseMatrix, LinearModel, Linearise, Transfer};

lagrange::system! {
    /// A mass on a spring with a damper.
    #[derive(Debug)]
    struct Oscillator;

    param m = 2, d = 1.2, k = 8;
    coord x;
    input u;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * d * dot(x)^2;
    force x = u;
    output place = x;
    output shaking = ddot(x);
    emit { system_matrix }
}

lagrange::system! {
    /// Three first-order lags in series, a loop with known margins.
    #[derive(Debug)]
    struct Lags;

    param gain = 1;
    state a, b, c;
    input u;
    dot(a) = gain * u - a;
    dot(b) = a - b;
    dot(c) = b - c;
    output y = c;
    emit { system_matrix }
}

fn oscillator(d: f64) -> LinearModel {
    Oscillator { d, ..Oscillator::default() }.linearise(0.0, [0.0, 0.0]).unwrap()
}

fn place(d: f64) -> Transfer {
    oscillator(d).transfer("u", "place").unwrap()
}

/// Returns 1 / (k − m ω² + i d ω), or −ω² times that.
fn expected(frequency: f64, d: f64, factor: f64) -> (f64, f64) {
    let (real, imaginary) = (8.0 - 2.0 * frequency * frequency, d * frequency);
    let square = real * real + imaginary * imaginary;
    (factor * real / square, -factor * imaginary / square)
}

fn close(a: (f64, f64), b: (f64, f64), bound: f64) -> bool {
    (a.0 - b.0).hypot(a.1 - b.1) < bound
}

#[test]
fn frequency_responses_are_those_of_the_formula() {
    let model = oscillator(1.2);
    let (place, shaking) = (place(1.2), model.transfer("u", "shaking").unwrap());
    for frequency in [0.0, 0.01, 1.0, 2.0, 3.5, 100.0] {
        assert!(close(place.at(frequency), expected(frequency, 1.2, 1.0), 1e-15));
        let factor = -frequency * frequency;
        assert!(close(shaking.at(frequency), expected(frequency, 1.2, factor), 1e-14), "{frequency}");
    }
    // Without damping, the response at the frequency of the mode is infinite.
    assert!(!self::place(0.0).at(2.0).0.is_finite());
}

#[test]
fn frequencies_reach_beyond_the_modes_and_phases_have_no_jumps() {
    let place = place(1.2);
    let frequencies = place.frequencies();
    assert!((frequencies[0] - 0.2).abs() < 1e-12 && (frequencies[499] - 20.0).abs() < 1e-9);
    let response = place.frequency_response(&frequencies);
    let phases = response.phases();
    assert!(phases.windows(2).all(|pair| pair[1] < pair[0] && pair[0] - pair[1] < 0.2));
    assert!(phases[0] > -0.1 && phases[499] < -3.0);
    // The peak of |G| at ω² = k/m − d²/(2 m²), by differentiation.
    let (size, frequency) = response.peak().unwrap();
    let at = (4.0 - 1.44 / 8.0_f64).sqrt();
    assert!((frequency / at - 1.0).abs() < 0.01);
    let (real, imaginary) = expected(at, 1.2, 1.0);
    assert!((size / real.hypot(imaginary) - 1.0).abs() < 1e-4);
    assert!((response.decibels()[0] - 20.0 * size_at(0.2).log10()).abs() < 1e-12);
}

fn size_at(frequency: f64) -> f64 {
    let (real, imaginary) = expected(frequency, 1.2, 1.0);
    real.hypot(imaginary)
}

#[test]
fn margins_of_three_lags_are_known() {
    // 2 / (1 + s)³: phase −180° at ω = √3, where |G| = 2/8; |G| = 1 at ω² = 2^(2/3) − 1.
    let lags = Lags { gain: 2.0, ..Lags::default() };
    let model = lags.linearise(0.0, [0.0; 3]).unwrap();
    let transfer = model.transfer("u", "y").unwrap();
    let margins = transfer.frequency_response(&transfer.frequencies()).margins();
    let (factor, at) = margins.gain.unwrap();
    assert!((factor - 4.0).abs() < 1e-9 && (at - 3.0_f64.sqrt()).abs() < 1e-9, "{factor} {at}");
    let (lag, at) = margins.phase.unwrap();
    let crossover = (2.0_f64.powf(2.0 / 3.0) - 1.0).sqrt();
    let expected = std::f64::consts::PI - 3.0 * crossover.atan();
    assert!((at - crossover).abs() < 1e-9 && (lag - expected).abs() < 1e-9, "{lag} {at}");
    // Ten times the gain: the loop is unstable, and stable below 8/20 of it.
    let large = Lags { gain: 20.0, ..Lags::default() }.linearise(0.0, [0.0; 3]).unwrap();
    let transfer = large.transfer("u", "y").unwrap();
    let margins = transfer.frequency_response(&transfer.frequencies()).margins();
    let (factor, at) = margins.reduction.unwrap();
    assert!((factor - 0.4).abs() < 1e-9 && (at - 3.0_f64.sqrt()).abs() < 1e-9, "{factor} {at}");
    assert_eq!(margins.gain, None);
    // A loop of small gain never reaches one.
    let small = Lags { gain: 0.5, ..Lags::default() }.linearise(0.0, [0.0; 3]).unwrap();
    let transfer = small.transfer("u", "y").unwrap();
    assert_eq!(transfer.frequency_response(&transfer.frequencies()).margins().phase, None);
}

#[test]
fn responses_in_time_are_closed_forms() {
    let (place, damping) = (place(1.2), 0.3_f64);
    let rate = (4.0 - damping * damping).sqrt();
    let step = place.step_response(20.0).unwrap();
    for (&t, &value) in step.times.iter().zip(&step.values) {
        let decay = (-damping * t).exp() * ((rate * t).cos() + damping / rate * (rate * t).sin());
        assert!((value - (1.0 - decay) / 8.0).abs() < 1e-14, "at {t}");
    }
    let impulse = place.impulse_response(20.0).unwrap();
    for (&t, &value) in impulse.times.iter().zip(&impulse.values) {
        assert!((value - (-damping * t).exp() * (rate * t).sin() / (2.0 * rate)).abs() < 1e-14);
    }
    assert!((step.limit.unwrap() - 0.125).abs() < 1e-15 && impulse.limit == Some(0.0));
    let overshoot = (-damping * std::f64::consts::PI / rate).exp();
    assert!((step.overshoot().unwrap() - overshoot).abs() < 1e-3);
    // Rise from 10 % to 90 % by bisection of the closed form.
    let part = |t: f64| 1.0 - (-damping * t).exp() * ((rate * t).cos() + damping / rate * (rate * t).sin());
    let reaches = |level: f64| {
        let (mut from, mut to) = (0.0, 1.0);
        for _ in 0..50 {
            let middle = (from + to) / 2.0;
            if part(middle) < level { from = middle } else { to = middle }
        }
        to
    };
    let rise = step.rise_time().unwrap();
    assert!((rise - (reaches(0.9) - reaches(0.1))).abs() < 1e-3, "{rise}");
    let settling = step.settling_time(0.02).unwrap();
    let within = |t: f64| (-damping * t).exp() * (4.0_f64 / (4.0 - damping * damping)).sqrt() <= 0.02;
    assert!(within(settling + 2.0) && settling > 10.0, "{settling}");
}

#[test]
fn responses_without_a_limit_are_reported() {
    let undamped = place(0.0).step_response(3.0).unwrap();
    assert_eq!((undamped.limit, undamped.rise_time(), undamped.settling_time(0.02)), (None, None, None));
    assert!((undamped.values[499] - (1.0 - 6.0_f64.cos()) / 8.0).abs() < 1e-14);
    let negative = place(-1.0);
    assert_eq!(negative.step_response(1.0).unwrap().limit, None);
    assert!(negative.step_response(1e6).is_none());
    assert!(negative.step_response(0.0).is_none() && negative.step_response(f64::NAN).is_none());
}

#[test]
fn feedback_moves_the_response() {
    let model = oscillator(0.0);
    let gain = DenseMatrix::from_rows(&[[0.0, 1.2]]);
    let damped = model.with_feedback(&gain).unwrap();
    let value = damped.transfer("u", "place").unwrap().at(1.5);
    assert!(close(value, expected(1.5, 1.2, 1.0), 1e-15));
    // Outputs of accelerations depend on the feedback, too.
    let shaking = damped.transfer("u", "shaking").unwrap().at(1.5);
    assert!(close(shaking, expected(1.5, 1.2, -2.25), 1e-15));
    assert!(model.with_feedback(&DenseMatrix::identity(2)).is_none());
}

#[test]
fn unknown_channels_are_named() {
    let error = oscillator(1.0).transfer("v", "place").unwrap_err();
    assert_eq!(error.to_string(), "the linear model has no `v`; it has `u`");
}

#[cfg(feature = "plot")]
#[test]
fn responses_are_plotted() {
    let folder = std::env::temp_dir().join(format!("lagrange-responses-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let place = place(1.2);
    let response = place.frequency_response(&place.frequencies());
    response.plot_bode(folder.join("bode.svg")).unwrap();
    response.plot_nyquist(folder.join("nyquist.svg")).unwrap();
    place.step_response(20.0).unwrap().plot(folder.join("step.svg")).unwrap();
    for file in ["bode", "nyquist", "step"] {
        let text = std::fs::read_to_string(folder.join(file).with_extension("svg")).unwrap();
        assert!(text.starts_with("<svg") && !text.contains("NaN"), "{file}");
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

#[cfg(feature = "plot")]
lagrange::system! {
    /// The oscillator with units.
    #[derive(Debug)]
    struct Measured;

    param m: kg = 2, d: kg/s = 1.2, k: N/m = 8;
    coord x: m;
    input u: N;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * d * dot(x)^2;
    force x = u;
    output place: m = x;
    output speed: m/s = dot(x);
    output share = k * x / u;
    emit { system_matrix }
}

#[cfg(feature = "plot")]
#[test]
fn axes_of_responses_show_units() {
    let folder = std::env::temp_dir().join(format!("lagrange-axes-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let measured = Measured { u: 1.0, ..Measured::default() };
    let model = measured.linearise(0.0, [0.1, 0.0]).unwrap();
    let gain = DenseMatrix::from_rows(&[[5.0, 0.7]]);
    let cases = [
        (
            model.transfer("u", "place").unwrap(),
            "magnitude in dB re 1 m/N<",
            "real part in m/N<",
            "place in m<",
        ),
        (
            model.transfer("u", "speed").unwrap(),
            "dB re 1 (m/s)/N<",
            "imaginary part in (m/s)/N<",
            "speed in m/s<",
        ),
        (model.transfer("u", "share").unwrap(), "dB re 1 1/N<", "real part in 1/N<", "share<"),
        // The feedback of an input has the same unit.
        (model.open_loop(&gain, "u").unwrap(), "magnitude in dB<", "real part<", "feedback in N<"),
    ];
    for (transfer, magnitude, part, value) in cases {
        let response = transfer.frequency_response(&transfer.frequencies());
        response.plot_bode(folder.join("bode.svg")).unwrap();
        response.plot_nyquist(folder.join("nyquist.svg")).unwrap();
        transfer.step_response(20.0).unwrap().plot(folder.join("step.svg")).unwrap();
        let expected = [
            ("bode", magnitude),
            ("bode", " in rad/s<"),
            ("nyquist", part),
            ("step", value),
            ("step", " in s<"),
        ];
        for (file, label) in expected {
            let text = std::fs::read_to_string(folder.join(file).with_extension("svg")).unwrap();
            assert!(text.contains(label), "{file} of {} lacks {label}", transfer.output);
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

lagrange::system! {
    /// Two masses between springs, each with a motor.
    #[derive(Debug)]
    struct Coupled;

    param k = 3;
    coord x, y;
    input u, w;
    kinetic = 1/2 * dot(x)^2 + 1/2 * dot(y)^2;
    potential = 1/2 * k * (x^2 + (y - x)^2);
    force x = u;
    force y = w;
    emit { system_matrix }
}

#[test]
fn loops_of_regulators_are_those_of_the_formula() {
    let (model, gain) = (oscillator(1.2), DenseMatrix::from_fn(1, 2, |_, j| [5.0, 0.7][j]));
    let cut = model.open_loop(&gain, "u").unwrap();
    for frequency in [0.0, 1.0, 2.0, 3.5] {
        let (real, imaginary) = expected(frequency, 1.2, 1.0);
        let rate = 0.7 * frequency;
        let wanted = (5.0 * real - rate * imaginary, 5.0 * imaginary + rate * real);
        assert!(close(cut.at(frequency), wanted, 1e-14), "{frequency}");
    }
    assert!(model.open_loop(&gain, "v").is_none());
    assert!(model.open_loop(&DenseMatrix::identity(2), "u").is_none());
}

/// An optimal loop keeps its distance from −1: |1 + L| ≥ 1. Source: Anderson, Moore, *Optimal
/// Control: Linear Quadratic Methods*, §5.3.
#[test]
fn optimal_loops_are_no_nearer_to_instability_than_one() {
    let model = Coupled::default().linearise(0.0, [0.0; 4]).unwrap();
    let regulator = model.lqr(&DenseMatrix::identity(4), &DenseMatrix::identity(2)).unwrap();
    for input in ["u", "w"] {
        let cut = model.open_loop(&regulator.gain, input).unwrap();
        for index in 0..200 {
            let (real, imaginary) = cut.at(0.017 * 1.05_f64.powi(index));
            assert!((1.0 + real).hypot(imaginary) > 1.0 - 1e-12);
        }
        let margins = cut.frequency_response(&cut.frequencies()).margins();
        assert!(margins.gain.is_none() && margins.phase.is_none_or(|(phase, _)| phase > 1.047));
        assert!(margins.reduction.is_none_or(|(factor, _)| factor < 0.5));
    }
}
