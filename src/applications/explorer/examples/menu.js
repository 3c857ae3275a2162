// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The menu of examples: all scenes of the project's examples, inlined with the files that they name. */

import examples from "topple:examples";

export class ExamplesMenu {
  /** @param {HTMLSelectElement} select @param {import("../scene/store.js").SceneStore} store */
  constructor(select, store) {
    this.select = select;
    this.store = store;
    for (const { name, title } of examples) select.append(new Option(title, name));
    select.addEventListener("change", () => this.open(select.value));
    store.addEventListener("text", () => {
      const found = examples.find((one) => one.name === store.name);
      select.value = found !== undefined && found.text === store.text ? found.name : "";
    });
  }

  /** @param {string} name as block_e_valley.yaml */
  open(name) {
    const found = examples.find((one) => one.name === name);
    if (found !== undefined) this.store.open({ name, text: found.text, files: found.files });
  }
}
