// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"
#include "devices/profile/report_statistics.h"

#include <QAbstractTableModel>

namespace gripscope {

/// The bytes of a gripper's reports, a row each: the last value, the range, how often it changes, and what it
/// belongs to by a profile. Bytes that move have a mark and stand in strong type; those of the field that is
/// chosen have an arrow and a tint.
class ByteTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column { Byte, Last, Least, Most, Changes, Field };
    explicit ByteTableModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void setBytes(const ReportStatistics& seen);
    void setProfile(const std::optional<GripperProfile>& profile);
    void setChosenField(const QString& name);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(std::size_t byte, Column column) const;
    [[nodiscard]] QString owners(std::size_t byte) const;
    [[nodiscard]] bool chosen(std::size_t byte) const;

    ReportStatistics m_seen;
    std::optional<GripperProfile> m_profile;
    QString m_chosen;
};

} // namespace gripscope
