// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The program topple as one instance of WebAssembly, run again and again, each time as a new process: its own data is
 * put back to what it was when it began, so that nothing of a run is left to the next, and no memory is lost.
 */

/**
 * @typedef {object} Written What a run wrote.
 * @property {number} status exit status
 * @property {string} out standard output
 * @property {string} err standard error
 * @property {Object<string, Uint8Array>} files those that were asked for and are there, by name
 * @property {number} seconds
 */

/**
 * @typedef {object} Rest What the first part of the core lacks (wasm/split.py).
 * @property {WebAssembly.Module} module its other functions
 * @property {Uint8Array} fonts
 */

const PLACEHOLDER = "placeholder"; // where functions of the rest are imported from
const ROOT = "/files";
const HOME = ROOT + "/scenes"; // a scene may name a file in a folder beside its own
const DATA_BEGIN = 1024; // below it nothing is stored, as no pointer is null or near it
const text = new TextDecoder();

/** @param {string} name of a file, from where the program runs @returns {string} its path; outside of all scenes there is none */
function placeOf(name) {
  const path = new URL(HOME + "/" + name.split("/").map(encodeURIComponent).join("/"), "file:///").pathname;
  if (!path.startsWith(ROOT + "/")) throw new Error(`${name} lies outside of where scenes are`);
  return decodeURIComponent(path);
}

/** Functions in place of those that are not there yet. @param {WebAssembly.Module} module @param {{lacks: boolean}} first is told that one was called */
function placeholders(module, first) {
  const called = () => {
    first.lacks = true;
    throw new Error("the rest of the core is not there yet");
  };
  return Object.fromEntries(WebAssembly.Module.imports(module).filter((each) => each.module === PLACEHOLDER).map(({ name }) => [name, called]));
}

/** Thrown by exit(). */
class Ended extends Error {
  /** @param {number} status */
  constructor(status) {
    super(`ended with status ${status}`);
    this.status = status;
  }
}

export class Program {
  #core;
  #begun;
  #first;
  /** @type {Promise<Rest>|null} null: it is there, or never needed */
  #rest;
  #lacks;

  /**
   * @param {Function} createCore what emscripten's loader exports
   * @param {{module: WebAssembly.Module, rest: Promise<Rest>|null, lacks?: () => void}} parts rest: null where the module is the
   *   whole core; lacks: called where a run waits for the rest
   * @param {Object<string, string>} [environment] variables that the program finds, such as SOURCE_DATE_EPOCH
   * @returns {Promise<Program>}
   */
  static async create(createCore, { module, rest, lacks = () => {} }, environment = {}) {
    const first = { lacks: false, imports: null, exports: null };
    // the loader's promise never ends where the module cannot be instantiated, as where there is no memory for it
    const core = await new Promise((resolve, reject) => createCore({
      preRun: [({ ENV }) => Object.assign(ENV, environment)],
      instantiateWasm(imports, done) {
        first.imports = { ...imports, [PLACEHOLDER]: placeholders(module, first) };
        WebAssembly.instantiate(module, first.imports).then((instance) => {
          first.exports = instance.exports;
          done(instance, module);
        }).catch(reject);
        return {};
      },
      quit(status) {
        throw new Ended(status);
      },
    }).then(resolve, reject));
    return new Program(core, first, rest, lacks);
  }

  constructor(core, first, rest, lacks) {
    this.#core = core;
    this.#first = first;
    this.#rest = rest;
    this.#lacks = lacks;
    core.FS.mkdirTree(HOME);
    core.FS.chdir(HOME);
    // Around the fonts, which nothing writes to.
    const kept = [[DATA_BEGIN, core._core_fonts(0)], [core._core_fonts(1), core._core_data_end()]];
    this.#begun = kept.map(([begin, end]) => ({ begin, bytes: core.HEAPU8.slice(begin, end) }));
    rest?.then((came) => this.#complete(came), () => {});
  }

  /** Where the fonts lie in its memory. @returns {Uint8Array} */
  get fonts() {
    return this.#core.HEAPU8.subarray(this.#core._core_fonts(0), this.#core._core_fonts(1));
  }

  /** Bytes of memory that the instance holds; it never gives any back. */
  get size() {
    return this.#core.HEAPU8.length;
  }

  /**
   * A run that needs what is not there yet is given up, and done anew when it is: each begins from the same state.
   * @param {string[]} args as on the command line, without the name of the program
   * @param {Object<string, string|Uint8Array>} files put where the program runs
   * @param {string[]} [collect] names of files to read afterwards
   * @returns {Promise<Written>}
   */
  async run(args, files, collect = []) {
    this.#first.lacks = false;
    try {
      const written = this.#runOnce(args, files, collect);
      if (!this.#first.lacks) return written;
    } catch (error) {
      if (!this.#first.lacks) throw error;
    }
    this.#lacks();
    this.#complete(await this.#rest);
    return this.#runOnce(args, files, collect);
  }

  /** @param {Rest} rest put where the placeholders of its functions are, and its fonts */
  #complete({ module, fonts }) {
    if (this.#rest === null) return;
    this.#rest = null;
    new WebAssembly.Instance(module, { ...this.#first.imports, primary: this.#first.exports });
    this.fonts.set(fonts);
  }

  /** @returns {Written} */
  #runOnce(args, files, collect) {
    const { FS } = this.#core;
    for (const { begin, bytes } of this.#begun) this.#core.HEAPU8.set(bytes, begin);
    this.#clear(ROOT);
    for (const [name, bytes] of Object.entries(files)) {
      const path = placeOf(name);
      FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
      FS.writeFile(path, bytes);
    }
    this.#open();
    const begin = performance.now();
    const status = this.#call(["topple", ...args]);
    const seconds = (performance.now() - begin) / 1000;
    const written = { status, out: text.decode(FS.readFile("/out")), err: text.decode(FS.readFile("/err")), files: {}, seconds };
    for (const name of collect) {
      const path = placeOf(name);
      if (FS.analyzePath(path).exists) written.files[name] = FS.readFile(path);
    }
    return written;
  }

  /** The three standard streams, as files: a terminal of emscripten's would take each byte by itself. */
  #open() {
    const { FS } = this.#core;
    FS.streams.filter((stream) => stream).forEach((stream) => FS.close(stream));
    FS.open("/dev/null", "r");
    FS.open("/out", "w");
    FS.open("/err", "w");
  }

  /** @param {string} folder emptied, and what lies below it, but for the folder where the program runs */
  #clear(folder) {
    const { FS } = this.#core;
    for (const name of FS.readdir(folder)) {
      if (name === "." || name === "..") continue;
      const path = `${folder}/${name}`;
      if (FS.isDir(FS.lstat(path).mode)) {
        this.#clear(path);
        if (path !== HOME) FS.rmdir(path);
      } else {
        FS.unlink(path);
      }
    }
  }

  /**
   * @param {string[]} words
   * @returns {number} the exit status
   */
  #call(words) {
    const core = this.#core;
    const stack = core.stackSave();
    try {
      const texts = words.map((word) => {
        const bytes = new TextEncoder().encode(word);
        const at = core._malloc(bytes.length + 1);
        core.HEAPU8.set(bytes, at);
        core.HEAPU8[at + bytes.length] = 0;
        return at;
      });
      const list = core._malloc(4 * (texts.length + 1));
      core.HEAPU32.set([...texts, 0], list / 4);
      core._core_run(words.length, list);
    } catch (end) {
      if (end instanceof Ended) return end.status;
      throw end;
    } finally {
      core.stackRestore(stack);
    }
    throw new Error("the program did not end by exit");
  }
}
