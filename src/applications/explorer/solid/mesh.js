// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The triangles of a mesh to be looked at: OBJ, STL and PLY as text, STL as bytes. The core reads the file itself, with all that
 * it refuses; a mesh is drawn only where its triangles are as many as the core counts.
 */

/** @typedef {Float64Array} Triangles nine numbers each: x, y, z of three corners */

/** @param {string|Uint8Array} content @returns {Triangles|null} null: it is none of these */
export function trianglesOf(content) {
  if (typeof content !== "string") return binaryStl(content);
  if (/^\s*ply\b/.test(content)) return plyOf(content);
  if (/^\s*solid\b/.test(content) && /\bfacet\b/.test(content)) return stlOf(content);
  return objOf(content);
}

function stlOf(text) {
  const numbers = [...text.matchAll(/vertex\s+(\S+)\s+(\S+)\s+(\S+)/g)].flatMap(([, x, y, z]) => [Number(x), Number(y), Number(z)]);
  return numbers.length > 0 && numbers.length % 9 === 0 ? Float64Array.from(numbers) : null;
}

function binaryStl(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 84 || bytes.length !== 84 + 50 * view.getUint32(80, true)) return null;
  return Float64Array.from({ length: 9 * view.getUint32(80, true) }, (_, k) => view.getFloat32(84 + 50 * Math.floor(k / 9) + 12 + 4 * (k % 9), true));
}

function objOf(text) {
  const points = [];
  const faces = [];
  for (const line of text.split("\n")) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === "v") points.push(rest.slice(0, 3).map(Number));
    else if (word === "f") faces.push(rest.map((each) => Number(each.split("/")[0])).map((at) => (at < 0 ? points.length + at : at - 1)));
  }
  return fans(points, faces);
}

function plyOf(text) {
  const [head, body = ""] = text.split(/end_header\r?\n/);
  const count = (name) => Number(new RegExp("element " + name + " (\\d+)").exec(head)?.[1] ?? 0);
  if (!/format ascii/.test(head)) return null;
  const rows = body.trim().split("\n").map((line) => line.trim().split(/\s+/).map(Number));
  const points = rows.slice(0, count("vertex")).map((row) => row.slice(0, 3));
  return fans(points, rows.slice(points.length, points.length + count("face")).map((row) => row.slice(1, 1 + row[0])));
}

/** Faces of several corners as triangles about their first one. */
function fans(points, faces) {
  const numbers = [];
  for (const face of faces) {
    for (let k = 1; k + 1 < face.length; k++) {
      for (const at of [face[0], face[k], face[k + 1]]) {
        if (points[at] === undefined) return null;
        numbers.push(...points[at]);
      }
    }
  }
  return numbers.length === 0 ? null : Float64Array.from(numbers);
}

/**
 * @param {Triangles} triangles @param {number[]} from where tetrahedra to them begin: on the plane of an open face its own has no volume
 * @returns {number} the volume that they enclose, in lengths of the mesh
 */
export function volumeOf(triangles, from = [0, 0, 0]) {
  let six = 0;
  for (let k = 0; k < triangles.length; k += 9) {
    const [a, b, c, d, e, f, g, h, i] = triangles.subarray(k, k + 9).map((value, at) => value - from[at % 3]);
    six += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  }
  return Math.abs(six / 6);
}
