//! ZIP archives: what phyphox exports, and the container of XLSX. What an archive unpacks to is bounded by its size.

use std::io::{Cursor, Read};

use super::refusal::{Refusal, plain, quoted};

/// No honest table is packed by more than this: deflate can reach a thousand on blanks.
const MOST_PACKED: u64 = 200;
const MOST_ENTRIES: usize = 2000;

/// An opened archive with the room that is left to unpack to.
pub(super) struct Archive<'a> {
    zip: zip::ZipArchive<Cursor<&'a [u8]>>,
    room: u64,
}

impl<'a> Archive<'a> {
    /// Opens an archive.
    pub(super) fn of(bytes: &'a [u8]) -> Result<Archive<'a>, Refusal> {
        let zip = zip::ZipArchive::new(Cursor::new(bytes)).map_err(|error| broken(&error.to_string()))?;
        if zip.len() > MOST_ENTRIES {
            let reason = format!("a ZIP archive of {} files; at most {MOST_ENTRIES} are read", zip.len());
            return Err(Refusal::fault(None, reason));
        }
        Ok(Archive { zip, room: MOST_PACKED * bytes.len() as u64 + (1 << 20) })
    }

    /// The names of its files.
    pub(super) fn names(&self) -> Vec<String> {
        self.zip.file_names().flatten().map(|name| name.into_owned()).collect()
    }

    /// The bytes of a file.
    pub(super) fn bytes(&mut self, name: &str) -> Result<Vec<u8>, Refusal> {
        let file = self.zip.by_name(name).map_err(|error| broken(&error.to_string()))?;
        let mut bytes = Vec::new();
        let read =
            file.take(self.room + 1).read_to_end(&mut bytes).map_err(|error| broken(&error.to_string()))?;
        if read as u64 > self.room {
            let reason =
                format!("{} in the archive unpacks to more than {MOST_PACKED} times its size", quoted(name));
            return Err(Refusal::fault(None, reason));
        }
        self.room -= read as u64;
        Ok(bytes)
    }
}

fn broken(error: &str) -> Refusal {
    Refusal::fault(None, format!("a ZIP archive that cannot be unpacked: {}", plain(error)))
}
