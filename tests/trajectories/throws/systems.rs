//! Thrown bodies: convex ones with 2 to 6 corners, each of them a contact with friction.

lagrange::system! {
    /// A board above a slope, with two feet.
    #[derive(Clone, Debug)]
    pub(super) struct Board;

    param m = 1, a = 0.6, b = 0.05, g = 9.81, e = 0.5, mu = 0.5, tilt = 0;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: -tilt; }
    body board { mass: m; center: (x, y); angle: phi; shape: rectangle(2 * a, 2 * b); }
    event left = floor.distance(board.point(-a, -b)), falling => impact(e);
    event right = floor.distance(board.point(a, -b)), falling => impact(e);
    friction rub_left = dot(floor.along(board.point(-a, -b))), mu * left;
    friction rub_right = dot(floor.along(board.point(a, -b))), mu * right;
}

lagrange::system! {
    /// A triangle above a slope.
    #[derive(Clone, Debug)]
    pub(super) struct Triangle;

    param m = 1, r = 0.5, g = 9.81, e = 0.5, mu = 0.5, tilt = 0;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: -tilt; }
    body die { mass: m; center: (x, y); angle: phi; shape: regular_polygon(3, r); }
    let (p1, p2, p3) = (r, r * cos(2 * pi / 3), r * cos(4 * pi / 3));
    let (h2, h3) = (r * sin(2 * pi / 3), r * sin(4 * pi / 3));
    event c1 = floor.distance(die.point(p1, 0)), falling => impact(e);
    event c2 = floor.distance(die.point(p2, h2)), falling => impact(e);
    event c3 = floor.distance(die.point(p3, h3)), falling => impact(e);
    friction f1 = dot(floor.along(die.point(p1, 0))), mu * c1;
    friction f2 = dot(floor.along(die.point(p2, h2))), mu * c2;
    friction f3 = dot(floor.along(die.point(p3, h3))), mu * c3;
}

lagrange::system! {
    /// A box above a slope.
    #[derive(Clone, Debug)]
    pub(super) struct Crate;

    param m = 1, a = 0.5, b = 0.3, g = 9.81, e = 0.5, mu = 0.5, tilt = 0;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: -tilt; }
    body die { mass: m; center: (x, y); angle: phi; shape: rectangle(2 * a, 2 * b); }
    event c1 = floor.distance(die.point(-a, -b)), falling => impact(e);
    event c2 = floor.distance(die.point(a, -b)), falling => impact(e);
    event c3 = floor.distance(die.point(a, b)), falling => impact(e);
    event c4 = floor.distance(die.point(-a, b)), falling => impact(e);
    friction f1 = dot(floor.along(die.point(-a, -b))), mu * c1;
    friction f2 = dot(floor.along(die.point(a, -b))), mu * c2;
    friction f3 = dot(floor.along(die.point(a, b))), mu * c3;
    friction f4 = dot(floor.along(die.point(-a, b))), mu * c4;
}

lagrange::system! {
    /// A pentagon above a slope.
    #[derive(Clone, Debug)]
    pub(super) struct Pentagon;

    param m = 1, r = 0.5, g = 9.81, e = 0.5, mu = 0.5, tilt = 0;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: -tilt; }
    body die { mass: m; center: (x, y); angle: phi; shape: regular_polygon(5, r); }
    let (c, d) = (2 * pi / 5, 4 * pi / 5);
    let (x2, y2) = (r * cos(c), r * sin(c));
    let (x3, y3) = (r * cos(d), r * sin(d));
    event c1 = floor.distance(die.point(r, 0)), falling => impact(e);
    event c2 = floor.distance(die.point(x2, y2)), falling => impact(e);
    event c3 = floor.distance(die.point(x3, y3)), falling => impact(e);
    event c4 = floor.distance(die.point(x3, -y3)), falling => impact(e);
    event c5 = floor.distance(die.point(x2, -y2)), falling => impact(e);
    friction f1 = dot(floor.along(die.point(r, 0))), mu * c1;
    friction f2 = dot(floor.along(die.point(x2, y2))), mu * c2;
    friction f3 = dot(floor.along(die.point(x3, y3))), mu * c3;
    friction f4 = dot(floor.along(die.point(x3, -y3))), mu * c4;
    friction f5 = dot(floor.along(die.point(x2, -y2))), mu * c5;
}

