// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"

#include <QAbstractTableModel>

#include <vector>

namespace gripscope {

/// The checks of a gripper on its reference object, newest first.
class ReferenceCheckModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column { Made, Verdict, Stiffness, Damping, Mass, By };
    static constexpr int columns = 6;

    using QAbstractTableModel::QAbstractTableModel;

    void setChecks(std::vector<ReferenceCheckRecord> checks);
    [[nodiscard]] const std::vector<ReferenceCheckRecord>& checks() const { return m_checks; }
    /// Whether any check says something in this column.
    [[nodiscard]] bool says(Column column) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] static std::optional<std::size_t> parameterOf(Column column);
    [[nodiscard]] QString text(const ReferenceCheckRecord& check, Column column) const;
    std::vector<ReferenceCheckRecord> m_checks;
};

} // namespace gripscope
