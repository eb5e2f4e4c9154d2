// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window_host.h"

#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/page_state.h"
#include "ui/pages/page.h"
#include "ui/settings/settings.h"
#include "ui/settings/settings_dialog.h"
#include "ui/window_state.h"
#include "ui/workbench.h"

#include <QEvent>

namespace gripscope {

WindowHost::WindowHost(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(&workbench)
{
    applyLanguage(workbench.settings().get(setting::language));
    build();
    restoreWindowState(*m_window, workbench.settings().windowState());
    // Later, since the window that asks for it cannot go while it is asking.
    connect(
        &workbench.settings(), &Settings::changed, this,
        [this](const QString& key) {
            if (key == QLatin1String(setting::language.key))
                rebuild();
        },
        Qt::QueuedConnection);
}

WindowHost::~WindowHost()
{
    m_window->removeEventFilter(this);
}

void WindowHost::build()
{
    m_window = std::make_unique<MainWindow>(*m_workbench);
    m_window->installEventFilter(this);
}

void WindowHost::rebuild()
{
    const QString language = m_workbench->settings().get(setting::language);
    if (language == currentLanguage() || !applyLanguage(language))
        return;
    const std::unique_ptr<MainWindow> before = std::move(m_window);
    before->removeEventFilter(this);
    const bool visible = before->isVisible();
    const bool inSettings = before->findChild<SettingsDialog*>() != nullptr;
    const QByteArray state = windowStateOf(*before);
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
