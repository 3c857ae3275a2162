// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What the page is made of, and under which licences: a dialogue whose texts are put in when it is first opened. */

import licences from "topple:licences";

/** @param {HTMLButtonElement} button @param {HTMLDialogElement} dialog @param {{run: Function}} core */
export function aboutDialog(button, dialog, core) {
  button.addEventListener("click", () => {
    if (dialog.querySelector("details") === null) fill(dialog, core);
    dialog.showModal();
  });
}

function fill(dialog, core) {
  const list = dialog.querySelector(".licences");
  list.append(...licences.map(({ name, version, licence, text }) => {
    const part = document.createElement("details");
    const summary = document.createElement("summary");
    const notice = document.createElement("pre");
    summary.textContent = name + (version === "" ? "" : " " + version) + ": " + licence;
    part.append(summary, notice);
    part.addEventListener("toggle", () => (notice.textContent = part.open ? text : ""));
    return part;
  }));
  core.run(["--version"], {}, {}).then(
    (answer) => (dialog.querySelector(".version").textContent = answer.out.split("\n")[0]),
    () => {}, // without a core there is no version to tell, and the strip says why
  );
}
