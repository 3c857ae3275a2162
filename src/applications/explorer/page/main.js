// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The page, put together: the core, the scene, and what shows it. */

import { Core } from "../core/core.js";
import { SceneStore } from "../scene/store.js";
import { Drawing } from "../drawing/drawing.js";
import { Editor } from "../editor/editor.js";
import { ExamplesMenu } from "../examples/menu.js";
import { sceneOfLink } from "../scene/link.js";
import { drawingTools } from "./drawing_tools.js";
import { Messages } from "./messages.js";
import { numbersForm } from "./numbers.js";
import { sceneTools } from "./scene_tools.js";
import { sceneWords } from "./scene_words.js";
import { themeSwitch } from "./theme.js";
import { addPanels } from "../panels/panels.js";

const FIRST = "block_e_valley.yaml";
const element = (id) => document.getElementById(id);

async function begin() {
  themeSwitch(element("theme"));
  const core = new Core();
  const store = new SceneStore(core);
  const editor = new Editor(element("editor"), store);
  const messages = new Messages(element("message"), { store, editor });
  const drawing = new Drawing(element("drawing"), store);
  drawingTools(element, drawing, store);
  numbersForm(element("numbers"), store);
  sceneWords(element, store, messages);
  sceneTools(element, store, messages);
  const menu = new ExamplesMenu(element("examples"), store);
  addPanels(element("panels"), { store, core, drawing, editor, messages, menu });
  await openFirst(store, menu, messages);
  addEventListener("hashchange", () => openLink(store, messages));
}

async function openFirst(store, menu, messages) {
  if (!(await openLink(store, messages))) menu.open(FIRST);
}

/** @returns {Promise<boolean>} whether the page's address carried a scene */
async function openLink(store, messages) {
  try {
    const state = await sceneOfLink(location.hash);
    if (state === null) return false;
    store.open(state);
    return true;
  } catch (error) {
    messages.say("The link carries no scene that can be read: " + error.message);
    return false;
  }
}

begin();
