// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

import { Core } from "./core.js";

/** A second core for what takes long, so that the answers to a drag never wait for a map; begun when first used. */
export class Background {
  #core = null;

  /** As Core's. */
  run(args, files, options) {
    this.#core ??= new Core();
    return this.#core.run(args, files, options);
  }
}
