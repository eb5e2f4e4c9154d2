// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/library_change.h"

#include <QString>

#include <map>
#include <vector>

namespace gripscope {

/// Where a change comes from, and its place in the order that all stations compute alike.
struct ChangeStamp {
    QString library;    ///< that it was made in
    qint64 version = 0; ///< of that library; 0: from before there were versions
    QString utc, station;
    QString row; ///< its key
    QString person = {};
    friend bool operator==(const ChangeStamp&, const ChangeStamp&) = default;
};
/// By version, time, station and key: of two, the later is in force.
[[nodiscard]] bool comesBefore(const ChangeStamp& one, const ChangeStamp& other);

/// A type as a change left it. Which of its facts the change was about follows from its kind.
struct TypeChange {
    ChangeStamp stamp;
    ChangeKind kind = ChangeKind::NewType;
    QString typeId, name;
    TypeStatus status = TypeStatus::Enrolled;
    QString recipe; ///< its key
    QString code;
    QString limits; ///< toText(PartLimits)
    friend bool operator==(const TypeChange&, const TypeChange&) = default;
};

/// A squeeze of an enrolment came (Squeeze), or where it belongs was changed.
struct SqueezeChange {
    ChangeStamp stamp;
    ChangeKind kind = ChangeKind::Squeeze;
    QString squeeze, typeId;
    bool accepted = true;
    friend bool operator==(const SqueezeChange&, const SqueezeChange&) = default;
};

/// From a version of `library` on, its changes are made knowing those of others up to these versions.
struct PlantMeeting {
    QString library;
    qint64 version = 0;
    std::map<QString, qint64> seen; ///< by library
    friend bool operator==(const PlantMeeting&, const PlantMeeting&) = default;
};

/// In any order; nothing in it follows from something else.
struct PlantHistory {
    std::vector<TypeChange> types;
    std::vector<SqueezeChange> squeezes;
    std::vector<PlantMeeting> meetings;
};

/// What changes knew of each other, by the meetings of their libraries.
class Causality {
public:
    explicit Causality(std::vector<PlantMeeting> meetings);
    /// Whoever made `later` had `earlier` before their eyes: the same library had it, or had met it. Changes
    /// of before there were versions were seen by all.
    [[nodiscard]] bool hasSeen(const ChangeStamp& later, const ChangeStamp& earlier) const;
    /// Neither had seen the other.
    [[nodiscard]] bool wereApart(const ChangeStamp& one, const ChangeStamp& other) const;

private:
    /// From a version of a library on: the version of another up to which it has seen it.
    struct Seen {
        qint64 from = 0, version = 0;
    };
    /// By a library and one that it has seen, both numbers rising.
    std::map<QString, std::map<QString, std::vector<Seen>>> m_seen;
};

} // namespace gripscope
