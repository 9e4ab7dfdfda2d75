//! A project of the video tool Tracker (`.trk`, XML): frame numbers, the time of a frame, and the places of each point mass
//! in pixels with y down, as the text of a table.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::refusal::{Refusal, quoted};
use crate::decimal;
use crate::digits::Shown;
use crate::order::sorted;
use crate::product::product;

/// Point masses that are read: those with the most steps.
const MOST_TRACKS: usize = 16;

/// What the file has of one point mass.
#[derive(Clone, Default)]
struct Mass {
    name: String,
    /// Frames with their places, as the file writes these.
    steps: Vec<(u64, String, String)>,
}

/// What is read on the way through the file.
#[derive(Default)]
struct Project {
    /// As the file writes it.
    milliseconds: Option<String>,
    masses: Vec<Mass>,
}

/// Whether a text is such a project.
pub(super) fn is_project(text: &str) -> bool {
    let start: String = text.chars().take(2000).collect();
    start.trim_start().starts_with('<') && start.contains("cabrillo.tracker")
}

/// The table of a project, one track beside the other, and what to say of it.
pub(super) fn table_of(text: &str) -> Result<(String, Vec<String>), Refusal> {
    let project = project(text)?;
    let step = project.milliseconds.unwrap_or_default();
    let milliseconds = decimal::number(&step).filter(|step| *step > 0.0).ok_or_else(|| {
        Refusal::fault(
            None,
            "a Tracker project without the time of a frame (delta_t); give the exported table",
        )
    })?;
    let masses: Vec<Mass> = project.masses.into_iter().filter(|mass| !mass.steps.is_empty()).collect();
    if masses.is_empty() {
        return Err(Refusal::fault(None, "a Tracker project without a tracked point mass"));
    }
    // Tracks stand side by side: more of them would make a table that is mostly blank.
    let mut masses = sorted(&masses, |a, b| b.steps.len().cmp(&a.steps.len()));
    masses.truncate(MOST_TRACKS);
    masses.iter_mut().for_each(|mass| mass.steps = sorted(&mass.steps, |a, b| a.0.cmp(&b.0)));
    let names: Vec<String> = masses.iter().map(|mass| quoted(&mass.name)).collect();
    let rows = masses.iter().map(|mass| mass.steps.len()).max().unwrap_or(0);
    let mut table = String::new();
    for k in 0..masses.len() {
        table += if k > 0 { "\t" } else { "" };
        table += &format!("Run {}: t (ms)\tRun {}: x (px)\tRun {}: y (px)", k + 1, k + 1, k + 1);
    }
    for row in 0..rows {
        table.push('\n');
        for (k, mass) in masses.iter().enumerate() {
            table += if k > 0 { "\t" } else { "" };
            match mass.steps.get(row) {
                // Signs as the screen has them: y down, so that the pendulum hangs to +y.
                Some((frame, x, y)) => {
                    let t = product(&frame.to_string(), &step).unwrap_or_default();
                    table += &format!("{t}\t{x}\t{y}");
                }
                None => table += "\t\t",
            }
        }
    }
    let said = format!(
        "A Tracker project: frames of {} ms, places in pixels with y down, tracks {}.",
        Shown(milliseconds),
        names.join(", ")
    );
    Ok((table, vec![said]))
}

fn project(text: &str) -> Result<Project, Refusal> {
    let mut reader = Reader::from_str(text);
    reader.config_mut().check_end_names = true;
    let mut found = Project::default();
    // The classes of the open objects, and the names of the open properties with their text.
    let (mut classes, mut properties): (Vec<String>, Vec<(String, String)>) = (Vec::new(), Vec::new());
    let (mut frame, mut x, mut y) = (None, None, None);
    loop {
        let at = reader.buffer_position();
        let event = reader.read_event().map_err(|error| {
            let line = text.as_bytes()[..(at as usize).min(text.len())]
                .iter()
                .filter(|byte| **byte == b'\n')
                .count()
                + 1;
            Refusal::fault(
                Some(line),
                format!("no well-formed XML: {}", super::refusal::plain(&error.to_string())),
            )
        })?;
        match event {
            Event::Start(tag) if tag.name().as_ref() == "object" => {
                let class = attribute(&tag, "class");
                if class.ends_with(".PointMass") {
                    found.masses.push(Mass::default());
                }
                if class.ends_with("PointMass$FrameData") {
                    (x, y) = (None, None);
                }
                classes.push(class);
            }
            Event::Start(tag) if tag.name().as_ref() == "property" => {
                let name = attribute(&tag, "name");
                if classes.last().is_some_and(|class| class.ends_with(".PointMass")) {
                    let digits = name.trim_start_matches('[').trim_end_matches(']');
                    frame =
                        digits.parse().ok().filter(|frame: &u64| name.starts_with('[') && *frame < 1 << 53);
                }
                properties.push((name, String::new()));
            }
            Event::Text(part) => {
                if let Some(last) = properties.last_mut().filter(|last| last.1.len() < 1000) {
                    let part: &str = part.as_ref();
                    last.1.extend(part.trim().chars().take(1000));
                }
            }
            Event::End(tag) if tag.name().as_ref() == "property" => {
                let Some((name, value)) = properties.pop() else { continue };
                let class = classes.last().map_or("", String::as_str);
                let number =
                    || decimal::number(&value).filter(|value| value.is_finite()).map(|_| value.clone());
                if class.ends_with("ClipControl") && name == "delta_t" {
                    found.milliseconds = number();
                } else if class.ends_with(".PointMass") && name == "name" {
                    if let Some(mass) = found.masses.last_mut() {
                        mass.name = value;
                    }
                } else if class.ends_with("PointMass$FrameData") {
                    match name.as_str() {
                        "x" => x = number(),
                        "y" => y = number(),
                        _ => {}
                    }
                }
            }
            Event::End(tag) if tag.name().as_ref() == "object" => {
                let class = classes.pop().unwrap_or_default();
                if !class.ends_with("PointMass$FrameData") {
                    continue;
                }
                if let (Some(frame), Some(x), Some(y), Some(mass)) =
                    (frame, x.take(), y.take(), found.masses.last_mut())
                {
                    mass.steps.push((frame, x, y));
                }
            }
            Event::Eof => return Ok(found),
            _ => {}
        }
    }
}

/// The value of an attribute; empty if there is none.
fn attribute(tag: &BytesStart<'_>, name: &str) -> String {
    let found = tag.attributes().with_checks(false).flatten().find(|each| each.key.as_ref() == name);
    found.map_or_else(String::new, |each| {
        let value: &str = each.value.as_ref();
        value.chars().take(200).collect()
    })
}
