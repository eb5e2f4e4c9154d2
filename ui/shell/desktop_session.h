// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <memory>

namespace gripscope {

class MainWindow;
class Settings;
class Workbench;

/// The workbench with its window, on a library; and both anew on another library when a person opens one, or
/// has put back a backup: nothing that was read from the one before outlives it. The gripper that was
/// connected is connected again, disarmed.
class DesktopSession : public QObject {
    Q_OBJECT
public:
    struct Start {
        QString library, settings;
        /// What holds for this run only, such as from the command line; for each workbench.
        std::function<void(Settings&)> prepare = {};
    };
    explicit DesktopSession(Start start, QObject* parent = nullptr);
    ~DesktopSession() override;

    [[nodiscard]] Workbench& workbench() const;
    [[nodiscard]] MainWindow& window() const;

private:
    void open(const QString& library);
    void openAnother(const QString& library, const QString& words);
    void whenQuiet(const std::function<void()>& then);
    void exchange(const QString& library, const QString& words);
    struct Parts;
    Start m_start;
    std::unique_ptr<Parts> m_parts;
};

} // namespace gripscope
