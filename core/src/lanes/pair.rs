//! Two lanes side by side: their operations interleave, which hides the latency of one behind the other.

use super::lane::{Lane, PIECES};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A pair of lanes as one lane of twice the width.
#[derive(Clone, Copy)]
pub struct Pair<L>(L, L);

/// Operators of two pairs.
macro_rules! operators {
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
operators!(Add add, Sub sub, Mul mul, Div div);

impl<L: Lane> Neg for Pair<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Pair(-self.0, -self.1)
    }
}

/// Methods of one lane and some more, with a pair as the result.
macro_rules! methods {
    ($($method:ident($($other:ident),*) -> $result:ty),*) => {$(
        #[inline(always)]
        fn $method(self $(, $other: Self)*) -> $result {
            (self.0.$method($($other.0),*), self.1.$method($($other.1),*)).into()
        }
    )*};
}

impl<L> From<(L, L)> for Pair<L> {
    #[inline(always)]
    fn from((first, second): (L, L)) -> Self {
        Pair(first, second)
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
    fn load_at(from: &[f64], at: usize) -> Self {
        Pair(L::load_at(from, at), L::load_at(from, at + L::WIDTH))
    }
    #[inline(always)]
    fn store_at(self, to: &mut [f64], at: usize) {
        self.0.store_at(to, at);
        self.1.store_at(to, at + L::WIDTH);
    }
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Pair(L::splat(value), L::splat(value))
    }
    #[inline(always)]
    fn two_product(self, factor: Self) -> (Self, Self) {
        let (first, second) = (self.0.two_product(factor.0), self.1.two_product(factor.1));
        (Pair(first.0, second.0), Pair(first.1, second.1))
    }
    #[inline(always)]
    fn two_product_in_range(self, factor: Self) -> (Self, Self) {
        let (first, second) = (self.0.two_product_in_range(factor.0), self.1.two_product_in_range(factor.1));
        (Pair(first.0, second.0), Pair(first.1, second.1))
    }
    methods!(
        mul_add(factor, term) -> Self, remainder(factor, other) -> Self, round() -> Self,
        sqrt() -> Self, abs() -> Self, copysign(sign) -> Self, exp2_integer() -> Self, exponent() -> Self,
        alternated(shifted) -> Self, larger(other) -> Self, smaller(other) -> Self, less(other) -> Self::Mask,
        equal(other) -> Self::Mask
    );
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        L::any(mask.0) || L::any(mask.1)
    }
    #[inline(always)]
    fn lookup(self, table: &[f64; PIECES]) -> Self {
        Pair(self.0.lookup(table), self.1.lookup(table))
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Pair(L::select(mask.0, yes.0, no.0), L::select(mask.1, yes.1, no.1))
    }
    #[inline(always)]
    fn pack(self, mask: Self::Mask, to: &mut [f64]) -> usize {
        let first = self.0.pack(mask.0, to);
        first + self.1.pack(mask.1, &mut to[first..])
    }
    #[inline(always)]
    fn unpack(self, mask: Self::Mask, from: &[f64]) -> (Self, usize) {
        let (low, first) = self.0.unpack(mask.0, from);
        let (high, second) = self.1.unpack(mask.1, &from[first..]);
        (Pair(low, high), first + second)
    }
}
