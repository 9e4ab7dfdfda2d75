//! aarch64: two lanes of NEON, which every such processor has, fused multiplication included.
//!
//! SAFETY of every intrinsic here: NEON belongs to the target.

use super::fused::Fused;
use super::scalar::ROUNDER;
use super::twice::Twice;
use super::{Kernel, Lane};
use core::arch::aarch64::*;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Width one.
#[inline]
pub fn single_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Fused>()
}

/// Width four.
#[inline]
pub fn wide_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Twice<F64x2>>()
}

/// Not on this processor, and never in use there.
pub fn wide_avx512<K: Kernel>(kernel: K) -> K::Output {
    wide_fused(kernel)
}

/// Two doubles of NEON.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct F64x2(float64x2_t);

macro_rules! neon_operator {
    ($($trait:ident $method:ident $intrinsic:ident),*) => {$(
        impl $trait for F64x2 {
            type Output = F64x2;
            #[inline(always)]
            fn $method(self, other: F64x2) -> F64x2 {
                // SAFETY: see the top of this file.
                F64x2(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}
neon_operator!(Add add vaddq_f64, Sub sub vsubq_f64, Mul mul vmulq_f64, Div div vdivq_f64);

impl Neg for F64x2 {
    type Output = F64x2;
    #[inline(always)]
    fn neg(self) -> F64x2 {
        // SAFETY: see the top of this file.
        F64x2(unsafe { vnegq_f64(self.0) })
    }
}

impl Lane for F64x2 {
    type Mask = uint64x2_t;
    const WIDTH: usize = 2;

    #[inline(always)]
    fn load(from: &[f64]) -> F64x2 {
        let from = &from[..2];
        // SAFETY: as above; the slice has the length that is read.
        F64x2(unsafe { vld1q_f64(from.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        let to = &mut to[..2];
        // SAFETY: as above; the slice has the length that is written.
        unsafe { vst1q_f64(to.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn splat(value: f64) -> F64x2 {
        // SAFETY: see the top of this file.
        F64x2(unsafe { vdupq_n_f64(value) })
    }
    #[inline(always)]
    fn mul_add(self, factor: F64x2, term: F64x2) -> F64x2 {
        // SAFETY: see the top of this file.
        F64x2(unsafe { vfmaq_f64(term.0, self.0, factor.0) })
    }
    #[inline(always)]
    fn two_product(self, factor: F64x2) -> (F64x2, F64x2) {
        let product = self * factor;
        // SAFETY: see the top of this file.
        (product, F64x2(unsafe { vfmaq_f64(vnegq_f64(product.0), self.0, factor.0) }))
    }
    #[inline(always)]
    fn round(self) -> F64x2 {
        // SAFETY: see the top of this file.
        F64x2(unsafe { vrndnq_f64(self.0) })
    }
    #[inline(always)]
    fn sqrt(self) -> F64x2 {
        // SAFETY: see the top of this file.
        F64x2(unsafe { vsqrtq_f64(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> F64x2 {
        // SAFETY: see the top of this file.
        F64x2(unsafe { vabsq_f64(self.0) })
    }
    #[inline(always)]
    fn copysign(self, sign: F64x2) -> F64x2 {
        // SAFETY: see the top of this file.
        F64x2(unsafe { vbslq_f64(vdupq_n_u64(1 << 63), sign.0, self.0) })
    }
    #[inline(always)]
    fn exp2_integer(self) -> F64x2 {
        let shifted = self + F64x2::splat(ROUNDER + 1023.0);
        // SAFETY: see the top of this file.
        F64x2(unsafe { vreinterpretq_f64_u64(vshlq_n_u64::<52>(vreinterpretq_u64_f64(shifted.0))) })
    }
    #[inline(always)]
    fn less(self, other: F64x2) -> uint64x2_t {
        // SAFETY: see the top of this file.
        unsafe { vcltq_f64(self.0, other.0) }
    }
    #[inline(always)]
    fn equal(self, other: F64x2) -> uint64x2_t {
        // SAFETY: see the top of this file.
        unsafe { vceqq_f64(self.0, other.0) }
    }
    #[inline(always)]
    fn select(mask: uint64x2_t, yes: F64x2, no: F64x2) -> F64x2 {
        // SAFETY: see the top of this file.
        F64x2(unsafe { vbslq_f64(mask, yes.0, no.0) })
    }
}
