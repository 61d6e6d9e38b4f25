lagrange::system! {
    struct Scene;

    param m = 1.0, r = 0.5, h = 0.2;
    coord x, y, a;
    body hoop { mass: m; center: (x, 0); shape: thin_rng(r); }
    body brick { mass: m; center: (y, 0); shape: rectangle(r); }
    body jar { origin: (0, r); angle: a; compound { teapot(r), mass: m; hole disk(r, h), mass: m; } }
}

fn main() {}
