// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Which functions of the core the page's first answers need: node profile.mjs INSTRUMENTED LOADER EXAMPLES PROFILE FONTS runs the
 * core that `wasm-split --instrument` made on each scene of a folder, as the page asks, and writes its profile; and the
 * bytes of the fonts as they lie in its memory, at the address that it prints.
 */

import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { Program } from "../core/program.js";

const PROFILE_MAX = 1 << 20; // bytes; what it overwrites at the end of memory is not used any more
const [instrumented, loader, folder, profile, fonts] = process.argv.slice(2);

let exported;
const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (module, imports) => {
  const instance = await instantiate(module, imports);
  exported = instance.exports;
  return instance;
};
const core = { module: await WebAssembly.compile(readFileSync(instrumented)), rest: null };
const program = await Program.create(createRequire(import.meta.url)(loader), core);
writeFileSync(fonts, program.fonts.slice());
console.log(program.fonts.byteOffset);
const files = Object.fromEntries(readdirSync(folder, { withFileTypes: true }).filter((entry) => entry.isFile())
  .map(({ name }) => [name, readFileSync(join(folder, name))]));
for (const name of Object.keys(files).filter((each) => each.endsWith(".yaml")).sort()) {
  await program.run(["solve", "--json", "--outlines", name], files);
}
const { buffer } = Object.values(exported).find((each) => each instanceof WebAssembly.Memory);
const at = buffer.byteLength - PROFILE_MAX;
writeFileSync(profile, new Uint8Array(buffer, at, exported.__write_profile(at, PROFILE_MAX)));
