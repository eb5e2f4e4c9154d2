// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/settings/settings_exchange.h"

#include <QFrame>

#include <functional>

class QPushButton;

namespace gripscope {

class Settings;

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

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QWidget* makeControl();
    [[nodiscard]] QWidget* makeSwitch();
    [[nodiscard]] QWidget* makeChoice();
    [[nodiscard]] QWidget* makeNumber();
    [[nodiscard]] QWidget* makeText();
    [[nodiscard]] QWidget* makeFolderButton();
    void store(const QVariant& value);
    void guarded(const QVariant& after, std::function<void()> apply);
    void refresh();
    Settings* m_settings;
    const Setting* m_setting;
    QString m_key;
    std::function<void(const QVariant&)> m_show; ///< puts a value into the control
    QPushButton* m_reset;
    Guard m_guard;
};

} // namespace gripscope
