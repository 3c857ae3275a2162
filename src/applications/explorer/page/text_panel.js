// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The scene as text, under its file's name, with what of it cannot be dragged. */

import { fixedShapes } from "../drawing/fixed_shapes.js";
import keys from "topple:keys";
import { Editor } from "../editor/editor.js";
import { keyCompletion } from "../editor/key_completion.js";
import { keyHelp } from "../editor/key_help.js";
import { element } from "../panels/element.js";
import { pointsButtons } from "./points_into_scene.js";

/** It is no panel of results: it follows the text by itself. */
export class TextPanel {
  /** @param {HTMLElement} place @param {{store: import("../scene/store.js").SceneStore, terms: import("../panels/terms.js").Terms}} context */
  constructor(place, { store, terms }) {
    const name = element("p", { class: "quiet", id: "scene-name" });
    const fixed = element("ul", { class: "quiet", id: "fixed" });
    const room = element("div", { id: "editor" });
    const help = element("p", { class: "quiet", id: "key-help", role: "status" });
    place.append(name, fixed, room, help);
    const explain = (path) => terms.explainKey(path);
    this.editor = new Editor(room, store, [...keyHelp(store, explain, help), keyCompletion(keys, explain)]);
    // Its messages come later, when there is a strip for them.
    this.messages = null;
    store.addEventListener("text", () => {
      name.textContent = store.name;
      const said = [...fixedShapes(store.parsed).map((words) => words + "."), ...pointsButtons(store, { say: (words) => this.messages?.say(words) })];
      fixed.replaceChildren(...said.map((each) => element("li", {}, each)));
    });
  }

  show() {
    this.editor.shown = true;
  }

  hide() {
    this.editor.shown = false;
  }
}
