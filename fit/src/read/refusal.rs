//! The one error of the reader: a fault of the file, or the question whose answer the file does not hold. Both print as
//! one line, whatever the file contains.

use core::fmt;

/// Why there is no record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The file, or what was stated about it, cannot be right.
    Fault {
        /// The file as named.
        file: String,
        /// The line, from 1, where one is to blame.
        line: Option<usize>,
        /// What was found, and what is allowed.
        reason: String,
    },
    /// The file may be read in several ways and only the user knows which.
    Question {
        /// The file as named.
        file: String,
        /// The question, with its question mark.
        question: String,
        /// What may be answered; empty if anything may.
        candidates: Vec<String>,
        /// How to answer, to be read after "write".
        answer: String,
    },
}

impl Refusal {
    pub(super) fn fault(line: Option<usize>, reason: impl Into<String>) -> Refusal {
        Refusal::Fault { file: String::new(), line, reason: reason.into() }
    }

    pub(super) fn question(
        question: impl Into<String>,
        candidates: Vec<String>,
        answer: impl Into<String>,
    ) -> Refusal {
        let (question, answer) = (question.into(), answer.into());
        Refusal::Question { file: String::new(), question, candidates, answer }
    }

    /// What a fault says without file and line.
    pub(super) fn reason(&self) -> String {
        match self {
            Refusal::Fault { reason, .. } => reason.clone(),
            Refusal::Question { question, .. } => question.clone(),
        }
    }

    /// The same with the name of the file: the rooms below do not know it.
    pub(super) fn of(mut self, name: &str) -> Refusal {
        match &mut self {
            Refusal::Fault { file, .. } | Refusal::Question { file, .. } => *file = name.to_owned(),
        }
        self
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Fault { file, line, reason } => {
                if !file.is_empty() {
                    write!(f, "{}: ", plain(file))?;
                }
                if let Some(line) = line {
                    write!(f, "line {line}: ")?;
                }
                f.write_str(reason)
            }
            Refusal::Question { file, question, candidates, answer } => {
                write!(f, "{}: {question} ", plain(file))?;
                if !candidates.is_empty() {
                    write!(f, "{}; ", listed(candidates))?;
                }
                write!(f, "write {answer}")
            }
        }
    }
}

impl core::error::Error for Refusal {}

/// Characters of a cell or a name that a message shows.
const SHOWN: usize = 60;

/// A text of the file for a message: quoted, without control characters, cut where it is long.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", plain(text))
}

/// A text without what would break the line or the terminal, cut where it is long.
pub(super) fn plain(text: &str) -> String {
    let mut shown: String = text
        .chars()
        .take(SHOWN)
        .flat_map(|each| {
            let hidden =
                each.is_control() || matches!(each, '\u{2028}' | '\u{2029}' | '\u{202a}'..='\u{202e}');
            if hidden { each.escape_default().collect::<Vec<_>>() } else { vec![each] }
        })
        .collect();
    if text.chars().nth(SHOWN).is_some() {
        shown.push_str("...");
    }
    shown
}

/// Names for a message, twelve at most.
pub(super) fn listed(names: &[String]) -> String {
    let shown: Vec<String> = names.iter().take(12).map(|name| plain(name)).collect();
    shown.join(", ") + if names.len() > 12 { ", ..." } else { "" }
}
