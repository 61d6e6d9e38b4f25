//! Written by `tools/chains.py`.

lagrange::system! {
    /// 30 point masses on massless rods in absolute angles.
    pub(crate) struct Absolute30;
    param m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, m21, m22, m23, m24, m25, m26, m27, m28, m29, m30, l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, l11, l12, l13, l14, l15, l16, l17, l18, l19, l20, l21, l22, l23, l24, l25, l26, l27, l28, l29, l30, g;
    coord q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15, q16, q17, q18, q19, q20, q21, q22, q23, q24, q25, q26, q27, q28, q29, q30;
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
    let (x11, y11) = (x10 + l11 * sin(q11), y10 - l11 * cos(q11));
    let (x12, y12) = (x11 + l12 * sin(q12), y11 - l12 * cos(q12));
    let (x13, y13) = (x12 + l13 * sin(q13), y12 - l13 * cos(q13));
    let (x14, y14) = (x13 + l14 * sin(q14), y13 - l14 * cos(q14));
    let (x15, y15) = (x14 + l15 * sin(q15), y14 - l15 * cos(q15));
    let (x16, y16) = (x15 + l16 * sin(q16), y15 - l16 * cos(q16));
    let (x17, y17) = (x16 + l17 * sin(q17), y16 - l17 * cos(q17));
    let (x18, y18) = (x17 + l18 * sin(q18), y17 - l18 * cos(q18));
    let (x19, y19) = (x18 + l19 * sin(q19), y18 - l19 * cos(q19));
    let (x20, y20) = (x19 + l20 * sin(q20), y19 - l20 * cos(q20));
    let (x21, y21) = (x20 + l21 * sin(q21), y20 - l21 * cos(q21));
    let (x22, y22) = (x21 + l22 * sin(q22), y21 - l22 * cos(q22));
    let (x23, y23) = (x22 + l23 * sin(q23), y22 - l23 * cos(q23));
    let (x24, y24) = (x23 + l24 * sin(q24), y23 - l24 * cos(q24));
    let (x25, y25) = (x24 + l25 * sin(q25), y24 - l25 * cos(q25));
    let (x26, y26) = (x25 + l26 * sin(q26), y25 - l26 * cos(q26));
    let (x27, y27) = (x26 + l27 * sin(q27), y26 - l27 * cos(q27));
    let (x28, y28) = (x27 + l28 * sin(q28), y27 - l28 * cos(q28));
    let (x29, y29) = (x28 + l29 * sin(q29), y28 - l29 * cos(q29));
    let (x30, y30) = (x29 + l30 * sin(q30), y29 - l30 * cos(q30));
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
    kinetic = 1/2 * m21 * (dot(x21)^2 + dot(y21)^2);
    kinetic = 1/2 * m22 * (dot(x22)^2 + dot(y22)^2);
    kinetic = 1/2 * m23 * (dot(x23)^2 + dot(y23)^2);
    kinetic = 1/2 * m24 * (dot(x24)^2 + dot(y24)^2);
    kinetic = 1/2 * m25 * (dot(x25)^2 + dot(y25)^2);
    kinetic = 1/2 * m26 * (dot(x26)^2 + dot(y26)^2);
    kinetic = 1/2 * m27 * (dot(x27)^2 + dot(y27)^2);
    kinetic = 1/2 * m28 * (dot(x28)^2 + dot(y28)^2);
    kinetic = 1/2 * m29 * (dot(x29)^2 + dot(y29)^2);
    kinetic = 1/2 * m30 * (dot(x30)^2 + dot(y30)^2);
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
    potential = m21 * g * y21;
    potential = m22 * g * y22;
    potential = m23 * g * y23;
    potential = m24 * g * y24;
    potential = m25 * g * y25;
    potential = m26 * g * y26;
    potential = m27 * g * y27;
    potential = m28 * g * y28;
    potential = m29 * g * y29;
    potential = m30 * g * y30;
}

#[rustfmt::skip]
pub(crate) fn chain(m: &[f64; 30], l: &[f64; 30], g: f64) -> Absolute30 {
    let [m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, m21, m22, m23, m24, m25, m26, m27, m28, m29, m30] = *m;
    let [l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, l11, l12, l13, l14, l15, l16, l17, l18, l19, l20, l21, l22, l23, l24, l25, l26, l27, l28, l29, l30] = *l;
    Absolute30 { m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, m21, m22, m23, m24, m25, m26, m27, m28, m29, m30, l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, l11, l12, l13, l14, l15, l16, l17, l18, l19, l20, l21, l22, l23, l24, l25, l26, l27, l28, l29, l30, g }
}
