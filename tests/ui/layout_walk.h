// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/layout_audit.h"
#include "ui/theme/theme.h"

#include <QCoreApplication>
#include <QMap>

#include <vector>

namespace gripscope::test {

/// A theme, and its name in findings.
using NamedTheme = std::pair<ThemeKind, const char*>;

/// Audits `top` in these themes at these sizes, and warns of each finding once; false where there is any.
[[nodiscard]] inline bool soundIn(QWidget& top, const QString& state, const std::vector<NamedTheme>& themes,
                                  const std::vector<QSize>& sizes)
{
    QMap<QString, QStringList> where;
    for (const auto& [theme, name] : themes) {
        Theme::instance().apply(theme);
        for (const QSize size : sizes) {
            top.resize(size);
            QCoreApplication::processEvents();
            QCoreApplication::processEvents();
            for (const QString& finding : LayoutAudit::of(top))
                where[finding] << QStringLiteral("%1 %2").arg(QLatin1String(name)).arg(size.width());
        }
    }
    Theme::instance().apply(ThemeKind::Light);
    for (auto finding = where.begin(); finding != where.end(); ++finding)
        qWarning("%s %s (%s)", qPrintable(state), qPrintable(finding.key()),
                 qPrintable(finding->join(QStringLiteral(", "))));
    return where.isEmpty();
}

[[nodiscard]] inline bool soundInAll(QWidget& top, const QString& state, const std::vector<QSize>& sizes)
{
    return soundIn(
        top, state,
        {{ThemeKind::Light, "light"}, {ThemeKind::Dark, "dark"}, {ThemeKind::HighContrast, "contrast"}},
        sizes);
}

} // namespace gripscope::test
