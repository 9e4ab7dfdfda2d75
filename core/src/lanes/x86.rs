//! x86-64: four lanes of AVX2 with FMA, eight of AVX-512, and the functions that enter them.
//!
//! SAFETY of every intrinsic here: the lane types are made only inside `wide_fused` and `wide_avx512`, which are
//! entered only where `InstructionSet::available` has seen the features on this processor.

use super::fused::Fused;
use super::scalar::ROUNDER;
use super::twice::Twice;
use super::{Kernel, Lane};
use core::arch::x86_64::*;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Width one, compiled for AVX2 with FMA.
#[inline]
pub fn single_fused<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx2,fma")]
    fn enter<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Fused>()
    }
    // SAFETY: see the top of this file.
    unsafe { enter(kernel) }
}

/// Width four.
#[inline]
pub fn wide_fused<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx2,fma")]
    fn enter<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Twice<F64x4>>()
    }
    // SAFETY: see the top of this file.
    unsafe { enter(kernel) }
}

/// Width sixteen.
#[inline]
pub fn wide_avx512<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx512f")]
    fn enter<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Twice<F64x8>>()
    }
    // SAFETY: see the top of this file.
    unsafe { enter(kernel) }
}

/// Eight doubles of AVX-512.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct F64x8(__m512d);

