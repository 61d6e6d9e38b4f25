//! The systems of this directory, compiled. Written by `declare.py`.

declare! { bead_on_rotating_hoop, energies: separate, mass_matrix: positions;
    param m = 0.4, a = 0.5, omega = 6.0, g = 9.81;
    coord theta;
    let x = a * sin(theta) * cos(omega * t);
    let y = a * sin(theta) * sin(omega * t);
    let z = -a * cos(theta);
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    potential = m * g * z;
}

declare! { cart_pole, energies: separate, mass_matrix: positions;
    param mc = 2.0, mp = 0.5, l = 0.6, j = 0.015, b = 0.2, c = 0.03, g = 9.81;
    input u = 1.7;
    coord x, theta;
    let px = x + l * sin(theta);
    let py = l * cos(theta);
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2) + 1/2 * j * dot(theta)^2;
    potential = mp * g * py;
    dissipation = 1/2 * b * dot(x)^2 + 1/2 * c * dot(theta)^2;
    force x = u;
}

declare! { cart_two_pendulums, energies: separate, mass_matrix: positions;
    param mc = 2.0, m1 = 0.5, m2 = 0.35, l1 = 0.6, l2 = 0.9, d = 0.4, b = 0.2, c1 = 0.03, c12 = 0.02, drag = 0.15;
    param shake = 1.5, w = 5.0, g = 9.81;
    input pull = 1.7, lift = 0.6, motor = -0.25;
    coord x, theta1, theta2;
    let (x1, y1) = (x - d + l1 / 2 * sin(theta1), -l1 / 2 * cos(theta1));
    let (x2, y2) = (x + d + l2 / 2 * sin(theta2), -l2 / 2 * cos(theta2));
    let (tip1x, tip1y) = (x - d + l1 * sin(theta1), -l1 * cos(theta1));
    let (tip2x, tip2y) = (x + d + l2 * sin(theta2), -l2 * cos(theta2));
    kinetic = 1/2 * mc * dot(x)^2;
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/24 * m1 * l1^2 * dot(theta1)^2;
    kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/24 * m2 * l2^2 * dot(theta2)^2;
    potential = m1 * g * y1 + m2 * g * y2;
    dissipation = 1/2 * b * dot(x)^2 + 1/2 * c1 * dot(theta1)^2 + 1/2 * c12 * (dot(theta2) - dot(theta1))^2;
    let speed = sqrt(dot(tip2x)^2 + dot(tip2y)^2);
    force (pull, lift) at (tip1x, tip1y);
    force (-drag * speed * dot(tip2x), -drag * speed * dot(tip2y)) at (tip2x, tip2y);
    torque motor on theta2 - theta1;
    force x = shake * cos(w * t);
}

