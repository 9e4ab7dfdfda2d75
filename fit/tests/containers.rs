//! UTF-16, ZIP, XLSX, XLS, Tracker's projects.

use std::io::{Cursor, Write};

use libration_fit::{Options, Quantity, read};

use super::{degrees, near, record, refusal, says};

const TABLE: &str = "Time (s)\tAngle (deg)\n0.0\t20.0\n0.1\t18.5\n0.2\t14.3\n0.3\t7.9\n";
const ANGLES: [f64; 4] = [20.0, 18.5, 14.3, 7.9];

#[test]
fn sixteen_bits() {
    let little: Vec<u8> = TABLE.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = TABLE.encode_utf16().flat_map(u16::to_be_bytes).collect();
    for bytes in [[b"\xff\xfe", &little[..]].concat(), [b"\xfe\xff", &big[..]].concat(), little, big] {
        let record = read("f", &bytes, &Options::default()).unwrap();
        near(&degrees(&record), &ANGLES, 1e-12);
        says(&record, "UTF-16");
    }
}

#[test]
fn a_mark_before_latin_1() {
    let text = b"\xef\xbb\xbfZeit (s)\tWinkel (\xb0)\n0\t20\n0.1\t18.5\n0.2\t14.3\n";
    near(&degrees(&read("f", text, &Options::default()).unwrap()), &ANGLES[..3], 1e-12);
}

fn zipped(files: &[(&str, &str)]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in files {
        zip.start_file(*name, zip::write::SimpleFileOptions::default()).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

const GYROSCOPE: &str =
    "\"Time (s)\"\t\"Gyroscope x (rad/s)\"\n0.0E0\t1.0E0\n1.0E-1\t2.0E0\n2.0E-1\t-1.0E0\n";

#[test]
fn what_phyphox_exports() {
    let acceleration = GYROSCOPE.replace("Gyroscope x (rad/s)", "Linear Acceleration x (m/s^2)");
    let device = ("meta/device.csv", "\"property\",\"value\"\n\"version\",\"1\"\n");
    let files = [device, ("Accelerometer.csv", &acceleration), ("Gyroscope.csv", GYROSCOPE)];
    let record = read("f.zip", &zipped(&files), &Options::default()).unwrap();
    assert_eq!(record.series[0].quantity, Quantity::Velocity);
    says(&record, "Of the files, Gyroscope.csv is read");
    let two = [("a.csv", GYROSCOPE), ("b.csv", GYROSCOPE)];
    let line = refusal(&zipped(&two), &Options::default()).to_string();
    assert_eq!(line, "file.csv: which file? a.csv, b.csv; write it to a file of its own and give that");
    let line = refusal(&zipped(&[device]), &Options::default()).to_string();
    assert!(line.contains("a ZIP archive without a table"), "{line}");
}

#[test]
fn an_archive_that_unpacks_to_too_much() {
    let line = refusal(&zipped(&[("a.csv", &"\n".repeat(30 << 20))]), &Options::default()).to_string();
    assert!(line.contains("unpacks to more than 200 times its size"), "{line}");
}

#[test]
fn xlsx() {
    let shared = "<sst><si><t>Zeit (s)</t></si><si><r><t>Winkel </t></r><r><t>(&#176;)</t></r></si></sst>";
    let mut rows = String::from(
        "<row r=\"1\"><c r=\"A1\" t=\"s\"><v>0</v></c><c r=\"C1\" t=\"inlineStr\"><is><t>theta [deg]</t></is></c></row>",
    );
    for (k, angle) in ANGLES.iter().enumerate() {
        let row = k + 3;
        rows += &format!(
            "<row r=\"{row}\"><c r=\"A{row}\"><v>{}</v></c><c r=\"C{row}\"><v>{angle}</v></c></row>",
            k as f64 / 8.0
        );
    }
    let sheet = format!("<worksheet><sheetData>{rows}</sheetData></worksheet>");
    let files = [
        ("xl/workbook.xml", "<workbook/>"),
        ("xl/sharedStrings.xml", shared),
        ("xl/worksheets/sheet1.xml", &sheet),
    ];
    let record = read("f.xlsx", &zipped(&files), &Options::default()).unwrap();
    near(&record.time, &[0.0, 0.125, 0.25, 0.375], 0.0);
    near(&degrees(&record), &ANGLES, 1e-12);
    assert_eq!(record.series[0].name, "theta [deg]");
    let far = sheet.replace("C6", "XFD1048576");
    let files = [
        ("xl/workbook.xml", "<workbook/>"),
        ("xl/sharedStrings.xml", shared),
        ("xl/worksheets/sheet1.xml", &far),
    ];
    let line = refusal(&zipped(&files), &Options::default()).to_string();
    assert!(line.contains("256 columns are read"), "{line}");
}

/// A BIFF8 record.
fn biff(kind: u16, data: &[u8]) -> Vec<u8> {
    [&kind.to_le_bytes()[..], &(data.len() as u16).to_le_bytes(), data].concat()
}

fn at(row: u16, column: u16, data: &[u8]) -> Vec<u8> {
    [&row.to_le_bytes()[..], &column.to_le_bytes(), &[0, 0], data].concat()
}

/// A workbook as Excel 97 writes it, with one sheet.
fn xls(cells: &[u8]) -> Vec<u8> {
    let string = |text: &str| [&(text.len() as u16).to_le_bytes()[..], &[0], text.as_bytes()].concat();
    let strings =
        [&2u32.to_le_bytes()[..], &2u32.to_le_bytes(), &string("Time (s)"), &string("Gyroscope x (ra")[..2]]
            .concat();
    // The second string runs on into a part of its own.
    let rest = [&[0][..], b"Gyroscope x (ra"].concat();
    let stream = [
        biff(0x0809, &[0, 6, 5, 0, 0, 0, 0, 0]),
        biff(0x0085, &[&[0; 6][..], &[8, 0], b"Raw Data"].concat()),
        biff(0x00fc, &strings),
        biff(0x003c, &rest),
        biff(0x000a, &[]),
        biff(0x0809, &[0, 6, 0x10, 0, 0, 0, 0, 0]),
        cells.to_vec(),
        biff(0x000a, &[]),
    ]
    .concat();
    let mut file = cfb::CompoundFile::create(Cursor::new(Vec::new())).unwrap();
    file.create_stream("/Workbook").unwrap().write_all(&stream).unwrap();
    file.flush().unwrap();
    file.into_inner().into_inner()
}

#[test]
fn xls_of_excel_97() {
    let packed = |value: i32| ((value << 2) as u32 | 2).to_le_bytes();
    let cells = [
        biff(0x00fd, &at(0, 0, &0u32.to_le_bytes())),
        biff(0x0204, &at(0, 1, &[&13u16.to_le_bytes()[..], &[0], b"omega (rad/s)"].concat())),
        biff(0x0203, &at(1, 0, &0.125f64.to_le_bytes())),
        biff(0x027e, &at(1, 1, &packed(3))),
        // Two packed numbers in one record: hundredths, and the upper half of a double.
        biff(
            0x00bd,
            &[
                &[2, 0, 0, 0][..],
                &[0, 0],
                &((25 << 2) | 3u32).to_le_bytes(),
                &[0, 0],
                &0x3ff8_0000u32.to_le_bytes(),
                &[1, 0],
            ]
            .concat(),
        ),
        biff(0x0006, &at(3, 0, &0.375f64.to_le_bytes())),
        biff(0x0203, &at(3, 1, &(-2.5f64).to_le_bytes())),
    ]
    .concat();
    let record = read("f.xls", &xls(&cells), &Options::default()).unwrap();
    near(&record.time, &[0.125, 0.25, 0.375], 0.0);
    near(&record.series[0].values, &[3.0, 1.5, -2.5], 0.0);
    let line = refusal(&xls(&biff(0x0203, &[1, 0])), &Options::default()).to_string();
    assert_eq!(line, "file.csv: a workbook without a filled sheet");
}

/// A frame and the place of a point in it.
type Step = (u32, f64, f64);

fn project(masses: &[(&str, &[Step])]) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<object class=\"org.opensourcephysics.cabrillo.tracker.TrackerPanel\">\n\
         <property name=\"clipcontrol\" type=\"object\"><object class=\"org.opensourcephysics.media.core.StepperClipControl\">\
         <property name=\"delta_t\" type=\"double\">20.0</property></object></property>\n<property name=\"tracks\" type=\"collection\">\n",
    );
    for (name, steps) in masses {
        text += &format!(
            "<property name=\"item\" type=\"object\"><object class=\"org.opensourcephysics.cabrillo.tracker.PointMass\">\
             <property name=\"name\" type=\"string\">{name}</property><property name=\"framedata\" type=\"array\">\n"
        );
        for (frame, x, y) in *steps {
            text += &format!(
                "<property name=\"[{frame}]\" type=\"object\"><object class=\"org.opensourcephysics.cabrillo.tracker.PointMass$FrameData\">\
                 <property name=\"x\" type=\"double\">{x}</property><property name=\"y\" type=\"double\">{y}</property></object></property>\n"
            );
        }
        text += "</property></object></property>\n";
    }
    text + "</property></object>\n"
}

