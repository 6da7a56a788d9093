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
            Event::Text(words) if !code => link_rules(&words, &mut events),
            event => events.push(event),
        }
    }
    let mut page = String::new();
    html::push_html(&mut page, events.into_iter());
    PreEscaped(page)
}

/// A text with its rule ids as links.
fn link_rules(text: &str, events: &mut Vec<Event<'_>>) {
    let mut rest = text;
    while let Some(word) = next_id(rest) {
        let (before, after) = rest.split_at(word.0);
        let (id, tail) = after.split_at(word.1);
        events.push(Event::Text(CowStr::from(before.to_owned())));
        events.push(Event::InlineHtml(CowStr::from(format!("<a href=\"#{id}\">{id}</a>"))));
        rest = tail;
    }
    events.push(Event::Text(CowStr::from(rest.to_owned())));
}

/// Place and length of the first rule id.
fn next_id(text: &str) -> Option<(usize, usize)> {
    let mut from = 0;
    while let Some(place) = text.get(from..)?.find("E100L-") {
        let start = from + place;
        let word = text.get(start..)?;
        let length = word.find(|letter: char| !letter.is_ascii_alphanumeric() && letter != '-');
        let word = word.split_at(length.unwrap_or(word.len())).0.trim_end_matches('-');
        if RuleId::parse(word).is_some() {
            return Some((start, word.len()));
        }
        from = start + 1;
    }
    None
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
        assert_eq!(html("E100L-NONE-77 E100L-"), "<p>E100L-NONE-77 E100L-</p>\n");
    }

    #[test]
    fn raw_html_is_text() {
        assert_eq!(html("a <b onclick=x> c"), "<p>a &lt;b onclick=x&gt; c</p>\n");
        assert!(!html("<script>alert(1)</script>").contains("<script"));
    }
}
