//! What every vector type is: a struct over the processor's register and its [`Lane`](super::lane::Lane), from one table.
//!
//! A row of the table names an operation and the expression that does it, in the registers `a`, `b`, `c` (the names
//! are the table's to choose), which stand for the arguments of the operation in their order. Where they do not:
//! - `apart` says whether long formulas are functions of their own, which they are not where it is left out;
//! - `load` and `store` have the slice's pointer as `a`; what is stored is `b`;
//! - `product_error` has both factors and their rounded product, as has `product_error_in_range`, which a table may leave out;
//! - `shift_52` moves the bits of every double up by 52 places;
//! - `exponent_field` has the bits above the mantissa of every double in the mantissa of a double from 2^52 on;
//! - `any` has the flags as `a`;
//! - `lookup` has the pointer to a table of sixteen doubles as `b`, and takes entries by four bits of each double;
//! - `select` has the flags, what is taken where they hold, and the rest;
//! - `pack` has the flags, the doubles, and the slice's pointer, and `unpack` likewise.
//!
//! A table may leave out the last five.
//!
//! SAFETY of every row: the file of the table answers for it; pointers are those of slices of the right length.
//! An expression is pasted into its method, never called: a closure would be compiled without the instruction set.

/// A vector type from its table.
macro_rules! vector {
    (
        $(#[$about:meta])*
        $vector:ident = $width:literal in $register:ty, flags in $flags:ty, of $a:ident, $b:ident, $c:ident;
        $(apart = $apart:literal;)?
        load = $load:expr;
        store = $store:expr;
        splat = $splat:expr;
        add = $add:expr;
        sub = $sub:expr;
        mul = $mul:expr;
        div = $div:expr;
        neg = $neg:expr;
        mul_add = $mul_add:expr;
        product_error = $product_error:expr;
        $(product_error_in_range = $product_error_in_range:expr;)?
        $(remainder = $remainder:expr;)?
        round = $round:expr;
        sqrt = $sqrt:expr;
        abs = $abs:expr;
        copysign = $copysign:expr;
        shift_52 = $shift_52:expr;
        exponent_field = $exponent_field:expr;
        any = $any:expr;
        lookup = $lookup:expr;
        less = $less:expr;
        equal = $equal:expr;
        select = $select:expr;
        $(alternated = $alternated:expr; larger = $larger:expr; smaller = $smaller:expr;)?
        $(pack = $pack:expr; unpack = $unpack:expr;)?
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy)]
        #[repr(transparent)]
        pub struct $vector($register);

        vector!(@operators $vector $a $b: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        #[allow(unused_unsafe, reason = "WebAssembly has its features when it is compiled: there most are safe")]
        impl core::ops::Neg for $vector {
            type Output = Self;
            vector!(@unary neg $a $neg);
        }

        #[allow(unused_unsafe, reason = "as above")]
        impl super::lane::Lane for $vector {
            type Mask = $flags;
            const WIDTH: usize = $width;
            $(const APART: bool = $apart;)?

            #[inline(always)]
            fn load(from: &[f64]) -> Self {
                let $a = from[..$width].as_ptr();
                // SAFETY: see the top of the table's file; the slice has the length that is read.
                Self(unsafe { $load })
            }
            #[inline(always)]
            fn store(self, to: &mut [f64]) {
                let ($a, $b) = (to[..$width].as_mut_ptr(), self.0);
                // SAFETY: see the top of the table's file; the slice has the length that is written.
                unsafe { $store }
            }
            #[cfg(target_arch = "wasm32")]
            #[inline(always)]
            fn load_at(from: &[f64], at: usize) -> Self {
                assert!(at < from.len() && $width <= from.len() - at);
                // SAFETY: the slice has the doubles from there on.
                let $a = unsafe { from.as_ptr().add(at) };
                // SAFETY: see the top of the table's file; as many are read.
                Self(unsafe { $load })
            }
            #[cfg(target_arch = "wasm32")]
            #[inline(always)]
            fn store_at(self, to: &mut [f64], at: usize) {
                assert!(at < to.len() && $width <= to.len() - at);
                // SAFETY: the slice has the doubles from there on.
                let ($a, $b) = (unsafe { to.as_mut_ptr().add(at) }, self.0);
                // SAFETY: see the top of the table's file; as many are written.
                unsafe { $store }
            }
            #[inline(always)]
            fn splat($a: f64) -> Self {
                // SAFETY: see the top of the table's file.
                Self(unsafe { $splat })
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                let ($a, $b, $c) = (self.0, factor.0, term.0);
                // SAFETY: see the top of the table's file.
                Self(unsafe { $mul_add })
            }
            #[inline(always)]
            fn two_product(self, factor: Self) -> (Self, Self) {
                let product = self * factor;
                let ($a, $b, $c) = (self.0, factor.0, product.0);
                // SAFETY: see the top of the table's file.
                (product, Self(unsafe { $product_error }))
            }
            $(
                #[inline(always)]
                fn two_product_in_range(self, factor: Self) -> (Self, Self) {
                    let product = self * factor;
                    let ($a, $b, $c) = (self.0, factor.0, product.0);
                    // SAFETY: see the top of the table's file.
                    (product, Self(unsafe { $product_error_in_range }))
                }
            )?
            $(
                #[inline(always)]
                fn remainder(self, factor: Self, other: Self) -> Self {
                    let ($a, $b, $c) = (factor.0, other.0, self.0);
                    // SAFETY: see the top of the table's file.
                    Self(unsafe { $remainder })
                }
            )?
            vector!(@unary round $a $round);
            vector!(@unary sqrt $a $sqrt);
            vector!(@unary abs $a $abs);
            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                let ($a, $b) = (self.0, sign.0);
                // SAFETY: see the top of the table's file.
                Self(unsafe { $copysign })
            }
            #[inline(always)]
            fn exp2_integer(self) -> Self {
                let $a = (self + Self::splat(super::lane::ROUNDER + 1023.0)).0;
                // SAFETY: see the top of the table's file.
                Self(unsafe { $shift_52 })
            }
            #[inline(always)]
            fn exponent(self) -> Self {
                let $a = self.0;
                // SAFETY: see the top of the table's file.
                Self(unsafe { $exponent_field }) - Self::splat(super::scalar::FIELD + 1023.0)
            }
            #[inline(always)]
            fn any($a: $flags) -> bool {
                // SAFETY: see the top of the table's file.
                unsafe { $any }
            }
            #[inline(always)]
            fn lookup(self, table: &[f64; super::lane::PIECES]) -> Self {
                let ($a, $b) = (self.0, table.as_ptr());
                // SAFETY: see the top of the table's file; the table has an entry for each value of four bits.
                Self(unsafe { $lookup })
            }
            $(
                vector!(@binary alternated $a $b $alternated);
                vector!(@binary larger $a $b $larger);
                vector!(@binary smaller $a $b $smaller);
            )?
            vector!(@compare less $a $b $less, $flags);
            vector!(@compare equal $a $b $equal, $flags);
            #[inline(always)]
            fn select($a: $flags, yes: Self, no: Self) -> Self {
                let ($b, $c) = (yes.0, no.0);
                // SAFETY: see the top of the table's file.
                Self(unsafe { $select })
            }
            $(
                #[inline(always)]
                fn pack(self, $a: $flags, to: &mut [f64]) -> usize {
                    let ($b, $c) = (self.0, to[..$width].as_mut_ptr());
                    // SAFETY: see the top of the table's file; the slice has the length that is written.
                    unsafe { $pack }
                    $a.count_ones() as usize
                }
                #[inline(always)]
                fn unpack(self, $a: $flags, from: &[f64]) -> (Self, usize) {
                    let ($b, $c) = (self.0, from[..$width].as_ptr());
                    // SAFETY: see the top of the table's file; the slice has the length that is read.
                    (Self(unsafe { $unpack }), $a.count_ones() as usize)
                }
            )?
        }
    };

    (@operators $vector:ident $a:ident $b:ident: $($trait:ident $method:ident $value:expr),*) => {$(
        #[allow(unused_unsafe, reason = "as above")]
        impl core::ops::$trait for $vector {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self.0, other.0);
                // SAFETY: see the top of the table's file.
                Self(unsafe { $value })
            }
        }
    )*};

    (@unary $method:ident $a:ident $value:expr) => {
        #[inline(always)]
        fn $method(self) -> Self {
            let $a = self.0;
            // SAFETY: see the top of the table's file.
            Self(unsafe { $value })
        }
    };

    (@binary $method:ident $a:ident $b:ident $value:expr) => {
        #[inline(always)]
        fn $method(self, other: Self) -> Self {
            let ($a, $b) = (self.0, other.0);
            // SAFETY: see the top of the table's file.
            Self(unsafe { $value })
        }
    };

    (@compare $method:ident $a:ident $b:ident $value:expr, $flags:ty) => {
        #[inline(always)]
        fn $method(self, other: Self) -> $flags {
            let ($a, $b) = (self.0, other.0);
            // SAFETY: see the top of the table's file.
            unsafe { $value }
        }
    };
}
pub(super) use vector;
