// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What stands beside the drawing: a panel for each kind of result, in this order. */

/** @type {{title: string, Panel: new (element: HTMLElement, page: object) => object}[]} */
const PANELS = [];

/** @param {HTMLElement} element @param {{store: object, core: object, drawing: object, editor: object, messages: object, menu: object}} page */
export function addPanels(element, page) {
  for (const { title, Panel } of PANELS) {
    const section = document.createElement("section");
    const heading = document.createElement("h2");
    const body = document.createElement("div");
    section.className = "panel";
    heading.textContent = title;
    section.append(heading, body);
    element.append(section);
    new Panel(body, page);
  }
}
