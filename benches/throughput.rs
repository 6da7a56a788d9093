//! How many blocks and megabytes a second: the engine, the oracle, and for scale a copy of the text, a
//! search for its line ends, and LinuxCNC's `rs274` on the same motions when it is installed
//! (`scripts/install-rs274.sh`).
//!
//! `cargo bench --bench throughput` prints a table; a number after `--` is the number of blocks. A block of a thread cycle,
//! of pecks or of LAP makes many motions, so that its rows count these.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::hint::black_box;
use std::io::{self, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use turnspec_oracle::vocabulary::{Action, Ending, Event, Length, Motion, Setup};

/// Runs of a row; the fastest counts.
const RUNS: usize = 5;
/// Blocks of a program for the engine.
const BLOCKS: usize = 500_000;
/// The oracle is made to be read, not to be fast: its programs are this many times shorter.
const ORACLE_SHARE: usize = 25;

/// A program of a known number of blocks.
struct Workload {
    name: &'static str,
    text: Vec<u8>,
    setup: Setup,
    blocks: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let argument = std::env::args().skip(1).find_map(|argument| argument.parse().ok());
    let blocks: usize = argument.unwrap_or(BLOCKS).max(ORACLE_SHARE);
    let mut out = io::stdout().lock();
    writeln!(out, "| program | what | blocks | MB | ms | blocks/s | MB/s |")?;
    writeln!(out, "|---|---|---:|---:|---:|---:|---:|")?;
    let programs = workloads(blocks);
    for (long, short) in programs.iter().zip(&workloads(blocks / ORACLE_SHARE)) {
        row(&mut out, long, "copy", || copy(&long.text))?;
        row(&mut out, long, "search for line ends", || line_ends(&long.text))?;
        row(&mut out, long, "parse only", || parse(long))?;
        row(&mut out, long, "engine", || engine(long))?;
        row(&mut out, long, "engine, trace as JSON", || engine_with_json(long))?;
        row(&mut out, short, "oracle", || oracle(short))?;
    }
    for (long, short) in loops(blocks).iter().zip(&loops(blocks / ORACLE_SHARE)) {
        row(&mut out, long, "engine", || engine(long))?;
        row(&mut out, short, "oracle", || oracle(short))?;
    }
    let cycles = cycles(blocks)?;
    for (long, short) in cycles.iter().zip(&self::cycles(blocks / ORACLE_SHARE)?) {
        row(&mut out, long, "engine", || engine(long))?;
        row(&mut out, long, "engine, trace as JSON", || engine_with_json(long))?;
        row(&mut out, short, "oracle", || oracle(short))?;
    }
    rs274(&mut out, &programs[0])?;
    for load in programs.iter().chain(&cycles) {
        writeln!(out, "{}: {}", load.name, slow_paths(load))?;
    }
    Ok(())
}

fn workloads(blocks: usize) -> [Workload; 4] {
    use turnspec_generator::{arcs_and_chamfers, compensated, expressions, straight_line, with_nose};
    let plain = Setup::default;
    [
        Workload { name: "straight lines", text: straight_line(blocks), setup: plain(), blocks },
        Workload { name: "arcs and chamfers", text: arcs_and_chamfers(blocks), setup: plain(), blocks },
        Workload { name: "radius compensation", text: compensated(blocks), setup: with_nose(), blocks },
        Workload { name: "expressions", text: expressions(blocks), setup: plain(), blocks },
    ]
}

/// Short texts with long runs.
fn loops(blocks: usize) -> [Workload; 2] {
    use turnspec_generator::{counting_loop, nested_calls};
    let of = |name, (text, setup, blocks)| Workload { name, text, setup, blocks };
    // Three calls take eleven blocks.
    [
        of("loop with IF and variables", counting_loop(blocks)),
        of("nested CALL and RTS", nested_calls(blocks * 3 / 11)),
    ]
}

/// Programs of cycles, counted by their motions.
fn cycles(motions: usize) -> Result<Vec<Workload>, Box<dyn Error>> {
    Ok(threads(motions)?.into_iter().chain(bores(motions)?).chain(laps(motions)?).collect())
}

/// Thread cycles of many passes, counted by their motions, about so many: plain ones; depths that are roots, by turns on
/// two flanks that are no right angle; and tapers by an angle, changing leads and chamfers.
fn threads(motions: usize) -> Result<[Workload; 3], Box<dyn Error>> {
    let start = "G00 X60 Z60 S500 M03 F1.5";
    // 100 passes of four motions each.
    let steps = ("motions of threads in steps", "G71 X40 Z10 D0.1 H10 M74", 400);
    let roots = ("motions of threads by area, two flanks", "G71 X40 Z10 B60 D1 H10 M75 M33", 400);
    // 50 passes with a chamfer each, on the face.
    let tapers =
        ("motions of face threads, taper and chamfer", "G72 X10 Z20 A91 D0.2 H10 E0.01 L2 M74 M23", 250);
    let load = |(name, cycle, each)| motions_of(name, start, cycle, "", motions.div_ceil(each));
    Ok([load(steps)?, load(roots)?, load(tapers)?])
}

/// Grooves and holes in pecks, counted by their motions, about so many: five grooves of 18 pecks a block, and a hole of 20
/// pecks a block.
fn bores(motions: usize) -> Result<[Workload; 2], Box<dyn Error>> {
    let grooves = ("motions of grooves", "G73 X40 Z40 I2 K5 D1", 195);
    let holes = ("motions of holes of driven tools", "C90\nC180", 82);
    let driven = "M110\nM146\nG94 F100 SB=400\nG00 X60 Z60\nG183 K2 R-20 D1 C0";
    Ok([
        motions_of(grooves.0, "G00 X60 Z60 F0.2", grooves.1, "", motions.div_ceil(grooves.2))?,
        motions_of(holes.0, driven, holes.1, "G180\nX60 Z60\n", motions.div_ceil(holes.2))?,
    ])
}

/// A program of blocks that are repeated between a beginning and an end, by the number of its motions.
fn motions_of(
    name: &'static str,
    start: &str,
    body: &str,
    end: &str,
    times: usize,
) -> Result<Workload, Box<dyn Error>> {
    let text = format!("{start}\n{}{end}M02\n", format!("{body}\n").repeat(times));
    counted(name, text, Setup::default())
}

/// A program by the number of its motions.
fn counted(name: &'static str, text: String, setup: Setup) -> Result<Workload, Box<dyn Error>> {
    let (text, mut blocks) = (text.into_bytes(), 0);
    let ending = turnspec::engine::run(&text, &setup, &mut |event: &Event| {
        let moves = matches!(
            event.action,
            Action::Rapid { .. } | Action::Linear { .. } | Action::Arc { .. } | Action::Thread { .. }
        );
        blocks += usize::from(moves);
    });
    ended(ending).map_err(|error| format!("{name}: {error}"))?;
    Ok(Workload { name, text, setup, blocks })
}

/// LAP, counted by its motions, about so many: bars cut along contours of 100 elements in modes I, IV and V; and one
/// contour of 10 000 elements, whatever the number.
fn laps(motions: usize) -> Result<[Workload; 4], Box<dyn Error>> {
    let calls =
        |name, level, blank, call: &str, each| lap(name, level, blank, 100, call, motions.div_ceil(each));
    Ok([
        calls("motions of LAP, mode I", 1, false, "G85 NAT1 D0.5 U0.4 W0.2 F0.3", 900)?,
        calls("motions of LAP, mode IV", 4, true, "G85 NAT1 D0.5 U0.4 W0.2 F0.3", 714)?,
        calls("motions of LAP, mode V", 5, true, "G86 NAT1 D0.5 U0.4 W0.2 F0.3", 869)?,
        lap("motions of LAP, 10 000 elements", 1, false, 10_000, "G85 NAT1 D2 U0.4 W0.2 F0.3", 1)?,
    ])
}

/// A cone from Ø20 to Ø80 of so many elements, every fourth an arc, which is cut from a bar that many times.
fn lap(
    name: &'static str,
    level: u8,
    blank: bool,
    elements: usize,
    call: &str,
    times: usize,
) -> Result<Workload, Box<dyn Error>> {
    let mut text = String::from("G00 X90 Z105 F0.3\n");
    for _ in 0..times {
        writeln!(text, "{call}\nG00 X90 Z105")?;
    }
    text.push_str("M02\nNAT1 ");
    if blank {
        text.push_str("G83\nG01 X20 Z102\nX84\nZ0\n");
    }
    text.push_str("G81\nG00 X20 Z102\nG01 Z100\n");
    for element in 1..=elements {
        let share = element as f64 / elements as f64;
        let (code, radius) = if element % 4 == 0 { ("G03", " L50") } else { ("G01", "") };
        writeln!(text, "{code} X{:.3} Z{:.3}{radius}", 20.0 + 60.0 * share, 100.0 - 100.0 * share)?;
    }
    text.push_str("G80\n");
    let mut setup = Setup::default();
    setup.options.lap = level;
    counted(name, text, setup)
}

/// How often the engine needed exact integers because `f64` left a rounding or a sign in doubt.
fn slow_paths(load: &Workload) -> String {
    let mut interpreter = turnspec::engine::Interpreter::new(&load.text, &load.setup);
    let mut events: u64 = 0;
    while interpreter.step(&mut |_: &Event| events += 1).is_none() {}
    format!("{:?} in {events} events", interpreter.slow_paths())
}

/// Times the fastest of several runs and prints it.
fn row(
    out: &mut impl io::Write,
    load: &Workload,
    what: &str,
    mut run: impl FnMut() -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let mut best = Duration::MAX;
    for _ in 0..RUNS {
        let start = Instant::now();
        run().map_err(|error| format!("{}, {what}: {error}", load.name))?;
        best = best.min(start.elapsed());
    }
    let seconds = best.as_secs_f64();
    let (name, megabytes) = (load.name, load.text.len() as f64 / 1e6);
    let (blocks, rate) = (load.blocks, load.blocks as f64 / seconds);
    let (milliseconds, throughput) = (seconds * 1e3, megabytes / seconds);
    writeln!(
        out,
        "| {name} | {what} | {blocks} | {megabytes:.1} | {milliseconds:.2} | {rate:.0} | {throughput:.1} |"
    )?;
    Ok(())
}

fn copy(text: &[u8]) -> Result<(), Box<dyn Error>> {
    black_box(black_box(text).to_vec());
    Ok(())
}

fn line_ends(text: &[u8]) -> Result<(), Box<dyn Error>> {
    black_box(memchr::memchr_iter(b'\n', black_box(text)).count());
    Ok(())
}

fn parse(load: &Workload) -> Result<(), Box<dyn Error>> {
    let blocks = black_box(turnspec::engine::count_blocks(black_box(&load.text), &load.setup));
    if blocks == load.blocks as u64 {
        Ok(())
    } else {
        Err(format!("{blocks} blocks instead of {}", load.blocks).into())
    }
}

fn engine(load: &Workload) -> Result<(), Box<dyn Error>> {
    ended(turnspec::engine::run(&load.text, &load.setup, &mut |event: &Event| {
        black_box(event);
    }))
}

fn engine_with_json(load: &Workload) -> Result<(), Box<dyn Error>> {
    let mut line = Vec::new();
    let mut fault = None;
    let ending = turnspec::engine::run(&load.text, &load.setup, &mut |event: &Event| {
        line.clear();
        fault = serde_json::to_writer(&mut line, event).err().or(fault.take());
        black_box(&line);
    });
    fault.map_or_else(|| ended(ending), |error| Err(error.into()))
}

fn oracle(load: &Workload) -> Result<(), Box<dyn Error>> {
    ended(turnspec_oracle::run(&load.text, &load.setup, &mut |event: &Event| {
        black_box(event);
    }))
}

/// A program that stops half-way would look fast.
fn ended(ending: Ending) -> Result<(), Box<dyn Error>> {
    match ending {
        Ending::End => Ok(()),
        Ending::Alarm => Err("the program ends in an alarm".into()),
    }
}

/// Times `rs274`, process start and output included, on the motions of a program.
fn rs274(out: &mut impl io::Write, program: &Workload) -> Result<(), Box<dyn Error>> {
    let (text, motions) = rs274_dialect(&program.text, &program.setup)?;
    let directory = std::env::temp_dir().join(format!("turnspec-rs274-{}", std::process::id()));
    fs::create_dir_all(&directory)?;
    fs::write(directory.join("program.ngc"), &text)?;
    fs::write(directory.join("tools.tbl"), "")?;
    let load = Workload { name: program.name, text, setup: Setup::default(), blocks: motions };
    let outcome = match run_rs274(&directory) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        _ => row(out, &load, "rs274", || match run_rs274(&directory)? {
            true => Ok(()),
            false => Err("rs274 reports a fault".into()),
        }),
    };
    fs::remove_dir_all(&directory)?;
    outcome
}

