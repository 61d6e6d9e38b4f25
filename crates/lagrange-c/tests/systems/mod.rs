//! Declarations for the C tests.

/// Systems with everything that a module may contain.
pub(crate) const SYSTEMS: [&str; 17] = [
    DOUBLE_PENDULUM,
    "struct Chain; param k[3] = [10.0, 20.0, 30.0]; input push = 1; coord x[3] = [0.1, 0.2, 0.3];
        kinetic = 1/2 * sum(i in 0..3, dot(x[i])^2);
        potential = 1/2 * sum(i in 0..3, k[i] * x[i]^2) + 1/2 * sum(i in 0..2, (x[i + 1] - x[i])^4);
        force x[0] = push + cos(3 * t) * tanh(x[1]) + exp(-x[2]^2) + dot(x[0])^77;",
    "struct Rod; param m = 1.0, g = 9.81; coord x, y;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2); potential = m * g * y;
        constraint length = x^2 + y^2 - 1; output tension = 2 * length;",
    "struct Skate; coord x, y, phi; kinetic = 1/2 * (dot(x)^2 + dot(y)^2) + 1/2 * dot(phi)^2;
        potential = 2 * y; constraint edge = dot(x) * sin(phi) - dot(y) * cos(phi);",
    "struct Bounce; param g: m/s^2 = 9.81, e = 0.8; coord h: m;
        kinetic = 1/2 * (1 [kg]) * dot(h)^2; potential = (1 [kg]) * g * h;
        event floor = h, falling => { dot(h) = -e * dot(h); }
        event top = dot(h), falling => record;
        event late = t - (3.2 [s]), rising => stop;",
    "struct Kinks; coord x; kinetic = 1/2 * dot(x)^2; potential = 3 * abs(x);
        force x = if t > 1.25 { 0.7 } else { -0.2 * max(dot(x), 0) };",
    "struct Landing; param k = 50, mu = 0.4; coord x, y, phi; gravity = (0, -9.81);
        body disk { mass: 2; center: (x, y); angle: phi; shape: disk(0.3); }
        contact touch = disk on ground { friction: mu; stiffness: k; dissipation: 0.7; stiction: 0.01; }
        output load = touch.normal; output push = touch.force;",
    "struct Top; param m = 0.5, l = 0.1, i1 = 2e-3, i3 = 1e-3, g = 9.81; gravity = (0, 0, -g);
        body rotor { mass: m; centroid: (0, 0, l); inertia: (i1, i1, i3); }
        ball tip = ground to rotor; output height = rotor.center.z; output center = rotor.center;",
    "struct Motor; param j = 0.01, r = 0.5, l = 0.02, k = 0.05; input voltage = 6.0;
        coord phi; state current; kinetic = 1/2 * j * dot(phi)^2; force phi = k * current;
        dot(current) = (voltage - r * current - k * dot(phi)) / l; output moment = k * current;",
    "struct Lorenz; param s = 10, r = 28; state x, y, z;
        dot(x) = s * (y - x); dot(y) = x * (r - z) - y; dot(z) = x * y - 8/3 * z;",
    "struct Wind;
        table gust(time) = [(0, 0), (1, 2), (1.5, -1), (3, 0.5)], interpolation: monotone, outside: clamp;
        table even(x) = [(-1, 0), (0, 2), (1, -1)], interpolation: linear, outside: extend;
        table curved(x) = [(-1, 0), (0.25, 2), (1, -1)], interpolation: natural, outside: extend;
        coord x; kinetic = 1/2 * dot(x)^2; potential = 2 * x^2 + curved(x); force x = gust(t) + even(dot(x));",
    "struct Map; table lift(a, b) = [(0, 0, 1), (0, 1, 2), (0, 3, 0), (1, 0, 4), (1, 1, 3), (1, 3, 1)],
        interpolation: natural, outside: extend;
        table drag(a, b) = [[0, 1, 1], [1, 3, 4]], rows: [-1, 1], columns: [-1, 0, 1.5],
        interpolation: monotone, outside: clamp;
        coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2); potential = lift(x, y); force x = -drag(x, dot(x));",
    "struct Solid; table lift(a, b, c) = [(0, 0, 0, 1), (0, 1, 0, 2), (1, 0, 0, 4), (1, 1, 0, 3),
        (0, 0, 2, 0), (0, 1, 2, 1), (1, 0, 2, -2), (1, 1, 2, 5)], interpolation: natural, outside: extend;
        table push(a, b, c) = [(0, 0, 0, 1), (0, 1, 0, 2), (1, 0, 0, 4), (1, 1, 0, 3),
        (0, 0, 2, 0), (0, 1, 2, 1), (1, 0, 2, -2), (1, 1, 2, 5)], interpolation: linear, outside: clamp;
        coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2); potential = lift(x, y, t);
        force x = push(y, dot(x), dot(y));",
    "struct Implicit; coord x; solve y: 0 = y^3 + y - x, start: x;
        kinetic = 1/2 * dot(x)^2; potential = 2 * y^2; output root = y;",
    "struct FourBar; param d = 3.5; coord phi;
        solve (coupler, rocker): 0 = cos(phi) + 4 * cos(coupler) - d - 3 * cos(rocker),
            0 = sin(phi) + 4 * sin(coupler) - 3 * sin(rocker), start: (0.7, 1.5);
        kinetic = 1/2 * dot(phi)^2 + 1/2 * dot(rocker)^2; potential = (rocker - 1)^2; force phi = 1;
        output angles = (coupler, rocker, dot(coupler));",
    "struct Room; param low = 19.8, high = 20.2, period = 0.1; coord x = 0; state temperature = 20;
        discrete count = 0, held = 0, mass = 1; mode heater = off | on;
        kinetic = 1/2 * mass * dot(x)^2; force x = held;
        dot(temperature) = 0.1 * (5 - temperature) + if heater == on { 3 } else { 0 };
        event cold = temperature - low, falling => { heater = on; count = count + 1; }
        event warm = temperature - high, rising => { heater = off; mass = 1.5 * mass; }
        every period => { held = temperature - 20 - x - dot(x); }
        every 3 * period => { held = held + 0.01; }",
    "struct Saddle; coord x, y;
        lagrangian = dot(x) * dot(y) * (2 + sin(x)) + 1/2 * x * dot(x)^2 - x * y^2;
        force x = 0.1 * t; dissipation = dot(y)^2; emit { power, lagrangian_hessian }",
];

const DOUBLE_PENDULUM: &str = "struct DoublePendulum;
    param m1: kg = 1.0, m2: kg = 1.0, l1: m = 1.0, l2: m = 1.0, g: m/s^2 = 9.81;
    coord theta1: rad, theta2: rad;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;";
