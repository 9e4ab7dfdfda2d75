use libration::*;
#[test]
fn scratch() {
    let f = Friction::new(1.0 / 256.0, 0.0, 0.0, 0.0).unwrap();
    let p =
        DampedPendulum::new(90f64.to_radians(), 0.0, Frequency::from_omega2(1.0).unwrap(), f, Torque::NONE)
            .unwrap();
    let tr = p.trajectory(0.0, 650.0).unwrap();
    println!("steps {}", tr.steps());
    for t in [1.0, 7.5, 65.0, 650.0] {
        println!("{:?}", tr.motion(t));
    }
    println!(
        "truth 1.0761915484525222449 1.5113262044916600962 0.767308156571731402 -0.10949386592627647402"
    );
    let f = Friction::new(1.0 / 1024.0, 0.0, 1.0 / 512.0, 1.0 / 64.0).unwrap();
    let p =
        DampedPendulum::new(5f64.to_radians(), 0.0, Frequency::from_omega2(1.0).unwrap(), f, Torque::NONE)
            .unwrap();
    let tr = p.trajectory(0.0, 650.0).unwrap();
    println!("steps {}", tr.steps());
    for t in [1.0, 7.5, 65.0, 650.0] {
        println!("{:?}", tr.motion(t));
    }
    println!(
        "truth 0.047487723185219825969 0.025084695795737386409 -0.027306148088353574031 0.00074322359115886775783"
    );
    for (th, law) in [
        (1.0, [0.0, 0.0, 0.0]),
        (0.1, [0.01, 0.0, 0.0]),
        (1.5, [0.01, 0.0, 0.0]),
        (3.0, [0.01, 0., 0.]),
        (3.14, [0.001, 0.01, 0.001]),
    ] {
        let p = DampedPendulum::new(
            th,
            0.0,
            Frequency::from_omega2(1.0).unwrap(),
            Friction::new(law[0], law[1], law[2] + 1e-300, 0.0).unwrap(),
            Torque::NONE,
        )
        .unwrap();
        let tr = p.trajectory(0.0, 628.3).unwrap();
        let o = Orbit::new(th, 0.0, Frequency::from_omega2(1.0).unwrap()).unwrap();
        println!(
            "{th} {law:?} steps/period {} err {:e}",
            tr.steps() as f64 / 100.0,
            tr.theta(600.0) - o.theta(600.0)
        );
    }
}
#[test]
fn scratch_slopes() {
    let f = Friction::new(1.0 / 32.0, 0.0, 0.5, 0.0).unwrap();
    let p = DampedPendulum::new(
        0.5,
        0.0,
        Frequency::from_omega2(1.0).unwrap(),
        f,
        Torque::new(0.0, 0.9375, 0.25, 0.5).unwrap(),
    )
    .unwrap();
    let tr = p.trajectory(0.0, 16.0).unwrap();
    println!("{:?}", tr.motion(16.0));
    println!("{:?}", tr.rests());
    println!("{:?}", DampedSensitivity::new(&tr).unwrap().at(16.0));
    println!(
        "truth 2.0646856346487052037e-1 nan 1.3112963280953269615 1.2312021859177675199 2.4368999369667749291e-1 8.3597749784448345107e-1', 'nan', '8.3597749784448345107e-1', '-1.4273316942207208531', '-3.2831931827248640378', '1.5777218104420236108e-30'"
    );
}
