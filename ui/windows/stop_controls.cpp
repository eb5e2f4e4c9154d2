// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/windows/stop_controls.h"

#include "core/session/connection/connect_session.h"
#include "core/session/connection/stop_words.h"
#include "ui/context/workbench.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QAccessible>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>

#include <utility>

namespace gripscope {

StopStanding& StopStanding::of(Workbench& workbench)
{
    if (auto* known = workbench.findChild<StopStanding*>(QString(), Qt::FindDirectChildrenOnly))
        return *known;
    return *new StopStanding(workbench);
}

StopStanding::StopStanding(Workbench& workbench) : QObject(&workbench), m_workbench(&workbench)
{
    connect(&workbench, &Workbench::stopped, this, &StopStanding::noticeStop);
    connect(&workbench, &Workbench::ticked, this, &StopStanding::follow);
    follow();
}

bool StopStanding::notObeyed() const
{
    return m_notObeyed;
}

void StopStanding::noticeStop()
{
    // Esc closes a menu far more often than it stops something.
    if (m_stopped || (!m_workbench->connection().armed() && !m_workbench->squeezing()))
        return;
    m_stopped = true;
    emit changed();
}

void StopStanding::follow()
{
    const ConnectSession& connection = m_workbench->connection();
    const bool armedAnew = connection.armed() && !m_armed;
    const bool another = std::exchange(m_address, connection.address()) != m_address;
    m_armed = connection.armed();
    const std::optional<Error> reason = m_armed ? std::nullopt : connection.disarmReason();
    const bool notObeyed = connection.stopState() == StopState::NotObeyed;
    const bool stopped = m_stopped && !armedAnew && !another;
    if (stopped == m_stopped && reason == m_reason && notObeyed == m_notObeyed)
        return;
    m_stopped = stopped;
    m_reason = reason;
    m_notObeyed = notObeyed;
    emit changed();
}

namespace {

QList<StopButton*>& buttons()
{
    static QList<StopButton*> all;
    return all;
}

/// A window that belongs to another lies above it.
bool coveredByAWindow(const QWidget& window, const QPoint& global)
{
    for (const QWidget* other : QApplication::topLevelWidgets()) {
        if (!other->isVisible() || other->windowType() == Qt::Popup || other->windowType() == Qt::ToolTip ||
            !other->geometry().contains(global))
            continue;
        for (const QWidget* under = other->parentWidget(); under; under = under->parentWidget())
            if (under == &window)
                return true;
    }
    return false;
}

} // namespace

StopButton::StopButton(Workbench& workbench, int height, QWidget* parent)
    : QPushButton(tr("STOP"), parent), m_workbench(&workbench)
{
    setRole(this, "stop");
    setAccessibleName(tr("Stop the gripper and disarm it"));
    setToolTip(tr("Stop the gripper and disarm it (Esc)"));
    setFixedHeight(height);
    setAutoDefault(false);        // Enter in a dialog is for the dialog
    setFocusPolicy(Qt::TabFocus); // a click leaves the focus where the work is
    // On the press, not on the release: that is when a person wants it.
    connect(this, &QPushButton::pressed, this, &StopButton::press);
    buttons().append(this);
}

StopButton::~StopButton()
{
    buttons().removeAll(this);
}

void StopButton::press()
{
    m_workbench->stop();
}

QRect StopButton::place() const
{
    return {mapToGlobal(QPoint(0, 0)), size()};
}

StopButton* StopButton::at(const QPoint& global)
{
    for (StopButton* button : buttons())
        if (button->isVisible() && !button->window()->isMinimized() && button->place().contains(global) &&
            !coveredByAWindow(*button->window(), global))
            return button;
    return nullptr;
}

QList<QRect> StopButton::places()
{
    QList<QRect> all;
    for (const StopButton* button : buttons())
        if (button->isVisible() && !button->window()->isMinimized())
            all << button->place();
    return all;
}

StopStrip::StopStrip(Workbench& workbench, QWidget* window)
    : QFrame(window), m_workbench(&workbench), m_state(makeLabel({}, "", this))
{
    setObjectName("stopStrip");
    setRole(this, "strip");
    setFixedHeight(height_px);
    auto* stop = new StopButton(workbench, metrics::touchTarget + 4, this);
    stop->setObjectName("stripStop");
    m_state->setObjectName("stripState");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 4, 16, 4);
    row->setSpacing(12);
    row->addWidget(m_state, 1);
    row->addWidget(stop);
    connect(&workbench, &Workbench::connectionChanged, this, &StopStrip::refresh);
    connect(&workbench, &Workbench::ticked, this, &StopStrip::refresh);
    hide();
    refresh();
}

