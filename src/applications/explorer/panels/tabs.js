// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Panels as tabs, by the keyboard as the ARIA practices have it: arrow keys go from tab to tab, Home and End to the ends. */

import { element } from "./element.js";

const HOPS = { ArrowRight: (at, count) => (at + 1) % count, ArrowLeft: (at, count) => (at + count - 1) % count, Home: () => 0, End: (_, count) => count - 1 };

export class Tabs {
  /**
   * @param {HTMLElement} place
   * @param {{id: string, title: string, make: (place: HTMLElement) => import("./panel.js").Panel}[]} panels made when first shown
   */
  constructor(place, panels) {
    this.entries = panels.map(({ id, title, make }) => {
      const sheet = element("section", { role: "tabpanel", id: "panel-" + id, "aria-labelledby": "tab-" + id, hidden: true, tabindex: -1 });
      const tab = element("button", {
        type: "button", role: "tab", id: "tab-" + id, "aria-controls": "panel-" + id, "aria-selected": "false", tabindex: -1,
        onclick: () => this.open(id), onkeydown: (event) => this.#hop(event),
      }, title);
      return { id, sheet, tab, make, panel: null };
    });
    place.append(
      element("div", { role: "tablist", "aria-label": "Results", class: "tabs" }, this.entries.map(({ tab }) => tab)),
      ...this.entries.map(({ sheet }) => sheet),
    );
    this.open(panels[0].id);
  }

  /** @param {string} id */
  open(id) {
    for (const entry of this.entries) {
      const chosen = entry.id === id;
      entry.tab.setAttribute("aria-selected", String(chosen));
      entry.tab.tabIndex = chosen ? 0 : -1;
      if (entry.sheet.hidden === !chosen && entry.panel !== null) continue;
      entry.sheet.hidden = !chosen;
      if (!chosen) entry.panel?.hide();
      else {
        entry.panel ??= entry.make(entry.sheet);
        entry.panel.show();
      }
    }
  }

  /** The tab that is open. */
  get opened() {
    return this.entries.find(({ sheet }) => !sheet.hidden).id;
  }

  /** These tabs and no others, the first of them open. @param {string[]} ids those that are none are passed over */
  keep(ids) {
    const kept = this.entries.filter(({ id }) => ids.includes(id));
    if (kept.length === 0) return;
    for (const { id, tab } of this.entries) tab.hidden = !ids.includes(id);
    this.open(kept[0].id);
  }

  /** @param {string} id @returns {import("./panel.js").Panel} shown */
  panel(id) {
    this.open(id);
    return this.entries.find((entry) => entry.id === id).panel;
  }

  #hop(event) {
    const hop = HOPS[event.key];
    if (hop === undefined) return;
    event.preventDefault();
    const seen = this.entries.filter(({ tab }) => !tab.hidden);
    const next = seen[hop(seen.findIndex(({ tab }) => tab === event.currentTarget), seen.length)];
    this.open(next.id);
    next.tab.focus();
  }
}
