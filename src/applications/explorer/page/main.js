// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The page, put together: the core, the scene, and what shows it. */

import { Core } from "../core/core.js";
import { Background } from "../core/background.js";
import { SceneStore } from "../scene/store.js";
import { Drawing } from "../drawing/drawing.js";
import { ExamplesMenu } from "../examples/menu.js";
import { keepScene, keptScene } from "../scene/kept.js";
import { carriesScene, exampleOfLink, sceneOfLink } from "../scene/link.js";
import { addMenu } from "./add_menu.js";
import { badge } from "./badge.js";
import { drawingTools } from "./drawing_tools.js";
import { readEmbed, showEmbedded } from "./embed.js";
import { firstGesture } from "./first_gesture.js";
import { loadCaseChoice } from "./load_case_choice.js";
import { Messages } from "./messages.js";
import { numbersForm } from "./numbers.js";
import { sceneTools } from "./scene_tools.js";
import { Photograph } from "../photograph/photograph.js";
import { SolidView } from "../solid/solid_view.js";
import { gallery } from "../send/gallery.js";
import { Player } from "./player.js";
import { sheet } from "./sheet.js";
import { sceneWords } from "./scene_words.js";
import { themeSwitch } from "./theme.js";
import { unitsMenu } from "./units_menu.js";
import keys from "topple:keys";
import { lengthsOf } from "../scene/scene_keys.js";
import { addPanels } from "../panels/panels.js";
import { languageMenu, say, translate } from "../words/language.js";

const FIRST = "block_e_valley.yaml";
const element = (id) => document.getElementById(id);

async function begin() {
  document.title = say(document.title);
  translate(document.body);
  languageMenu(element("language"));
  themeSwitch(element("theme"));
  const core = new Core();
  const store = new SceneStore(core);
  const drawing = new Drawing(element("drawing"), store);
  const menu = new ExamplesMenu(element("examples"), store);
  const background = new Background();
  const { tabs, text } = addPanels(element("panels"), element("tour-begin"), { store, core, background, menu });
  const show = (line, column) => {
    tabs.open("text");
    text.editor.show(line, column);
  };
  const messages = new Messages(element("message"), { store, show });
  text.messages = messages;
  new SolidView(element("solid-stage"), element("solid-words"), store);
  drawingTools(element, drawing, store);
  badge(element, drawing, store);
  loadCaseChoice(element("load-case"), element("load-cases"), store);
  addMenu(element("add"), drawing, store, messages);
  unitsMenu(element("units"), store, messages, lengthsOf(keys));
  sheet(element("grip"));
  new Player(element("play"), element("film"), { drawing, store, core: background, searcher: new Background(), messages });
  numbersForm(element("numbers"), store);
  sceneWords(element, store);
  const photograph = new Photograph({ stage: element("photo-stage"), place: element("photo"), button: element("trace"), drawing, store, messages });
  sceneTools(element, { store, menu, messages, tabs, photograph });
  gallery(element("gallery-dialog"), element("gallery"), { menu, core: background });
  const embedded = readEmbed(location.hash);
  if (embedded !== null) showEmbedded(embedded, tabs);
  const told = (words) => (element("told").textContent = words);
  if (await openFirst(store, menu, messages, embedded)) store.addEventListener("solution", () => firstGesture(drawing, store, told), { once: true });
  // a page within another one neither takes nor leaves the reader's own scene
  if (embedded === null) keepScene(store);
  store.addEventListener("text", () => forgetLink());
  addEventListener("hashchange", () => openLink(store, menu, messages));
}

/**
 * A link says which scene is meant; else it is the one that was left here, or the first example.
 * @returns {Promise<boolean>} whether it is the example
 */
async function openFirst(store, menu, messages, embedded) {
  if (await openLink(store, menu, messages, embedded?.link)) return false;
  const kept = embedded === null ? keptScene() : null;
  if (kept === null) menu.open(FIRST);
  else store.open(kept);
  return kept === null && embedded === null;
}

/** The scene is no more the one that the address carries: a reload would bring that one back. */
function forgetLink() {
  if (carriesScene(location.hash)) history.replaceState(history.state, "", location.pathname + location.search);
}

/** @returns {Promise<boolean>} whether the page's address carried a scene */
async function openLink(store, menu, messages, link = location.hash) {
  try {
    const example = exampleOfLink(link);
    if (example !== null && menu.open(example)) return true;
    const state = await sceneOfLink(link);
    if (state === null) return false;
    store.open(state);
    return true;
  } catch (error) {
    messages.say(say("The link carries no scene that can be read: %s", error.message));
    return false;
  }
}

begin();
