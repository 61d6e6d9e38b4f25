//! Pendulum chains by hand: what an expert would write for the systems that benches compare with.
//!
//! A module, not a bench of its own. Everything here is plain safe Rust: arrays on the stack, parameters as
//! run-time values, nothing borrowed from the derivation. Sines and cosines come from the standard library or,
//! for systems with `#[accuracy(fast)]`, from the same inline function as theirs.
//!
//! n point masses m hang on massless rods l under gravity g; rod k leads from mass k − 1 (the fixed pivot for
//! k = 0) to mass k, and its angle is θ_k from the downward vertical. With σ, γ the sine and cosine of
//! θ_(k+1) − θ_k and μ_k the sum of the masses from k on, there are two ways to the accelerations.
//!
//! **Dense.** Written for z_k = l_k θ̈_k the equations are
//!
//! ```text
//! Σ_j μ_max(i,j) cos(θ_i − θ_j) z_j = −μ_i g sin θ_i − Σ_j μ_max(i,j) sin(θ_i − θ_j) l_j θ̇_j²,
//! ```
//!
//! solved by LDLᵀ in n³/6 multiplications.
//!
//! **Recursive.** Featherstone's articulated bodies (*Rigid Body Dynamics Algorithms*, chapter 7), O(n). A
//! massless rod pulls only along itself, so the subtree behind rod k answers with one number: the tension is
//! λ_k b + π_k, where b is the component along the rod of the acceleration of its upper end, gravity included.
//! Eliminating rod k between its neighbours gives, with κ_k = l_k θ̇_k², D = m_k + λ_(k+1) σ²,
//!
//! ```text
//! λ_k = m_k (m_k + λ_(k+1)) / D,    π_k = γ (m_k / D) π_(k+1) − λ_k κ_k,
//! ```
//!
//! from the tip to the pivot. D is a sum of positive terms, and σ comes from the difference of the angles
//! rather than from products of sines, so that no mass or angle makes digits cancel on the way to D.
#![allow(dead_code, reason = "each target that includes this module measures or tests a part of it")]

use lagrange::Scalar;

/// Where sines and cosines come from, and when.
pub(crate) trait SinCos {
    /// Angles, or what has been computed of them.
    type Of<const N: usize>;
    fn of<const N: usize>(angles: [f64; N]) -> Self::Of<N>;
    /// The sine and the cosine of angle k.
    fn at<const N: usize>(angles: &Self::Of<N>, k: usize) -> (f64, f64);
}

/// The function of the standard library, called where its results are needed: other work goes on meanwhile.
pub(crate) struct Platform;

impl SinCos for Platform {
    type Of<const N: usize> = [f64; N];

    #[inline(always)]
    fn of<const N: usize>(angles: [f64; N]) -> [f64; N] {
        angles
    }

    #[inline(always)]
    fn at<const N: usize>(angles: &[f64; N], k: usize) -> (f64, f64) {
        angles[k].sin_cos()
    }
}

/// An inline function, for all angles at a time.
pub(crate) struct Inline;

impl SinCos for Inline {
    type Of<const N: usize> = [(f64, f64); N];

    #[inline(always)]
    fn of<const N: usize>(angles: [f64; N]) -> [(f64, f64); N] {
        Scalar::sin_cos_each(angles)
    }

    #[inline(always)]
    fn at<const N: usize>(angles: &[(f64, f64); N], k: usize) -> (f64, f64) {
        angles[k]
    }
}

/// a·b + c, rounded once where the processor can and twice where that would need a library call.
#[inline(always)]
pub(crate) fn fma(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}

/// Accelerations of the double pendulum in absolute angles, written out.
#[inline]
pub(crate) fn double_pendulum<F: SinCos>(
    q: &[f64; 2],
    v: &[f64; 2],
    m: &[f64; 2],
    l: &[f64; 2],
    g: f64,
) -> [f64; 2] {
    let (l1_inverse, l2_inverse) = (1.0 / l[0], 1.0 / l[1]);
    let waves = F::of([q[0], q[1] - q[0]]);
    let [(s1, c1), (sin, cos)] = [F::at(&waves, 0), F::at(&waves, 1)];
    let pull1 = fma(g, c1, l[0] * v[0] * v[0]);
    let pull2 = l[1] * v[1] * v[1];
    let ratio = m[1] * sin / fma(m[1] * sin, sin, m[0]);
    let across = ratio * fma(cos, pull1, pull2);
    [fma(-g, s1, across) * l1_inverse, -fma(cos, across, sin * pull1) * l2_inverse]
}

