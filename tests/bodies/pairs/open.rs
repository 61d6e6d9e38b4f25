//! Pairs without closed loops: every coordinate is free, except for a contact.

use super::pair;

pair! { cart_pole,
    bodies {
        param mc = 1.3, mp = 0.2, l = 0.7, c = 0.05, g = 9.81;
        coord x, theta;
        input u = 2.5;
        gravity = (0, -g);
        line rail {}
        body cart { mass: mc; center: (x, 0); }
        body pole {
            shape: slender_rod(l);
            mass: mp;
            center: (x + l/2 * sin(theta), -l/2 * cos(theta));
            angle: theta - pi/2;
        }
        slide cart on rail;
        pin pole.point(-l/2, 0) to cart;
        torsion_damper { from: ground; to: pole; damping: c; }
        force (u, 0) at cart;
    }
    by_hand {
        param mc = 1.3, mp = 0.2, l = 0.7, c = 0.05, g = 9.81;
        coord x, theta;
        input u = 2.5;
        let (px, py) = (x + l/2 * sin(theta), -l/2 * cos(theta));
        kinetic = 1/2 * mc * dot(x)^2;
        kinetic = 1/2 * mp * (dot(px)^2 + dot(py)^2) + 1/24 * mp * l^2 * dot(theta)^2;
        potential = mp * g * py;
        dissipation = 1/2 * c * dot(theta)^2;
        force x = u;
    }
}

pair! { rolling_cylinder,
    bodies {
        param m = 2.0, r = 0.3, alpha = 30 * pi / 180, g = 9.81;
        coord x, y, phi;
        gravity = (0, -g);
        line slope { angle: -alpha; }
        body cylinder { mass: m; shape: solid_cylinder(r); center: (x, y); angle: phi; }
        roll contact = cylinder on slope;
    }
    by_hand {
        param m = 2.0, r = 0.3, alpha = 30 * pi / 180, g = 9.81;
        coord x, y, phi;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/4 * m * r^2 * dot(phi)^2;
        potential = m * g * y;
        constraint normal = sin(alpha) * x + cos(alpha) * y - r;
        constraint rolling = cos(alpha) * dot(x) - sin(alpha) * dot(y) + r * dot(phi);
    }
}

pair! { step_ladder,
    bodies {
        param m = 6.0, man = 80.0, l = 2.5, h = 0.9, g = 9.81;
        coord phi;
        gravity = (0, -g);
        line floor {}
        body left { shape: slender_rod(l); mass: m; center: (l/2 * cos(phi), l/2 * sin(phi)); angle: phi; }
        body right { shape: slender_rod(l); mass: m; center: (3/2 * l * cos(phi), l/2 * sin(phi)); angle: -phi; }
        body person { mass: man; center: left.point(l/2, 0) + (0, h); }
        pin left.point(-l/2, 0) to (0, 0);
        pin left.point(l/2, 0) to right.point(-l/2, 0);
        slide right.point(l/2, 0) on floor;
    }
    by_hand {
        param m = 6.0, man = 80.0, l = 2.5, h = 0.9, g = 9.81;
        coord phi;
        let (x1, y1) = (l/2 * cos(phi), l/2 * sin(phi));
        let (x2, y2) = (3/2 * l * cos(phi), l/2 * sin(phi));
        let (x3, y3) = (l * cos(phi), l * sin(phi) + h);
        kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/24 * m * l^2 * dot(phi)^2;
        kinetic = 1/2 * m * (dot(x2)^2 + dot(y2)^2) + 1/24 * m * l^2 * dot(phi)^2;
        kinetic = 1/2 * man * (dot(x3)^2 + dot(y3)^2);
        potential = m * g * (y1 + y2) + man * g * y3;
    }
}

pair! { arm_on_turning_base,
    bodies {
        param m1 = 3.0, m2 = 0.8, r = 0.4, l = 0.6, b = 0.05, c = 0.1;
        coord base, arm;
        input motor = 1.5;
        body disk { shape: disk(r); mass: m1; center: (0, 0); angle: base; }
        body beam {
            origin: disk.point(r, 0);
            angle: disk.angle + arm;
            compound { rectangle(l, b), mass: m2, at: (l/2, 0); }
        }
        torque motor on disk;
        torsion_damper joint { from: disk; to: beam; damping: c; }
    }
    by_hand {
        param m1 = 3.0, m2 = 0.8, r = 0.4, l = 0.6, b = 0.05, c = 0.1;
        coord base, arm;
        input motor = 1.5;
        let (x, y) = (r * cos(base) + l/2 * cos(base + arm), r * sin(base) + l/2 * sin(base + arm));
        kinetic = 1/4 * m1 * r^2 * dot(base)^2;
        kinetic = 1/2 * m2 * (dot(x)^2 + dot(y)^2) + 1/24 * m2 * (l^2 + b^2) * (dot(base) + dot(arm))^2;
        force base = motor;
        dissipation = 1/2 * c * dot(arm)^2;
    }
}

