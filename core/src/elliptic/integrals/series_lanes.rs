//! The series that end Carlson's duplication, over lanes, in the elementary symmetric functions of the distances from the
//! mean: less 1, of which they are a small change.
//!
//! Coefficients: reference/coefficients.py. Source: DLMF 19.19.7, 19.36.1, 19.36.2, continued.

use crate::float::elementary::horner;
use crate::lanes::Lane;

/// R_F less 1, to degree 13.
#[inline(always)]
pub(crate) fn first_kind<L: Lane>(e2: L, e3: L) -> L {
    const SECOND: [f64; 6] =
        [-0.1, 0.041666666666666664, -0.02403846153846154, 0.01608455882352941, -0.01171875, 0.0090234375];
    const THIRD: [f64; 6] = [
        0.07142857142857142, -0.06818181818181818, 0.0625, -0.05756578947368421, 0.053498641304347824,
        -0.050130208333333336,
    ];
    const SIXTH: [f64; 4] = [0.028846153846153848, -0.05514705882352941, 0.078125, -0.0984375];
    const NINTH: [f64; 3] = [0.01644736842105263, -0.04755434782608696, 0.09114583333333333];
    const TWELFTH: f64 = 0.0109375;
    let sum = e3.mul_add(L::splat(TWELFTH), horner(&NINTH, e2));
    let sum = e3.mul_add(sum, horner(&SIXTH, e2));
    let sum = e3.mul_add(sum, horner(&THIRD, e2));
    e3.mul_add(sum, e2 * horner(&SECOND, e2))
}

/// R_J less 1, and R_D as its case of two equal arguments, to degree 11.
#[inline(always)]
pub(crate) fn third_kind<L: Lane>(e2: L, e3: L, e4: L, e5: L) -> L {
    const SECOND: [f64; 5] =
        [-0.21428571428571427, 0.10227272727272728, -0.0625, 0.04317434210526316, -0.032099184782608696];
    const THIRD: [f64; 5] =
        [0.16666666666666666, -0.17307692307692307, 0.16544117647058823, -0.15625, 0.14765625];
    const SIXTH: [f64; 3] = [0.075, -0.14802631578947367, 0.2139945652173913];
    const NINTH: [f64; 2] = [0.044642857142857144, -0.13125];
    const FOURTH: [f64; 4] = [-0.13636363636363635, 0.15, -0.14802631578947367, 0.14266304347826086];
    const FOURTH_THIRD: [f64; 3] = [-0.1323529411764706, 0.26785714285714285, -0.39375];
    const FIFTH: [f64; 4] = [0.11538461538461539, -0.1323529411764706, 0.13392857142857142, -0.13125];
    const FIFTH_THIRD: [f64; 2] = [0.11842105263157894, -0.24456521739130435];
    const FOURTH_FOURTH: [f64; 2] = [0.05921052631578947, -0.12228260869565218];
    const FOURTH_FIFTH: [f64; 2] = [-0.10714285714285714, 0.225];
    let three = e3.mul_add(horner(&NINTH, e2), horner(&SIXTH, e2));
    let three = e3.mul_add(three, horner(&THIRD, e2));
    let three = e3.mul_add(three, e2 * horner(&SECOND, e2));
    let four = e3.mul_add(L::splat(-0.12228260869565218), horner(&FOURTH_THIRD, e2));
    let four = e3.mul_add(four, horner(&FOURTH, e2));
    let twice = e3.mul_add(L::splat(0.1125), horner(&FOURTH_FOURTH, e2));
    let four = e4.mul_add(twice, e5.mul_add(horner(&FOURTH_FIFTH, e2), four));
    let five = e3.mul_add(L::splat(0.1125), horner(&FIFTH_THIRD, e2));
    let five = e3.mul_add(five, horner(&FIFTH, e2));
    let five = e5.mul_add(L::splat(0.04891304347826087), five);
    e5.mul_add(five, e4.mul_add(four, three))
}
