//! The audit bundle from outside: `turnspec audit` on copies of this tree, whole, changed and broken.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;
use turnspec_oracle::vocabulary::RuleId;

/// What the audit reads, and a file that it only lists.
const PARTS: [&str; 13] = [
    "Cargo.lock",
    "Cargo.toml",
    ".gitignore",
    "README.md",
    "conformance/cases",
    "conformance/src",
    "evidence",
    "proofs/src",
    "spec/rules",
    "spec/src",
    "spec/tests",
    "src",
    "tests/tables.rs",
];

/// A folder that lives as long as the test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("turnspec-audit-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// A copy of this tree, without history.
    fn tree(name: &str) -> Self {
        let folder = Self::new(name);
        for part in PARTS {
            copy(&Path::new(env!("CARGO_MANIFEST_DIR")).join(part), &folder.0.join("tree").join(part));
        }
        folder
    }

    fn root(&self) -> PathBuf {
        self.0.join("tree")
    }

    fn out(&self) -> PathBuf {
        self.0.join("bundle")
    }

    /// Audits the copy; exit status and standard error.
    fn audit(&self) -> (i32, String) {
        audit(&["--root", self.root().to_str().unwrap(), "--out", self.out().to_str().unwrap()], &self.0)
    }

    fn git(&self, arguments: &[&str]) {
        let mut command = Command::new("git");
        command.args(["-c", "user.name=A", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"]);
        let output = command.args(arguments).current_dir(self.root()).output().expect("git starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }

    fn commit(&self) {
        self.git(&["init", "--quiet"]);
        self.git(&["add", "--all"]);
        self.git(&["commit", "--quiet", "--message", "All"]);
    }

    fn json(&self, file: &str) -> Value {
        serde_json::from_str(&self.read(file)).unwrap()
    }

    fn read(&self, file: &str) -> String {
        fs::read_to_string(self.out().join(file)).unwrap()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        fs::create_dir_all(to).unwrap();
        for entry in fs::read_dir(from).unwrap() {
            let entry = entry.unwrap();
            copy(&entry.path(), &to.join(entry.file_name()));
        }
    } else {
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(from, to).unwrap();
    }
}

fn audit(arguments: &[&str], folder: &Path) -> (i32, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_turnspec"));
    let output = command.arg("audit").args(arguments).current_dir(folder).output().expect("turnspec starts");
    (output.status.code().expect("no signal"), String::from_utf8(output.stderr).expect("UTF-8"))
}

/// Every file of a folder with its bytes.
fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).unwrap();
    let mut files: Vec<_> = entries
        .map(|entry| {
            let entry = entry.unwrap();
            (entry.file_name().to_string_lossy().into_owned(), fs::read(entry.path()).unwrap())
        })
        .collect();
    files.sort();
    files
}

fn refused(folder: &Folder, because: &[&str]) {
    let (status, stderr) = folder.audit();
    assert_eq!(status, 2, "{stderr}");
    for words in because {
        assert!(stderr.contains(words), "{words} is not in: {stderr}");
    }
    assert!(!folder.out().exists(), "something was written");
}

#[test]
fn two_audits_of_one_commit_are_equal() {
    let folder = Folder::tree("twice");
    folder.commit();
    let (status, stderr) = folder.audit();
    assert!(status < 2, "{stderr}");
    assert!(!stderr.contains("dirty"), "{stderr}");
    let first = contents(&folder.out());
    folder.audit();
    assert!(first == contents(&folder.out()), "the second bundle differs from the first");
    for (name, bytes) in &first {
        let text = String::from_utf8_lossy(bytes);
        let place = folder.root().display().to_string();
        assert!(!text.contains(&place), "{name} names the place of the tree");
    }
    let names: Vec<&str> = first.iter().map(|(name, _)| name.as_str()).collect();
    let expected = [
        "MANIFEST.sha256",
        "SOURCES.sha256",
        "index.html",
        "matrix.csv",
        "matrix.json",
        "matrix.schema.json",
        "sbom.cdx.json",
        "tools.json",
    ];
    assert_eq!(names, expected);
    let beside = fs::read_dir(&folder.0).unwrap().count();
    assert_eq!(beside, 2, "a temporary folder was left");
}

#[test]
fn a_dirty_tree_is_said() {
    let folder = Folder::tree("dirty");
    folder.commit();
    fs::write(folder.root().join("README.md"), "changed").unwrap();
    let (status, stderr) = folder.audit();
    assert_eq!(status, 1, "{stderr}");
    assert!(stderr.contains("dirty") && stderr.contains("README.md"), "{stderr}");
    assert_eq!(folder.json("matrix.json")["changed"], serde_json::json!([" M README.md"]));
    assert!(folder.read("index.html").contains("The tree is dirty."));
}

#[test]
fn a_bundle_inside_the_tree_does_not_make_it_dirty() {
    let folder = Folder::tree("inside");
    folder.commit();
    for _ in 0..2 {
        let (status, stderr) = audit(&["--out", "audit"], &folder.root());
        assert!(status < 2 && !stderr.contains("dirty"), "{stderr}");
    }
    let sources = fs::read_to_string(folder.root().join("audit/SOURCES.sha256")).unwrap();
    assert!(!sources.contains("  audit/"), "{sources}");
}

#[test]
fn an_archive_has_an_unknown_commit() {
    let folder = Folder::tree("archive");
    let (status, stderr) = folder.audit();
    assert!(status < 2, "{stderr}");
    assert_eq!(folder.json("matrix.json")["commit"], Value::Null);
    assert!(folder.read("index.html").contains("The commit is unknown:"));
    assert!(folder.read("SOURCES.sha256").contains("  spec/rules/e100l/arcs.md\n"));
}

#[test]
fn the_manifests_verify() {
    let folder = Folder::tree("manifest");
    folder.audit();
    for (manifest, place) in [("MANIFEST.sha256", folder.out()), ("SOURCES.sha256", folder.root())] {
        let list = folder.out().join(manifest);
        let output =
            Command::new("sha256sum").args(["--check", "--strict"]).arg(list).current_dir(place).output();
        match output {
            Ok(output) => assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout)),
            // Where the tool is missing the test below still compares the names.
            Err(error) => assert_eq!(error.kind(), std::io::ErrorKind::NotFound),
        }
    }
    let listed: Vec<String> = folder
        .read("MANIFEST.sha256")
        .lines()
        .map(|line| line.split_once("  ").unwrap().1.to_owned())
        .collect();
    let mut present: Vec<String> = contents(&folder.out()).into_iter().map(|(name, _)| name).collect();
    present.retain(|name| name != "MANIFEST.sha256");
    assert_eq!(listed, present);
}

