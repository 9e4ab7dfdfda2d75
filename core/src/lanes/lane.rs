//! A vector of doubles, and a computation over any of them.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Whether code is to be short rather than fast but where it is asked for by the million: on a page.
pub const COMPACT: bool = cfg!(target_arch = "wasm32");

/// 1.5 * 2^52: adding it leaves the nearest integer in the low bits of the mantissa.
pub const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Doubles side by side, with the operations the kernels use.
pub trait Lane:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The answer of a comparison, one flag per double.
    type Mask: Copy;
    /// How many doubles.
    const WIDTH: usize;
    /// Whether long formulas are functions of their own (`compiled_once!`): for the plain double on a page, and where nothing is fused.
    const APART: bool = false;

    /// The first WIDTH doubles of a slice that has them.
    fn load(from: &[f64]) -> Self;
    /// Into the first WIDTH doubles of a slice that has them.
    fn store(self, to: &mut [f64]);
    /// The next WIDTH doubles from a place on, of a slice that has them. Not by a slice of it where code is short: there that
    /// is a call, before which every vector goes to memory.
    #[inline(always)]
    fn load_at(from: &[f64], at: usize) -> Self {
        Self::load(&from[at..])
    }
    /// Into the next WIDTH doubles from a place on, likewise.
    #[inline(always)]
    fn store_at(self, to: &mut [f64], at: usize) {
        self.store(&mut to[at..]);
    }
    /// The first double.
    #[inline(always)]
    fn first(self) -> f64 {
        let mut places = [0.0; WIDEST];
        self.store(&mut places);
        places[0]
    }

    /// The same value in every place.
    fn splat(value: f64) -> Self;
    /// `self * factor + term`, fused where the processor fuses.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Product and its exact error.
    fn two_product(self, factor: Self) -> (Self, Self);
    /// [`Lane::two_product`] where an infinity or a NaN serves as well for factors beyond 2^990: no test of them.
    #[inline(always)]
    fn two_product_in_range(self, factor: Self) -> (Self, Self) {
        self.two_product(factor)
    }
    /// `self - factor * other`, exact where that is a double: what a root or a quotient has left.
    #[inline(always)]
    fn remainder(self, factor: Self, other: Self) -> Self {
        let (product, error) = factor.two_product_in_range(other);
        (self - product) - error
    }
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
    /// The e of 2^e <= `self` < 2^(e + 1), for a positive normal number.
    fn exponent(self) -> Self;
    /// Whether the mask holds anywhere.
    fn any(mask: Self::Mask) -> bool;
    /// The entry of a table that bits 49 to 52 of each double name: for a number in [1, 4) the last bit of its exponent, and
    /// the first three of its mantissa.
    fn lookup(self, table: &[f64; PIECES]) -> Self;
    /// `self < other`.
    fn less(self, other: Self) -> Self::Mask;
    /// `self == other`.
    fn equal(self, other: Self) -> Self::Mask;
    /// `self`, negative where a whole number is odd: n + 1.5 2^52, which has n in its low bits, |n| < 2^51.
    #[inline(always)]
    fn alternated(self, shifted: Self) -> Self {
        let half = (shifted - Self::splat(ROUNDER)) * Self::splat(0.5);
        Self::select(half.equal(half.round()), self, -self)
    }
    /// The larger; `self` where either is a NaN.
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self::select(self.less(other), other, self)
    }
    /// The smaller; `self` where either is a NaN.
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self::select(other.less(self), other, self)
    }
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The doubles where the mask holds, side by side into a slice with room for WIDTH, and how many.
    #[inline(always)]
    fn pack(self, mask: Self::Mask, to: &mut [f64]) -> usize {
        let (mut values, mut flags) = ([0.0; WIDEST], [0.0; WIDEST]);
        self.store(&mut values);
        Self::select(mask, Self::splat(1.0), Self::splat(0.0)).store(&mut flags);
        let (mut count, mut i) = (0, 0);
        while i < Self::WIDTH {
            to[count] = values[i];
            count += usize::from(flags[i] != 0.0);
            i += 1;
        }
        count
    }
    /// `self` with the first doubles of a slice of at least WIDTH where the mask holds, and how many those are.
    #[inline(always)]
    fn unpack(self, mask: Self::Mask, from: &[f64]) -> (Self, usize) {
        let (mut values, mut flags) = ([0.0; WIDEST], [0.0; WIDEST]);
        self.store(&mut values);
        Self::select(mask, Self::splat(1.0), Self::splat(0.0)).store(&mut flags);
        let (mut count, mut i) = (0, 0);
        while i < Self::WIDTH {
            // By an index: whether one is taken cannot be foreseen.
            let taken = usize::from(flags[i] != 0.0);
            values[i] = [values[i], from[count]][taken];
            count += taken;
            i += 1;
        }
        (Self::load(&values), count)
    }
}

/// A computation over any lane type, handed to `single`, `wide` or `four` of dispatch.rs.
pub trait Kernel {
    /// What it returns.
    type Output;
    /// The type in whose module it is compiled: [`Entry`].
    type Place;
    /// Whether WebAssembly runs it on vectors. A kernel without fused multiplication is long, and a page loads what is
    /// compiled: only what is asked for by the million has a second one.
    const VECTORS: bool = false;
    /// Whether those are single ones: half the code, for what is asked for by the thousand.
    const SINGLE_VECTORS: bool = false;
    /// Runs it on the lane type of the instruction set; `#[inline(always)]`, so that it is compiled for it.
    fn run<L: Lane>(self) -> Self::Output;
}

/// Entries of the table of [`Lane::lookup`].
pub const PIECES: usize = 16;

/// Widest lane.
pub const WIDEST: usize = 16;

/// A formula over lanes that is inlined into every kernel, but on lanes that are [`Lane::APART`], where it is a function.
macro_rules! compiled_once {
    ($(#[$about:meta])* $visible:vis fn $name:ident<L: Lane>($($argument:ident: $type:ty),*) -> $result:ty $body:block) => {
        $(#[$about])*
        #[inline(always)]
        $visible fn $name<L: Lane>($($argument: $type),*) -> $result {
            #[inline(always)]
            fn inlined<L: Lane>($($argument: $type),*) -> $result $body
            #[inline(never)]
            fn apart<L: Lane>($($argument: $type),*) -> $result {
                inlined($($argument),*)
            }
            if L::APART { apart($($argument),*) } else { inlined($($argument),*) }
        }
    };
}
pub(crate) use compiled_once;

/// The function that holds a compiled kernel.
///
/// It is a default method, because the compiler puts such a function into the code unit of the module of its `Self` type.
/// So the kernels of each room are units of their own, which are compiled in parallel. A plain function would put all of
/// them into one unit.
pub trait Entry {
    /// Runs a kernel without fused multiplication: compiled once where both widths are the same.
    #[inline(never)]
    fn enter<L: Lane, K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<L>()
    }
}

impl<Place> Entry for Place {}
