//! Written by `tools/chains.py`.

lagrange::system! {
    /// 10 point masses on massless rods in absolute angles.
    pub(crate) struct Absolute10;
    const n = 10;
    param m[n], l[n], g;
    coord q[n];
    for i in 0..n {
        let p[i] = if i > 0 { p[i-1] + l[i] * (sin(q[i]), -cos(q[i])) } else { l[i] * (sin(q[i]), -cos(q[i])) };
        kinetic = kinetic_energy(m[i], dot(p[i]));
        potential = gravitational_energy(m[i], g, p[i].y);
    }
}

pub(crate) fn chain(m: &[f64; 10], l: &[f64; 10], g: f64) -> Absolute10 {
    Absolute10 { m: *m, l: *l, g }
}
