// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/layout_audit.h"
#include "ui/theme/theme.h"
#include "ui/widgets/message_bar.h"

#include <QCoreApplication>
#include <QDialog>
#include <QMap>
#include <QPixmap>

#include <algorithm>
#include <vector>

namespace gripscope::test {

/// A theme, and its name in findings.
using NamedTheme = std::pair<ThemeKind, const char*>;

inline const std::vector<NamedTheme> everyTheme{
    {ThemeKind::Light, "light"}, {ThemeKind::Dark, "dark"}, {ThemeKind::HighContrast, "contrast"}};
inline const std::vector<QSize> everySize{{2048, 1280}, {1440, 900}, {1024, 640}};
constexpr QSize leastSize{1024, 640};

inline void settleLayout()
{
    for (int i = 0; i < 3; ++i) // what wraps asks its parent for another height
        QCoreApplication::processEvents();
}

/// What is wrong with `top` as it stands. Colours depend on neither size nor scale: they are looked at in
/// small pictures.
[[nodiscard]] inline QStringList findingsNow(QWidget& top)
{
    const bool small = top.width() <= leastSize.width() && top.devicePixelRatioF() == 1;
    return LayoutAudit::of(top) + PaintedAudit::of(top, small ? top.grab().toImage() : QImage());
}

/// Collects findings over states, themes, sizes and messages, and tells each once.
class LayoutWalk {
public:
    explicit LayoutWalk(QWidget& top) : m_top(&top) {}

    /// `where`: the state, and how it is looked at. For eyes: with GRIPSCOPE_LOOKS=FOLDER a picture of each.
    void look(const QString& where)
    {
        if (const QString folder = qEnvironmentVariable("GRIPSCOPE_LOOKS"); !folder.isEmpty())
            m_top->grab().save(QStringLiteral("%1/%2 %3.png")
                                   .arg(folder, QString(where).replace(u'/', u'-'), QLocale().name()));
        for (const QString& finding : findingsNow(*m_top))
            note(finding, where);
    }
    /// In every theme. With a message too, where there is one.
    void inAll(const QString& state, const std::vector<QSize>& sizes, const QString& message = {})
    {
        in(state, {{everyTheme[0], sizes}, {everyTheme[1], sizes}, {everyTheme[2], sizes}}, message);
    }
    /// One of the many states of a page that was met in every theme and size: where it is tightest, and where
    /// lines are thickest.
    void whereTight(const QString& state)
    {
        in(state, {{everyTheme[0], {{1440, 900}, leastSize}}, {everyTheme[2], {leastSize}}});
    }
    /// Tells what was found; false where there is any.
    [[nodiscard]] bool sound() const
    {
        for (auto finding = m_where.begin(); finding != m_where.end(); ++finding)
            qWarning("%s (%s)", qPrintable(finding.key()), qPrintable(finding->join(QStringLiteral("; "))));
        return m_where.isEmpty();
    }

private:
    using Looks = std::vector<std::pair<NamedTheme, std::vector<QSize>>>;

    /// The theme in force comes first: to give a window another takes longer than to look at it.
    void in(const QString& state, Looks looks, const QString& message = {})
    {
        std::ranges::stable_partition(looks, [now = Theme::instance().tokens().kind](const auto& look) {
            return look.first.first == now;
        });
        for (const auto& [theme, sizes] : looks)
            lookIn(state, theme, sizes, message);
    }
    void lookIn(const QString& state, const NamedTheme& theme, const std::vector<QSize>& sizes,
                const QString& message)
    {
        Theme::instance().apply(theme.first);
        auto* bar = message.isEmpty() ? nullptr : m_top->findChild<MessageBar*>();
        for (const QSize size : sizes) {
            const QString where =
                QStringLiteral("%1, %2 %3").arg(state, QLatin1String(theme.second)).arg(size.width());
            m_top->resize(size);
            settleLayout();
            look(where);
            if (!bar)
                continue;
            bar->show(message);
            settleLayout();
            look(where + QStringLiteral(" with a message"));
            if (m_top->size() != size) // the screen may have no more
                note(QStringLiteral("is %1 x %2").arg(m_top->width()).arg(m_top->height()), where);
            bar->dismiss();
        }
    }
    void note(const QString& finding, const QString& where)
    {
        if (QStringList& places = m_where[finding]; !places.contains(where))
            places << where;
    }
    QWidget* m_top;
    QMap<QString, QStringList> m_where;
};

} // namespace gripscope::test