declare! { chain10_absolute, energies: separate, mass_matrix: positions;
    param m1 = 0.93, l1 = 0.85, m2 = 0.86, l2 = 0.80, m3 = 0.79, l3 = 0.75, m4 = 0.72, l4 = 0.70, m5 = 0.65, l5 = 0.65, m6 = 0.58, l6 = 0.60, m7 = 0.51, l7 = 0.55, m8 = 0.44, l8 = 0.50, m9 = 0.37, l9 = 0.45, m10 = 0.30, l10 = 0.40, g = 9.81;
    coord q1, q2, q3, q4, q5, q6, q7, q8, q9, q10;
    let x1 = l1 * sin(q1);
    let y1 = -l1 * cos(q1);
    let x2 = x1 + l2 * sin(q2);
    let y2 = y1 - l2 * cos(q2);
    let x3 = x2 + l3 * sin(q3);
    let y3 = y2 - l3 * cos(q3);
    let x4 = x3 + l4 * sin(q4);
    let y4 = y3 - l4 * cos(q4);
    let x5 = x4 + l5 * sin(q5);
    let y5 = y4 - l5 * cos(q5);
    let x6 = x5 + l6 * sin(q6);
    let y6 = y5 - l6 * cos(q6);
    let x7 = x6 + l7 * sin(q7);
    let y7 = y6 - l7 * cos(q7);
    let x8 = x7 + l8 * sin(q8);
    let y8 = y7 - l8 * cos(q8);
    let x9 = x8 + l9 * sin(q9);
    let y9 = y8 - l9 * cos(q9);
    let x10 = x9 + l10 * sin(q10);
    let y10 = y9 - l10 * cos(q10);
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/2 * m3 * (dot(x3)^2 + dot(y3)^2) + 1/2 * m4 * (dot(x4)^2 + dot(y4)^2) + 1/2 * m5 * (dot(x5)^2 + dot(y5)^2) + 1/2 * m6 * (dot(x6)^2 + dot(y6)^2) + 1/2 * m7 * (dot(x7)^2 + dot(y7)^2) + 1/2 * m8 * (dot(x8)^2 + dot(y8)^2) + 1/2 * m9 * (dot(x9)^2 + dot(y9)^2) + 1/2 * m10 * (dot(x10)^2 + dot(y10)^2);
    potential = m1 * g * y1 + m2 * g * y2 + m3 * g * y3 + m4 * g * y4 + m5 * g * y5 + m6 * g * y6 + m7 * g * y7 + m8 * g * y8 + m9 * g * y9 + m10 * g * y10;
}

declare! { chain3_absolute, energies: separate, mass_matrix: positions;
    param m1 = 0.93, l1 = 0.85, m2 = 0.86, l2 = 0.80, m3 = 0.79, l3 = 0.75, g = 9.81;
    coord q1, q2, q3;
    let x1 = l1 * sin(q1);
    let y1 = -l1 * cos(q1);
    let x2 = x1 + l2 * sin(q2);
    let y2 = y1 - l2 * cos(q2);
    let x3 = x2 + l3 * sin(q3);
    let y3 = y2 - l3 * cos(q3);
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/2 * m3 * (dot(x3)^2 + dot(y3)^2);
    potential = m1 * g * y1 + m2 * g * y2 + m3 * g * y3;
}

declare! { chain4_relative, energies: separate, mass_matrix: positions;
    param m1 = 0.93, l1 = 0.85, m2 = 0.86, l2 = 0.80, m3 = 0.79, l3 = 0.75, m4 = 0.72, l4 = 0.70, g = 9.81;
    coord q1, q2, q3, q4;
    let a1 = q1;
    let x1 = l1 * sin(a1);
    let y1 = -l1 * cos(a1);
    let a2 = a1 + q2;
    let x2 = x1 + l2 * sin(a2);
    let y2 = y1 - l2 * cos(a2);
    let a3 = a2 + q3;
    let x3 = x2 + l3 * sin(a3);
    let y3 = y2 - l3 * cos(a3);
    let a4 = a3 + q4;
    let x4 = x3 + l4 * sin(a4);
    let y4 = y3 - l4 * cos(a4);
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/2 * m3 * (dot(x3)^2 + dot(y3)^2) + 1/2 * m4 * (dot(x4)^2 + dot(y4)^2);
    potential = m1 * g * y1 + m2 * g * y2 + m3 * g * y3 + m4 * g * y4;
}

