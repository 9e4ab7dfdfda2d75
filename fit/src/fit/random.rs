//! Random numbers from a counter: the same counter gives the same number, on any machine and in any order.
//!
//! SplitMix64's finaliser of a counter times the golden ratio. Source: Steele, Lea & Flood, OOPSLA 2014, figure 16.

/// A stream of random numbers, one for each counter: for draws, and for the noise of records that are made.
#[derive(Clone, Copy, Debug)]
pub struct Stream {
    key: u64,
}

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

impl Stream {
    /// The stream of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Stream {
        Stream { key: mixed(seed.wrapping_add(GOLDEN)) }
    }
    /// Uniform in (0, 1).
    #[must_use]
    pub fn uniform(self, counter: u64) -> f64 {
        let bits = mixed(self.key.wrapping_add(counter.wrapping_mul(GOLDEN)));
        ((bits >> 11) as f64 + 0.5) / 9_007_199_254_740_992.0
    }
    /// Standard normal, by Box and Muller's map of two uniform numbers.
    #[must_use]
    pub fn normal(self, counter: u64) -> f64 {
        let (a, b) = (self.uniform(2 * counter), self.uniform(2 * counter + 1));
        (-2.0 * libm::log(a)).sqrt() * libm::cos(core::f64::consts::TAU * b)
    }
    /// Standard normal noise in which each number remembers a share of the one before: e_i = memory e_(i-1) + sqrt(1 - memory^2) n_i.
    #[must_use]
    pub fn noise(self, memory: f64, rows: usize) -> Vec<f64> {
        let fresh = (1.0 - memory * memory).sqrt();
        let mut error = self.normal(0);
        (1..=rows as u64)
            .map(|i| {
                error = memory * error + fresh * self.normal(i);
                error
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_numbers_have_mean_0_and_deviation_1() {
        let stream = Stream::new(3);
        let n = 40_000;
        let drawn: Vec<f64> = (0..n).map(|i| stream.normal(i)).collect();
        let mean = drawn.iter().sum::<f64>() / n as f64;
        let variance = drawn.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n as f64;
        assert!(mean.abs() < 0.02 && (variance - 1.0).abs() < 0.03, "{mean} {variance}");
        assert_ne!(stream.normal(1), Stream::new(4).normal(1));
    }

    #[test]
    fn noise_has_the_memory_that_is_asked_for() {
        for memory in [0.0, 0.7] {
            let drawn = Stream::new(5).noise(memory, 40_000);
            let variance = drawn.iter().map(|x| x * x).sum::<f64>() / 40_000.0;
            let next = drawn.windows(2).map(|w| w[0] * w[1]).sum::<f64>() / 40_000.0;
            assert!((variance - 1.0).abs() < 0.05 && (next - memory).abs() < 0.05, "{variance} {next}");
        }
    }
}
