// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/row_table_model.h"

#include <QDateTime>

#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

/// A moment that a person marked in the live charts.
struct LiveMarker {
    int number = 0;                          ///< as it stands in the charts
    double time_s = 0;                       ///< of the live history
    QDateTime when;                          ///< by this computer's clock
    QString words;                           ///< may be empty
    int link = 0;                            ///< how often the gripper had come back by then
    std::optional<std::uint64_t> sequence{}; ///< of the nearest sample, where that is known
};

/// The markers, oldest first. The words can be edited. Beyond `most` the oldest go.
class LiveMarkerModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Number, When, Words };
    static constexpr int columns = 3;
    static constexpr int most = 200;

    using RowTableModel::RowTableModel;

    /// In its place by time, with the next number.
    void add(LiveMarker marker);
    void remove(int row);
    void clear();
    [[nodiscard]] const std::vector<LiveMarker>& markers() const { return m_markers; }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    [[nodiscard]] int length() const override { return static_cast<int>(m_markers.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    std::vector<LiveMarker> m_markers;
    int m_lastNumber = 0;
};

} // namespace gripscope
