//! Emitted right-hand sides of constrained systems against handwritten ones, in alternation: rows
//! of a Markdown table.
//!
//! Handwritten means the code of a good engineer: mass matrix, forces and constraints in closed
//! form, and each sine and cosine once. An LDLᵀ factorisation of the whole system, on the stack
//! with unrolled loops, gives accelerations and multipliers,
//!
//! ```text
//! ⎡ M  Aᵀ ⎤ ⎡  a ⎤   ⎡  f ⎤
//! ⎣ A  0  ⎦ ⎣ −λ ⎦ = ⎣ −γ ⎦ ,    γ = c̈ at zero acceleration.
//! ```
//!
//! There is no search for pivots: M is definite, and so is A M⁻¹ Aᵀ. Times are minima, ratios
//! medians (`timing.rs`).

#[path = "../tests/mechanisms/four_bar.rs"]
mod four_bar;
mod handwritten;
#[path = "../tests/mechanisms/squeezer.rs"]
mod squeezer;
mod timing;

use std::hint::black_box;

use four_bar::{FourBar, FourBarState};
use handwritten::solve_in_place;
use squeezer::{Squeezer, SqueezerState};
use timing::in_turns;

/// Solves the system above for accelerations: N coordinates, K unknowns in total, the upper
/// triangle of the matrix.
#[inline(always)]
fn solved<const N: usize, const K: usize>(mut matrix: [[f64; K]; K], mut right: [f64; K]) -> [f64; N] {
    solve_in_place(&mut matrix, &mut right);
    std::array::from_fn(|i| right[i])
}

/// Computes accelerations of the four-bar linkage.
fn four_bar_by_hand(p: &FourBar, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
    let [(s1, c1), (s2, c2), (s3, c3)] = q.map(f64::sin_cos);
    let [w1, w2, w3] = v.map(|rate| rate * rate);
    let &FourBar { a, b, c, m1, m2, m3, g, .. } = p;
    let coupling = m2 * a * b / 2.0;
    let (cosine, sine) = (c1 * c2 + s1 * s2, s1 * c2 - c1 * s2);
    let matrix = [
        [(m1 / 3.0 + m2) * a * a, coupling * cosine, 0.0, -a * s1, a * c1],
        [0.0, m2 * b * b / 3.0, 0.0, -b * s2, b * c2],
        [0.0, 0.0, m3 * c * c / 3.0, c * s3, -c * c3],
        [0.0; 5],
        [0.0; 5],
    ];
    let right = [
        -coupling * sine * w2 - (m1 / 2.0 + m2) * g * a * c1,
        coupling * sine * w1 - m2 * g * b / 2.0 * c2,
        -m3 * g * c / 2.0 * c3,
        a * c1 * w1 + b * c2 * w2 - c * c3 * w3,
        a * s1 * w1 + b * s2 * w2 - c * s3 * w3,
    ];
    solved(matrix, right)
}