lagrange::system! {
    /// A hexagon above a slope.
    #[derive(Clone, Debug)]
    pub(super) struct Hexagon;

    param m = 1, r = 0.5, g = 9.81, e = 0.5, mu = 0.5, tilt = 0;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: -tilt; }
    body die { mass: m; center: (x, y); angle: phi; shape: regular_polygon(6, r); }
    let (c, s) = (r / 2, r * sin(pi / 3));
    event c1 = floor.distance(die.point(r, 0)), falling => impact(e);
    event c2 = floor.distance(die.point(c, s)), falling => impact(e);
    event c3 = floor.distance(die.point(-c, s)), falling => impact(e);
    event c4 = floor.distance(die.point(-r, 0)), falling => impact(e);
    event c5 = floor.distance(die.point(-c, -s)), falling => impact(e);
    event c6 = floor.distance(die.point(c, -s)), falling => impact(e);
    friction f1 = dot(floor.along(die.point(r, 0))), mu * c1;
    friction f2 = dot(floor.along(die.point(c, s))), mu * c2;
    friction f3 = dot(floor.along(die.point(-c, s))), mu * c3;
    friction f4 = dot(floor.along(die.point(-r, 0))), mu * c4;
    friction f5 = dot(floor.along(die.point(-c, -s))), mu * c5;
    friction f6 = dot(floor.along(die.point(c, -s))), mu * c6;
}

lagrange::system! {
    /// A box above a slope that ends at a wall.
    #[derive(Clone, Debug)]
    pub(super) struct Walled;

    param m = 1, a = 0.5, b = 0.3, g = 9.81, e = 0.5, mu = 0.5, tilt = 0, room = 1;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: -tilt; }
    line wall { through: (room, 0); angle: pi / 2; }
    body die { mass: m; center: (x, y); angle: phi; shape: rectangle(2 * a, 2 * b); }
    event c1 = floor.distance(die.point(-a, -b)), falling => impact(e);
    event c2 = floor.distance(die.point(a, -b)), falling => impact(e);
    event c3 = floor.distance(die.point(a, b)), falling => impact(e);
    event c4 = floor.distance(die.point(-a, b)), falling => impact(e);
    event w1 = wall.distance(die.point(-a, -b)), falling => impact(e);
    event w2 = wall.distance(die.point(a, -b)), falling => impact(e);
    event w3 = wall.distance(die.point(a, b)), falling => impact(e);
    event w4 = wall.distance(die.point(-a, b)), falling => impact(e);
    friction f1 = dot(floor.along(die.point(-a, -b))), mu * c1;
    friction f2 = dot(floor.along(die.point(a, -b))), mu * c2;
    friction f3 = dot(floor.along(die.point(a, b))), mu * c3;
    friction f4 = dot(floor.along(die.point(-a, b))), mu * c4;
    friction g1 = dot(wall.along(die.point(-a, -b))), mu * w1;
    friction g2 = dot(wall.along(die.point(a, -b))), mu * w2;
    friction g3 = dot(wall.along(die.point(a, b))), mu * w3;
    friction g4 = dot(wall.along(die.point(-a, b))), mu * w4;
}

lagrange::system! {
    /// A box above another one that stands on a floor by its two feet. The upper side of the lower
    /// one is unbounded.
    #[derive(Clone, Debug)]
    pub(super) struct Stack;

    param m = 1, a = 0.5, b = 0.3, base = 3, wide = 1, g = 9.81, e = 0.5, mu = 0.5, tilt = 0;
    coord x, y, phi, u, w, psi;
    gravity = (0, -g);
    line floor { angle: -tilt; }
    body lower { mass: base; center: (x, y); angle: phi; shape: rectangle(2 * wide, 2 * b); }
    body upper { mass: m; center: (u, w); angle: psi; shape: rectangle(2 * a, 2 * b); }
    line top { through: (0, b); on: lower; }
    event left = floor.distance(lower.point(-wide, -b)), falling => impact(e);
    event right = floor.distance(lower.point(wide, -b)), falling => impact(e);
    event c1 = top.distance(upper.point(-a, -b)), falling => impact(e);
    event c2 = top.distance(upper.point(a, -b)), falling => impact(e);
    event c3 = top.distance(upper.point(a, b)), falling => impact(e);
    event c4 = top.distance(upper.point(-a, b)), falling => impact(e);
    friction rub_left = dot(floor.along(lower.point(-wide, -b))), mu * left;
    friction rub_right = dot(floor.along(lower.point(wide, -b))), mu * right;
    friction f1 = dot(top.along(upper.point(-a, -b))), mu * c1;
    friction f2 = dot(top.along(upper.point(a, -b))), mu * c2;
    friction f3 = dot(top.along(upper.point(a, b))), mu * c3;
    friction f4 = dot(top.along(upper.point(-a, b))), mu * c4;
}
