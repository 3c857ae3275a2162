// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A scene in the fragment of the page's address, which no server ever sees: JSON of its name, text and files, deflated
 * where the browser can, in base64url. What comes in is bounded before it is unpacked whole.
 */

import { say } from "../words/language.js";

const LINK_MAX = 2_000_000; // characters of a fragment
const SCENE_MAX = 8_000_000; // bytes unpacked: a fragment of zeros could unpack to a thousand times its size
const NAME_MAX = 250; // characters of a file's name, ...
const FOLDERS_MAX = 3; // ... with the folders it lies in
const EXAMPLE = "#example=";
const PACKED = "#z=";
const PLAIN = "#t=";

/** @param {import("./store.js").State} state @returns {Promise<string>} */
export async function linkOfScene({ name, text, files }) {
  if (Object.values(files).some((content) => typeof content !== "string")) {
    throw new Error(say("A file beside the scene is not a text: it goes into no link. Save the scene and send both files."));
  }
  const bytes = new TextEncoder().encode(JSON.stringify({ name, text, files }));
  const packs = typeof CompressionStream === "function";
  const body = packs ? await through(bytes, new CompressionStream("deflate-raw"), SCENE_MAX) : bytes;
  const hash = (packs ? PACKED : PLAIN) + toBase64(body);
  if (hash.length > LINK_MAX) throw new Error(say("The scene is too long for a link. Save it and send the file."));
  return hash;
}

/** @param {string} hash of an address */
export function carriesScene(hash) {
  return [PACKED, PLAIN, EXAMPLE].some((head) => hash.startsWith(head));
}

/** The short link of a scene that every copy of the page has. @param {string} name */
export function linkOfExample(name) {
  return EXAMPLE + name;
}

/** @param {string} hash of an address @returns {string|null} the name of the example that it leads to */
export function exampleOfLink(hash) {
  return hash.startsWith(EXAMPLE) ? hash.slice(EXAMPLE.length) : null;
}

/** @param {string} hash of an address @returns {Promise<import("./store.js").State|null>} null: it carries none */
export async function sceneOfLink(hash) {
  if (!hash.startsWith(PACKED) && !hash.startsWith(PLAIN)) return null;
  const packed = hash.startsWith(PACKED);
  if (hash.length > LINK_MAX) throw new Error(say("it is longer than a link of this page can be"));
  const body = fromBase64(hash.slice(PACKED.length));
  const bytes = packed ? await through(body, new DecompressionStream("deflate-raw"), SCENE_MAX) : body;
  return checked(JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes)));
}

/** Below the folder where the program runs: letters of any script, blanks, brackets; no way up, no control characters. */
function named(name) {
  if (typeof name !== "string" || name.length > NAME_MAX || /[\p{C}\\]/u.test(name)) return false;
  const pieces = name.split("/");
  return pieces.length <= FOLDERS_MAX + 1 && pieces.every((piece) => piece.trim() !== "" && piece !== "." && piece !== "..");
}

/** Only what a scene is made of, with names that are names of files. @returns {import("./store.js").State} */
export function checked(state) {
  if (!named(state?.name) || typeof state.text !== "string") throw new Error(say("it has no scene in it"));
  const files = Object.entries(state.files ?? {});
  // a file may lie in a folder beside that of the scene
  if (files.some(([name, content]) => !named(name.replace(/^\.\.\//, "")) || typeof content !== "string")) throw new Error(say("its files have no plain names"));
  return { name: state.name, text: state.text, files: Object.fromEntries(files) };
}

/** @param {Uint8Array} bytes @param {number} most bytes that may come out @returns {Promise<Uint8Array>} */
async function through(bytes, transform, most) {
  const reader = new Blob([bytes]).stream().pipeThrough(transform).getReader();
  const pieces = [];
  let size = 0;
  for (let { done, value } = await reader.read(); !done; { done, value } = await reader.read()) {
    size += value.length;
    if (size > most) {
      await reader.cancel();
      throw new Error(say("it holds more than %s MB", most / 1e6));
    }
    pieces.push(value);
  }
  return new Uint8Array(await new Blob(pieces).arrayBuffer());
}

function toBase64(bytes) {
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

function fromBase64(text) {
  const plain = atob(text.replace(/-/g, "+").replace(/_/g, "/"));
  return Uint8Array.from(plain, (character) => character.charCodeAt(0));
}
