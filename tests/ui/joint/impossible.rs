lagrange::system! {
    struct Scene;

    param m = 1.0, l = 2.0;
    coord x, y, a;
    body rod { mass: m; origin: (x, y); angle: a; shape: slender_rod(l); }
    line floor { through: (0, 0); }
    line edge { on: rod; }
    pin rod.point(l/2, 0) to rod.point(-l/2, 0);
    pin rod to rod;
    slide rod.point(l, 0) on edge;
    roll rod on floor;
}

fn main() {}
