// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/acquisition/report_log.h"
#include "ui/models/row_table_model.h"

namespace gripscope {

/// The last reports of a link, newest first, each with its time before the newest, direction, kind and words.
class ReportTableModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Kind { All, Stream, Answers, Commands, Features, Damaged };
    enum Column { Time, Direction, Report, Words, Columns };

    using RowTableModel::RowTableModel;
    /// Oldest first, as the log gives them.
    void setReports(std::vector<LoggedReport> reports);
    void setKind(Kind kind);
    [[nodiscard]] const LoggedReport& at(int row) const { return m_shown[static_cast<std::size_t>(row)]; }
    /// All that is shown, a line each: time, direction, kind, bytes, words; with tabs between.
    [[nodiscard]] QString asText() const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    [[nodiscard]] int length() const override { return static_cast<int>(m_shown.size()); }
    [[nodiscard]] int width() const override { return Columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    void choose();
    [[nodiscard]] bool wanted(const LoggedReport& report) const;
    [[nodiscard]] QString cell(const LoggedReport& report, int column) const;
    std::vector<LoggedReport> m_all, m_shown;
    Kind m_kind = Kind::All;
};

} // namespace gripscope