fn run_rs274(directory: &Path) -> io::Result<bool> {
    let arguments = ["-t", "tools.tbl", "-v", "parameters.var", "-n", "2", "-g", "program.ngc", "trace.txt"];
    let mut command = Command::new("rs274");
    command.args(arguments).current_dir(directory).stdin(Stdio::null());
    Ok(command.stdout(Stdio::null()).stderr(Stdio::null()).status()?.success())
}

/// The motions of a program as blocks of LinuxCNC's language: lathe diameter mode, millimetres, plane Z-X.
fn rs274_dialect(program: &[u8], setup: &Setup) -> Result<(Vec<u8>, usize), Box<dyn Error>> {
    let mut text = String::from("G7 G18 G21 G40 G80 G90 G94\n");
    let mut motions = 0;
    ended(turnspec::engine::run(program, setup, &mut |event: &Event| {
        let block = match event.action {
            Action::Rapid { motion } => format!("G0 {}", end_point(&motion)),
            Action::Linear { motion, feed, .. } => format!("G1 {} F{}", end_point(&motion), feed.value),
            _ => return,
        };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{block}");
        motions += 1;
    }))?;
    text.push_str("M2\n");
    Ok((text.into_bytes(), motions))
}

fn end_point(motion: &Motion) -> String {
    let (x, z): (Length, Length) = (motion.program.x, motion.program.z);
    format!("X{x} Z{z}")
}
