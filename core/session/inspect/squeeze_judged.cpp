// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/squeeze_judged.h"

#include "core/base/csv.h"
#include "core/library/records/determined_text.h"
#include "core/session/squeeze/squeeze_notes.h"

#include <QMap>
#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString noteTitle()
{
    return QString::fromLatin1(squeezeJudgedNote.data(), static_cast<qsizetype>(squeezeJudgedNote.size()));
}

QMap<QString, QString> judgedFacts(const QString& note)
{
    QMap<QString, QString> facts;
    for (const QString& line : note.split(u'\n'))
        if (const qsizetype colon = line.indexOf(u": "_s); colon > 0)
            facts.insert(line.left(colon), line.mid(colon + 2));
    return facts;
}

std::optional<double> numberIn(const QMap<QString, QString>& facts, const QString& key)
{
    bool isNumber = false;
    const double value = facts.value(key).toDouble(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
}

/// Notes of before there was a policy in them say nothing of one.
JudgingPolicy policyIn(const QMap<QString, QString>& facts)
{
    const auto says = [&facts](const QString& key) { return facts.value(key) == u"yes"_s; };
    return {says(u"refuse_overdue"_s), numberIn(facts, u"most_lost_share"_s).value_or(0),
            says(u"nobody_signed_in"_s)};
}

std::optional<EarlyEnd> earlyEndIn(const QMap<QString, QString>& facts)
{
    const std::optional<VerdictKind> kind = verdictKindFromString(facts.value(u"early_verdict"_s));
    bool isNumber = false;
    const qulonglong samples = facts.value(u"early_samples"_s).toULongLong(&isNumber);
    if (!kind || !isNumber)
        return {};
    return EarlyEnd{*kind, facts.value(u"early_type"_s), numberIn(facts, u"early_posterior"_s).value_or(0),
                    static_cast<std::size_t>(samples)};
}

/// Notes of before there were adjustments say nothing of one.
std::optional<CommonShift> transferIn(const QMap<QString, QString>& facts)
{
    const std::optional<DeterminedQuantities> error =
        determinedQuantities({facts.value(u"adjusted_quantities"_s), facts.value(u"adjusted_by"_s),
                              facts.value(u"adjusted_covariance"_s)});
    if (!error || !error->covariance)
        return {};
    CommonShift transfer;
    transfer.space = error->space;
    transfer.value = error->log;
    transfer.covariance = *error->covariance;
    transfer.degreesOfFreedom = numberIn(facts, u"adjusted_degrees"_s).value_or(0);
    return transfer;
}

} // namespace

QString toNote(const SqueezeJudged& judged)
{
    const VerdictOptions& rates = judged.rates;
    QString note = noteTitle();
    const auto add = [&note](const QString& key, const QString& value) {
        note += key + u": "_s + QString(value).replace(u'\n', u' ') + u'\n';
    };
    add(u"false_reject"_s, exactText(rates.falseReject));
    add(u"wrong_type"_s, exactText(rates.wrongType));
    add(u"stranger_accept"_s, exactText(rates.strangerAccept));
    add(u"stranger_share"_s, exactText(rates.strangerShare));
    add(u"robust"_s, rates.robust ? u"yes"_s : u"no"_s);
    if (rates.confidence)
        add(u"confidence"_s, exactText(*rates.confidence));
    if (judged.policy.calibrationOverdue)
        add(u"refuse_overdue"_s, u"yes"_s);
    if (judged.policy.mostLostShare > 0)
        add(u"most_lost_share"_s, exactText(judged.policy.mostLostShare));
    if (judged.policy.nobodySignedIn)
        add(u"nobody_signed_in"_s, u"yes"_s);
    const std::optional<DeterminedText> error =
        judged.transfer
            ? determinedText({judged.transfer->space, judged.transfer->value, judged.transfer->covariance})
            : std::nullopt;
    if (error) {
        add(u"adjusted_quantities"_s, error->quantities);
        add(u"adjusted_by"_s, error->logarithms);
        add(u"adjusted_covariance"_s, error->covariance);
        add(u"adjusted_degrees"_s, exactText(judged.transfer->degreesOfFreedom));
    }
    if (judged.earlyEnd) {
        add(u"early_verdict"_s, toString(judged.earlyEnd->kind));
        add(u"early_type"_s, judged.earlyEnd->type);
        add(u"early_posterior"_s, exactText(judged.earlyEnd->posterior));
        add(u"early_samples"_s, QString::number(judged.earlyEnd->samples));
    }
    return note;
}

std::optional<SqueezeJudged> squeezeJudged(const QString& note)
{
    if (!note.startsWith(noteTitle()))
        return {};
    const QMap<QString, QString> facts = judgedFacts(note);
    const std::optional<double> falseReject = numberIn(facts, u"false_reject"_s);
    const std::optional<double> wrongType = numberIn(facts, u"wrong_type"_s);
    const std::optional<double> strangerAccept = numberIn(facts, u"stranger_accept"_s);
    const std::optional<double> strangerShare = numberIn(facts, u"stranger_share"_s);
    if (!falseReject || !wrongType || !strangerAccept || !strangerShare)
        return {};
    SqueezeJudged judged;
    judged.rates.falseReject = *falseReject;
    judged.rates.wrongType = *wrongType;
    judged.rates.strangerAccept = *strangerAccept;
    judged.rates.strangerShare = *strangerShare;
    judged.rates.robust = facts.value(u"robust"_s) == u"yes"_s;
    judged.rates.confidence = numberIn(facts, u"confidence"_s);
    if (judged.rates.validate())
        return {};
    judged.earlyEnd = earlyEndIn(facts);
    judged.policy = policyIn(facts);
    judged.transfer = transferIn(facts);
    return judged;
}

} // namespace gripscope
