//! Numbers in texts: the nearest double, as the standard library reads it. On a page they have a short code of their own, in whole
//! numbers: the library's brings a table of powers of five, 13 kB to load.

/// What a page loads is short.
const COMPACT: bool = cfg!(target_arch = "wasm32");

/// The double nearest to what a text says; none where it is no number.
pub(crate) fn number(text: &str) -> Option<f64> {
    if COMPACT { read(text) } else { text.parse().ok() }
}

/// A sign, then digits with a point at most, then an exponent; or a word for what is not finite.
fn read(text: &str) -> Option<f64> {
    let (minus, rest) = match text.as_bytes() {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        all => (false, all),
    };
    let is = |word: &str| rest.eq_ignore_ascii_case(word.as_bytes());
    let size = match () {
        () if is("inf") || is("infinity") => f64::INFINITY,
        () if is("nan") => f64::NAN,
        () => Decimal::of(rest)?.nearest(),
    };
    Some(if minus { -size } else { size })
}

/// Digits beyond these cannot tell a double from its neighbour, but for whether there are any.
const MOST: usize = 800;

/// Digits that 64 bits hold.
const SHORT: usize = 19;

/// Digits without zeros before them, and the power of ten of the last.
#[derive(Default)]
struct Decimal {
    count: usize,
    /// The first of them as a number.
    first: u64,
    /// Those after it.
    others: Vec<u8>,
    exponent: i64,
}

impl Decimal {
    fn of(text: &[u8]) -> Option<Decimal> {
        let mut found = Decimal::default();
        let (mut some, mut point, mut more) = (false, false, false);
        for (at, byte) in text.iter().enumerate() {
            match byte {
                b'0'..=b'9' => {
                    some = true;
                    let digit = byte - b'0';
                    if found.count < MOST {
                        found.exponent -= i64::from(point);
                        found.push(digit);
                    } else {
                        found.exponent += i64::from(!point);
                        more |= digit != 0;
                    }
                }
                b'.' if !point => point = true,
                b'e' | b'E' if some => {
                    found.exponent += power(&text[at + 1..])?;
                    break;
                }
                _ => return None,
            }
        }
        if more {
            found.push(1);
            found.exponent -= 1;
        }
        some.then_some(found)
    }

    fn push(&mut self, digit: u8) {
        if digit == 0 && self.count == 0 {
            return;
        }
        if self.count < SHORT {
            self.first = 10 * self.first + u64::from(digit);
        } else {
            self.others.push(digit);
        }
        self.count += 1;
    }

    fn nearest(&self) -> f64 {
        let Decimal { count, first, others, exponent } = self;
        let scale = *count as i64 + exponent;
        if *count == 0 || scale < -330 {
            return 0.0;
        }
        if scale > 310 {
            return f64::INFINITY;
        }
        let tens = exponent.unsigned_abs() as u32;
        if others.is_empty() && tens <= 19 {
            return nearest_short(*first, tens, *exponent < 0);
        }
        let mut above = Whole(Vec::new());
        above.grow(0, (first >> 32) as u32);
        above.grow(1 << 16, 0);
        above.grow(1 << 16, *first as u32);
        for digit in others {
            above.grow(10, u32::from(*digit));
        }
        let mut below = Whole(vec![1]);
        for _ in 0..tens {
            if *exponent < 0 { &mut below } else { &mut above }.grow(10, 0);
        }
        quotient(above, below)
    }
}

/// The whole number behind an `e`, within what a double can have.
fn power(text: &[u8]) -> Option<i64> {
    let (minus, digits) = match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        all => (false, all),
    };
    let size = |size: i64, byte: &u8| {
        byte.is_ascii_digit().then(|| (10 * size + i64::from(byte - b'0')).min(1 << 40))
    };
    let size = (!digits.is_empty()).then(|| digits.iter().try_fold(0, size))??;
    Some(if minus { -size } else { size })
}

