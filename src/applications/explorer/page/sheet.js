// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** On a narrow window the results are a sheet from below: a press on its edge makes it higher, the drawing stays in view. */

import { say } from "../words/language.js";

/** @param {HTMLButtonElement} grip */
export function sheet(grip) {
  const put = (tall) => {
    document.body.classList.toggle("tall-sheet", tall);
    grip.setAttribute("aria-expanded", String(tall));
    grip.textContent = say(tall ? "Less of the results" : "More of the results");
  };
  grip.addEventListener("click", () => put(!document.body.classList.contains("tall-sheet")));
}
