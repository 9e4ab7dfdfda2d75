//! Exact scaling by powers of two, subnormal numbers included.

/// Exponent e with 2^e <= |value| < 2^(e+1), for finite non-zero values.
pub fn exponent(value: f64) -> i32 {
    let bits = (value.to_bits() >> 52 & 0x7ff) as i32;
    if bits == 0 { 63 - 1074 - (value.to_bits() << 1 >> 1).leading_zeros() as i32 } else { bits - 1023 }
}

/// |value| over its power of two, in [1, 2), for finite non-zero values.
pub fn mantissa(value: f64) -> f64 {
    ldexp(value.abs(), -exponent(value))
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
    if (-1022..=1023).contains(&power) {
        return value * exp2(power);
    }
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let e = exponent(value);
    let half = e / 2;
    let mantissa = value * exp2(-half) * exp2(half - e);
    match e.saturating_add(power) {
        // Below the smallest subnormal number half of it decides the rounding.
        target @ ..-1074 => mantissa * if target == -1075 { 0.5 } else { 0.125 } * exp2(-1074),
        target => mantissa * exp2(target),
    }
}

/// Powers of two that a double-double can carry beside its digits.
pub const CARRIED: i32 = 300;

/// The part of a power of two that a double-double carries, and the part that is kept separately.
pub fn carried(power: i32) -> (i32, i32) {
    let inside = power.clamp(-CARRIED, CARRIED);
    (inside, power - inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_exact() {
        for (value, e) in [(1.0, 0), (1.5, 0), (0.75, -1), (5e-324, -1074), (2.5e-308, -1022), (1e308, 1023)]
        {
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
