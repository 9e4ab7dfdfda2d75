//! What is stated is lines of a name, a tab and a value: their parts, and the refusals of those that are not understood.

/// The name and the value of each line.
pub fn statements(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.lines().map(|line| line.split_once('\t').unwrap_or((line, "")))
}

/// The line of a refusal as the command line prints it: the name of the file, a colon, what is wrong.
pub fn of_file(file: &str, reason: &str) -> String {
    let reason = reason.strip_prefix(": ").unwrap_or(reason);
    if file.is_empty() { reason.to_owned() } else { format!("{file}: {reason}") }
}

/// That of a statement.
pub fn refused(name: &str, text: &str) -> String {
    format!("{name} = {text:?}: is not understood")
}
