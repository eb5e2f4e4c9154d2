// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace gripscope {

/// Names come from grippers, files and people. Qt takes a text for markup wherever it looks like some, and
/// then opens the files that it names. In this program a text is plain; what is marked up is written by the
/// program itself and made here. (A check at configure time keeps markup out of all other files.)

/// Makes every label plain that does not say otherwise, message boxes' and tooltips' too, from now on. Once
/// an application; further calls do nothing.
void keepTextPlain();

/// A label whose text is markup. Whoever writes it escapes (QString::toHtmlEscaped) what is not the program's
/// own.
[[nodiscard]] QLabel* makeMarkedLabel(const QString& html, const char* role = "", QWidget* parent = nullptr);

/// For actions, buttons and check boxes, where an ampersand marks a key.
[[nodiscard]] QString withoutKeys(const QString& text);
/// For a window's title, where "[*]" stands for changes and a long name for nothing.
[[nodiscard]] QString titleText(const QString& text);

} // namespace gripscope
