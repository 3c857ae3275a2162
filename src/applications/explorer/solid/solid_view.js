// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A solid on its base, tilted as the scene says, to be turned by the hand or by arrow keys: the mesh, the support within the band
 * that governs, the edge that it topples about, its weight, and the way down, or the mesh of the ground; of one that a plane cuts what lies above, on its
 * section. A browser without WebGL draws it by the processor. Where there is no mesh of it, its report stands alone.
 */

import { belowBadge } from "../drawing/view.js";
import { degreesText } from "../panels/certain.js";
import { element, refill, svgElement } from "../panels/element.js";
import { numeral, say } from "../words/language.js";
import { MeshPicture } from "./mesh_picture.js";
import { SoftwarePicture } from "./software_picture.js";
import { isOnSlope, levelled, meshOf } from "./solid_mesh.js";
import { FIRST, after, seenFrom, tilted, turned } from "./turning.js";

const PER_DOT = 0.008; // radians
const STEP = Math.PI / 36;
const CLOSER = 1.2;
const DISC = 48; // corners of the ground that is drawn
const WEIGHT = 0.8; // of the solid's reach
const NORMAL = 0.25; // of it, of a contact
const SLIDES = 0.7; // of it, beyond the toe of a wedge
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class SolidView {
  #eye = { ...FIRST, zoom: 1 };
  #read = null; // what the mesh is of, and whether there is one

  /** @param {HTMLElement} place @param {HTMLElement} words where it is told how it lies, not over it @param {import("../scene/store.js").SceneStore} store */
  constructor(place, words, store) {
    Object.assign(this, { place, words, store });
    this.ground = svgElement("svg", { class: "solid-lines below-mesh", "aria-hidden": "true" });
    this.canvas = element("canvas", { tabindex: 0, role: "img", onkeydown: (event) => this.#key(event), onwheel: (event) => this.#wheel(event),
      onpointerdown: (event) => this.canvas.setPointerCapture(event.pointerId), onpointermove: (event) => event.buttons === 1 && this.#drag(event) });
    this.lines = svgElement("svg", { class: "solid-lines", "aria-hidden": "true" });
    place.append(this.ground, this.canvas, this.lines);
    this.picture = null; // made for the first solid: most pages need none
    store.addEventListener("solution", () => this.#solved());
    store.addEventListener("text", () => store.lastSolution === null && this.#show(false));
    new ResizeObserver(() => this.#draw()).observe(place);
    new MutationObserver(() => this.#draw()).observe(document.documentElement, { attributeFilter: ["data-theme"] });
  }

  #solved() {
    const { solution } = this.store;
    if (solution.kind === "solid") this.picture ??= pictureOn(this.canvas);
    const shown = solution.kind === "solid" && this.picture.works && this.#mesh(solution);
    this.#show(shown);
    if (!shown) return;
    this.solution = solution;
    this.canvas.setAttribute("aria-label", say("The solid, of %s triangles: arrow keys turn it, + and - zoom, 0 as at first", solution.triangles));
    this.#draw();
  }

  #show(shown) {
    document.body.classList.toggle("solid", shown);
    this.place.hidden = !shown;
  }

  /** @returns {boolean} whether there is one */
  #mesh(solution) {
    const { parsed, files } = this.store;
    this.isOnSlope = isOnSlope(parsed);
    // of a mesh in a file nothing but the file counts, and where it is cut; it is read once
    const content = files[parsed.scalar(["solid", "file"]) ?? ""] ?? parsed.text;
    const of = [content, files[parsed.scalar(["solid", "base", "file"]) ?? ""], solution.ground?.object, solution.ground?.metres_per_unit,
      solution.volume_m3.value, solution.triangles, ...levelled(solution, parsed)];
    if (this.#read !== null && of.every((each, k) => each === this.#read.of[k])) return this.#read.fits;
    const mesh = meshOf(solution, parsed, files);
    const another = content !== this.#read?.of[0];
    this.#read = { of, fits: mesh !== null };
    if (mesh === null) return false;
    const { near, ground } = mesh;
    for (const key of ["unit", "centroid", "reach", "section", "level", "goesOn"]) this[key] = mesh[key];
    this.lowest = Infinity;
    for (let k = 0; k < near.length; k += 3) this.lowest = Math.min(this.lowest, turned(this.level, [near[k], near[k + 1], near[k + 2]])[2]);
    this.picture.set(near, ground);
    if (another) this.#eye = { ...FIRST, zoom: 1 };
    return true;
  }

  #draw() {
    if (this.place.hidden || this.solution === undefined) return;
    const { width, height } = this.place.getBoundingClientRect();
    if (width === 0) return;
    const { around, height: high, zoom } = this.#eye;
    const base = tilted(this.solution.tilt_angle_deg ?? 0, this.solution.tilt_azimuth_deg ?? 0);
    const eye = seenFrom(around, high);
    const top = belowBadge(width);
    this.dots = (zoom * Math.min(width, height - top)) / (2.9 * this.reach);
    const style = getComputedStyle(document.documentElement);
    const colours = ["--solid", "--rock"].map((name) => style.getPropertyValue(name).trim()).map((hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255));
    this.picture.draw(after(eye, after(base, this.level)), { dots: this.dots, reach: 3.5 * this.reach, x: 0, y: top / 2 }, colours);
    const project = (turn) => (point) => {
      const [x, y] = turned(turn, point);
      return (width / 2 + this.dots * x).toFixed(2) + " " + ((height + top) / 2 - this.dots * y).toFixed(2);
    };
    for (const svg of [this.ground, this.lines]) svg.setAttribute("viewBox", "0 0 " + width + " " + height);
    this.#lines(project(after(eye, base)), project(eye), project(after(eye, after(base, this.level))));
  }

  /** @param of points of the base @param free points of the world @param own points of the mesh, all from the centroid */
  #lines(of, free, own) {
    const { solution, lowest, reach } = this;
    const band = solution.bands?.find(({ band: one }) => one === solution.governing_band);
    const path = (points, end = "") => (points.length === 0 ? "" : "M" + points.join("L") + end);
    const disc = Array.from({ length: DISC }, (_, k) => of([1.3 * reach * Math.cos((2 * Math.PI * k) / DISC), 1.3 * reach * Math.sin((2 * Math.PI * k) / DISC), lowest]));
    const azimuth = ((solution.tilt_azimuth_deg ?? 0) * Math.PI) / 180;
    const way = (long) => [long * Math.sin(azimuth), long * Math.cos(azimuth), lowest];
    const onPlane = solution.bands?.length > 0;
    refill(this.ground, onPlane ? svgElement("path", { class: "disc", d: path(disc, "Z") }) : null,
      solution.tilt_angle_deg > 0 ? [svgElement("path", { class: "way", d: path([of([0, 0, lowest]), of(way(1.25 * reach))]) })] : null);
    const support = (band?.support ?? []).map(({ east_m: east, north_m: north }) => of([east / this.unit, north / this.unit, lowest]));
    const least = band?.least;
    const edge = [least?.edge_from, least?.edge_to].filter((end) => end !== undefined).map((end) => own(end.map((value, k) => value - this.centroid[k])));
    const at = (point) => own(point.map((value, k) => value - this.centroid[k]));
    const contacts = (solution.contacts?.contacts ?? []).map((contact) => path([at(contact.at), at(contact.at.map((value, k) => value + NORMAL * reach * contact.normal[k]))]));
    const section = this.section.map((ends) => ends.map(own));
    refill(this.lines, svgElement("path", { class: "section", d: section.map(([from, to]) => "M" + section[0][0] + "L" + from + "L" + to + "Z").join("") }),
      svgElement("path", { class: "cut", d: section.map(([from, to]) => "M" + from + "L" + to).join("") }),
      contacts.map((d) => svgElement("path", { class: "touching", d })),
      solution.wedge === undefined ? null : svgElement("path", { class: "way", d: path([at([0, 0, 0]), at(alongLine(solution.wedge, reach))]) }), svgElement("path", { class: "support", d: path(support, "Z") }), svgElement("path", { class: "edge", d: path(edge) }),
      svgElement("path", { class: "weight", d: path([free([0, 0, 0]), free([0, 0, -WEIGHT * reach])]) }));
    this.words.textContent = this.#words(band).join(" · ");
  }

  /** @returns {string[]} */
  #words(band) {
    const { wedge } = this.solution;
    if (wedge !== undefined) return [say("The joints' line plunges by %s towards %s", ...[wedge.plunge_deg, wedge.trend_deg].map((each) => degreesText(each)))];
    const { tilt_angle_deg: tilt, tilt_azimuth_deg: azimuth, below, length_unit: unit } = this.solution;
    const lies = this.isOnSlope ? "its base dips by %s towards %s" : "tilted by %s towards %s";
    return [tilt > 0 ? say(lies, numeral(tilt + "") + "°", numeral((azimuth ?? 0) + "") + "°") : null,
      below !== undefined ? say("cut %s over its lowest point: it rests on the section", numeral(below + "") + " " + unit)
        : band === undefined ? null : say("what lies within %s of its lowest point touches", numeral(band.band + "") + " " + unit),
      this.goesOn ? say("its ground goes on farther than it is drawn") : null,
      this.picture instanceof SoftwarePicture ? say("drawn without WebGL: a large mesh turns slowly") : null].filter((each) => each !== null);
  }

  #drag(event) {
    this.#turn(event.movementX * PER_DOT, event.movementY * PER_DOT);
  }

  #turn(around, height) {
    const eye = this.#eye;
    eye.around += around;
    eye.height = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, eye.height + height));
    this.#draw();
  }

  #wheel(event) {
    event.preventDefault();
    this.#eye.zoom *= Math.exp(-event.deltaY / 500);
    this.#draw();
  }

  #key(event) {
    const way = KEYS[event.key];
    if (way !== undefined) this.#turn(STEP * way[0], STEP * way[1]);
    else if (event.key === "+" || event.key === "=") this.#eye.zoom *= CLOSER;
    else if (event.key === "-") this.#eye.zoom /= CLOSER;
    else if (event.key === "0") this.#eye = { ...FIRST, zoom: 1 };
    else return;
    event.preventDefault();
    this.#draw();
  }
}

/** A point on the line of a wedge's joints beyond its toe, which is the origin. */
function alongLine({ plunge_deg: plunge, trend_deg: trend }, reach) {
  const [p, t] = [plunge, trend].map(({ value }) => (value * Math.PI) / 180);
  return [Math.cos(p) * Math.sin(t), Math.cos(p) * Math.cos(t), -Math.sin(p)].map((each) => SLIDES * reach * each);
}

/** By the graphics card where the browser lets it, else by the processor. @param {HTMLCanvasElement} canvas */
function pictureOn(canvas) {
  const picture = new MeshPicture(canvas);
  return picture.gl === null ? new SoftwarePicture(canvas) : picture;
}
