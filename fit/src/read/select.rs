//! Which column holds the instants and which the motion: by what is stated, by names and units, by the look of the
//! numbers; where several could be the one, a question.

use super::axes;
use super::circle::circle;
use super::gate;
use super::groups::Group;
use super::heads::Head;
use super::names::{Meaning, words};
use super::options::{Options, Role};
use super::profile::Profile;
use super::record::Quantity;
use super::refusal::{Refusal, listed, quoted};
use super::table::Table;
use super::units::Dimension;
use crate::order::sorted;

/// What to make of the columns of a group.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Chosen {
    /// One column.
    One(Quantity, usize),
    /// Coordinates.
    Track(usize, usize),
    /// A gate: periods, and times in the dark.
    Gate(usize, Option<usize>),
    /// A count of the passages of a gate, whose times are those of the table.
    Passages(usize),
    /// Periods against angles of release.
    Swings(usize, usize),
}

/// The choice for one group, with its guesses.
#[derive(Clone, Debug)]
pub(super) struct Selection {
    pub time: Option<usize>,
    pub chosen: Chosen,
    pub understood: Vec<String>,
    /// The profile of an accelerometer's radial axis.
    pub radial: Option<Profile>,
}

/// What the choice works on.
struct Choice<'t> {
    heads: &'t [Head],
    headed: bool,
    profiles: &'t [Profile],
    columns: &'t [Vec<f64>],
    group: &'t Group,
    options: &'t Options,
    understood: Vec<String>,
    radial: Option<Profile>,
}

/// Chooses for a group.
pub(super) fn select(
    table: &Table<'_>,
    profiles: &[Profile],
    group: &Group,
    options: &Options,
) -> Result<Selection, Refusal> {
    let (heads, headed) = (&table.heads[..], table.headed);
    let mut choice = Choice {
        heads,
        headed,
        profiles,
        columns: &table.columns,
        group,
        options,
        understood: Vec::new(),
        radial: None,
    };
    let time = choice.time()?;
    let chosen = choice.values(time)?;
    Ok(Selection { time, chosen, understood: choice.understood, radial: choice.radial })
}