void StopStrip::refresh()
{
    const ConnectSession& connection = m_workbench->connection();
    const bool wanted =
        connection.armed() || connection.stopState() == StopState::NotObeyed ||
        (connection.state() == ConnectSession::State::Connected && connection.identity().commandable);
    const QString words = m_workbench->squeezing() ? tr("The gripper is squeezing.")
                          : connection.armed()     ? tr("The gripper is armed: it may move.")
                          : StopStanding::of(*m_workbench).stopped()
                              ? tr("Stopped. The gripper is not armed.")
                              : tr("The gripper is not armed.");
    if (m_state->text() != words)
        m_state->setText(words);
    if (wanted == !isHidden())
        return;
    setVisible(wanted);
    emit shown(wanted);
}

namespace {

constexpr int margin = 16;
constexpr int frame = 6;
/// 72 px are 19 mm on a usual screen: at 3 m as large as this line at 60 cm.
constexpr int largestFont = metrics::fontVerdict, least = metrics::fontTitle;
/// What is under it stays in sight.
constexpr double mostOfTheHeight = 0.5;

QRect textRect(int pixels, int width)
{
    return QFontMetrics(Theme::font(pixels, true))
        .boundingRect(QRect(0, 0, width, 10000), Qt::TextWordWrap | Qt::AlignHCenter, notObeyedWords());
}

} // namespace

StopNotice::StopNotice(const ConnectSession& connection, QWidget* above, QWidget* window)
    : QWidget(window), m_connection(&connection), m_above(above)
{
    setObjectName("stopNotice");
    setAccessibleName(notObeyedWords());
    hide();
    window->installEventFilter(this);
    above->installEventFilter(this);
    connect(&Theme::instance(), &Theme::changed, this, &StopNotice::takePlace);
}

void StopNotice::refresh()
{
    const bool wanted = m_connection->stopState() == StopState::NotObeyed;
    if (wanted == !isHidden())
        return;
    setVisible(wanted);
    if (!wanted)
        return;
    takePlace();
    raise();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

bool StopNotice::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move)
        takePlace();
    return QWidget::eventFilter(watched, event);
}

void StopNotice::takePlace()
{
    if (isHidden())
        return;
    const QPoint corner = m_above->mapTo(window(), QPoint(0, m_above->height()));
    const int width = window()->width() - corner.x();
    const int room = width - 2 * (margin + frame);
    const int most = static_cast<int>(mostOfTheHeight * window()->height());
    for (m_pixels = largestFont; m_pixels > least; m_pixels -= 2)
        if (const QRect text = textRect(m_pixels, room);
            text.width() <= room && text.height() + 2 * margin <= most)
            break;
    setGeometry(QRect(corner, QSize(width, textRect(m_pixels, room).height() + 2 * (margin + frame))));
    update();
}

void StopNotice::paintEvent(QPaintEvent*)
{
    const ThemeTokens& t = Theme::instance().tokens();
    QPainter painter(this);
    painter.fillRect(rect(), t.stop);
    const QRect inner = rect().adjusted(frame, frame, -frame, -frame);
    painter.fillRect(inner, t.text); // text and page the other way round: the most contrast that a theme has
    painter.setPen(t.page);
    painter.setFont(Theme::font(m_pixels, true));
    painter.drawText(inner.adjusted(margin, margin, -margin, -margin), Qt::TextWordWrap | Qt::AlignCenter,
                     notObeyedWords());
}

} // namespace gripscope
