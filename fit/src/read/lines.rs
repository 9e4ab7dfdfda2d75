//! The lines of a text with their numbers. `\n`, `\r\n`, `\r` and `\r\r\n` each end one line.

/// One line without its end, its number from 1 and its first byte.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line<'a> {
    pub number: usize,
    pub start: usize,
    pub text: &'a str,
}

/// Every line that holds more than blanks and separators of nothing; blank ones are only counted.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    lines_from(text, 0, 1)
}

/// The same from a place where a line starts.
pub(super) fn lines_from(text: &str, start: usize, number: usize) -> impl Iterator<Item = Line<'_>> {
    let (mut at, mut number) = (start, number);
    let bytes = text.as_bytes();
    core::iter::from_fn(move || {
        while at < bytes.len() {
            // Most of a file of blank lines goes by here.
            if bytes[at] == b'\n' {
                (at, number) = (at + 1, number + 1);
                continue;
            }
            let rest = &bytes[at..];
            let length = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
            let line = Line { number, start: at, text: &text[at..at + length] };
            at += length + line_end(&rest[length..]);
            number += 1;
            if !line.text.trim().is_empty() {
                return Some(line);
            }
        }
        None
    })
}

/// How many bytes end the line.
fn line_end(rest: &[u8]) -> usize {
    match rest {
        [b'\r', b'\r', b'\n', ..] => 3,
        [b'\r', b'\n', ..] => 2,
        [_, ..] => 1,
        [] => 0,
    }
}

/// The line that starts at a byte, without its end.
pub(super) fn line_at(text: &str, start: usize) -> &str {
    let rest = &text[start..];
    rest.split(['\n', '\r']).next().unwrap_or("")
}

/// What stands behind the mark of a comment: `#`, `%` or `//`; `None` if the line has none.
pub(super) fn comment(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let marked = text.starts_with(['#', '%']) || text.starts_with("//");
    marked.then(|| text.trim_start_matches(['#', '%', '/', ' ']))
}
