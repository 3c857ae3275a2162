// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The core in node. Each line of the standard input is a request, {"folder", "args", "collect"}: the program is run with
 * the files of the folder around it. Each line of the output is its answer, with the bytes of memory held.
 */

import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, relative } from "node:path";
import { createInterface } from "node:readline";
import { Program } from "../../src/applications/explorer/core/program.js";

const build = new URL("../../build-explorer/", import.meta.url);
const createCore = createRequire(import.meta.url)(new URL("core_loader.js", build).pathname);
const part = (name) => readFileSync(new URL(name, build));
// as on the page, the rest comes later
const rest = async () => ({ module: await WebAssembly.compile(part("core_rest.wasm")), fonts: part("core_fonts.bin") });
const module = await WebAssembly.compile(part("core_first.wasm"));
const begun = () => Program.create(createCore, { module, rest: rest() }, environment);

const filesOf = (folder) => readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
  entry.isDirectory() ? filesOf(join(folder, entry.name)) : [join(folder, entry.name)]);
const known = new Map();
const carried = (folder) => {
  if (!known.has(folder)) {
    known.set(folder, Object.fromEntries(filesOf(folder).map((file) => [relative(folder, file), readFileSync(file)])));
  }
  return known.get(folder);
};

const { SOURCE_DATE_EPOCH } = process.env;
const environment = SOURCE_DATE_EPOCH === undefined ? {} : { SOURCE_DATE_EPOCH };
let program = await begun();
for await (const line of createInterface({ input: process.stdin })) {
  const { folder, args, collect } = JSON.parse(line);
  let answer;
  try {
    answer = await program.run(args, carried(folder), collect ?? []);
    answer.files = Object.fromEntries(Object.entries(answer.files).map(([name, bytes]) => [name, Buffer.from(bytes).toString("latin1")]));
  } catch (error) {
    answer = { status: -1, out: "", err: `broke down: ${error}`, files: {}, seconds: 0 };
    program = await begun();
  }
  process.stdout.write(JSON.stringify({ ...answer, memory: program.size }) + "\n");
}
