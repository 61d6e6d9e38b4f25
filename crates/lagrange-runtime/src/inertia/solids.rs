//! Bodies with closed formulas.

use crate::scalar::Scalar;

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value)
}

fn pi<S: Scalar>() -> S {
    (-S::ONE).acos()
}

/// Computes Σ lengths² · numerator / denominator, for a mass of one.
fn squares<S: Scalar, const N: usize>(lengths: [S; N], numerator: f64, denominator: f64) -> S {
    let sum = lengths.into_iter().fold(S::ZERO, |sum, length| sum + length * length);
    sum * number(numerator) / number(denominator)
}

/// Returns the moment of inertia about an axis at `distance` from the centre of mass: J + m r², the
/// theorem of Steiner or Huygens.
///
/// `inertia` is the moment about the parallel axis through the centre of mass, which is the
/// smallest of all.
///
/// ```
/// use lagrange::inertia::{slender_rod, slender_rod_end, steiner};
///
/// let (m, l) = (2.0, 3.0_f64);
/// assert_eq!(steiner(slender_rod(m, l), m, l / 2.0), slender_rod_end(m, l));
/// ```
pub fn steiner<S: Scalar>(inertia: S, mass: S, distance: S) -> S {
    inertia + mass * distance * distance
}

/// Returns the moment of inertia of a point mass: zero.
pub fn point_mass<S: Scalar>(mass: S) -> S {
    mass * S::ZERO
}

/// Returns the moment of inertia of a thin rod of length l, or of a thin plate seen edge-on, about
/// its middle: m l²/12.
pub fn slender_rod<S: Scalar>(mass: S, length: S) -> S {
    mass * squares([length], 1.0, 12.0)
}

/// Returns the same as [`slender_rod`].
pub fn rod<S: Scalar>(mass: S, length: S) -> S {
    slender_rod(mass, length)
}

/// Returns the moment of inertia of a thin rod of length l about one of its *ends*: m l²/3.
pub fn slender_rod_end<S: Scalar>(mass: S, length: S) -> S {
    mass * squares([length], 1.0, 3.0)
}

/// Returns the moment of inertia of a cylinder of radius r about its axis: m r²/2.
pub fn solid_cylinder<S: Scalar>(mass: S, radius: S) -> S {
    mass * squares([radius], 1.0, 2.0)
}

/// Returns the moment of inertia of a disk. It equals [`solid_cylinder`], since the height is
/// irrelevant.
pub fn disk<S: Scalar>(mass: S, radius: S) -> S {
    solid_cylinder(mass, radius)
}

/// Returns the moment of inertia of a tube of inner radius r and outer radius R about its axis: m
/// (r² + R²)/2.
///
/// NaN if the inner radius is larger than the outer one.
pub fn hollow_cylinder<S: Scalar>(mass: S, inner: S, outer: S) -> S {
    if inner.abs() <= outer.abs() { mass * squares([inner, outer], 1.0, 2.0) } else { S::NAN }
}

/// Returns the moment of inertia of a thin ring or tube of radius r about its axis: m r².
pub fn thin_ring<S: Scalar>(mass: S, radius: S) -> S {
    mass * squares([radius], 1.0, 1.0)
}

/// Returns the moment of inertia of a rectangle with sides a and b: m (a² + b²)/12.
pub fn rectangle<S: Scalar>(mass: S, a: S, b: S) -> S {
    mass * squares([a, b], 1.0, 12.0)
}

/// Returns the moment of inertia of a cuboid with edges a and b in the plane of motion. It equals
/// [`rectangle`], since the depth is irrelevant.
pub fn cuboid<S: Scalar>(mass: S, a: S, b: S) -> S {
    rectangle(mass, a, b)
}

/// Returns the moment of inertia of half a disk or cylinder of radius r: m (r²/2 − s²) = (1/2 −
/// 16/(9 π²)) m r² = 0.3198734513 m r².
///
/// About the centre of the circle it is m r²/2, as for the whole disk. The distance from there to
/// the centre of mass is s = 4 r/(3 π), by [`semicircular_disk_center`].
pub fn semicircular_disk<S: Scalar>(mass: S, radius: S) -> S {
    let [_, distance] = semicircular_disk_center(radius);
    mass * (squares([radius], 1.0, 2.0) - distance * distance)
}

/// Returns the centre of mass of half a disk: (0, 4 r/(3 π)).
///
/// Y is positive on the side of the disk, and the middle of its straight edge is the origin.
pub fn semicircular_disk_center<S: Scalar>(radius: S) -> [S; 2] {
    [S::ZERO, number::<S>(4.0) * radius / (number::<S>(3.0) * pi())]
}

/// Returns the moment of inertia of a sector of a disk with radius r and opening angle α in rad. It
/// is m (r²/2 − s²) with s as in [`circular_sector_center`].
///
/// NaN unless 0 < α ≤ 2π.
pub fn circular_sector<S: Scalar>(mass: S, radius: S, angle: S) -> S {
    let [distance, _] = circular_sector_center(radius, angle);
    mass * (squares([radius], 1.0, 2.0) - distance * distance)
}

