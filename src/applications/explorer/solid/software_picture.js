// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Triangles drawn by the processor, for browsers without WebGL: what `MeshPicture` draws, dot by dot, of each the triangle
 * that is nearest to the eye. Its cost is that of the dots and of the triangles: a million take some tenths of a second.
 */

const LIGHT = [0.35, 0.55, 0.75].map((each) => each / Math.hypot(0.35, 0.55, 0.75));
const FINER = 2; // dots drawn for one shown, each way: edges are smooth then

export class SoftwarePicture {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.works = this.context !== null;
  }

  /** As `MeshPicture.set`. */
  set(rock, ground = new Float64Array(0)) {
    this.parts = [rock, ground];
  }

  /** As `MeshPicture.draw`. */
  draw(turn, { dots, x, y }, colours) {
    const { canvas, context } = this;
    const finer = FINER * Math.min(devicePixelRatio, 1);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((each) => Math.round(each * finer));
    if (width === 0 || height === 0) return;
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const picture = context.createImageData(width, height);
    const near = new Float32Array(width * height).fill(-Infinity);
    const paint = new Uint32Array(picture.data.buffer);
    this.parts.forEach((part, which) => {
      const seen = seenFrom(part, turn, dots * finer, width / 2 + x * finer, height / 2 + y * finer);
      for (let k = 0; k < seen.length; k += 9) fill(seen, k, paint, near, width, height, colours[which]);
    });
    context.putImageData(picture, 0, 0);
  }
}

/** Corners on the screen: x to the right, y down, z to the eye, all in dots. */
function seenFrom(triangles, turn, dots, left, top) {
  const seen = new Float64Array(triangles.length);
  for (let k = 0; k < triangles.length; k += 3) {
    const [x, y, z] = [triangles[k], triangles[k + 1], triangles[k + 2]];
    seen[k] = left + dots * (turn[0] * x + turn[1] * y + turn[2] * z);
    seen[k + 1] = top - dots * (turn[3] * x + turn[4] * y + turn[5] * z);
    seen[k + 2] = dots * (turn[6] * x + turn[7] * y + turn[8] * z);
  }
  return seen;
}

/** The dots of a triangle, row by row, that nothing nearer has. */
function fill(seen, k, paint, near, width, height, colour) {
  const [ax, ay, az, bx, by, bz, cx, cy, cz] = seen.subarray(k, k + 9);
  const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az];
  const across = ux * vy - uy * vx; // twice its area on the screen
  if (across === 0) return;
  const [nx, ny] = [uy * vz - uz * vy, uz * vx - ux * vz];
  const shade = dotsColour(Math.abs(nx * LIGHT[0] - ny * LIGHT[1] + across * LIGHT[2]) / Math.hypot(nx, ny, across), colour);
  const edges = [[ax, ay, bx, by], [bx, by, cx, cy], [cx, cy, ax, ay]];
  for (let row = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)); row < height && row + 0.5 < Math.max(ay, by, cy); row++) {
    let [from, to] = [Infinity, -Infinity];
    for (const [px, py, qx, qy] of edges) {
      if (py > row + 0.5 === qy > row + 0.5) continue;
      const at = px + ((row + 0.5 - py) / (qy - py)) * (qx - px);
      [from, to] = [Math.min(from, at), Math.max(to, at)];
    }
    for (let column = Math.max(0, Math.ceil(from - 0.5)); column < width && column + 0.5 < to; column++) {
      // on the plane of its corners
      const depth = az - (nx * (column + 0.5 - ax) + ny * (row + 0.5 - ay)) / across;
      if (depth <= near[row * width + column]) continue;
      near[row * width + column] = depth;
      paint[row * width + column] = shade;
    }
  }
}

/** Of light from 0 to 1, as the shader of `MeshPicture` has it. @returns {number} red in the lowest byte */
function dotsColour(light, colour) {
  const [red, green, blue] = colour.map((each) => Math.round(255 * each * (0.42 + 0.58 * light)));
  return ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;
}
