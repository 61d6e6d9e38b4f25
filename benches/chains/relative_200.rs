//! Written by `tools/chains.py`.

lagrange::system! {
    /// 200 point masses on massless rods in relative angles.
    pub(crate) struct Relative200;
    const n = 200;
    param m[n], l[n], g;
    coord q[n];
    for i in 0..n {
        let a[i] = if i > 0 { a[i-1] + q[i] } else { q[i] };
        let p[i] = if i > 0 { p[i-1] + l[i] * (sin(a[i]), -cos(a[i])) } else { l[i] * (sin(a[i]), -cos(a[i])) };
        kinetic = kinetic_energy(m[i], dot(p[i]));
        potential = gravitational_energy(m[i], g, p[i].y);
    }
}

pub(crate) fn chain(m: &[f64; 200], l: &[f64; 200], g: f64) -> Relative200 {
    Relative200 { m: *m, l: *l, g }
}
