lagrange::system! {
    struct Crane;

    param m = 1.0, l = 2.0, k = 3.0, g = 9.81;
    coord x, a;
    gravity = (0, -g);
    body trolley {
        mas: m;
        center: (x, 0)
        colour: red;
    }
    body load {
        mass: 2 * m;
        mass: m;
        centre: (x + l * sin(a), -l * cos(a));
        shape: disk;
    }
    spring rope { from: trolley; to: load; stiffness = k; damping: 1; }
    line rail { angle: 0; };
    slide trolley at rail;
    roll trolley.center on rail;
    pin trolley;
    body mass: m;
}

lagrange::system! {
    struct Wheel;

    param m = 1.0, r = 0.5;
    coord phi;
    body wheel {
        origin: (r * phi, r);
        angle: phi;
        compound {
            disk(r) mass: m;
            hole disk(r / 2), mass: m / 4, ad: (0, 0);
            3 * disk(r);
        }
    }
    output height = wheel.center.y;
}

fn main() {}
