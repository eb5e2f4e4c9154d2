// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace gripscope {

/// A page of the manual that is compiled in (resources/manual), in the language in force.
struct ManualPage {
    QString file; ///< "inspect.md"
    QString title, text;
};

/// Where a page is, ":/manual/de/inspect.md": in English where the language has no page of its own.
[[nodiscard]] QString manualPath(const QString& file);
/// All pages in the order of the table of contents, which comes first.
[[nodiscard]] std::vector<ManualPage> manualPages();
/// Whether all of these words, or beginnings of words, stand on the page.
[[nodiscard]] bool speaksOf(const ManualPage& page, const QString& words);
/// The page about a screen, by the screen's id; the contents where it has none.
[[nodiscard]] QString manualPageFor(const QString& screen);

} // namespace gripscope
