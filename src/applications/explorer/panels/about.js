// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What the page is, whose it is, and what is inlined into it, each with its licence and its notice. */

import { element, table } from "./element.js";
import { Panel } from "./panel.js";
import libraries from "topple:libraries";
import packed from "topple:licence_texts";
import { unpacked } from "../core/packed.js";
import { parts, say } from "../words/language.js";

const VERSION_MAX_MS = 5000;

export class AboutPanel extends Panel {
  get isOfScene() {
    return false;
  }

  constructor(place, context) {
    super(place, context);
    const texts = element("div", {});
    const version = element("strong", {}, "topple");
    this.body.append(
      element(
        "p", {}, parts("%s: does a rock block stand, slide or topple on its base? Free software under the GNU General Public License, version 3 or later, without any warranty. This page holds the whole program, works without a network, and sends nothing anywhere.", version),
      ),
      table(say("What is inlined"), ["library", "licence", "for"].map((head) => say(head)), libraries.map(({ name, licence, for: purpose }) => ({
        cells: [name, licence, say(purpose)],
      }))),
      element("p", {}, say("The texts of the licences, and the notices that go with them:")),
      texts,
    );
    new Response(unpacked(packed)).json().then((found) => texts.append(...Object.entries(found.licences).map(([name, text]) => foldedText(name, text)),
      ...found.notices.map((notice, at) => foldedText(named(at), notice))));
    this.core.run(["--version"], {}, { timeoutMs: VERSION_MAX_MS }).then(
      (answer) => (version.textContent = answer.out.trim() || "topple"),
      () => {}, // a core that was stopped has no version to tell; the page says so by itself
    );
  }
}

/** A text of many lines below its name. */
function foldedText(name, text) {
  return element("details", {}, element("summary", {}, name), element("pre", { class: "wide", tabindex: 0 }, text));
}

function named(notice) {
  return libraries.filter((each) => each.notice === notice).map(({ name }) => name).join(", ");
}
