// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Curves over one number, drawn by uPlot, with upright and level marks. Colours follow light and dark. */

import uPlot from "uplot";
import { element } from "./element.js";
import { numeral, say } from "../words/language.js";

const HEIGHT = 300;
const MANY = 10; // numbers of x that a key passes with Shift
/** Of each place its chart, which follows the place's width. */
const drawnIn = new WeakMap();
const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3], [4, 4], [12, 4]];
const LONG = 1e5; // what a tick of a logarithmic axis has no room for in full

/**
 * @typedef {object} Curve
 * @property {string} name
 * @property {(number|null)[]} values
 * @property {string} colour a custom property of the page's style, as --blue
 * @property {boolean} [dots] points alone
 * @property {(index: number) => string} [told] what the legend says there
 */

/**
 * @param {HTMLElement} place what stood there goes
 * @param {object} drawn
 * @param {number[]} drawn.x in order
 * @param {Curve[]} drawn.curves
 * @param {string} drawn.xLabel
 * @param {string} drawn.yLabel
 * @param {[number, number]} [drawn.yRange]
 * @param {{x?: number, y?: number, name: string, colour: string}[]} [drawn.marks]
 * @param {boolean} [drawn.logarithmic] both axes
 */
export function drawChart(place, drawn) {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(name).trim() || "gray";
  const axis = (label) => ({
    label, stroke: colour("--ink"), labelFont: "13px system-ui", font: "12px system-ui",
    values: (_, ticks) => ticks.map((tick) => (tick === null ? "" : drawn.logarithmic && tick >= LONG ? powerOfTen(tick) : shortNumber(tick))),
    grid: { stroke: colour("--line"), width: 1 }, ticks: { stroke: colour("--line"), width: 1 },
  });
  const scale = drawn.logarithmic ? { distr: 3 } : {};
  const chart = new uPlot(
    {
      ...sizeOf(place),
      scales: { x: { time: false, ...scale }, y: { ...scale, ...(drawn.yRange ? { range: drawn.yRange } : {}) } },
      axes: [axis(drawn.xLabel), axis(drawn.yLabel)],
      series: [
        { label: drawn.xLabel, value: (_, value) => shortNumber(value) },
        ...drawn.curves.map((curve, index) => ({
          label: curve.name, stroke: colour(curve.colour), width: curve.dots ? 1 : 2, dash: DASHES[index % DASHES.length],
          ...(curve.dots ? { paths: () => null } : {}), points: { show: curve.dots === true, size: 7 },
          value: (_, value, __, at) => (value === null || at === null || at === undefined ? "—" : curve.told?.(at) ?? shortNumber(value)),
        })),
      ],
      hooks: { draw: [(plot) => (drawn.marks ?? []).forEach((mark) => drawMark(plot, mark, colour))] },
    },
    [drawn.x, ...drawn.curves.map((curve) => curve.values)],
  );
  chart.root.setAttribute("role", "group");
  chart.root.setAttribute("aria-label", say("%s over %s: arrow keys read it", drawn.yLabel, drawn.xLabel));
  chart.root.tabIndex = 0;
  chart.root.addEventListener("keydown", (event) => readByKey(event, chart));
  place.replaceChildren(chart.root);
  if (!drawnIn.has(place)) new ResizeObserver(() => drawnIn.get(place).setSize(sizeOf(place))).observe(place);
  drawnIn.get(place)?.destroy();
  drawnIn.set(place, chart);
  return chart;
}

/** From one number of x to the next, in larger steps with Shift; the legend, which tells what is there, is read out. @param {KeyboardEvent} event @param {uPlot} chart */
function readByKey(event, chart) {
  const [x] = chart.data;
  const many = event.shiftKey ? MANY : 1;
  const at = chart.cursor.idx ?? -1;
  const wanted = { ArrowLeft: at < 0 ? x.length - 1 : at - many, ArrowRight: at + many, Home: 0, End: x.length - 1 }[event.key];
  if (wanted === undefined) return;
  event.preventDefault();
  chart.root.querySelector(".u-legend").setAttribute("aria-live", "polite");
  chart.setCursor({ left: chart.valToPos(x[Math.max(0, Math.min(x.length - 1, wanted))], "x"), top: chart.over.clientHeight / 2 });
}

function sizeOf(place) {
  return { width: Math.max(260, place.clientWidth), height: HEIGHT };
}

function drawMark(plot, mark, colour) {
  const { ctx, bbox } = plot;
  const upright = mark.x !== undefined;
  const at = Math.round(plot.valToPos(upright ? mark.x : mark.y, upright ? "x" : "y", true));
  if (upright ? at < bbox.left || at > bbox.left + bbox.width : at < bbox.top || at > bbox.top + bbox.height) return;
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = colour(mark.colour);
  ctx.lineWidth = devicePixelRatio;
  ctx.setLineDash([5, 4]);
  ctx.beginPath();
  ctx.moveTo(upright ? at : bbox.left, upright ? bbox.top : at);
  ctx.lineTo(upright ? at : bbox.left + bbox.width, upright ? bbox.top + bbox.height : at);
  ctx.stroke();
  ctx.font = 12 * devicePixelRatio + "px system-ui";
  ctx.fillText(mark.name, upright ? at + 4 : bbox.left + 6, upright ? bbox.top + 14 * devicePixelRatio : at - 5);
  ctx.restore();
}

/** For an eye on a curve: the numbers with their bounds are in the table. @param {number|null} value */
export function shortNumber(value) {
  return value === null || value === undefined ? "—" : numeral(String(Number(value.toPrecision(5))));
}

/** @param {number} tick of a logarithmic axis @returns {string} 10⁶ */
function powerOfTen(tick) {
  return "10" + [...String(Math.round(Math.log10(tick)))].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(digit)]).join("");
}

/** A text as a file that can be saved. @param {string} name @param {string|Uint8Array} content @param {string} label */
export function saveLink(name, content, label = name) {
  const link = element("a", { download: name, href: URL.createObjectURL(new Blob([content])) }, label);
  // the address keeps the content in memory until it is given back
  link.addEventListener("click", () => setTimeout(() => URL.revokeObjectURL(link.href), 60_000), { once: true });
  return link;
}