declare! { chain5_absolute, energies: separate, mass_matrix: positions;
    param m1 = 0.93, l1 = 0.85, m2 = 0.86, l2 = 0.80, m3 = 0.79, l3 = 0.75, m4 = 0.72, l4 = 0.70, m5 = 0.65, l5 = 0.65, g = 9.81;
    coord q1, q2, q3, q4, q5;
    let x1 = l1 * sin(q1);
    let y1 = -l1 * cos(q1);
    let x2 = x1 + l2 * sin(q2);
    let y2 = y1 - l2 * cos(q2);
    let x3 = x2 + l3 * sin(q3);
    let y3 = y2 - l3 * cos(q3);
    let x4 = x3 + l4 * sin(q4);
    let y4 = y3 - l4 * cos(q4);
    let x5 = x4 + l5 * sin(q5);
    let y5 = y4 - l5 * cos(q5);
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/2 * m3 * (dot(x3)^2 + dot(y3)^2) + 1/2 * m4 * (dot(x4)^2 + dot(y4)^2) + 1/2 * m5 * (dot(x5)^2 + dot(y5)^2);
    potential = m1 * g * y1 + m2 * g * y2 + m3 * g * y3 + m4 * g * y4 + m5 * g * y5;
}

declare! { chain6_relative, energies: separate, mass_matrix: positions;
    param m1 = 0.93, l1 = 0.85, m2 = 0.86, l2 = 0.80, m3 = 0.79, l3 = 0.75, m4 = 0.72, l4 = 0.70, m5 = 0.65, l5 = 0.65, m6 = 0.58, l6 = 0.60, g = 9.81;
    coord q1, q2, q3, q4, q5, q6;
    let a1 = q1;
    let x1 = l1 * sin(a1);
    let y1 = -l1 * cos(a1);
    let a2 = a1 + q2;
    let x2 = x1 + l2 * sin(a2);
    let y2 = y1 - l2 * cos(a2);
    let a3 = a2 + q3;
    let x3 = x2 + l3 * sin(a3);
    let y3 = y2 - l3 * cos(a3);
    let a4 = a3 + q4;
    let x4 = x3 + l4 * sin(a4);
    let y4 = y3 - l4 * cos(a4);
    let a5 = a4 + q5;
    let x5 = x4 + l5 * sin(a5);
    let y5 = y4 - l5 * cos(a5);
    let a6 = a5 + q6;
    let x6 = x5 + l6 * sin(a6);
    let y6 = y5 - l6 * cos(a6);
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/2 * m3 * (dot(x3)^2 + dot(y3)^2) + 1/2 * m4 * (dot(x4)^2 + dot(y4)^2) + 1/2 * m5 * (dot(x5)^2 + dot(y5)^2) + 1/2 * m6 * (dot(x6)^2 + dot(y6)^2);
    potential = m1 * g * y1 + m2 * g * y2 + m3 * g * y3 + m4 * g * y4 + m5 * g * y5 + m6 * g * y6;
}

declare! { charged_particle, energies: joint, mass_matrix: positions;
    param m = 1.0, q = 0.7, b = 2.5, e = 0.3;
    coord x, y, z;
    lagrangian = 1/2 * m * (dot(x)^2 + dot(y)^2 + dot(z)^2) + q * b / 2 * (x * dot(y) - y * dot(x)) + q * e * x;
}

