//! Pairs in which a moving body carries the line on which another one slides or rolls.

use super::pair;

pair! { block_on_a_wedge,
    bodies {
        param m1 = 5.0, m2 = 1.0, a = 0.2, k = 40.0, alpha = 0.4, g = 9.81;
        coord s, x, y;
        gravity = (0, -g);
        body wedge { mass: m1; center: (s, 0); }
        line incline { on: wedge; angle: -alpha; }
        body block { mass: m2; shape: rectangle(a, a); center: (x, y); angle: -alpha; }
        slide block.point(0, -a/2) on incline;
        spring { from: (-1, 0); to: wedge; stiffness: k; rest: 1; }
    }
    by_hand {
        param m1 = 5.0, m2 = 1.0, a = 0.2, k = 40.0, alpha = 0.4, g = 9.81;
        coord s, x, y;
        kinetic = 1/2 * m1 * dot(s)^2 + 1/2 * m2 * (dot(x)^2 + dot(y)^2);
        potential = m2 * g * y + 1/2 * k * (abs(s + 1) - 1)^2;
        constraint pressure = sin(alpha) * (x - s - a/2 * sin(alpha)) + cos(alpha) * (y - a/2 * cos(alpha));
    }
}

pair! { cylinder_on_a_cart,
    bodies {
        param m1 = 5.0, m2 = 1.0, r = 0.3, h = 0.2, g = 9.81;
        coord s, x, y, phi;
        input push = 2.0;
        gravity = (0, -g);
        body cart { mass: m1; center: (s, 0); }
        line deck { on: cart; through: (0, h); }
        body cylinder { mass: m2; shape: disk(r); center: (x, y); angle: phi; }
        roll cylinder on deck;
        force (push, 0) at cart;
    }
    by_hand {
        param m1 = 5.0, m2 = 1.0, r = 0.3, h = 0.2, g = 9.81;
        coord s, x, y, phi;
        input push = 2.0;
        kinetic = 1/2 * m1 * dot(s)^2 + 1/2 * m2 * (dot(x)^2 + dot(y)^2) + 1/4 * m2 * r^2 * dot(phi)^2;
        potential = m2 * g * y;
        constraint pressure = y - h - r;
        constraint rolling = dot(x) - dot(s) + r * dot(phi);
        force s = push;
    }
}

pair! { wheel_on_a_beam,
    bodies {
        param m1 = 5.0, m2 = 1.0, l = 2.0, r = 0.1, g = 9.81;
        coord beta, x, y, phi;
        input motor = 1.0;
        gravity = (0, -g);
        body beam { mass: m1; shape: slender_rod(l); center: (0, 0); angle: beta; }
        line top { on: beam; }
        body wheel { mass: m2; shape: thin_ring(r); center: (x, y); angle: phi; }
        roll wheel on top;
        torque motor on beam;
    }
    by_hand {
        param m1 = 5.0, m2 = 1.0, l = 2.0, r = 0.1, g = 9.81;
        coord beta, x, y, phi;
        input motor = 1.0;
        kinetic = 1/24 * m1 * l^2 * dot(beta)^2;
        kinetic = 1/2 * m2 * (dot(x)^2 + dot(y)^2) + 1/2 * m2 * r^2 * dot(phi)^2;
        potential = m2 * g * y;
        let gap = y * cos(beta) - x * sin(beta) - r;
        constraint pressure = gap;
        constraint rolling = dot(x) * cos(beta) + dot(y) * sin(beta) + r * dot(phi) + gap * dot(beta);
        force beta = motor;
    }
}