/// Accelerations of a chain in absolute angles by assembling and factoring the mass matrix.
#[inline]
pub(crate) fn absolute_chain<F: SinCos, const N: usize>(
    q: &[f64; N],
    v: &[f64; N],
    m: &[f64; N],
    l: &[f64; N],
    g: f64,
) -> [f64; N] {
    let waves = F::of(*q);
    let (mut sin, mut cos, mut mu) = ([0.0; N], [0.0; N], [0.0; N]);
    let mut carried = 0.0;
    for k in (0..N).rev() {
        (sin[k], cos[k]) = F::at(&waves, k);
        carried += m[k];
        mu[k] = carried;
    }
    let mut z = absolute_forcing(&sin, &cos, &mu, v, l, g);
    let mut a = [[0.0; N]; N];
    for i in 0..N {
        for j in i..N {
            a[i][j] = mu[j] * fma(cos[i], cos[j], sin[i] * sin[j]);
        }
    }
    solve_in_place(&mut a, &mut z);
    for k in 0..N {
        z[k] /= l[k];
    }
    z
}

/// The right-hand side of the dense equations, with running sums in place of the double one.
#[inline(always)]
fn absolute_forcing<const N: usize>(
    sin: &[f64; N],
    cos: &[f64; N],
    mu: &[f64; N],
    v: &[f64; N],
    l: &[f64; N],
    g: f64,
) -> [f64; N] {
    let mut f = [0.0; N];
    let (mut x, mut y) = (0.0, g);
    for k in 0..N {
        let pull = l[k] * v[k] * v[k];
        (x, y) = (fma(pull, sin[k], x), fma(pull, cos[k], y));
        f[k] = mu[k] * fma(cos[k], x, -(sin[k] * y));
    }
    let (mut x, mut y) = (0.0, 0.0);
    for k in (0..N).rev() {
        f[k] += fma(cos[k], x, -(sin[k] * y));
        let pull = mu[k] * l[k] * v[k] * v[k];
        (x, y) = (fma(pull, sin[k], x), fma(pull, cos[k], y));
    }
    f
}

/// Solves A x = b by LDLᵀ, reading the upper triangle of A and overwriting both; for up to 24 unknowns.
#[inline(always)]
pub(crate) fn solve_in_place<const N: usize>(a: &mut [[f64; N]; N], b: &mut [f64; N]) {
    const { assert!(N <= 24) }
    // A literal pivot makes every trip count of its step a constant: the loops unroll, which at n = 10 takes
    // a quarter off the time of the whole chain.
    macro_rules! eliminate_each {
        ($($pivot:literal)*) => { [$(if $pivot < N { eliminate::<N, $pivot>(a, b) } else { 0.0 }),*] };
    }
    let inverse = eliminate_each!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23);
    for k in (0..N).rev() {
        let mut rest = b[k];
        for i in k + 1..N {
            rest = fma(-a[k][i], b[i], rest);
        }
        b[k] = rest * inverse[k];
    }
}

/// Eliminates unknown K from the equations behind it; returns the inverse of the pivot.
#[inline(always)]
fn eliminate<const N: usize, const K: usize>(a: &mut [[f64; N]; N], b: &mut [f64; N]) -> f64 {
    let inverse = 1.0 / a[K][K];
    let row = a[K];
    for i in K + 1..N {
        let factor = -row[i] * inverse;
        for j in i..N {
            a[i][j] = fma(factor, row[j], a[i][j]);
        }
        b[i] = fma(factor, b[K], b[i]);
    }
    inverse
}

/// Accelerations of a chain in absolute angles by articulated bodies.
#[inline]
pub(crate) fn absolute_chain_recursive<F: SinCos, const N: usize>(
    q: &[f64; N],
    v: &[f64; N],
    m: &[f64; N],
    l: &[f64; N],
    g: f64,
) -> [f64; N] {
    let mut joints = *q;
    for k in (1..N).rev() {
        joints[k] -= joints[k - 1];
    }
    rod_accelerations::<F, N>(&joints, v, m, l, g)
}

/// Accelerations of a chain in joint angles (each rod against the one before) by articulated bodies.
#[inline]
pub(crate) fn relative_chain<F: SinCos, const N: usize>(
    q: &[f64; N],
    v: &[f64; N],
    m: &[f64; N],
    l: &[f64; N],
    g: f64,
) -> [f64; N] {
    let mut rate = *v;
    for k in 1..N {
        rate[k] += rate[k - 1];
    }
    let mut a = rod_accelerations::<F, N>(q, &rate, m, l, g);
    for k in (1..N).rev() {
        a[k] -= a[k - 1];
    }
    a
}

/// What the sweep from the tip leaves behind for the sweep from the pivot, per rod.
#[derive(Clone, Copy, Default)]
struct Rod {
    /// Sine of the joint angle at the upper end.
    sin: f64,
    /// Cosine of that angle.
    cos: f64,
    /// l θ̇²
    pull: f64,
    /// The lower end accelerates across the rod by −(slope · y + offset) where y is that along it.
    slope: f64,
    /// See `slope`.
    offset: f64,
}

