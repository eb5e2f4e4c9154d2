// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/outcome_words.h"

#include "core/base/words.h"
#include "ui/format/number_format.h"

#include <QCoreApplication>

#include <algorithm>

namespace gripscope {

namespace {

struct OutcomeWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::Outcome)
};

/// The two types with the largest posterior.
QStringList likeliest(const QMap<QString, double>& posterior)
{
    QStringList names = posterior.keys();
    std::stable_sort(names.begin(), names.end(), [&posterior](const QString& a, const QString& b) {
        return posterior[a] > posterior[b];
    });
    return names.mid(0, 2);
}

} // namespace

QString outcomeWord(InspectionOutcome outcome)
{
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        return OutcomeWords::tr("as expected");
    case InspectionOutcome::OtherType:
        return OutcomeWords::tr("other type");
    case InspectionOutcome::Unknown:
        return OutcomeWords::tr("unknown");
    case InspectionOutcome::Inconclusive:
        return OutcomeWords::tr("inconclusive");
    case InspectionOutcome::NotValid:
        return OutcomeWords::tr("not valid");
    case InspectionOutcome::DoesNotConform:
        return OutcomeWords::tr("does not conform");
    }
    return {};
}

bool isSuspect(const InspectSession::Result& result)
{
    return result.verdict.validity.verdict == ValidityVerdict::Suspect &&
           result.outcome != InspectionOutcome::NotValid;
}

QString outcomeWord(InspectionOutcome outcome, bool suspect)
{
    return suspect ? OutcomeWords::tr("suspect: %1").arg(outcomeWord(outcome)) : outcomeWord(outcome);
}

QString outcomeWord(InspectionOutcome outcome, bool suspect, bool expected)
{
    if (outcome != InspectionOutcome::AsExpected || expected)
        return outcomeWord(outcome, suspect);
    const QString known = OutcomeWords::tr("known type");
    return suspect ? OutcomeWords::tr("suspect: %1").arg(known) : known;
}

QString outcomeFilterWord(InspectionOutcome outcome)
{
    return outcome == InspectionOutcome::AsExpected ? OutcomeWords::tr("as expected or known type")
                                                    : outcomeWord(outcome);
}

bool callsSupervisor(const InspectSession::Result& result, int callAfter)
{
    return callAfter > 0 && result.invalidInARow >= callAfter;
}

namespace {

/// Which two types it may be, and how long to squeeze to know.
QString betweenTypes(const InspectSession::Result& result)
{
    const Verdict& verdict = result.verdict;
    QString first = verdict.nearest, second = verdict.rival;
    if (verdict.posterior.value(first) < verdict.posterior.value(second))
        first.swap(second);
    const QString either = OutcomeWords::tr("It could be %1 (%2) or %3 (%4)")
                               .arg(first, formatProbability(verdict.posterior.value(first)), second,
                                    formatProbability(verdict.posterior.value(second)));
    const std::optional<CorrectedParameters> object = result.identification.object();
    const bool lengthTells = verdict.timesLonger || (object && !object->covariance.isZero(0));
    if (lengthTells && !verdict.timesLonger)
        return OutcomeWords::tr("%1, and a longer squeeze would not tell them apart.").arg(either);
    if (!lengthTells || *verdict.timesLonger < 1.05)
        return OutcomeWords::tr("%1: squeeze it again.").arg(either);
    return OutcomeWords::tr("%1: squeezed for %2 s, nine of ten would be told apart.")
        .arg(either, Words::number(result.seconds * *verdict.timesLonger, 'g', 2));
}

QString reasonOf(const InspectSession::Result& result)
{
    const Verdict& verdict = result.verdict;
    if (result.outcome == InspectionOutcome::NotValid)
        return described(verdict.reasons).join(u' ');
    if (verdict.conformity) {
        const QString limits = inWords(*verdict.conformity).describe();
        return verdict.conformity->decision != ConformityDecision::Conforms || verdict.reasons.empty()
                   ? limits
                   : limits + u' ' + verdict.reasons.front().describe();
    }
    const bool contradicted = result.earlyEnd && verdict.kind == VerdictKind::Inconclusive;
    if (result.outcome == InspectionOutcome::Inconclusive && !verdict.rival.isEmpty() &&
        !verdict.heldForStranger && !contradicted)
        return betweenTypes(result);
    return verdict.reasons.empty() ? QString() : verdict.reasons.front().describe();
}

VerdictWords headlineOf(const InspectSession::Result& result)
{
    const Verdict& verdict = result.verdict;
    switch (result.outcome) {
    case InspectionOutcome::AsExpected:
        return {verdict.type,
                result.expectedType.isEmpty() ? OutcomeWords::tr("known type, none was expected")
                                              : outcomeWord(result.outcome),
                {}};
    case InspectionOutcome::OtherType:
        return {verdict.type, OutcomeWords::tr("other type; expected %1").arg(result.expectedType), {}};
    case InspectionOutcome::Unknown:
        return {OutcomeWords::tr("Unknown"),
                verdict.nearest.isEmpty() ? OutcomeWords::tr("no type is enrolled yet")
                                          : OutcomeWords::tr("none of the enrolled types"),
                {}};
    case InspectionOutcome::DoesNotConform:
        return {verdict.type, outcomeWord(result.outcome), {}};
    case InspectionOutcome::Inconclusive: {
        if (verdict.conformity)
            return {OutcomeWords::tr("%1?").arg(verdict.type),
                    inWords(verdict.conformity->decision).describe(),
                    {}};
        if (verdict.heldForStranger)
            return {OutcomeWords::tr("%1?").arg(verdict.nearest), outcomeWord(result.outcome), {}};
        const QStringList two = likeliest(verdict.posterior);
        return {two.size() == 2 ? OutcomeWords::tr("%1 or %2?").arg(two[0], two[1])
                                : OutcomeWords::tr("Open"),
                outcomeWord(result.outcome),
                {}};
    }
    case InspectionOutcome::NotValid:
        if (result.refused)
            return {OutcomeWords::tr("Not judged"), OutcomeWords::tr("refused by the settings"), {}};
        return {OutcomeWords::tr("Squeeze again"),
                OutcomeWords::tr("measurement not valid; part not judged"),
                {}};
    }
    return {};
}

} // namespace

VerdictWords verdictWords(const InspectSession::Result& result, int callAfter)
{
    VerdictWords words = headlineOf(result);
    words.reason = reasonOf(result);
    if (callsSupervisor(result, callAfter)) {
        words.headline = OutcomeWords::tr("Call your supervisor");
        words.outcome =
            OutcomeWords::tr("%n squeezes in a row were not valid", nullptr, result.invalidInARow);
    }
    if (result.voided)
        words.outcome = OutcomeWords::tr("VOIDED, does not count: %1").arg(words.outcome);
    if (isSuspect(result)) {
        words.outcome = OutcomeWords::tr("SUSPECT: %1").arg(words.outcome);
        if (const Findings& doubts = result.verdict.validity.reasons; !doubts.empty())
            words.reason = OutcomeWords::tr("Suspect: %1").arg(described(doubts).join(u' '));
    }
    if (result.keeping == InspectSession::Keeping::Waiting)
        words.outcome = OutcomeWords::tr("%1 · not stored yet").arg(words.outcome);
    else if (result.keeping == InspectSession::Keeping::Refused)
        words.outcome = OutcomeWords::tr("%1 · NOT STORED").arg(words.outcome);
    return words;
}

} // namespace gripscope
