// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/study_words.h"

#include "ui/format/number_format.h"

namespace gripscope {

QString StudyWords::name(StudyKind kind)
{
    switch (kind) {
    case StudyKind::Gauge:
        return tr("Gauge repeatability and reproducibility");
    case StudyKind::TypeOne:
        return tr("Type-1 study");
    case StudyKind::Linearity:
        return tr("Linearity");
    case StudyKind::Attributes:
        return tr("Attribute agreement");
    case StudyKind::Transfer:
        return tr("Types on another gripper");
    }
    return {};
}

QString StudyWords::answer(StudyKind kind)
{
    switch (kind) {
    case StudyKind::Gauge:
        return tr("Does it tell parts apart, and is the scatter due to the gripper or to its operators?");
    case StudyKind::TypeOne:
        return tr("Does it find the value of one known part, again and again?");
    case StudyKind::Linearity:
        return tr("Is it as right for soft parts as for stiff ones?");
    case StudyKind::Attributes:
        return tr("Do people call the same parts good, and are they right?");
    case StudyKind::Transfer:
        return tr("Do types that were enrolled on another gripper serve here, and by which adjustment?");
    }
    return {};
}

SettingKey<double> StudyWords::repeatMonths(StudyKind kind)
{
    switch (kind) {
    case StudyKind::TypeOne:
        return setting::typeOneMonths;
    case StudyKind::Linearity:
        return setting::linearityMonths;
    case StudyKind::Attributes:
        return setting::attributesMonths;
    case StudyKind::Gauge:
    case StudyKind::Transfer: // led through by itself; the calendar does not ask for it
        break;
    }
    return setting::gaugeMonths;
}

QString StudyWords::state(const StudyRecord& study, std::size_t planned)
{
    switch (study.state) {
    case StudyState::Open:
        return tr("unfinished: %1 of %2").arg(formatCount(study.measurements), formatCount(qint64(planned)));
    case StudyState::Finished:
        return tr("finished");
    case StudyState::Abandoned:
        return tr("given up");
    }
    return {};
}

} // namespace gripscope
