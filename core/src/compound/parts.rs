//! Parts of a rigid pendulum, in line below its pivot: inertia I = sum m (k s^2 + d^2), moment S = sum m d, length I/S.
//!
//! d is the distance of the part's centre from the pivot, s its size, k its shape's factor (Steiner's theorem). omega0^2 = g S/I.
//! Source: Landau & Lifshitz, Mechanics, section 32.

use crate::domain::Domain;

/// The shape of a part, which says what its size is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A thin rod or thread along the pendulum; the size is its length.
    Rod,
    /// A homogeneous ball; the size is its radius.
    Ball,
    /// A flat disc that swings in its own plane; the size is its radius.
    Disc,
    /// All mass at one point; the size does not count.
    Point,
}

impl Shape {
    /// The square of the radius of gyration over that of the size.
    #[must_use]
    pub fn gyration(self) -> f64 {
        match self {
            Shape::Rod => 1.0 / 12.0,
            Shape::Ball => 0.4,
            Shape::Disc => 0.5,
            Shape::Point => 0.0,
        }
    }
}

/// A part of a rigid pendulum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Its shape.
    pub shape: Shape,
    /// In kg.
    pub mass: f64,
    /// Of its centre from the pivot in m; negative above the pivot.
    pub distance: f64,
    /// In m.
    pub size: f64,
}

/// A rigid pendulum.
#[derive(Clone, Debug, PartialEq)]
pub struct Compound {
    parts: Vec<Part>,
    inertia: f64,
    moment: f64,
}

impl Compound {
    /// From its parts.
    ///
    /// # Errors
    /// For a mass or a size that is negative or not finite, a distance that is not finite, and where the centre of mass is not
    /// below the pivot.
    ///
    /// ```
    /// use libration::{Compound, Part, Shape};
    /// let rod = Part { shape: Shape::Rod, mass: 0.019, distance: 0.2475, size: 0.495 };
    /// let end = Part { shape: Shape::Point, mass: 0.031, distance: 0.495, size: 0.0 };
    /// assert_eq!(format!("{:.5}", Compound::new(&[rod, end])?.length()), "0.45630");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn new(parts: &[Part]) -> Result<Compound, Domain> {
        for part in parts {
            let known = |value: f64| value.is_finite() && value >= 0.0;
            Domain::check("mass", part.mass, known(part.mass), "finite and not negative")?;
            Domain::check("size", part.size, known(part.size), "finite and not negative")?;
            Domain::check("distance", part.distance, part.distance.is_finite(), "finite")?;
        }
        let inertia = |p: &Part| p.mass * (p.shape.gyration() * p.size * p.size + p.distance * p.distance);
        let compound = Compound {
            inertia: parts.iter().map(inertia).sum(),
            moment: parts.iter().map(|p| p.mass * p.distance).sum(),
            parts: parts.to_vec(),
        };
        Domain::check(
            "moment",
            compound.moment,
            compound.moment > 0.0,
            "positive: the centre of mass hangs below the pivot",
        )?;
        Ok(compound)
    }
    /// About the pivot, in kg m^2. **Error** 2 ulp for each part.
    #[must_use]
    pub fn inertia(&self) -> f64 {
        self.inertia
    }
    /// Sum of mass times distance, in kg m. **Error** 2 ulp of the largest term.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.moment
    }
    /// The equivalent length I/S in m: omega0^2 = g/length.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.inertia / self.moment
    }
    /// The derivatives of the length by mass, distance and size of every part.
    #[must_use]
    pub fn length_by_parts(&self) -> Vec<[f64; 3]> {
        let length = self.length();
        let by = |p: &Part| {
            let k = p.shape.gyration();
            let by_mass = k * p.size * p.size + p.distance * p.distance - length * p.distance;
            let by_distance = 2.0 * p.mass * p.distance - length * p.mass;
            let by_size = 2.0 * p.mass * k * p.size;
            [by_mass, by_distance, by_size].map(|part| part / self.moment)
        };
        self.parts.iter().map(by).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_uniform_rod_has_two_thirds_of_its_length() {
        let rod = |distance: f64| Part { shape: Shape::Rod, mass: 0.3, distance, size: 0.9 };
        assert!((Compound::new(&[rod(0.45)]).unwrap().length() - 0.6).abs() < 1e-15);
        assert!(Compound::new(&[rod(0.0)]).is_err() && Compound::new(&[rod(f64::NAN)]).is_err());
    }

    #[test]
    fn derivatives_are_those_of_the_length() {
        let parts = [
            Part { shape: Shape::Rod, mass: 0.02, distance: 0.25, size: 0.5 },
            Part { shape: Shape::Ball, mass: 0.1, distance: 0.5, size: 0.02 },
            Part { shape: Shape::Disc, mass: 0.05, distance: -0.1, size: 0.04 },
        ];
        let by = Compound::new(&parts).unwrap().length_by_parts();
        for (i, row) in by.iter().enumerate() {
            for (j, derivative) in row.iter().enumerate() {
                let length = |side: f64| {
                    let mut parts = parts;
                    let value = [&mut parts[i].mass, &mut parts[i].distance, &mut parts[i].size];
                    *value.into_iter().nth(j).unwrap() += side * 1e-6;
                    Compound::new(&parts).unwrap().length()
                };
                let difference = (length(1.0) - length(-1.0)) / 2e-6;
                assert!((difference - derivative).abs() < 1e-7 * (1.0 + derivative.abs()), "{i} {j}");
            }
        }
    }
}
