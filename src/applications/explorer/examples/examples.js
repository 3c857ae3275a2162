// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The project's examples with the files that they name, packed in the page: meshes of theirs are long. */

import packed from "topple:examples";
import { unpacked } from "../core/packed.js";

/** @type {{name: string, group: string, title: string, text: string, files: Record<string, string>}[]} */
export const examples = await new Response(unpacked(packed)).json();
