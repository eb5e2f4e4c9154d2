// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// Whether a text could steer what shows it instead of being shown: control characters (a terminal obeys
/// them), marks that turn the direction of writing, line ends of Unicode, halves of a surrogate pair.
[[nodiscard]] bool isSteering(const QString& text, qsizetype at);

/// Names and other texts of devices, files and people for a message: what steers is written out (\x1b, \n,
/// \u202e), and of more than `most` characters the middle is left out.
[[nodiscard]] QString printable(const QString& text, qsizetype most);
/// The same with line ends and tabs as they are: for advice of several lines, and for whole output, of which
/// nothing is left out.
[[nodiscard]] QString printableLines(const QString& text, qsizetype most);
[[nodiscard]] QString printableLines(const QString& text);

/// Of a value that is quoted in a message.
inline constexpr qsizetype longestQuote = 80;
/// Of an argument of a message: paths and lists of names are long.
inline constexpr qsizetype longestArgument = 600;

} // namespace gripscope
