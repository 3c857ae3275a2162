// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Tables that the program prints as CSV: fields may stand in double quotes, a quote within is doubled (RFC 4180). */

/** @param {string} text @returns {string[][]} a list of fields for each line */
export function readCsv(text) {
  const rows = [];
  let row = [];
  let at = 0;
  while (at < text.length) {
    const quoted = text[at] === '"';
    const end = quoted ? closingQuote(text, at + 1) : fieldEnd(text, at);
    row.push(quoted ? text.slice(at + 1, end).replaceAll('""', '"') : text.slice(at, end));
    at = quoted ? end + 1 : end;
    if (text[at] === "\r") at++;
    if (text[at] === ",") {
      at++;
      if (at === text.length || text[at] === "\n") row.push("");
    }
    if (at >= text.length || text[at] === "\n") {
      rows.push(row);
      row = [];
      at++;
    }
  }
  return rows;
}

function fieldEnd(text, from) {
  let end = from;
  while (end < text.length && text[end] !== "," && text[end] !== "\n" && text[end] !== "\r") end++;
  return end;
}

function closingQuote(text, from) {
  let end = text.indexOf('"', from);
  while (end >= 0 && text[end + 1] === '"') end = text.indexOf('"', end + 2);
  return end < 0 ? text.length : end;
}

/** The same by the names of the first line. @param {string} text @returns {Record<string, string>[]} */
export function readTable(text) {
  const [heads, ...rows] = readCsv(text);
  if (heads === undefined) return [];
  return rows.map((row) => Object.fromEntries(heads.map((head, index) => [head, row[index] ?? ""])));
}
