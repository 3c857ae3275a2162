// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What the page carries packed: gzip, in base 64. */

/** @param {string} packed @returns {ReadableStream<Uint8Array>} its bytes */
export function unpacked(packed) {
  return new Blob([bytesOf(packed)]).stream().pipeThrough(new DecompressionStream("gzip"));
}

/** @param {string} letters in base 64 @returns {Uint8Array} */
export function bytesOf(letters) {
  if (typeof Uint8Array.fromBase64 === "function") return Uint8Array.fromBase64(letters);
  return Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
}
