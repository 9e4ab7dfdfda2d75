//! What the file does not hold is asked in one line with the candidates, and the answer is taken.

use libration_fit::{Options, Quantity, Refusal, read};

use super::{degrees, near, refusal};

#[track_caller]
fn asks(text: &str, line: &str) {
    let refusal = refusal(text.as_bytes(), &Options::default());
    assert!(matches!(refusal, Refusal::Question { .. }), "{refusal}");
    assert_eq!(refusal.to_string(), line);
}

const TWO: &str = "t,theta,phi\n0,10,1\n0.1,9,2\n0.2,7,4\n";

#[test]
fn which_column_is_the_angle() {
    asks(TWO, "file.csv: which column is the angle? theta, phi; write --column angle=NAME");
    for (name, first) in [("theta", 10.0), ("phi", 1.0), ("3", 1.0)] {
        let options = Options::default().column(&format!("angle={name}")).unwrap().unit("angle=deg").unwrap();
        let record = read("f", TWO.as_bytes(), &options).unwrap();
        near(&degrees(&record)[..1], &[first], 1e-12);
    }
    asks(
        "0\t1\t9\t5\n1\t2\t8\t9\n2\t4\t1\t3\n3\t2\t8\t1\n",
        "file.csv: which column is the angle? 2, 3, 4; write --column angle=NAME",
    );
}

#[test]
fn which_column_is_the_time() {
    asks(
        "theta,b\n1,10\n2,9\n1,7\n",
        "file.csv: which column is the time? b; write --rate HZ for evenly spaced samples, or --column time=NAME",
    );
    asks(
        "1.5\n2.5\n1.5\n",
        "file.csv: no column of times: how many samples in a second? write --rate HZ for evenly spaced samples, or --column time=NAME",
    );
}

#[test]
fn in_which_unit() {
    let text = "time_us,angle\n0,1500\n5000,1000\n10000,-500\n15000,-1500\n";
    asks(
        text,
        "file.csv: in which unit is column \"angle\"? It holds whole numbers from -1500 to 1500: deg, rad, counts of a turn; write --unit angle=deg, =rad or =4000/turn",
    );
    let counts = Options::default().unit("angle=4000/turn").unwrap();
    let record = read("f", text.as_bytes(), &counts).unwrap();
    near(&degrees(&record), &[135.0, 90.0, -45.0, -135.0], 1e-9);
}

#[test]
fn which_velocity() {
    asks(
        "t,omega,gyro\n0,1,5\n0.1,2,6\n0.2,1,8\n",
        "file.csv: which column is the angular velocity? omega, gyro; write --column velocity=NAME",
    );
}

#[test]
fn other_quantities_can_be_stated() {
    let text = b"t,a,b,c\n0,1,5,1\n0.1,2,6,0\n0.2,1,8,1\n";
    for (column, quantity) in
        [("velocity=b", Quantity::Velocity), ("acceleration=b", Quantity::LinearAcceleration)]
    {
        let record = read("f", text, &Options::default().column(column).unwrap()).unwrap();
        assert_eq!((record.series[0].quantity, record.series[0].values[0]), (quantity, 5.0));
    }
    let units = Options::default().column("velocity=b").unwrap().unit("velocity=deg/s").unwrap();
    near(&[read("f", text, &units).unwrap().series[0].values[0].to_degrees()], &[5.0], 1e-12);
    let swings = Options::default().column("angle=a").unwrap().column("period=b").unwrap();
    let record = read("f", b"a,b\n10,1.0\n20,1.1\n30,1.2\n", &swings).unwrap();
    assert_eq!(record.series[0].quantity, Quantity::Theta0);
}
