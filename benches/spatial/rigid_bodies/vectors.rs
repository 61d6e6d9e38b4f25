//! Vectors of three components, matrices in rows and symmetric ones by their six entries.

use crate::handwritten::fma;

pub(super) type Vector = [f64; 3];
/// Three rows.
pub(super) type Matrix = [Vector; 3];

#[inline(always)]
pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    fma(a[0], b[0], fma(a[1], b[1], a[2] * b[2]))
}

/// Returns a·b + c by components.
#[inline(always)]
pub(super) fn scaled_sum(a: f64, b: Vector, c: Vector) -> Vector {
    [fma(a, b[0], c[0]), fma(a, b[1], c[1]), fma(a, b[2], c[2])]
}

#[inline(always)]
pub(super) fn scaled(a: f64, b: Vector) -> Vector {
    [a * b[0], a * b[1], a * b[2]]
}

#[inline(always)]
pub(super) fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [fma(a[1], b[2], -(a[2] * b[1])), fma(a[2], b[0], -(a[0] * b[2])), fma(a[0], b[1], -(a[1] * b[0]))]
}

/// Returns a × b + c.
#[inline(always)]
pub(super) fn cross_sum(a: Vector, b: Vector, c: Vector) -> Vector {
    [
        fma(a[1], b[2], fma(-a[2], b[1], c[0])),
        fma(a[2], b[0], fma(-a[0], b[2], c[1])),
        fma(a[0], b[1], fma(-a[1], b[0], c[2])),
    ]
}

/// Returns M x.
#[inline(always)]
pub(super) fn product(m: &Matrix, x: Vector) -> Vector {
    [dot(m[0], x), dot(m[1], x), dot(m[2], x)]
}

/// Returns Mᵀ x.
#[inline(always)]
pub(super) fn transposed_product(m: &Matrix, x: Vector) -> Vector {
    scaled_sum(x[0], m[0], scaled_sum(x[1], m[1], scaled(x[2], m[2])))
}

/// A symmetric matrix.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Symmetric {
    pub(super) xx: f64,
    pub(super) yy: f64,
    pub(super) zz: f64,
    pub(super) xy: f64,
    pub(super) xz: f64,
    pub(super) yz: f64,
}

impl Symmetric {
    #[inline(always)]
    pub(super) fn rows(self) -> Matrix {
        let Symmetric { xx, yy, zz, xy, xz, yz } = self;
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    }

    /// Returns the symmetric matrix with these entries on the diagonal and above.
    #[inline(always)]
    pub(super) fn from_entries(entry: impl Fn(usize, usize) -> f64) -> Symmetric {
        Symmetric {
            xx: entry(0, 0),
            yy: entry(1, 1),
            zz: entry(2, 2),
            xy: entry(0, 1),
            xz: entry(0, 2),
            yz: entry(1, 2),
        }
    }

    #[inline(always)]
    pub(super) fn plus(self, other: Symmetric) -> Symmetric {
        Symmetric {
            xx: self.xx + other.xx,
            yy: self.yy + other.yy,
            zz: self.zz + other.zz,
            xy: self.xy + other.xy,
            xz: self.xz + other.xz,
            yz: self.yz + other.yz,
        }
    }

    /// Returns Eᵀ S E, with the rows of E.
    #[inline(always)]
    pub(super) fn turned_back(self, e: &Matrix) -> Symmetric {
        let half = self.rows().map(|row| transposed_product(e, row));
        Symmetric::from_entries(|i, j| {
            fma(e[0][i], half[0][j], fma(e[1][i], half[1][j], e[2][i] * half[2][j]))
        })
    }
}
