// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** While a key is typed, those that can stand there are proposed, each with what `topple explain` says of it. */

import { autocompletion } from "@codemirror/autocomplete";
import { keyPlace } from "../scene/key_place.js";
import { keysOf } from "../scene/scene_keys.js";
import { tooltipOf } from "./key_help.js";

const BOOST_MAX = 99; // of CodeMirror: the order of the table

/**
 * @param {import("../scene/scene_keys.js").Keys} keys
 * @param {(path: string) => Promise<{title: string, rows: {label: string, text: string}[]}>} explain
 */
export function keyCompletion(keys, explain) {
  const propose = ({ state, pos, explicit }) => {
    const place = keyPlace(state.doc.toString(), pos);
    if (place === null || (place.from === pos && !explicit)) return null;
    const options = keysOf(keys, place.path).filter(({ key }) => !place.keys.has(key)).map(({ key, path, unit }, at) => ({
      label: key, detail: unit, type: "property", boost: BOOST_MAX - Math.min(at, BOOST_MAX), apply: applied(state, pos, key),
      info: async () => ({ dom: tooltipOf(await explain(path)) }),
    }));
    return options.length === 0 ? null : { from: place.from, options, validFor: /^\w*$/ };
  };
  return autocompletion({ override: [propose], icons: false });
}

/** A key that has no colon yet gets one. */
function applied(state, pos, key) {
  return /^\w*:/.test(state.sliceDoc(pos, pos + 100)) ? key : key + ": ";
}
