// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/display_units.h"
#include "ui/context/language.h"
#include "ui/context/workbench.h"
#include "ui/pages/page.h"
#include "ui/pages/page_state.h"
#include "ui/settings/settings_dialog.h"
#include "ui/settings/values/chosen_units.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/desktop_session.h"
#include "ui/shell/main_window.h"
#include "ui/widgets/message_bar.h"

#include <QEvent>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPointer>
#include <QScreen>

#include <algorithm>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int windowStateVersion = 1;
constexpr int titleBar = 32; ///< of the desktop's frame, which is not known before the window is shown

QJsonArray toJson(const QRect& rect)
{
    return {rect.x(), rect.y(), rect.width(), rect.height()};
}

QRect toRect(const QJsonArray& numbers)
{
    return numbers.size() == 4
               ? QRect(numbers[0].toInt(), numbers[1].toInt(), numbers[2].toInt(), numbers[3].toInt())
               : QRect();
}

QString unitsShown()
{
    return fieldUnit(MechanicalQuantity::Force).unit + u' ' + fieldUnit(MechanicalQuantity::Length).unit;
}

/// Moved and shrunk onto the screen that shows most of it; onto the first one where none does.
QRect ontoAScreen(QRect rect, const QSize& least)
{
    QRect room = QGuiApplication::primaryScreen()->availableGeometry();
    int most = 0;
    for (const QScreen* screen : QGuiApplication::screens()) {
        const QRect seen = screen->availableGeometry().intersected(rect);
        if (seen.width() * seen.height() > most) {
            most = seen.width() * seen.height();
            room = screen->availableGeometry();
        }
    }
    rect.setSize(rect.size().boundedTo(room.size()).expandedTo(least));
    rect.moveLeft(std::max(room.left(), std::min(rect.left(), room.right() + 1 - rect.width())));
    rect.moveTop(std::max(room.top() + titleBar, std::min(rect.top(), room.bottom() + 1 - rect.height())));
    return rect;
}

} // namespace

QByteArray windowStateOf(const MainWindow& window)
{
    const bool plain = !window.isMaximized() && !window.isFullScreen();
    QJsonObject pages;
    for (const Page* page : window.pages())
        pages.insert(page->id(), arrangementOf(*page));
    const QJsonObject state{{u"version"_s, windowStateVersion},
                            {u"geometry"_s, toJson(plain ? window.geometry() : window.normalGeometry())},
                            {u"maximized"_s, window.isMaximized()},
                            {u"page"_s, window.currentPage()->id()},
                            {u"language"_s, currentLanguage()},
                            {u"units"_s, unitsShown()},
                            {u"pages"_s, pages}};
    return QJsonDocument(state).toJson(QJsonDocument::Compact);
}

void restoreWindowState(MainWindow& window, const QByteArray& document)
{
    const QJsonObject state = QJsonDocument::fromJson(document).object();
    if (state[u"version"_s].toInt() != windowStateVersion)
        return;
    if (const QRect geometry = toRect(state[u"geometry"_s].toArray()); !geometry.isEmpty())
        window.setGeometry(ontoAScreen(geometry, window.minimumSize()));
    if (state[u"maximized"_s].toBool())
        window.setWindowState(window.windowState() | Qt::WindowMaximized);
    const bool sameWords = state[u"language"_s].toString() == currentLanguage() &&
                           state[u"units"_s].toString(unitsShown()) == unitsShown();
    for (Page* page : window.pages())
        restoreArrangement(*page, state[u"pages"_s][page->id()].toObject(), sameWords);
    window.showPage(state[u"page"_s].toString());
}

WindowHost::WindowHost(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(&workbench)
{
    applyLanguage(workbench.settings().get(setting::language));
    DisplayUnits::choose(chosenUnits(workbench.settings()));
    build();
    restoreWindowState(*m_window, workbench.settings().windowState());
    // Later, since the window that asks for it cannot go while it is asking.
    connect(
        &workbench.settings(), &Settings::changed, this,
        [this](const QString& key) {
            for (const auto& one : {setting::language, setting::forceUnit, setting::lengthUnit})
                if (key == QLatin1String(one.key))
                    rebuild();
        },
        Qt::QueuedConnection);
    connect(&workbench, &Workbench::ticked, this, [this] {
        if (m_waits != Waits::ForNothing)
            QMetaObject::invokeMethod(this, &WindowHost::rebuild, Qt::QueuedConnection);
    });
}

WindowHost::~WindowHost()
{
    m_window->removeEventFilter(this);
}

void WindowHost::build()
{
    m_window = std::make_unique<MainWindow>(*m_workbench);
    m_window->installEventFilter(this);
    explainStop();
}

void WindowHost::explainStop()
{
    Settings& settings = m_workbench->settings();
    if (settings.get(setting::stopExplained))
        return;
    m_stopWords =
        tr("STOP is not an emergency stop: it asks the gripper's own electronics, over USB. For the "
           "safety of people fit a switch that takes the power from the gripper's drive.");
    auto* bar = m_window->findChild<MessageBar*>();
    bar->show(m_stopWords);
    connect(bar, &MessageBar::changed, this, [this, bar, &settings] {
        if (!bar->messages().contains(m_stopWords)) // a person has put it away
            settings.set(setting::stopExplained, true);
    });
}

bool WindowHost::mustWait()
{
    const std::vector<Page*>& pages = m_window->pages();
    const bool underWay =
        std::any_of(pages.begin(), pages.end(), [](const Page* page) { return page->underWay(); });
    const Waits before = std::exchange(m_waits, underWay                   ? Waits::ForPage
                                                : m_workbench->squeezing() ? Waits::ForSqueeze
                                                                           : Waits::ForNothing);
    if (m_waits == Waits::ForPage && before != Waits::ForPage)
        m_workbench->messages().report(
            tr("The screen changes as soon as what is under way on the Calibrate page is accepted or left: "
               "it would be lost."),
            [host = QPointer(this)] { return host && host->m_waits == Waits::ForPage; });
    return m_waits != Waits::ForNothing;
}

void WindowHost::rebuild()
{
    const QString language = m_workbench->settings().get(setting::language);
    const DisplayUnits units = chosenUnits(m_workbench->settings());
    if (language == currentLanguage() && units == DisplayUnits::current()) {
        m_waits = Waits::ForNothing;
        return;
    }
    if (mustWait())
        return;
    const QByteArray state = windowStateOf(*m_window); // in the words and units that it was arranged in
    const bool otherWords = language != currentLanguage() && applyLanguage(language);
    if (!otherWords && units == DisplayUnits::current())
        return;
    DisplayUnits::choose(units);
    const std::unique_ptr<MainWindow> before = std::move(m_window);
    before->removeEventFilter(this);
    const bool visible = before->isVisible();
    const bool inSettings = before->findChild<SettingsDialog*>() != nullptr;
    auto* bar = before->findChild<MessageBar*>();
    bar->disconnect(this);
    bar->withdraw(m_stopWords); // it comes again, in the other language
    build();
    restoreWindowState(*m_window, state);
    for (std::size_t i = 0; i < m_window->pages().size(); ++i)
        restoreInput(*m_window->pages()[i], inputOf(*before->pages()[i]));
    m_window->takeMessages(*before);
    if (!visible)
        return;
    m_window->show(); // before the other goes: without a window the program would end
    if (inSettings)
        m_window->showSettings();
}

bool WindowHost::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_window.get() && event->type() == QEvent::Close)
        keepState();
    return QObject::eventFilter(watched, event);
}

void WindowHost::keepState()
{
    m_workbench->settings().setWindowState(windowStateOf(*m_window));
}

} // namespace gripscope
