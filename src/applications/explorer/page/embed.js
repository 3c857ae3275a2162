// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The page within another one, as a course or a paper has it: `#embed` shows the drawing with its badge alone,
 * `#embed=forces,map` these tabs beside it; `&` and the scene of a link may follow. And the line of HTML that does it.
 */

import { linkOfScene } from "../scene/link.js";

const EMBED = /^#embed(?:=([a-z,]*))?(?:&(.*))?$/;
const SIZE = 'width="900" height="560"';

/** @param {string} hash of an address @returns {{tabs: string[], link: string}|null} null: it is none for another page */
export function readEmbed(hash) {
  const found = EMBED.exec(hash);
  if (found === null) return null;
  return { tabs: (found[1] ?? "").split(",").filter((tab) => tab !== ""), link: found[2] === undefined ? "" : "#" + found[2] };
}

/** @param {{tabs: string[]}} wanted @param {import("../panels/tabs.js").Tabs} tabs */
export function showEmbedded({ tabs: wanted }, tabs) {
  document.body.classList.add("embedded");
  document.getElementById("scene-title").setAttribute("aria-level", "1"); // without the toolbar, whose heading it is else
  document.body.classList.toggle("drawing-alone", wanted.length === 0);
  if (wanted.length > 0) tabs.keep(wanted);
}

/**
 * @param {string} address of the page, without a fragment @param {import("../scene/store.js").State} state @param {string} tab that is open
 * @returns {Promise<string>} a line of HTML
 */
export async function embedLine(address, state, tab) {
  const link = await linkOfScene(state);
  const quoted = (text) => text.replace(/&/g, "&amp;").replace(/"/g, "&quot;");
  return '<iframe src="' + quoted(address + "#embed=" + tab + "&" + link.slice(1)) + '" ' + SIZE + ' title="' + quoted(state.name) + '" loading="lazy"></iframe>';
}
