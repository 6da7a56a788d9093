//! The worked examples of the manual, sections 1 to 5, 13 and 15: the numbers are those that the manual
//! prints, or that follow from its formulas as the comments say.

use turnspec_oracle::vocabulary::notation::{Expectation, render};
use turnspec_oracle::vocabulary::{Event, Setup};

use super::run;

pub fn trace(setup: &str, program: &str) -> Vec<Event> {
    let setup = Setup::from_toml(setup).unwrap_or_else(|error| panic!("{error}"));
    let mut events = Vec::new();
    run(program.as_bytes(), &setup, &mut |event: &Event| events.push(*event));
    events
}

pub fn expect(setup: &str, program: &str, expected: &str) {
    let events = trace(setup, program);
    if let Err(reason) = Expectation::parse(expected).matches(&events) {
        let text: Vec<String> = events.iter().map(render).collect();
        panic!("{program}\n{reason}\n{}", text.join("\n"));
    }
}

const JOINED: &str = "M110\n";

#[test]
fn feed_of_c_axis_blocks() {
    // 90 degrees are 125 mm; T = L / F gives the printed rates.
    expect(
        "",
        &format!("{JOINED}G94 G01 C90 F320\n"),
        "...\nlinear c=90 c_travel=90 f=320mm/min path=125\n...",
    );
    // sqrt(50^2 + 125^2) = 134.6291201783626: printed as 135.
    let program = format!("{JOINED}G94 G01 Z50 C90 F67.5\n");
    expect("", &program, "...\nlinear z=50 c=90 f=67.5mm/min path=134.62912\n...");
    // sqrt(40^2 + 125^2) = 131.24404748: printed as 131.2.
    let program = format!("{JOINED}G00 X80 Z100 C120\nG94 G01 X40 Z100 C210 F117\n");
    expect("", &program, "...\nlinear x=40 c=210 path=131.244047\n...");
    // sqrt(40^2 + 50^2 + 125^2) = 140.44571905: printed as 140.4.
    let program = format!("{JOINED}G00 X80 Z50 C120\nG94 G01 X40 Z100 C210 F83.6\n");
    expect("", &program, "...\nlinear x=40 z=100 c=210 path=140.445719\n...");
}

#[test]
fn dimensions_and_units() {
    expect("", "N100 G00 X200 (FIRST STEP)\n", "rapid x=200 block=N100\nalarm name=no_program_end");
    expect("", "G01 X1 F100.000001\n", "alarm name=too_many_digits rules=E100L-DEC-04");
    expect("", "G01 X1 F1.2345678\n", "mode\nlinear x=1 f=1.2345678mm/rev\n...");
    expect("", "G90\nG00 X50 Z150\nX100 Z50\n", "rapid x=50 z=150\nrapid x=100 z=50\n...");
    expect("", "G90\nG00 X50 Z150\nG91 X50 Z-100\n", "rapid\nmode\nrapid x=100 z=50\n...");
    let millimetres = "G91\nG00 X0.001\nX10\nX100.01\nF0.23456\nX1\nX1.0\nX1.00\nX1.000\nG01 X0\n";
    expect(
        "",
        millimetres,
        "...\nrapid x=0.001\nrapid x=10.001\nrapid x=110.011\nrapid x=111.011\n...\nlinear x=114.011 f=0.23456mm/rev\n...",
    );
    let program = "G91\nG00 X0.1\nX1000\nX10001\nF23.456\nG01 X0\n";
    expect("unit_system = \"10um\"", program, "...\nlinear x=110.011 f=0.23456mm/rev\n...");
    let program = "G91\nG00 X1\nX10000\nX100010\nF234.56\nG01 X0\n";
    expect("unit_system = \"1um\"", program, "...\nlinear x=110.011 f=0.23456mm/rev\n...");
}

