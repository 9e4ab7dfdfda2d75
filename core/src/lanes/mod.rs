//! A vector of doubles and the run-time choice of the instruction set that carries it.
//!
//! Formulas are written once over [`Lane`]; a scalar is a lane of width one. Every operation here is one
//! IEEE operation (or an error-free pair of them), so all widths of one instruction set give the same bits.
//! Instruction sets differ only in whether `mul_add` is fused.

use crate::domain::Domain;
use core::ops::{Add, Div, Mul, Neg, Sub};
use core::sync::atomic::{AtomicU8, Ordering};

/// Doubles side by side, with the operations the kernels use.
pub trait Lane:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The answer of a comparison, one flag per double.
    type Mask: Copy;

    /// The same value in every place.
    fn splat(value: f64) -> Self;
    /// `self * factor + term`, fused where the processor fuses.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Product and its exact error.
    fn two_product(self, factor: Self) -> (Self, Self);
    /// Nearest integer, ties to even.
    fn round(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Magnitude of `self`, sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// 2 to the power `self`, an integer in [-1022, 1023].
    fn exp2_integer(self) -> Self;
    /// `self < other`.
    fn less(self, other: Self) -> Self::Mask;
    /// `self == other`.
    fn equal(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

/// A lane of width one, which can be read as a plain double.
pub trait Scalar: Lane + Into<f64> {}
impl<L: Lane + Into<f64>> Scalar for L {}

/// A computation over any width-one lane, handed to [`dispatch`].
pub trait Kernel {
    /// What it returns.
    type Output;
    /// Runs it on the lane type of the chosen instruction set.
    fn run<L: Scalar>(self) -> Self::Output;
}

/// What a processor can do that changes the last digits or the speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum InstructionSet {
    /// No fused multiplication: every processor, and WebAssembly.
    Plain = 1,
    /// Fused multiplication: AVX2 with FMA on x86-64, every aarch64.
    Fused = 2,
}

/// The set in use; 0 until it is first asked for.
static IN_USE: AtomicU8 = AtomicU8::new(0);

impl InstructionSet {
    /// The sets that this processor has, best last.
    pub fn available() -> &'static [InstructionSet] {
        #[cfg(target_arch = "x86_64")]
        let fused = std::arch::is_x86_feature_detected!("fma") && std::arch::is_x86_feature_detected!("avx2");
        #[cfg(not(target_arch = "x86_64"))]
        let fused = cfg!(target_arch = "aarch64");
        if fused { &[InstructionSet::Plain, InstructionSet::Fused] } else { &[InstructionSet::Plain] }
    }

    /// The set in use: the best one, unless [`InstructionSet::force`] has chosen another.
    #[inline]
    pub fn in_use() -> InstructionSet {
        match IN_USE.load(Ordering::Relaxed) {
            1 => InstructionSet::Plain,
            2 => InstructionSet::Fused,
            _ => InstructionSet::first_use(),
        }
    }

    #[cold]
    fn first_use() -> InstructionSet {
        let available = InstructionSet::available();
        let best = available[available.len() - 1];
        IN_USE.store(best as u8, Ordering::Relaxed);
        best
    }

    /// Makes the whole process use this set, for tests and benchmarks; refused where it is not available.
    pub fn force(self) -> Result<(), Domain> {
        let allowed = "an instruction set of this processor";
        if !InstructionSet::available().contains(&self) {
            return Err(Domain { argument: "instruction set", given: format!("{self:?}"), allowed });
        }
        IN_USE.store(self as u8, Ordering::Relaxed);
        Ok(())
    }
}

/// Runs the kernel on the instruction set in use.
#[inline]
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    match InstructionSet::in_use() {
        InstructionSet::Plain => kernel.run::<f64>(),
        InstructionSet::Fused => run_fused(kernel),
    }
}

#[cfg(target_arch = "x86_64")]
#[inline]
fn run_fused<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx2,fma")]
    fn with_fma<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Fused>()
    }
    // SAFETY: `InstructionSet::Fused` is in use only where `available` has seen both features.
    unsafe { with_fma(kernel) }
}

#[cfg(not(target_arch = "x86_64"))]
#[inline]
fn run_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Fused>()
}

/// 1.5 * 2^52: adding it leaves the nearest integer in the low bits of the mantissa.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

impl Lane for f64 {
    type Mask = bool;

