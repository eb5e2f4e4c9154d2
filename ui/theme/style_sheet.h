// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme/theme.h"

#include <QString>
#include <QTemporaryDir>

namespace gripscope {

/// The one style sheet of the program, made from the tokens. Widgets choose a look by dynamic properties:
///   QPushButton  role = "primary" | "quiet" | "stop"
///   QFrame       role = "card" | "bar" | "rail" | "rule" | "message"
///   QLabel       role = "heading" | "title" | "caption" | "number" | "big-number" | "strong" | "second" |
///   "error"
/// setRole() in ui/widgets/controls.h sets the property and repolishes.
class StyleSheet {
public:
    [[nodiscard]] QString text(const ThemeTokens& tokens);

private:
    /// Style sheets take pictures only from files: the few signs they need are written in the colours in
    /// force.
    QString sign(const QString& name, const QString& path, const QColor& color);
    QString buttons(const ThemeTokens& t) const;
    QString inputs(const ThemeTokens& t);
    QString views(const ThemeTokens& t) const;
    QString texts(const ThemeTokens& t) const;
    QString frames(const ThemeTokens& t) const;
    QTemporaryDir m_signs;
    int m_version = 0;
};

} // namespace gripscope
