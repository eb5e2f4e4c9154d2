// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/shift/transfer_look.h"

#include "core/base/words.h"
#include "core/library/library.h"
#include "core/recognition/verdict/identified_squeeze.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int fewestOfAType = 3;
constexpr double coverage = 1.96; ///< of 95 %

/// "mass ± 1.2 %, damping ± 2.0 %, stiffness ± 0.3 %"
Finding uncertaintyInWords(const LogVector& deviation)
{
    const auto half = [&](Eigen::Index i) {
        return u"± "_s + Finding::number(100 * coverage * deviation(i), 'f', 1) + u" %"_s;
    };
    return Words::say("mass %1, damping %2, stiffness %3").arg(half(0), half(1), half(2));
}

QStringList scarce(const TransferReport& report)
{
    QStringList types;
    for (const TypeShift& type : report.types)
        if (type.squeezes < fewestOfAType)
            types << type.type;
    return types;
}

void advise(TransferLook& look)
{
    if (!look.report.error) {
        look.advice = {
            Words::say("No adjustment yet: it takes %1 squeezes of each type, of two types or more.")
                .arg(fewestOfAType)};
        return;
    }
    if (const QStringList few = scarce(look.report); !few.isEmpty())
        look.advice.push_back(
            Words::say("Too few squeezes of %1: %2 of each type are the least, since one that "
                       "went wrong is not seen among two.")
                .arg(few.join(u", "_s))
                .arg(fewestOfAType));
    if (look.report.types.size() < 2)
        look.advice.push_back(Words::say(
            "So far of one type only: whether others need the same adjustment shows with a second."));
    const std::optional<LogVector> now = uncertaintyWith(look.models, look.report, 0);
    if (!now || now->size() != 3)
        return;
    if (look.more && *look.more == 0) {
        look.advice.push_back(
            Words::say(
                "The adjustment is known well enough: %1 (95 %). More squeezes would change no verdict.")
                .arg(uncertaintyInWords(*now)));
    } else if (look.more) {
        look.advice.push_back(
            Words::say("Known so far to %1 (95 %). %2 more squeezes of each type bring that to "
                       "%3, a third of what squeezes of one type scatter: then it widens no "
                       "verdict.")
                .arg(uncertaintyInWords(*now))
                .arg(*look.more)
                .arg(uncertaintyInWords(*uncertaintyWith(look.models, look.report, *look.more))));
    } else {
        look.advice.push_back(
            Words::say("Known so far to %1 (95 %). More squeezes here help little: the "
                       "enrolment of the types is not known better. Its uncertainty counts in "
                       "every verdict.")
                .arg(uncertaintyInWords(*now)));
    }
    if (const QStringList odd = look.misfits(); !odd.isEmpty())
        look.advice.push_back(
            odd.size() == 2 && look.report.types.size() == 2
                ? Words::say(
                      "%1 and %2 need different adjustments: one of them is not common to both grippers, "
                      "or a wrong part was in. A third type tells which.")
                      .arg(odd[0], odd[1])
                : Words::say(
                      "%1 does not fit the adjustment of the others: not the same parts on both grippers, "
                      "or a wrong part was in. Leave it out, or squeeze it again.")
                      .arg(odd.join(u", "_s)));
}

} // namespace

QStringList TransferLook::misfits() const
{
    QStringList types;
    for (const TransferResidual& residual : residuals)
        if (!residual.fits)
            types << residual.type;
    return types;
}

bool TransferLook::acceptable() const
{
    return report.error && scarce(report).isEmpty() && misfits().isEmpty();
}

TransferLook lookAtTransfer(const TypeModels& models, const std::vector<TransferSqueeze>& squeezes,
                            const QStringList& planned)
{
    TransferLook look;
    look.models = models;
    std::vector<TypeSqueeze> all;
    for (const TransferSqueeze& one : squeezes)
        all.push_back(one.squeeze);
    look.squeezes = int(all.size());
    look.report = measureTransfer(models, all);
    look.residuals = transferResiduals(look.report);
    for (const QString& type : planned)
        if (std::ranges::none_of(all, [&](const TypeSqueeze& one) { return one.type == type; }))
            look.missing << type;
    if (look.report.error) {
        look.wanted = wantedUncertainty(models);
        look.more = squeezesNeeded(models, look.report, look.wanted);
    }
    if (all.size() > 1) {
        const TypeSqueeze newest = all.back();
        all.pop_back();
        look.doubt = transferDoubt(models, newest, all);
    }
    advise(look);
    return look;
}

Expected<Recording> transferRecording(Library& library, const StudyMeasurementRecord& measured)
{
    if (measured.squeezeId.isEmpty())
        return failure(ErrorCode::NotFound, {Words::say("the recording of a measurement")});
    ASSIGN_OR_RETURN(DraftSqueeze squeeze, library.draftSqueeze(measured.squeezeId));
    return std::move(squeeze.recording);
}

std::optional<TypeSqueeze> transferSqueeze(const QString& type, const Recording& recording,
                                           const IdentificationOptions& options)
{
    const Identification found = identify(recording, options);
    if (found.validity.verdict == ValidityVerdict::Invalid)
        return {};
    return identifiedSqueeze(type, found, recording.forceUnit, recording.positionUnit);
}

} // namespace gripscope
