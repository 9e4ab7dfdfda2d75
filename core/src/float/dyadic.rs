//! Whole numbers times powers of two, of any length: sums and products of doubles without any rounding, for the signs
//! that decide what a motion does and for what is left where terms cancel.
//!
//! Most numbers are a few words long and stand in the value itself. Only those whose terms lie more than a thousand
//! powers of two apart use the heap.

use super::Dd;
use super::scaled::Scaled;
use core::ops::{Add, Mul, Neg, Sub};

/// Words that stand in the value itself.
const SHORT: usize = 16;

/// words * 2^power, least significant word first, without zero words at either end.
#[derive(Clone, Debug)]
pub(crate) struct Dyadic {
    negative: bool,
    power: i32,
    length: usize,
    words: Words,
}

#[derive(Clone, Debug)]
enum Words {
    Short([u64; SHORT]),
    Long(Vec<u64>),
}

impl Words {
    fn zeros(length: usize) -> Words {
        if length <= SHORT { Words::Short([0; SHORT]) } else { Words::Long(vec![0; length]) }
    }
    fn all(&self) -> &[u64] {
        match self {
            Words::Short(words) => words,
            Words::Long(words) => words,
        }
    }
    fn all_mut(&mut self) -> &mut [u64] {
        match self {
            Words::Short(words) => words,
            Words::Long(words) => words,
        }
    }
}

impl Dyadic {
    pub const ZERO: Dyadic = Dyadic { negative: false, power: 0, length: 0, words: Words::Short([0; SHORT]) };

    fn words(&self) -> &[u64] {
        &self.words.all()[..self.length]
    }
    /// Zeros, to be filled and trimmed in place: a number is a few cache lines long, and a copy costs as much as a product.
    fn zeros(negative: bool, power: i32, length: usize) -> Dyadic {
        Dyadic { negative, power, length, words: Words::zeros(length) }
    }
    fn words_mut(&mut self) -> &mut [u64] {
        &mut self.words.all_mut()[..self.length]
    }
    /// Leaves out the zero words at either end.
    fn trim(&mut self) {
        let words = self.words_mut();
        let Some(last) = words.iter().rposition(|word| *word != 0) else {
            (self.negative, self.power, self.length) = (false, 0, 0);
            return;
        };
        let mut low = 0;
        if words[0] == 0 {
            low = words.iter().position(|word| *word != 0).unwrap_or(last);
            words.copy_within(low..=last, 0);
        }
        self.power += 64 * low as i32;
        self.length = last + 1 - low;
    }
    /// +1, 0 or -1.
    pub fn sign(&self) -> i32 {
        match (self.length == 0, self.negative) {
            (true, _) => 0,
            (_, true) => -1,
            _ => 1,
        }
    }
    /// Rounded once, to a double-double of any range.
    pub fn to_scaled(&self) -> Scaled {
        let words = self.words();
        let [.., top] = words else { return Scaled::ZERO };
        // The 128 bits from the first one on, of which 53 are the high word, and the others rounded to 53 the low word.
        let word = |back: usize| if back < words.len() { words[words.len() - 1 - back] } else { 0 };
        let zeros = top.leading_zeros();
        let bits = (u128::from(*top) << 64 | u128::from(word(1))) << zeros;
        let bits = bits | (u128::from(word(2)) << zeros) >> 64;
        let (high, rest) = ((bits >> 75) as u64, bits & ((1 << 75) - 1));
        let low = ((rest + (1 << 21)) >> 22) as u64;
        const LAST: f64 = 1.0 / (1u64 << 53) as f64;
        let value = Dd::ordered_sum(high as f64, low as f64 * LAST);
        // The last bit of the high word.
        let power = self.power + 64 * (words.len() as i32 - 1) + 11 - zeros as i32;
        let value = Scaled::new(value, power);
        if self.negative { -value } else { value }
    }
    /// The square.
    pub fn square(&self) -> Dyadic {
        self * self
    }