declare! { double_pendulum, energies: separate, mass_matrix: positions;
    param m1 = 1.0, m2 = 0.6, l1 = 1.0, l2 = 0.8, g = 9.81;
    coord theta1, theta2;
    let x1 = l1 * sin(theta1);
    let y1 = -l1 * cos(theta1);
    let x2 = x1 + l2 * sin(theta2);
    let y2 = y1 - l2 * cos(theta2);
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

declare! { elementary_functions, energies: separate, mass_matrix: positions;
    param a = 0.7, b = 1.4, k = 3.0, p = 1.7, r0 = 1.2, mu = 0.3;
    coord x, y, r;
    let mx = 1 + exp(-a * x) + tanh(y)^2;
    let my = hypot(x, b) + cosh(y / 2) + ln(1 + r^2);
    let mr = pow(r, p) + sqrt(1 + x^2) + atan(y) / 4;
    let mxy = sin(x) * cos(y) / 5;
    kinetic = 1/2 * mx * dot(x)^2 + 1/2 * my * dot(y)^2 + 1/2 * mr * dot(r)^2 + mxy * dot(x) * dot(y);
    let stop = if r < r0 { 1/2 * k * (r - r0)^2 } else { 1/3 * k * (r - r0)^3 };
    let groove = if x > 0 { x^2 } else if y >= 0 { x * y } else { 0 };
    potential = stop + groove + a * asin(x / 2) * acos(y / 2) + b * atan2(y, r) + sinh(x * y) / 3 + tan(y / 2);
    potential = abs(x * r) + min(x, y)^2 + max(x^3, y / 2) * r + (1 + x^2 + r^2)^(3/2) / 10 + 2^(x / 3) + pi * r^-2;
    force r = -mu * sign(dot(r)) * (2 + sin(x));
}

declare! { friction_patch, energies: separate, mass_matrix: positions;
    param m = 1.5, r = 0.25, mu = 0.6, l1 = 1.2, alpha = 0.5235987755982988, g = 9.81;
    coord s;
    let friction = if s < l1 { 0 } else if s < l1 + 2 * r { mu * m * g * (s - l1) / (2 * r) } else { mu * m * g };
    kinetic = 1/2 * m * dot(s)^2 + 1/2 * m * dot(s)^2 + 1/2 * (1/2 * m * r^2) * (dot(s) / r)^2;
    potential = -m * g * s * sin(alpha);
    force s = -friction * sign(dot(s));
}

declare! { furuta_pendulum, energies: separate, mass_matrix: positions;
    param ja = 0.02, jp = 0.004, mp = 0.15, la = 0.3, lp = 0.2, ba = 0.01, bp = 0.002, g = 9.81;
    input tau = 0.05;
    coord alpha, beta;
    let x = la * cos(alpha) - lp * sin(beta) * sin(alpha);
    let y = la * sin(alpha) + lp * sin(beta) * cos(alpha);
    let z = lp * cos(beta);
    kinetic = 1/2 * ja * dot(alpha)^2 + 1/2 * mp * (dot(x)^2 + dot(y)^2 + dot(z)^2) + 1/2 * jp * (dot(beta)^2 + sin(beta)^2 * dot(alpha)^2);
    potential = mp * g * z;
    dissipation = 1/2 * ba * dot(alpha)^2 + 1/2 * bp * dot(beta)^2;
    force alpha = tau;
}

declare! { heavy_top, energies: separate, mass_matrix: positions;
    param i1 = 0.12, i3 = 0.05, m = 1.1, h = 0.25, g = 9.81;
    coord phi, theta, psi;
    kinetic = 1/2 * i1 * (dot(theta)^2 + dot(phi)^2 * sin(theta)^2) + 1/2 * i3 * (dot(psi) + dot(phi) * cos(theta))^2;
    potential = m * g * h * cos(theta);
}

declare! { kepler_polar, energies: separate, mass_matrix: positions;
    param m = 1.0, mu = 1.0;
    coord r, phi;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(phi)^2);
    potential = -m * mu / r;
}

declare! { pendulum, energies: separate, mass_matrix: positions;
    param m = 1.3, l = 0.7, g = 9.81;
    coord theta;
    kinetic = 1/2 * m * l^2 * dot(theta)^2;
    potential = -m * g * l * cos(theta);
}

