//! Gauss's arithmetic-geometric mean in double-double, and with it K = pi / (2 agm(1, k')).
//!
//! Source: DLMF 19.8.1, 19.8.5. Converges quadratically for any k' > 0; no cancellation.

use crate::float::{Dd, HALF_PI};

/// agm(1, b) for 0 < b <= 1.
pub fn agm(b: Dd) -> Dd {
    let (mut a, mut b) = (Dd::ONE, b);
    loop {
        let mean = (a + b).scale(0.5);
        let apart = (a.hi - b.hi).abs() > 2e-16 * a.hi;
        // After this step the two means differ by (a - b)^2 / 8a, below 2^-108 of a: the mean is the limit.
        // A NaN is not apart, and a zero (its logarithmic limit) would never come nearer.
        if !apart || b.hi == 0.0 {
            return if b.hi == 0.0 { Dd::ZERO } else { mean };
        }
        b = (a * b).sqrt();
        a = mean;
    }
}

/// K from the complementary modulus k' in (0, 1].
pub fn quarter_period(kc: Dd) -> Dd {
    HALF_PI / agm(kc)
}
