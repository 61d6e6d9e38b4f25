//! A rope with so many points that its matrices are written without zeros.

use lagrange::constraint::{ConstrainedSystem, weighed};

lagrange::system! {
    /// Point masses that hang from each other on massless rods.
    #[derive(Clone, Debug)]
    struct Rope;

    param m = 2, l = 1/4, g = 9.81;
    coord x1, y1; kinetic = kinetic_energy(m, dot((x1, y1))); potential = m * g * y1;
    coord x2, y2; kinetic = kinetic_energy(m, dot((x2, y2))); potential = m * g * y2;
    coord x3, y3; kinetic = kinetic_energy(m, dot((x3, y3))); potential = m * g * y3;
    coord x4, y4; kinetic = kinetic_energy(m, dot((x4, y4))); potential = m * g * y4;
    coord x5, y5; kinetic = kinetic_energy(m, dot((x5, y5))); potential = m * g * y5;
    coord x6, y6; kinetic = kinetic_energy(m, dot((x6, y6))); potential = m * g * y6;
    coord x7, y7; kinetic = kinetic_energy(m, dot((x7, y7))); potential = m * g * y7;
    coord x8, y8; kinetic = kinetic_energy(m, dot((x8, y8))); potential = m * g * y8;
    coord x9, y9; kinetic = kinetic_energy(m, dot((x9, y9))); potential = m * g * y9;
    coord x10, y10; kinetic = kinetic_energy(m, dot((x10, y10))); potential = m * g * y10;
    coord x11, y11; kinetic = kinetic_energy(m, dot((x11, y11))); potential = m * g * y11;
    coord x12, y12; kinetic = kinetic_energy(m, dot((x12, y12))); potential = m * g * y12;
    coord x13, y13; kinetic = kinetic_energy(m, dot((x13, y13))); potential = m * g * y13;
    coord x14, y14; kinetic = kinetic_energy(m, dot((x14, y14))); potential = m * g * y14;
    coord x15, y15; kinetic = kinetic_energy(m, dot((x15, y15))); potential = m * g * y15;
    coord x16, y16; kinetic = kinetic_energy(m, dot((x16, y16))); potential = m * g * y16;
    coord x17, y17; kinetic = kinetic_energy(m, dot((x17, y17))); potential = m * g * y17;
    coord x18, y18; kinetic = kinetic_energy(m, dot((x18, y18))); potential = m * g * y18;
    coord x19, y19; kinetic = kinetic_energy(m, dot((x19, y19))); potential = m * g * y19;
    coord x20, y20; kinetic = kinetic_energy(m, dot((x20, y20))); potential = m * g * y20;
    coord x21, y21; kinetic = kinetic_energy(m, dot((x21, y21))); potential = m * g * y21;
    coord x22, y22; kinetic = kinetic_energy(m, dot((x22, y22))); potential = m * g * y22;
    coord x23, y23; kinetic = kinetic_energy(m, dot((x23, y23))); potential = m * g * y23;
    coord x24, y24; kinetic = kinetic_energy(m, dot((x24, y24))); potential = m * g * y24;
    coord x25, y25; kinetic = kinetic_energy(m, dot((x25, y25))); potential = m * g * y25;
    coord x26, y26; kinetic = kinetic_energy(m, dot((x26, y26))); potential = m * g * y26;
    coord x27, y27; kinetic = kinetic_energy(m, dot((x27, y27))); potential = m * g * y27;
    coord x28, y28; kinetic = kinetic_energy(m, dot((x28, y28))); potential = m * g * y28;
    coord x29, y29; kinetic = kinetic_energy(m, dot((x29, y29))); potential = m * g * y29;
    coord x30, y30; kinetic = kinetic_energy(m, dot((x30, y30))); potential = m * g * y30;
    coord x31, y31; kinetic = kinetic_energy(m, dot((x31, y31))); potential = m * g * y31;
    coord x32, y32; kinetic = kinetic_energy(m, dot((x32, y32))); potential = m * g * y32;
    coord x33, y33; kinetic = kinetic_energy(m, dot((x33, y33))); potential = m * g * y33;
    coord x34, y34; kinetic = kinetic_energy(m, dot((x34, y34))); potential = m * g * y34;
    coord x35, y35; kinetic = kinetic_energy(m, dot((x35, y35))); potential = m * g * y35;
    coord x36, y36; kinetic = kinetic_energy(m, dot((x36, y36))); potential = m * g * y36;
    coord x37, y37; kinetic = kinetic_energy(m, dot((x37, y37))); potential = m * g * y37;
    coord x38, y38; kinetic = kinetic_energy(m, dot((x38, y38))); potential = m * g * y38;
    coord x39, y39; kinetic = kinetic_energy(m, dot((x39, y39))); potential = m * g * y39;
    coord x40, y40; kinetic = kinetic_energy(m, dot((x40, y40))); potential = m * g * y40;
    coord x41, y41; kinetic = kinetic_energy(m, dot((x41, y41))); potential = m * g * y41;
    coord x42, y42; kinetic = kinetic_energy(m, dot((x42, y42))); potential = m * g * y42;
    coord x43, y43; kinetic = kinetic_energy(m, dot((x43, y43))); potential = m * g * y43;
    coord x44, y44; kinetic = kinetic_energy(m, dot((x44, y44))); potential = m * g * y44;
    coord x45, y45; kinetic = kinetic_energy(m, dot((x45, y45))); potential = m * g * y45;
    coord x46, y46; kinetic = kinetic_energy(m, dot((x46, y46))); potential = m * g * y46;
    coord x47, y47; kinetic = kinetic_energy(m, dot((x47, y47))); potential = m * g * y47;
    coord x48, y48; kinetic = kinetic_energy(m, dot((x48, y48))); potential = m * g * y48;
    coord x49, y49; kinetic = kinetic_energy(m, dot((x49, y49))); potential = m * g * y49;
    coord x50, y50; kinetic = kinetic_energy(m, dot((x50, y50))); potential = m * g * y50;
    coord x51, y51; kinetic = kinetic_energy(m, dot((x51, y51))); potential = m * g * y51;
    coord x52, y52; kinetic = kinetic_energy(m, dot((x52, y52))); potential = m * g * y52;
    coord x53, y53; kinetic = kinetic_energy(m, dot((x53, y53))); potential = m * g * y53;
    coord x54, y54; kinetic = kinetic_energy(m, dot((x54, y54))); potential = m * g * y54;
    coord x55, y55; kinetic = kinetic_energy(m, dot((x55, y55))); potential = m * g * y55;
    coord x56, y56; kinetic = kinetic_energy(m, dot((x56, y56))); potential = m * g * y56;
    coord x57, y57; kinetic = kinetic_energy(m, dot((x57, y57))); potential = m * g * y57;
    coord x58, y58; kinetic = kinetic_energy(m, dot((x58, y58))); potential = m * g * y58;
    coord x59, y59; kinetic = kinetic_energy(m, dot((x59, y59))); potential = m * g * y59;
    coord x60, y60; kinetic = kinetic_energy(m, dot((x60, y60))); potential = m * g * y60;
    coord x61, y61; kinetic = kinetic_energy(m, dot((x61, y61))); potential = m * g * y61;
    coord x62, y62; kinetic = kinetic_energy(m, dot((x62, y62))); potential = m * g * y62;
    coord x63, y63; kinetic = kinetic_energy(m, dot((x63, y63))); potential = m * g * y63;
    coord x64, y64; kinetic = kinetic_energy(m, dot((x64, y64))); potential = m * g * y64;
    coord x65, y65; kinetic = kinetic_energy(m, dot((x65, y65))); potential = m * g * y65;
    coord x66, y66; kinetic = kinetic_energy(m, dot((x66, y66))); potential = m * g * y66;
    coord x67, y67; kinetic = kinetic_energy(m, dot((x67, y67))); potential = m * g * y67;
    coord x68, y68; kinetic = kinetic_energy(m, dot((x68, y68))); potential = m * g * y68;
    coord x69, y69; kinetic = kinetic_energy(m, dot((x69, y69))); potential = m * g * y69;
    coord x70, y70; kinetic = kinetic_energy(m, dot((x70, y70))); potential = m * g * y70;
    coord x71, y71; kinetic = kinetic_energy(m, dot((x71, y71))); potential = m * g * y71;
    coord x72, y72; kinetic = kinetic_energy(m, dot((x72, y72))); potential = m * g * y72;
    constraint rod1 = norm((x1, y1)) - l;
    constraint rod2 = norm((x2 - x1, y2 - y1)) - l;
    constraint rod3 = norm((x3 - x2, y3 - y2)) - l;
    constraint rod4 = norm((x4 - x3, y4 - y3)) - l;
    constraint rod5 = norm((x5 - x4, y5 - y4)) - l;
    constraint rod6 = norm((x6 - x5, y6 - y5)) - l;
    constraint rod7 = norm((x7 - x6, y7 - y6)) - l;
    constraint rod8 = norm((x8 - x7, y8 - y7)) - l;
    constraint rod9 = norm((x9 - x8, y9 - y8)) - l;
    constraint rod10 = norm((x10 - x9, y10 - y9)) - l;
    constraint rod11 = norm((x11 - x10, y11 - y10)) - l;
    constraint rod12 = norm((x12 - x11, y12 - y11)) - l;
    constraint rod13 = norm((x13 - x12, y13 - y12)) - l;
    constraint rod14 = norm((x14 - x13, y14 - y13)) - l;
    constraint rod15 = norm((x15 - x14, y15 - y14)) - l;
    constraint rod16 = norm((x16 - x15, y16 - y15)) - l;
    constraint rod17 = norm((x17 - x16, y17 - y16)) - l;
    constraint rod18 = norm((x18 - x17, y18 - y17)) - l;
    constraint rod19 = norm((x19 - x18, y19 - y18)) - l;
    constraint rod20 = norm((x20 - x19, y20 - y19)) - l;
    constraint rod21 = norm((x21 - x20, y21 - y20)) - l;
    constraint rod22 = norm((x22 - x21, y22 - y21)) - l;
    constraint rod23 = norm((x23 - x22, y23 - y22)) - l;
    constraint rod24 = norm((x24 - x23, y24 - y23)) - l;
    constraint rod25 = norm((x25 - x24, y25 - y24)) - l;
    constraint rod26 = norm((x26 - x25, y26 - y25)) - l;
    constraint rod27 = norm((x27 - x26, y27 - y26)) - l;
    constraint rod28 = norm((x28 - x27, y28 - y27)) - l;
    constraint rod29 = norm((x29 - x28, y29 - y28)) - l;
    constraint rod30 = norm((x30 - x29, y30 - y29)) - l;
    constraint rod31 = norm((x31 - x30, y31 - y30)) - l;
    constraint rod32 = norm((x32 - x31, y32 - y31)) - l;
    constraint rod33 = norm((x33 - x32, y33 - y32)) - l;
    constraint rod34 = norm((x34 - x33, y34 - y33)) - l;
    constraint rod35 = norm((x35 - x34, y35 - y34)) - l;
    constraint rod36 = norm((x36 - x35, y36 - y35)) - l;
    constraint rod37 = norm((x37 - x36, y37 - y36)) - l;
    constraint rod38 = norm((x38 - x37, y38 - y37)) - l;
    constraint rod39 = norm((x39 - x38, y39 - y38)) - l;
    constraint rod40 = norm((x40 - x39, y40 - y39)) - l;
    constraint rod41 = norm((x41 - x40, y41 - y40)) - l;
    constraint rod42 = norm((x42 - x41, y42 - y41)) - l;
    constraint rod43 = norm((x43 - x42, y43 - y42)) - l;
    constraint rod44 = norm((x44 - x43, y44 - y43)) - l;
    constraint rod45 = norm((x45 - x44, y45 - y44)) - l;
    constraint rod46 = norm((x46 - x45, y46 - y45)) - l;
    constraint rod47 = norm((x47 - x46, y47 - y46)) - l;
    constraint rod48 = norm((x48 - x47, y48 - y47)) - l;
    constraint rod49 = norm((x49 - x48, y49 - y48)) - l;
    constraint rod50 = norm((x50 - x49, y50 - y49)) - l;
    constraint rod51 = norm((x51 - x50, y51 - y50)) - l;
    constraint rod52 = norm((x52 - x51, y52 - y51)) - l;
    constraint rod53 = norm((x53 - x52, y53 - y52)) - l;
    constraint rod54 = norm((x54 - x53, y54 - y53)) - l;
    constraint rod55 = norm((x55 - x54, y55 - y54)) - l;
    constraint rod56 = norm((x56 - x55, y56 - y55)) - l;
    constraint rod57 = norm((x57 - x56, y57 - y56)) - l;
    constraint rod58 = norm((x58 - x57, y58 - y57)) - l;
    constraint rod59 = norm((x59 - x58, y59 - y58)) - l;
    constraint rod60 = norm((x60 - x59, y60 - y59)) - l;
    constraint rod61 = norm((x61 - x60, y61 - y60)) - l;
    constraint rod62 = norm((x62 - x61, y62 - y61)) - l;
    constraint rod63 = norm((x63 - x62, y63 - y62)) - l;
    constraint rod64 = norm((x64 - x63, y64 - y63)) - l;
    constraint rod65 = norm((x65 - x64, y65 - y64)) - l;
    constraint rod66 = norm((x66 - x65, y66 - y65)) - l;
    constraint rod67 = norm((x67 - x66, y67 - y66)) - l;
    constraint rod68 = norm((x68 - x67, y68 - y67)) - l;
    constraint rod69 = norm((x69 - x68, y69 - y68)) - l;
    constraint rod70 = norm((x70 - x69, y70 - y69)) - l;
    constraint rod71 = norm((x71 - x70, y71 - y70)) - l;
    constraint rod72 = norm((x72 - x71, y72 - y71)) - l;
}

