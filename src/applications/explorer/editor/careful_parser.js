// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A parser for the colours of a text, which leaves without colours what is nested too deeply for it: it descends as the
 * text does, and a browser's stack holds some ten thousand levels.
 */

import { NodeType, Parser, Tree } from "@lezer/common";

class CarefulParse {
  /** @param {import("@lezer/common").PartialParse} parse @param {number} length of the text */
  constructor(parse, length) {
    this.parse = parse;
    this.length = length;
  }

  get parsedPos() {
    return this.parse.parsedPos;
  }

  get stoppedAt() {
    return this.parse.stoppedAt;
  }

  stopAt(position) {
    this.parse.stopAt(position);
  }

  advance() {
    try {
      return this.parse.advance();
    } catch (error) {
      if (!(error instanceof RangeError) && error.name !== "InternalError") throw error; // as Firefox names it
      return new Tree(NodeType.none, [], [], this.length);
    }
  }
}

export class CarefulParser extends Parser {
  /** @param {Parser} parser */
  constructor(parser) {
    super();
    this.parser = parser;
  }

  createParse(input, fragments, ranges) {
    return new CarefulParse(this.parser.createParse(input, fragments, ranges), input.length);
  }
}
