lagrange::system! {
    struct Scene;

    param m = 1.0, l = 2.0, c = 0.1;
    coord x, a, b;
    body massless { center: (x, 0); }
    body placeless { mass: m; angle: a; }
    body twofold { mass: m; center: (x, 1); origin: (x, 0); }
    body bare { mass: m; center: (x, 1); angle: b; }
    body chest { mass: m; center: (x, 0); compound { rectangle(l, l); } }
    spring { from: twofold; to: (0, 0); }
    damper { to: twofold; damping: c; }
}

fn main() {}
