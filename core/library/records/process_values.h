// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_column.h"

#include <QDateTime>
#include <QString>
#include <QStringList>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace gripscope {

/// Which inspections a control chart reads: those in which this type was recognised, that were not voided.
struct ProcessQuery {
    QString type; ///< a name that it has or had: what was recognised under its other names counts, too
    QString gripper = {}; ///< as HistoryChoices has them; empty: any
    qint64 after = 0;     ///< only those with a larger number
    qint64 newest = 0;    ///< above 0: only among so many that are the newest of the library
    friend bool operator==(const ProcessQuery&, const ProcessQuery&) = default;
};

/// A name that a type has or had, from one time on until another; as utcText(), empty: without a bound. A
/// name that no other type has taken goes on after a rename: what was under way then is judged by it.
struct TypeNameSpan {
    QString name;
    QString from = {}, until = {};
};

/// m, b and k of inspections, a column each: 64 bytes an inspection, so that a million fit. In the order in
/// which they were squeezed. Copies share what they have in common: one more inspection costs no more.
struct ProcessValues {
    SharedColumn<qint64> numbers, times_ms; ///< times since 1970, UTC
    /// In SI where the units of the channels are known, else as stored; NaN: not determined.
    std::array<SharedColumn<double>, 3> quantities;
    SharedColumn<std::uint32_t> stations, operators, batches; ///< places in the names below
    QStringList stationNames, operatorNames;                  ///< as they came
    QStringList batchNames;                                   ///< the first: of no batch
    bool si = true;                                           ///< units known, all of them
    bool unitsDiffer = false; ///< some known, some not, or several that are not: not to be compared
    qint64 newest = 0;        ///< the largest number
    std::shared_ptr<const std::vector<qint64>> voided; ///< ascending numbers that were left out

    [[nodiscard]] std::size_t size() const { return numbers.size(); }
    [[nodiscard]] bool empty() const { return numbers.empty(); }
};

/// Where reading goes on. As it is made: from the beginning.
struct ProcessPlace {
    QString key;       ///< of the squeeze that was read last
    qint64 last = 0;   ///< its number
    qint64 newest = 0; ///< number in the library when reading began: how far it is
    std::shared_ptr<const std::vector<qint64>> voided;      ///< ascending numbers
    std::shared_ptr<const std::vector<TypeNameSpan>> names; ///< of the type
    QString units;                                          ///< that were seen, as "force position"
    bool through = false;
    [[nodiscard]] double share() const { return newest > 0 ? double(last) / double(newest) : 1; }
};

/// Limits of a type's charts that somebody has fixed; a later row takes the place of an earlier one.
struct ProcessLimitsRecord {
    QString type;
    QString limits; ///< FixedLimits as text (core/session/process/fixed_limits.h); empty: no longer fixed
    QDateTime fixed;
    QString operatorName;
    bool ofThisLibrary = true; ///< the numbers of inspections in it; else those of another station's
};

} // namespace gripscope
