# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A calculation sheet as a reader of HTML has it: a tree whose elements all close, its tables, its headings, and its
equations, which are recomputed by intervals. It shares nothing with the program."""

import html.parser
import math
import re
import xml.etree.ElementTree as ElementTree

VOID = {"meta", "img", "link", "br", "hr", "input"}
ULP = 0.5


class Page(html.parser.HTMLParser):
    """The tree of a page. An element that does not close where it must is an error."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.root = ElementTree.Element("page")
        self.open = [self.root]
        self.feed(text)
        self.close()
        if self.open != [self.root]:
            raise ValueError(f"<{self.open[-1].tag}> does not close")

    def handle_starttag(self, tag, attrs):
        names = [name for name, _ in attrs]
        if len(set(names)) != len(names):
            raise ValueError(f"<{tag}> has an attribute twice")
        element = ElementTree.SubElement(self.open[-1], tag, {name: value or "" for name, value in attrs})
        if tag not in VOID:
            self.open.append(element)

    def handle_startendtag(self, tag, attrs):
        raise ValueError(f"<{tag}/> is no HTML")

    def handle_endtag(self, tag):
        if self.open[-1].tag != tag:
            raise ValueError(f"</{tag}> within <{self.open[-1].tag}>")
        self.open.pop()

    def handle_data(self, data):
        element = self.open[-1]
        if len(element):
            element[-1].tail = (element[-1].tail or "") + data
        else:
            element.text = (element.text or "") + data

    def all(self, *tags):
        return [element for element in self.root.iter() if element.tag in tags]

    def tables(self, caption):
        """The tables of that caption: lists of rows of texts, the heads first where there are any."""
        return [[[words(cell) for cell in row if cell.tag in ("th", "td")] for row in table.iter("tr")]
                for table in self.all("table") if words(table.find("caption")).startswith(caption)]

    def facts(self, caption):
        return dict(row for table in self.tables(caption) for row in table)

    def lines(self):
        """Each line of an equation: the texts of its sides, with their values where they hold numbers alone."""
        return [sides(math_element) for math_element in self.all("math")]


def words(element):
    return re.sub(r"\s+", " ", "".join(element.itertext()).replace("▶", "")).strip()


def number(text):
    """A printed number, and half a unit of its last digit: zeros at its end are not printed, but three decimals or six
    digits there are, whichever are fewer."""
    text = text.replace("°", "").replace("−", "-").strip("()")
    found = re.match(r"^[^-\d]*(-?\d+(?:\.(\d+))?(?:e([-+]\d+))?)(?:\s|$|[^\d.])", text + " ")
    if found is None:
        raise ValueError(f"no number in {text!r}")
    value, power = float(found.group(1)), int(found.group(3) or 0)
    shown = len(found.group(2) or "") - power
    if found.group(3) is not None:
        return value, ULP * 10.0 ** -shown
    digits = 5 - math.floor(math.log10(abs(value))) if value else 3
    return value, ULP * 10.0 ** -max(shown, min(3, digits))


class Interval:
    """All that a number can be, of which so many digits are printed."""

    def __init__(self, low, high):
        self.low, self.high = min(low, high), max(low, high)

    @classmethod
    def printed(cls, text):
        value, half = number(text)
        return cls(value - half, value + 2 * half)  # a factor of safety is rounded down

    @classmethod
    def around(cls, values):
        values = list(values)
        room = 1e-13 * max(abs(v) for v in values)
        return cls(min(values) - room, max(values) + room)

    def __add__(self, other):
        return Interval(self.low + other.low, self.high + other.high)

    def __neg__(self):
        return Interval(-self.high, -self.low)

    def __mul__(self, other):
        return Interval.around(a * b for a in (self.low, self.high) for b in (other.low, other.high))

    def __truediv__(self, other):
        if other.low <= 0 <= other.high:
            raise ZeroDivisionError
        return Interval.around(a / b for a in (self.low, self.high) for b in (other.low, other.high))

    def meets(self, other):
        return self.low <= other.high and other.low <= self.high


def function(name, values):
    """Of degrees, each monotonic over what a number leaves open."""
    a = values[0]
    if name == "arctan":
        return Interval.around(math.degrees(math.atan(v)) for v in (a.low, a.high))
    if name == "min":
        return Interval(min(v.low for v in values), min(v.high for v in values))
    return Interval.around(getattr(math, name)(math.radians(v)) for v in (a.low, a.high))


class Symbol(Exception):
    """A side that has a letter in it."""


class Reckoning:
    """The value of a row of MathML."""

    def __init__(self, elements):
        self.elements, self.at = elements, 0

    def peek(self):
        return self.elements[self.at] if self.at < len(self.elements) else None

    def sign(self):
        element = self.peek()
        return words(element) if element is not None and element.tag == "mo" else None

    def sum(self):
        negative = self.sign() in ("−", "-")
        self.at += negative
        value = -self.product() if negative else self.product()
        while self.sign() in ("+", "−", "-"):
            minus = self.sign() != "+"
            self.at += 1
            value = value + (-self.product() if minus else self.product())
        return value

    def product(self):
        value = self.factor()
        while self.peek() is not None and self.sign() in (None, "·"):
            self.at += self.sign() == "·"
            value = value * self.factor()
        return value

    def arguments(self):
        """Of a function: a list in brackets, or the factor that follows."""
        if self.sign() != "(":
            return [self.factor()]
        self.at += 1
        values = [self.sum()]
        while self.sign() == ",":
            self.at += 1
            values.append(self.sum())
        if self.sign() != ")":
            raise ValueError("a bracket does not close")
        self.at += 1
        return values

    def factor(self):
        element = self.peek()
        if element is None:
            raise ValueError("a number is missing")
        self.at += 1
        if element.tag == "mspace":
            return self.factor()
        if element.tag == "mn":
            return Interval.printed(words(element))
        if element.tag == "mrow":
            return row(element)
        if element.tag == "mfrac":
            return row(element[0]) / row(element[1])
        if element.tag == "mo" and words(element) == "(":
            self.at -= 1
            return self.arguments()[0]
        if element.tag == "mi" and words(element) in ("tan", "sin", "cos", "arctan", "min"):
            if self.peek() is not None and self.peek().tag == "mspace":
                self.at += 1
            return function(words(element), self.arguments())
        raise Symbol(words(element))


def row(element):
    own = Reckoning(list(element))
    value = own.sum()
    if own.peek() is not None:
        raise Symbol(words(own.peek()))
    return value


def sides(math_element):
    """(text, value or None) of each side of an equation."""
    parts = [[]]
    for element in math_element[0]:
        if element.tag == "mo" and words(element) == "=":
            parts.append([])
        else:
            parts[-1].append(element)
    told = []
    for part in parts:
        text = " ".join(words(element) for element in part)
        holder = ElementTree.Element("mrow")
        holder.extend(part)
        try:
            told.append((text, row(holder)))
        except Symbol:
            told.append((text, None))
    return told
