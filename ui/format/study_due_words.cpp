// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/study_due_words.h"

#include "ui/format/date_text.h"

#include <algorithm>

namespace gripscope {

QString StudyDueWords::name(StudyKind kind)
{
    switch (kind) {
    case StudyKind::TypeOne:
        return tr("Type-1 study");
    case StudyKind::Gauge:
        return tr("Gauge study");
    case StudyKind::Linearity:
        return tr("Linearity study");
    case StudyKind::Attributes:
        return tr("Attribute study");
    case StudyKind::Transfer:
        return tr("Types on another gripper");
    }
    return {};
}

QString StudyDueWords::status(const StudyStanding& standing, const QDate& today, bool asked)
{
    switch (standing.status(today)) {
    case StudyStatus::Missing:
        return asked ? tr("due") : tr("not asked for");
    case StudyStatus::NotAsked:
        return tr("not to be repeated");
    case StudyStatus::Overdue:
        return tr("overdue since %1").arg(dateText(*standing.due));
    case StudyStatus::DueSoon:
        return tr("holds until %1: repeat it soon").arg(dateText(*standing.due));
    case StudyStatus::Valid:
        break;
    }
    return tr("holds until %1").arg(dateText(*standing.due));
}

QString StudyDueWords::brief(const std::vector<StudyStanding>& standings, const QDate& today)
{
    const StudyStanding* first = nullptr;
    for (const StudyStanding& standing : standings)
        if (standing.due && (first == nullptr || *standing.due < *first->due))
            first = &standing;
    if (first == nullptr)
        return {};
    const QString study = first->kind == StudyKind::TypeOne     ? tr("type-1 study")
                          : first->kind == StudyKind::Gauge     ? tr("gauge study")
                          : first->kind == StudyKind::Linearity ? tr("linearity study")
                                                                : tr("attribute study");
    const auto days = int(today.daysTo(*first->due));
    if (days < 0)
        return tr("%1 overdue since %2").arg(study, dateText(*first->due));
    if (days < 2)
        return tr("%1 due %2").arg(study, days == 0 ? tr("today") : tr("tomorrow"));
    return tr("%1 due in %n days", nullptr, days).arg(study);
}

QString StudyDueWords::lines(const std::vector<StudyStanding>& standings, const QDate& today)
{
    QStringList lines;
    for (const StudyStanding& standing : standings)
        if (standing.last)
            lines << tr("%1: %2.").arg(name(standing.kind), status(standing, today));
    return lines.isEmpty() ? tr("None of this gripper yet: the Quality page leads through them.")
                           : lines.join(QLatin1Char('\n'));
}

} // namespace gripscope
