// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The queue of requests to the core, with threads of node instead of a page's workers. Prints a line for each story. */

import { readFileSync } from "node:fs";
import { Worker } from "node:worker_threads";
import { CoreStopped, Requests } from "../../src/applications/explorer/core/requests.js";

const part = (name) => readFileSync(new URL("../../build-explorer/" + name, import.meta.url));
const module = await WebAssembly.compile(part("core_first.wasm"));
const rest = { module: await WebAssembly.compile(part("core_rest.wasm")), fonts: part("core_fonts.bin") };
const slab = readFileSync(new URL("../../examples/slab_left.yaml", import.meta.url), "utf8");
const solve = ["solve", "--json", "slab.yaml"];
let started = 0;

function start(heard) {
  started++;
  const worker = new Worker(new URL("./core_thread.mjs", import.meta.url));
  worker.on("message", (message) => (message.kind === "lacks" ? worker.postMessage({ kind: "rest", rest }) : heard(message)));
  worker.postMessage({ kind: "begin", module });
  return { post: (message) => worker.postMessage(message), end: () => worker.terminate() };
}

const caught = (promise) => promise.then(() => null, (error) => error);
const stories = {
  async "each request has its answer, in order"(core) {
    const [one, other] = await Promise.all([core.run(solve, { "slab.yaml": slab }), core.run(["--version"], {})]);
    return one.status === 0 && JSON.parse(one.out).cases.length > 0 && other.out.startsWith("topple ");
  },
  async "a later request replaces a waiting one of its name, and no other"(core) {
    const first = core.run(solve, { "slab.yaml": slab }, { latest: "solve" });
    const second = caught(core.run(solve, { "slab.yaml": slab }, { latest: "solve" }));
    const other = core.run(["--version"], {}, { latest: "version" });
    const third = core.run(solve, { "slab.yaml": "topple: 1\n" }, { latest: "solve" });
    return (await first).status === 0 && (await second).name === "AbortError" && (await other).status === 0 && (await third).status === 3;
  },
  async "what takes too long is stopped, says so, and the next request is answered"(core) {
    const before = started;
    const stopped = caught(core.run(["accuracy", "--sweep=10:1000000"], {}, { timeoutMs: 300 }));
    const next = core.run(solve, { "slab.yaml": slab });
    const error = await stopped;
    return error instanceof CoreStopped && error.message.includes("0.3 s") && (await next).status === 0 && started === before + 1;
  },
  async "a request that is given up ends at once, running or waiting"(core) {
    const running = new AbortController(), waiting = new AbortController();
    const one = caught(core.run(["accuracy", "--sweep=10:1000000"], {}, { signal: running.signal }));
    const two = caught(core.run(solve, { "slab.yaml": slab }, { signal: waiting.signal }));
    setTimeout(() => waiting.abort(), 50);
    setTimeout(() => running.abort(), 100);
    return (await one).name === "AbortError" && (await two).name === "AbortError" && (await core.run(["--version"], {})).status === 0;
  },
  async "a file may lie in a folder beside, and none outside of where scenes are; nothing of it stays"(core) {
    const scene = slab.replace(/block:[^]*?\n(?=\w)/, "block: {outline: ../beside/points.csv, unit_weight_kn_m3: 26}\n");
    const points = "0, 0\n1, 0\n1, 2\n0, 2\n";
    const one = await core.run(solve, { "slab.yaml": scene, "../beside/points.csv": points });
    const other = await core.run(solve, { "slab.yaml": scene });
    const third = await caught(core.run(solve, { "slab.yaml": scene, "../../points.csv": points }));
    return one.status === 0 && other.status !== 0 && third.message.includes("lies outside");
  },
  async "files that a run writes are handed back"(core) {
    const args = ["sweep", "slab.yaml", "--x", "block.slab.width=10:20:3", "-o", "curve.csv"];
    const answer = await core.run(args, { "slab.yaml": slab }, { collect: ["curve.csv", "none.csv"] });
    return answer.status === 0 && new TextDecoder().decode(answer.files["curve.csv"]).split("\n").length > 3 && !("none.csv" in answer.files);
  },
};

let failed = 0;
const core = new Requests(start);
for (const [story, told] of Object.entries(stories)) {
  const right = await told(core).catch((error) => console.log(error) ?? false);
  failed += right ? 0 : 1;
  console.log(`${right ? "ok" : "FAILED"}: ${story}`);
}
core.close();
console.log(`${Object.keys(stories).length - failed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
