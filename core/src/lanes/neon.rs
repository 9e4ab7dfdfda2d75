//! aarch64: two lanes of NEON, which every such processor has, fused multiplication included.
//!
//! SAFETY of every intrinsic here: NEON belongs to the target.

use super::fused::Fused;
use super::lane::Kernel;
use super::pair::Pair;
use super::scalar::FIELD;
use super::vector::vector;
use core::arch::aarch64::*;

/// Whether `Plain` is the only set, known when compiled.
pub const ONLY_PLAIN: bool = false;

/// How many of `InstructionSet` this processor has.
pub fn instruction_sets() -> usize {
    2
}

/// Width one.
#[inline]
pub fn single_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Fused>()
}

/// Width four.
#[inline]
pub fn four_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Pair<F64x2>>()
}

/// Width four.
#[inline]
pub fn wide_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Pair<F64x2>>()
}

/// Not on this processor, and never in use there.
pub fn four_avx512<K: Kernel>(kernel: K) -> K::Output {
    four_fused(kernel)
}

/// Not on this processor, and never in use there.
pub fn wide_avx512<K: Kernel>(kernel: K) -> K::Output {
    wide_fused(kernel)
}

/// Not asked for here.
#[inline(always)]
pub fn prefetch(_place: *const f64) {}

vector! {
    /// Two doubles of NEON.
    F64x2 = 2 in float64x2_t, flags in uint64x2_t, of a, b, c;
    load = vld1q_f64(a);
    store = vst1q_f64(a, b);
    splat = vdupq_n_f64(a);
    add = vaddq_f64(a, b);
    sub = vsubq_f64(a, b);
    mul = vmulq_f64(a, b);
    div = vdivq_f64(a, b);
    neg = vnegq_f64(a);
    mul_add = vfmaq_f64(c, a, b);
    product_error = vfmaq_f64(vnegq_f64(c), a, b);
    remainder = vfmsq_f64(c, a, b);
    round = vrndnq_f64(a);
    sqrt = vsqrtq_f64(a);
    abs = vabsq_f64(a);
    copysign = vbslq_f64(vdupq_n_u64(1 << 63), b, a);
    shift_52 = vreinterpretq_f64_u64(vshlq_n_u64::<52>(vreinterpretq_u64_f64(a)));
    exponent_field = vreinterpretq_f64_u64(vorrq_u64(
        vshrq_n_u64::<52>(vreinterpretq_u64_f64(a)), vdupq_n_u64(FIELD.to_bits())));
    any = vmaxvq_u32(vreinterpretq_u32_u64(a)) != 0;
    lookup = two_of(b, vshrq_n_u64::<49>(vreinterpretq_u64_f64(a)));
    less = vcltq_f64(a, b);
    equal = vceqq_f64(a, b);
    select = vbslq_f64(a, b, c);
}

/// Entries of a table of sixteen by the last four bits of each integer.
///
/// SAFETY: the pointer is that of the table.
#[inline]
unsafe fn two_of(table: *const f64, places: uint64x2_t) -> float64x2_t {
    // SAFETY: NEON is there where this is compiled, and four bits name an entry.
    unsafe {
        let (i, j) = (vgetq_lane_u64::<0>(places) % 16, vgetq_lane_u64::<1>(places) % 16);
        vsetq_lane_f64::<1>(*table.add(j as usize), vdupq_n_f64(*table.add(i as usize)))
    }
}
