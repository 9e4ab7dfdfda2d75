//! x86-64: four lanes of AVX2 with FMA, eight of AVX-512, and the functions that enter them.
//!
//! SAFETY of every intrinsic here: the lane types are made only inside `wide_fused` and `wide_avx512`, which are
//! entered only where `InstructionSet::available` has seen the features on this processor.

use super::fused::Fused;
use super::lane::Kernel;
use super::pair::Pair;
use super::scalar::FIELD;
use super::vector::vector;
use core::arch::x86_64::*;

/// Whether `Plain` is the only set, known when compiled.
pub const ONLY_PLAIN: bool = false;

/// How many of `InstructionSet` this processor has.
pub fn instruction_sets() -> usize {
    let fused = std::arch::is_x86_feature_detected!("fma") && std::arch::is_x86_feature_detected!("avx2");
    let wide = std::arch::is_x86_feature_detected!("avx512f")
        && std::arch::is_x86_feature_detected!("avx512vl")
        && std::arch::is_x86_feature_detected!("popcnt");
    1 + usize::from(fused) + usize::from(fused && wide)
}

/// The functions that hold the kernels, with the features they are compiled for; as [`Entry`](super::lane::Entry), default
/// methods of the type in whose module they are compiled.
trait FeatureEntry {
    /// SAFETY: only where the processor has AVX2 and FMA.
    #[target_feature(enable = "avx2,fma")]
    unsafe fn single_fused<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Fused>()
    }
    /// SAFETY: only where the processor has AVX2 and FMA.
    #[target_feature(enable = "avx2,fma")]
    unsafe fn four_fused<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<F64x4>()
    }
    /// SAFETY: only where the processor has AVX2 and FMA.
    #[target_feature(enable = "avx2,fma")]
    unsafe fn wide_fused<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Pair<F64x4>>()
    }
    /// SAFETY: only where the processor has AVX-512. Twice as many registers as `four_fused` has.
    #[target_feature(enable = "avx512f,avx512vl")]
    unsafe fn four_avx512<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<F64x4>()
    }
    /// SAFETY: only where the processor has AVX-512.
    #[target_feature(enable = "avx512f,popcnt")]
    unsafe fn wide_avx512<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Pair<F64x8>>()
    }
}

impl<Place> FeatureEntry for Place {}

/// Width one, compiled for AVX2 with FMA.
#[inline]
pub fn single_fused<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: see the top of this file.
    unsafe { K::Place::single_fused(kernel) }
}

/// Width four.
#[inline]
pub fn four_fused<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: see the top of this file.
    unsafe { K::Place::four_fused(kernel) }
}

/// Width four with the registers of AVX-512.
#[inline]
pub fn four_avx512<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: see the top of this file.
    unsafe { K::Place::four_avx512(kernel) }
}

/// Width eight.
#[inline]
pub fn wide_fused<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: see the top of this file.
    unsafe { K::Place::wide_fused(kernel) }
}

/// Width sixteen.
#[inline]
pub fn wide_avx512<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: see the top of this file.
    unsafe { K::Place::wide_avx512(kernel) }
}

/// Asks for the line of the cache at a place, which need not be one.
#[inline(always)]
pub fn prefetch(place: *const f64) {
    // SAFETY: SSE is part of x86-64. Nothing is read, and a place that cannot be is left alone.
    unsafe { _mm_prefetch::<_MM_HINT_T0>(place.cast()) };
}

