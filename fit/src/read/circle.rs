//! The pivot of a tracked point: the circle through its places, by algebra (Kasa) and then by least distance
//! (Gauss-Newton), and the angle about its centre.

// The indices are those of the normal equations.
#![allow(clippy::needless_range_loop)]

/// A circle with the rms distance of the points from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Circle {
    pub x: f64,
    pub y: f64,
    pub radius: f64,
    pub rms: f64,
    /// The standard error of the radius, for independent errors of the points.
    pub radius_error: f64,
}

/// The circle of least squared distance from the points; `radius` where it is known.
pub(super) fn circle(x: &[f64], y: &[f64], radius: Option<f64>) -> Option<Circle> {
    let n = x.len() as f64;
    if x.len() < 3 {
        return None;
    }
    let (mx, my) = (x.iter().sum::<f64>() / n, y.iter().sum::<f64>() / n);
    let points = || x.iter().zip(y).map(|(x, y)| (x - mx, y - my));
    let scale = (points().map(|(x, y)| x * x + y * y).sum::<f64>() / n).sqrt();
    if !(scale > 0.0 && scale.is_finite()) {
        return None;
    }
    // x^2 + y^2 = 2 a x + 2 b y + c, in units of the spread.
    let mut normal = [[0.0; 4]; 3];
    for (x, y) in points().map(|(x, y)| (x / scale, y / scale)) {
        let (row, right) = ([2.0 * x, 2.0 * y, 1.0], x * x + y * y);
        for i in 0..3 {
            for j in 0..3 {
                normal[i][j] += row[i] * row[j];
            }
            normal[i][3] += row[i] * right;
        }
    }
    let [a, b, c] = solved(normal)?;
    let mut at = [a, b, (c + a * a + b * b).max(0.0).sqrt()];
    if let Some(radius) = radius {
        // With a known radius the centre lies on the same side, at its distance.
        let (away, wanted) = ((a * a + b * b).sqrt(), radius / scale);
        if away > 0.0 {
            (at[0], at[1]) = (a / away * wanted, b / away * wanted);
        }
        at[2] = wanted;
    }
    let free = if radius.is_some() { 2 } else { 3 };
    let mut inverse = f64::NAN;
    for _ in 0..60 {
        let mut normal = [[0.0; 4]; 3];
        let mut last = [[0.0; 4]; 3];
        for (x, y) in points().map(|(x, y)| (x / scale - at[0], y / scale - at[1])) {
            let distance = (x * x + y * y).sqrt();
            if distance == 0.0 {
                continue;
            }
            let row = [-x / distance, -y / distance, -1.0];
            for i in 0..free {
                for j in 0..free {
                    normal[i][j] += row[i] * row[j];
                }
                normal[i][3] -= row[i] * (distance - at[2]);
            }
        }
        for i in free..3 {
            normal[i][i] = 1.0;
        }
        for i in 0..3 {
            last[i] = normal[i];
            last[i][3] = if i == 2 { 1.0 } else { 0.0 };
        }
        inverse = solved(last)?[2];
        let step = solved(normal)?;
        let length = step.iter().map(|each| each * each).sum::<f64>().sqrt();
        // A step longer than the circle has left the quadratic region.
        let shorter = (0.5 * at[2] / length).min(1.0);
        for i in 0..free {
            at[i] += shorter * step[i];
        }
        if length < 1e-12 * at[2] {
            break;
        }
    }
    let squares: f64 = points()
        .map(|(x, y)| {
            let (x, y) = (x / scale - at[0], y / scale - at[1]);
            let off = (x * x + y * y).sqrt() - at[2];
            off * off
        })
        .sum();
    let rms = (squares / n).sqrt() * scale;
    let found = Circle {
        x: mx + at[0] * scale,
        y: my + at[1] * scale,
        radius: at[2].abs() * scale,
        rms,
        radius_error: rms * inverse.max(0.0).sqrt(),
    };
    [found.x, found.y, found.radius, found.rms].iter().all(|each| each.is_finite()).then_some(found)
}

/// The solution of three equations with their right sides, by elimination with pivoting.
fn solved(mut m: [[f64; 4]; 3]) -> Option<[f64; 3]> {
    for k in 0..3 {
        let largest = (k..3).max_by(|a, b| m[*a][k].abs().total_cmp(&m[*b][k].abs()))?;
        m.swap(k, largest);
        if m[k][k] == 0.0 || !m[k][k].is_finite() {
            return None;
        }
        for i in 0..3 {
            if i != k {
                let factor = m[i][k] / m[k][k];
                for j in k..4 {
                    m[i][j] -= factor * m[k][j];
                }
            }
        }
    }
    Some([m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]])
}

/// The side of the axes on which a track hangs below its pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Down {
    MinusY,
    PlusY,
    MinusX,
    PlusX,
}

impl Down {
    /// The axis nearest to the middle of the track.
    pub(super) fn of(x: &[f64], y: &[f64], pivot: (f64, f64)) -> Down {
        // The mean of the unit vectors would forget nothing; the plain mean is as near for a pendulum that hangs.
        let n = x.len().max(1) as f64;
        let dx = x.iter().map(|x| x - pivot.0).sum::<f64>() / n;
        let dy = y.iter().map(|y| y - pivot.1).sum::<f64>() / n;
        match (dx.abs() > dy.abs(), dx > 0.0, dy > 0.0) {
            (true, true, _) => Down::PlusX,
            (true, false, _) => Down::MinusX,
            (false, _, true) => Down::PlusY,
            (false, _, false) => Down::MinusY,
        }
    }

    /// In words.
    pub(super) fn words(self) -> &'static str {
        match self {
            Down::MinusY => "-y",
            Down::PlusY => "+y",
            Down::MinusX => "-x",
            Down::PlusX => "+x",
        }
    }

    /// Angles from down, counter-clockwise as a person sees it (y points down where the pendulum hangs to +y).
    pub(super) fn angles(self, x: &[f64], y: &[f64], pivot: (f64, f64)) -> Vec<f64> {
        let angle = |(x, y): (&f64, &f64)| {
            let (x, y) = (x - pivot.0, y - pivot.1);
            match self {
                Down::MinusY => libm::atan2(x, -y),
                Down::PlusY => libm::atan2(x, y),
                Down::MinusX => libm::atan2(-y, -x),
                Down::PlusX => libm::atan2(y, x),
            }
        };
        x.iter().zip(y).map(angle).collect()
    }
}
