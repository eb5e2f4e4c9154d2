// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/chain_library.h"

#include "app/cli/line/output.h"

#include <QFileInfo>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

Expected<KnownGripper> ChainLibrary::read(const QString& gripperSerial)
{
    if (!m_library) {
        if (!QFileInfo::exists(m_file))
            return KnownGripper{};
        ASSIGN_OR_RETURN(std::unique_ptr<Library> opened, Library::open(m_file));
        m_library = std::move(opened);
    }
    return knownGripper(*m_library, gripperSerial);
}

std::optional<MeasuringChainRecord> ChainLibrary::find(const QString& gripperSerial)
{
    return known(gripperSerial).chain;
}

KnownGripper ChainLibrary::known(const QString& gripperSerial)
{
    if (gripperSerial.isEmpty() || m_failed)
        return {};
    Expected<KnownGripper> found = read(gripperSerial);
    if (found)
        return std::move(*found);
    m_failed = true;
    message(u"gripscope-cli: %1 What it knows of the grippers' channels is not used."_qs.arg(
        found.error().describe()));
    return {};
}

std::vector<StudyStanding> ChainLibrary::studies(const QString& gripperSerial)
{
    constexpr int mostRead = 200; // the newest: what is due rests on the last of each kind
    if (gripperSerial.isEmpty() || !m_library)
        return {};
    return studyStandings(m_library->studies(mostRead).value_or(std::vector<StudyRecord>()), gripperSerial);
}

void ChainLibrary::complete(Recording& recording, const QString& recordingFile)
{
    if (!(recording.chain == MeasuringChain()))
        return;
    const QString serial = recording.provenance.value(u"serial"_qs);
    const std::optional<MeasuringChainRecord> known = find(serial);
    if (!known)
        return;
    if (completeChain(recording, *known) == ChainUse::Stored)
        message(u"%1: the library's measuring chain of gripper %2 is used; lag %3."_qs.arg(
            recordingFile, serial, lagText(*known)));
    else
        message(u"%1: the library's measuring chain of gripper %2 is used, but the file's own lag."_qs.arg(
            recordingFile, serial));
}

QString lagText(const MeasuringChainRecord& known)
{
    return u"%1 us, known to %2 us, measured %3"_qs.arg(
        QString::number(known.forceLag_s * 1e6, 'g', 4),
        QString::number(known.chain.forceLagUncertainty_s * 1e6, 'g', 2),
        known.measured.toUTC().toString(Qt::ISODate));
}

} // namespace gripscope::cli