vector! {
    /// Eight doubles of AVX-512.
    F64x8 = 8 in __m512d, flags in __mmask8, of a, b, c;
    load = _mm512_loadu_pd(a);
    store = _mm512_storeu_pd(a, b);
    splat = _mm512_set1_pd(a);
    add = _mm512_add_pd(a, b);
    sub = _mm512_sub_pd(a, b);
    mul = _mm512_mul_pd(a, b);
    div = _mm512_div_pd(a, b);
    neg = _mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(a), _mm512_set1_epi64(i64::MIN)));
    mul_add = _mm512_fmadd_pd(a, b, c);
    product_error = _mm512_fmsub_pd(a, b, c);
    remainder = _mm512_fnmadd_pd(a, b, c);
    round = _mm512_roundscale_pd::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(a);
    sqrt = _mm512_sqrt_pd(a);
    abs = _mm512_abs_pd(a);
    copysign = _mm512_castsi512_pd(_mm512_ternarylogic_epi64::<0xd8>(
        _mm512_castpd_si512(a), _mm512_castpd_si512(b), _mm512_set1_epi64(i64::MIN)));
    shift_52 = _mm512_castsi512_pd(_mm512_slli_epi64::<52>(_mm512_castpd_si512(a)));
    exponent_field = _mm512_castsi512_pd(_mm512_or_si512(
        _mm512_srli_epi64::<52>(_mm512_castpd_si512(a)), _mm512_castpd_si512(_mm512_set1_pd(FIELD))));
    any = a != 0;
    lookup = _mm512_permutex2var_pd(
        _mm512_loadu_pd(b), _mm512_srli_epi64::<49>(_mm512_castpd_si512(a)), _mm512_loadu_pd(b.add(8)));
    less = _mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b);
    equal = _mm512_cmp_pd_mask::<_CMP_EQ_OQ>(a, b);
    select = _mm512_mask_blend_pd(a, c, b);
    alternated = _mm512_castsi512_pd(_mm512_xor_si512(
        _mm512_castpd_si512(a), _mm512_slli_epi64::<63>(_mm512_castpd_si512(b))));
    larger = _mm512_max_pd(b, a);
    smaller = _mm512_min_pd(b, a);
    pack = _mm512_storeu_pd(c, _mm512_maskz_compress_pd(a, b));
    unpack = _mm512_mask_expand_pd(b, a, _mm512_loadu_pd(c));
}

vector! {
    /// Four doubles of AVX2 with FMA.
    F64x4 = 4 in __m256d, flags in __m256d, of a, b, c;
    load = _mm256_loadu_pd(a);
    store = _mm256_storeu_pd(a, b);
    splat = _mm256_set1_pd(a);
    add = _mm256_add_pd(a, b);
    sub = _mm256_sub_pd(a, b);
    mul = _mm256_mul_pd(a, b);
    div = _mm256_div_pd(a, b);
    neg = _mm256_xor_pd(a, _mm256_set1_pd(-0.0));
    mul_add = _mm256_fmadd_pd(a, b, c);
    product_error = _mm256_fmsub_pd(a, b, c);
    remainder = _mm256_fnmadd_pd(a, b, c);
    round = _mm256_round_pd::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(a);
    sqrt = _mm256_sqrt_pd(a);
    abs = _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
    copysign = _mm256_or_pd(
        _mm256_andnot_pd(_mm256_set1_pd(-0.0), a), _mm256_and_pd(_mm256_set1_pd(-0.0), b));
    shift_52 = _mm256_castsi256_pd(_mm256_slli_epi64::<52>(_mm256_castpd_si256(a)));
    exponent_field = _mm256_or_pd(_mm256_castsi256_pd(_mm256_srli_epi64::<52>(_mm256_castpd_si256(a))), _mm256_set1_pd(FIELD));
    any = _mm256_movemask_pd(a) != 0;
    lookup = four_of(b, _mm256_srli_epi64::<49>(_mm256_castpd_si256(a)));
    less = _mm256_cmp_pd::<_CMP_LT_OQ>(a, b);
    equal = _mm256_cmp_pd::<_CMP_EQ_OQ>(a, b);
    select = _mm256_blendv_pd(c, b, a);
    alternated = _mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_slli_epi64::<63>(_mm256_castpd_si256(b))));
    larger = _mm256_max_pd(b, a);
    smaller = _mm256_min_pd(b, a);
}

/// Entries of a table of sixteen by the last four bits of each integer. By single loads: a gather is no faster, and on many
/// processors far slower.
///
/// SAFETY: only where the processor has AVX2; the pointer is that of the table.
#[inline]
#[target_feature(enable = "avx2")]
unsafe fn four_of(table: *const f64, places: __m256i) -> __m256d {
    let places = _mm256_and_si256(places, _mm256_set1_epi64x(15));
    let (low, high) = (_mm256_castsi256_si128(places), _mm256_extracti128_si256::<1>(places));
    let place = |half: __m128i| (_mm_cvtsi128_si64(half) as usize, _mm_extract_epi64::<1>(half) as usize);
    let ((i, j), (k, l)) = (place(low), place(high));
    // SAFETY: four bits name an entry.
    unsafe { _mm256_set_pd(*table.add(l), *table.add(k), *table.add(j), *table.add(i)) }
}
