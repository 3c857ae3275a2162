# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Where under PREFIX this Python looks for packages; where it looks nowhere there, where one with
that prefix would.

    site_folder.py PREFIX"""

import pathlib
import site
import sys
import sysconfig


def main(prefix):
    for folder in site.getsitepackages():
        # Debian's Python looks for its own packages in /usr, and for others' in /usr/local.
        if pathlib.Path(prefix) in pathlib.Path(folder).parents and (
                prefix != "/usr" or not folder.startswith("/usr/local/")):
            return folder
    return sysconfig.get_path("platlib", "posix_prefix", {"base": prefix, "platbase": prefix})


if __name__ == "__main__":
    print(main(sys.argv[1]))
