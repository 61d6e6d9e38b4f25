//! Systems with attributes that affect more than the struct.

lagrange::system! {
    /// Deprecated, and used by the items emitted beside it.
    #[deprecated(note = "there is a better one")]
    #[derive(Clone, Copy, Debug)]
    pub struct Old;

    param m = 1.0;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = pi * x;
    constraint line = y - x;
    event end = x - 1, rising => stop;
    emit { system_matrix }
}

lagrange::system! {
    /// Deprecated with its reduced type, in any number type.
    #[deprecated]
    #[derive(Clone, Copy, Debug)]
    pub struct OldWhole<S>;

    param m = 1.0;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = cos(x) + y^2;

    /// A deprecated part.
    reduce OldPart { freeze y = 0; }
}

lagrange::system! {
    /// Not compiled, although another type has its name.
    #[cfg(any())]
    #[derive(Clone, Copy, Debug)]
    pub struct Expected;

    param unused = 1.0;
    coord x = 1;
    kinetic = 1/2 * dot(x)^2;
    potential = pi * unknown;
    reduce Part { freeze x = 0; }
}

lagrange::system! {
    /// Unused parameters.
    #[cfg(all())]
    #[expect(unused_variables, reason = "warnings about the declaration are expected, too")]
    #[derive(Clone, Copy, Debug)]
    pub struct Expected;

    param unused = 1.0, spare = 2.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    /// A moment of inertia that differs from that of the shape, and an unused parameter.
    #[expect(deprecated, unused_variables, reason = "both are meant")]
    #[derive(Clone, Copy, Debug)]
    pub struct Doubtful;

    param unused = 1.0;
    coord x, a;
    body rod { mass: 1; inertia: 2; shape: slender_rod(1); center: (x, 0); angle: a; }
    body disk { mass: 1; inertia: 2; shape: disk(1); center: (2 * x, 0); angle: 2 * a; }
}

lagrange::system! {
    /// A lower-case name, which causes a single warning.
    #[expect(non_camel_case_types, reason = "the name is that of a formula")]
    #[derive(Clone, Copy, Debug)]
    pub struct cart_pole;

    param m = 1.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
}
