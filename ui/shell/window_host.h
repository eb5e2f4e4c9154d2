// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>

#include <cstdint>
#include <memory>

namespace gripscope {

class MainWindow;
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

} // namespace gripscope
