// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_due.h"
#include "core/session/squeeze/stored_chain.h"

#include <memory>
#include <optional>

namespace gripscope::cli {

/// What a library knows of the grippers' channels, for recordings and for a gripper that records. A library
/// that is not there knows nothing and is not made; one that cannot be read is told once, on standard error.
class ChainLibrary {
public:
    explicit ChainLibrary(QString file) : m_file(std::move(file)) {}

    [[nodiscard]] std::optional<MeasuringChainRecord> find(const QString& gripperSerial);
    /// With the calibrations of its sensors: for a gripper that is connected.
    [[nodiscard]] KnownGripper known(const QString& gripperSerial);
    /// When its studies are due again.
    [[nodiscard]] std::vector<StudyStanding> studies(const QString& gripperSerial);
    /// Gives a recording that names its gripper and has no chain the library's, told on standard error.
    void complete(Recording& recording, const QString& recordingFile);

private:
    Expected<KnownGripper> read(const QString& gripperSerial);

    QString m_file;
    std::unique_ptr<Library> m_library; ///< opened when it is first needed
    bool m_failed = false;
};

/// "100 us, known to 2 us, measured 2026-11-21": the lag of a chain and where it is from.
[[nodiscard]] QString lagText(const MeasuringChainRecord& known);

} // namespace gripscope::cli
