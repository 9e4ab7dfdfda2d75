//! Prints what the reader makes of files: `cargo run -p libration-fit --example read -- FILE... [--column ROLE=NAME]
//! [--unit ROLE=UNIT] [--rate HZ] [--run N] [--length M]`.

use libration_fit::{Options, read};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (mut options, mut files) = (Options::default(), Vec::new());
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        if !word.starts_with("--") {
            files.push(word);
            continue;
        }
        let value = words.next().ok_or("an option without a value")?;
        match word.as_str() {
            "--column" => options = options.column(&value)?,
            "--unit" => options = options.unit(&value)?,
            "--rate" => options.rate = Some(value.parse()?),
            "--run" => options.run = Some(value.parse()?),
            "--length" => options.length = Some(value.parse()?),
            _ => return Err(format!("no option {word}").into()),
        }
    }
    for file in files {
        let bytes = std::fs::read(&file)?;
        match read(&file, &bytes, &options) {
            Ok(record) => {
                println!("{file}: {:?}, {} instants", record.kind, record.time.len());
                for series in &record.series {
                    let (first, last) = (series.values.first(), series.values.last());
                    println!(
                        "  {:?} {:?}: {} values, {first:?} to {last:?}",
                        series.quantity,
                        series.name,
                        series.values.len()
                    );
                }
                record.understood.iter().for_each(|each| println!("  {each}"));
                record.dropped.iter().for_each(|each| println!("  left out: {each}"));
            }
            Err(refusal) => println!("{refusal}"),
        }
    }
    Ok(())
}
