// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inspector/report_table_model.h"

#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTableView;

namespace gripscope {

/// The last 256 reports in and out, live or frozen; of the one chosen its bytes and fields.
class ReportsTab : public QWidget {
    Q_OBJECT
public:
    explicit ReportsTab(QWidget* parent = nullptr);
    /// Nothing while frozen.
    void show(std::vector<LoggedReport> reports, std::uint64_t missed);
    using QWidget::show;
    [[nodiscard]] const ReportTableModel& model() const { return *m_model; }

private:
    void showChosen();
    ReportTableModel* m_model;
    QTableView* m_table;
    QPushButton* m_freeze;
    QLabel* m_note;
    QPlainTextEdit *m_bytes, *m_fields;
};

} // namespace gripscope
