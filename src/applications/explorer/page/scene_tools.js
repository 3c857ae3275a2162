// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Open, save, undo, redo, and a link that carries the scene. */

import { linkOfExample, linkOfScene } from "../scene/link.js";
import { readFiles } from "../scene/open.js";
import { embedLine } from "./embed.js";
import { sendDialog } from "../send/send_dialog.js";
import { offer } from "./offer.js";
import { say } from "../words/language.js";

/** @param {(id: string) => HTMLElement} element @param {{store: import("../scene/store.js").SceneStore, menu: object, messages: object, tabs: object, photograph: {take: (file: File) => boolean}}} page */
export function sceneTools(element, { store, menu, messages, tabs, photograph }) {
  const openFiles = async (files) => {
    try {
      messages.clear();
      const others = [...files].filter((file) => !photograph.take(file));
      if (others.length > 0) await readFiles(others, store);
    } catch (error) {
      messages.say(error.message);
    }
  };
  element("open").addEventListener("click", () => element("file").click());
  element("file").addEventListener("change", async () => {
    await openFiles(element("file").files);
    element("file").value = "";
  });
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    if (event.dataTransfer.files.length > 0) openFiles(event.dataTransfer.files);
  });
  const save = () => offer(store.name, store.text, "application/yaml");
  element("save").addEventListener("click", save);
  element("link").addEventListener("click", () => copyLink(store, menu, messages));
  element("embed").addEventListener("click", () => copyEmbed(store, messages, tabs));
  sendDialog(element("send-dialog"), element("send"), { link: async () => location.href.split("#")[0] + (await hashOf(store, menu)) });
  undoTools(element, store);
  addEventListener("keydown", (event) => {
    if ((event.ctrlKey || event.metaKey) && event.key === "s") {
      event.preventDefault();
      save();
    }
  });
}

function undoTools(element, store) {
  element("undo").addEventListener("click", () => store.undo());
  element("redo").addEventListener("click", () => store.redo());
  store.addEventListener("history", () => {
    element("undo").disabled = !store.canUndo;
    element("redo").disabled = !store.canRedo;
  });
  addEventListener("keydown", (event) => {
    // a field of its own undoes its own typing; the editor has these keys itself
    if (!(event.ctrlKey || event.metaKey) || event.target.closest?.("input, textarea, .cm-editor")) return;
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) store.redo();
    else store.undo();
  });
}

async function copyEmbed(store, messages, tabs) {
  try {
    const line = await embedLine(location.href.split("#")[0], { name: store.name, text: store.text, files: store.files }, tabs.opened);
    try {
      await navigator.clipboard.writeText(line);
      messages.say(say("The line for another page is copied; that page shows the drawing, and the tab that is open here."));
    } catch {
      messages.say(line);
    }
  } catch (error) {
    messages.say(error.message);
  }
}

/** The fragment of an address that carries the scene. @returns {Promise<string>} */
function hashOf(store, menu) {
  return menu.present === null ? linkOfScene({ name: store.name, text: store.text, files: store.files }) : Promise.resolve(linkOfExample(menu.present));
}

async function copyLink(store, menu, messages) {
  try {
    const hash = await hashOf(store, menu);
    history.replaceState(history.state, "", hash);
    try {
      await navigator.clipboard.writeText(location.href);
      messages.say(say("The link is copied: it carries the whole scene."));
    } catch {
      messages.say(say("The link is in the address bar: it carries the whole scene."));
    }
  } catch (error) {
    messages.say(error.message);
  }
}
