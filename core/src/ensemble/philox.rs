//! Uniform numbers of particles: those of a particle depend on the seed and on its number, and on nothing else.
//!
//! Philox4x64-10 in counter mode, of which each particle has one counter. Source: Salmon, Moraes, Dror & Shaw, Parallel random
//! numbers: as easy as 1, 2, 3, SC11 (2011).

const MULTIPLIERS: [u64; 2] = [0xD2E7_470E_E14C_6C93, 0xCA5A_8263_9512_1157];
/// The golden ratio and the root of 3 less 1, in units of 2^-64.
const WEYL: [u64; 2] = [0x9E37_79B9_7F4A_7C15, 0xBB67_AE85_84CA_A73B];
const ROUNDS: usize = 10;

/// Fills two columns with uniform numbers in the open interval (0, 1): those of the particles `first`, `first` + 1 and so on. Panics
/// where the lengths differ.
///
/// Each is the middle of one of 2^52 equal intervals, so that u and 1 - u are as likely.
///
/// ```
/// let (mut u, mut v) = ([0.0; 3], [0.0; 3]);
/// libration::ensemble::uniforms_into(1, 40, [&mut u, &mut v]);
/// let (mut a, mut b) = ([0.0; 1], [0.0; 1]);
/// libration::ensemble::uniforms_into(1, 42, [&mut a, &mut b]);
/// assert!(a[0] == u[2] && b[0] == v[2] && 0.0 < u[0] && u[0] < 1.0);
/// ```
pub fn uniforms_into(seed: u64, first: u64, [u, v]: [&mut [f64]; 2]) {
    assert!(u.len() == v.len(), "columns of different lengths");
    // The counters of a generator begin at 1.
    let mut counter = first;
    for (u, v) in u.iter_mut().zip(v) {
        counter = counter.wrapping_add(1);
        let (first, second) = words(seed, counter);
        (*u, *v) = (open(first), open(second));
    }
}

/// The first two words of a counter.
#[inline(always)]
fn words(seed: u64, counter: u64) -> (u64, u64) {
    let (mut a, mut b, mut c, mut d) = (counter, 0, 0, 0);
    let (mut key, mut other) = (seed, 0_u64);
    // No closures and no arrays, which would be calls and vectors.
    let mut round = 0;
    while round < ROUNDS {
        let first = u128::from(MULTIPLIERS[0]) * u128::from(a);
        let second = u128::from(MULTIPLIERS[1]) * u128::from(c);
        a = (second >> 64) as u64 ^ b ^ key;
        b = second as u64;
        c = (first >> 64) as u64 ^ d ^ other;
        d = first as u64;
        key = key.wrapping_add(WEYL[0]);
        other = other.wrapping_add(WEYL[1]);
        round += 1;
    }
    (a, b)
}

/// The middle of the interval that the first 52 bits name.
#[inline(always)]
fn open(word: u64) -> f64 {
    // In [1, 2), so that the difference is exact; and so is the sum.
    (f64::from_bits(0x3FF0_0000_0000_0000 | word >> 12) - 1.0) + 1.110_223_024_625_156_5e-16
}
