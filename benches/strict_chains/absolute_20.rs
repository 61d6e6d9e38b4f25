//! Written by `tools/chains.py`.

lagrange::system! {
    /// 20 point masses on massless rods in absolute angles.
    #[accuracy(strict)]
    pub(crate) struct Absolute20;
    const n = 20;
    param m[n], l[n], g;
    coord q[n];
    for i in 0..n {
        let p[i] = if i > 0 { p[i-1] + l[i] * (sin(q[i]), -cos(q[i])) } else { l[i] * (sin(q[i]), -cos(q[i])) };
        kinetic = kinetic_energy(m[i], dot(p[i]));
        potential = gravitational_energy(m[i], g, p[i].y);
    }
}

pub(crate) fn chain(m: &[f64; 20], l: &[f64; 20], g: f64) -> Absolute20 {
    Absolute20 { m: *m, l: *l, g }
}
