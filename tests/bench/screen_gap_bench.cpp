// SPDX-License-Identifier: GPL-3.0-or-later
// The longest time between two polls of the gripper while a person walks through the window: pages, dialogs,
// themes and languages. Heartbeats end 500 ms after the screen stands still: a gap of that length stops a
// squeeze.
//   QT_QPA_PLATFORM=offscreen build/bench/bin/screen_gap_bench
#include "ui/context/workbench.h"
#include "ui/pages/page.h"
#include "ui/settings/settings_link.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/desktop_session.h"
#include "ui/shell/main_window.h"
#include "ui/windows/dialog.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>
#include <functional>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

constexpr int settle_ms = 600; ///< in which what a step set going comes to its end

void live(int ms)
{
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < ms)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, ms);
}

/// Takes the times between polls, step by step.
class Gaps {
public:
    explicit Gaps(Workbench& bench)
    {
        m_sincePoll.start();
        QObject::connect(&bench, &Workbench::ticked, &bench, [this] {
            m_longest_ms = std::max(m_longest_ms, static_cast<double>(m_sincePoll.nsecsElapsed()) * 1e-6);
            m_sincePoll.restart();
        });
    }
    void step(const QString& name, const std::function<void()>& what)
    {
        m_longest_ms = 0;
        what();
        live(settle_ms);
        std::printf("%8.1f ms  %s\n", m_longest_ms, qPrintable(name));
        m_most_ms = std::max(m_most_ms, m_longest_ms);
    }
    [[nodiscard]] double most_ms() const { return m_most_ms; }

private:
    QElapsedTimer m_sincePoll;
    double m_longest_ms = 0, m_most_ms = 0;
};

void walk(Workbench& bench, WindowHost& host, Gaps& gaps)
{
    for (const char* turn : {"first", "again"})
        for (const Page* page : host.window().pages())
            gaps.step(u"page %1, %2"_s.arg(page->id(), QLatin1String(turn)),
                      [&] { host.window().showPage(page->id()); });
    for (const DialogRow& row : dialogTable()) {
        QDialog* dialog = nullptr;
        gaps.step(u"dialog %1"_s.arg(QLatin1String(row.name)), [&] {
            dialog = row.make(bench, &host.window());
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->open();
        });
        dialog->close();
    }
    for (const QString& theme : {u"dark"_s, u"contrast"_s, u"light"_s})
        gaps.step(u"theme %1"_s.arg(theme), [&] { bench.settings().set(setting::theme, theme); });
    for (const QString& language : {u"de"_s, u"en"_s})
        gaps.step(u"language %1"_s.arg(language), [&] { bench.settings().set(setting::language, language); });
}

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    QTemporaryDir folder;
    Workbench bench(folder.filePath(u"bench.gripscope"_s));
    const SettingsLink link(bench);
    WindowHost host(bench);
    host.window().resize(1440, 900);
    host.window().show();
    bench.background().ask<void>(
        nullptr, [](Library& library) { return library.loadExampleTypes(); },
        [&](const Expected<void>&) { bench.tellLibraryChanged(); });
    bench.connectTo(u"virtual:"_s);
    live(3000);
    bench.arm();
    Gaps gaps(bench);
    walk(bench, host, gaps);
    std::printf("%8.1f ms  the longest of all\n", gaps.most_ms());
    return 0;
}
