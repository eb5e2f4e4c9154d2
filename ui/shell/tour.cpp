// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/tour.h"

#include "core/library/ledger/library_witness.h"
#include "ui/context/language.h"
#include "ui/context/workbench.h"
#include "ui/pages/page.h"
#include "ui/shell/main_window.h"
#include "ui/widgets/message_bar.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QEventLoop>
#include <QPixmap>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTimer>

#include <functional>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr int longestAnswer_ms = 30000; ///< of the library
constexpr int settle_ms = 250;          ///< for what is still being drawn when a page says it is ready

/// Lets the program live until `reached`, or until the deadline.
bool waitFor(const std::function<bool()>& reached, const QDeadlineTimer& deadline)
{
    QEventLoop loop;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
        if (reached() || deadline.hasExpired())
            loop.quit();
    });
    timer.start(10);
    loop.exec();
    return reached();
}

void pause(int milliseconds)
{
    (void)waitFor([] { return false; }, QDeadlineTimer(milliseconds));
}

void complain(const QString& what)
{
    QTextStream(stderr) << "tour: " << what << Qt::endl;
}

bool loadExamples(Workbench& bench)
{
    bool answered = false;
    bool loaded = false;
    bench.background().ask<void>(
        nullptr, [](Library& library) { return library.loadExampleTypes(); },
        [&](const Expected<void>& done) {
            answered = true;
            loaded = done.has_value();
            if (!done)
                complain(done.error().describe());
        });
    const bool inTime = waitFor([&answered] { return answered; }, QDeadlineTimer(longestAnswer_ms));
    bench.tellLibraryChanged();
    return inTime && loaded;
}

/// A page in a telling state. False: it never came to one.
bool prepare(MainWindow& window, int index, const QDeadlineTimer& deadline)
{
    Page* page = window.pages()[static_cast<std::size_t>(index)];
    window.showPage(index);
    page->prepareTour();
    const bool good = waitFor([page] { return page->tourReady(); }, deadline);
    if (!good)
        complain(u"the page %1 was not ready in time (%2)"_s.arg(page->id(), window.message()));
    pause(settle_ms);
    window.showPage(index); // a squeeze may have opened another page
    return good;
}

/// A busy computer may let the gripper's watchdog trip, which is told: true when there was something to
/// take away again.
bool takeMessagesAway(MainWindow& window)
{
    auto* bar = window.findChild<MessageBar*>();
    const bool told = !bar->messages().isEmpty();
    while (!bar->messages().isEmpty()) {
        complain(u"taken away: %1"_s.arg(bar->messages().constFirst()));
        bar->dismiss();
    }
    return told;
}

/// Leaves no picture of a page that was not ready: it would be taken for how the page looks.
bool visit(MainWindow& window, int index, const QDir& folder, const TourOptions& options)
{
    Page* page = window.pages()[static_cast<std::size_t>(index)];
    const QDeadlineTimer deadline(options.patience);
    bool good = prepare(window, index, deadline);
    constexpr int tries = 3;
    for (int i = 1; takeMessagesAway(window) && i < tries && !deadline.hasExpired(); ++i)
        good = prepare(window, index, deadline);
    if (!good)
        return false;
    pause(settle_ms); // the page has the room of the messages again
    if (window.size() != options.size) {
        complain(u"the window with the page %1 is %2 x %3"_s.arg(page->id())
                     .arg(window.width())
                     .arg(window.height()));
        return false;
    }
    const QString file = folder.filePath(page->id() + u".png"_s);
    if (window.grab().save(file))
        return true;
    complain(u"%1 could not be written"_s.arg(file));
    return false;
}

} // namespace

int runTour(const TourOptions& options)
{
    const QDir folder(options.folder);
    if (!folder.mkpath(u"."_s)) {
        complain(u"the folder %1 cannot be made"_s.arg(options.folder));
        return 1;
    }
    QTemporaryDir temporary;
    if (!temporary.isValid()) {
        complain(temporary.errorString());
        return 1;
    }
    Theme::instance().apply(options.theme);
    if (!applyLanguage(options.language)) {
        complain(u"there are no words in the language %1"_s.arg(options.language));
        return 1;
    }
    bool good = true;
    {
        const PassingLibrary library(temporary.filePath(u"tour.gripscope"_s));
        Workbench bench(library.file());
        bench.setOperatorName(u"Mai"_s);
        LinkLimits unhurried; // nobody sits before it, and no finger is between virtual jaws
        unhurried.aliveFor = std::chrono::seconds(60);
        unhurried.freshFor = unhurried.reportPeriod = std::chrono::seconds(1);
        bench.setLinkLimits(unhurried);
        good = loadExamples(bench);
        bench.connectTo(u"virtual:"_s);
        MainWindow window(bench);
        window.resize(options.size);
        window.show();
        for (int i = 0; i < static_cast<int>(window.pages().size()); ++i)
            good = visit(window, i, folder, options) && good;
        window.close();
    }
    return good ? 0 : 1;
}

} // namespace gripscope