    /// a + b, or a - b.
    fn sum(a: &Dyadic, b: &Dyadic, minus: bool) -> Dyadic {
        let negative = b.negative != minus;
        if a.length == 0 {
            return Dyadic { negative: negative && b.length > 0, ..b.clone() };
        }
        let power = a.power.min(b.power);
        let end = |x: &Dyadic| ((x.power - power) / 64) as usize + x.length + 2;
        let length = end(a).max(end(b));
        let mut found = Dyadic::zeros(a.negative, power, length);
        let all = found.words_mut();
        add_shifted(all, a.words(), a.power - power, false);
        let subtracted = a.negative != negative;
        add_shifted(all, b.words(), b.power - power, subtracted);
        // The two words above both numbers are free: the top bit tells a difference below 0.
        let below = all[length - 1] >> 63 == 1;
        if below {
            let mut carry = true;
            for word in all.iter_mut() {
                (*word, carry) = (!*word).overflowing_add(u64::from(carry));
            }
        }
        found.negative = a.negative != below;
        found.trim();
        found
    }

    /// Times a double.
    fn times(&self, factor: f64) -> Dyadic {
        let (word, power) = odd_mantissa(factor);
        if self.length == 0 || word == 0 {
            return Dyadic::ZERO;
        }
        let negative = self.negative != (factor < 0.0);
        let mut found = Dyadic::zeros(negative, self.power + power, self.length + 1);
        let mut carry = 0u128;
        for (place, x) in found.words_mut().iter_mut().zip(self.words().iter().chain([&0])) {
            let sum = u128::from(*x) * u128::from(word) + carry;
            (*place, carry) = (sum as u64, sum >> 64);
        }
        // An odd factor leaves no zero word at the lower end.
        if found.words()[self.length] == 0 {
            found.length = self.length;
        }
        found
    }
}

/// Adds a number moved up by `shift` bits, or subtracts it in two's complement.
fn add_shifted(sum: &mut [u64], words: &[u64], shift: i32, subtracted: bool) {
    let (start, bits) = ((shift / 64) as usize, shift % 64);
    let mut above = 0;
    let mut carry = false;
    for (i, place) in sum[start..].iter_mut().enumerate() {
        if i > words.len() && !carry {
            return;
        }
        let word = words.get(i).copied().unwrap_or(0);
        let moved = word << bits | above;
        above = if bits == 0 { 0 } else { word >> (64 - bits) };
        let (part, first, second);
        if subtracted {
            (part, first) = place.overflowing_sub(moved);
            (*place, second) = part.overflowing_sub(u64::from(carry));
        } else {
            (part, first) = place.overflowing_add(moved);
            (*place, second) = part.overflowing_add(u64::from(carry));
        }
        carry = first | second;
    }
}

/// The mantissa of a finite double as an odd number (0 for 0), and its power of two.
fn odd_mantissa(value: f64) -> (u64, i32) {
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    let word = if exponent == 0 { fraction } else { fraction | 1 << 52 };
    let spare = if word == 0 { 0 } else { word.trailing_zeros() };
    (word >> spare, exponent.max(1) - 1075 + spare as i32)
}

impl From<f64> for Dyadic {
    fn from(value: f64) -> Dyadic {
        let (word, power) = odd_mantissa(value);
        if word == 0 {
            return Dyadic::ZERO;
        }
        let mut words = [0; SHORT];
        words[0] = word;
        Dyadic { negative: value < 0.0, power, length: 1, words: Words::Short(words) }
    }
}

/// The sum of products of doubles, rounded once: zero only if it is exactly zero.
pub(crate) fn sum_of_products(products: &[&[f64]]) -> Scaled {
    let product =
        |factors: &&[f64]| factors.iter().fold(Dyadic::from(1.0), |product, factor| product * *factor);
    products.iter().fold(Dyadic::ZERO, |sum, factors| sum + product(factors)).to_scaled()
}

fn product(a: &Dyadic, b: &Dyadic) -> Dyadic {
    let mut found = Dyadic::zeros(a.negative != b.negative, a.power + b.power, a.length + b.length);
    let all = found.words_mut();
    for (i, x) in a.words().iter().enumerate() {
        let mut carry = 0u128;
        for (place, y) in all[i..].iter_mut().zip(b.words()) {
            let sum = u128::from(*x) * u128::from(*y) + u128::from(*place) + carry;
            (*place, carry) = (sum as u64, sum >> 64);
        }
        all[i + b.length] = carry as u64;
    }
    found.trim();
    found
}

