// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What stands beside the drawing, in tabs: the verdict with its factors, the scene as text, and all else. */

import { AboutPanel } from "./about.js";
import { AccuracyPanel } from "./accuracy.js";
import { ComparePanel } from "./compare.js";
import { CurvesPanel } from "./curves.js";
import { DerivePanel } from "./derive.js";
import { element } from "./element.js";
import { FactorsPanel } from "./factors.js";
import { ForcesPanel } from "./forces.js";
import { MapPanel } from "./map.js";
import { PivotsPanel } from "./pivots.js";
import { ReportPanel } from "./report.js";
import { Tabs } from "./tabs.js";
import { Terms } from "./terms.js";
import { Tour } from "../tour/tour.js";
import { VerdictPanel } from "./verdict.js";
import { VerifyPanel } from "./verify.js";
import { TextPanel } from "../page/text_panel.js";
import { say } from "../words/language.js";

const RESULTS = [
  { id: "verdict", title: "Verdict", Panel: VerdictPanel },
  { id: "factors", title: "Factors of safety", Panel: FactorsPanel },
];

/** Verdict and factors under each other; they follow the scene whatever is shown. */
class ResultsPanel {
  constructor(place, context) {
    for (const { id, title, Panel } of RESULTS) {
      const body = element("div", {});
      const section = element("div", { id: "panel-" + id }, element("h2", {}, say(title)), body);
      place.append(section);
      const panel = new Panel(body, context);
      panel.show();
      context.store.addEventListener("solution", () => (section.hidden = !panel.takes.includes(context.store.solution.kind)));
    }
  }

  show() {}

  hide() {}
}

const IN_TABS = [
  { id: "results", title: "Verdict", Panel: ResultsPanel },
  { id: "text", title: "Text", Panel: TextPanel },
  { id: "pivots", title: "Pivots", Panel: PivotsPanel },
  { id: "forces", title: "Forces", Panel: ForcesPanel },
  { id: "curves", title: "Curves", Panel: CurvesPanel },
  { id: "map", title: "Map", Panel: MapPanel },
  { id: "compare", title: "Compare", Panel: ComparePanel },
  { id: "derive", title: "Formulas", Panel: DerivePanel },
  { id: "verify", title: "Verify", Panel: VerifyPanel },
  { id: "accuracy", title: "Accuracy", Panel: AccuracyPanel },
  { id: "report", title: "Report", Panel: ReportPanel },
  { id: "about", title: "About", Panel: AboutPanel },
];

/**
 * @param {HTMLElement} place
 * @param {HTMLElement} tourBegin where the button of the tour stands
 * @param {{store: object, core: object, background: object, menu: {open: (name: string) => void}}} page
 * @returns {{tabs: Tabs, text: TextPanel}}
 */
export function addPanels(place, tourBegin, { store, core, background, menu }) {
  const context = { store, core, background, terms: new Terms(core) };
  const tourPlace = element("section", { class: "panel tour", "aria-label": "Guided tour" });
  place.append(tourPlace);
  const sheets = element("div", { class: "panel" });
  place.append(sheets);
  const tabs = new Tabs(sheets, IN_TABS.map(({ id, title, Panel }) => ({ id, title: say(title), make: (sheet) => new Panel(sheet, context) })));
  const text = tabs.panel("text");
  tabs.open("results");
  new Tour(tourPlace, tourBegin, { store, core, menu, tabs });
  return { tabs, text };
}
