// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

const LABELS = /^(Symbol|Formula|Unit|Range|Default|Source|Also|Keys|Page|More)\s{2,}(.*)$/;

/**
 * What `topple explain` printed of one meaning, as a title and paragraphs, the lines of each joined.
 * @param {string} printed
 * @param {string} [heading] how its title begins; the first meaning, unless one begins so
 */
export function readExplanation(printed, heading = "") {
  const meanings = printed.split("\n\n");
  const [title, ...lines] = (meanings.find((meaning) => meaning.startsWith(heading)) ?? meanings[0]).trim().split("\n");
  const rows = [];
  for (const line of lines.map((each) => each.trim())) {
    const found = LABELS.exec(line);
    if (found !== null) rows.push({ label: found[1], text: found[2] });
    else if (rows.length === 0) rows.push({ label: "", text: line });
    else rows[rows.length - 1].text += " " + line;
  }
  return { title, rows };
}
