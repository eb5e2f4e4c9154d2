// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/classification.h"

#include "app/cli/chain_library.h"
#include "app/cli/drive.h"
#include "app/cli/library_squeezes.h"
#include "app/cli/shared_options.h"
#include "devices/factory/gripper_factory.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {
/// Longer than any identification takes.
constexpr double patience_s = 600;
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

    ChainLibrary chains;
    DeviceFactory devices;
    LibraryService library;
    ConnectSession connection; // stays unconnected: the squeezes come from files
    InspectSession session;
};

Classification::Classification(const QString& library, const IdentificationOptions& options,
                               const VerdictOptions& rates, const std::optional<CommonShift>& transfer)
    : d(std::make_unique<Private>(library))
{
    d->session.setStoring(false);
    d->session.setIdentificationOptions(options);
    d->session.setRates(rates);
    d->session.setTransfer(transfer);
}

Classification::~Classification() = default;

std::optional<Error> Classification::begin()
{
    return d->waitFor(
        [this] { return d->session.state() == InspectSession::State::Ready || d->session.lastError(); });
}

Expected<InspectSession::Result> Classification::judge(Recording recording, const QString& source)
{
    RETURN_IF_ERROR(d->session.judgeRecording(std::move(recording), source));
    if (const std::optional<Error> error =
            d->waitFor([this] { return d->session.state() == InspectSession::State::Ready; }))
        return tl::unexpected<Error>(*error);
    return *d->session.result();
}

Expected<Verdict> Classification::judge(const QString& file, const CsvReadOptions& reading)
{
    ASSIGN_OR_RETURN(Recording recording, readRecordingCsv(file, reading));
    d->chains.complete(recording, file);
    return judge(std::move(recording), file).map([](const InspectSession::Result& result) {
        return result.verdict;
    });
}

Expected<QString> existingLibrary(const CommandLine& line)
{
    return libraryFile(line).and_then(existingLibraryFile);
}

} // namespace gripscope::cli
