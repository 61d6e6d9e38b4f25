//! What is there for messages about products that are not emitted gets in nobody's way.

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
    /// The stiffness, under a name that a product has.
    const STATEMENTS: usize = 2;

    fn energy(&self) -> f64 {
        self.m
    }
}

/// Names of products on everything.
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
