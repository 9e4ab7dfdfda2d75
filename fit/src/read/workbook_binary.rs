//! XLS (BIFF8, [MS-XLS]): the records of cells in the stream `Workbook`. Every length is checked against the stream, and
//! nothing is allocated for cells that are not there.

use std::io::{Cursor, Read};

use super::refusal::{Refusal, plain};
use super::workbook::{Sheet, number};

const BOF: u16 = 0x0809;
const BOUND_SHEET: u16 = 0x0085;
const CONTINUE: u16 = 0x003c;
const FORMULA: u16 = 0x0006;
const LABEL: u16 = 0x0204;
const LABEL_SST: u16 = 0x00fd;
const MUL_RK: u16 = 0x00bd;
const NUMBER: u16 = 0x0203;
const RK: u16 = 0x027e;
const SST: u16 = 0x00fc;
const WORKSHEET: u16 = 0x0010;

/// The sheets of a workbook.
pub(super) fn sheets(bytes: &[u8]) -> Result<Vec<Sheet>, Refusal> {
    let broken = |error: std::io::Error| {
        Refusal::fault(None, format!("an XLS workbook that cannot be opened: {}", plain(&error.to_string())))
    };
    let mut file = cfb::CompoundFile::open(Cursor::new(bytes)).map_err(broken)?;
    let name = if file.is_stream("/Workbook") { "/Workbook" } else { "/Book" };
    let mut stream = Vec::new();
    let limit = bytes.len() as u64;
    file.open_stream(name).map_err(broken)?.take(limit).read_to_end(&mut stream).map_err(broken)?;
    read(&stream)
}

fn read(stream: &[u8]) -> Result<Vec<Sheet>, Refusal> {
    let mut strings: Vec<String> = Vec::new();
    let mut names: Vec<String> = Vec::new();
    let mut sheets: Vec<Sheet> = Vec::new();
    let mut in_sheet = false;
    let mut records = Records { stream }.peekable();
    while let Some((kind, data)) = records.next() {
        match kind {
            BOF if word(data, 0) != Some(0x0600) => {
                return Err(Refusal::fault(
                    None,
                    "an XLS workbook older than Excel 97; save it as XLSX or CSV",
                ));
            }
            BOF => {
                in_sheet = word(data, 2) == Some(WORKSHEET);
                if in_sheet {
                    let name = names.get(sheets.len()).cloned().unwrap_or_default();
                    sheets.push(Sheet::named(name));
                }
            }
            BOUND_SHEET => names.extend(data.get(6..).and_then(|data| string(data, usize::from(data[0]), 1))),
            SST => {
                let mut parts = vec![data];
                while let Some((_, more)) = records.next_if(|next| next.0 == CONTINUE) {
                    parts.push(more);
                }
                strings = shared_strings(&parts);
            }
            _ if in_sheet => {
                if let Some(sheet) = sheets.last_mut() {
                    cell(sheet, kind, data, &strings)?;
                }
            }
            _ => {}
        }
    }
    Ok(sheets)
}

/// The records of a stream: kind, length, data.
struct Records<'a> {
    stream: &'a [u8],
}

impl<'a> Iterator for Records<'a> {
    type Item = (u16, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let (kind, length) = (word(self.stream, 0)?, usize::from(word(self.stream, 2)?));
        let data = self.stream.get(4..4 + length)?;
        self.stream = &self.stream[4 + length..];
        Some((kind, data))
    }
}

fn word(data: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_le_bytes(data.get(at..at + 2)?.try_into().ok()?))
}

fn double_word(data: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(data.get(at..at + 4)?.try_into().ok()?))
}

fn double(data: &[u8], at: usize) -> Option<f64> {
    Some(f64::from_le_bytes(data.get(at..at + 8)?.try_into().ok()?))
}

/// A number packed into 30 bits: the upper part of a double or a whole number, perhaps in hundredths.
fn packed(rk: u32) -> f64 {
    let value =
        if rk & 2 == 0 { f64::from_bits(u64::from(rk & !3) << 32) } else { f64::from(rk as i32 >> 2) };
    if rk & 1 == 0 { value } else { value / 100.0 }
}

/// Characters behind a length and a byte of flags; `offset` is where the flags stand.
fn string(data: &[u8], length: usize, offset: usize) -> Option<String> {
    let wide = data.get(offset)? & 1 == 1;
    let data = data.get(offset + 1..)?;
    Some(if wide {
        let units: Vec<u16> =
            data.chunks_exact(2).take(length).map(|pair| u16::from_le_bytes([pair[0], pair[1]])).collect();
        String::from_utf16_lossy(&units)
    } else {
        data.iter().take(length).map(|byte| char::from(*byte)).collect()
    })
}

fn cell(sheet: &mut Sheet, kind: u16, data: &[u8], strings: &[String]) -> Result<(), Refusal> {
    let (Some(row), Some(column)) = (word(data, 0), word(data, 2)) else { return Ok(()) };
    let (row, column) = (usize::from(row), usize::from(column));
    let text = match kind {
        NUMBER => double(data, 6).map(number),
        RK => double_word(data, 6).map(|rk| number(packed(rk))),
        // Two last bytes of 0xffff mark a result that is no number.
        FORMULA if word(data, 12) != Some(0xffff) => double(data, 6).map(number),
        LABEL_SST => double_word(data, 6).and_then(|k| strings.get(k as usize).cloned()),
        LABEL => data.get(6..).and_then(|rest| string(rest, usize::from(word(rest, 0)?), 2)),
        MUL_RK => {
            let count = data.len().saturating_sub(6) / 6;
            for k in 0..count {
                if let Some(rk) = double_word(data, 4 + 6 * k + 2) {
                    sheet.put(row, column + k, &number(packed(rk)))?;
                }
            }
            None
        }
        _ => None,
    };
    text.map_or(Ok(()), |text| sheet.put(row, column, &text))
}

/// The shared strings: each may run on into the next part, which then begins with a byte of flags.
fn shared_strings(parts: &[&[u8]]) -> Vec<String> {
    let mut strings = Vec::new();
    let mut at = Parts { parts, part: 0, byte: 8 };
    while let Some(string) = at.string() {
        strings.push(string);
    }
    strings
}

/// A place in the parts of a long record.
struct Parts<'a> {
    parts: &'a [&'a [u8]],
    part: usize,
    byte: usize,
}

impl Parts<'_> {
    fn byte(&mut self) -> Option<u8> {
        while self.byte >= self.parts.get(self.part)?.len() {
            (self.part, self.byte) = (self.part + 1, 0);
        }
        self.byte += 1;
        Some(self.parts[self.part][self.byte - 1])
    }

    fn word(&mut self) -> Option<u16> {
        Some(u16::from_le_bytes([self.byte()?, self.byte()?]))
    }

    fn string(&mut self) -> Option<String> {
        let length = usize::from(self.word()?);
        let mut flags = self.byte()?;
        let runs = if flags & 8 != 0 { usize::from(self.word()?) } else { 0 };
        let extra = if flags & 4 != 0 { u32::from(self.word()?) | u32::from(self.word()?) << 16 } else { 0 };
        let mut units = Vec::new();
        for _ in 0..length {
            if self.byte >= self.parts.get(self.part)?.len() {
                (self.part, self.byte) = (self.part + 1, 0);
                flags = self.byte()?;
            }
            units.push(if flags & 1 == 1 { self.word()? } else { u16::from(self.byte()?) });
        }
        for _ in 0..4 * runs + extra as usize {
            self.byte()?;
        }
        Some(String::from_utf16_lossy(&units))
    }
}
