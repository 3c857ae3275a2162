// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Triangles drawn by the graphics card: a mesh of a million is turned as smoothly as one of a hundred. */

const SHADERS = [
  ["VERTEX_SHADER", "attribute vec3 at; attribute vec3 normal; uniform mat3 turn; uniform vec3 scale; uniform vec2 shift; varying float light;" +
    "void main() { vec3 p = turn * at; light = 0.42 + 0.58 * abs(dot(turn * normal, normalize(vec3(0.35, 0.55, 0.75))));" +
    "gl_Position = vec4(p.x * scale.x + shift.x, p.y * scale.y + shift.y, -p.z * scale.z, 1.0); }"],
  ["FRAGMENT_SHADER", "precision mediump float; uniform vec3 colour; varying float light; void main() { gl_FragColor = vec4(colour * light, 1.0); }"],
];

export class MeshPicture {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl", { antialias: true });
    if (this.gl === null) return;
    const { gl } = this;
    this.program = gl.createProgram();
    for (const [kind, text] of SHADERS) {
      const shader = gl.createShader(gl[kind]);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
    }
    gl.linkProgram(this.program);
    gl.useProgram(this.program);
    gl.enable(gl.DEPTH_TEST);
    this.buffer = gl.createBuffer();
  }

  /** Whether this browser draws them. */
  get works() {
    return this.gl !== null && this.gl.getProgramParameter(this.program, this.gl.LINK_STATUS);
  }

  /** @param {Float64Array} rock triangles from an origin near them @param {Float64Array} [ground] likewise, in a colour of its own */
  set(rock, ground = new Float64Array(0)) {
    const { gl } = this;
    const triangles = new Float64Array(rock.length + ground.length);
    triangles.set(rock);
    triangles.set(ground, rock.length);
    const data = new Float32Array(2 * triangles.length);
    for (let k = 0; k < triangles.length; k += 9) {
      const [ux, uy, uz, vx, vy, vz] = [3, 4, 5, 6, 7, 8].map((j) => triangles[k + j] - triangles[k + (j % 3)]);
      const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
      const long = Math.hypot(...n) || 1;
      for (let corner = 0; corner < 3; corner++) {
        for (let j = 0; j < 3; j++) {
          data[2 * k + 6 * corner + j] = triangles[k + 3 * corner + j];
          data[2 * k + 6 * corner + 3 + j] = n[j] / long;
        }
      }
    }
    this.counts = [rock.length / 3, ground.length / 3];
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    for (const [name, offset] of [["at", 0], ["normal", 12]]) {
      const place = gl.getAttribLocation(this.program, name);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, offset);
    }
  }

  /** @param {number[]} turn row by row @param {{dots: number, reach: number, x: number, y: number}} view dots a length; how far points lie; the middle, dots from that of the canvas @param {number[][]} colours of rock and ground */
  draw(turn, { dots, reach, x, y }, colours) {
    const { gl, canvas } = this;
    const ratio = devicePixelRatio;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const at = (name) => gl.getUniformLocation(this.program, name);
    gl.uniformMatrix3fv(at("turn"), false, [0, 3, 6, 1, 4, 7, 2, 5, 8].map((k) => turn[k])); // columns
    gl.uniform3f(at("scale"), (2 * dots) / width, (2 * dots) / height, 1 / (1.1 * reach));
    gl.uniform2f(at("shift"), (2 * x) / width, (-2 * y) / height);
    colours.forEach((colour, part) => {
      gl.uniform3f(at("colour"), ...colour);
      gl.drawArrays(gl.TRIANGLES, part === 0 ? 0 : this.counts[0], this.counts[part]);
    });
  }
}
