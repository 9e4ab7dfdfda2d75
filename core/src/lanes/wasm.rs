//! WebAssembly with simd128: two lanes, without fused multiplication, so every row does what the plain double does.
//!
//! SAFETY of every intrinsic here: this file is compiled only where the module asks for simd128 as a whole.

use super::lane::Lane;
use super::scalar::{DOWN, FIELD, HUGE, UP, product_error, product_error_of_parts};
use super::vector::vector;
use core::arch::wasm32::*;

vector! {
    /// Two doubles of simd128.
    F64x2 = 2 in v128, flags in v128, of a, b, c;
    load = v128_load(a.cast());
    store = v128_store(a.cast(), b);
    splat = f64x2_splat(a);
    add = f64x2_add(a, b);
    sub = f64x2_sub(a, b);
    mul = f64x2_mul(a, b);
    div = f64x2_div(a, b);
    neg = f64x2_neg(a);
    mul_add = f64x2_add(f64x2_mul(a, b), c);
    product_error = scaled_product_error(a, b, c);
    product_error_in_range = product_error_of_parts(split(a), split(b), F64x2(c)).0;
    // The plain double adds and takes away a large number, which leaves no -0.
    round = f64x2_add(f64x2_nearest(a), f64x2_splat(0.0));
    sqrt = f64x2_sqrt(a);
    abs = f64x2_abs(a);
    copysign = v128_bitselect(b, a, i64x2_splat(i64::MIN));
    shift_52 = i64x2_shl(a, 52);
    exponent_field = v128_or(u64x2_shr(a, 52), f64x2_splat(FIELD));
    any = v128_any_true(a);
    lookup = two_of(b, u64x2_shr(a, 49));
    less = f64x2_lt(a, b);
    equal = f64x2_eq(a, b);
    select = v128_bitselect(b, c, a);
    alternated = v128_xor(a, i64x2_shl(b, 63));
    larger = f64x2_pmax(a, b);
    smaller = f64x2_pmin(a, b);
}

/// 26 bits and the rest, as exact as Veltkamp's splitting and an operation shorter: the bits are rounded as an integer.
#[inline(always)]
fn split(value: v128) -> (F64x2, F64x2) {
    const HALF: i64 = 1 << 26;
    let hi = F64x2(v128_and(i64x2_add(value, i64x2_splat(HALF)), i64x2_splat(-2 * HALF)));
    (hi, F64x2(value) - hi)
}

/// The product error of the plain double, scaled where it scales. Not `inline(always)`: its thirty operations are to
/// be simplified once, before they are spread over every formula.
#[inline]
fn scaled_product_error(a: v128, b: v128, product: v128) -> v128 {
    let (a, b, huge) = (F64x2(a), F64x2(b), F64x2::splat(HUGE));
    let (huge_a, huge_b) = (huge.less(a.abs()), huge.less(b.abs()));
    if v128_any_true(v128_or(huge_a, huge_b)) {
        return scaled(a, b, huge_a, huge_b).0;
    }
    product_error(a, b, F64x2(product)).0
}

/// Hardly ever.
#[cold]
#[inline(never)]
fn scaled(a: F64x2, b: F64x2, huge_a: v128, huge_b: v128) -> F64x2 {
    let (one, up, down) = (F64x2::splat(1.0), F64x2::splat(UP), F64x2::splat(DOWN));
    let (a, b) = (a * F64x2::select(huge_a, down, one), b * F64x2::select(huge_b, down, one));
    product_error(a, b, a * b) * F64x2::select(huge_a, up, one) * F64x2::select(huge_b, up, one)
}

/// Entries of a table of sixteen by the last four bits of each integer.
///
/// SAFETY: the pointer is that of the table.
#[inline(always)]
unsafe fn two_of(table: *const f64, places: v128) -> v128 {
    let (i, j) = (u64x2_extract_lane::<0>(places) % 16, u64x2_extract_lane::<1>(places) % 16);
    // SAFETY: four bits name an entry.
    unsafe { f64x2(*table.add(i as usize), *table.add(j as usize)) }
}