#[test]
fn a_project_of_tracker() {
    let mut steps = Vec::new();
    for k in 0..40 {
        let angle = 0.6 * (0.3 * f64::from(k)).cos();
        steps.push((1300 + 5 * k, 860.0 + 700.0 * angle.sin(), 10.0 + 700.0 * angle.cos()));
    }
    let record = record(&project(&[("mass A", &steps)]));
    near(&record.time[..2], &[26.0, 26.1], 1e-12);
    near(&record.series[0].values[..1], &[0.6], 1e-9);
    says(&record, "A Tracker project: frames of 20 ms");
    says(&record, "down is +y");
    let two = project(&[("ruler", &steps[..5]), ("bob", &steps)]);
    assert_eq!(super::record(&two).time.len(), 40);
}

#[test]
fn projects_that_hold_no_track() {
    let none = project(&[]);
    let line = refusal(none.as_bytes(), &Options::default()).to_string();
    assert!(line.contains("without a tracked point mass"), "{line}");
    let timeless = project(&[("a", &[(1, 2.0, 3.0)])]).replace("delta_t", "delta");
    let line = refusal(timeless.as_bytes(), &Options::default()).to_string();
    assert!(line.contains("delta_t"), "{line}");
    let cut = project(&[("a", &[(1, 2.0, 3.0)])])
        .replace("</object></property>\n</property>", "</objec></property>");
    let line = refusal(cut.as_bytes(), &Options::default()).to_string();
    assert!(line.contains("line 6: no well-formed XML"), "{line}");
}