#[test]
fn basic_chamfers() {
    let setup = "parameters.chamfering = \"basic\"";
    let program = "N101 G01 X60 Z92 F0.1\nN102 G75 Z60 F0.05 L3\nN103 G75 X100 L-2\nN104 G75 Z40 L4\n\
                   N105 G75 X160 L-5\nN106 Z10\n";
    expect(
        setup,
        program,
        "mode
        linear x=60 z=92 f=0.1mm/rev
        linear x=60 z=63 f=0.05mm/rev rules=E100L-CHAM-03+E100L-CHAM-12
        linear x=66 z=60
        linear x=96 z=60
        linear x=100 z=58
        linear x=100 z=44
        linear x=108 z=40
        linear x=150 z=40
        linear x=160 z=35
        linear x=160 z=10
        ...",
    );
    expect(
        setup,
        &program.replace("G75", "G76"),
        "mode
        linear x=60 z=92
        linear x=60 z=63
        arc x=66 z=60 cx=66 cz=63 sense=cw rules=E100L-CHAM-11
        linear x=96 z=60
        arc x=100 z=58 cx=96 cz=58 sense=ccw
        linear x=100 z=44
        arc x=108 z=40 cx=108 cz=44 sense=cw
        linear x=150 z=40
        arc x=160 z=35 cx=150 cz=35 sense=ccw
        linear x=160 z=10
        ...",
    );
}

#[test]
fn any_angle_chamfers() {
    let program =
        "N100 G00 X20 Z120\nN110 G75 G01 X60 L6 F0.2\nN120 G75 Z90 L5\nN130 G75 A120 X100 L6\nN140 Z30\n";
    // X 60 + 2 * 5 * cos 30; Z 90 - 5 / 2; corner Z 90 - 20 / tan 60 = 78.452994619; legs of 6 from it.
    expect(
        "",
        program,
        "rapid x=20 z=120
        mode
        linear x=48 z=120 readings=chamfer_leg=leg
        linear x=60 z=114
        linear x=60 z=95
        linear x=68.660254 z=87.5
        linear x=89.607695 z=81.452995
        linear x=100 z=72.452995
        linear x=100 z=30
        ...",
    );
    let program = program.replace("G75", "G76").replace("L5", "L10").replace("X100 L6", "X100 L8");
    // t = 10 tan 30 = 5.773503, and 8 tan 30 = 4.618802 from the corner latched at 78.452995.
    expect(
        "",
        &program,
        "rapid x=20 z=120
        mode
        linear x=48 z=120
        arc x=60 z=114 cx=48 cz=114 sense=ccw
        linear x=60 z=95.773503
        arc x=70 z=87.113249 cx=80 cz=95.773503 sense=cw
        linear x=92 z=80.762396
        arc x=100 z=73.834193 cx=84 cz=73.834193 sense=ccw
        linear x=100 z=30
        ...",
    );
}

#[test]
fn torque_skip() {
    let setup = "options.w_axis = true\nstart.w = 300\ninputs.torque_stops = [48]";
    let program = "G29 PW=30\nG94 G22 W50 D5 L10 F1000 PW=25\nG29 PW=5\nM248\nM84\nG28\nG90 G00 W300\n";
    expect(
        setup,
        program,
        "torque w=30
        mode code=G94
        linear w=55 f=1000mm/min path=245
        linear w=48 f=200mm/min
        torque w=5
        aux code=M248
        aux code=M84 group=chuck
        torque w=- z=-
        rapid w=300
        ...",
    );
    let late = "options.w_axis = true\nstart.w = 300";
    expect(late, program, "...\nlinear w=40\nalarm name=torque_not_reached number=1220");
    let early = "options.w_axis = true\nstart.w = 300\ninputs.torque_stops = [100]";
    expect(early, program, "...\nlinear w=100 f=1000mm/min\nalarm name=torque_reached_early number=1219");
}

#[test]
fn zero_shift_and_speeds() {
    let program = "N004 G00 X100\nN005 G50 X200\nN006 G00 X200\n";
    expect("", program, "rapid x=100 mx=100\nframe cause=zero_shift x=-100\nrapid x=200 mx=100\n...");
    // 1000 * 100 / (π * 100) = 318.3098... rpm.
    let program = "G00 X100\nM03\nN000 G96 S100\nN001 G97 S500\n";
    expect(
        "",
        program,
        "...\nmode code=G96\nspindle speed=318.31 surface=100\nmode code=G97\nspindle speed=500 surface=-\n...",
    );
}

