//! Two lanes side by side: their operations interleave, which hides the latency of one behind the other.

use super::lane::Lane;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A pair of lanes as one lane of twice the width.
#[derive(Clone, Copy)]
pub struct Pair<L>(L, L);

macro_rules! pair_operator {
    ($($trait:ident $method:ident),*) => {$(
        impl<L: Lane> $trait for Pair<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Pair(self.0.$method(other.0), self.1.$method(other.1))
            }
        }
    )*};
}
pair_operator!(Add add, Sub sub, Mul mul, Div div);

impl<L: Lane> Neg for Pair<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Pair(-self.0, -self.1)
    }
}

impl<L: Lane> Lane for Pair<L> {
    type Mask = (L::Mask, L::Mask);
    const WIDTH: usize = 2 * L::WIDTH;

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        Pair(L::load(from), L::load(&from[L::WIDTH..]))
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        self.0.store(to);
        self.1.store(&mut to[L::WIDTH..]);
    }
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Pair(L::splat(value), L::splat(value))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Pair(self.0.mul_add(factor.0, term.0), self.1.mul_add(factor.1, term.1))
    }
    #[inline(always)]
    fn two_product(self, factor: Self) -> (Self, Self) {
        let (first, second) = (self.0.two_product(factor.0), self.1.two_product(factor.1));
        (Pair(first.0, second.0), Pair(first.1, second.1))
    }
    #[inline(always)]
    fn round(self) -> Self {
        Pair(self.0.round(), self.1.round())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Pair(self.0.sqrt(), self.1.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Pair(self.0.abs(), self.1.abs())
    }
    #[inline(always)]
    fn exp2_integer(self) -> Self {
        Pair(self.0.exp2_integer(), self.1.exp2_integer())
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        Pair(self.0.copysign(sign.0), self.1.copysign(sign.1))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        (self.0.less(other.0), self.1.less(other.1))
    }
    #[inline(always)]
    fn equal(self, other: Self) -> Self::Mask {
        (self.0.equal(other.0), self.1.equal(other.1))
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Pair(L::select(mask.0, yes.0, no.0), L::select(mask.1, yes.1, no.1))
    }
}
