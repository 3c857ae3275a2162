// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What a key of the scene means, as `topple explain` says it: below the text for the one at the cursor, and over it at the pointer. */

import { EditorView, hoverTooltip } from "@codemirror/view";
import { element } from "../panels/element.js";
import { keyAt } from "../scene/key_at.js";

/**
 * @param {import("../scene/store.js").SceneStore} store
 * @param {(path: string) => Promise<{title: string, rows: {label: string, text: string}[]}>} explain
 * @param {HTMLElement} line where that of the cursor stands
 */
export function keyHelp(store, explain, line) {
  // where lines end in two characters the editor counts one: then no place is told
  const at = (offset) => (store.parsed.root === null || store.text.includes("\r") ? null : keyAt(store.parsed, offset));
  let shown = "";
  const atCursor = async (view) => {
    await null; // what was typed is the scene's text first
    const path = at(view.state.selection.main.head)?.path ?? "";
    if (path === shown) return;
    shown = path;
    const told = path === "" ? null : await explain(path);
    if (shown === path) line.textContent = told === null ? "" : sentenceOf(told);
  };
  return [
    EditorView.updateListener.of((update) => {
      if (update.selectionSet && update.view.hasFocus) atCursor(update.view);
    }),
    hoverTooltip(async (view, offset) => {
      const found = at(offset);
      if (found === null || offset > found.to) return null;
      const told = await explain(found.path);
      return { pos: found.from, end: found.to, above: true, create: () => ({ dom: tooltipOf(told) }) };
    }),
  ];
}

function sentenceOf({ title, rows }) {
  return title + ": " + rows.map(({ label, text }) => (label === "" ? text : label + " " + text)).join("; ");
}

/** @param {{title: string, rows: {label: string, text: string}[]}} told */
export function tooltipOf({ title, rows }) {
  const lines = rows.map(({ label, text }) => element("p", {}, label === "" ? null : element("span", { class: "label" }, label + " "), text));
  return element("div", { class: "key-help" }, element("strong", {}, title), lines);
}
