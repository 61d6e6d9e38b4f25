lagrange::system! {
    struct Scene;

    param m = 1.0, l = 2.0, k = 1.0;
    coord x, y, a;
    body rod { mass: m; origin: (x, y); angle: a; shape: slender_rod(l); }
    line floor { angle: a; through: x; }
    pin rod to x;
    slide y on floor;
    spring { from: rod; to: (x, y, 0); stiffness: k; }
}

fn main() {}
