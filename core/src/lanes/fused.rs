//! The lane of width one on a processor with fused multiplication, by the table of the vector types.
//!
//! SAFETY of every row here: a pointer is that of a slice with one double at least.

use super::scalar::FIELD;
use super::vector::vector;

vector! {
    /// One double on a processor with fused multiplication.
    Fused = 1 in f64, flags in bool, of a, b, c;
    load = *a;
    store = *a = b;
    splat = a;
    add = a + b;
    sub = a - b;
    mul = a * b;
    div = a / b;
    neg = -a;
    mul_add = f64::mul_add(a, b, c);
    product_error = f64::mul_add(a, b, -c);
    remainder = f64::mul_add(-a, b, c);
    round = f64::round_ties_even(a);
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