/// An operator of values and references alike.
macro_rules! operator {
    ($trait:ident $method:ident: $a:ident, $b:ident => $value:expr) => {
        operator!(@ $trait $method $a $b $value; Dyadic, Dyadic; Dyadic, &Dyadic; &Dyadic, Dyadic; &Dyadic, &Dyadic);
    };
    (@ $trait:ident $method:ident $a:ident $b:ident $value:expr; $($left:ty, $right:ty);*) => {$(
        impl $trait<$right> for $left {
            type Output = Dyadic;
            fn $method(self, other: $right) -> Dyadic {
                let ($a, $b): (&Dyadic, &Dyadic) = (&self, &other);
                $value
            }
        }
    )*};
}
operator!(Add add: a, b => Dyadic::sum(a, b, false));
operator!(Sub sub: a, b => Dyadic::sum(a, b, true));
operator!(Mul mul: a, b => product(a, b));

impl Mul<f64> for Dyadic {
    type Output = Dyadic;
    fn mul(self, factor: f64) -> Dyadic {
        self.times(factor)
    }
}

impl Mul<f64> for &Dyadic {
    type Output = Dyadic;
    fn mul(self, factor: f64) -> Dyadic {
        self.times(factor)
    }
}

impl Neg for Dyadic {
    type Output = Dyadic;
    fn neg(mut self) -> Dyadic {
        self.negative = !self.negative && self.length > 0;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(value: f64) -> Dyadic {
        Dyadic::from(value)
    }

    #[test]
    fn nothing_is_lost() {
        let [a, b, tiny, huge] = [1.0 + f64::EPSILON, 1.0 - f64::EPSILON, 5e-324, f64::MAX].map(of);
        let rest = &a * &b - of(1.0);
        assert_eq!(rest.to_scaled().value(), -f64::EPSILON * f64::EPSILON);
        let sum = huge.square() + &tiny - huge.square();
        assert_eq!(sum.to_scaled().value(), 5e-324);
        assert_eq!((&sum - &tiny).sign(), 0);
        assert_eq!((of(-7.25) * 2.0).to_scaled().value(), -14.5);
        assert_eq!((of(3.0) - of(5.0)).to_scaled().value(), -2.0);
        assert_eq!((of(0.0) + of(-0.75)).sign(), -1);
        assert_eq!((of(0.0) - of(0.75)).to_scaled().value(), -0.75);
        assert_eq!((of(-0.5) - of(-0.5)).sign(), 0);
        let long = (&a * &a * &a).square() * 3.0;
        assert_eq!((&long - &long * 1.0).sign(), 0);
        assert_eq!((&long + &tiny - &long).to_scaled().value(), 5e-324);
        assert_eq!((&tiny - &long + long).to_scaled().value(), 5e-324);
    }

    /// Sums of powers of two far apart, whose high and low words are known.
    #[test]
    fn doubles_of_doubles_keep_all_bits() {
        for (k, n) in [(1, 53), (10, 64), (52, 60), (63, 105), (64, 80), (100, 104)] {
            let [first, second] = [k, n].map(|k: i32| 2f64.powi(-k));
            let exact = of(1.0) + of(first) + of(second);
            let found = exact.to_scaled().to_dd();
            assert_eq!((exact - of(found.hi) - of(found.lo)).sign(), 0, "{k} {n}");
            let minus = of(first) - of(1.0) - of(second);
            let found = minus.to_scaled().to_dd();
            assert_eq!((minus - of(found.hi) - of(found.lo)).sign(), 0, "{k} {n}");
        }
        let thirds = of(1.0 / 3.0).square() * of(1.0 / 3.0).square();
        let rest = &thirds - of(thirds.to_scaled().to_dd().hi) - of(thirds.to_scaled().to_dd().lo);
        assert!(rest.to_scaled().abs().value() < thirds.to_scaled().value() * 2f64.powi(-106));
    }

    #[test]
    fn sums_of_products_are_rounded_once() {
        let sum = |products: &[&[f64]]| sum_of_products(products).value();
        assert_eq!(sum(&[&[3.0, 0.5], &[-1.5]]), 0.0);
        let huge = [-1e300, 1e300, 1e300, 1e300, 1e300, 1e300, 1e300, 1e300];
        assert_eq!(sum(&[&[1e300; 8], &[5e-324], &huge]), 5e-324);
        assert_eq!(sum(&[&[-0.1, 10.0], &[1.0]]), -f64::EPSILON / 4.0);
        assert_eq!(sum(&[&[5e-324; 8], &[-5e-324, 3.0]]), -1.5e-323);
        assert_eq!(sum(&[&[0.0, 1.0], &[]]), 1.0);
        let least = sum_of_products(&[&[5e-324; 8]]);
        assert_eq!(least.shift(1074 * 8).value(), 1.0);
    }
}