declare! { pleiades, energies: separate, mass_matrix: positions;
    coord x1, x2, x3, x4, x5, x6, x7, y1, y2, y3, y4, y5, y6, y7;
    kinetic = 1/2 * (dot(x1)^2 + dot(y1)^2) + 2/2 * (dot(x2)^2 + dot(y2)^2) + 3/2 * (dot(x3)^2 + dot(y3)^2) + 4/2 * (dot(x4)^2 + dot(y4)^2) + 5/2 * (dot(x5)^2 + dot(y5)^2) + 6/2 * (dot(x6)^2 + dot(y6)^2) + 7/2 * (dot(x7)^2 + dot(y7)^2);
    potential = -(2 / sqrt((x1 - x2)^2 + (y1 - y2)^2) + 3 / sqrt((x1 - x3)^2 + (y1 - y3)^2) + 4 / sqrt((x1 - x4)^2 + (y1 - y4)^2) + 5 / sqrt((x1 - x5)^2 + (y1 - y5)^2) + 6 / sqrt((x1 - x6)^2 + (y1 - y6)^2) + 7 / sqrt((x1 - x7)^2 + (y1 - y7)^2) + 6 / sqrt((x2 - x3)^2 + (y2 - y3)^2) + 8 / sqrt((x2 - x4)^2 + (y2 - y4)^2) + 10 / sqrt((x2 - x5)^2 + (y2 - y5)^2) + 12 / sqrt((x2 - x6)^2 + (y2 - y6)^2) + 14 / sqrt((x2 - x7)^2 + (y2 - y7)^2) + 12 / sqrt((x3 - x4)^2 + (y3 - y4)^2) + 15 / sqrt((x3 - x5)^2 + (y3 - y5)^2) + 18 / sqrt((x3 - x6)^2 + (y3 - y6)^2) + 21 / sqrt((x3 - x7)^2 + (y3 - y7)^2) + 20 / sqrt((x4 - x5)^2 + (y4 - y5)^2) + 24 / sqrt((x4 - x6)^2 + (y4 - y6)^2) + 28 / sqrt((x4 - x7)^2 + (y4 - y7)^2) + 30 / sqrt((x5 - x6)^2 + (y5 - y6)^2) + 35 / sqrt((x5 - x7)^2 + (y5 - y7)^2) + 42 / sqrt((x6 - x7)^2 + (y6 - y7)^2));
}

declare! { relativistic_charge, energies: joint, mass_matrix: state;
    param m = 1.3, c = 3.0, q = 0.7, b = 1.9, k = 4.0, a = 0.25, w = 2.5;
    coord x, y;
    let xs = a * cos(w * t);
    let ys = a * sin(w * t);
    lagrangian = -m * c^2 * sqrt(1 - (dot(x)^2 + dot(y)^2) / c^2);
    lagrangian = q * b / 2 * (x * dot(y) - y * dot(x));
    lagrangian = -1/2 * k * ((x - xs)^2 + (y - ys)^2);
}

declare! { shaken_top, energies: separate, mass_matrix: positions;
    param i1 = 0.06, i3 = 0.05, m = 1.1, h = 0.25, ax = 0.03, ay = 0.02, az = 0.015, w = 17.0, casing = 0.8, g = 9.81;
    coord phi, theta, psi;
    let px = ax * sin(w * t) + h * sin(theta) * sin(phi);
    let py = ay * cos(w * t) - h * sin(theta) * cos(phi);
    let pz = az * cos(2 * w * t) + h * cos(theta);
    let turning = casing * sin(3 * t);
    let precession = dot(phi) + turning;
    let spin = dot(psi) + precession * cos(theta);
    kinetic = 1/2 * m * (dot(px)^2 + dot(py)^2 + dot(pz)^2);
    kinetic = 1/2 * i1 * (dot(theta)^2 + precession^2 * sin(theta)^2) + 1/2 * i3 * spin^2;
    potential = m * g * pz;
}

declare! { spherical_spring_pendulum, energies: separate, mass_matrix: positions;
    param m = 0.9, k = 35.0, r0 = 1.0, g = 9.81;
    coord r, theta, phi;
    let x = r * sin(theta) * cos(phi);
    let y = r * sin(theta) * sin(phi);
    let z = -r * cos(theta);
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    potential = m * g * z + 1/2 * k * (r - r0)^2;
}

declare! { vibrating_pivot, energies: separate, mass_matrix: positions;
    param m = 1.0, l = 0.5, a = 0.02, w = 120.0, g = 9.81;
    coord theta;
    let x = l * sin(theta);
    let y = a * cos(w * t) - l * cos(theta);
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
}
