// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The menu of scenes: some to begin one's own with, and all of the project's examples with the files that they name. */

import examples from "topple:examples";
import { TEMPLATES } from "./templates.js";

const GROUPS = [["Begin your own", TEMPLATES], ["Examples", examples]];
const ALL = GROUPS.flatMap(([, scenes]) => scenes);

export class ExamplesMenu {
  /** @param {HTMLSelectElement} select @param {import("../scene/store.js").SceneStore} store */
  constructor(select, store) {
    this.select = select;
    this.store = store;
    for (const [label, scenes] of GROUPS) {
      const group = document.createElement("optgroup");
      group.label = label;
      group.append(...scenes.map(({ name, title }) => new Option(title, name)));
      select.append(group);
    }
    select.addEventListener("change", () => this.open(select.value));
    store.addEventListener("text", () => {
      const found = ALL.find((one) => one.name === store.name);
      select.value = found !== undefined && found.text === store.text ? found.name : "";
    });
  }

  /** @param {string} name as block_e_valley.yaml */
  open(name) {
    const found = ALL.find((one) => one.name === name);
    if (found !== undefined) this.store.open({ name, text: found.text, files: found.files });
  }
}
