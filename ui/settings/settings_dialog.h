// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <vector>

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace gripscope {

class SettingRow;
class Workbench;

/// Every setting, by groups, searched, set at once; exported, imported, reset.
class SettingsDialog : public QDialog {
    Q_OBJECT
public:
    explicit SettingsDialog(Workbench& workbench, QWidget* parent = nullptr);
    /// Shows what a file would change, to be applied or not.
    void importFile(const QString& file);
    void exportFile(const QString& file);

private:
    void addRows(QVBoxLayout* column);
    void addButtons(QVBoxLayout* column);
    void filter(const QString& search);
    void chooseFile(bool toSave);
    void askForReset();
    struct Group {
        QLabel* heading;
        std::vector<SettingRow*> rows;
    };
    Workbench* m_workbench;
    QLineEdit* m_search;
    QLabel* m_nothing;
    QLabel* m_told; ///< what came of an export or import
    std::vector<Group> m_groups;
};

} // namespace gripscope
