# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors

# What cffi makes of the public headers: typed by C, not for Python.
from typing import Any

ffi: Any
lib: Any
