//! Andrews' squeezing mechanism.

lagrange::system! {
    /// Seven bodies, which six joints close to three loops; a motor drives the first, a spring
    /// holds the third.
    ///
    /// Declaration and data are those of Hairer, Wanner, *Solving Ordinary Differential Equations
    /// II*, 2nd ed., §VII.7.
    #[derive(Clone, Debug)]
    pub(crate) struct Squeezer;

    param m1: kg = 0.04325, m2: kg = 0.00365, m3: kg = 0.02373, m4: kg = 0.00706, m5: kg = 0.07050, m6: kg = 0.00706;
    param m7: kg = 0.05498;
    param i1: kg*m^2 = 2.194e-6, i2: kg*m^2 = 4.410e-7, i3: kg*m^2 = 5.255e-6, i4: kg*m^2 = 5.667e-7;
    param i5: kg*m^2 = 1.169e-5, i6: kg*m^2 = 5.667e-7, i7: kg*m^2 = 1.912e-5;
    param xa: m = -0.06934, ya: m = -0.00227, xb: m = -0.03635, yb: m = 0.03273, xc: m = 0.014, yc: m = 0.072;
    param c0: N/m = 4530.0, l0: m = 0.07785;
    param d: m = 0.028, da: m = 0.0115, e: m = 0.02, ea: m = 0.01421, rr: m = 0.007, ra: m = 0.00092;
    param ss: m = 0.035, sa: m = 0.01874, sb: m = 0.01043, sc: m = 0.018, sd: m = 0.02;
    param ta: m = 0.02308, tb: m = 0.00916, u: m = 0.04, ua: m = 0.01228, ub: m = 0.00449, zf: m = 0.02, zt: m = 0.04;
    param fa: m = 0.01421;
    input drive: N*m = 0.033;
    coord beta: rad, theta: rad, gamma: rad, phi: rad, delta: rad, omega: rad, eps: rad;

    // Joints: P connects the first three loops, D the spring.
    let (xp, yp) = (rr * cos(beta) - d * cos(beta + theta), rr * sin(beta) - d * sin(beta + theta));
    let (xd, yd) = (xb + sc * sin(gamma) + sd * cos(gamma), yb - sc * cos(gamma) + sd * sin(gamma));

    // Centres of mass.
    let (x1, y1) = (ra * cos(beta), ra * sin(beta));
    let (x2, y2) = (rr * cos(beta) - da * cos(beta + theta), rr * sin(beta) - da * sin(beta + theta));
    let (x3, y3) = (xb + sa * sin(gamma) + sb * cos(gamma), yb - sa * cos(gamma) + sb * sin(gamma));
    let (x4, y4) = (xa + zt * cos(delta) + (e - ea) * sin(phi + delta), ya + zt * sin(delta) - (e - ea) * cos(phi + delta));
    let (x5, y5) = (xa + ta * cos(delta) - tb * sin(delta), ya + ta * sin(delta) + tb * cos(delta));
    let (x6, y6) = (xa + u * sin(eps) + (zf - fa) * cos(omega + eps), ya - u * cos(eps) + (zf - fa) * sin(omega + eps));
    let (x7, y7) = (xa + ua * sin(eps) - ub * cos(eps), ya - ua * cos(eps) - ub * sin(eps));

    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * i1 * dot(beta)^2;
    kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/2 * i2 * (dot(beta) + dot(theta))^2;
    kinetic = 1/2 * m3 * (dot(x3)^2 + dot(y3)^2) + 1/2 * i3 * dot(gamma)^2;
    kinetic = 1/2 * m4 * (dot(x4)^2 + dot(y4)^2) + 1/2 * i4 * (dot(phi) + dot(delta))^2;
    kinetic = 1/2 * m5 * (dot(x5)^2 + dot(y5)^2) + 1/2 * i5 * dot(delta)^2;
    kinetic = 1/2 * m6 * (dot(x6)^2 + dot(y6)^2) + 1/2 * i6 * (dot(omega) + dot(eps))^2;
    kinetic = 1/2 * m7 * (dot(x7)^2 + dot(y7)^2) + 1/2 * i7 * dot(eps)^2;
    potential = 1/2 * c0 * (hypot(xd - xc, yd - yc) - l0)^2;
    force beta = drive;

    constraint g1 = xp - xb - ss * sin(gamma);
    constraint g2 = yp - yb + ss * cos(gamma);
    constraint g3 = xp - xa - e * sin(phi + delta) - zt * cos(delta);
    constraint g4 = yp - ya + e * cos(phi + delta) - zt * sin(delta);
    constraint g5 = xp - xa - zf * cos(omega + eps) - u * sin(eps);
    constraint g6 = yp - ya - zf * sin(omega + eps) + u * cos(eps);
}

/// A position at rest in which all loops are closed.
pub(crate) const START: [f64; 14] = [
    -0.061_713_890_014_276_45,
    0.0,
    0.455_279_819_163_070_4,
    0.222_668_390_165_885_9,
    0.487_364_979_543_842_55,
    -0.222_668_390_165_885_9,
    1.230_547_444_549_821_2,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
];
