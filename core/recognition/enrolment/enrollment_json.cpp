// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_value.h"
#include "core/recognition/enrolment/enrollment_guidance.h"

#include <QJsonArray>
#include <QJsonObject>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject boundsJson(const BinomialEvidence& evidence)
{
    return {{u"failures"_s, qint64(evidence.failures)},
            {u"trials"_s, qint64(evidence.trials)},
            {u"lowest"_s, evidence.lowest},
            {u"highest"_s, evidence.highest}};
}

} // namespace

QJsonObject toJson(const EnrollmentProgress& progress)
{
    return {{u"squeezes"_s, progress.squeezes},
            {u"more_for_gate"_s, progress.moreForGate},
            {u"gate"_s, jsonNumber(progress.gate)},
            {u"gate_limit"_s, jsonNumber(progress.gateLimit)},
            {u"strangers_passing"_s, jsonNumber(progress.strangersPassing)},
            {u"strangers_limit"_s, jsonNumber(progress.strangersLimit)},
            {u"more_for_most"_s, progress.moreForMost ? QJsonValue(*progress.moreForMost) : QJsonValue()},
            {u"stiffness_uncertainty"_s, jsonNumber(progress.stiffnessUncertainty)},
            {u"words"_s, QJsonArray::fromStringList(english(inWords(progress)))}};
}

QJsonObject toJson(const SqueezeOutlier& outlier)
{
    const bool alone = outlier.parameter >= 0;
    return {{u"deviations"_s, jsonNumber(outlier.deviations)},
            {u"chance"_s, jsonNumber(outlier.chance)},
            {u"parameter"_s, alone ? QJsonValue(symbolOf(TypeQuantity(outlier.parameter))) : QJsonValue()},
            {u"reason"_s, outlier.reason.english()}};
}

QJsonObject toJson(const TypeOverlap& overlap)
{
    return {{u"other"_s, overlap.other},
            {u"undecided"_s, overlap.undecided},
            {u"wrong"_s, overlap.wrong},
            {u"undecided_of_other"_s, overlap.back},
            {u"words"_s, inWords(overlap).english()}};
}

QJsonObject toJson(const HeldOutConfusion& confusion)
{
    QJsonObject table;
    const QStringList columns = confusion.types + QStringList{u"unknown"_s, u"inconclusive"_s};
    for (qsizetype row = 0; row < confusion.types.size(); ++row) {
        QJsonObject counts;
        for (qsizetype column = 0; column < columns.size(); ++column)
            if (const int count = confusion.counts(row, column); count > 0)
                counts.insert(columns[column], count);
        table.insert(confusion.types[row], counts);
    }
    return {{u"confusion"_s, table},
            {u"squeezes"_s, confusion.squeezes},
            {u"parts"_s, confusion.parts},
            {u"untested"_s, confusion.untested},
            {u"wrong_type"_s, boundsJson(confusion.wrongType)},
            {u"unknown"_s, boundsJson(confusion.unknown)}};
}

} // namespace gripscope