#[test]
fn the_matrix_has_every_rule() {
    let folder = Folder::tree("matrix");
    folder.audit();
    let matrix = folder.json("matrix.json");
    let rules: BTreeSet<&str> =
        matrix["rules"].as_array().unwrap().iter().map(|row| row["id"].as_str().unwrap()).collect();
    let all: BTreeSet<&str> = RuleId::all().map(RuleId::as_str).collect();
    assert_eq!(rules, all);
    assert_eq!(folder.read("matrix.csv").matches("\r\n").count(), all.len() + 1);
    let page = folder.read("index.html");
    for id in all {
        assert!(page.contains(&format!("id=\"{id}\"")), "{id} is not on the page");
    }
    let shift = &matrix["rules"].as_array().unwrap().iter().find(|row| row["id"] == "E100L-G50-02").unwrap();
    let text = shift.to_string();
    for part in ["zero_shift", "a_zero_shift_only_translates", "e100l/s4-g50-shift"] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    keys_follow_the_schema(&matrix, &folder.json("matrix.schema.json"));
}

/// The objects of the matrix have exactly the keys that the schema lists.
fn keys_follow_the_schema(matrix: &Value, schema: &Value) {
    let keys = |object: &Value| object.as_object().unwrap().keys().cloned().collect::<BTreeSet<String>>();
    assert_eq!(keys(matrix), keys(&schema["properties"]));
    for row in matrix["rules"].as_array().unwrap() {
        assert_eq!(keys(row), keys(&schema["$defs"]["Row"]["properties"]));
    }
}