pair! { plates_with_springs_and_dampers,
    bodies {
        param m = 1.2, a = 0.3, b = 0.8, k = 40.0, l0 = 0.2, c = 0.7, kt = 3.0, ct = 0.04, g = 9.81;
        coord p, q;
        gravity = (0, -g);
        body upper { shape: rectangle(a, b); mass: m; origin: b/2 * (sin(p), -cos(p)); angle: p; }
        body lower {
            shape: rectangle(a, b);
            mass: m;
            center: upper.point(0, -b/2) + b/2 * (sin(q), -cos(q));
            angle: q;
        }
        torsion_spring { from: upper; to: lower; stiffness: kt; }
        torsion_damper { from: upper; to: lower; damping: ct; }
        spring { from: (1, -1); to: lower.point(a/2, 0); stiffness: k; rest: l0; }
        damper { from: (1, -1); to: lower.point(a/2, 0); damping: c; }
    }
    by_hand {
        param m = 1.2, a = 0.3, b = 0.8, k = 40.0, l0 = 0.2, c = 0.7, kt = 3.0, ct = 0.04, g = 9.81;
        coord p, q;
        let (x1, y1) = (b/2 * sin(p), -b/2 * cos(p));
        let (x2, y2) = (b * sin(p) + b/2 * sin(q), -b * cos(p) - b/2 * cos(q));
        kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/24 * m * (a^2 + b^2) * dot(p)^2;
        kinetic = 1/2 * m * (dot(x2)^2 + dot(y2)^2) + 1/24 * m * (a^2 + b^2) * dot(q)^2;
        potential = m * g * (y1 + y2) + 1/2 * kt * (q - p)^2;
        let d = sqrt((x2 + a/2 * cos(q) - 1)^2 + (y2 + a/2 * sin(q) + 1)^2);
        potential = 1/2 * k * (d - l0)^2;
        dissipation = 1/2 * ct * (dot(q) - dot(p))^2 + 1/2 * c * dot(d)^2;
    }
}

pair! { compound_wheel_on_a_torsion_spring,
    bodies {
        param m = 2.0, lost = 0.1, r = 0.4, s = 0.06, d = 0.25, k = 6.0, g = 9.81;
        coord phi;
        gravity = (0, -g);
        body wheel {
            origin: (0, 0);
            angle: phi;
            compound {
                disk(r), mass: m;
                hole disk(s), mass: lost, at: (d, 0);
                hole disk(s), mass: lost, at: (0, d);
            }
        }
        pin wheel.point(0, 0) to (0, 0);
        torsion_spring { from: ground; to: wheel; stiffness: k; rest: 1/2; }
    }
    by_hand {
        param m = 2.0, lost = 0.1, r = 0.4, s = 0.06, d = 0.25, k = 6.0, g = 9.81;
        coord phi;
        let total = m - 2 * lost;
        let e = -lost * d / total;
        let (x, y) = (e * cos(phi) - e * sin(phi), e * sin(phi) + e * cos(phi));
        let j = 1/2 * m * r^2 + m * (e^2 + e^2) - 2 * lost * (1/2 * s^2 + (d - e)^2 + e^2);
        kinetic = 1/2 * total * (dot(x)^2 + dot(y)^2) + 1/2 * j * dot(phi)^2;
        potential = total * g * y + 1/2 * k * (phi - 1/2)^2;
    }
}

pair! { rocking_half_disk,
    bodies {
        param m = 1.5, r = 0.4, g = 9.81;
        coord phi;
        gravity = (0, -g);
        line floor {}
        body half { shape: semicircular_disk(r); mass: m; origin: (-r * phi, r); angle: phi + pi; }
        roll half on floor, radius: r;
    }
    by_hand {
        param m = 1.5, r = 0.4, g = 9.81;
        coord phi;
        let s = 4 * r / (3 * pi);
        let (x, y) = (-r * phi + s * sin(phi), r - s * cos(phi));
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/2 * (1/2 - 16 / (9 * pi^2)) * m * r^2 * dot(phi)^2;
        potential = m * g * y;
    }
}

pair! { body_and_point_mass_on_a_spring,
    bodies {
        param m1 = 2.0, m2 = 0.5, a = 0.4, b = 0.2, k = 30.0, l0 = 0.3, g = 9.81;
        coord x, y, phi, u, w;
        gravity = (0, -g);
        body block { mass: m1; shape: rectangle(a, b); center: (x, y); angle: phi; }
        kinetic = 1/2 * m2 * (dot(u)^2 + dot(w)^2);
        potential = m2 * g * w;
        spring link { from: block.point(a/2, b/2); to: (u, w); stiffness: k; rest: l0; }
        spring { from: (0, 1); to: block; stiffness: 2 * k; }
    }
    by_hand {
        param m1 = 2.0, m2 = 0.5, a = 0.4, b = 0.2, k = 30.0, l0 = 0.3, g = 9.81;
        coord x, y, phi, u, w;
        kinetic = 1/2 * m1 * (dot(x)^2 + dot(y)^2) + 1/24 * m1 * (a^2 + b^2) * dot(phi)^2;
        kinetic = 1/2 * m2 * (dot(u)^2 + dot(w)^2);
        potential = m1 * g * y + m2 * g * w;
        let px = x + a/2 * cos(phi) - b/2 * sin(phi);
        let py = y + a/2 * sin(phi) + b/2 * cos(phi);
        potential = 1/2 * k * (sqrt((u - px)^2 + (w - py)^2) - l0)^2 + k * (x^2 + (y - 1)^2);
    }
}

pair! { rod_on_a_shaken_pivot,
    bodies {
        param m = 1.2, l = 0.4, h = 0.1, w = 5, g = 9.81;
        coord theta;
        gravity = (0, -g);
        let pivot = (0, h * cos(w * t));
        body rod { mass: m; shape: slender_rod(l); center: pivot + l/2 * (sin(theta), -cos(theta)); angle: theta - pi/2; }
        pin rod.point(-l/2, 0) to pivot;
    }
    by_hand {
        param m = 1.2, l = 0.4, h = 0.1, w = 5, g = 9.81;
        coord theta;
        let (x, y) = (l/2 * sin(theta), h * cos(w * t) - l/2 * cos(theta));
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/24 * m * l^2 * dot(theta)^2;
        potential = m * g * y;
    }
}