macro_rules! avx512_operator {
    ($($trait:ident $method:ident $intrinsic:ident),*) => {$(
        impl $trait for F64x8 {
            type Output = F64x8;
            #[inline(always)]
            fn $method(self, other: F64x8) -> F64x8 {
                // SAFETY: see the top of this file.
                F64x8(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}
avx512_operator!(Add add _mm512_add_pd, Sub sub _mm512_sub_pd, Mul mul _mm512_mul_pd, Div div _mm512_div_pd);

impl Neg for F64x8 {
    type Output = F64x8;
    #[inline(always)]
    fn neg(self) -> F64x8 {
        // SAFETY: see the top of this file.
        F64x8(unsafe {
            _mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(self.0), _mm512_set1_epi64(i64::MIN)))
        })
    }
}

impl Lane for F64x8 {
    type Mask = __mmask8;
    const WIDTH: usize = 8;

    #[inline(always)]
    fn load(from: &[f64]) -> F64x8 {
        let from = &from[..8];
        // SAFETY: as above; the slice has the length that is read.
        F64x8(unsafe { _mm512_loadu_pd(from.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        let to = &mut to[..8];
        // SAFETY: as above; the slice has the length that is written.
        unsafe { _mm512_storeu_pd(to.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn splat(value: f64) -> F64x8 {
        // SAFETY: see the top of this file.
        F64x8(unsafe { _mm512_set1_pd(value) })
    }
    #[inline(always)]
    fn mul_add(self, factor: F64x8, term: F64x8) -> F64x8 {
        // SAFETY: see the top of this file.
        F64x8(unsafe { _mm512_fmadd_pd(self.0, factor.0, term.0) })
    }
    #[inline(always)]
    fn two_product(self, factor: F64x8) -> (F64x8, F64x8) {
        let product = self * factor;
        // SAFETY: see the top of this file.
        (product, F64x8(unsafe { _mm512_fmsub_pd(self.0, factor.0, product.0) }))
    }
    #[inline(always)]
    fn round(self) -> F64x8 {
        // SAFETY: see the top of this file.
        F64x8(unsafe { _mm512_roundscale_pd::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(self.0) })
    }
    #[inline(always)]
    fn sqrt(self) -> F64x8 {
        // SAFETY: see the top of this file.
        F64x8(unsafe { _mm512_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> F64x8 {
        // SAFETY: see the top of this file.
        F64x8(unsafe { _mm512_abs_pd(self.0) })
    }
    #[inline(always)]
    fn copysign(self, sign: F64x8) -> F64x8 {
        // SAFETY: see the top of this file.
        F64x8(unsafe {
            {
                let sign_bit = _mm512_set1_epi64(i64::MIN);
                let (value, sign) = (_mm512_castpd_si512(self.0), _mm512_castpd_si512(sign.0));
                _mm512_castsi512_pd(_mm512_ternarylogic_epi64::<0xd8>(value, sign, sign_bit))
            }
        })
    }
    #[inline(always)]
    fn exp2_integer(self) -> F64x8 {
        let shifted = self + F64x8::splat(ROUNDER + 1023.0);
        // SAFETY: see the top of this file.
        F64x8(unsafe { _mm512_castsi512_pd(_mm512_slli_epi64::<52>(_mm512_castpd_si512(shifted.0))) })
    }
    #[inline(always)]
    fn less(self, other: F64x8) -> __mmask8 {
        // SAFETY: see the top of this file.
        unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn equal(self, other: F64x8) -> __mmask8 {
        // SAFETY: see the top of this file.
        unsafe { _mm512_cmp_pd_mask::<_CMP_EQ_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn select(mask: __mmask8, yes: F64x8, no: F64x8) -> F64x8 {
        // SAFETY: see the top of this file.
        F64x8(unsafe { _mm512_mask_blend_pd(mask, no.0, yes.0) })
    }
}

/// Four doubles of AVX2 with FMA.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct F64x4(__m256d);

macro_rules! avx2_operator {
    ($($trait:ident $method:ident $intrinsic:ident),*) => {$(
        impl $trait for F64x4 {
            type Output = F64x4;
            #[inline(always)]
            fn $method(self, other: F64x4) -> F64x4 {
                // SAFETY: see the top of this file.
                F64x4(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}
avx2_operator!(Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);

impl Neg for F64x4 {
    type Output = F64x4;
    #[inline(always)]
    fn neg(self) -> F64x4 {
        // SAFETY: see the top of this file.
        F64x4(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
}

impl Lane for F64x4 {
    type Mask = __m256d;
    const WIDTH: usize = 4;

    #[inline(always)]
    fn load(from: &[f64]) -> F64x4 {
        let from = &from[..4];
        // SAFETY: as above; the slice has the length that is read.
        F64x4(unsafe { _mm256_loadu_pd(from.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        let to = &mut to[..4];
        // SAFETY: as above; the slice has the length that is written.
        unsafe { _mm256_storeu_pd(to.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn splat(value: f64) -> F64x4 {
        // SAFETY: see the top of this file.
        F64x4(unsafe { _mm256_set1_pd(value) })
    }
    #[inline(always)]
    fn mul_add(self, factor: F64x4, term: F64x4) -> F64x4 {
        // SAFETY: see the top of this file.
        F64x4(unsafe { _mm256_fmadd_pd(self.0, factor.0, term.0) })
    }
    #[inline(always)]
    fn two_product(self, factor: F64x4) -> (F64x4, F64x4) {
        let product = self * factor;
        // SAFETY: see the top of this file.
        (product, F64x4(unsafe { _mm256_fmsub_pd(self.0, factor.0, product.0) }))
    }
    #[inline(always)]
    fn round(self) -> F64x4 {
        // SAFETY: see the top of this file.
        F64x4(unsafe { _mm256_round_pd::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(self.0) })
    }
    #[inline(always)]
    fn sqrt(self) -> F64x4 {
        // SAFETY: see the top of this file.
        F64x4(unsafe { _mm256_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> F64x4 {
        // SAFETY: see the top of this file.
        F64x4(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn copysign(self, sign: F64x4) -> F64x4 {
        // SAFETY: see the top of this file.
        F64x4(unsafe {
            {
                let sign_bit = _mm256_set1_pd(-0.0);
                _mm256_or_pd(_mm256_andnot_pd(sign_bit, self.0), _mm256_and_pd(sign_bit, sign.0))
            }
        })
    }
    #[inline(always)]
    fn exp2_integer(self) -> F64x4 {
        let shifted = self + F64x4::splat(ROUNDER + 1023.0);
        // SAFETY: see the top of this file.
        F64x4(unsafe { _mm256_castsi256_pd(_mm256_slli_epi64::<52>(_mm256_castpd_si256(shifted.0))) })
    }
    #[inline(always)]
    fn less(self, other: F64x4) -> __m256d {
        // SAFETY: see the top of this file.
        unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn equal(self, other: F64x4) -> __m256d {
        // SAFETY: see the top of this file.
        unsafe { _mm256_cmp_pd::<_CMP_EQ_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn select(mask: __m256d, yes: F64x4, no: F64x4) -> F64x4 {
        // SAFETY: see the top of this file.
        F64x4(unsafe { _mm256_blendv_pd(no.0, yes.0, mask) })
    }
}