/// Computes accelerations of the squeezing mechanism.
fn squeezer_by_hand(p: &Squeezer, q: &[f64; 7], v: &[f64; 7]) -> [f64; 7] {
    let &[beta, theta, gamma, phi, delta, omega, eps] = q;
    let &[beta_dot, theta_dot, gamma_dot, phi_dot, delta_dot, omega_dot, eps_dot] = v;
    let ((sb, cb), (st, ct), (sg, cg)) = (beta.sin_cos(), theta.sin_cos(), gamma.sin_cos());
    let ((sp, cp), (sd, cd)) = (phi.sin_cos(), delta.sin_cos());
    let ((so, co), (se, ce)) = (omega.sin_cos(), eps.sin_cos());
    let (s_bt, c_bt) = (sb * ct + cb * st, cb * ct - sb * st);
    let (s_pd, c_pd) = (sp * cd + cp * sd, cp * cd - sp * sd);
    let (s_oe, c_oe) = (so * ce + co * se, co * ce - so * se);

    let (arm4, arm6) = (p.e - p.ea, p.zf - p.fa);
    let (k2, k4, k6) = (p.m2 * p.da * p.rr, p.m4 * p.zt * arm4, p.m6 * p.u * arm6);
    let (own2, own4) = (p.m2 * p.da * p.da + p.i2, p.m4 * arm4 * arm4 + p.i4);
    let own6 = p.m6 * arm6 * arm6 + p.i6;
    let m11 = p.m1 * p.ra * p.ra + p.m2 * p.rr * p.rr - 2.0 * k2 * ct + own2 + p.i1;
    let m33 = p.m3 * (p.sa * p.sa + p.sb * p.sb) + p.i3;
    let m55 = p.m4 * p.zt * p.zt + 2.0 * k4 * sp + own4 + p.m5 * (p.ta * p.ta + p.tb * p.tb) + p.i5;
    let m77 = p.m6 * p.u * p.u - 2.0 * k6 * so + own6 + p.m7 * (p.ua * p.ua + p.ub * p.ub) + p.i7;

    let (px, py) = (-p.rr * sb + p.d * s_bt, p.rr * cb - p.d * c_bt);
    let (tx, ty) = (p.d * s_bt, -p.d * c_bt);
    let (fx, fy) = (-p.e * c_pd, -p.e * s_pd);
    let (ox, oy) = (p.zf * s_oe, -p.zf * c_oe);
    let (gx, gy) = (-p.ss * cg, -p.ss * sg);
    let (dx, dy) = (fx + p.zt * sd, fy - p.zt * cd);
    let (ex, ey) = (ox - p.u * ce, oy - p.u * se);
    let mut matrix = [[0.0; 13]; 13];
    matrix[0] = [m11, own2 - k2 * ct, 0.0, 0.0, 0.0, 0.0, 0.0, px, py, px, py, px, py];
    matrix[1] = [0.0, own2, 0.0, 0.0, 0.0, 0.0, 0.0, tx, ty, tx, ty, tx, ty];
    matrix[2] = [0.0, 0.0, m33, 0.0, 0.0, 0.0, 0.0, gx, gy, 0.0, 0.0, 0.0, 0.0];
    matrix[3] = [0.0, 0.0, 0.0, own4, own4 + k4 * sp, 0.0, 0.0, 0.0, 0.0, fx, fy, 0.0, 0.0];
    matrix[4] = [0.0, 0.0, 0.0, 0.0, m55, 0.0, 0.0, 0.0, 0.0, dx, dy, 0.0, 0.0];
    matrix[5] = [0.0, 0.0, 0.0, 0.0, 0.0, own6, own6 - k6 * so, 0.0, 0.0, 0.0, 0.0, ox, oy];
    matrix[6] = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, m77, 0.0, 0.0, 0.0, 0.0, ex, ey];

    let (x, y) = (p.xb + p.sc * sg + p.sd * cg - p.xc, p.yb - p.sc * cg + p.sd * sg - p.yc);
    let length = x.hypot(y);
    let pull = -p.c0 * (length - p.l0) / length;
    let (bb, gg, dd, ee) =
        (beta_dot * beta_dot, gamma_dot * gamma_dot, delta_dot * delta_dot, eps_dot * eps_dot);
    let bt = (beta_dot + theta_dot) * (beta_dot + theta_dot);
    let pd = (phi_dot + delta_dot) * (phi_dot + delta_dot);
    let oe = (omega_dot + eps_dot) * (omega_dot + eps_dot);
    let (ax, ay) = (p.rr * cb * bb - p.d * c_bt * bt, p.rr * sb * bb - p.d * s_bt * bt);
    let right = [
        p.drive - k2 * theta_dot * (theta_dot + 2.0 * beta_dot) * st,
        k2 * bb * st,
        pull * (x * (p.sc * cg - p.sd * sg) + y * (p.sc * sg + p.sd * cg)),
        k4 * dd * cp,
        -k4 * phi_dot * (phi_dot + 2.0 * delta_dot) * cp,
        -k6 * ee * co,
        k6 * omega_dot * (omega_dot + 2.0 * eps_dot) * co,
        ax - p.ss * sg * gg,
        ay + p.ss * cg * gg,
        ax - p.e * s_pd * pd - p.zt * cd * dd,
        ay + p.e * c_pd * pd - p.zt * sd * dd,
        ax - p.zf * c_oe * oe - p.u * se * ee,
        ay - p.zf * s_oe * oe + p.u * ce * ee,
    ];
    solved(matrix, right)
}

/// Asserts that both ways agree at this state.
#[track_caller]
fn assert_same<const N: usize>(emitted: &[f64; N], by_hand: &[f64; N]) {
    let largest = emitted.iter().fold(0.0_f64, |largest, a| largest.max(a.abs()));
    for (a, b) in emitted.iter().zip(by_hand) {
        assert!((a - b).abs() < 1e-10 * largest, "{emitted:?} emitted, {by_hand:?} by hand");
    }
}

fn main() {
    println!("| system | emitted, ns | by hand, ns | ratio |\n|---|---|---|---|");
    let linkage = black_box(FourBar::default());
    for state in [four_bar::START, [0.3, 1.1, 2.0, 3.0, -0.7, 0.9]].map(FourBarState::from) {
        let (q, v) = (state.coordinates(), state.velocities());
        assert_same(&linkage.acceleration(0.0, &q, &v), &four_bar_by_hand(&linkage, &q, &v));
    }
    let times = in_turns(
        |q, v| black_box(&linkage).acceleration(0.0, q, v),
        |q, v| four_bar_by_hand(black_box(&linkage), q, v),
    );
    println!("| four-bar linkage | {times} |");

    let squeezer = black_box(Squeezer::default());
    let moving = [-0.05, 0.02, 0.45, 0.22, 0.49, -0.23, 1.24, 1.0, -0.8, 0.3, 0.2, -0.4, 0.5, 0.7];
    for state in [squeezer::START, moving].map(SqueezerState::from) {
        let (q, v) = (state.coordinates(), state.velocities());
        assert_same(&squeezer.acceleration(0.0, &q, &v), &squeezer_by_hand(&squeezer, &q, &v));
    }
    let times = in_turns(
        |q, v| black_box(&squeezer).acceleration(0.0, q, v),
        |q, v| squeezer_by_hand(black_box(&squeezer), q, v),
    );
    println!("| Andrews' squeezer | {times} |");
}
