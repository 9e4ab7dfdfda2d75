//! Exact scaling by powers of two, subnormal numbers included.

/// Exponent e with 2^e <= |value| < 2^(e+1), for finite non-zero values.
pub fn exponent(value: f64) -> i32 {
    let bits = (value.to_bits() >> 52 & 0x7ff) as i32;
    if bits == 0 { 63 - 1074 - (value.to_bits() << 1 >> 1).leading_zeros() as i32 } else { bits - 1023 }
}

/// 2^power for -1074 <= power <= 1023; 0 below, infinite above.
pub fn exp2(power: i32) -> f64 {
    match power {
        -1022..=1023 => f64::from_bits(((power + 1023) as u64) << 52),
        -1074..=-1023 => f64::from_bits(1 << (power + 1074)),
        1024.. => f64::INFINITY,
        _ => 0.0,
    }
}

/// value * 2^power with one rounding.
pub fn ldexp(value: f64, power: i32) -> f64 {
    match power {
        -1000..=1000 => value * exp2(power),
        // The first step is exact: it moves away from, or stays above, the subnormal numbers.
        1001.. => value * exp2(1000) * exp2((power - 1000).min(1023)),
        _ if value == 0.0 => value,
        _ => {
            let lift = exponent(value).max(-1022);
            let power = (power + lift).max(-1100);
            ldexp_normal(value * exp2(-lift.min(1000)) * exp2(-(lift - lift.min(1000))), power)
        }
    }
}

/// A value in [1, 2) times 2^power.
fn ldexp_normal(value: f64, power: i32) -> f64 {
    if power >= -1000 { value * exp2(power) } else { value * exp2(-500) * exp2((power + 500).max(-1074)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_exact() {
        for (value, e) in [(1.0, 0), (1.5, 0), (0.75, -1), (5e-324, -1074), (2.5e-308, -1022), (1e308, 1023)] {
            assert_eq!(exponent(value), e);
            assert_eq!(exponent(-value), e);
        }
        assert_eq!(ldexp(5e-324, 1074), 1.0);
        assert_eq!(ldexp(1.0, -1074), 5e-324);
        assert_eq!(ldexp(1e308, -2100), 0.0);
        assert_eq!(ldexp(5e-324, 2097), exp2(1023));
        assert_eq!(ldexp(1.5, 1023), 1.5 * exp2(1023));
        assert_eq!(ldexp(f64::MAX, -1030), f64::MAX * exp2(-500) * exp2(-530));
    }
}
