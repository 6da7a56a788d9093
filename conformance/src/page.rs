//! A page to read: one self-contained HTML file, light and dark, for a screen of any width and for paper.
//!
//! Text is escaped by `maud`; nothing is loaded from elsewhere and no script runs.

use maud::{DOCTYPE, Markup, PreEscaped, html};

/// The look of every page.
const STYLE: &str = "\
:root{color-scheme:light dark;--text:#1c1f23;--back:#fff;--soft:#f3f4f6;--line:#d5d9de;--faint:#5b636d;\
--good:#14713c;--bad:#b3261e;--warn:#8a5a00}\
@media (prefers-color-scheme:dark){:root{--text:#e4e7eb;--back:#14171a;--soft:#1f2429;--line:#3a4149;\
--faint:#9aa4af;--good:#5fd38d;--bad:#ff8a80;--warn:#f0b75a}}\
*{box-sizing:border-box}\
body{margin:0 auto;max-width:72rem;padding:1.5rem 1rem 4rem;font:16px/1.5 system-ui,sans-serif;color:var(--text);\
background:var(--back)}\
h1{font-size:1.6rem;line-height:1.25;margin:0 0 .5rem}h2{font-size:1.2rem;margin:2.2rem 0 .6rem}\
h3{font-size:1rem;margin:0}p{margin:.5rem 0}a{color:inherit}\
code,pre{font:.86em/1.45 ui-monospace,monospace}\
pre{white-space:pre-wrap;overflow-wrap:anywhere;background:var(--soft);padding:.6rem .8rem;border-radius:.3rem;\
margin:.5rem 0}\
.scroll{overflow-x:auto}\
table{border-collapse:collapse;width:100%;font-size:.92rem}\
th,td{text-align:left;vertical-align:top;padding:.3rem .7rem .3rem 0;border-bottom:1px solid var(--line)}\
td.number,th.number{text-align:right;font-variant-numeric:tabular-nums}\
table.narrow{width:auto}td code{overflow-wrap:anywhere}\
details{border-bottom:1px solid var(--line);padding:.5rem 0}summary{cursor:pointer}\
dl{display:grid;grid-template-columns:max-content minmax(0,1fr);gap:.2rem 1rem;margin:.6rem 0}\
dt{color:var(--faint)}dd{margin:0;overflow-wrap:anywhere}\
.faint{color:var(--faint)}.good{color:var(--good)}.bad{color:var(--bad)}.warn{color:var(--warn)}\
.tag{font-size:.82rem;font-weight:600}\
@media (max-width:40rem){body{padding:1rem .7rem 3rem}dl{grid-template-columns:1fr}dt{margin-top:.4rem}}\
@media print{:root{color-scheme:light;--text:#000;--back:#fff;--soft:#f3f4f6;--line:#bbb;--faint:#444;\
--good:#0b5a2c;--bad:#9b1c14;--warn:#6d4700}body{max-width:none;padding:0;font-size:10pt}\
details,tr{break-inside:avoid}h2,h3{break-after:avoid}}";

/// Text of a rule for a page: paragraphs, tables as they stand, words in backticks as code.
#[must_use]
pub fn prose(markdown: &str) -> Markup {
    html! {
        @for paragraph in markdown.split("\n\n") {
            @if paragraph.starts_with(['|', ' ']) || paragraph.contains("\n|") { pre { (paragraph) } }
            @else {
                p {
                    @for (number, part) in paragraph.split('`').enumerate() {
                        @if number % 2 == 0 { (part) } @else { code { (part) } }
                    }
                }
            }
        }
    }
}

/// A page with a title and a body in the look of the reports. The title stands in the head only.
#[must_use]
pub fn page(title: &str, body: &Markup) -> String {
    page_with(title, STYLE, body)
}

/// Text with a replacement for each character that XML forbids, and a page had better not have either.
#[must_use]
pub fn permitted(text: &str) -> String {
    let permitted = |each: char| matches!(each, '\t' | '\n' | '\r' | ' '..='\u{FFFD}' | '\u{10000}'..);
    text.chars().map(|each| if permitted(each) { each } else { char::REPLACEMENT_CHARACTER }).collect()
}

/// A page with a title, a look of its own and a body. Characters that are not [`permitted`] are replaced.
#[must_use]
pub fn page_with(title: &str, style: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(style)) }
            }
            body { (body) }
        }
    };
    permitted(&page.into_string())
}

#[cfg(test)]
mod tests {
    use maud::html;

    use super::{page, prose};

    #[test]
    fn text_is_escaped_and_nothing_is_loaded() {
        let text = page("<title>", &html! { p { "a <script> & more\u{1}" } });
        assert!(text.starts_with("<!DOCTYPE html>") && text.contains("&lt;title&gt;"));
        assert!(text.contains("a &lt;script&gt; &amp; more\u{FFFD}</p>"));
        let prose = prose("a `G01` <b>\n\n| x |").into_string();
        assert_eq!(prose, "<p>a <code>G01</code> &lt;b&gt;</p><pre>| x |</pre>");
        for foreign in ["<script", "http:", "https:", "url(", "@import", "src="] {
            assert!(!text.contains(foreign), "{foreign}");
        }
    }
}
