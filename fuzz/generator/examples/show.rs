use turnspec_generator::*;
use turnspec_oracle::vocabulary::*;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let want = &a[1];
    let n: usize = a[2].parse().unwrap();
    let mut k = 0;
    for seed in 0..60000u64 {
        let c = case_from_seed(seed);
        if c.setup.machine.r#type == MachineType::OneTurret {
            continue;
        }
        let mut last = String::new();
        let mut all = vec![];
        turnspec_oracle::run(&c.program, &c.setup, &mut |e: &Event| {
            last = notation::render(e);
            all.push(last.clone());
        });
        if last.contains(want) {
            println!(
                "=== seed {seed} {:?}\n{}\n...{}",
                c.setup.machine.r#type,
                String::from_utf8_lossy(&decode(&c.program, c.setup.tape.code)),
                all[all.len().saturating_sub(3)..].join("\n")
            );
            k += 1;
            if k >= n {
                return;
            }
        }
    }
}
