// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/verification/library_verification.h"
#include "devices/hid/node_permission.h"

#include <QDate>
#include <QDateTime>
#include <QFileDevice>

#include <functional>
#include <optional>
#include <vector>

namespace gripscope {

enum class CheckOutcome {
    Ok,
    Look,   ///< it works, but somebody has to see to it
    Broken, ///< something does not work
};
[[nodiscard]] QString toString(CheckOutcome outcome); ///< "ok", "look", "broken"

/// One question that was asked of this computer.
struct CheckLine {
    QString id;   ///< library, integrity, chain, keys, disk, calibration, clock, permissions, versions
    QString name; ///< "Library"
    CheckOutcome outcome = CheckOutcome::Ok;
    QString found;  ///< what is so
    QString advice; ///< what to do; empty when ok
};

/// A library as it was found.
struct LibraryFacts {
    QString file;
    bool exists = false;
    QString missingPackage; ///< of Qt's driver for such a library; empty: it is installed
    int version = 0;        ///< of its schema; 0 where it could not be read
    int newestVersion = 0;
    std::optional<Error> error;                  ///< why it could not be read
    std::optional<LibraryVerification> verified; ///< nothing where it was not asked for, or not possible
};

struct DiskFacts {
    QString folder;          ///< of the library
    qint64 freeBytes = -1;   ///< -1: not known
    bool isWritable = false; ///< by this user
};

struct KeyFacts {
    QString file;
    bool exists = false;
    bool isReadable = false;
    QFileDevice::Permissions permissions;
};

struct ClockFacts {
    QDateTime utc;
    QDateTime newestEntry;            ///< of the library; invalid where there is none
    std::optional<bool> synchronised; ///< nothing: nobody here knows
    QString askedOf;                  ///< who said so: "timedatectl", "chronyc"
};

/// A channel of a gripper that has been calibrated, or of one that is plugged in and has not.
struct CalibratedChannel {
    QString gripper, channel; ///< serial number; "force" or "position"
    std::optional<QDate> due; ///< nothing: it has no calibration
};

struct GripperNode {
    HidNode node;
    NodePermission permission;
    QString command; ///< that helps
};

struct VersionFacts {
    QString program, qt, qtBuiltWith, sqlite, hidapi, sodium, kernel, system;
};

// Each a line, or several; pure functions of what was found.
[[nodiscard]] CheckLine libraryLine(const LibraryFacts& facts);
/// Whether its rows are as they were written; and where its chains end, against what this computer knows.
[[nodiscard]] CheckLine integrityLine(const LibraryFacts& facts);
[[nodiscard]] CheckLine chainLine(const LibraryFacts& facts);
[[nodiscard]] CheckLine keyLine(const KeyFacts& facts);
[[nodiscard]] CheckLine diskLine(const DiskFacts& facts);
[[nodiscard]] CheckLine calibrationLine(const std::vector<CalibratedChannel>& channels, const QDate& today);
[[nodiscard]] CheckLine clockLine(const ClockFacts& facts);
/// `ruled`: the rule for Gripscope's own gripper is in force; `isRoot`: this user needs none.
[[nodiscard]] CheckLine permissionLine(const std::vector<GripperNode>& nodes, bool ruled, bool isRoot);
[[nodiscard]] CheckLine versionLine(const VersionFacts& facts);

/// By what `timedatectl show --property=NTPSynchronized --value` and `chronyc -n tracking` print.
[[nodiscard]] std::optional<bool> synchronisedByTimedatectl(const QString& printed);
[[nodiscard]] std::optional<bool> synchronisedByChronyc(const QString& printed);

/// What is looked at; everything but the library is for tests.
struct SelfCheckSubject {
    QString libraryFile;
    bool verified = true; ///< reads all of the library, which takes a second for some thousand squeezes
    NodeAccess access = NodeAccess::here();
    std::vector<HidNode> nodes = listHidNodes();
    /// What a program of this computer prints; nothing where it is not there, fails or does not answer.
    std::function<std::optional<QString>(const QString& program, const QStringList& arguments)> ask =
        askProgram;
    [[nodiscard]] static std::optional<QString> askProgram(const QString& program,
                                                           const QStringList& arguments);
};

/// Library, its integrity and ledger, the station's key, disk, calibrations, clock, permissions, versions: a
/// line each, in this order. Writes nothing, not into the library either; may take as long as reading it.
[[nodiscard]] std::vector<CheckLine> selfCheck(const SelfCheckSubject& subject);

} // namespace gripscope
