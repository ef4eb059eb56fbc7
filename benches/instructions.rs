//! Instructions of the hot loop, counted by valgrind: they do not depend on how busy a machine is.
//!
//!     cargo bench -p peelkit-benches --bench instructions
//!
//! Runs itself under `valgrind --tool=callgrind` with many and with twice as many repetitions of each kernel; the difference
//! is what the repetitions take. Needs valgrind on the path.

mod common;

use common::Setting;
use std::env::{args, current_exe};
use std::process::{Command, ExitCode};

const REPETITIONS: usize = 500;
const ELEMENTS: usize = 12;
const ORDER: usize = 7;

/// One repetition of a kernel.
type Kernel = fn(&mut Setting);

const KERNELS: [(&str, Kernel); 5] = [
    ("the law at 4 points, all second derivatives", |s| s.law(4)),
    ("the law at the 84 points of 12 elements of order 7", |s| s.law(ELEMENTS * ORDER)),
    ("integration and elimination of these elements", Setting::eliminate),
    ("one Newton iteration on them: the same and the way back", Setting::iterate),
    ("their energy alone", Setting::energy),
];

/// Instructions of a run of this program under callgrind.
fn counted(kernel: usize, repetitions: usize) -> Option<f64> {
    let run = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(current_exe().ok()?)
        .args(["--kernel", &kernel.to_string(), &repetitions.to_string()])
        .output()
        .ok()?;
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    said.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok())
}

fn main() -> ExitCode {
    let given: Vec<String> = args().skip_while(|arg| arg != "--kernel").skip(1).collect();
    if let [kernel, repetitions] = &given[..] {
        let (Ok(kernel), Ok(repetitions)) = (kernel.parse::<usize>(), repetitions.parse::<usize>()) else {
            return ExitCode::FAILURE;
        };
        let mut setting = Setting::new(ELEMENTS, ORDER);
        // once, so that there is something to go back from, and room
        setting.iterate();
        (0..repetitions).for_each(|_| KERNELS[kernel].1(&mut setting));
        return ExitCode::SUCCESS;
    }
    for (kernel, (name, _)) in KERNELS.iter().enumerate() {
        let (Some(once), Some(twice)) = (counted(kernel, REPETITIONS), counted(kernel, 2 * REPETITIONS)) else {
            eprintln!("valgrind could not be run: install it to count instructions");
            return ExitCode::FAILURE;
        };
        println!("{:>8.0}  {name}", (twice - once) / REPETITIONS as f64);
    }
    ExitCode::SUCCESS
}