#[test]
fn drilling_with_the_c_axis() {
    let program = "N099 G00 X1000 Z1000 M05\nN100 M01\nN101 M110\nN102 M15\n\
        N103 G94 X120 Z102 C90 T0101 SB=400\nN104 G01 Z75 F40 M13 M147\nN105 G00 Z102\nN106 C270 M146\n\
        N107 G01 Z75 M147\nN108 G00 Z102\nN109 G095 X1000 Z1000 M12 M146\nN110 M109\nN111 M02\n";
    expect(
        "options.nose_radius_compensation = false",
        program,
        "spindle state=stop
        rapid x=1000 z=1000
        aux code=M110 group=c_axis
        aux code=M15
        mode code=G94
        spindle spindle=tool state=stop speed=0
        tool tool=1 offset=1 index=true
        rapid x=120 z=102 c=90 c_travel=90
        mode code=G01
        spindle spindle=tool state=cw speed=400
        aux code=M147
        linear z=75 f=40mm/min
        mode code=G00
        rapid z=102
        aux code=M146
        rapid c=270 c_travel=180
        mode code=G01
        aux code=M147
        linear z=75 f=40mm/min
        mode code=G00
        rapid z=102
        mode code=G95
        spindle spindle=tool state=stop
        aux code=M146
        rapid x=1000 z=1000
        aux code=M109
        end code=M02",
    );
}

#[test]
fn expressions() {
    let program = "V2=1 V3=2 V4=3 V5=10 V6=4 V7=2 V8=5\nV1=[V2+V3]*V4+[V5-V6]/V7+V8\nM02\n";
    expect("", program, "...\nvariable name=V8 value=5\nvariable name=V1 value=17\nend");
    let program = "V1=SIN[30] V2=COS[60] V3=TAN[45]\nV4=ATAN[1] V5=ATAN2[1,SQRT[3]]\nV6=SQRT[16] V7=ABS[-3]\n\
        V8=BIN[$25] V9=BCD[25]\nV10=$A EOR $C V11=$A OR $C V12=$A AND $C\nV13=MOD[17,5] V14=15/5 V15=NOT 5\nM02\n";
    let values = ["0.5", "0.5", "1", "45", "30", "4", "3", "25", "37", "6", "14", "8", "2", "3", "-6"];
    let lines: Vec<String> =
        values.iter().zip(1..).map(|(value, n)| format!("variable name=V{n} value={value}")).collect();
    // ATAN2[1, SQRT[3]] is the angle of a rounded root: the neighbour of 30 is found exactly there.
    expect("", program, &(lines.join("\n").replace("value=30", "name=V5") + "\nend"));
}

#[test]
fn system_variables() {
    let program =
        "N1 VZOFZ=12364.256\nN2 VZSHZ=50\nN3 VTOFZ[5]=2.634\nN4 VNSRZ[4]=0.8\nN5 VPVLZ=2352.168\nN6 M02\n";
    expect(
        "",
        program,
        "variable name=VZOFZ value=12364.256
        frame cause=zero_offset z=12364.256
        variable name=VZSHZ value=50
        frame cause=zero_shift z=50
        variable name=VTOFZ[5] value=2.634
        variable name=VNSRZ[4] value=0.8
        variable name=VPVLZ value=2352.168
        frame cause=zero_shift z=0
        end",
    );
}

#[test]
fn spindle_with_motion_and_turret_unclamp() {
    let program = "N100 G00 X50 Z50 M03 S1000 M63\nN101 Z10\nN102 M02\n";
    expect(
        "",
        program,
        "spindle state=stop with_motion=true rules=E100L-M63-02
        spindle state=cw speed=1000 with_motion=true
        aux code=M63
        rapid x=50 z=50
        rapid z=10
        end",
    );
    let program = "G01 X200 F0.2\nG00 X220 Z300\nG00 X500 Z800 M203\nX220 Z300 T020202\nM02\n";
    expect("", program, "...\naux code=M203 rules=E100L-TUNC-01\nrapid x=500 z=800\ntool tool=2\n...\nend");
    let setup = "inputs.turret_clamp_confirmed = false";
    let program = "G01 X200 F0.2\nG00 X500 Z800 M203\n";
    expect(setup, program, "...\nalarm name=turret_clamp number=1730");
}