/// Returns the centre of mass of a sector of a disk with radius r and opening angle α in rad. It is
/// (s, 0) with s = 4 r sin(α/2)/(3 α).
///
/// The apex is at the origin, and the X axis bisects the angle. NaN unless 0 < α ≤ 2π.
pub fn circular_sector_center<S: Scalar>(radius: S, angle: S) -> [S; 2] {
    // Allow for a full turn that was rounded up.
    let full = number::<S>(2.0) * pi() * (S::ONE + number::<S>(8.0) * S::epsilon());
    if !(angle > S::ZERO && angle <= full) {
        return [S::NAN; 2];
    }
    let chord = (angle / number(2.0)).sin();
    [number::<S>(4.0) * radius * chord / (number::<S>(3.0) * angle), S::ZERO]
}

/// Returns the moment of inertia of a triangle with a right angle between legs a and b: m (a² +
/// b²)/18.
pub fn right_triangle<S: Scalar>(mass: S, a: S, b: S) -> S {
    mass * squares([a, b], 1.0, 18.0)
}

/// Returns the centre of mass of a right triangle: (a/3, b/3), with the right angle at the origin
/// and the legs along X and Y.
pub fn right_triangle_center<S: Scalar>(a: S, b: S) -> [S; 2] {
    [a / number(3.0), b / number(3.0)]
}

/// Returns the moment of inertia of a triangle with sides a, b, c: m (a² + b² + c²)/36.
///
/// NaN if there is no such triangle.
pub fn triangle<S: Scalar>(mass: S, a: S, b: S, c: S) -> S {
    let [x, y] = triangle_center(a, b, c);
    if x.is_finite() && y.is_finite() { mass * squares([a, b, c], 1.0, 36.0) } else { S::NAN }
}

/// Returns the centre of mass of a triangle with sides a, b, c.
///
/// Side a extends from the origin along X, b continues from its end, and c returns; Y is positive
/// inside. The third corner is (p, q) with p = (a² − b² + c²)/(2 a), and q =
/// √((a+b+c)(−a+b+c)(a−b+c)(a+b−c))/(2 a) by Heron's formula. The centre of mass is ((a + p)/3,
/// q/3). NaN if there is no such triangle, or a is zero or any side negative.
pub fn triangle_center<S: Scalar>(a: S, b: S, c: S) -> [S; 2] {
    let factors = [a + b + c, b + c - a, a - b + c, a + b - c];
    if !factors.into_iter().all(|factor| factor >= S::ZERO) {
        return [S::NAN; 2];
    }
    let twice = number::<S>(2.0) * a;
    let p = (a * a + (c - b) * (c + b)) / twice;
    let q = factors.into_iter().fold(S::ONE, |product, factor| product * factor).sqrt() / twice;
    [(a + p) / number(3.0), q / number(3.0)]
}

/// Returns the moment of inertia of an ellipse with semi-axes a and b: m (a² + b²)/4.
pub fn ellipse<S: Scalar>(mass: S, a: S, b: S) -> S {
    mass * squares([a, b], 1.0, 4.0)
}

/// Returns the moment of inertia of a regular polygon of n corners on a circle of radius r: m r² (2 +
/// cos(2π/n))/6.
///
/// NaN for fewer than three corners.
pub fn regular_polygon<S: Scalar>(mass: S, corners: u32, radius: S) -> S {
    if corners < 3 {
        return S::NAN;
    }
    let cosine = (number::<S>(2.0) * pi() / number(f64::from(corners))).cos();
    mass * squares([radius], 1.0, 6.0) * (number::<S>(2.0) + cosine)
}

/// Returns the moment of inertia of a ball of radius r: 2/5 m r².
pub fn solid_sphere<S: Scalar>(mass: S, radius: S) -> S {
    mass * squares([radius], 2.0, 5.0)
}

/// Returns the moment of inertia of a ball of radius R with a concentric cavity of radius r: 2/5 m
/// (R⁵ − r⁵)/(R³ − r³).
///
/// R − r is cancelled, so the result is also accurate for thin shells. NaN unless 0 ≤ r ≤ R and 0 <
/// R.
pub fn hollow_sphere<S: Scalar>(mass: S, inner: S, outer: S) -> S {
    if !(inner >= S::ZERO && inner <= outer && outer > S::ZERO) {
        return S::NAN;
    }
    let ratio = inner / outer;
    let homogeneous = |degree: i32| (0..degree).fold(S::ONE, |sum, _| sum * ratio + S::ONE);
    mass * squares([outer], 2.0, 5.0) * homogeneous(4) / homogeneous(2)
}

/// Returns the moment of inertia of a thin spherical shell of radius r: 2/3 m r².
pub fn thin_sphere<S: Scalar>(mass: S, radius: S) -> S {
    mass * squares([radius], 2.0, 3.0)
}
