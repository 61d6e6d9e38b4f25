//! Written by `tools/chains.py`.

lagrange::system! {
    /// 4 point masses on massless rods in relative angles.
    #[accuracy(fast)]
    pub(crate) struct Relative4;
    param m1, m2, m3, m4, l1, l2, l3, l4, g;
    coord q1, q2, q3, q4;
    let a1 = q1;
    let (x1, y1) = (l1 * sin(a1), -l1 * cos(a1));
    let a2 = a1 + q2;
    let (x2, y2) = (x1 + l2 * sin(a2), y1 - l2 * cos(a2));
    let a3 = a2 + q3;
    let (x3, y3) = (x2 + l3 * sin(a3), y2 - l3 * cos(a3));
    let a4 = a3 + q4;
    let (x4, y4) = (x3 + l4 * sin(a4), y3 - l4 * cos(a4));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2);
    kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    kinetic = 1/2 * m3 * (dot(x3)^2 + dot(y3)^2);
    kinetic = 1/2 * m4 * (dot(x4)^2 + dot(y4)^2);
    potential = m1 * g * y1;
    potential = m2 * g * y2;
    potential = m3 * g * y3;
    potential = m4 * g * y4;
}

#[rustfmt::skip]
pub(crate) fn chain(m: &[f64; 4], l: &[f64; 4], g: f64) -> Relative4 {
    let [m1, m2, m3, m4] = *m;
    let [l1, l2, l3, l4] = *l;
    Relative4 { m1, m2, m3, m4, l1, l2, l3, l4, g }
}