/// Angular accelerations of the rods from the joint angles and the rates of the rods.
#[inline(always)]
fn rod_accelerations<F: SinCos, const N: usize>(
    joints: &[f64; N],
    rate: &[f64; N],
    m: &[f64; N],
    l: &[f64; N],
    g: f64,
) -> [f64; N] {
    let waves = F::of(*joints);
    let mut rods = [Rod::default(); N];
    let (mut sin, mut cos) = (0.0, 1.0);
    let (mut lambda, mut pi) = (0.0, 0.0);
    for k in (0..N).rev() {
        let pull = l[k] * rate[k] * rate[k];
        let ratio = 1.0 / fma(lambda * sin, sin, m[k]);
        let (lever, kept) = (sin * ratio, m[k] * ratio);
        let (slope, offset) = (lever * lambda * cos, lever * pi);
        lambda = kept * (m[k] + lambda);
        pi = fma(kept * cos, pi, -(lambda * pull));
        (sin, cos) = F::at(&waves, k);
        rods[k] = Rod { sin, cos, pull, slope, offset };
    }
    // The pivot accelerates upwards by g: along and across are its components in the frame of a rod.
    let (mut along, mut across) = (-g, 0.0);
    let mut a = [0.0; N];
    for k in 0..N {
        let Rod { sin, cos, pull, slope, offset } = rods[k];
        (along, across) = (fma(cos, along, sin * across), fma(cos, across, -(sin * along)));
        along -= pull;
        let free = across;
        across = -fma(slope, along, offset);
        a[k] = (across - free) / l[k];
    }
    a
}

/// Accelerations of a chain in absolute angles by articulated bodies as they are written for any plane
/// mechanism: a symmetric 2×2 inertia and a force for each subtree. Does not use that rods have no mass.
#[inline]
pub(crate) fn absolute_chain_articulated<F: SinCos, const N: usize>(
    q: &[f64; N],
    v: &[f64; N],
    m: &[f64; N],
    l: &[f64; N],
    g: f64,
) -> [f64; N] {
    let waves = F::of(*q);
    let mut links = [Link::default(); N];
    let (mut x, mut y) = (0.0, 0.0);
    for k in 0..N {
        let (sin, cos) = F::at(&waves, k);
        let arm = [l[k] * cos, l[k] * sin];
        let rate_squared = v[k] * v[k];
        (x, y) = (fma(-arm[1], rate_squared, x), fma(arm[0], rate_squared, y));
        links[k] = Link { arm, centripetal: [x, y], ..Link::default() };
    }
    let (mut xx, mut xy, mut yy, mut px, mut py) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for k in (0..N).rev() {
        let Link { arm: [tx, ty], centripetal: [cx, cy], .. } = links[k];
        (xx, yy) = (xx + m[k], yy + m[k]);
        (px, py) = (fma(m[k], cx, px), fma(m[k], cy + g, py));
        let (wx, wy) = (fma(tx, xx, ty * xy), fma(tx, xy, ty * yy));
        let inverse = 1.0 / fma(tx, wx, ty * wy);
        let (fx, fy) = (wx * inverse, wy * inverse);
        let moment = fma(tx, px, ty * py);
        links[k].factor = [fx, fy];
        links[k].free = moment * inverse;
        (xx, xy, yy) = (fma(-fx, wx, xx), fma(-fx, wy, xy), fma(-fy, wy, yy));
        (px, py) = (fma(-fx, moment, px), fma(-fy, moment, py));
    }
    let (mut ax, mut ay) = (0.0, 0.0);
    std::array::from_fn(|k| {
        let Link { arm, factor, free, .. } = links[k];
        let acceleration = -fma(factor[0], ax, fma(factor[1], ay, free));
        (ax, ay) = (fma(arm[0], acceleration, ax), fma(arm[1], acceleration, ay));
        acceleration
    })
}

/// The same in joint angles.
#[inline]
pub(crate) fn relative_chain_articulated<F: SinCos, const N: usize>(
    q: &[f64; N],
    v: &[f64; N],
    m: &[f64; N],
    l: &[f64; N],
    g: f64,
) -> [f64; N] {
    let (mut angle, mut rate) = (*q, *v);
    for k in 1..N {
        angle[k] += angle[k - 1];
        rate[k] += rate[k - 1];
    }
    let mut a = absolute_chain_articulated::<F, N>(&angle, &rate, m, l, g);
    for k in (1..N).rev() {
        a[k] -= a[k - 1];
    }
    a
}

/// What the sweeps of the articulated chain leave for each other, per rod.
#[derive(Clone, Copy, Default)]
struct Link {
    /// Velocity of the lower end against the upper one at unit rate.
    arm: [f64; 2],
    /// Acceleration of the lower end when no rate changes.
    centripetal: [f64; 2],
    /// Acceleration of the angle for unit accelerations of the upper end, negated.
    factor: [f64; 2],
    /// Acceleration of the angle when the upper end does not accelerate, negated.
    free: f64,
}
