// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window_state.h"

#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/page_state.h"
#include "ui/pages/page.h"

#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScreen>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr int version = 1;
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
    const QJsonObject state{{u"version"_s, version},
                            {u"geometry"_s, toJson(plain ? window.geometry() : window.normalGeometry())},
                            {u"maximized"_s, window.isMaximized()},
                            {u"page"_s, window.currentPage()->id()},
                            {u"language"_s, currentLanguage()},
                            {u"pages"_s, pages}};
    return QJsonDocument(state).toJson(QJsonDocument::Compact);
}

void restoreWindowState(MainWindow& window, const QByteArray& document)
{
    const QJsonObject state = QJsonDocument::fromJson(document).object();
    if (state[u"version"_s].toInt() != version)
        return;
    if (const QRect geometry = toRect(state[u"geometry"_s].toArray()); !geometry.isEmpty())
        window.setGeometry(ontoAScreen(geometry, window.minimumSize()));
    if (state[u"maximized"_s].toBool())
        window.setWindowState(window.windowState() | Qt::WindowMaximized);
    const bool sameWords = state[u"language"_s].toString() == currentLanguage();
    for (Page* page : window.pages())
        restoreArrangement(*page, state[u"pages"_s][page->id()].toObject(), sameWords);
    window.showPage(state[u"page"_s].toString());
}

} // namespace gripscope
