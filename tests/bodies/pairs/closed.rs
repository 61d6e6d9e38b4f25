//! Pairs with constraints that close loops: each body has coordinates of its own.

use super::pair;

pair! { four_bar,
    bodies {
        param m1 = 0.5, m2 = 1.4, m3 = 0.9, a = 0.4, b = 1.1, c = 0.8, d = 1.0, g = 9.81;
        coord x1, y1, p1, x2, y2, p2, x3, y3, p3;
        input drive = 0.7;
        gravity = (0, -g);
        body crank { shape: slender_rod(a); mass: m1; center: (x1, y1); angle: p1; }
        body coupler { shape: slender_rod(b); mass: m2; center: (x2, y2); angle: p2; }
        body rocker { shape: slender_rod(c); mass: m3; center: (x3, y3); angle: p3; }
        pin crank.point(-a/2, 0) to (0, 0);
        pin crank.point(a/2, 0) to coupler.point(-b/2, 0);
        pin coupler.point(b/2, 0) to rocker.point(c/2, 0);
        pin rocker.point(-c/2, 0) to (d, 0);
        torque drive on crank;
    }
    by_hand {
        param m1 = 0.5, m2 = 1.4, m3 = 0.9, a = 0.4, b = 1.1, c = 0.8, d = 1.0, g = 9.81;
        coord x1, y1, p1, x2, y2, p2, x3, y3, p3;
        input drive = 0.7;
        kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/24 * m1 * a^2 * dot(p1)^2;
        kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/24 * m2 * b^2 * dot(p2)^2;
        kinetic = 1/2 * m3 * (dot(x3)^2 + dot(y3)^2) + 1/24 * m3 * c^2 * dot(p3)^2;
        potential = m1 * g * y1 + m2 * g * y2 + m3 * g * y3;
        constraint c1 = x1 - a/2 * cos(p1);
        constraint c2 = y1 - a/2 * sin(p1);
        constraint c3 = x1 + a/2 * cos(p1) - x2 + b/2 * cos(p2);
        constraint c4 = y1 + a/2 * sin(p1) - y2 + b/2 * sin(p2);
        constraint c5 = x2 + b/2 * cos(p2) - x3 - c/2 * cos(p3);
        constraint c6 = y2 + b/2 * sin(p2) - y3 - c/2 * sin(p3);
        constraint c7 = x3 - c/2 * cos(p3) - d;
        constraint c8 = y3 - c/2 * sin(p3);
        force p1 = drive;
    }
}

pair! { leaning_ladder,
    bodies {
        param m = 10.0, l = 3.0, g = 9.81;
        coord x, y, theta;
        gravity = (0, -g);
        line floor {}
        line wall { angle: -pi/2; }
        body ladder { shape: slender_rod(l); mass: m; center: (x, y); angle: -theta; }
        slide ladder.point(l/2, 0) on floor;
        slide ladder.point(-l/2, 0) on wall;
    }
    by_hand {
        param m = 10.0, l = 3.0, g = 9.81;
        coord x, y, theta;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/24 * m * l^2 * dot(theta)^2;
        potential = m * g * y;
        constraint floor = y - l/2 * sin(theta);
        constraint wall = x - l/2 * cos(theta);
    }
}

pair! { slider_crank,
    bodies {
        param r = 0.05, l = 0.15, m1 = 0.5, m2 = 0.8, m3 = 0.6, k = 500.0;
        coord a, b, x;
        input motor = 0.3;
        line guide {}
        body crank { shape: rod(r); mass: m1; center: r/2 * (cos(a), sin(a)); angle: a; }
        body conrod {
            shape: rod(l);
            mass: m2;
            center: (r * cos(a) + l/2 * cos(b), r * sin(a) + l/2 * sin(b));
            angle: b;
        }
        body slider { mass: m3; center: (x, 0); shape: rectangle(0.04, 0.03); }
        pin crank.point(-r/2, 0) to (0, 0);
        pin crank.point(r/2, 0) to conrod.point(-l/2, 0);
        pin slider to conrod.point(l/2, 0);
        slide slider on guide;
        spring { from: (0.3, 0); to: slider; stiffness: k; }
        torque motor on crank;
    }
    by_hand {
        param r = 0.05, l = 0.15, m1 = 0.5, m2 = 0.8, m3 = 0.6, k = 500.0;
        coord a, b, x;
        input motor = 0.3;
        let (xs, ys) = (r * cos(a) + l/2 * cos(b), r * sin(a) + l/2 * sin(b));
        let (x1, y1) = (r/2 * cos(a), r/2 * sin(a));
        kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/24 * m1 * r^2 * dot(a)^2;
        kinetic = 1/2 * m2 * (dot(xs)^2 + dot(ys)^2) + 1/24 * m2 * l^2 * dot(b)^2;
        kinetic = 1/2 * m3 * dot(x)^2;
        potential = 1/2 * k * (x - 0.3)^2;
        constraint pin_x = x - r * cos(a) - l * cos(b);
        constraint pin_y = -r * sin(a) - l * sin(b);
        force a = motor;
    }
}

pair! { eccentric_wheel,
    bodies {
        param m = 3.0, r = 0.5, e = 0.15, j = 0.3, alpha = 0.1, g = 9.81;
        coord x, y, phi;
        gravity = (0, -g);
        line slope { angle: alpha; }
        body wheel { mass: m; inertia: j; origin: (x, y); centroid: (e, 0); angle: phi; }
        roll contact = wheel on slope, radius: r;
    }
    by_hand {
        param m = 3.0, r = 0.5, e = 0.15, j = 0.3, alpha = 0.1, g = 9.81;
        coord x, y, phi;
        let (cx, cy) = (x + e * cos(phi), y + e * sin(phi));
        kinetic = 1/2 * m * (dot(cx)^2 + dot(cy)^2) + 1/2 * j * dot(phi)^2;
        potential = m * g * cy;
        constraint normal = cos(alpha) * y - sin(alpha) * x - r;
        constraint rolling = cos(alpha) * dot(x) + sin(alpha) * dot(y) + r * dot(phi);
    }
}

pair! { block_with_dry_friction,
    bodies {
        param m = 1.2, a = 0.2, mu = 0.3, alpha = 0.5, g = 9.81;
        coord x, y;
        gravity = (0, -g);
        line slope { angle: -alpha; }
        body block { mass: m; shape: rectangle(a, a); center: (x, y); angle: -alpha; }
        slide foot = block.point(0, -a/2) on slope;
        friction rub = dot(slope.along(block)), mu * foot.normal;
    }
    by_hand {
        param m = 1.2, a = 0.2, mu = 0.3, alpha = 0.5, g = 9.81;
        coord x, y;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
        potential = m * g * y;
        constraint foot = sin(alpha) * x + cos(alpha) * y - a/2;
        friction rub = cos(alpha) * dot(x) - sin(alpha) * dot(y), mu * foot;
    }
}
