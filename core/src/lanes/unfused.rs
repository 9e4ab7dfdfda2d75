//! The lane of width one on a processor without fused multiplication, by the table of the vector types: the operations of the
//! plain double, bit for bit. Long formulas are functions of their own, since this is for processors older than AVX2: inlined,
//! they were two fifths of the code of all kernels.
//!
//! SAFETY of every row here: a pointer is that of a slice with one double at least.

use super::lane::Lane;
use super::scalar::FIELD;
use super::vector::vector;

vector! {
    /// One double on a processor without fused multiplication.
    Unfused = 1 in f64, flags in bool, of a, b, c;
    apart = true;
    load = *a;
    store = *a = b;
    splat = a;
    add = a + b;
    sub = a - b;
    mul = a * b;
    div = a / b;
    neg = -a;
    mul_add = a * b + c;
    product_error = product_error(a, b, c);
    round = Lane::round(a);
    sqrt = f64::sqrt(a);
    abs = f64::abs(a);
    copysign = f64::copysign(a, b);
    shift_52 = f64::from_bits(a.to_bits() << 52);
    exponent_field = f64::from_bits((a.to_bits() >> 52) | FIELD.to_bits());
    any = a;
    lookup = *b.add((a.to_bits() >> 49) as usize % super::lane::PIECES);
    less = a < b;
    equal = a == b;
    select = if a { b } else { c };
}

/// That of the plain double, of factors of any size; compiled once.
#[inline(never)]
fn product_error(a: f64, b: f64, _product: f64) -> f64 {
    a.two_product(b).1
}
