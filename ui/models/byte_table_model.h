// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"
#include "devices/profile/report_statistics.h"
#include "ui/models/row_table_model.h"

namespace gripscope {

/// The bytes of a gripper's reports, a row each: the last value, the range, how often it changes, and what it
/// belongs to by a profile. Bytes that move have a mark and stand in strong type; those of the field that is
/// chosen have an arrow and a tint.
class ByteTableModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Byte, Last, Least, Most, Changes, Field };
    explicit ByteTableModel(QObject* parent = nullptr) : RowTableModel(parent) {}

    void setBytes(const ReportStatistics& seen);
    void setProfile(const std::optional<GripperProfile>& profile);
    void setChosenField(const QString& name);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    [[nodiscard]] int length() const override { return static_cast<int>(m_seen.bytes().size()); }
    [[nodiscard]] int width() const override { return static_cast<int>(Column::Field) + 1; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    [[nodiscard]] QString text(std::size_t byte, Column column) const;
    [[nodiscard]] QString owners(std::size_t byte) const;
    [[nodiscard]] bool chosen(std::size_t byte) const;

    ReportStatistics m_seen;
    std::optional<GripperProfile> m_profile;
    QString m_chosen;
};

} // namespace gripscope
