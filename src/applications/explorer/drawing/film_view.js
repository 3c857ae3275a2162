// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A film on the drawing: the table at its tilt, the block on its way, each contact in the colour of what it does. */

import { zoomIdentity } from "d3-zoom";
import { contactPaths, transformOf, wayOf } from "./film.js";
import { drawScale } from "./scale_bar.js";
import { drawArc } from "./tilt_handle.js";
import { waterPath } from "./water.js";

const DECIMALS = 2; // of the tilt

export class FilmView {
  /** @param {import("./drawing.js").Drawing} drawing */
  constructor(drawing) {
    this.drawing = drawing;
  }

  /** @param {import("./film.js").Film} film */
  enter(film) {
    const { drawing } = this;
    drawing.svg.classed("filming", true).call(drawing.zooming.transform, zoomIdentity);
    drawing.refit(wayOf(film, drawing.case, drawing.store.lastSolution.outlines));
  }

  /** The block at a time of it. */
  show(film, time) {
    const { view, layers, sign, store, context } = this.drawing;
    const { outlines } = store.lastSolution;
    const pose = film.poseAt(time);
    view.turn = (sign * pose.tilt * Math.PI) / 180;
    layers.frame.attr("transform", "matrix(" + view.matrix.join(" ") + ")");
    if (context !== null && !context.many) layers.water.attr("d", waterPath(context, outlines, view.turn));
    layers.moving.attr("transform", transformOf(this.drawing.case, outlines, pose));
    layers.touch.attr("transform", layers.front.attr("transform")).selectAll("path").data(contactPaths(outlines, film.contactsAt(time))).join("path")
      .attr("class", ({ state }) => "shape touch " + state).attr("d", ({ path }) => path);
    drawArc(layers.arc, view, sign, DECIMALS);
    if (context !== null) drawScale(layers.scale, view, sign, context);
  }

  leave() {
    const { drawing } = this;
    drawing.svg.classed("filming", false);
    drawing.layers.moving.attr("transform", null);
    drawing.layers.touch.selectAll("path").remove();
    drawing.refit(null);
    drawing.draw();
  }
}
