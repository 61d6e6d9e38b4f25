//! Declarations, each as a compiled type and as text.

#[macro_use]
mod both_ways;

both_ways! {
    DoublePendulum = DOUBLE_PENDULUM {
        param m1: kg = 1.0, m2: kg = 1.0, l1: m = 1.0, l2: m = 1.0, g: m/s^2 = 9.81;
        coord theta1: rad, theta2: rad;
        let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
        let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
        kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
        potential = m1 * g * y1 + m2 * g * y2;
    }

    FourMasses = FOUR_MASSES {
        param k[4] = [10.0, 20.0, 30.0, 40.0], u = 0.3;
        input push;
        coord x[4];
        kinetic = 1/2 * sum(i in 0..4, dot(x[i])^2);
        potential = 1/2 * sum(i in 0..4, k[i] * x[i]^2) + 1/2 * sum(i in 0..3, (x[i + 1] - x[i])^4);
        force x[0] = push + u * cos(3 * t);
    }

    FiveMasses = FIVE_MASSES {
        emit { jacobian }
        coord x[5];
        kinetic = 1/2 * sum(i in 0..5, dot(x[i])^2);
        potential = sum(i in 0..5, cos(x[i])) + 1/2 * sum(i in 0..4, (x[i + 1] - x[i])^4);
    }

    Shaken = SHAKEN {
        param size = 1.5, period = 0.17;
        coord x = 0, theta;
        state current;
        discrete held = 0;
        noise push, density: size^2;
        noise voltage[2], density: [0.1, 0.2];
        let (px, py) = (x + sin(theta), -cos(theta));
        kinetic = 1/2 * dot(x)^2 + 1/2 * (dot(px)^2 + dot(py)^2);
        potential = 5 * py + x^2;
        force x = push + held;
        force theta = current;
        dot(current) = voltage[0] - 2 * voltage[1] * cos(theta) - current;
        event far = x - 0.1, rising => record;
        every period => { held = -dot(x); }
    }

    Room = ROOM {
        param low = 19.8, high = 20.2, period = 0.1;
        coord x = 0;
        state temperature = 20;
        discrete count = 0, held = 0, mass = 1;
        mode heater = off | on;
        kinetic = 1/2 * mass * dot(x)^2;
        force x = held;
        dot(temperature) = 0.1 * (5 - temperature) + if heater == on { 3 } else { 0 };
        event cold = temperature - low, falling => { heater = on; count = count + 1; }
        event warm = temperature - high, rising => { heater = off; mass = 1.5 * mass; }
        every period => { held = temperature - 20 - x - dot(x); }
        every 3 * period => { held = held + 0.01; }
    }

    Mirror = MIRROR {
        emit { jacobian }
        coord tilt in -2e-6..=2e-6 nominal 1e-6;
        state heat > 0 nominal 300;
        kinetic = 1/2 * dot(tilt)^2;
        potential = 1/2 * tilt^2;
        dot(heat) = 290 - heat;
    }

    Late = LATE {
        param m: kg = 1, l: m = 1, g: m/s^2 = 9.81, p: N*m = 30, d: N*m*s = 6, lag: s = 0.05;
        coord theta: rad = 0.3;
        state mean = 0.1;
        let seen = delay(theta, lag);
        kinetic = 1/2 * m * (l * dot(theta))^2;
        potential = m * g * l * cos(theta);
        force theta = -p * seen - d * delay(dot(theta), lag);
        dot(mean) = (delay(seen, 2 * lag) - mean) / (1 [s]);
        event low = seen - 0.1, falling => { dot(theta) = dot(theta) + 0.5 [1/s]; }
        output behind: rad = theta - seen;
    }

    Rising = RISING {
        param lag: s = 0.3, w: rad/s = 2;
        coord x: m = 1;
        state y = 0;
        history x = 1 [m] + sin(w * t) * (1 [m]), y = t / (1 [s]);
        let seen = delay(x + (1 [m]) * y, lag);
        kinetic = 1/2 * (1 [kg]) * dot(x)^2;
        force x = -(4 [N/m]) * seen - (1 [N*s/m]) * delay(dot(x), 2 * lag);
        dot(y) = (delay(seen, lag) / (1 [m]) - y) / (1 [s]);
        output behind: m = x - seen;
    }

    Landing = LANDING {
        param m: kg = 2, k: N/m = 5000, d: s/m = 0.3, mu = 0.4, v: m/s = 0.01, g: m/s^2 = 9.81;
        coord x: m, y: m, phi: rad;
        gravity = (0, -g);
        body case { mass: m; center: (x, y); angle: phi; shape: rectangle(0.4 [m], 200 [mm]); }
        contact foot = case.corners on ground { friction: mu; stiffness: k; dissipation: d; stiction: v; }
        output load = foot[0].normal + foot[1].normal;
        output push = foot[0].force;
    }

    Rod = ROD {
        param m = 1.0, g = 9.81;
        coord x, y;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
        potential = m * g * y;
        constraint length = x^2 + y^2 - 1;
        output tension = 2 * length;
    }

    StabilisedRod = STABILISED_ROD {
        param m = 1.0, g = 9.81;
        coord x, y;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
        potential = m * g * y;
        constraint length = hypot(x, y) - 1;
        stabilise = 5;
    }

    Skate = SKATE {
        coord x, y, phi;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2) + 1/2 * dot(phi)^2;
        potential = 2 * y;
        constraint edge = dot(x) * sin(phi) - dot(y) * cos(phi);
    }

    Bounce = BOUNCE {
        param g: m/s^2 = 9.81, e = 0.8;
        coord h: m;
        kinetic = 1/2 * (1 [kg]) * dot(h)^2;
        potential = (1 [kg]) * g * h;
        event floor = h, falling => { dot(h) = -e * dot(h); }
        event top = dot(h), falling => record;
        event slow = dot(h) - (2.0 [m/s]) + (1.5 [m/s^2]) * t, falling => record;
        event late = t - (3.2 [s]), rising => stop;
    }

    Cords = CORDS {
        coord x;
        kinetic = 1/2 * dot(x)^2;
        potential = sum(i in 0..300, abs(x - i / 100)) / 100;
    }

    Kinks = KINKS {
        coord x;
        kinetic = 1/2 * dot(x)^2;
        potential = 3 * abs(x);
        force x = if t > 1.25 { 0.7 } else { -0.2 * max(dot(x), 0) };
    }

    Slide = SLIDE {
        coord x;
        kinetic = 1/2 * dot(x)^2;
        force x = -sign(dot(x));
    }

    Top = TOP {
        param m = 0.5, l = 0.1, i1 = 2e-3, i3 = 1e-3, g = 9.81;
        gravity = (0, 0, -g);
        body rotor { mass: m; centroid: (0, 0, l); inertia: (i1, i1, i3); }
        ball tip = ground to rotor;
        output height = rotor.center.z;
    }

    Motor = MOTOR {
        param j = 0.01, r = 0.5, l = 0.02, k = 0.05;
        input voltage = 6.0;
        coord phi;
        state current;
        kinetic = 1/2 * j * dot(phi)^2;
        force phi = k * current;
        dot(current) = (voltage - r * current - k * dot(phi)) / l;
        output moment = k * current;
    }

    Wind = WIND {
        table gust(time) = [(0, 0), (1, 2), (1.5, -1), (3, 0.5)], interpolation: monotone, outside: clamp;
        coord x;
        kinetic = 1/2 * dot(x)^2;
        potential = 2 * x^2;
        force x = gust(t);
    }

    Implicit = IMPLICIT {
        coord x;
        solve y: 0 = y^3 + y - x, start: x;
        kinetic = 1/2 * dot(x)^2;
        potential = 2 * y^2;
    }

    Indefinite = INDEFINITE {
        coord x, y;
        lagrangian = dot(x) * dot(y) * (2 + sin(x)) + 1/2 * x * dot(x)^2 - x * y^2;
    }

    Root = ROOT {
        coord x;
        kinetic = 1/2 * dot(x)^2;
        force x = sqrt(x);
    }

    Ranged = RANGED {
        param m: kg in 0.5..=4;
        coord x: m;
        kinetic = 1/2 * m * dot(x)^2;
    }
}
