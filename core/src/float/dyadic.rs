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
    /// Sets the word at the end of `length` words.
    fn push(&mut self, length: usize, word: u64) {
        match self {
            Words::Short(words) if length < SHORT => words[length] = word,
            Words::Short(words) => {
                let mut long = words.to_vec();
                long.push(word);
                *self = Words::Long(long);
            }
            Words::Long(words) => {
                words.truncate(length);
                words.push(word);
            }
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
    /// Without the zero words at either end.
    fn trimmed(negative: bool, power: i32, length: usize, mut words: Words) -> Dyadic {
        let all = &mut words.all_mut()[..length];
        let Some(last) = all.iter().rposition(|word| *word != 0) else { return Dyadic::ZERO };
        let (high, mut low) = (last + 1, 0);
        if all[0] == 0 {
            low = all.iter().position(|word| *word != 0).unwrap_or(last);
            all.copy_within(low..high, 0);
        }
        Dyadic { negative, power: power + 64 * low as i32, length: high - low, words }
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
        const HALF_WORD: f64 = 4_294_967_296.0;
        // Three words hold at least 129 bits; two doubles hold a word.
        let low = self.length.saturating_sub(3);
        let mut value = Dd::ZERO;
        for word in self.words()[low..].iter().rev() {
            let word = Dd::sum((word >> 32) as f64 * HALF_WORD, (word & 0xffff_ffff) as f64);
            value = value.scale(HALF_WORD * HALF_WORD) + word;
        }
        let value = Scaled::new(value, self.power + 64 * low as i32);
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
        let mut words = Words::zeros(length);
        let all = &mut words.all_mut()[..length];
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
        Dyadic::trimmed(a.negative != below, power, length, words)
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
    let length = a.length + b.length;
    let mut words = Words::zeros(length);
    let all = &mut words.all_mut()[..length];
    for (i, x) in a.words().iter().enumerate() {
        let mut carry = 0u128;
        for (place, y) in all[i..].iter_mut().zip(b.words()) {
            let sum = u128::from(*x) * u128::from(*y) + u128::from(*place) + carry;
            (*place, carry) = (sum as u64, sum >> 64);
        }
        all[i + b.length] = carry as u64;
    }
    Dyadic::trimmed(a.negative != b.negative, a.power + b.power, length, words)
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
    fn mul(mut self, factor: f64) -> Dyadic {
        let (word, power) = odd_mantissa(factor);
        if self.length == 0 || word == 0 {
            return Dyadic::ZERO;
        }
        let mut carry = 0u128;
        for place in &mut self.words.all_mut()[..self.length] {
            let sum = u128::from(*place) * u128::from(word) + carry;
            (*place, carry) = (sum as u64, sum >> 64);
        }
        if carry != 0 {
            self.words.push(self.length, carry as u64);
            self.length += 1;
        }
        // An odd factor leaves no zero word at the lower end.
        Dyadic { negative: self.negative != (factor < 0.0), power: self.power + power, ..self }
    }
}

impl Mul<f64> for &Dyadic {
    type Output = Dyadic;
    fn mul(self, factor: f64) -> Dyadic {
        self.clone() * factor
    }
}

impl Neg for Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic { negative: !self.negative && self.length > 0, ..self }
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
