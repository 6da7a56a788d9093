"use strict";
const told = new Map(JSON.parse(document.getElementById("told").textContent).map((each) => [each.n, each]));
const motions = [...document.querySelectorAll("[data-n]")];
const panel = document.querySelector(".told");
let shown = -1;

function show(index) {
  if (index < 0 || index >= motions.length) return;
  motions[shown]?.classList.remove("shown");
  shown = index;
  motions[shown].classList.add("shown");
  const each = told.get(Number(motions[shown].dataset.n));
  if (!each) return;
  document.querySelector(".hint").hidden = true;
  panel.hidden = false;
  panel.querySelector(".line").textContent = `line ${each.line}`;
  panel.querySelector(".block").textContent = each.block;
  panel.querySelector(".event").textContent = `${each.n}. ${each.event}`;
  panel.querySelector(".rules").replaceChildren(...each.rules.map((rule) => {
    const item = document.createElement("li");
    item.textContent = rule;
    return item;
  }));
}

// A thin line is hard to hit: the nearest motion within a few pixels counts.
document.querySelector(".sheet svg").addEventListener("pointermove", (event) => {
  for (const [x, y] of [[0, 0], [0, 3], [3, 0], [0, -3], [-3, 0], [0, 6], [6, 0], [0, -6], [-6, 0]]) {
    const hit = document.elementFromPoint(event.clientX + x, event.clientY + y)?.closest("[data-n]");
    if (hit) return show(motions.indexOf(hit));
  }
});
document.addEventListener("keydown", (event) => {
  const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
  if (!step) return;
  event.preventDefault();
  show(shown + step);
});