#[test]
fn a_failing_case_is_found() {
    let folder = Folder::tree("failing");
    let file = folder.root().join("conformance/cases/e100l/s4-g50-shift.json");
    let mut case: Value = serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    case["expect"][0] = "stop".into();
    fs::write(&file, case.to_string()).unwrap();
    let (status, stderr) = folder.audit();
    assert_eq!(status, 1, "{stderr}");
    assert!(stderr.contains("e100l/s4-g50-shift"), "{stderr}");
    assert!(folder.read("index.html").contains("✗ oracle: expected `stop`"));
}

#[test]
fn the_bill_of_materials_lists_every_package() {
    let folder = Folder::tree("sbom");
    folder.audit();
    let bill = folder.json("sbom.cdx.json");
    let component =
        |value: &Value| format!("{} {}", value["name"].as_str().unwrap(), value["version"].as_str().unwrap());
    let mut listed: BTreeSet<String> = bill["components"].as_array().unwrap().iter().map(component).collect();
    listed.insert(component(&bill["metadata"]["component"]));
    let lock: toml::Table = fs::read_to_string(folder.root().join("Cargo.lock")).unwrap().parse().unwrap();
    let packages = lock["package"].as_array().unwrap().iter();
    let locked: BTreeSet<String> = packages
        .map(|package| {
            format!("{} {}", package["name"].as_str().unwrap(), package["version"].as_str().unwrap())
        })
        .collect();
    assert_eq!(listed, locked);
    let references: BTreeSet<&str> =
        bill["dependencies"].as_array().unwrap().iter().map(|each| each["ref"].as_str().unwrap()).collect();
    assert_eq!(references.len(), locked.len());
    for each in bill["dependencies"].as_array().unwrap() {
        for on in each["dependsOn"].as_array().unwrap() {
            assert!(references.contains(on.as_str().unwrap()), "{on} is no component");
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn evidence_of_another_state_is_said() {
    let folder = Folder::tree("stale");
    let text = "{\"state\":{\"sources\":{\"spec/src\":\"00\"}},\"tools\":[],\"files\":{}}";
    fs::write(folder.root().join("evidence/coverage.json"), text).unwrap();
    let sources = sources(&folder.root()).replacen("\":\"", "\":\"0", 1);
    let none = format!("{{\"state\":{{\"sources\":{{{sources}}}}},\"tool\":\"t\",\"mutants\":[]}}");
    fs::write(folder.root().join("evidence/mutants.json"), none).unwrap();
    folder.audit();
    assert_eq!(folder.json("matrix.json")["coverage"]["freshness"]["measured_on"], "past");
    assert_eq!(
        folder.json("matrix.json")["mutants"]["untried"],
        serde_json::json!(["spec/src/barrier/arc.rs"])
    );
    let page = folder.read("index.html");
    assert!(page.contains("measured on another state of spec/src"));
    assert!(page.contains("Not tried in their present state:</strong> spec/src/barrier/arc.rs"));
}

#[test]
fn a_planted_bug_that_was_not_found_fails() {
    let folder = Folder::tree("planted");
    let bug = |name: &str, programs: &str| {
        format!("{{\"bug\":\"{name}\",\"rules\":[\"E100L-G50-02\"],\"programs\":{programs},\"bound\":100}}")
    };
    let bugs = [bug("early", "100"), bug("late", "101"), bug("hidden", "null")].join(",");
    let text = format!("{{\"state\":{{}},\"bugs\":[{bugs}]}}");
    fs::write(folder.root().join("evidence/planted.json"), text).unwrap();
    folder.audit();
    let matrix = folder.json("matrix.json");
    let findings = matrix["findings"].as_array().unwrap();
    let finding = findings.iter().find(|finding| finding["subject"] == "planted bugs").unwrap();
    assert_eq!(finding["concerns"], serde_json::json!(["late", "hidden"]));
    assert!(finding["text"].as_str().unwrap().contains("does not say on which state"), "{finding}");
    let row = matrix["rules"].as_array().unwrap().iter().find(|row| row["id"] == "E100L-G50-02").unwrap();
    assert_eq!(row["planted"][0], serde_json::json!({"bug": "early", "found": true}));
}

#[cfg(target_os = "linux")]
#[test]
fn a_survivor_needs_a_reason() {
    let folder = Folder::tree("survivor");
    let name = "spec/src/modal/carry_out.rs:99:1: replace + with - in zero_shift";
    let run = format!(
        "{{\"state\":{{\"sources\":{{{}}}}},\"tool\":\"t 1\",\"mutants\":\
         [{{\"name\":\"{name}\",\"function\":\"zero_shift\",\"outcome\":\"missed\"}}]}}",
        sources(&folder.root())
    );
    fs::write(folder.root().join("evidence/mutants.json"), run).unwrap();
    let reasons = folder.root().join("evidence/survivors.toml");
    fs::write(&reasons, "").unwrap();
    let (status, stderr) = folder.audit();
    assert!(status == 1 && stderr.contains(name), "{stderr}");
    let row = |folder: &Folder| {
        let matrix = folder.json("matrix.json");
        let rows = matrix["rules"].as_array().unwrap().clone();
        rows.into_iter().find(|row| row["id"] == "E100L-G50-02").unwrap()["mutants"].clone()
    };
    assert_eq!(row(&folder)["missed"], 1);
    fs::write(&reasons, format!("[[survivor]]\nmutant = \"{name}\"\nreason = \"none\"\n")).unwrap();
    let (_, stderr) = folder.audit();
    assert!(!stderr.contains(name), "{stderr}");
    assert_eq!(row(&folder)["explained"], 1);
    fs::write(&reasons, "[[survivor]]\nmutant = \"another\"\nreason = \"none\"\n").unwrap();
    let (status, stderr) = folder.audit();
    assert!(status == 1 && stderr.contains("another"), "{stderr}");
}

#[cfg(target_os = "linux")]
/// The sources of the oracle with their digests, as the documentation says that a shell computes them.
fn sources(root: &Path) -> String {
    let script = "find spec/src src/engine/arithmetic -name '*.rs' ! -name schema.rs | LC_ALL=C sort | xargs sha256sum";
    let output = Command::new("sh").args(["-c", script]).current_dir(root).output().expect("sh starts");
    let listing = String::from_utf8(output.stdout).unwrap();
    let pair = |line: &str| line.split_once("  ").map(|(digest, file)| format!("\"{file}\":\"{digest}\""));
    listing.lines().filter_map(pair).collect::<Vec<_>>().join(",")
}

#[test]
fn a_broken_tree_is_refused() {
    let folder = Folder::tree("no-rules");
    fs::remove_dir_all(folder.root().join("spec/rules")).unwrap();
    refused(&folder, &["spec/rules", "missing"]);

    let folder = Folder::tree("changed-rule");
    fs::write(folder.root().join("spec/rules/e100l/arcs.md"), "").unwrap();
    refused(&folder, &["spec/rules", "not the sources that this program was built from"]);

    for (file, text) in [
        ("evidence/mutants.json", "{"),
        ("evidence/coverage.json", "[]"),
        ("evidence/planted.json", "{\"bugs\": 1}"),
        ("evidence/licences.json", "{\"a\": 1}"),
        ("conformance/cases/e100l/s1-comment.json", "{}"),
        ("Cargo.lock", "package = 1"),
    ] {
        let folder = Folder::tree("broken");
        fs::write(folder.root().join(file), text).unwrap();
        refused(&folder, &[file]);
    }

    let folder = Folder::tree("reasons");
    fs::write(folder.root().join("evidence/mutants.json"), "{\"state\":{},\"tool\":\"\",\"mutants\":[]}")
        .unwrap();
    fs::write(folder.root().join("evidence/survivors.toml"), "[survivor").unwrap();
    refused(&folder, &["evidence/survivors.toml"]);
}

#[test]
fn what_is_no_tree_is_refused() {
    let folder = Folder::new("none");
    let (status, stderr) = audit(&["--out", "bundle"], &folder.0);
    assert_eq!(status, 2);
    assert!(stderr.contains("not inside a source tree"), "{stderr}");
    let (status, stderr) = audit(&["--out", "bundle", "--root", "."], &folder.0);
    assert_eq!(status, 2);
    assert!(stderr.contains("no source tree of Turnspec"), "{stderr}");
    assert!(!folder.out().exists());
}

#[test]
fn a_folder_with_something_else_is_left_alone() {
    let folder = Folder::tree("occupied");
    fs::create_dir(folder.out()).unwrap();
    let (status, stderr) = folder.audit();
    assert!(status < 2, "an empty folder is filled: {stderr}");
    fs::write(folder.out().join("mine.txt"), "mine").unwrap();
    let before = contents(&folder.out());
    let (status, stderr) = folder.audit();
    assert_eq!(status, 2);
    assert!(stderr.contains("not empty and no former bundle"), "{stderr}");
    assert!(before == contents(&folder.out()));
}

/// A manifest alone makes no bundle, whatever it says.
#[test]
fn a_foreign_folder_with_a_manifest_is_left_alone() {
    let folder = Folder::tree("foreign");
    let digest = "b5bb9d8014a0f9b1d61e21e796d78dccdf1352f23cd32812f4850b878ae4944c";
    for name in ["thesis.txt", "index.html"] {
        fs::create_dir(folder.out()).unwrap();
        fs::write(folder.out().join(name), "foo\n").unwrap();
        fs::write(folder.out().join("MANIFEST.sha256"), format!("{digest}  {name}\n")).unwrap();
        let before = contents(&folder.out());
        let (status, stderr) = folder.audit();
        assert_eq!(status, 2, "{stderr}");
        assert!(stderr.contains("no former bundle"), "{stderr}");
        assert!(before == contents(&folder.out()));
        fs::remove_dir_all(folder.out()).unwrap();
    }
}

#[test]
fn an_altered_bundle_is_left_alone() {
    let folder = Folder::tree("altered");
    folder.audit();
    let page = folder.out().join("index.html");
    fs::write(&page, folder.read("index.html") + "<!-- seen, 3 May -->").unwrap();
    let before = contents(&folder.out());
    let (status, stderr) = folder.audit();
    assert_eq!(status, 2, "{stderr}");
    assert!(stderr.contains("its files are not those of its manifest"), "{stderr}");
    assert!(before == contents(&folder.out()));
    fs::remove_file(&page).unwrap();
    assert_eq!(folder.audit().0, 2, "a bundle with a file missing");
}

#[test]
fn a_link_to_a_folder_stands_for_the_folder() {
    let folder = Folder::tree("link");
    let (link, real) = (folder.0.join("bundle"), folder.0.join("real"));
    std::os::unix::fs::symlink(&real, &link).unwrap();
    let (status, stderr) = folder.audit();
    assert_eq!(status, 2, "{stderr}");
    assert!(stderr.contains("a link that leads nowhere"), "{stderr}");
    fs::create_dir(&real).unwrap();
    for _ in 0..2 {
        let (status, stderr) = folder.audit();
        assert!(status < 2, "{stderr}");
        assert!(link.is_symlink() && real.join("MANIFEST.sha256").is_file());
    }
    let beside = fs::read_dir(&folder.0).unwrap().count();
    assert_eq!(beside, 3, "a temporary folder was left");
}

#[test]
fn a_place_for_no_folder_is_refused() {
    let folder = Folder::tree("place");
    let here = folder.0.join("here");
    fs::create_dir(&here).unwrap();
    fs::write(folder.0.join("file"), "").unwrap();
    let root = folder.root();
    for (out, because) in [
        (".", "the current folder"),
        ("../here", "the current folder"),
        ("../file/bundle", "no folder"),
        ("missing/..", "no name"),
    ] {
        let (status, stderr) = audit(&["--root", root.to_str().unwrap(), "--out", out], &here);
        assert_eq!(status, 2, "{out}: {stderr}");
        assert!(stderr.contains(because), "{out}: {stderr}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_name_that_is_not_utf_8_is_told() {
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::tree("name");
    folder.commit();
    fs::write(folder.root().join(std::ffi::OsStr::from_bytes(b"caf\xE9.txt")), "").unwrap();
    let (status, stderr) = folder.audit();
    assert_eq!(status, 1, "{stderr}");
    assert!(stderr.contains("dirty") && stderr.contains("?? caf\u{FFFD}.txt"), "{stderr}");
    fs::remove_dir_all(folder.out()).unwrap();
    folder.git(&["add", "--all"]);
    refused(&folder, &["caf\u{FFFD}.txt", "not UTF-8"]);
}
