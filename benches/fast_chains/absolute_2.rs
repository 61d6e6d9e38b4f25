//! Written by `tools/chains.py`.

lagrange::system! {
    /// 2 point masses on massless rods in absolute angles.
    #[accuracy(fast)]
    pub(crate) struct Absolute2;
    param m1, m2, l1, l2, g;
    coord q1, q2;
    let (x1, y1) = (l1 * sin(q1), -l1 * cos(q1));
    let (x2, y2) = (x1 + l2 * sin(q2), y1 - l2 * cos(q2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2);
    kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1;
    potential = m2 * g * y2;
}

#[rustfmt::skip]
pub(crate) fn chain(m: &[f64; 2], l: &[f64; 2], g: f64) -> Absolute2 {
    let [m1, m2] = *m;
    let [l1, l2] = *l;
    Absolute2 { m1, m2, l1, l2, g }
}
