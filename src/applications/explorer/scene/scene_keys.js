// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The table of the keys of scenes: which a map can have, and which of them are lengths. */

/** @typedef {[string, string][]} Keys path, as loads.anchors[].at, and unit */

const LENGTHS = "scene lengths";

/** Cases of a scene change keys of it: theirs are those of the same name. */
const plain = (path) => path.replace(/^cases\[\]\./, "");

/**
 * The keys that a map can have, in the order of the table.
 * @param {Keys} keys @param {string} path of the map; "" of the scene @returns {{key: string, path: string, unit: string}[]}
 */
export function keysOf(keys, path) {
  const own = (head) => keys.filter(([each]) => each.startsWith(head) && /^\w+$/.test(each.slice(head.length)))
    .map(([each, unit]) => ({ key: each.slice(head.length), path: each, unit }));
  const found = own(path === "" ? "" : path + ".");
  return found.length > 0 ? found : own(plain(path) + ".");
}

/** @param {Keys} keys @returns {(path: string) => boolean} whether what stands at a path, or in the lists there, are lengths of the scene */
export function lengthsOf(keys) {
  const lengths = new Set(keys.filter(([, unit]) => unit === LENGTHS).map(([path]) => path));
  return (path) => {
    const point = path.replace(/(\[\])+$/, "");
    return lengths.has(point) || lengths.has(plain(point));
  };
}
