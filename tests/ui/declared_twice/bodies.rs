lagrange::system! {
    struct Scene;

    param m = 1.0, g = 9.81;
    coord x, y;
    gravity = (0, -g);
    body ball { mass: m; center: (x, y); }
    gravity = (0, g);
    body ball { mass: 2 * m; center: (y, x); }
    line x { through: (0, 0); }
    let ball_center = 3;
}

fn main() {}
