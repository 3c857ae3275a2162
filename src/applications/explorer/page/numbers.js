// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Tilt and friction as numbers with sliders: what every scene can have, whatever its shape. */

import { parameterValues, quantity } from "../scene/quantity.js";
import { snap } from "../scene/decimal.js";
import { typedNumber } from "./typed_number.js";
import { numeral, say } from "../words/language.js";

/** @param {import("../scene/scene_text.js").SceneText} scene @returns {string|null} why there is no one friction angle */
function lawOfFriction(scene) {
  return scene.keys(["friction"])?.includes("law") ? say("is set by the friction law; edit its numbers in the text") : null;
}

const NUMBERS = [
  { path: ["tilt", "angle_deg"], or: ["slope", "dip_deg"], label: "Tilt, °", max: 60, greatest: 90 },
  { path: ["friction_angle_deg"], label: "Friction angle, °", max: 60, greatest: 89.9, other: lawOfFriction },
];

/** @param {HTMLFormElement} form @param {import("../scene/store.js").SceneStore} store */
export function numbersForm(form, store) {
  form.addEventListener("submit", (event) => event.preventDefault());
  const rows = NUMBERS.map((number) => numberRow(form, store, number));
  store.addEventListener("text", () => rows.forEach((update) => update()));
}

/** @returns {() => void} brings it up to the scene */
function numberRow(form, store, { path: own, or = own, label, max, greatest, other = () => null }) {
  const row = document.createElement("label");
  const slider = input("range", { min: 0, max, step: 0.1 });
  const field = input("text", { inputmode: "decimal", autocomplete: "off", size: 6, "aria-label": say(label) });
  const why = document.createElement("span");
  why.className = "why";
  why.setAttribute("role", "alert");
  row.append(say(label) + " ", slider, field, why);
  form.append(row);
  let typing = false;
  const present = () => {
    const path = store.parsed.scalar(or) === null ? own : or;
    const found = quantity(store.parsed, path, parameterValues(store.parsed));
    return { ...found, fixed: found.fixed ?? other(store.parsed) };
  };
  const complain = (words) => {
    why.textContent = words;
    field.setAttribute("aria-invalid", String(words !== ""));
  };
  const put = (text) => {
    const now = present();
    if (now.fixed === null) store.setNumber(now.path, text, { mergeWith: "slide " + own.join(".") });
  };
  const update = () => {
    if (store.parsed.unread !== null) return;
    // a wedge lies as its joints do, each of which has a friction of its own
    row.hidden = store.parsed.keys(["solid"])?.includes("wedge") ?? false;
    const now = present();
    slider.disabled = field.disabled = now.fixed !== null;
    row.title = now.fixed === null ? "" : say(label) + " " + now.fixed;
    slider.value = String(now.value ?? 0);
    slider.setAttribute("aria-valuetext", now.value === null ? say("none") : numeral(String(now.value)));
    field.placeholder = now.value === null ? say("none") : "";
    if (typing) return;
    field.value = now.value === null ? "" : numeral(String(now.value));
    complain("");
  };
  slider.addEventListener("input", () => put(snap(slider.valueAsNumber, -1)));
  slider.addEventListener("change", () => store.endGesture());
  field.addEventListener("input", () => {
    const { text, wrong } = typedNumber(field.value, greatest);
    complain(wrong);
    typing = true;
    if (text !== null) put(text);
    typing = false;
  });
  // what was not taken does not stand there as if it were the scene's
  field.addEventListener("change", () => {
    store.endGesture();
    update();
  });
  return update;
}

function input(type, attributes) {
  const made = document.createElement("input");
  made.type = type;
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  return made;
}