const POINTS: usize = 72;
const N: usize = 2 * POINTS;

/// Returns rods whose directions turn from one to the next, stretched by a factor of 10⁻⁴.
fn places() -> [f64; N] {
    let mut places = [0.0; N];
    let mut end = [0.0; 2];
    for k in 0..POINTS {
        let (sin, cos) = (0.7 * k as f64).sin_cos();
        end = [end[0] + 0.25 * 1.0001 * cos, end[1] + 0.25 * 1.0001 * sin];
        places[2 * k..2 * k + 2].copy_from_slice(&end);
    }
    places
}

#[test]
fn matrices_written_without_zeros_are_whole() {
    let (rope, q) = (Rope::default(), places());
    let mass_matrix = rope.mass_matrix(0.0, &q);
    for (i, row) in mass_matrix.iter().enumerate() {
        assert!(row.iter().enumerate().all(|(j, &entry)| entry == if i == j { 2.0 } else { 0.0 }));
    }
    let jacobian = rope.constraint_jacobian(0.0, &q);
    for (k, row) in jacobian.iter().enumerate() {
        let (sin, cos) = (0.7 * k as f64).sin_cos();
        for (j, &entry) in row.iter().enumerate() {
            let direction = if j % 2 == 0 { cos } else { sin };
            let expected = match j / 2 {
                point if point == k => direction,
                point if point + 1 == k => -direction,
                _ => 0.0,
            };
            assert!((entry - expected).abs() < 1e-13, "{k}, {j}: {entry}, not {expected}");
        }
    }
}

#[test]
fn residuals_are_measured_without_the_jacobian() {
    let (rope, q) = (Rope::default(), places());
    let shares = std::array::from_fn(|j| (1 + j) as f64 / 7.0);
    let expected = weighed(&rope.constraint_jacobian(0.0, &q), &shares);
    assert_eq!(rope.residual_scales(0.0, &q, &shares), expected);
    let (mut q, mut v) = (q, [0.1; N]);
    rope.project(0.0, &mut q, &mut v).expect("the rods are stretched a little");
    assert!(rope.constraints(0.0, &q, &v).iter().all(|residual| residual.abs() < 1e-14));
}
