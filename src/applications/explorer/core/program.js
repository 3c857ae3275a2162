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

  /**
   * @param {Function} createCore what emscripten's loader exports
   * @param {WebAssembly.Module} module
   * @param {Object<string, string>} [environment] variables that the program finds, such as SOURCE_DATE_EPOCH
   * @returns {Promise<Program>}
   */
  static async create(createCore, module, environment = {}) {
    const core = await createCore({
      preRun: [({ ENV }) => Object.assign(ENV, environment)],
      instantiateWasm(imports, done) {
        WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
        return {};
      },
      quit(status) {
        throw new Ended(status);
      },
    });
    return new Program(core);
  }

  constructor(core) {
    this.#core = core;
    core.FS.mkdirTree(HOME);
    core.FS.chdir(HOME);
    // Around the fonts, which nothing writes to.
    const kept = [[DATA_BEGIN, core._core_fonts(0)], [core._core_fonts(1), core._core_data_end()]];
    this.#begun = kept.map(([begin, end]) => ({ begin, bytes: core.HEAPU8.slice(begin, end) }));
  }

  /** Bytes of memory that the instance holds; it never gives any back. */
  get size() {
    return this.#core.HEAPU8.length;
  }

  /**
   * @param {string[]} args as on the command line, without the name of the program
   * @param {Object<string, string|Uint8Array>} files put where the program runs
   * @param {string[]} [collect] names of files to read afterwards
   * @returns {Written}
   */
  run(args, files, collect = []) {
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
