// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace gripscope {

class ReidentifyJob;
class ReidentifyModel;
class Workbench;

/// Chosen squeezes with another estimator: how, the results beside what is stored, and whether to keep them.
class ReidentifyDialog : public QDialog {
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
