// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/desktop_session.h"

#include "ui/context/workbench.h"
#include "ui/library/recent_libraries.h"
#include "ui/settings/settings_link.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/arming.h"
#include "ui/shell/main_window.h"
#include "ui/station/station_watch.h"

#include <QGuiApplication>
#include <QTimer>

#include <utility>

namespace gripscope {

namespace {
constexpr int lookAgain_ms = 50;
}

/// In the order in which they need one another.
struct DesktopSession::Parts {
    Parts(const QString& library, const Start& start) : bench(library, start.settings)
    {
        if (start.prepare)
            start.prepare(bench.settings());
        link = std::make_unique<SettingsLink>(bench);
        host = std::make_unique<WindowHost>(bench);
        attendance = std::make_unique<Attendance>(bench, makeStationWatch());
    }
    bool ending = false; ///< for another library
    Workbench bench;
    std::unique_ptr<SettingsLink> link;
    std::unique_ptr<WindowHost> host;
    std::unique_ptr<Attendance> attendance;
};

DesktopSession::DesktopSession(Start start, QObject* parent) : QObject(parent), m_start(std::move(start))
{
    open(m_start.library);
}

DesktopSession::~DesktopSession() = default;

Workbench& DesktopSession::workbench() const
{
    return m_parts->bench;
}

MainWindow& DesktopSession::window() const
{
    return m_parts->host->window();
}

void DesktopSession::open(const QString& library)
{
    m_parts = std::make_unique<Parts>(library, m_start);
    noteLibrary(m_parts->bench.settings(), library);
    // Later, since the dialog that asks for it cannot go while it is asking.
    connect(&m_parts->bench.navigator(), &Navigator::libraryAsked, this, &DesktopSession::openAnother,
            Qt::QueuedConnection);
}

void DesktopSession::openAnother(const QString& library, const QString& words)
{
    if (std::exchange(m_parts->ending, true))
        return;
    whenQuiet([this, library, words] { exchange(library, words); });
}

/// The end of the workbench waits for its threads. What they have to do yet is done before, while the window
/// answers.
void DesktopSession::whenQuiet(const std::function<void()>& then)
{
    m_parts->bench.background().ask<void>(
        this, [](Library&) { return Expected<void>(); }, // behind all that the library was asked for
        [this, then](const Expected<void>&) {
            Workbench& bench = m_parts->bench;
            const bool quiet = !bench.background().busy() && !bench.squeezing() &&
                               bench.inspection().state() != InspectSession::State::Judging;
            // Later, since who tells this answer is to end too.
            if (quiet)
                QTimer::singleShot(0, this, then);
            else
                QTimer::singleShot(lookAgain_ms, this, [this, then] { whenQuiet(then); });
        });
}

void DesktopSession::exchange(const QString& library, const QString& words)
{
    const ConnectSession& connection = m_parts->bench.connection();
    const QString address =
        connection.state() == ConnectSession::State::Disconnected ? QString() : connection.address();
    m_parts->bench.settings().setWindowState(windowStateOf(window()));
    // For a moment there is no window, which is no reason to end.
    const bool quits = QGuiApplication::quitOnLastWindowClosed();
    QGuiApplication::setQuitOnLastWindowClosed(false);
    m_parts.reset(); // the gripper is one's at a time, and so may the library be
    open(library);
    window().show();
    QGuiApplication::setQuitOnLastWindowClosed(quits);
    m_parts->bench.messages().tell(words);
    if (!address.isEmpty())
        m_parts->bench.connectTo(address);
}

} // namespace gripscope
