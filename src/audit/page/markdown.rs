//! Markdown of a rule's text as HTML: raw HTML is shown as text, ids of rules become links within the page,
//! links to other files lose their target.

use maud::{Markup, PreEscaped};
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};
use turnspec_oracle::vocabulary::RuleId;

/// Renders a text.
#[must_use]
pub fn render(text: &str) -> Markup {
    let options = Options::ENABLE_TABLES | Options::ENABLE_SMART_PUNCTUATION;
    let mut events = Vec::new();
    let mut code = false;
    for event in Parser::new_ext(text, options) {
        match event {
            Event::Html(raw) | Event::InlineHtml(raw) => events.push(Event::Text(raw)),
            Event::Start(Tag::Link { .. } | Tag::Image { .. }) | Event::End(TagEnd::Link | TagEnd::Image) => {
            }
            Event::Start(Tag::CodeBlock(_)) | Event::End(TagEnd::CodeBlock) => {
                code = matches!(event, Event::Start(_));
                events.push(event);
            }
            // Wider than a narrow screen, perhaps.
            Event::Start(Tag::Table(_)) => {
                events.extend([Event::InlineHtml(CowStr::Borrowed("<div class=\"scroll\">")), event]);
            }
            Event::End(TagEnd::Table) => {
                events.extend([event, Event::InlineHtml(CowStr::Borrowed("</div>\n"))]);
            }
            Event::Text(words) if !code => link_rules(&words, &mut events),
            event => events.push(event),
        }
    }
    let mut page = String::new();
    html::push_html(&mut page, events.into_iter());
    PreEscaped(page)
}

/// A text with its rule ids as links; the texts leave the name of the control out of most of them.
fn link_rules(text: &str, events: &mut Vec<Event<'_>>) {
    let mut plain = String::new();
    for word in text.split_inclusive(|letter: char| !letter.is_ascii_alphanumeric() && letter != '-') {
        let id = word.trim_end_matches(|letter: char| !letter.is_ascii_alphanumeric());
        match RuleId::parse(id).or_else(|| RuleId::parse(&format!("E100L-{id}"))) {
            Some(rule) => {
                events.push(Event::Text(CowStr::from(std::mem::take(&mut plain))));
                events.push(Event::InlineHtml(CowStr::from(format!("<a href=\"#{rule}\">{id}</a>"))));
                plain.push_str(word.split_at(id.len()).1);
            }
            None => plain.push_str(word),
        }
    }
    events.push(Event::Text(CowStr::from(plain)));
}

#[cfg(test)]
mod tests {
    use super::render;

    fn html(text: &str) -> String {
        render(text).into_string()
    }

    #[test]
    fn rules_become_links_and_foreign_links_text() {
        assert_eq!(
            html("See E100L-G50-02, `E100L-G50-02` and [there](x.md)."),
            "<p>See <a href=\"#E100L-G50-02\">E100L-G50-02</a>, <code>E100L-G50-02</code> and there.</p>\n"
        );
        assert_eq!(html("(G50-02)"), "<p>(<a href=\"#E100L-G50-02\">G50-02</a>)</p>\n");
        assert_eq!(html("E100L-NONE-77 E100L-, \u{2212}1."), "<p>E100L-NONE-77 E100L-, \u{2212}1.</p>\n");
    }

    #[test]
    fn a_table_scrolls() {
        let table = html("| a |\n|---|\n| b |\n\nc\n");
        assert!(table.starts_with("<div class=\"scroll\"><table>"), "{table}");
        assert!(table.ends_with("</table>\n</div>\n<p>c</p>\n"), "{table}");
    }

    #[test]
    fn raw_html_is_text() {
        assert_eq!(html("a <b onclick=x> c"), "<p>a &lt;b onclick=x&gt; c</p>\n");
        assert!(!html("<script>alert(1)</script>").contains("<script"));
    }
}
