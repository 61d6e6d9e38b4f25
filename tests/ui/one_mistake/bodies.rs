lagrange::system! {
    struct EqualsSigns;
    param m = 1.0;
    coord x, y;
    body ball { mass = m; center = (x, y); }
}

lagrange::system! {
    struct Commas;
    param m = 1.0;
    coord x, y;
    body ball { mass: m, center: (x, y) }
}

lagrange::system! {
    struct Synonym;
    param m = 1.0;
    coord x, y;
    body ball { mass: m; position: (x, y); }
}

lagrange::system! {
    struct UsedTwice;
    param m = 1.0;
    coord x, y;
    force (1, 0) at ball;
    output place = ball.center;
    body ball { mass: m; center: (x, y); }
}

fn main() {}