impl Choice<'_> {
    /// The column that the user names for a role.
    fn stated(&self, role: Role) -> Result<Option<usize>, Refusal> {
        let Some(name) = self.options.stated_column(role) else { return Ok(None) };
        let all: Vec<usize> = (0..self.heads.len()).collect();
        let by = |among: &[usize], written: bool| -> Vec<usize> {
            let same = |k: &&usize| {
                if written { self.heads[**k].written == name } else { self.heads[**k].name == name }
            };
            among.iter().filter(same).copied().collect()
        };
        for found in
            [by(&self.group.columns, true), by(&self.group.columns, false), by(&all, true), by(&all, false)]
        {
            if found.len() == 1 {
                return Ok(found.first().copied());
            }
        }
        let number = name.parse::<usize>().ok().filter(|number| (1..=self.heads.len()).contains(number));
        if let Some(number) = number {
            return Ok(Some(number - 1));
        }
        let several = if by(&all, false).len() > 1 { "names several columns" } else { "is no column" };
        let has = listed(&self.names(&all));
        let option = format!("--column {}={}", role.name(), super::refusal::plain(name));
        Err(Refusal::fault(None, format!("{option}: {several}; the file has {has}")))
    }

    fn names(&self, columns: &[usize]) -> Vec<String> {
        columns.iter().map(|k| self.heads[*k].written.clone()).collect()
    }

    /// The columns of the group with a meaning.
    fn of(&self, meaning: Meaning) -> Vec<usize> {
        self.group.columns.iter().copied().filter(|k| self.heads[*k].meaning == Some(meaning)).collect()
    }

    /// The column of the instants; none where a rate stands in for it, or where a table needs none.
    fn time(&mut self) -> Result<Option<usize>, Refusal> {
        if let Some(column) = self.stated(Role::Time)? {
            return Ok(Some(column));
        }
        let named = self.of(Meaning::Time);
        let rising = |k: &usize| self.profiles[*k].rising > 0.5 && self.profiles[*k].count > 1;
        if let Some(column) = named.iter().copied().find(rising).or(named.first().copied()) {
            if named.len() > 1 {
                let others: Vec<usize> = named.iter().copied().filter(|k| *k != column).collect();
                let (taken, left) = (quoted(&self.heads[column].written), listed(&self.names(&others)));
                self.understood.push(format!("Time is column {taken}, not {left}."));
            }
            if !(self.options.rate.is_some() && self.profiles[column].constant()) {
                return Ok(Some(column));
            }
        }
        if !self.of(Meaning::Period).is_empty() && !self.of(Meaning::Angle).is_empty() {
            return Ok(None);
        }
        if self.options.rate.is_some() {
            return Ok(None);
        }
        let unsaid = |k: &usize| {
            matches!(self.heads[*k].meaning, None | Some(Meaning::X | Meaning::Label | Meaning::Other))
        };
        let clock = |k: &usize| unsaid(k) && self.profiles[*k].clock();
        let clocks: Vec<usize> = self.group.columns.iter().copied().filter(clock).collect();
        let best = clocks.iter().copied().find(|k| !self.counter(*k));
        if let Some(column) = best.filter(|_| self.group.columns.len() > 1) {
            let name = quoted(&self.heads[column].written);
            self.understood.push(format!("Time is column {name}: it rises by even steps."));
            return Ok(Some(column));
        }
        Ok(None)
    }

    /// A counter of rows has no name of a time; large steps of a counter are ticks of a clock.
    fn counter(&self, k: usize) -> bool {
        self.profiles[k].counter()
    }

    /// The column or columns of the motion.
    fn values(&mut self, time: Option<usize>) -> Result<Chosen, Refusal> {
        for (role, quantity) in [
            (Role::Angle, Quantity::Angle),
            (Role::Velocity, Quantity::Velocity),
            (Role::Acceleration, Quantity::LinearAcceleration),
        ] {
            if let Some(column) = self.stated(role)? {
                let dimension = self.heads[column].unit.map(|unit| unit.dimension);
                let angular = dimension == Some(Dimension::AngularAcceleration);
                let quantity = if role == Role::Acceleration && angular {
                    Quantity::AngularAcceleration
                } else {
                    quantity
                };
                if let (Role::Angle, Some(period)) = (role, self.stated(Role::Period)?) {
                    return Ok(Chosen::Swings(column, period));
                }
                return Ok(Chosen::One(quantity, column));
            }
        }
        match (self.stated(Role::X)?, self.stated(Role::Y)?) {
            (Some(x), Some(y)) => return Ok(Chosen::Track(x, y)),
            (None, None) => {}
            _ => return Err(Refusal::fault(None, "a track needs both --column x=NAME and --column y=NAME")),
        }
        let with_period = self.stated(Role::Period)?;
        let free = |k: &usize| Some(*k) != time && self.profiles[*k].count > 0;
        let (moving, still): (Vec<usize>, Vec<usize>) = self
            .group
            .columns
            .iter()
            .copied()
            .filter(free)
            .partition(|k| self.profiles[*k].count < 2 || !self.profiles[*k].constant());
        let motion = |k: &&usize| {
            matches!(
                self.heads[**k].meaning,
                Some(Meaning::Angle | Meaning::X | Meaning::Y | Meaning::Velocity)
            )
        };
        let several = self.profiles.iter().any(|profile| profile.count > 1);
        for column in still.iter().filter(motion).filter(|_| several) {
            let name = quoted(&self.heads[*column].written);
            self.understood.push(format!("Column {name} does not move: left out."));
        }
        let among = |meaning: Option<Meaning>| -> Vec<usize> {
            moving.iter().copied().filter(|k| self.heads[*k].meaning == meaning).collect()
        };
        let (angles, periods) = (among(Some(Meaning::Angle)), among(Some(Meaning::Period)));
        if let Some(period) = with_period.or(periods.first().copied()) {
            if let (None, Some(angle)) = (time, angles.first()) {
                return Ok(Chosen::Swings(*angle, period));
            }
            if angles.is_empty() {
                return Ok(Chosen::Gate(period, among(Some(Meaning::Transit)).first().copied()));
            }
        }
        if !angles.is_empty() {
            let column = self.one_angle(angles)?;
            return Ok(Chosen::One(self.scaled(column), column));
        }
        let (x, y) = (among(Some(Meaning::X)), among(Some(Meaning::Y)));
        let third = self.group.columns.iter().find(|k| words(&self.heads[**k].name) == "z");
        if let (false, Some(z)) = (x.is_empty() || y.is_empty(), third) {
            let names = self.names(&[x[0], y[0], *z]);
            let answer = "--column velocity=NAME or --column acceleration=NAME, or both --column x=NAME and --column y=NAME";
            return Err(Refusal::question("what do the three axes hold?", names, answer));
        }
        if let ([x], [y]) = (&x[..], &y[..]) {
            return Ok(Chosen::Track(*x, *y));
        }
        let velocities = among(Some(Meaning::Velocity));
        if !velocities.is_empty() {
            return self.turned(velocities);
        }
        let accelerations = among(Some(Meaning::LinearAcceleration));
        if !accelerations.is_empty() {
            return Ok(self.moved(accelerations));
        }
        if let [column] = &among(Some(Meaning::AngularAcceleration))[..] {
            return Ok(Chosen::One(Quantity::AngularAcceleration, *column));
        }
        let mut unsaid = among(None);
        // Where the header is borrowed, `x` is the time and `y` the motion.
        unsaid.extend(x.into_iter().chain(y));
        let mut unsaid = sorted(&unsaid, usize::cmp);
        // What counts the rows is no motion, and may stand beside one.
        let counters = unsaid.iter().filter(|k| self.counter(**k)).count();
        if counters < unsaid.len() {
            unsaid.retain(|k| !self.counter(*k));
        }
        match unsaid[..] {
            [column] if time.is_some() && self.counter(column) && self.profiles[column].step == 1.0 => {
                gate::counted(&self.heads[column]).map(|()| Chosen::Passages(column))
            }
            _ => self.by_look(&unsaid, &moving, &still),
        }
    }

    fn scaled(&self, column: usize) -> Quantity {
        let arbitrary = self.heads[column].unit.is_some_and(|unit| unit.dimension == Dimension::Arbitrary);
        let stated = self.options.stated_unit(Role::Angle).is_some();
        if arbitrary && !stated { Quantity::AngleUnscaled } else { Quantity::Angle }
    }

    /// Of several angles the one with a unit; of two copies the first.
    fn one_angle(&mut self, angles: Vec<usize>) -> Result<usize, Refusal> {
        let is_angle = |k: &usize| self.heads[*k].unit.is_some_and(|unit| unit.dimension == Dimension::Angle);
        let with_unit: Vec<usize> = angles.iter().copied().filter(is_angle).collect();
        let left = if with_unit.is_empty() { angles } else { with_unit };
        let turns = |k: usize| {
            let factor = self.heads[k].unit.map_or(1.0, |unit| unit.factor);
            (self.profiles[k].least * factor, self.profiles[k].most * factor, self.profiles[k].mean * factor)
        };
        let first = left[0];
        let copy = |k: &usize| {
            let (a, b) = (turns(first), turns(*k));
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-3 * (a.abs() + b.abs());
            near(a.0, b.0) && near(a.1, b.1) && (near(a.2, b.2) || a.2.abs() < 1e-3 * a.1.abs())
        };
        if !left[1..].iter().all(copy) {
            let names = self.names(&left);
            return Err(Refusal::question("which column is the angle?", names, "--column angle=NAME"));
        }
        if left.len() > 1 {
            let (name, others) = (quoted(&self.heads[first].written), listed(&self.names(&left[1..])));
            self.understood.push(format!("Column {name} and {others} hold one angle: the first is taken."));
        }
        Ok(first)
    }

    /// A gyroscope's axis.
    fn turned(&mut self, columns: Vec<usize>) -> Result<Chosen, Refusal> {
        let profiles: Vec<Profile> = columns.iter().map(|k| self.profiles[*k]).collect();
        let Some((axis, share)) = axes::turned(&profiles) else {
            return Err(Refusal::fault(None, "no angular velocity moves"));
        };
        let column = columns[axis];
        if columns.len() > 1 {
            let stems: Vec<String> = columns.iter().map(|k| stem(&self.heads[*k].name)).collect();
            if stems.iter().any(|stem| *stem != stems[0]) {
                let names = self.names(&columns);
                let question = "which column is the angular velocity?";
                return Err(Refusal::question(question, names, "--column velocity=NAME"));
            }
            let name = quoted(&self.heads[column].written);
            let also = if share > 0.1 {
                format!("; another axis has {:.0} % of it", 100.0 * share)
            } else {
                String::new()
            };
            self.understood
                .push(format!("The angular velocity is column {name}, the axis that moves most{also}."));
        }
        Ok(Chosen::One(Quantity::Velocity, column))
    }

    /// An accelerometer's axis.
    fn moved(&mut self, columns: Vec<usize>) -> Chosen {
        let profiles: Vec<Profile> = columns.iter().map(|k| self.profiles[*k]).collect();
        let (axis, radial) = axes::moved(&profiles).unwrap_or((0, None));
        let column = columns[axis];
        self.radial = radial.map(|k| profiles[k]);
        if columns.len() > 1 {
            let name = quoted(&self.heads[column].written);
            let why = radial.map_or("the axis that moves most".to_owned(), |k| {
                let other = quoted(&self.heads[columns[k]].written);
                format!("along the path; {other} is radial and swings twice in a period")
            });
            self.understood.push(format!("The acceleration is column {name}, {why}."));
        }
        Chosen::One(Quantity::LinearAcceleration, column)
    }

    /// Columns without a meaning: one alone is the angle; two on a circle are a track; more are a question.
    fn by_look(&mut self, unsaid: &[usize], moving: &[usize], still: &[usize]) -> Result<Chosen, Refusal> {
        match unsaid {
            [] => {
                // A distance without a pivot: small swings have its period.
                let distance = |k: &&usize| {
                    let length = self.heads[**k].unit.is_some_and(|unit| unit.dimension == Dimension::Length);
                    length && !self.profiles[**k].clock()
                };
                if let [column] = moving.iter().filter(distance).copied().collect::<Vec<usize>>()[..] {
                    return Ok(Chosen::One(Quantity::AngleUnscaled, column));
                }
                let empty = |k: &&usize| self.profiles[**k].count == 0 && self.heads[**k].meaning.is_some();
                let alone = moving.is_empty() && still.is_empty();
                if let Some(column) = self.group.columns.iter().find(empty).filter(|_| alone) {
                    let name = quoted(&self.heads[*column].written);
                    return Err(Refusal::fault(None, format!("column {name} holds no number")));
                }
                let all = self.names(&self.group.columns);
                let reason = if moving.is_empty() && !still.is_empty() {
                    format!("no column moves: {}", listed(&self.names(still)))
                } else {
                    format!(
                        "has no column of an angle, an angular velocity, an acceleration, a position x, y or a period; it has {}",
                        listed(&all)
                    )
                };
                Err(Refusal::fault(None, reason))
            }
            [column] => {
                let name = quoted(&self.heads[*column].written);
                self.understood
                    .push(format!("The angle is column {name}: no other column moves with the time."));
                let length = self.heads[*column].unit.is_some_and(|unit| unit.dimension == Dimension::Length);
                let quantity = if length { Quantity::AngleUnscaled } else { self.scaled(*column) };
                Ok(Chosen::One(quantity, *column))
            }
            [x, y] if !self.headed && self.on_circle(*x, *y) => {
                let names = (quoted(&self.heads[*x].written), quoted(&self.heads[*y].written));
                self.understood
                    .push(format!("Columns {} and {} lie on a circle: a position x, y.", names.0, names.1));
                Ok(Chosen::Track(*x, *y))
            }
            several => {
                let names = self.names(several);
                Err(Refusal::question("which column is the angle?", names, "--column angle=NAME"))
            }
        }
    }

    /// Whether two columns are coordinates of one swing: near a circle that is not much larger than the arc.
    fn on_circle(&self, x: usize, y: usize) -> bool {
        let points =
            self.columns[x].iter().zip(&self.columns[y]).filter(|(x, y)| x.is_finite() && y.is_finite());
        let (xs, ys): (Vec<f64>, Vec<f64>) = points.unzip();
        let range = self.profiles[x].range().max(self.profiles[y].range());
        circle(&xs, &ys, None).is_some_and(|circle| circle.rms < 0.03 * range && circle.radius < 50.0 * range)
    }
}

/// A name without the letter of its axis.
fn stem(name: &str) -> String {
    let words = words(name);
    match words.strip_suffix(['x', 'y', 'z']) {
        Some(stem) => stem.trim_end().to_owned(),
        None => words,
    }
}