/// Where digits and power of ten are whole numbers of 64 bits.
fn nearest_short(whole: u64, tens: u32, below: bool) -> f64 {
    let power = 10u64.pow(tens);
    // Both are doubles, so one rounding is all there is.
    if whole <= 1 << 53 {
        return if below { whole as f64 / power as f64 } else { whole as f64 * power as f64 };
    }
    if !below {
        return (u128::from(whole) * u128::from(power)) as f64;
    }
    // 62 bits at least, and whether something is left, which is more than a double and half of its last place.
    let shift = whole.leading_zeros() + 63;
    let above = u128::from(whole) << shift;
    let (bits, rest) = (above / u128::from(power), above % u128::from(power));
    (bits | u128::from(rest != 0)) as f64 * two_to(-(shift as i32))
}

/// A whole number: 32 bits at each place, the lowest first, and no zero at the end.
struct Whole(Vec<u32>);

impl Whole {
    fn bits(&self) -> i32 {
        self.0.last().map_or(0, |last| 32 * self.0.len() as i32 - last.leading_zeros() as i32)
    }

    /// Times a factor, plus a number.
    fn grow(&mut self, factor: u32, plus: u32) {
        let mut carry = u64::from(plus);
        for place in &mut self.0 {
            carry += u64::from(*place) * u64::from(factor);
            *place = carry as u32;
            carry >>= 32;
        }
        if carry != 0 {
            self.0.push(carry as u32);
        }
    }

    /// Times 2 so many times.
    fn double(&mut self, times: i32) {
        self.0.splice(0..0, core::iter::repeat_n(0, times as usize / 32));
        self.grow(1 << (times % 32), 0);
    }

    /// Less another one, if that is not larger.
    fn reduce(&mut self, other: &Whole) -> bool {
        let own = self.0.iter().rev();
        if self.0.len() < other.0.len() || self.0.len() == other.0.len() && own.lt(other.0.iter().rev()) {
            return false;
        }
        let mut borrow = 0i64;
        for (i, place) in self.0.iter_mut().enumerate() {
            borrow += i64::from(*place) - other.0.get(i).map_or(0, |place| i64::from(*place));
            *place = borrow as u32;
            borrow >>= 32;
        }
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
        true
    }
}

/// The double nearest to the quotient of two whole numbers that are not 0, by long division.
fn quotient(mut above: Whole, mut below: Whole) -> f64 {
    let apart = above.bits() - below.bits();
    // Of the same length: the first bit is that of 1, or the next one is.
    if apart > 0 {
        below.double(apart)
    } else {
        above.double(-apart)
    }
    let mut bits = 0u64;
    for _ in 0..64 {
        bits = bits << 1 | u64::from(above.reduce(&below));
        above.double(1);
    }
    // The last bit has 2^last; a double has 53 bits, and none below 2^-1074.
    let last = apart - 63;
    let first = last + 63 - bits.leading_zeros() as i32;
    let cut = (first - 52).max(-1074) - last;
    if cut > 64 {
        return 0.0;
    }
    let wide = u128::from(bits);
    let (kept, rest, half) = (wide >> cut, wide & ((1 << cut) - 1), 1u128 << (cut - 1));
    let up = rest > half || rest == half && (!above.0.is_empty() || kept & 1 == 1);
    let kept = (kept as u64 + u64::from(up)) as f64;
    let exponent = last + cut;
    if exponent > 971 { f64::INFINITY } else { kept * two_to(exponent) }
}

/// 2^exponent, for -1074 to 1023.
fn two_to(exponent: i32) -> f64 {
    f64::from_bits(if exponent < -1022 { 1 << (exponent + 1074) } else { ((exponent + 1023) as u64) << 52 })
}

#[cfg(test)]
mod tests {
    use super::read;

