// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What the worker of the page runs; bundled by itself, as a text within the page. */

import createCore from "topple:loader";
import { serve } from "./worker.js";

serve(
  {
    post: (message) => postMessage(message),
    listen: (heard) => addEventListener("message", (event) => heard(event.data)),
  },
  createCore,
);
