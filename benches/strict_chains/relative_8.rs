//! Written by `tools/chains.py`.

lagrange::system! {
    /// 8 point masses on massless rods in relative angles.
    #[accuracy(strict)]
    pub(crate) struct Relative8;
    param m1, m2, m3, m4, m5, m6, m7, m8, l1, l2, l3, l4, l5, l6, l7, l8, g;
    coord q1, q2, q3, q4, q5, q6, q7, q8;
    let a1 = q1;
    let (x1, y1) = (l1 * sin(a1), -l1 * cos(a1));
    let a2 = a1 + q2;
    let (x2, y2) = (x1 + l2 * sin(a2), y1 - l2 * cos(a2));
    let a3 = a2 + q3;
    let (x3, y3) = (x2 + l3 * sin(a3), y2 - l3 * cos(a3));
    let a4 = a3 + q4;
    let (x4, y4) = (x3 + l4 * sin(a4), y3 - l4 * cos(a4));
    let a5 = a4 + q5;
    let (x5, y5) = (x4 + l5 * sin(a5), y4 - l5 * cos(a5));
    let a6 = a5 + q6;
    let (x6, y6) = (x5 + l6 * sin(a6), y5 - l6 * cos(a6));
    let a7 = a6 + q7;
    let (x7, y7) = (x6 + l7 * sin(a7), y6 - l7 * cos(a7));
    let a8 = a7 + q8;
    let (x8, y8) = (x7 + l8 * sin(a8), y7 - l8 * cos(a8));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2);
    kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    kinetic = 1/2 * m3 * (dot(x3)^2 + dot(y3)^2);
    kinetic = 1/2 * m4 * (dot(x4)^2 + dot(y4)^2);
    kinetic = 1/2 * m5 * (dot(x5)^2 + dot(y5)^2);
    kinetic = 1/2 * m6 * (dot(x6)^2 + dot(y6)^2);
    kinetic = 1/2 * m7 * (dot(x7)^2 + dot(y7)^2);
    kinetic = 1/2 * m8 * (dot(x8)^2 + dot(y8)^2);
    potential = m1 * g * y1;
    potential = m2 * g * y2;
    potential = m3 * g * y3;
    potential = m4 * g * y4;
    potential = m5 * g * y5;
    potential = m6 * g * y6;
    potential = m7 * g * y7;
    potential = m8 * g * y8;
}

#[rustfmt::skip]
pub(crate) fn chain(m: &[f64; 8], l: &[f64; 8], g: f64) -> Relative8 {
    let [m1, m2, m3, m4, m5, m6, m7, m8] = *m;
    let [l1, l2, l3, l4, l5, l6, l7, l8] = *l;
    Relative8 { m1, m2, m3, m4, m5, m6, m7, m8, l1, l2, l3, l4, l5, l6, l7, l8, g }
}
