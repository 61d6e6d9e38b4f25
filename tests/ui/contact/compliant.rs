//! Compliant contacts have a stiffness, and no labels of rigid ones.

lagrange::system! {
    struct Forms;
    coord x, y;
    gravity = (0, -9.81);
    body ball { mass: 1; center: (x, y); }
    contact a = ball on ground { stiffness: 1e4; restitution: 0.5; }
    contact b = ball on ground { stiffness: 1e4; kinetic: 0.2; static: 0.3; stiction: 0.01; }
    contact c = ball on ground { stiffness: 1e4; friction: 0.2; }
    contact d = ball on ground { friction: 0.2; stiction: 0.01; }
    contact e = ball on ground { dissipation: 0.5; }
    contact f = ball on ground { stiffness: 1e4; stiction: 0.01; }
    contact g = ball on ground { stiffness: 1e4; damping: 0.5; }
}

lagrange::system! {
    struct Values;
    coord x, y;
    gravity = (0, -9.81);
    body ball { mass: 1; center: (x, y); }
    body still { mass: 1; center: (x, 2); }
    contact a = ball on ground { stiffness: -1e4; }
    contact b = ball on ground { stiffness: 1e4; dissipation: -0.5; }
    contact c = ball on ground { stiffness: 1e4; friction: -0.1; stiction: 0; }
    contact d = ball on ground { stiffness: 1e4 * (1 + x); }
}

lagrange::system! {
    struct Still;
    coord x;
    body still { mass: 1; center: (x, 2); }
    contact touch = still on ground { stiffness: 1e4; }
}

lagrange::system! {
    struct Units;
    param c: N*s/m = 50;
    coord x: m, y: m;
    gravity = (0, -9.81 [m/s^2]);
    body ball { mass: 1 [kg]; center: (x, y); }
    contact touch = ball on ground { stiffness: 1e4 [N/m]; dissipation: c; }
}

lagrange::system! {
    struct Rigid;
    coord x, y;
    gravity = (0, -9.81);
    body ball { mass: 1; center: (x, y); }
    contact touch = ball on ground;
    emit { taylor }
}

fn main() {}
