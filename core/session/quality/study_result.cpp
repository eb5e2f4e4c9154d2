// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_result.h"

#include "core/base/words.h"
#include "core/session/quality/study_verdict.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<StudyResult> gaugeFound(const KeptStudy& study)
{
    ASSIGN_OR_RETURN(GaugeResult found, gaugeResult(study));
    Findings verdict = studyVerdict(found.study);
    return StudyResult{std::move(found), std::move(verdict)};
}

Expected<StudyResult> typeOneFound(const KeptStudy& study)
{
    TypeOneResult found;
    const std::optional<double> tolerance = study.options.tolerances[std::size_t(study.plan.design.quantity)];
    if (!tolerance)
        return failure(ErrorCode::Usage, {Words::say("A type-1 study needs the tolerance of its quantity.")});
    ASSIGN_OR_RETURN(found.readings, referencedReadings(study));
    found.options.reference = found.readings.references.front();
    found.options.tolerance = *tolerance;
    found.options.quantity = found.readings.quantity;
    ASSIGN_OR_RETURN(found.study, studyTypeOne(found.readings.values, found.options));
    Findings verdict = found.study.messages;
    return StudyResult{std::move(found), std::move(verdict)};
}

Expected<StudyResult> linearityFound(const KeptStudy& study)
{
    LinearityResult found;
    ASSIGN_OR_RETURN(found.readings, referencedReadings(study));
    LinearityOptions options;
    options.quantity = found.readings.quantity;
    ASSIGN_OR_RETURN(found.study, studyLinearity(found.readings.references, found.readings.values, options));
    Findings verdict = found.study.messages;
    return StudyResult{std::move(found), std::move(verdict)};
}

Expected<StudyResult> agreementFound(const KeptStudy& study)
{
    RatingColumns columns;
    columns.part = u"part"_s;
    columns.rater = u"operator"_s; // who was there, where the plan names nobody
    columns.verdict = u"rating"_s;
    if (!study.plan.design.references.isEmpty())
        columns.reference = u"reference"_s;
    ASSIGN_OR_RETURN(const AttributeRatings ratings, readRatings(studyTable(study), columns));
    ASSIGN_OR_RETURN(AttributeAgreement found, studyAgreement(ratings));
    Findings verdict = found.messages;
    return StudyResult{std::move(found), std::move(verdict)};
}

Expected<StudyResult> foundOf(const KeptStudy& study)
{
    switch (study.plan.design.kind) {
    case StudyKind::Gauge:
        return gaugeFound(study);
    case StudyKind::TypeOne:
        return typeOneFound(study);
    case StudyKind::Linearity:
        return linearityFound(study);
    case StudyKind::Attributes:
        return agreementFound(study);
    case StudyKind::Transfer:
        break;
    }
    return failure(ErrorCode::Usage, {Words::say("Types on another gripper are judged squeeze by squeeze.")});
}

} // namespace

Expected<StudyResult> resultOf(const KeptStudy& study)
{
    if (study.counted().empty())
        return failure(ErrorCode::BadInput, {Words::say("The study %1").arg(study.record.study.name),
                                             Words::say("nothing that counts was measured"),
                                             Words::say("a squeeze or a verdict of every part")});
    ASSIGN_OR_RETURN(StudyResult result, foundOf(study));
    const StudyProgress progress = study.progress();
    result.left = progress.left();
    result.skipped = progress.skipped;
    result.repeated = progress.repeated;
    return result;
}

} // namespace gripscope
