//! Written by `tools/chains.py`.

lagrange::system! {
    /// 20 point masses on massless rods in relative angles.
    pub(crate) struct Relative20;
    param m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, l11, l12, l13, l14, l15, l16, l17, l18, l19, l20, g;
    coord q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15, q16, q17, q18, q19, q20;
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
    let a9 = a8 + q9;
    let (x9, y9) = (x8 + l9 * sin(a9), y8 - l9 * cos(a9));
    let a10 = a9 + q10;
    let (x10, y10) = (x9 + l10 * sin(a10), y9 - l10 * cos(a10));
    let a11 = a10 + q11;
    let (x11, y11) = (x10 + l11 * sin(a11), y10 - l11 * cos(a11));
    let a12 = a11 + q12;
    let (x12, y12) = (x11 + l12 * sin(a12), y11 - l12 * cos(a12));
    let a13 = a12 + q13;
    let (x13, y13) = (x12 + l13 * sin(a13), y12 - l13 * cos(a13));
    let a14 = a13 + q14;
    let (x14, y14) = (x13 + l14 * sin(a14), y13 - l14 * cos(a14));
    let a15 = a14 + q15;
    let (x15, y15) = (x14 + l15 * sin(a15), y14 - l15 * cos(a15));
    let a16 = a15 + q16;
    let (x16, y16) = (x15 + l16 * sin(a16), y15 - l16 * cos(a16));
    let a17 = a16 + q17;
    let (x17, y17) = (x16 + l17 * sin(a17), y16 - l17 * cos(a17));
    let a18 = a17 + q18;
    let (x18, y18) = (x17 + l18 * sin(a18), y17 - l18 * cos(a18));
    let a19 = a18 + q19;
    let (x19, y19) = (x18 + l19 * sin(a19), y18 - l19 * cos(a19));
    let a20 = a19 + q20;
    let (x20, y20) = (x19 + l20 * sin(a20), y19 - l20 * cos(a20));
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
    kinetic = 1/2 * m11 * (dot(x11)^2 + dot(y11)^2);
    kinetic = 1/2 * m12 * (dot(x12)^2 + dot(y12)^2);
    kinetic = 1/2 * m13 * (dot(x13)^2 + dot(y13)^2);
    kinetic = 1/2 * m14 * (dot(x14)^2 + dot(y14)^2);
    kinetic = 1/2 * m15 * (dot(x15)^2 + dot(y15)^2);
    kinetic = 1/2 * m16 * (dot(x16)^2 + dot(y16)^2);
    kinetic = 1/2 * m17 * (dot(x17)^2 + dot(y17)^2);
    kinetic = 1/2 * m18 * (dot(x18)^2 + dot(y18)^2);
    kinetic = 1/2 * m19 * (dot(x19)^2 + dot(y19)^2);
    kinetic = 1/2 * m20 * (dot(x20)^2 + dot(y20)^2);
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
    potential = m11 * g * y11;
    potential = m12 * g * y12;
    potential = m13 * g * y13;
    potential = m14 * g * y14;
    potential = m15 * g * y15;
    potential = m16 * g * y16;
    potential = m17 * g * y17;
    potential = m18 * g * y18;
    potential = m19 * g * y19;
    potential = m20 * g * y20;
}

#[rustfmt::skip]
pub(crate) fn chain(m: &[f64; 20], l: &[f64; 20], g: f64) -> Relative20 {
    let [m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20] = *m;
    let [l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, l11, l12, l13, l14, l15, l16, l17, l18, l19, l20] = *l;
    Relative20 { m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, l11, l12, l13, l14, l15, l16, l17, l18, l19, l20, g }
}
