// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The dialogue for those who pass a scene on: its link, the link as a code for a camera, a line for another page, print. */

import { element } from "../panels/element.js";
import { say } from "../words/language.js";
import { codeOf } from "./code.js";

/** @param {HTMLDialogElement} dialog @param {HTMLButtonElement} button @param {{link: () => Promise<string>}} page link: the address that carries the scene */
export function sendDialog(dialog, button, { link }) {
  const field = element("input", { type: "text", readonly: true, "aria-label": "The link", onfocus: () => field.select() });
  const code = element("div", { class: "code-place" });
  const note = element("p", { class: "quiet" });
  dialog.querySelector(".send-link").prepend(field);
  dialog.querySelector(".send-code").append(code, note);
  button.addEventListener("click", async () => {
    dialog.showModal();
    try {
      const address = await link();
      field.value = address;
      const drawn = codeOf(address, say("The link as a code"));
      code.replaceChildren(...(drawn === null ? [] : [drawn]));
      note.textContent = drawn === null ? say("The link is too long for a code: copy it, or send the file.")
        : location.protocol === "file:" ? say("This page is a file on this machine: a link to it opens where the file lies at the same place.") : "";
    } catch (error) {
      field.value = "";
      code.replaceChildren();
      note.textContent = error.message;
    }
  });
  for (const each of dialog.querySelectorAll("button")) each.addEventListener("click", () => dialog.close());
  dialog.querySelector("#print").addEventListener("click", () => print());
}
