//! Hints for products that are not emitted interfere with nothing.

use lagrange::system::OdeSystem;

lagrange::system! {
    struct Bead;
    param m = 2;
    coord x;
    body bead { mass: m; center: (x, 0); }
    potential = x^2;
    emit { no energy, no momenta }
}

impl Bead {
    /// The stiffness, under the name of a product.
    const STATEMENTS: usize = 2;

    fn energy(&self) -> f64 {
        self.m
    }
}

/// Methods with the names of products, on every type.
trait Own {
    fn bias(&self) -> usize {
        7
    }

    fn momenta(self) -> usize
    where
        Self: Sized,
    {
        8
    }
}

impl<T> Own for T {}

#[test]
fn methods_of_ones_own_are_found_first() {
    let mut bead = Bead::default();
    assert_eq!((bead.energy(), bead.bias(), Bead::STATEMENTS), (2.0, 7, 2));
    assert!(bead.jacobian(0.0, &[0.0; 2]).is_none(), "that of the trait in scope");
    let borrowed = &mut bead;
    assert_eq!(borrowed.energy(), 2.0);
    assert_eq!(bead.momenta(), 8);
    assert_eq!("bias of anything".bias(), 7);
}

lagrange::system! {
    /// A system whose mass has no default, with a handwritten default.
    struct Weight<S>;
    param m;
    coord y;
    kinetic = kinetic_energy(m, dot(y));
    potential = 9.81 * m * y;
}

impl Default for Weight<f64> {
    fn default() -> Self {
        Weight { m: 3.0 }
    }
}

fn default_of<T: Default>() -> T {
    T::default()
}

#[test]
fn defaults_of_ones_own_are_found() {
    let inferred = Weight::default();
    assert_eq!((inferred.m, default_of::<Weight<f64>>().m), (3.0, 3.0));
    let filled = Weight { ..Weight::default() };
    let others = (Vec::<u8>::default(), String::default(), <[i32; 2]>::default(), Option::<u8>::default());
    assert_eq!((filled.m, others), (3.0, (vec![], String::new(), [0, 0], None)));
}
