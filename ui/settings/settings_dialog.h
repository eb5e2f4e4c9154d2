// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/settings/values/settings_exchange.h"
#include "ui/windows/dialog.h"

#include <QFrame>

#include <functional>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace gripscope {

class Settings;
class Workbench;

/// One setting in the Settings window: what it is, its control, and a button back to the default.
class SettingRow : public QFrame {
    Q_OBJECT
public:
    SettingRow(Settings& settings, const Setting& setting, QWidget* parent = nullptr);
    [[nodiscard]] const Setting& setting() const { return *m_setting; }
    /// Each word of `search` is found in its name, explanation, group, key or choices.
    [[nodiscard]] bool matches(const QString& search) const;
    /// Asked before the setting is changed: does `apply` when it may be.
    using Guard = std::function<void(const SettingChange& change, std::function<void()> apply)>;
    void setGuard(Guard guard) { m_guard = std::move(guard); }
    /// Told why what was chosen or typed is not taken; what was typed stays to be mended.
    void setTeller(std::function<void(const QString&)> teller) { m_teller = std::move(teller); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QWidget* makeControl();
    [[nodiscard]] QWidget* makeSwitch();
    [[nodiscard]] QWidget* makeChoice();
    [[nodiscard]] QWidget* makeNumber();
    [[nodiscard]] QWidget* makeText();
    [[nodiscard]] QWidget* makeFileButton();
    void store(const QVariant& value);
    void guarded(const QVariant& after, std::function<void()> apply);
    void refresh();
    Settings* m_settings;
    const Setting* m_setting;
    QString m_key;
    std::function<void(const QVariant&)> m_show; ///< puts a value into the control
    QPushButton* m_reset;
    Guard m_guard;
    std::function<void(const QString&)> m_teller;
};

/// What a file of settings would change, before it does: each setting as it is and as it would be, and what
/// is wrong with the file. Accepted only where nothing is.
class ImportDialog : public Dialog {
    Q_OBJECT
public:
    explicit ImportDialog(const SettingsImport& import, QWidget* parent = nullptr);

private:
    [[nodiscard]] QWidget* makeTable(const SettingsImport& import);
};

/// Every setting, by groups, searched, set at once; exported, imported, reset.
class SettingsDialog : public Dialog {
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
    void tell(const QString& words, const char* role = "second");
    QLabel* m_told; ///< what came of an export or import, or why a setting is not taken
    std::vector<Group> m_groups;
};

} // namespace gripscope
