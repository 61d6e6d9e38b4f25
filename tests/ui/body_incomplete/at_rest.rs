lagrange::system! {
    struct Scene;

    param m = 1.0, l = 2.0;
    coord x, a;
    body cart { mass: m; center: (x, 0); }
    body pillar { mass: m; center: (l, 0); }
    body flat { mass: m; center: x; }
    body deep { mass: m; origin: (x, 0, 1); angle: a; shape: disk(l); }
}

fn main() {}
