// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The scene is kept in the browser's own storage, so that a reload, a crash or another day finds it as it was left: by a
 * tab for itself, and the last one for new tabs. What cannot be kept there is asked about before the page is left.
 *
 * A tab knows its own scene by a name in the state of its history, where the scene itself is too if it is short. The storage
 * of a session would be simpler; but Chromium, as it goes over to another process with a reload, now and then gives the page
 * that of before, or none, and under load no storage of either kind.
 */

import { checked } from "./link.js";

const TABS = "topple.scene"; // names of the tabs whose scenes are kept, with blanks between, the last that was changed first
const OWN = TABS + ".";
const LATE_MS = 150;
const LATEST_MS = 1500; // a drag that goes on is kept that often
const TABS_MAX = 6;
const SHORT = 100_000; // letters of a scene that goes into the history's state
const LONG = 5_000_000; // letters that no browser's storage has room for: to try it would hold up the page by half a second

/** @returns {Storage|null} */
function storage() {
  try {
    return window.localStorage;
  } catch {
    return null; // refused by the reader's settings
  }
}

/** @param {Storage} from @returns {string[]} */
const tabsOf = (from) => (from.getItem(TABS) ?? "").split(" ").filter((tab) => tab !== "");

/** @returns {import("./store.js").State|null} the scene that was left here */
export function keptScene() {
  const from = storage();
  const stored = (tab) => from?.getItem(OWN + tab) ?? null;
  for (const find of [() => history.state?.scene ?? null, () => stored(history.state?.tab), () => stored(tabsOf(from)[0])]) {
    try {
      const found = find();
      if (found !== null) return checked(JSON.parse(found));
    } catch {
      // of another version, or cut off: as if there were none
    }
  }
  return null;
}

/** @param {import("./store.js").SceneStore} store */
export function keepScene(store) {
  const tab = history.state?.tab ?? crypto.getRandomValues(new Uint32Array(2)).join("-");
  noteTab(tab, history.state?.scene);
  addEventListener("hashchange", () => keep()); // a link followed within the page
  let timer = null;
  let since = 0; // when the first change came that is not kept yet
  let isKept = true;
  const keep = () => {
    clearTimeout(timer);
    timer = null;
    const scene = written(store);
    noteTab(tab, scene !== null && scene.length <= SHORT ? scene : undefined);
    isKept = scene !== null && put(scene, tab);
    if (scene === null) storage()?.removeItem(OWN + tab); // or an older one would come back instead
  };
  const flush = () => timer !== null && keep();
  store.addEventListener("text", () => {
    if (timer === null) since = performance.now();
    clearTimeout(timer);
    timer = setTimeout(keep, Math.min(LATE_MS, Math.max(0, since + LATEST_MS - performance.now())));
  });
  addEventListener("pagehide", flush);
  // a browser of a phone ends hidden pages without a word
  document.addEventListener("visibilitychange", () => document.hidden && flush());
  addEventListener("beforeunload", (event) => {
    flush();
    if (!isKept && store.canUndo) event.preventDefault();
  });
}

/** @param {import("./store.js").SceneStore} store @returns {string|null} null: files of it are no text, or it is too long */
function written({ name, text, files }) {
  const contents = [text, ...Object.values(files)];
  if (contents.some((content) => typeof content !== "string") || contents.reduce((sum, { length }) => sum + length, 0) > LONG) return null;
  return JSON.stringify({ name, text, files });
}

/** @param {string} tab @param {string|undefined} scene */
function noteTab(tab, scene) {
  if (history.state?.tab !== tab || history.state.scene !== scene) history.replaceState({ ...history.state, tab, scene }, "");
}

/** @param {string} scene @param {string} tab @returns {boolean} whether a reload would find all of it */
function put(scene, tab) {
  const into = storage();
  if (into === null) return false;
  const tabs = [tab, ...tabsOf(into).filter((other) => other !== tab)];
  const forget = (old) => into.removeItem(OWN + old);
  tabs.splice(TABS_MAX).forEach(forget);
  for (;;) {
    try {
      into.setItem(TABS, tabs.join(" "));
      into.setItem(OWN + tab, scene);
      return true;
    } catch {
      forget(tabs.pop()); // no room for it: the oldest goes, and at last its own, or an older scene would come back instead
      if (tabs.length === 0) return false;
    }
  }
}
