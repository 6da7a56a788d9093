//! `audit`: the evidence for every rule, in one folder.

use std::io::{Write, stderr, stdout};
use std::path::PathBuf;

use turnspec::audit::{self, Finding, Tree, Verdict as Found};

use super::{Failure, Verdict, exit_status};

/// Gather the evidence for every rule of a source tree into a folder.
///
/// The folder holds a page to read (index.html), the rule table as JSON and CSV, a bill of materials, and
/// manifests with the SHA-256 of every file. Every rule example and conformance case runs on both
/// implementations; coverage and mutants come from the files in evidence/, with a remark when the sources
/// have changed since. Two audits of one commit are equal byte for byte.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec audit --out audit\n  turnspec audit --root ../turnspec --out /tmp/audit\n  \
     cd audit && sha256sum -c MANIFEST.sha256\n\nThe program has to be built from the tree that it audits.\n\
     A former bundle is replaced if it is as it was written; any other folder that is not empty is left alone, \
     and so is the current one.\n\n",
    exit_status!()
))]
pub struct Arguments {
    /// Where the bundle is written.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// The source tree; by default the current folder or the closest one above that is a source tree.
    #[arg(long, value_name = "TREE")]
    root: Option<PathBuf>,
}

/// Writes the bundle; the findings go to standard output, what does not hold to standard error too.
pub fn carry_out(arguments: &Arguments) -> Result<Verdict, Failure> {
    let root = match &arguments.root {
        Some(root) => root.clone(),
        None => {
            let here = std::env::current_dir().map_err(|error| Failure::about("current folder", error))?;
            Tree::around(&here).map_err(failure)?
        }
    };
    let findings = audit::write(&root, &arguments.out).map_err(failure)?;
    let mut out = stdout().lock();
    for finding in &findings {
        writeln!(out, "{:<13} {}: {}", name(finding.verdict), finding.subject, finding.text)?;
    }
    let failing: Vec<&Finding> = findings.iter().filter(|finding| finding.verdict == Found::Fails).collect();
    for finding in &failing {
        let _ = writeln!(stderr(), "turnspec: {}: {}", finding.subject, finding.text);
        for concern in &finding.concerns {
            let _ = writeln!(stderr(), "  {concern}");
        }
    }
    Ok(Verdict::fault_if(!failing.is_empty()))
}

fn failure(fault: audit::Fault) -> Failure {
    Failure::Usage(fault.to_string())
}

fn name(verdict: Found) -> &'static str {
    match verdict {
        Found::Holds => "holds",
        Found::Fails => "fails",
        Found::Measured => "measured",
        Found::NotMeasured => "not measured",
    }
}
