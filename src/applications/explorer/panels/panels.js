// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What stands beside the drawing: the verdict and its factors always, all else in tabs. */

import { Core } from "../core/core.js";
import { AboutPanel } from "./about.js";
import { AccuracyPanel } from "./accuracy.js";
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

const ALWAYS = [
  { id: "verdict", title: "Verdict", Panel: VerdictPanel },
  { id: "factors", title: "Factors of safety", Panel: FactorsPanel },
];

const IN_TABS = [
  { id: "pivots", title: "Pivots", Panel: PivotsPanel },
  { id: "forces", title: "Forces", Panel: ForcesPanel },
  { id: "curves", title: "Curves", Panel: CurvesPanel },
  { id: "map", title: "Map", Panel: MapPanel },
  { id: "derive", title: "Formulas", Panel: DerivePanel },
  { id: "verify", title: "Verify", Panel: VerifyPanel },
  { id: "accuracy", title: "Accuracy", Panel: AccuracyPanel },
  { id: "report", title: "Report", Panel: ReportPanel },
  { id: "about", title: "About", Panel: AboutPanel },
];

/** A second core for what takes long, so that the answers to a drag never wait for a map; begun when first used. */
class Background {
  #core = null;

  run(args, files, options) {
    this.#core ??= new Core();
    return this.#core.run(args, files, options);
  }
}

/**
 * @param {HTMLElement} place
 * @param {{store: object, core: object, menu: {open: (name: string) => void}}} page
 */
export function addPanels(place, { store, core, menu }) {
  const context = { store, core, background: new Background(), terms: new Terms(core) };
  const tourPlace = element("section", { class: "panel tour", "aria-label": "Guided tour" });
  place.append(tourPlace);
  for (const { id, title, Panel } of ALWAYS) {
    const body = element("div", {});
    place.append(element("section", { class: "panel", id: "panel-" + id }, element("h2", {}, title), body));
    new Panel(body, context).show();
  }
  const sheets = element("div", { class: "panel" });
  place.append(sheets);
  const tabs = new Tabs(sheets, IN_TABS.map(({ id, title, Panel }) => ({ id, title, make: (sheet) => new Panel(sheet, context) })));
  new Tour(tourPlace, { store, core, menu, tabs });
}
