// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/profile_json.h"

namespace gripscope {

/// A profile and where it is from.
struct KnownProfile {
    GripperProfile profile;
    QString file;
    bool shipped = false; ///< came with the program; else the user's own
};

struct ProfileCollection {
    std::vector<KnownProfile> profiles; ///< the user's own first, in the order of their file names
    std::vector<Error> errors;          ///< of files that are no profiles

    /// The first for these USB numbers: the user's own goes before one that came with the program.
    [[nodiscard]] const KnownProfile* find(std::uint16_t vendor, std::uint16_t product) const;
};

/// Where the user's own profiles are: the folder named by GRIPSCOPE_PROFILES, or gripscope/profiles in the
/// user's data folder, which the desktop application and the command line share.
[[nodiscard]] QString userProfileFolder();

// These read files: not for the screen's thread.

[[nodiscard]] ProfileCollection loadProfiles();

/// The profile of a gripper with these USB numbers; NotFound with what to do, or the error of a user's file
/// that may have been meant.
[[nodiscard]] Expected<GripperProfile> profileFor(std::uint16_t vendor, std::uint16_t product);

/// What an address names: a file, or the name of one that came with the program ("example_bare").
[[nodiscard]] Expected<GripperProfile> namedProfile(const QString& name);

/// Puts `json`, which must be a profile, into the user's folder under its USB numbers, whole or not at all;
/// the file's name. A profile for the same gripper is replaced.
[[nodiscard]] Expected<QString> installProfile(const QByteArray& json);

/// All of `bytes` in `file`, or `file` as it was. FileUnwritable.
[[nodiscard]] Expected<void> writeWholeFile(const QString& file, const QByteArray& bytes);

} // namespace gripscope
