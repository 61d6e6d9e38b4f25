//! Written by `tools/chains.py`.

lagrange::system! {
    /// 10 point masses on massless rods in absolute angles.
    #[accuracy(strict)]
    pub(crate) struct Absolute10;
    param m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, g;
    coord q1, q2, q3, q4, q5, q6, q7, q8, q9, q10;
    let (x1, y1) = (l1 * sin(q1), -l1 * cos(q1));
    let (x2, y2) = (x1 + l2 * sin(q2), y1 - l2 * cos(q2));
    let (x3, y3) = (x2 + l3 * sin(q3), y2 - l3 * cos(q3));
    let (x4, y4) = (x3 + l4 * sin(q4), y3 - l4 * cos(q4));
    let (x5, y5) = (x4 + l5 * sin(q5), y4 - l5 * cos(q5));
    let (x6, y6) = (x5 + l6 * sin(q6), y5 - l6 * cos(q6));
    let (x7, y7) = (x6 + l7 * sin(q7), y6 - l7 * cos(q7));
    let (x8, y8) = (x7 + l8 * sin(q8), y7 - l8 * cos(q8));
    let (x9, y9) = (x8 + l9 * sin(q9), y8 - l9 * cos(q9));
    let (x10, y10) = (x9 + l10 * sin(q10), y9 - l10 * cos(q10));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2);
    kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    kinetic = 1/2 * m3 * (dot(x3)^2 + dot(y3)^2);
    kinetic = 1/2 * m4 * (dot(x4)^2 + dot(y4)^2);
    kinetic = 1/2 * m5 * (dot(x5)^2 + dot(y5)^2);
    kinetic = 1/2 * m6 * (dot(x6)^2 + dot(y6)^2);
    kinetic = 1/2 * m7 * (dot(x7)^2 + dot(y7)^2);
    kinetic = 1/2 * m8 * (dot(x8)^2 + dot(y8)^2);
    kinetic = 1/2 * m9 * (dot(x9)^2 + dot(y9)^2);
    kinetic = 1/2 * m10 * (dot(x10)^2 + dot(y10)^2);
    potential = m1 * g * y1;
    potential = m2 * g * y2;
    potential = m3 * g * y3;
    potential = m4 * g * y4;
    potential = m5 * g * y5;
    potential = m6 * g * y6;
    potential = m7 * g * y7;
    potential = m8 * g * y8;
    potential = m9 * g * y9;
    potential = m10 * g * y10;
}

#[rustfmt::skip]
pub(crate) fn chain(m: &[f64; 10], l: &[f64; 10], g: f64) -> Absolute10 {
    let [m1, m2, m3, m4, m5, m6, m7, m8, m9, m10] = *m;
    let [l1, l2, l3, l4, l5, l6, l7, l8, l9, l10] = *l;
    Absolute10 { m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, g }
}
