// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/recordings/verdict_output.h"

#include "app/cli/line/output.h"
#include "core/base/json_value.h"
#include "core/quality/conformity/conformity_json.h"

#include <QJsonArray>

#include <cmath>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

QJsonObject verdictJson(const QString& file, const Verdict& verdict)
{
    QJsonObject posterior;
    for (auto it = verdict.posterior.cbegin(); it != verdict.posterior.cend(); ++it)
        posterior[it.key()] = jsonNumber(it.value());
    return {{u"file"_qs, file},
            {u"verdict"_qs, toString(verdict.kind)},
            {u"type"_qs, jsonText(verdict.type)},
            {u"nearest"_qs, jsonText(verdict.nearest)},
            {u"posterior"_qs, posterior},
            {u"distance"_qs, jsonNumber(verdict.distance)},
            {u"gate"_qs, jsonNumber(verdict.gate)},
            {u"rival"_qs, jsonText(verdict.rival)},
            {u"times_longer"_qs, jsonNumber(verdict.timesLonger)},
            {u"stranger_posterior"_qs, jsonNumber(verdict.strangerPosterior)},
            {u"stranger_accept"_qs, jsonNumber(verdict.strangerAccept)},
            {u"samples_used"_qs, static_cast<qint64>(verdict.samplesUsed)},
            {u"conformity"_qs,
             verdict.conformity ? QJsonValue(conformityJson(*verdict.conformity)) : QJsonValue()},
            {u"validity"_qs, toString(verdict.validity.verdict)},
            {u"checks_failed"_qs, QJsonArray::fromStringList(verdict.validity.checksFailed)},
            {u"reasons"_qs, QJsonArray::fromStringList(described(verdict.allReasons()))}};
}

QString verdictText(const QString& file, const Verdict& verdict)
{
    QString text = u"%1: %2"_qs.arg(file, toString(verdict.kind));
    if (verdict.kind == VerdictKind::Type)
        text += u" %1 (posterior %2)"_qs.arg(verdict.type,
                                             QString::number(verdict.posterior.value(verdict.type), 'f', 4));
    else if (!verdict.nearest.isEmpty())
        text += u", nearest %1"_qs.arg(verdict.nearest);
    if (verdict.conformity)
        text += u", "_qs + inWords(verdict.conformity->decision).english();
    if (verdict.distance && verdict.gate)
        text += u"; %1 sd away, gate %2 sd"_qs.arg(QString::number(std::sqrt(*verdict.distance), 'f', 1),
                                                   QString::number(std::sqrt(*verdict.gate), 'f', 1));
    if (verdict.validity.verdict == ValidityVerdict::Suspect)
        text += u"; the measurement is suspect (%1)"_qs.arg(verdict.validity.checksFailed.join(u", "_qs));
    for (const QString& reason : described(verdict.allReasons()))
        text += u"\n    "_qs + reason;
    return text;
}

} // namespace gripscope::cli
