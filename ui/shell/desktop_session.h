// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>

#include <cstdint>
#include <functional>
#include <memory>

namespace gripscope {

class MainWindow;
class Settings;
class Workbench;

/// Place and size of the window, its page, and how its pages are arranged (ui/pages/page_state.h), as a
/// document.
[[nodiscard]] QByteArray windowStateOf(const MainWindow& window);
/// Puts the window back; one that would lie beyond the screens of now comes onto one of them. What cannot be
/// read is as if it had never been kept.
void restoreWindowState(MainWindow& window, const QByteArray& state);

/// Owns the window: opens it as it was left, keeps how it is left, and builds it anew in another language or
/// in other units (so no page, not one that is yet to be written either, has to follow them). The sessions of
/// the workbench know nothing of it and go on; for what lives in a page (Page::underWay()) it waits.
class WindowHost : public QObject {
    Q_OBJECT
public:
    explicit WindowHost(Workbench& workbench, QObject* parent = nullptr);
    ~WindowHost() override;
    [[nodiscard]] MainWindow& window() const { return *m_window; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void rebuild();
    /// For the end of a squeeze, and of what a page has under way; a person is told of the latter.
    [[nodiscard]] bool mustWait();
    void keepState();
    void explainStop(); ///< once for each user: what STOP is not
    QString m_stopWords;
    Workbench* m_workbench;
    std::unique_ptr<MainWindow> m_window;
    enum class Waits : std::uint8_t { ForNothing, ForSqueeze, ForPage };
    Waits m_waits = Waits::ForNothing; ///< to build it anew
};

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
