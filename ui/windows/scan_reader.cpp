// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/windows/scan_reader.h"

#include "ui/windows/window_guard.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

bool takesText(const QWidget* widget)
{
    const auto* box = qobject_cast<const QComboBox*>(widget);
    return (box && box->isEditable()) || qobject_cast<const QLineEdit*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QTextEdit*>(widget) ||
           qobject_cast<const QPlainTextEdit*>(widget);
}

bool isIn(const QWidget* page, const QWidget* widget)
{
    return page == widget || page->isAncestorOf(widget);
}

} // namespace

ScanReader::ScanReader(QWidget* page) : QObject(page), m_page(page)
{
    m_space.setSingleShot(true);
    m_space.setInterval(longestGap_ms);
    connect(&m_space, &QTimer::timeout, this, &ScanReader::pressSpace);
}

ScanReader::~ScanReader()
{
    setActive(false);
}

void ScanReader::setActive(bool active)
{
    if (active == m_active)
        return;
    m_active = active;
    m_typed.clear();
    m_space.stop();
    if (active)
        qApp->installEventFilter(this);
    else
        qApp->removeEventFilter(this);
}

QWidget* ScanReader::focus() const
{
    QWidget* widget = m_page->window()->focusWidget();
    return widget ? widget : m_page;
}

bool ScanReader::listensTo(QObject* watched) const
{
    // An event that a widget does not take goes on to its parents: it is looked at once.
    return watched == focus() && !WindowGuard::asking() && !takesText(focus());
}

bool ScanReader::waitsForSpace() const
{
    return isIn(m_page, focus());
}

bool ScanReader::eventFilter(QObject* watched, QEvent* event)
{
    return event->type() == QEvent::KeyPress && listensTo(watched) && take(*static_cast<QKeyEvent*>(event));
}

bool ScanReader::take(const QKeyEvent& key)
{
    if (!m_typed.isEmpty() && m_sinceKey.elapsed() > longestGap_ms)
        m_typed.clear(); // a person's keys, one by one
    if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter)
        return takeEnd();
    const QString text = key.text();
    const bool command = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    if (command || text.isEmpty() || !text.front().isPrint())
        return false;
    const bool firstSpace = text == " "_L1 && m_typed.isEmpty();
    if (firstSpace && !waitsForSpace())
        return false;
    if (key.isAutoRepeat())
        return true; // held down: neither a code nor a further press
    m_sinceKey.start();
    if (firstSpace)
        m_space.start();
    else
        m_space.stop();
    m_typed += text;
    return true;
}

bool ScanReader::takeEnd()
{
    m_space.stop();
    const QString text = m_typed.trimmed();
    m_typed.clear();
    if (!text.isEmpty()) {
        m_sinceScan.start();
        emit scanned(text);
        return true;
    }
    // Some scanners end with two keys.
    return m_sinceScan.isValid() && m_sinceScan.elapsed() <= longestGap_ms;
}

void ScanReader::pressSpace()
{
    m_typed.clear();
    if (!m_active || WindowGuard::asking())
        return;
    if (auto* button = qobject_cast<QAbstractButton*>(focus()); button && isIn(m_page, button))
        button->click();
    else
        emit spacePressed();
}

} // namespace gripscope
