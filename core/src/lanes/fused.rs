//! The lane of width one on a processor with fused multiplication.

use super::lane::Lane;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// One double on a processor with fused multiplication.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Fused(f64);

macro_rules! fused_operator {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Fused {
            type Output = Fused;
            #[inline(always)]
            fn $method(self, other: Fused) -> Fused {
                Fused(self.0.$method(other.0))
            }
        }
    )*};
}
fused_operator!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Fused {
    type Output = Fused;
    #[inline(always)]
    fn neg(self) -> Fused {
        Fused(-self.0)
    }
}

impl Lane for Fused {
    type Mask = bool;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn load(from: &[f64]) -> Fused {
        Fused(from[0])
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        to[0] = self.0;
    }

    #[inline(always)]
    fn splat(value: f64) -> Fused {
        Fused(value)
    }
    #[inline(always)]
    fn mul_add(self, factor: Fused, term: Fused) -> Fused {
        Fused(f64::mul_add(self.0, factor.0, term.0))
    }
    #[inline(always)]
    fn two_product(self, factor: Fused) -> (Fused, Fused) {
        let product = self.0 * factor.0;
        (Fused(product), Fused(f64::mul_add(self.0, factor.0, -product)))
    }
    #[inline(always)]
    fn round(self) -> Fused {
        Fused(f64::round_ties_even(self.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Fused {
        Fused(f64::sqrt(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Fused {
        Fused(f64::abs(self.0))
    }
    #[inline(always)]
    fn copysign(self, sign: Fused) -> Fused {
        Fused(f64::copysign(self.0, sign.0))
    }
    #[inline(always)]
    fn exp2_integer(self) -> Fused {
        Fused(Lane::exp2_integer(self.0))
    }
    #[inline(always)]
    fn less(self, other: Fused) -> bool {
        self.0 < other.0
    }
    #[inline(always)]
    fn equal(self, other: Fused) -> bool {
        self.0 == other.0
    }
    #[inline(always)]
    fn select(mask: bool, yes: Fused, no: Fused) -> Fused {
        Fused(Lane::select(mask, yes.0, no.0))
    }
}
