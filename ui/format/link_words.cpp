// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/link_words.h"

#include "core/base/words.h"
#include "ui/format/number_format.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct LinkWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::LinkWords)
};

QString count(std::uint64_t n)
{
    return formatCount(static_cast<qint64>(n));
}

QString ago(double seconds)
{
    if (seconds < 60)
        return LinkWords::tr("%1 s ago").arg(std::floor(seconds));
    if (seconds < 3600)
        return LinkWords::tr("%1 min ago").arg(std::floor(seconds / 60));
    return LinkWords::tr("%1 h ago").arg(std::floor(seconds / 3600));
}

} // namespace

QString linkWords(ConnectSession::State state, const LinkCounters& counters)
{
    switch (state) {
    case ConnectSession::State::Connected:
        return counters.stalled ? LinkWords::tr("silent") : LinkWords::tr("connected");
    case ConnectSession::State::Connecting:
        return LinkWords::tr("connecting");
    case ConnectSession::State::Lost:
        return LinkWords::tr("lost");
    case ConnectSession::State::Disconnected:
        break;
    }
    return LinkWords::tr("none");
}

QString lossWords(const LinkCounters& counters, LinkCounters::TimePoint now)
{
    const std::uint64_t lost = counters.lostSamples + counters.droppedSamples;
    if (lost == 0)
        return LinkWords::tr("none");
    const double all = static_cast<double>(lost) + static_cast<double>(counters.samples);
    const double percent = 100 * static_cast<double>(lost) / all;
    QString text = LinkWords::tr("%1 (%2 %)")
                       .arg(count(lost), percent < 0.01 ? u"<0.01"_s : Words::number(percent, 'g', 2));
    if (counters.lastLoss)
        text = LinkWords::tr("%1, %2").arg(
            text, ago(std::chrono::duration<double>(now - *counters.lastLoss).count()));
    return text;
}

QString streamWords(const LinkCounters& counters)
{
    QStringList parts;
    if (counters.duplicateReports > 0)
        parts << LinkWords::tr("%1 twice").arg(count(counters.duplicateReports));
    if (counters.badReports > 0)
        parts << LinkWords::tr("%1 damaged").arg(count(counters.badReports));
    if (counters.stalls > 0)
        parts << LinkWords::tr("%1 silent (%2 s)")
                     .arg(count(counters.stalls))
                     .arg(counters.longestStall_s, 0, 'g', 2);
    if (counters.clockSteps > 0)
        parts << (counters.clockSteps == 1 ? LinkWords::tr("1 clock jump")
                                           : LinkWords::tr("%1 clock jumps").arg(count(counters.clockSteps)));
    return parts.isEmpty() ? LinkWords::tr("sound") : parts.join(u", "_s);
}

QString latencyWords(double median_ms, double most_ms)
{
    if (!(most_ms > 0))
        return QStringLiteral("–");
    return LinkWords::tr("%1 ms, most %2 ms").arg(median_ms, 0, 'f', 0).arg(most_ms, 0, 'f', 0);
}

QString squeezeWords(SqueezeState state)
{
    switch (state) {
    case SqueezeState::Idle:
        return LinkWords::tr("none");
    case SqueezeState::Uploading:
        return LinkWords::tr("loading");
    case SqueezeState::Running:
        return LinkWords::tr("under way");
    case SqueezeState::Finished:
        return LinkWords::tr("finished");
    case SqueezeState::Stopped:
        return LinkWords::tr("stopped");
    case SqueezeState::Refused:
        return LinkWords::tr("refused");
    }
    return {};
}

QString limitWords(double inForce, double ofDevice, const ShownUnit& shown)
{
    const auto number = [&](double value) { return Words::number(value * shown.factor, 'g', 4); };
    if (!(ofDevice > 0))
        return QStringLiteral("–");
    return inForce < ofDevice
               ? LinkWords::tr("%1 of %2 %3").arg(number(inForce), number(ofDevice), shown.unit)
               : u"%1 %2"_s.arg(number(ofDevice), shown.unit);
}

} // namespace gripscope
