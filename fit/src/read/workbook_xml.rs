//! XLSX (ECMA-376): the cells of every sheet, in the order of the file, by the XML parser alone: nothing is allocated for
//! cells that are not there.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::archive::Archive;
use super::refusal::{Refusal, plain};
use super::workbook::Sheet;
use crate::order::sorted;

/// The sheets of a workbook.
pub(super) fn sheets(archive: &mut Archive<'_>) -> Result<Vec<Sheet>, Refusal> {
    let mut names = archive.names();
    names.retain(|name| name.starts_with("xl/worksheets/") && name.ends_with(".xml"));
    // sheet2 before sheet10.
    let mut names = sorted(&names, |a, b| a.len().cmp(&b.len()).then_with(|| a.cmp(b)));
    names.truncate(32);
    let shared = match archive.names().iter().find(|name| *name == "xl/sharedStrings.xml") {
        Some(name) => shared_strings(&text(archive.bytes(name)?)?)?,
        None => Vec::new(),
    };
    let mut sheets = Vec::new();
    for name in names {
        let xml = text(archive.bytes(&name)?)?;
        let stem = name.trim_start_matches("xl/worksheets/").trim_end_matches(".xml").to_owned();
        sheets.push(sheet(Sheet::named(stem), &xml, &shared)?);
    }
    Ok(sheets)
}

fn text(bytes: Vec<u8>) -> Result<String, Refusal> {
    String::from_utf8(bytes).map_err(|_| Refusal::fault(None, "an XLSX workbook that is not UTF-8"))
}

fn event<'a>(reader: &mut Reader<&'a [u8]>) -> Result<Event<'a>, Refusal> {
    reader.read_event().map_err(|error| {
        Refusal::fault(None, format!("an XLSX workbook with bad XML: {}", plain(&error.to_string())))
    })
}

/// The strings that cells refer to by number.
fn shared_strings(xml: &str) -> Result<Vec<String>, Refusal> {
    let mut reader = Reader::from_str(xml);
    let (mut strings, mut inside, mut hidden) = (Vec::new(), false, false);
    loop {
        match event(&mut reader)? {
            Event::Start(tag) => match local(&tag) {
                "si" => strings.push(String::new()),
                "t" => inside = !hidden,
                // A reading aid beside the word is no part of it.
                "rPh" => hidden = true,
                _ => {}
            },
            Event::Empty(tag) if local(&tag) == "si" => strings.push(String::new()),
            Event::End(tag) if tag.local_name().as_ref() == "t" => inside = false,
            Event::End(tag) if tag.local_name().as_ref() == "rPh" => hidden = false,
            Event::Text(part) if inside => append(strings.last_mut(), part.as_ref()),
            Event::GeneralRef(part) if inside => append(strings.last_mut(), entity(part.as_ref())),
            Event::Eof => return Ok(strings),
            _ => {}
        }
    }
}

fn append(string: Option<&mut String>, part: &str) {
    if let Some(string) = string {
        string.push_str(part);
    }
}

/// The five entities of XML; others stand for nothing that a table needs.
fn entity(name: &str) -> &'static str {
    match name {
        "lt" => "<",
        "gt" => ">",
        "amp" => "&",
        "quot" => "\"",
        "apos" => "'",
        _ => " ",
    }
}

fn local<'a>(tag: &'a BytesStart<'_>) -> &'a str {
    let name = tag.name().into_inner();
    name.rsplit(':').next().unwrap_or(name)
}

fn sheet(mut sheet: Sheet, xml: &str, shared: &[String]) -> Result<Sheet, Refusal> {
    let mut reader = Reader::from_str(xml);
    let (mut row, mut column) = (0usize, 0usize);
    let (mut kind, mut value, mut inside) = (String::new(), String::new(), false);
    let (mut rows, mut cells) = (0usize, 0usize);
    loop {
        match event(&mut reader)? {
            Event::Start(tag) | Event::Empty(tag) if local(&tag) == "row" => {
                row = attribute(&tag, "r").parse::<usize>().map_or(rows, |row| row.saturating_sub(1));
                (rows, cells) = (row.saturating_add(1), 0);
            }
            Event::Start(tag) => match local(&tag) {
                "c" => {
                    let at = column_of(&attribute(&tag, "r")).unwrap_or(cells);
                    (column, cells) = (at, at.saturating_add(1));
                    kind = attribute(&tag, "t");
                    value.clear();
                }
                "v" | "t" => inside = true,
                _ => {}
            },
            Event::Text(part) if inside => value.push_str(part.as_ref()),
            Event::GeneralRef(part) if inside => value.push_str(entity(part.as_ref())),
            Event::End(tag) => match tag.local_name().as_ref() {
                "v" | "t" => inside = false,
                "c" => {
                    let text = match (kind.as_str(), value.trim().parse::<usize>()) {
                        ("s", Ok(k)) => shared.get(k).map_or("", String::as_str),
                        _ => value.trim(),
                    };
                    sheet.put(row, column, text)?;
                }
                _ => {}
            },
            Event::Eof => return Ok(sheet),
            _ => {}
        }
    }
}

/// `BC7`: column 54, from 0.
fn column_of(reference: &str) -> Option<usize> {
    let letters = reference.bytes().take_while(u8::is_ascii_alphabetic);
    let mut column = 0usize;
    for letter in letters.take(4) {
        column = column * 26 + usize::from(letter.to_ascii_uppercase() - b'A') + 1;
    }
    column.checked_sub(1)
}

fn attribute(tag: &BytesStart<'_>, name: &str) -> String {
    let found = tag.attributes().with_checks(false).flatten().find(|each| each.key.as_ref() == name);
    found.map_or_else(String::new, |each| {
        let value: &str = each.value.as_ref();
        value.chars().take(40).collect()
    })
}
