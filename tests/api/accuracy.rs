//! Levels of accuracy, in every number type.

macro_rules! levels {
    ($($(#[$attribute:ident($value:ident)])* $name:ident $(<$scalar:ident>)?;)*) => {
        $(
            lagrange::system! {
                $(#[$attribute($value)])*
                #[derive(Clone, Copy, Debug)]
                struct $name $(<$scalar>)?;

                param length = 0.7, pull = 9.81;
                coord a, b, c;
                let (xa, ya) = (length * sin(a), -length * cos(a));
                let (xb, yb) = (xa + length * sin(b), ya - length * cos(b));
                kinetic = 1/2 * (dot(xa)^2 + dot(ya)^2 + dot(xb)^2 + dot(yb)^2 + dot(c)^2);
                potential = pull * (ya + yb) + sin(c + cos(a));
                output height = yb;
            }
        )*
    };
}

levels! {
    Standard;
    #[accuracy(standard)] AlsoStandard;
    #[accuracy(fast)] Fast;
    #[accuracy(fast)] FastAny<S>;
    #[accuracy(fast)] #[scalar(f32)] FastSingle;
}

const Q: [f64; 3] = [0.4, -2.3, 40.0];
const V: [f64; 3] = [1.5, 0.3, -0.2];

#[test]
fn fast_is_standard_up_to_rounding() {
    let standard = Standard::default();
    let fast = Fast::default();
    let accelerations = [standard.acceleration(0.0, &Q, &V), fast.acceleration(0.0, &Q, &V)];
    for (standard, fast) in accelerations[0].into_iter().zip(accelerations[1]) {
        crate::assert_close(fast, standard);
    }
    crate::assert_close(fast.energy(0.0, &Q, &V), standard.energy(0.0, &Q, &V));
    crate::assert_close(fast.height(0.0, &Q, &V), standard.height(0.0, &Q, &V));
}

#[test]
fn standard_is_what_is_not_said_otherwise() {
    let unsaid = Standard::default().acceleration(0.0, &Q, &V);
    assert_eq!(AlsoStandard::default().acceleration(0.0, &Q, &V), unsaid);
}

#[test]
fn fast_is_there_for_every_number_type() {
    let double = Fast::default().acceleration(0.0, &Q, &V);
    let any = FastAny::<f64>::default();
    assert_eq!(any.acceleration(0.0, &Q, &V), double);
    let single = FastSingle::default();
    let single = single.acceleration(0.0, &Q.map(|q| q as f32), &V.map(|v| v as f32));
    for (single, double) in single.into_iter().zip(double) {
        assert!(
            (f64::from(single) - double).abs() < 1e-5 * double.abs().max(1.0),
            "{single} is not {double}"
        );
    }
}

#[test]
fn nan_angles_give_nan_accelerations() {
    let fast = Fast::default();
    for angle in [f64::NAN, f64::INFINITY] {
        assert!(fast.acceleration(0.0, &[angle, 0.1, 0.2], &V)[0].is_nan());
    }
    let far = fast.acceleration(0.0, &[1e7, 0.1, 0.2], &V)[0];
    crate::assert_close(far, Standard::default().acceleration(0.0, &[1e7, 0.1, 0.2], &V)[0]);
}