    #[inline(always)]
    fn splat(value: f64) -> f64 {
        value
    }
    #[inline(always)]
    fn mul_add(self, factor: f64, term: f64) -> f64 {
        self * factor + term
    }
    /// Dekker's product with Veltkamp's splitting; factors above 2^990 are scaled so that splitting does
    /// not overflow.
    #[inline(always)]
    fn two_product(self, factor: f64) -> (f64, f64) {
        const HUGE: f64 = 1.046_336_793_293_362_4e298; // 2^990
        const DOWN: f64 = 1.387_778_780_781_445_7e-17; // 2^-56
        const UP: f64 = 72_057_594_037_927_936.0; // 2^56
        let product = self * factor;
        let (a, up_a) = if f64::abs(self) > HUGE { (self * DOWN, UP) } else { (self, 1.0) };
        let (b, up_b) = if f64::abs(factor) > HUGE { (factor * DOWN, UP) } else { (factor, 1.0) };
        let (a_hi, a_lo) = split(a);
        let (b_hi, b_lo) = split(b);
        let error = ((a_hi * b_hi - a * b) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo;
        (product, error * up_a * up_b)
    }
    #[inline(always)]
    fn round(self) -> f64 {
        if f64::abs(self) < 2_251_799_813_685_248.0 { (self + ROUNDER) - ROUNDER } else { round_large(self) }
    }
    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    #[inline(always)]
    fn copysign(self, sign: f64) -> f64 {
        f64::copysign(self, sign)
    }
    #[inline(always)]
    fn exp2_integer(self) -> f64 {
        f64::from_bits(((self + (ROUNDER + 1023.0)).to_bits()) << 52)
    }
    #[inline(always)]
    fn less(self, other: f64) -> bool {
        self < other
    }
    #[inline(always)]
    fn equal(self, other: f64) -> bool {
        self == other
    }
    #[inline(always)]
    fn select(mask: bool, yes: f64, no: f64) -> f64 {
        if mask { yes } else { no }
    }
}

/// Veltkamp's splitting into 26 + 26 bits.
#[inline(always)]
fn split(value: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * value;
    let hi = scaled - (scaled - value);
    (hi, value - hi)
}

/// Between 2^51 and 2^52 a half is left; above, every double is an integer.
fn round_large(value: f64) -> f64 {
    if f64::abs(value) < 4_503_599_627_370_496.0 {
        let whole = (f64::abs(value) + 4_503_599_627_370_496.0) - 4_503_599_627_370_496.0;
        f64::copysign(whole, value)
    } else {
        value
    }
}

/// One double on a processor with fused multiplication.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Fused(f64);

impl From<Fused> for f64 {
    #[inline(always)]
    fn from(lane: Fused) -> f64 {
        lane.0
    }
}

macro_rules! fused_operator {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Fused {
            type Output = Fused;
            #[inline(always)]
            fn $method(self, other: Fused) -> Fused {
                Fused(self.0.$method(other.0))
            }
        }
    )*};
}
fused_operator!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Fused {
    type Output = Fused;
    #[inline(always)]
    fn neg(self) -> Fused {
        Fused(-self.0)
    }
}

impl Lane for Fused {
    type Mask = bool;

    #[inline(always)]
    fn splat(value: f64) -> Fused {
        Fused(value)
    }
    #[inline(always)]
    fn mul_add(self, factor: Fused, term: Fused) -> Fused {
        Fused(f64::mul_add(self.0, factor.0, term.0))
    }
    #[inline(always)]
    fn two_product(self, factor: Fused) -> (Fused, Fused) {
        let product = self.0 * factor.0;
        (Fused(product), Fused(f64::mul_add(self.0, factor.0, -product)))
    }
    #[inline(always)]
    fn round(self) -> Fused {
        Fused(f64::round_ties_even(self.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Fused {
        Fused(f64::sqrt(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Fused {
        Fused(f64::abs(self.0))
    }
    #[inline(always)]
    fn copysign(self, sign: Fused) -> Fused {
        Fused(f64::copysign(self.0, sign.0))
    }
    #[inline(always)]
    fn exp2_integer(self) -> Fused {
        Fused(Lane::exp2_integer(self.0))
    }
    #[inline(always)]
    fn less(self, other: Fused) -> bool {
        self.0 < other.0
    }
    #[inline(always)]
    fn equal(self, other: Fused) -> bool {
        self.0 == other.0
    }
    #[inline(always)]
    fn select(mask: bool, yes: Fused, no: Fused) -> Fused {
        Fused(Lane::select(mask, yes.0, no.0))
    }
}
