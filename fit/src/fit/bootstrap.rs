//! The moving-block bootstrap of a minimum, by one Gauss-Newton step for each resampling.
//!
//! Blocks keep the correlation of the residuals. Source: Kuensch, Ann. Statist. 17 (1989) 1217.

use super::options::FitOptions;
use super::random::Stream;
use nalgebra::{DMatrix, DVector};

/// The variance of every value.
pub(super) fn block_bootstrap(
    jacobian: &DMatrix<f64>,
    inverse: &DMatrix<f64>,
    residuals: &[f64],
    block: usize,
    options: &FitOptions,
) -> Vec<f64> {
    let (n, p) = jacobian.shape();
    let stream = Stream::new(options.seed);
    let blocks = n.div_ceil(block);
    let mut squares = vec![0.0; p];
    for draw in 0..options.bootstrap {
        let mut score = DVector::<f64>::zeros(p);
        for number in 0..blocks {
            let counter = (draw * blocks + number) as u64;
            let from = (stream.uniform(counter) * (n - block + 1) as f64) as usize;
            let to = number * block;
            let length = block.min(n - to);
            let piece = DVector::from_column_slice(&residuals[from..from + length]);
            score += jacobian.rows(to, length).tr_mul(&piece);
        }
        let step = inverse * score;
        for (square, change) in squares.iter_mut().zip(step.iter()) {
            *square += change * change;
        }
    }
    // Residuals are shorter than the noise by the values that were fitted.
    let longer = n as f64 / (n - p) as f64;
    squares.into_iter().map(|square| square / options.bootstrap as f64 * longer).collect()
}
