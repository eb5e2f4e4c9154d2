// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "devices/protocol/codec.h"

// What was answered and what was not understood, in words.

namespace gripscope::protocol {

using namespace Qt::StringLiterals;

namespace {

QString version(std::size_t major, std::size_t minor)
{
    return u"%1.%2"_qs.arg(major).arg(minor);
}

/// The two numbers of Set limits: its detail says which of them.
QString describeLimits(CommandResult result, std::uint32_t detail)
{
    const bool above = result == CommandResult::LimitExceeded;
    if (detail == limitsDetailForce)
        return above ? Words::tr("the largest force is above its own limit")
                     : Words::tr("the largest force is not above zero");
    if (detail == limitsDetailTravel)
        return above ? Words::tr("the longest travel is above its own limit")
                     : Words::tr("the longest travel is not above zero");
    return Words::tr(describe(result));
}

} // namespace

const char* describe(CommandResult result)
{
    switch (result) {
    case CommandResult::Done:
        return QT_TRANSLATE_NOOP("Words", "done");
    case CommandResult::Repeated:
        return QT_TRANSLATE_NOOP("Words", "it was done before");
    case CommandResult::NotArmed:
        return QT_TRANSLATE_NOOP("Words", "it is not armed");
    case CommandResult::Busy:
        return QT_TRANSLATE_NOOP("Words", "a squeeze is running");
    case CommandResult::LimitExceeded:
        return QT_TRANSLATE_NOOP("Words", "a value is above a limit");
    case CommandResult::BadValue:
        return QT_TRANSLATE_NOOP("Words", "a value is outside its range");
    case CommandResult::Incomplete:
        return QT_TRANSLATE_NOOP("Words", "a part of the force signal is missing");
    case CommandResult::ChecksumDiffers:
        return QT_TRANSLATE_NOOP("Words", "the force signal arrived damaged");
    case CommandResult::Spent:
        return QT_TRANSLATE_NOOP("Words", "this squeeze was started before");
    case CommandResult::UnknownCommand:
        return QT_TRANSLATE_NOOP("Words", "it does not know this command");
    case CommandResult::Fault:
        return QT_TRANSLATE_NOOP("Words", "it reports a fault");
    }
    return "unknown";
}

QString describe(ReportId command, CommandResult result, std::uint32_t detail)
{
    const bool ofForces = command == ReportId::Upload || command == ReportId::Start;
    switch (result) {
    case CommandResult::LimitExceeded:
    case CommandResult::BadValue:
        if (command == ReportId::SetLimits)
            return describeLimits(result, detail);
        if (!ofForces)
            break;
        return result == CommandResult::LimitExceeded
                   ? Words::tr("force %1 of the signal is above the limit").arg(detail)
                   : Words::tr("force %1 of the signal is outside its range").arg(detail);
    case CommandResult::Incomplete:
        return Words::tr("force %1 of the signal is missing").arg(detail);
    case CommandResult::Spent:
        return Words::tr("squeeze %1 was started already; this one is not behind it").arg(detail);
    case CommandResult::Fault:
        return Words::tr("it reports a fault: its code %1").arg(detail);
    default:
        break;
    }
    return Words::tr(describe(result));
}

QString describe(const DecodeError& error)
{
    switch (error.kind) {
    case DecodeError::Length:
        return Words::tr("the report has %1 bytes, not 64 bytes").arg(error.came);
    case DecodeError::Crc:
        return Words::tr("the checksum differs");
    case DecodeError::Version:
        return Words::tr("it speaks version %1 of the protocol, this program %2")
            .arg(version(error.came >> 4, error.came & 0x0F), version(versionMajor, versionMinor));
    case DecodeError::UnknownReport:
        return Words::tr("the report is of an unknown kind");
    case DecodeError::BadField:
        return error.field ? describe(*error.field) : Words::tr("a field is outside its range");
    }
    return u"?"_qs;
}

} // namespace gripscope::protocol
