//! The description that an emitted type gives to integrators and tables of states.

use lagrange::system::{Columns, MechanicalSystem, SeparableSystem};

lagrange::system! {
    struct Planet<S>;

    param mu = 1.0;
    coord r, phi;
    kinetic = 1/2 * (dot(r)^2 + r^2 * dot(phi)^2);
    potential = -mu / r;
}

/// Two states of a planet, in columns.
struct Table([[f32; 2]; 4]);

impl Columns for Table {
    type Scalar = f32;

    fn column(&self, index: usize) -> &[f32] {
        &self.0[index]
    }
}

#[test]
fn columns_have_the_names_of_the_state() {
    let table = Table([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]]);
    let columns = <Planet<f32> as MechanicalSystem>::Columns::from(table);
    let found = [columns.r(), columns.phi(), columns.r_dot(), columns.phi_dot()];
    let table: &Table = columns.as_ref();
    assert_eq!(found, table.0);
}

lagrange::system! {
    struct Oscillators;

    param k = 1.0;
    input push = 0.0;
    coord x, y;
    kinetic = 1/2 * (2 * dot(x)^2 + dot(x) * dot(y) + dot(y)^2);
    potential = k * (x - y)^2 + y^4 * cos(t);
    force x = push;
}

#[test]
fn explicit_symplectic_methods_take_constant_mass_and_forces_without_velocities() {
    fn takes<T: SeparableSystem>(_: &T) {}
    takes(&Oscillators::default());
}
