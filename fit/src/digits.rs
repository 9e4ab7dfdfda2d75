//! Numbers as they are written in sentences. On a page JavaScript writes them, after the bits and the form that are left in their place
//! (lab/src/model/digits.ts): Rust's digits would be 18 kB of code to load.

use core::fmt;

/// What a page loads is short.
const COMPACT: bool = cfg!(target_arch = "wasm32");

/// A number in a sentence.
pub(crate) struct Shown(pub f64);

/// A mark, a letter for the form, two digits for its precision, and sixteen for the bits.
fn marked(f: &mut fmt::Formatter<'_>, form: char, value: f64) -> fmt::Result {
    let precision = f.precision().map_or(99, |digits| digits.min(98));
    let bits = value.to_bits();
    write!(f, "\u{2}{form}{precision:02}{bits:016x}")
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if COMPACT { marked(f, 'f', self.0) } else { fmt::Display::fmt(&self.0, f) }
    }
}

impl fmt::Debug for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if COMPACT { marked(f, 'd', self.0) } else { fmt::Debug::fmt(&self.0, f) }
    }
}

impl fmt::LowerExp for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if COMPACT { marked(f, 'e', self.0) } else { fmt::LowerExp::fmt(&self.0, f) }
    }
}

/// So many digits after the first, without zeros at the end and without an exponent: of `1.230e-4`, 0.000123.
pub(crate) fn plain(value: f64, digits: usize) -> String {
    if COMPACT {
        return format!("\u{2}p{digits:02}{:016x}", value.to_bits());
    }
    let text = format!("{value:.digits$e}");
    let Some((mantissa, exponent)) = text.split_once('e') else { return text };
    let (sign, mantissa) = mantissa.strip_prefix('-').map_or(("", mantissa), |rest| ("-", rest));
    let kept = mantissa.replace('.', "");
    let kept = kept.trim_end_matches('0');
    let exponent: i32 = exponent.parse().unwrap_or_default();
    let before = usize::try_from(exponent + 1).unwrap_or(0);
    let zeros = |count: usize| "0".repeat(count);
    match kept.len() {
        0 => format!("{sign}0"),
        length if before >= length => format!("{sign}{kept}{}", zeros(before - length)),
        _ if before > 0 => {
            let (whole, rest) = kept.split_at(before);
            format!("{sign}{whole}.{rest}")
        }
        _ => format!("{sign}0.{}{kept}", zeros(usize::try_from(-1 - exponent).unwrap_or(0))),
    }
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn digits_are_those_of_the_nearest_double() {
        for value in
            [0.0, 1.0, -1.0, 9.999, 9.996, 0.5, 1e-4, 123456.0, 9.876e22, 1.5e300, -3.04e-7, 100.0, 0.1]
        {
            for digits in [2, 5] {
                let rounded: f64 = format!("{value:.digits$e}").parse().unwrap();
                assert_eq!(plain(value, digits), rounded.to_string(), "{value} {digits}");
            }
        }
        // The spoiled sibling: rounded first, and not so.
        assert_ne!(plain(1.236, 2), 1.236f64.to_string());
        assert_eq!([plain(f64::NAN, 2), plain(f64::NEG_INFINITY, 2)], ["NaN", "-inf"]);
    }
}
