// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/library/records/history.h"
#include "ui/models/row_table_model.h"
#include "ui/windows/dialog.h"

#include <QObject>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace gripscope {

class Workbench;

/// A stored squeeze beside what another estimator finds in its recording.
struct ReidentifiedSqueeze {
    HistoryEntry entry;
    std::optional<Estimate> estimate; ///< without its curves
    QString trouble;                  ///< why there is none: no recording, or damaged
};

/// Identifies stored squeezes again, one after another: each recording is fetched on the library's thread and
/// identified in the pool.
class ReidentifyJob : public QObject {
    Q_OBJECT
public:
    ReidentifyJob(Workbench& workbench, QObject* parent);

    void start(std::vector<QString> graspIds, Estimator estimator, const Reidentification& how);
    void cancel(); ///< after the squeeze that is being worked on
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] std::size_t total() const { return m_ids.size(); }
    [[nodiscard]] const std::vector<ReidentifiedSqueeze>& results() const { return m_results; }

signals:
    void progressed();
    void ended();

private:
    void next();
    void take(ReidentifiedSqueeze squeeze);

    Workbench* m_workbench;
    std::vector<QString> m_ids;
    std::vector<ReidentifiedSqueeze> m_results;
    Estimator m_estimator = Estimator::OutputError;
    Reidentification m_how;
    bool m_running = false, m_cancelled = false;
};

/// Squeezes identified again: m, b and k as stored, as found now, and how far they are apart. EditRole holds
/// raw numbers: the deviation as a share.
class ReidentifyModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Squeeze, Mass, Damping, Stiffness, Fit };
    static constexpr int columns = 5;

    using RowTableModel::RowTableModel;
    void clear();
    void append(const ReidentifiedSqueeze& squeeze);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_rows.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    [[nodiscard]] static QString text(const ReidentifiedSqueeze& row, Column column);
    std::vector<ReidentifiedSqueeze> m_rows;
};

/// Chosen squeezes with another estimator: how, the results beside what is stored, and whether to keep them.
class ReidentifyDialog : public Dialog {
    Q_OBJECT
public:
    ReidentifyDialog(Workbench& workbench, std::vector<QString> graspIds, QWidget* parent = nullptr);

signals:
    void kept(); ///< estimates were stored

private:
    [[nodiscard]] QWidget* buildOptions();
    [[nodiscard]] QWidget* buildButtons();
    [[nodiscard]] Reidentification how() const;
    void start();
    void keep();
    void refresh();

    Workbench* m_workbench;
    std::vector<QString> m_ids;
    ReidentifyJob* m_job;
    ReidentifyModel* m_model;
    QComboBox *m_estimator, *m_hold, *m_initial;
    QCheckBox* m_offset;
    QProgressBar* m_progress;
    QLabel* m_state;
    QPushButton *m_start, *m_keep, *m_close;
    Reidentification m_used; ///< of the results that are shown
    bool m_keeping = false, m_kept = false;
};

} // namespace gripscope
