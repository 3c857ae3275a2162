# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""An independent reader of printed formulas: into Python, evaluated in rationals.

Shares nothing with Topple's parser: letters are told apart by a regular expression and products
that are not written are put in by a look at neighbouring tokens."""

import re
from fractions import Fraction

GREEK = {"α": "alpha", "δ": "delta", "Δ": "d", "λ": "lambda_", "φ": "phi", "σ": "sigma", "·": "*",
         "−": "-", "°": ""}
FUNCTIONS = ("tan^-1", "tan^{-1}", "sin", "cos", "tan", "sqrt")


def tokens(text, names):
    """Numbers, functions, names (the longest first) and operators of a printed formula."""
    for letter, spelt in GREEK.items():
        text = text.replace(letter, spelt)
    text = text.replace("lambda ", "lambda_ ") if "lambda_" not in text else text
    words = [re.escape(w) for w in FUNCTIONS + tuple(sorted(names, key=len, reverse=True))]
    pattern = re.compile(r"\s*(\d+(?:\.\d+)?|" + "|".join(words) + r"|[-+*/^()])")
    at, found = 0, []
    while at < len(text.rstrip()):
        match = pattern.match(text, at)
        if not match:
            raise ValueError(f"cannot read {text[at:]!r}")
        found.append(match.group(1))
        at = match.end()
    return found


def python(text, names):
    """The formula as a Python expression; f_sin(x) and the like take angles as names or sums."""
    out, previous = [], None
    stack = tokens(text, names)
    pending = 0  # a function without brackets: its argument is the next token
    for token in stack:
        operand = token[0].isalnum() and token not in FUNCTIONS
        begins = operand or token in FUNCTIONS or token == "("
        ended = previous is not None and (previous == ")" or (previous[0].isalnum()
                                                             and previous not in FUNCTIONS))
        if begins and ended:
            out.append("*")
        if token in FUNCTIONS:
            out.append({"tan^-1": "f_inverse", "tan^{-1}": "f_inverse"}.get(token, "f_" + token))
        elif token[0].isdigit():
            out.append(f"(Fraction('{token}'))" if previous in FUNCTIONS else f"Fraction('{token}')")
        elif operand:
            out.append(f"({token})" if previous in FUNCTIONS else token)
        else:
            out.append("**" if token == "^" else token)
        previous = token
    return "".join(out)


class Angle:
    """An angle by a rational sine and cosine."""

    def __init__(self, half):
        """tan of the half angle."""
        half = Fraction(half)
        self.sin, self.cos = 2 * half / (1 + half**2), (1 - half**2) / (1 + half**2)

    def complement(self):
        """90 degrees less this angle."""
        other = Angle(0)
        other.sin, other.cos = self.cos, self.sin
        return other

    def __add__(self, degrees):
        assert degrees == 90
        other = Angle(0)
        other.sin, other.cos = self.cos, -self.sin
        return other

    def __truediv__(self, two):
        """Half the angle, of which only the tangent is asked for."""
        assert two == 2
        return ("half", self.sin / (1 + self.cos))


def evaluate(text, values):
    """A printed formula at rational values; tan^-1 of anything but an angle is left as what it is
    taken of, so that critical angles are compared by their tangents."""
    functions = {"Fraction": Fraction, "__builtins__": {},
                 "f_sin": lambda x: x.sin, "f_cos": lambda x: x.cos,
                 "f_tan": lambda x: x[1] if isinstance(x, tuple) else x.sin / x.cos,
                 "f_inverse": lambda x: x.cos / x.sin if isinstance(x, Angle) else x}
    code = python(text, [n for n in values])
    return eval(code, functions, values)
