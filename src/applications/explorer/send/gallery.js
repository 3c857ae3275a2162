// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** All scenes of the menu as pictures in their groups, solved while one looks at them. */

import { element } from "../panels/element.js";
import { kindOf } from "../scene/kind.js";
import { SceneText } from "../scene/scene_text.js";
import { solutionOf } from "../scene/solution.js";
import { askedFor } from "../scene/store.js";
import { MODEL } from "../solid/model.js";
import { say } from "../words/language.js";
import { shortVerdict, thumbnail } from "./thumbnail.js";
import { refusalOf } from "../scene/complaint.js";

const SOLVE_MAX_MS = 20_000;

/** @param {HTMLDialogElement} dialog @param {HTMLButtonElement} button @param {{menu: import("../examples/menu.js").ExamplesMenu, core: {run: Function}}} page */
export function gallery(dialog, button, { menu, core }) {
  let cards = null;
  button.addEventListener("click", async () => {
    dialog.showModal();
    if (cards !== null) return;
    cards = menu.all.map((scene) => cardOf(scene, () => (dialog.close(), menu.open(scene.name))));
    const groups = [...new Set(menu.all.map(({ group }) => group))];
    dialog.querySelector(".cards").append(...groups.map((group) => element("section", {}, element("h3", {}, say(group)),
      element("div", { class: "card-row" }, cards.filter(({ scene }) => scene.group === group).map(({ card }) => card)))));
    const seen = new IntersectionObserver((entries) => entries.forEach(({ isIntersecting, target }) => {
      if (!isIntersecting) return;
      seen.unobserve(target);
      draw(cards.find(({ card }) => card === target), core);
    }), { root: dialog, rootMargin: "200px" });
    for (const { card } of cards) seen.observe(card);
  });
  dialog.querySelector(".close").addEventListener("click", () => dialog.close());
}

function cardOf(scene, open) {
  const place = element("span", { class: "thumb-place" });
  const verdict = element("span", { class: "card-verdict" });
  return { scene, place, verdict, card: element("button", { type: "button", class: "card", onclick: open }, place, element("span", { class: "card-title" }, say(scene.title)), verdict) };
}

async function draw({ scene, place, verdict, card }, core) {
  const parsed = new SceneText(scene.text);
  const kind = kindOf(parsed);
  try {
    const { words: asked, collect } = askedFor(kind, parsed);
    const answer = await core.run([...asked, scene.name], { ...scene.files, [scene.name]: scene.text }, { timeoutMs: SOLVE_MAX_MS, collect });
    if (answer.out === "") throw refusalOf(answer);
    const solution = { ...solutionOf(kind, answer.out), model: answer.files[MODEL] };
    place.replaceChildren(thumbnail(solution, scene));
    const { words, kind: colour } = shortVerdict(solution);
    verdict.textContent = words;
    card.dataset.kind = colour;
  } catch (error) {
    verdict.textContent = error.message;
  }
  card.dataset.drawn = "";
}