    fn random(state: &mut u64) -> u64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 32) ^ state.rotate_left(17)
    }

    fn agrees(text: &str) {
        let wanted: Option<f64> = text.parse().ok();
        let same = match (read(text), wanted) {
            (Some(a), Some(b)) => a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
            (a, b) => a.is_none() && b.is_none(),
        };
        assert!(same, "{text}: {:?}, not {wanted:?}", read(text));
    }

    #[test]
    fn doubles_come_back() {
        let mut state = 1;
        for _ in 0..100_000 {
            let value = f64::from_bits(random(&mut state));
            agrees(&format!("{value}"));
            agrees(&format!("{value:e}"));
            let digits = random(&mut state) as usize % 25;
            agrees(&format!("{value:.digits$e}"));
            let usual = (value.to_bits() >> 11) as f64 * 1e-12;
            agrees(&format!("{usual:.digits$}"));
        }
    }

    #[test]
    fn digits_of_any_number_and_place() {
        let mut state = 2;
        for _ in 0..100_000 {
            let count = 1 + random(&mut state) % 40;
            let mut text = String::new();
            let point = random(&mut state) % 40;
            for place in 0..count {
                if place == point {
                    text.push('.');
                }
                text.push(char::from(b'0' + (random(&mut state) % 10) as u8));
            }
            if random(&mut state).is_multiple_of(2) {
                text += &format!("e{}", random(&mut state) as i64 % 360);
            }
            agrees(&text);
        }
    }

    /// Exactly between two doubles, and a little beside: the neighbours and their middle have up to 770 digits.
    #[test]
    fn middles_of_doubles() {
        let mut state = 3;
        for _ in 0..2_000 {
            let value = f64::from_bits(random(&mut state) >> 1);
            if !value.is_finite() || value == f64::MAX {
                continue;
            }
            // Both of them exactly, and half their sum in decimals.
            let [low, high] = [value, value.next_up()].map(|each| format!("{each:.1080}"));
            let middle = middle(&low, &high);
            agrees(&middle);
            agrees(&format!("{middle}1"));
            agrees(&format!("{middle}{}1", "0".repeat(900)));
            let below = middle.trim_end_matches('0');
            agrees(&below[..below.len() - 1]);
        }
        for text in [
            "179769313486231580793728971405303415079934132710037826936173778980444968292764750946649017977587207096330286416692887910946555547851940402630657488671505820681908902000708383676273854845817711531764475730270069855571366959622842914819860834936475292719074168444365510704342711559699508093042880",
            "179769313486231580793728971405303415079934132710037826936173778980444968292764750946649017977587207096330286416692887910946555547851940402630657488671505820681908902000708383676273854845817711531764475730270069855571366959622842914819860834936475292719074168444365510704342711559699508093042879.9",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "4.9e-324",
            "2.2250738585072011e-308",
            "2.2250738585072012e-308",
        ] {
            agrees(text);
        }
    }

    /// Half the sum of two decimal texts of the same number of decimals.
    fn middle(low: &str, high: &str) -> String {
        let whole = high.len();
        let (low, high) = (format!("{low:0>whole$}0"), format!("{high}0"));
        let mut sum = vec![0u8; whole + 2];
        let mut carry = 0;
        for (i, (a, b)) in low.bytes().zip(high.bytes()).enumerate().rev() {
            if a == b'.' {
                sum[i + 1] = b'.';
                continue;
            }
            let digits = a - b'0' + (b - b'0') + carry;
            (sum[i + 1], carry) = (digits % 10, digits / 10);
        }
        sum[0] = carry;
        let mut rest = 0;
        for digit in &mut sum {
            if *digit != b'.' {
                let now = 10 * rest + *digit;
                (*digit, rest) = (b'0' + now / 2, now % 2);
            }
        }
        String::from_utf8(sum).unwrap()
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in [
            "", "+", "-", ".", "+.", "e5", ".e5", "1e", "1e+", "1e-", "1.2.3", "1,5", " 1", "1 ", "0x10",
            "1_000", "١", "1.", ".5", "-.5", "+1.e3", "1E5", "1e0005", "00.00", "-0",
            "0e99999999999999999999", "1e99999999999999999999", "1e-99999999999999999999", "inf",
            "-Infinity", "+nan", "NaN", "-nan", "infi", "in", "1e400", "1e-400", "--1", "1e5.0",
        ] {
            agrees(text);
        }
        let mut state = 4;
        for _ in 0..100_000 {
            let length = random(&mut state) % 9;
            let text: String =
                (0..length).map(|_| char::from(b"0159.eE+-n"[random(&mut state) as usize % 10])).collect();
            agrees(&text);
        }
    }
}
