// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A plane of points and what happens at each, found by solving few of them: first every eighth one, then all that lie
 * in a cell whose solved points do not agree, down to single cells. A point that is not solved lies in a cell all of
 * whose solved corners, edge middles and centre agree. The core's certified borders are drawn over it.
 */

const COARSE = 8;
const UNKNOWN = 0;

export class MapGrid {
  /** @param {number} columns points along x, one more than a multiple of eight @param {number} rows likewise along y */
  constructor(columns, rows) {
    if ((columns - 1) % COARSE !== 0 || (rows - 1) % COARSE !== 0) throw new RangeError("cells are halved three times");
    this.columns = columns;
    this.rows = rows;
    /** What happens there, by a number from 1. */
    this.kinds = new Uint8Array(columns * rows);
    this.solved = new Uint8Array(columns * rows);
    this.count = 0;
  }

  /** @param {number} column @param {number} row from below @param {number} kind */
  put(column, row, kind) {
    const at = row * this.columns + column;
    if (this.solved[at] === 0) this.count++;
    this.solved[at] = 1;
    this.kinds[at] = kind;
  }

  /**
   * Solves what has to be.
   * @param {(rows: number[], columns: number[]) => Promise<boolean>} solve puts all points of these rows; false: leave
   * @param {() => void} drawn after each round the whole plane is told, ever finer
   */
  async refine(solve, drawn) {
    if (!(await solve(everyEighth(this.rows), everyEighth(this.columns)))) return;
    for (let size = COARSE; size >= 2; size /= 2) {
      this.#fill(size);
      drawn();
      let wanted = this.#wanted(size);
      while (wanted.size > 0) {
        for (const { rows, columns } of alike(wanted)) if (!(await solve(rows, columns))) return;
        wanted = this.#wanted(size);
      }
    }
    drawn();
  }

  /** Of cells so large whose solved points differ, the ones that are not solved. @returns {Map<number, number[]>} */
  #wanted(size) {
    const rows = new Map();
    this.#cells(size, (column, row) => {
      if (this.#agreed(column, row, size) !== UNKNOWN) return;
      for (const [c, r] of nine(column, row, size)) {
        if (this.solved[r * this.columns + c] !== 0) continue;
        if (!rows.has(r)) rows.set(r, new Set());
        rows.get(r).add(c);
      }
    });
    return new Map([...rows].map(([row, columns]) => [row, [...columns].sort((a, b) => a - b)]));
  }

  /** What is not solved takes what its cell agrees on; where it does not, its corner's. */
  #fill(size) {
    this.#cells(size, (column, row) => {
      const agreed = this.#agreed(column, row, size);
      const kind = agreed === UNKNOWN ? this.kinds[row * this.columns + column] : agreed;
      for (let r = row; r <= row + size; r++) {
        for (let c = column; c <= column + size; c++) {
          if (this.solved[r * this.columns + c] === 0) this.kinds[r * this.columns + c] = kind;
        }
      }
    });
  }

  /** @returns {number} UNKNOWN where solved points differ, or none is there */
  #agreed(column, row, size) {
    let agreed = UNKNOWN;
    for (const [c, r] of nine(column, row, size)) {
      const at = r * this.columns + c;
      if (this.solved[at] === 0) continue;
      if (agreed === UNKNOWN) agreed = this.kinds[at];
      else if (agreed !== this.kinds[at]) return UNKNOWN;
    }
    return agreed === UNKNOWN ? this.kinds[row * this.columns + column] : agreed;
  }

  #cells(size, visit) {
    for (let row = 0; row + size < this.rows; row += size) {
      for (let column = 0; column + size < this.columns; column += size) visit(column, row);
    }
  }
}

function everyEighth(count) {
  const found = [];
  for (let at = 0; at < count; at += COARSE) found.push(at);
  return found;
}

/** Rows of which the same columns are wanted are solved together. @param {Map<number, number[]>} wanted */
function alike(wanted) {
  const groups = new Map();
  for (const [row, columns] of wanted) {
    const key = columns.join();
    if (!groups.has(key)) groups.set(key, { rows: [], columns });
    groups.get(key).rows.push(row);
  }
  return groups.values();
}

/** Corners, middles of edges and centre of a cell. */
function nine(column, row, size) {
  const steps = [0, size / 2, size];
  return steps.flatMap((y) => steps.map((x) => [column + x, row + y]));
}
