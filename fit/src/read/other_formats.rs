//! Files that are no table though a reader of tables would find one in some of them: MATLAB, HDF, Parquet, pages of HTML, PDF, gzip,
//! JSON.

/// The first bytes of files of arrays. A table may begin with the same letters in another case.
const ARRAYS: [&[u8]; 3] = [b"MATLAB 5.0", b"\x89HDF", b"PAR1"];

/// The first bytes of a text, in small letters, and what they are.
const MARKS: [(&[u8], &str); 4] = [
    (b"\x1f\x8b", "is packed by gzip; unpack it first"),
    (b"%pdf", "is a PDF; give the file of the raw data"),
    (b"<!doctype html", "is a page of HTML; save the table as CSV"),
    (b"<html", "is a page of HTML; save the table as CSV"),
];

/// What a file is, as a refusal says it; none if it may be a table.
pub fn named(bytes: &[u8]) -> Option<&'static str> {
    if ARRAYS.iter().any(|mark| bytes.starts_with(mark)) {
        return Some("a MATLAB, HDF or Parquet file; load it and hand over its arrays, or save it as CSV");
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii();
    let begins = |mark: &[u8]| text.get(..mark.len()).is_some_and(|start| start.eq_ignore_ascii_case(mark));
    if let Some((_, what)) = MARKS.iter().find(|(mark, _)| begins(mark)) {
        return Some(what);
    }
    // A head of units such as `[s]` ends with no bracket: the rows follow it.
    let json = matches!((text.first()?, text.last()?), (b'{', b'}') | (b'[', b']'));
    json.then_some("is JSON; write a table of text, or give its times and values to libration.fit in Python")
}

#[cfg(test)]
mod tests {
    use super::named;

    #[test]
    fn what_is_no_table_is_named() {
        for text in
            [" \n<!DOCTYPE html>", "\u{feff}<html>", "%PDF-1.4", "{\"t\": [0, 1]}\n", "[[0, 1], [1, 2]]"]
        {
            assert!(named(text.as_bytes()).is_some(), "{text}");
        }
        assert!(named(b"\x1f\x8b\x08\x00").is_some() && named(b"PAR1").is_some());
    }

    #[test]
    fn tables_are_not() {
        for text in ["", "t,theta\n0,1\n", "[s],[rad]\n0,1\n", "{t};{theta}\n0;1\n", "<a>\n", "par1,t\n"] {
            assert!(named(text.as_bytes()).is_none(), "{text}");
        }
    }
}
