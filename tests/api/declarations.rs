//! Places for declarations, and the parts of their heads that are kept.

mod inner {
    lagrange::system! {
        pub(super) struct Sibling;

        param m = 2.0;
        coord x;
        kinetic = kinetic_energy(m, dot(x));
    }

    lagrange::system! {
        /// Documented.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(all(), derive(PartialOrd))]
        #[cfg_attr(any(), derive(DoesNotExist))]
        #[must_use]
        pub(crate) struct Spring;

        param k = 3.0,;
        coord x,;
        kinetic = 1/2 * dot(x)^2;
        potential = spring_energy(k, x);
    }
}

#[test]
fn two_systems_stand_in_one_module_with_their_own_visibility() {
    let (sibling, spring) = (inner::Sibling { m: 4.0 }, inner::Spring::default());
    assert_eq!(sibling.momenta(0.0, &[0.0], &[2.0]), [8.0]);
    assert_eq!(spring.acceleration(0.0, &[2.0], &[0.0]), [-6.0]);
}

#[test]
fn attributes_are_kept() {
    let spring = inner::Spring::default();
    let stiffer = inner::Spring { k: 4.0 };
    let copy = spring;
    assert!(spring < stiffer && spring == copy);
    assert_eq!(format!("{stiffer:?}"), "Spring { k: 4.0 }");
}

#[test]
fn a_system_stands_in_a_function() {
    lagrange::system! {
        struct Falling;

        const g = 9.81;
        coord z;
        kinetic = 1/2 * dot(z)^2;
        potential = g * z;
    }
    assert_eq!(Falling.acceleration(0.0, &[0.0], &[0.0]), [-9.81]);
}

#[test]
fn a_macro_passes_on_attributes_names_and_expressions() {
    macro_rules! oscillator {
        ($(#[$attribute:meta])* $visibility:vis $name:ident, $text:literal, $stiffness:expr) => {
            lagrange::system! {
                $(#[$attribute])*
                #[doc = $text]
                $visibility struct $name;

                coord x;
                kinetic = 1/2 * dot(x)^2;
                potential = 1/2 * $stiffness * x^2;
            }
        };
    }
    oscillator!(pub Soft, "A soft spring.", 1 / 2);
    oscillator!(
        /// A spring.
        #[derive(PartialEq, Debug)]
        Hard,
        "A hard one.",
        2 + 3
    );
    oscillator!(
        #[cfg(any())]
        Hard,
        "Another one.",
        7
    );
    assert_eq!(Hard, Hard);
    assert_eq!(Soft.acceleration(0.0, &[1.0], &[0.0]), [-0.5]);
    assert_eq!(Hard.acceleration(0.0, &[1.0], &[0.0]), [-5.0]);
}
