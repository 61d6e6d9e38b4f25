//! Written by `tools/chains.py`.

lagrange::system! {
    /// 5 point masses on massless rods in absolute angles.
    #[accuracy(fast)]
    pub(crate) struct Absolute5;
    const n = 5;
    param m[n], l[n], g;
    coord q[n];
    for i in 0..n {
        let p[i] = if i > 0 { p[i-1] + l[i] * (sin(q[i]), -cos(q[i])) } else { l[i] * (sin(q[i]), -cos(q[i])) };
        kinetic = kinetic_energy(m[i], dot(p[i]));
        potential = gravitational_energy(m[i], g, p[i].y);
    }
}

pub(crate) fn chain(m: &[f64; 5], l: &[f64; 5], g: f64) -> Absolute5 {
    Absolute5 { m: *m, l: *l, g }
}
