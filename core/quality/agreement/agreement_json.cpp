// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_value.h"
#include "core/quality/agreement/attribute_agreement.h"

#include <QJsonArray>
#include <QJsonObject>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonValue limitsJson(const AgreementShare& share)
{
    if (share.of == 0)
        return QJsonValue::Null;
    return QJsonArray{share.lower, share.upper};
}

QJsonObject shareJson(const AgreementShare& share)
{
    return {{u"value"_s, jsonNumber(share.value())},
            {u"interval"_s, limitsJson(share)},
            {u"count"_s, qint64(share.count)},
            {u"of"_s, qint64(share.of)}};
}

QJsonObject kappaJson(const CohenKappa& kappa)
{
    return {{u"value"_s, jsonNumber(kappa.value)},
            {u"standard_error"_s, jsonNumber(kappa.standardError)},
            {u"agreement"_s, jsonNumber(kappa.agreement)},
            {u"pairs"_s, qint64(kappa.pairs)}};
}

QJsonObject kappaJson(const FleissKappa& kappa, const QStringList& classes)
{
    QJsonObject each;
    for (const ClassKappa& one : kappa.classes)
        each[classes[one.verdict]] = QJsonObject{
            {u"share"_s, one.share}, {u"value"_s, jsonNumber(one.value)}, {u"z"_s, jsonNumber(one.z)}};
    return {{u"value"_s, jsonNumber(kappa.value)},
            {u"standard_error"_s, jsonNumber(kappa.standardError)},
            {u"z"_s, jsonNumber(kappa.z)},
            {u"p"_s, jsonNumber(kappa.p)},
            {u"parts"_s, qint64(kappa.parts)},
            {u"ratings"_s, qint64(kappa.ratings)},
            {u"classes"_s, each}};
}

QJsonObject raterJson(const RaterAgreement& rater, const QStringList& classes)
{
    return {{u"ratings"_s, qint64(rater.ratings)},
            {u"repeatability"_s, shareJson(rater.repeatability)},
            {u"within"_s, kappaJson(rater.within, classes)},
            {u"effectiveness"_s, jsonNumber(rater.effectiveness.value())},
            {u"interval"_s, limitsJson(rater.effectiveness)},
            {u"correct_rate"_s, jsonNumber(rater.correct.value())},
            {u"miss_rate"_s, jsonNumber(rater.misses.value())},
            {u"false_alarm_rate"_s, jsonNumber(rater.falseAlarms.value())},
            {u"undecided_rate"_s, jsonNumber(rater.undecided.value())}};
}

} // namespace

QJsonObject toJson(const AttributeAgreement& study)
{
    QJsonObject raters, reference;
    for (const RaterAgreement& rater : study.raters) {
        raters[rater.name] = raterJson(rater, study.classes);
        reference[rater.name] = kappaJson(rater.reference);
    }
    QJsonArray pairs;
    for (const RaterPair& pair : study.pairs) {
        QJsonObject kappa = kappaJson(pair.kappa);
        kappa[u"raters"_s] = QJsonArray{study.raters[pair.first].name, study.raters[pair.second].name};
        pairs.append(kappa);
    }
    return {
        {u"raters"_s, raters},
        {u"kappa"_s, QJsonObject{{u"pairs"_s, pairs},
                                 {u"reference"_s, study.hasReference ? QJsonValue(reference) : QJsonValue()},
                                 {u"fleiss"_s, kappaJson(study.fleiss, study.classes)}}},
        {u"agreement"_s, shareJson(study.all)},
        {u"agreement_with_reference"_s,
         study.hasReference ? QJsonValue(shareJson(study.allRight)) : QJsonValue()},
        {u"accepted"_s, jsonText(study.accepted)},
        {u"undecided"_s, jsonText(study.undecided)},
        {u"classes"_s, QJsonArray::fromStringList(study.classes)},
        {u"incomplete_parts"_s, qint64(study.incomplete)},
        {u"messages"_s, QJsonArray::fromStringList(english(study.messages))}};
}

} // namespace gripscope
