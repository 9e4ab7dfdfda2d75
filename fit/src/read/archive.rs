//! ZIP archives: what phyphox exports, and the container of XLSX. What an archive unpacks to is bounded by its size.
//!
//! The directory by `rawzip`, which unpacks nothing, deflate by `miniz_oxide`: both are the same in a browser.

use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_with_limit};
use rawzip::{CompressionMethod, ZipArchive, ZipArchiveEntryWayfinder, ZipSliceArchive, ZipVerification};

use super::refusal::{Refusal, plain, quoted};

/// No honest table is packed by more than this: deflate can reach a thousand on blanks.
const MOST_PACKED: usize = 200;
const MOST_ENTRIES: usize = 2000;

/// A file of an archive.
struct Entry {
    name: String,
    method: CompressionMethod,
    encrypted: bool,
    place: ZipArchiveEntryWayfinder,
}

/// An opened archive with the room that is left to unpack to.
pub(super) struct Archive<'a> {
    zip: ZipSliceArchive<&'a [u8]>,
    entries: Vec<Entry>,
    room: usize,
}

impl<'a> Archive<'a> {
    /// Opens an archive.
    pub(super) fn of(bytes: &'a [u8]) -> Result<Archive<'a>, Refusal> {
        let zip = ZipArchive::from_slice(bytes).map_err(|error| broken(&error.to_string()))?;
        let mut entries = Vec::new();
        let mut directory = zip.entries();
        while let Some(entry) = directory.next_entry().map_err(|error| broken(&error.to_string()))? {
            if entries.len() == MOST_ENTRIES {
                let reason =
                    format!("a ZIP archive of more than {MOST_ENTRIES} files; at most so many are read");
                return Err(Refusal::fault(None, reason));
            }
            entries.push(Entry {
                name: String::from_utf8_lossy(entry.file_path().as_bytes()).into_owned(),
                method: entry.compression_method(),
                encrypted: entry.flags().is_encrypted(),
                place: entry.wayfinder(),
            });
        }
        Ok(Archive { zip, entries, room: MOST_PACKED * bytes.len() + (1 << 20) })
    }

    /// The names of its files.
    pub(super) fn names(&self) -> Vec<String> {
        self.entries.iter().map(|entry| entry.name.clone()).collect()
    }

    /// The bytes of a file.
    pub(super) fn bytes(&mut self, name: &str) -> Result<Vec<u8>, Refusal> {
        let entry = self.entries.iter().find(|entry| entry.name == name);
        let entry = entry.ok_or_else(|| broken("a file is missing"))?;
        if entry.encrypted {
            return Err(broken("it is encrypted"));
        }
        let found = self.zip.get_entry(entry.place).map_err(|error| broken(&error.to_string()))?;
        let packed = found.data();
        let too_much = || {
            let reason =
                format!("{} in the archive unpacks to more than {MOST_PACKED} times its size", quoted(name));
            Refusal::fault(None, reason)
        };
        let bytes = match entry.method {
            CompressionMethod::STORE if packed.len() > self.room => return Err(too_much()),
            CompressionMethod::STORE => packed.to_vec(),
            CompressionMethod::DEFLATE => {
                decompress_to_vec_with_limit(packed, self.room).map_err(|error| match error.status {
                    TINFLStatus::HasMoreOutput => too_much(),
                    _ => broken("its deflated data is corrupt"),
                })?
            }
            _ => return Err(broken("it is packed by another method than deflate")),
        };
        let is = ZipVerification { crc: checksum(&bytes), uncompressed_size: bytes.len() as u64 };
        found.claim_verifier().valid(is).map_err(|error| broken(&error.to_string()))?;
        self.room -= bytes.len();
        Ok(bytes)
    }
}

/// CRC-32 of ISO 3309, bit by bit: the tables of 16 kB that make it fast would be loaded by a page.
fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| (sum >> 1) ^ (0xedb8_8320 & (sum & 1).wrapping_neg()))
    })
}

fn broken(error: &str) -> Refusal {
    Refusal::fault(None, format!("a ZIP archive that cannot be unpacked: {}", plain(error)))
}
