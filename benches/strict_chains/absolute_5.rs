//! Written by `tools/chains.py`.

lagrange::system! {
    /// 5 point masses on massless rods in absolute angles.
    #[accuracy(strict)]
    pub(crate) struct Absolute5;
    param m1, m2, m3, m4, m5, l1, l2, l3, l4, l5, g;
    coord q1, q2, q3, q4, q5;
    let (x1, y1) = (l1 * sin(q1), -l1 * cos(q1));
    let (x2, y2) = (x1 + l2 * sin(q2), y1 - l2 * cos(q2));
    let (x3, y3) = (x2 + l3 * sin(q3), y2 - l3 * cos(q3));
    let (x4, y4) = (x3 + l4 * sin(q4), y3 - l4 * cos(q4));
    let (x5, y5) = (x4 + l5 * sin(q5), y4 - l5 * cos(q5));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2);
    kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    kinetic = 1/2 * m3 * (dot(x3)^2 + dot(y3)^2);
    kinetic = 1/2 * m4 * (dot(x4)^2 + dot(y4)^2);
    kinetic = 1/2 * m5 * (dot(x5)^2 + dot(y5)^2);
    potential = m1 * g * y1;
    potential = m2 * g * y2;
    potential = m3 * g * y3;
    potential = m4 * g * y4;
    potential = m5 * g * y5;
}

#[rustfmt::skip]
pub(crate) fn chain(m: &[f64; 5], l: &[f64; 5], g: f64) -> Absolute5 {
    let [m1, m2, m3, m4, m5] = *m;
    let [l1, l2, l3, l4, l5] = *l;
    Absolute5 { m1, m2, m3, m4, m5, l1, l2, l3, l4, l5, g }
}
