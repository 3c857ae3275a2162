// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What the worker of a page does, in a thread of node. */

import { createRequire } from "node:module";
import { parentPort } from "node:worker_threads";
import { serve } from "../../src/applications/explorer/core/worker.js";

const loader = new URL("../../build-explorer/core_loader.js", import.meta.url).pathname;
serve({ post: (message) => parentPort.postMessage(message), listen: (heard) => parentPort.on("message", heard) }, createRequire(import.meta.url)(loader));
