// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/recordings/classification.h"

#include "app/cli/library/chain_library.h"
#include "app/cli/library/existing_library.h"
#include "app/cli/line/drive.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/base/json_value.h"
#include "core/quality/conformity/conformity_json.h"
#include "devices/factory/gripper_factory.h"

#include <QJsonArray>

#include <cmath>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {
/// Longer than any identification takes.
constexpr double patience_s = 600;

/// Types that are there and that no part is held against.
void tellUnapproved(const std::vector<TypeRecord>& types)
{
    QStringList names;
    for (const TypeRecord& type : types)
        if (!type.approved)
            names << type.name;
    if (!names.isEmpty())
        message(
            u"Not approved, and so not recognised: %1. See \"types approve\"."_qs.arg(names.join(u", "_qs)));
}
} // namespace

struct Classification::Private {
    explicit Private(const QString& file)
        : chains(file), library(file), connection(devices), session(connection, library)
    {
    }

    std::optional<Error> waitFor(const std::function<bool()>& done)
    {
        if (!drive([this] { session.poll(); }, done, patience_s))
            return Error{ErrorCode::Cancelled, {u"The classification"_qs}};
        return session.lastError();
    }

    Expected<InspectSession::Result> judge(Recording recording, const QString& source,
                                           const std::optional<EarlyEnd>& earlyEnd)
    {
        RETURN_IF_ERROR(session.judgeRecording(std::move(recording), source, earlyEnd));
        if (const std::optional<Error> error =
                waitFor([this] { return session.state() == InspectSession::State::Ready; }))
            return tl::unexpected<Error>(*error);
        return *session.result();
    }

    std::optional<std::optional<CommonShift>> transfer; ///< that was stated, which may be that there is none
    ChainLibrary chains;
    DeviceFactory devices;
    LibraryService library;
    ConnectSession connection; // stays unconnected: the squeezes come from files
    InspectSession session;
};

Classification::Classification(const QString& library, const IdentificationOptions& options,
                               const VerdictOptions& rates)
    : d(std::make_unique<Private>(library))
{
    d->session.setStoring(false);
    d->session.setIdentificationOptions(options);
    d->session.setRates(rates);
}

Classification::~Classification() = default;

void Classification::setPolicy(const JudgingPolicy& policy)
{
    d->session.setPolicy(policy);
}

void Classification::setTransfer(const std::optional<CommonShift>& transfer)
{
    d->transfer = transfer;
    d->session.setTransfer(transfer);
}

std::optional<Error> Classification::begin(Telling telling)
{
    const std::optional<Error> error = d->waitFor(
        [this] { return d->session.state() == InspectSession::State::Ready || d->session.lastError(); });
    if (!error && telling == Telling::Unapproved)
        tellUnapproved(d->session.types());
    return error;
}

Expected<InspectSession::Result> Classification::judge(Recording recording, const QString& source)
{
    return d->judge(std::move(recording), source, {});
}

Expected<InspectSession::Result> Classification::judgeAgain(Recording recording, const QString& source,
                                                            const SqueezeJudged& before, Adjusting adjusting)
{
    const VerdictOptions own = d->session.rates();
    const JudgingPolicy ownPolicy = d->session.policy();
    d->session.setRates(before.rates);
    d->session.setPolicy(before.policy);
    if (adjusting == Adjusting::AsThen)
        d->session.setTransfer(before.transfer);
    Expected<InspectSession::Result> result = d->judge(std::move(recording), source, before.earlyEnd);
    d->session.setRates(own);
    d->session.setPolicy(ownPolicy);
    d->transfer ? d->session.setTransfer(*d->transfer) : d->session.setTransferOfLibrary();
    return result;
}

void Classification::complete(Recording& recording, const QString& source)
{
    d->chains.complete(recording, source);
}

Expected<InspectSession::Result> Classification::judge(const QString& file, const CsvReadOptions& reading)
{
    ASSIGN_OR_RETURN(Recording recording, readRecordingCsv(file, reading));
    d->chains.complete(recording, file);
    return judge(std::move(recording), file);
}

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

Expected<QString> existingLibrary(const CommandLine& line)
{
    return libraryFile(line).and_then(existingLibraryFile);
}

} // namespace gripscope::cli
