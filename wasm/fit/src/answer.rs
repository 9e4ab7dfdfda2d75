//! The answers: JSON, and columns of numbers beside it, four for each record: times or turning angles, what was measured, that less what
//! was fitted, and of periods the turning angle of each by the fit, in rad.

use crate::json::json;
use crate::lines::of_file;
use crate::stated::Stated;
use libration_fit::fit::{Data, Fit, Grade, Residuals, Together, Verdict, fit, fit_lengths, fit_runs};
use serde::Serialize;

/// A result with the grades of its verdicts, in their order.
#[derive(Serialize)]
struct Fitted<'a> {
    fit: &'a Fit,
    grades: Vec<Grade>,
    stands: bool,
}

/// Several records together: what they share, and each alone.
#[derive(Serialize)]
struct Joint<'a> {
    together: &'a Together,
    /// Of the verdicts of all.
    grades: Vec<Grade>,
    /// Whether no verdict, of all or of one record, forbids to quote it.
    stands: bool,
    records: Vec<Fitted<'a>>,
}

/// JSON with columns, or a refusal.
type Answer = Result<(String, Vec<Vec<f64>>), String>;

fn grades(verdicts: &[Verdict]) -> Vec<Grade> {
    verdicts.iter().map(|Verdict { grade, .. }| *grade).collect()
}

impl Fitted<'_> {
    fn of(fit: &Fit) -> Fitted<'_> {
        Fitted { fit, grades: grades(&fit.verdicts), stands: fit.stands() }
    }
}

/// The columns of a result, which leave it.
fn columns(fit: &mut Fit) -> [Vec<f64>; 4] {
    let Residuals { t, measured, residual, swings } = core::mem::take(&mut fit.residuals);
    [t, measured, residual, swings]
}

/// The fit of data.
pub fn fitted(data: &Data, stated: &Stated) -> Answer {
    let refused = |reason: &str| of_file(&stated.file, reason);
    let mut found = fit(data, &stated.known).map_err(|refusal| refused(&refusal.to_string()))?;
    let columns = columns(&mut found);
    Ok((json(&Fitted::of(&found)), columns.into()))
}

/// The fit of several records: of one pendulum, or of one g at several lengths.
pub fn together(all: &[Data], stated: &Stated) -> Answer {
    let found = match &stated.lengths[..] {
        [] | [_] => fit_runs(all, &stated.known),
        lengths => fit_lengths(all, lengths, &stated.known),
    };
    let mut found = found.map_err(|refusal| refusal.to_string())?;
    // Each record stands beside what they share, with its grades.
    let mut fits = core::mem::take(&mut found.fits);
    let columns = fits.iter_mut().flat_map(columns).collect();
    let grades = grades(&found.verdicts);
    let stands = !grades.contains(&Grade::Refuted) && fits.iter().all(Fit::stands);
    let records = fits.iter().map(Fitted::of).collect();
    Ok((json(&Joint { together: &found, grades, stands, records }), columns))
}
