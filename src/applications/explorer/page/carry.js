// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Runs in the page's head, before all else. The core stands at the page's end in pieces. What the first answer needs of it
 * (wasm/split.py) comes first: each of its pieces is unpacked and compiled in other threads while the browser still reads
 * the next, and the page already draws itself. The rest is taken up when it is asked for.
 */

import { bytesOf } from "../core/packed.js";

const WASM = { headers: { "Content-Type": "application/wasm" } };
const unpackedOf = (stream) => stream.pipeThrough(new DecompressionStream("gzip"));

/** @type {ReadableStreamDefaultController<Uint8Array>} */
let pieces;
const packed = new ReadableStream({ start: (controller) => (pieces = controller) });
const module = WebAssembly.compileStreaming(new Response(unpackedOf(packed), WASM));
module.catch(() => {}); // who takes it up says so

/** @param {HTMLElement} element @returns {Uint8Array} */
function taken(element) {
  element.remove();
  return bytesOf(element.textContent);
}

/** Called by the page behind each piece of the first part, in an element where nothing else is put. @param {boolean} isLast */
globalThis.toppleCarry = (isLast) => {
  pieces.enqueue(taken(document.currentScript.previousElementSibling));
  if (isLast) pieces.close();
};

/** A part that has been read whole. @param {string} name @returns {Response} */
function part(name) {
  const found = [...document.querySelectorAll('script[data-part="' + name + '"]')].map(taken);
  return new Response(unpackedOf(new Blob(found).stream()), WASM);
}

async function readRest() {
  if (document.readyState === "loading") await new Promise((read) => document.addEventListener("DOMContentLoaded", read, { once: true }));
  const [found, fonts] = await Promise.all([WebAssembly.compileStreaming(part("rest")), part("fonts").arrayBuffer()]);
  return { module: found, fonts: new Uint8Array(fonts) };
}

let rest = null;

/** Taken up by core/core.js. @type {{module: Promise<WebAssembly.Module>, rest: () => Promise<import("../core/program.js").Rest>}} */
globalThis.toppleCore = { module, rest: () => (rest ??= readRest()) };
