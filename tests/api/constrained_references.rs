//! Compiled systems under constraints against reference values of an independent derivation with
//! many digits. The statements are those of `tests/constrained/*.lag`, which
//! `lagrange-core/tests/constrained.rs` interprets.

use std::fs;
use std::path::Path;

use serde_json::Value;

/// Tests a reference: the compiled declaration at its states.
macro_rules! reference {
    ($name:ident; $($statements:tt)*) => {
        mod $name {
            lagrange::system! {
                struct Compiled;
                $($statements)*
            }

            #[test]
            fn accelerations_and_multipliers_agree() {
                let system = Compiled::default();
                super::compare(stringify!($name), |t, q, v| {
                    let (q, v) = (&super::array(q), &super::array(v));
                    (system.acceleration(t, q, v).to_vec(), system.multipliers(t, q, v).to_vec())
                });
            }
        }
    };
}

fn array<const N: usize>(values: &[f64]) -> [f64; N] {
    values.try_into().expect("one value for each coordinate")
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(entries) => entries.iter().flat_map(numbers).collect(),
        scalar => vec![scalar.as_str().expect("in quotes").parse().expect("a number")],
    }
}

fn compare(name: &str, evaluate: impl Fn(f64, &[f64], &[f64]) -> (Vec<f64>, Vec<f64>)) {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/constrained"));
    let values = fs::read_to_string(directory.join(name).with_extension("json")).expect("a reference");
    let values: Value = serde_json::from_str(&values).expect("valid JSON");
    for state in values["states"].as_array().expect("states") {
        let [t, q, v] = ["t", "q", "v"].map(|key| numbers(&state[key]));
        let (accelerations, multipliers) = evaluate(t[0], &q, &v);
        assert_near(name, &accelerations, &numbers(&state["acceleration"]));
        assert_near(name, &multipliers, &numbers(&state["multipliers"]));
    }
}

fn assert_near(name: &str, found: &[f64], expected: &[f64]) {
    let largest = expected.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    assert_eq!(found.len(), expected.len(), "{name}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= 1e-11 * (1.0 + largest), "{name}: {found:?}, not {expected:?}");
    }
}

reference! { andrews_squeezer;
    param m1 = 0.04325, m2 = 0.00365, m3 = 0.02373, m4 = 0.00706, m5 = 0.07050, m6 = 0.00706, m7 = 0.05498;
    param i1 = 2.194e-6, i2 = 4.410e-7, i3 = 5.255e-6, i4 = 5.667e-7, i5 = 1.169e-5, i6 = 5.667e-7, i7 = 1.912e-5;
    param xa = -0.06934, ya = -0.00227, xb = -0.03635, yb = 0.03273, xc = 0.014, yc = 0.072, c0 = 4530.0, l0 = 0.07785;
    param d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092, ss = 0.035, sa = 0.01874, sb = 0.01043;
    param sc = 0.018, sd = 0.02, ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228, ub = 0.00449, zf = 0.02, zt = 0.04, fa = 0.01421;
    input drive = 0.033;
    coord beta, theta, gamma, phi, delta, omega, eps;
    let m11 = m1 * ra^2 + m2 * (rr^2 - 2 * da * rr * cos(theta) + da^2) + i1 + i2;
    let m21 = m2 * (da^2 - da * rr * cos(theta)) + i2;
    let m22 = m2 * da^2 + i2;
    let m33 = m3 * (sa^2 + sb^2) + i3;
    let m44 = m4 * (e - ea)^2 + i4;
    let m54 = m4 * ((e - ea)^2 + zt * (e - ea) * sin(phi)) + i4;
    let m55 = m4 * (zt^2 + 2 * zt * (e - ea) * sin(phi) + (e - ea)^2) + m5 * (ta^2 + tb^2) + i4 + i5;
    let m66 = m6 * (zf - fa)^2 + i6;
    let m76 = m6 * ((zf - fa)^2 - u * (zf - fa) * sin(omega)) + i6;
    let m77 = m6 * ((zf - fa)^2 - 2 * u * (zf - fa) * sin(omega) + u^2) + m7 * (ua^2 + ub^2) + i6 + i7;
    kinetic = 1/2 * m11 * dot(beta)^2 + m21 * dot(beta) * dot(theta) + 1/2 * m22 * dot(theta)^2 + 1/2 * m33 * dot(gamma)^2
        + 1/2 * m44 * dot(phi)^2 + m54 * dot(phi) * dot(delta) + 1/2 * m55 * dot(delta)^2
        + 1/2 * m66 * dot(omega)^2 + m76 * dot(omega) * dot(eps) + 1/2 * m77 * dot(eps)^2;
    let xd = sd * cos(gamma) + sc * sin(gamma) + xb;
    let yd = sd * sin(gamma) - sc * cos(gamma) + yb;
    potential = 1/2 * c0 * (sqrt((xd - xc)^2 + (yd - yc)^2) - l0)^2;
    force beta = drive;
    constraint g1 = rr * cos(beta) - d * cos(beta + theta) - ss * sin(gamma) - xb;
    constraint g2 = rr * sin(beta) - d * sin(beta + theta) + ss * cos(gamma) - yb;
    constraint g3 = rr * cos(beta) - d * cos(beta + theta) - e * sin(phi + delta) - zt * cos(delta) - xa;
    constraint g4 = rr * sin(beta) - d * sin(beta + theta) + e * cos(phi + delta) - zt * sin(delta) - ya;
    constraint g5 = rr * cos(beta) - d * cos(beta + theta) - zf * cos(omega + eps) - u * sin(eps) - xa;
    constraint g6 = rr * sin(beta) - d * sin(beta + theta) - zf * sin(omega + eps) + u * cos(eps) - ya;
}

reference! { chaplygin_sleigh;
    param m = 1.2, j = 0.3, a = 0.4;
    coord x, y, theta;
    let cx = x + a * cos(theta);
    let cy = y + a * sin(theta);
    kinetic = 1/2 * m * (dot(cx)^2 + dot(cy)^2) + 1/2 * j * dot(theta)^2;
    constraint blade = dot(y) * cos(theta) - dot(x) * sin(theta);
}

reference! { cylinder_on_slope;
    param m = 2.0, r = 0.3, alpha = 0.5235987755982988, g = 9.81;
    const half = 1/2;
    coord x, y, phi;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/2 * (half * m * r^2) * dot(phi)^2;
    potential = m * g * (y * cos(alpha) - x * sin(alpha));
    constraint normal = y;
    constraint rolling = x - r * phi;
}

reference! { ladder_on_wall;
    param m = 10.0, l = 3.0, g = 9.81;
    coord x, y, theta;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/24 * m * l^2 * dot(theta)^2;
    potential = m * g * y;
    constraint floor = y - l / 2 * sin(theta);
    constraint wall = x - l / 2 * cos(theta);
}
