// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/report_log.h"
#include "devices/inspection/self_test.h"
#include "ui/models/row_table_model.h"

#include <QStringList>
#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTableView;
class QTableWidget;

namespace gripscope {

class Workbench;

/// A quiet table of words, whose last column takes what width there is.
[[nodiscard]] QTableWidget* makeFactTable(const QStringList& headers, QWidget* parent);
void addFacts(QTableWidget* table, const QStringList& cells);

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

/// Tests the gripper without moving it; a line for each question with its figure, limit, tick or cross, and
/// what to do.
class SelfTestTab : public QWidget {
    Q_OBJECT
public:
    explicit SelfTestTab(Workbench& workbench, QWidget* parent = nullptr);
    [[nodiscard]] const SelfTest& test() const { return m_test; }
    void start();

private:
    void follow();
    void showLines();
    Workbench* m_workbench;
    SelfTest m_test;
    QPushButton* m_start;
    QProgressBar* m_progress;
    QLabel* m_verdict;
    QTableWidget* m_table;
};

} // namespace gripscope
