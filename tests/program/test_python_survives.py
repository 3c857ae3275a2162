# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""No scene ends a program that calls the library. The story: a face that dips by 1e-12 degrees, or ground behind the crest that is
flatter than the base by 1e-9, was divided by zero in FLINT, which aborts: SIGABRT ended the interpreter with all that it held. Every
number of the scenes in tests/data/swept is changed to extremes, in this one process."""

import unittest
import warnings

from harness import main
from python_case import topple
from swept_case import FOLDER, swept


def ask(text, name):
    """Solve it by the call of its kind; True where that has an answer."""
    try:
        scene = topple.Scene.from_text(text, str(FOLDER / name))
        if any(f"\n{key}:" in text for key in ("blocks", "columns", "jointed_slope")):
            scene.solve_block_system()
        elif "\nsolid:" in text:
            scene.solve_solid()
        elif "\ncases:" in text:
            scene.solve_load_cases()
        else:
            scene.solve()
    except topple.ToppleError as error:
        if not str(error):
            raise AssertionError(f"a refusal without words: {text}") from error
        return False
    return True


class Survives(unittest.TestCase):
    def test_scenes_as_they_are(self):
        for path in FOLDER.glob("*.yaml"):
            self.assertTrue(ask(path.read_text(encoding="utf-8"), path.name), path)

    def test_swept(self):
        warnings.simplefilter("ignore")
        asked = answered = 0
        for path, text in swept(12, 300):
            asked += 1
            answered += ask(text, path.name)
        print(f"{asked} scenes, {answered} of them solved, in one process")
        self.assertGreater(answered, asked / 10)
        self.assertGreater(asked - answered, asked / 10)


if __name__ == "__main__":
    main()
