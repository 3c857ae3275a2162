// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Of many blocks, and of solids, the verdict is the report of the command line, whose words and numbers are all there. */

import { element } from "./element.js";

const REPORT_MAX_MS = 60_000;

/** @param {import("./panel.js").Panel} panel @returns {HTMLElement} which gets its text when it is there */
export function otherReport({ store, background, files }) {
  const text = element("pre", { class: "wide", tabindex: 0, "aria-label": "Report" }, "…");
  const options = { latest: "other report", timeoutMs: REPORT_MAX_MS };
  background.run(["solve", store.argument], files.call({ store }), options).then(
    (answer) => (text.textContent = answer.out + answer.err),
    (error) => error.name !== "AbortError" && (text.textContent = error.message),
  );
  return text;
}
