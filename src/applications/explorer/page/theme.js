// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Light and dark: as the system has it, or chosen. Nothing is kept beyond the page. */

/** @param {HTMLSelectElement} select */
export function themeSwitch(select) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    const chosen = select.value === "auto" ? (dark.matches ? "dark" : "light") : select.value;
    document.documentElement.dataset.theme = chosen;
  };
  select.addEventListener("change", apply);
  dark.addEventListener("change", apply);
  apply();
}
