//! The report as JUnit XML, for build servers.
//!
//! A mismatch and whatever else the trace shows is a `failure`, what the process did wrong an `error`. A
//! waived case is a passed one with the waiver in its output.

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use super::summary::explained;
use super::{CaseReport, Report, Ruling};
use crate::page::permitted as text;

/// The report as XML text.
///
/// # Errors
/// When it cannot be written as XML.
pub fn junit(report: &Report) -> io::Result<String> {
    let mut writer = Writer::new_with_indent(Vec::new(), b' ', 2);
    writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let is_error = |case: &&CaseReport| element(case.verdict) == "error";
    let errors = report.failures().filter(is_error).count();
    let failures = report.failures().count() - errors;
    let seconds: f64 = report.cases.iter().map(|case| case.seconds).sum();
    writer.create_element("testsuites").write_inner_content(|writer| {
        writer
            .create_element("testsuite")
            .with_attribute(("name", text(&report.implementation).as_str()))
            .with_attribute(("tests", report.cases.len().to_string().as_str()))
            .with_attribute(("failures", failures.to_string().as_str()))
            .with_attribute(("errors", errors.to_string().as_str()))
            .with_attribute(("skipped", report.count(Ruling::Skipped).to_string().as_str()))
            .with_attribute(("time", format!("{seconds:.3}").as_str()))
            .write_inner_content(|writer| report.cases.iter().try_for_each(|each| case(writer, each)))
            .map(|_| ())
    })?;
    writer.write_event(Event::Text(BytesText::from_escaped("\n")))?;
    String::from_utf8(writer.into_inner()).map_err(io::Error::other)
}

fn case(writer: &mut Writer<Vec<u8>>, case: &CaseReport) -> io::Result<()> {
    let (class, _) = case.id.rsplit_once('/').unwrap_or((&case.id, ""));
    let element_of_case = writer
        .create_element("testcase")
        .with_attribute(("classname", text(&class.replace('/', ".")).as_str()))
        .with_attribute(("name", text(&format!("{}: {}", case.id, case.title)).as_str()))
        .with_attribute(("time", format!("{:.3}", case.seconds).as_str()));
    let reason = text(&case.reason);
    match case.verdict {
        Ruling::Pass => element_of_case.write_empty()?,
        Ruling::Skipped => element_of_case.write_inner_content(|writer| {
            writer.create_element("skipped").with_attribute(("message", reason.as_str())).write_empty()?;
            Ok(())
        })?,
        Ruling::Waived => element_of_case.write_inner_content(|writer| {
            writer.create_element("system-out").write_text_content(BytesText::new(&reason))?;
            Ok(())
        })?,
        verdict => element_of_case.write_inner_content(|writer| {
            let explanation = text(&case.explanation.as_ref().map(explained).unwrap_or_default());
            writer
                .create_element(element(verdict))
                .with_attribute(("type", verdict.as_str()))
                .with_attribute(("message", reason.as_str()))
                .write_text_content(BytesText::new(&explanation))?;
            if !case.stderr.is_empty() {
                let stderr = text(&case.stderr);
                writer.create_element("system-err").write_text_content(BytesText::new(&stderr))?;
            }
            Ok(())
        })?,
    };
    Ok(())
}

fn element(verdict: Ruling) -> &'static str {
    match verdict {
        Ruling::Mismatch | Ruling::Unsupported | Ruling::StaleWaiver => "failure",
        _ => "error",
    }
}
