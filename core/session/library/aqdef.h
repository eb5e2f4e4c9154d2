// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history.h"
#include "core/library/records/type_record.h"

#include <QByteArray>
#include <QStringList>

namespace gripscope {

/// What the head of an AQDEF file (Q-DAS ASCII transfer format, .dfq) says before the values: gathered from
/// all squeezes first.
class AqdefCatalogue {
public:
    void add(const std::vector<HistoryEntry>& entries);
    [[nodiscard]] const std::optional<QString>& type() const { return m_type; } ///< of all; empty: various
    /// K-fields, a line each. `type`: the record of the one type, for its limits; null: none.
    [[nodiscard]] QByteArray head(const TypeRecord* type) const;
    /// A line a squeeze: m, b and k with char 15 between, each its fields with char 20 between: value,
    /// attribute (0; 255: it does not count), time, events, batch, nest, operator, machine, process
    /// parameter, gauge. SI; times in UTC; Latin-1, lines end with CR LF.
    [[nodiscard]] QByteArray lines(const std::vector<HistoryEntry>& entries) const;

private:
    [[nodiscard]] QString line(const HistoryEntry& entry) const;
    QStringList m_operators, m_stations, m_gauges; ///< numbered from 1
    std::optional<QString> m_type;
    bool m_begun = false;
};

} // namespace gripscope
