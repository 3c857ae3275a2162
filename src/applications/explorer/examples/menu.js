// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The menu of scenes: some to begin one's own with, and all of the project's examples with the files that they name. */

import { examples } from "./examples.js";
import { TEMPLATES } from "./templates.js";
import { say } from "../words/language.js";

const ALL = [...TEMPLATES.map((each) => ({ ...each, group: "Begin your own" })), ...examples];
const GROUPS = [...new Set(ALL.map(({ group }) => group))];

export class ExamplesMenu {
  /** @param {HTMLSelectElement} select @param {import("../scene/store.js").SceneStore} store */
  constructor(select, store) {
    this.select = select;
    this.store = store;
    for (const label of GROUPS) {
      const group = document.createElement("optgroup");
      group.label = say(label);
      group.append(...ALL.filter((each) => each.group === label).map(({ name, title }) => new Option(say(title), name)));
      select.append(group);
    }
    select.addEventListener("change", () => this.open(select.value));
    store.addEventListener("text", () => (select.value = this.present ?? ""));
  }

  /** All scenes of it: {name, group, title, text, files}. */
  get all() {
    return ALL;
  }

  /** The name of the scene that is on the page, as it stands in the menu; null: it is another one. @returns {string|null} */
  get present() {
    const found = ALL.find((one) => one.name === this.store.name);
    return found !== undefined && found.text === this.store.text ? found.name : null;
  }

  /** @param {string} name as block_e_valley.yaml @returns {boolean} whether there is one */
  open(name) {
    const found = ALL.find((one) => one.name === name);
    if (found !== undefined) this.store.open({ name, text: found.text, files: found.files });
    return found !== undefined;
  }
}
