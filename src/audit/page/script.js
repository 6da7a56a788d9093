// Search and filters of the rule table; without it every rule is shown.
"use strict";
(() => {
  const form = document.getElementById("filter");
  const count = document.getElementById("count");
  const rules = [...document.querySelectorAll("details.rule")];
  const texts = new Map(rules.map((rule) => [rule, rule.textContent.toLowerCase()]));
  const shown = () => rules.filter((rule) => !rule.hidden);

  function filter() {
    const { text, area, level, basis } = form.elements;
    const words = text.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const rule of rules) {
      rule.hidden = !(
        [area, level, basis].every((field) => !field.value || rule.dataset[field.name] === field.value) &&
        words.every((word) => texts.get(rule).includes(word))
      );
    }
    count.value = `${shown().length} of ${rules.length} rules`;
  }

  function follow() {
    const rule = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!rule?.matches("details.rule")) return;
    if (rule.hidden) {
      form.reset();
      filter();
    }
    rule.open = true;
    rule.scrollIntoView();
  }

  let closed = [];
  addEventListener("beforeprint", () => {
    closed = [...document.querySelectorAll("details:not([open])")].filter((each) => !each.hidden);
    for (const each of closed) each.open = true;
  });
  addEventListener("afterprint", () => {
    for (const each of closed) each.open = false;
  });
  addEventListener("hashchange", follow);
  document.addEventListener("click", (event) => {
    const link = event.target.closest?.("a[href^='#']");
    if (link && link.getAttribute("href") === location.hash) follow();
  });
  form.addEventListener("input", (event) => {
    if (event.target.name === "open") for (const rule of shown()) rule.open = event.target.checked;
    else filter();
  });
  form.addEventListener("submit", (event) => event.preventDefault());
  form.hidden = false;
  filter();
  follow();
})();
