//! Scenes run one after the other, and what is kept of them.

use crate::job::Job;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

#[derive(Serialize, Deserialize)]
pub struct Snapshot {
    pub seed: u64,
    pub runs: Vec<Run>,
}

/// What one run left.
#[derive(Serialize, Deserialize)]
pub struct Run {
    pub label: String,
    pub status: Option<i32>,
    /// The summary without what depends on the machine; null where there was none.
    pub summary: Value,
    /// What was printed in its place.
    pub message: String,
    pub scene: String,
}

/// What depends on the machine or on the build, wherever it stands.
const LEFT_OUT: [&str; 4] = ["timing", "solve_s", "version", "command"];

pub fn run_all(peel: &Path, jobs: &[Job], times: bool) -> Result<Vec<Run>, Box<dyn Error>> {
    let temporary = std::env::temp_dir().join(format!("peel-snapshot-{}", std::process::id()));
    std::fs::create_dir_all(&temporary)?;
    let begin = Instant::now();
    let runs = jobs.iter().map(|job| {
        let started = Instant::now();
        let folder = job.folder.as_deref().unwrap_or(&temporary);
        if job.folder.is_none() {
            std::fs::write(folder.join(&job.name), &job.text)?;
        }
        // named without a folder, so that the name in the summary is the same everywhere
        let mut command = Command::new(peel);
        command.current_dir(folder).args(["run", &job.name, "--json"]);
        if job.observed {
            command.arg("--observed");
        }
        let output = command.output()?;
        let mut summary = serde_json::from_slice(&output.stdout).unwrap_or(Value::Null);
        strip(&mut summary);
        let message =
            if summary.is_null() { String::from_utf8_lossy(&output.stderr).into_owned() } else { String::new() };
        if times {
            let [end, reason] = ["end", "reason"].map(|key| summary[key].as_str().unwrap_or("").to_owned());
            let points = summary["path"]["points"].as_u64().unwrap_or(0);
            let seconds = started.elapsed().as_secs_f64();
            eprintln!("{seconds:7.2} s  {:40} {points:6} points  {end} {reason}{message}", job.label());
        }
        let text = if job.folder.is_none() { job.text.clone() } else { String::new() };
        Ok(Run { label: job.label(), status: output.status.code(), summary, message, scene: text })
    });
    let runs: std::io::Result<Vec<Run>> = runs.collect();
    std::fs::remove_dir_all(&temporary)?;
    let runs = runs?;
    let timed = |run: &&Run| run.summary["reason"].as_str().is_some_and(|reason| reason.contains("bounds.time"));
    for run in runs.iter().filter(timed) {
        eprintln!("{}: ended by time, which depends on the machine", run.label);
    }
    eprintln!("{} runs in {:.1} s", runs.len(), begin.elapsed().as_secs_f64());
    Ok(runs)
}

fn strip(value: &mut Value) {
    match value {
        Value::Object(entries) => {
            entries.retain(|name, _| !LEFT_OUT.contains(&name.as_str()));
            entries.values_mut().for_each(strip);
        }
        Value::Array(items) => items.iter_mut().for_each(strip),
        _ => {}
    }
}
