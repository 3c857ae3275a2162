// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The scene is kept in the browser's own storage, so that a reload, a crash or another day finds it as it was left: by a
 * tab for itself, and the last one for new tabs. What cannot be kept there is asked about before the page is left.
 */

import { checked } from "./link.js";

const KEY = "topple.scene";
const LATE_MS = 150;

/** @returns {Storage[]} those that this browser gives to this page */
function storages() {
  return ["sessionStorage", "localStorage"].flatMap((name) => {
    try {
      return [window[name]];
    } catch {
      return []; // refused by the reader's settings
    }
  });
}

/** @returns {import("./store.js").State|null} the scene that was left here */
export function keptScene() {
  for (const storage of storages()) {
    try {
      const found = storage.getItem(KEY);
      if (found !== null) return checked(JSON.parse(found));
    } catch {
      // of another version, or cut off: as if there were none
    }
  }
  return null;
}

/** @param {import("./store.js").SceneStore} store */
export function keepScene(store) {
  let timer = null;
  let isKept = true;
  const keep = () => {
    clearTimeout(timer);
    timer = null;
    isKept = put(store);
  };
  store.addEventListener("text", () => {
    timer ??= setTimeout(keep, LATE_MS);
  });
  addEventListener("pagehide", () => timer !== null && keep());
  addEventListener("beforeunload", (event) => {
    if (timer !== null) keep();
    if (!isKept && store.canUndo) event.preventDefault();
  });
}

/** @returns {boolean} whether a reload would find all of it */
function put(store) {
  if (Object.values(store.files).some((content) => typeof content !== "string")) return false;
  const scene = JSON.stringify({ name: store.name, text: store.text, files: store.files });
  let kept = false;
  for (const storage of storages()) {
    try {
      storage.setItem(KEY, scene);
      kept = true;
    } catch {
      storage.removeItem(KEY); // too long for it: an older scene would come back instead
    }
  }
  return kept;
}
