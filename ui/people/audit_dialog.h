// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/audit_trail.h"

#include <QDialog>
#include <QTimer>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace gripscope {

class AuditModel;
class Workbench;

/// Who did what, when and why: filtered, exported, and verified.
class AuditDialog : public QDialog {
    Q_OBJECT
public:
    explicit AuditDialog(Workbench& workbench, QWidget* parent = nullptr);
    void exportTo(const QString& file);

private:
    QWidget* makeBar();
    void makeTable();
    [[nodiscard]] AuditFilter filter(int offset = 0) const;
    void reload();
    void fetch(int offset);
    void verify();
    void chooseExport();

    Workbench* m_workbench;
    AuditModel* m_model;
    QTableView* m_table;
    QLineEdit* m_text;
    QComboBox* m_action;
    QPushButton* m_verify;
    QLabel *m_counts, *m_result;
    QTimer m_typing; ///< a filter is applied once a person stops typing
    int m_generation = 0;
};

} // namespace gripscope
