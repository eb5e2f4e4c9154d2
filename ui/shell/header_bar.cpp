// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/connect_session.h"
#include "ui/context/connection_words.h"
#include "ui/context/sign_in.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/library/library_dialog.h"
#include "ui/people/people_dialogs.h"
#include "ui/people/sign_in_dialog.h"
#include "ui/shell/arming.h"
#include "ui/shell/connect_menu.h"
#include "ui/shell/window_bars.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/outcome_view.h"
#include "ui/windows/stop_controls.h"

#include <QAbstractButton>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QWidget>

#include <algorithm>
#include <chrono>

namespace gripscope {

using namespace Qt::StringLiterals;

/// The gripper at a glance: a sign and a word for its state, name, rate and lost reports. Pressed, it opens
/// the menu to connect another.
class DeviceChip : public QAbstractButton {
    Q_OBJECT
public:
    explicit DeviceChip(QWidget* parent = nullptr);
    /// `losing`: reports are being lost, or none come.
    void setLink(ConnectSession::State state, const QString& words, const QString& detail, bool losing);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {168, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintState(QPainter& painter, const QPointF& centre) const;
    ConnectSession::State m_state = ConnectSession::State::Disconnected;
    QString m_words, m_detail;
    bool m_losing = false;
};

DeviceChip::DeviceChip(QWidget* parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void DeviceChip::setLink(ConnectSession::State state, const QString& words, const QString& detail,
                         bool losing)
{
    if (state == m_state && words == m_words && detail == m_detail && losing == m_losing)
        return;
    m_losing = losing;
    const bool resized = words.size() != m_words.size() || detail.size() != m_detail.size();
    m_state = state;
    m_words = words;
    m_detail = detail;
    setAccessibleName(tr("Gripper: %1").arg(words));
    setAccessibleDescription(losing ? tr("%1 · reports are being lost").arg(detail) : detail);
    setToolTip(detail.isEmpty() ? words : u"%1 · %2"_s.arg(words, detail));
    if (resized)
        updateGeometry();
    update();
}

QSize DeviceChip::sizeHint() const
{
    const int words = QFontMetrics(Theme::font(metrics::fontBase, true)).horizontalAdvance(m_words);
    const int detail = QFontMetrics(Theme::font(metrics::fontBase)).horizontalAdvance(m_detail);
    return {36 + words + (detail ? 8 + detail : 0) + 34, metrics::touchTarget};
}

void DeviceChip::paintState(QPainter& painter, const QPointF& c) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    switch (m_state) {
    case ConnectSession::State::Connected:
        if (m_losing) {
            paintOutcomeSign(painter, QRectF(c.x() - 9, c.y() - 9, 18, 18), InspectionOutcome::NotValid,
                             t.notValid);
            break;
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(t.asExpected);
        painter.drawEllipse(c, 6, 6);
        break;
    case ConnectSession::State::Connecting:
        painter.setPen(QPen(t.accent, 2.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawArc(QRectF(c.x() - 6, c.y() - 6, 12, 12), 45 * 16, 270 * 16);
        break;
    case ConnectSession::State::Lost:
        paintOutcomeSign(painter, QRectF(c.x() - 9, c.y() - 9, 18, 18), InspectionOutcome::NotValid,
                         t.notValid);
        break;
    case ConnectSession::State::Disconnected:
        painter.setPen(QPen(t.secondText, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(c, 5.5, 5.5);
        break;
    }
}

void DeviceChip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeTokens& t = Theme::instance().tokens();
    const double w = hasFocus() ? 2 : t.lineWidth;
    painter.setPen(QPen(hasFocus() ? t.accent : t.line, w));
    painter.setBrush(isDown()       ? Theme::mix(t.surface, t.text, 0.12)
                     : underMouse() ? Theme::mix(t.surface, t.text, 0.06)
                                    : t.page);
    painter.drawRoundedRect(QRectF(rect()).adjusted(w / 2, w / 2, -w / 2, -w / 2), height() / 2.0,
                            height() / 2.0);
    paintState(painter, {20, height() / 2.0});
    const double end = width() - 30;
    // The name first: rate and losses are in the status line too.
    const QFont strong = Theme::font(metrics::fontBase, true);
    const QFont plain = Theme::font(metrics::fontBase);
    const QFontMetricsF strongMetrics(strong);
    const double room = end - 36;
    const QString words = elided(strongMetrics, m_words, room);
    painter.setFont(strong);
    painter.setPen(t.text);
    painter.drawText(QRectF(36, 0, room, height()), Qt::AlignLeft | Qt::AlignVCenter, words);
    const double from = 36 + strongMetrics.horizontalAdvance(words) + 8;
    if (QFontMetricsF(plain).horizontalAdvance(m_detail) <= end - from) {
        painter.setFont(plain);
        painter.setPen(t.secondText);
        painter.drawText(QRectF(from, 0, end - from, height()), Qt::AlignLeft | Qt::AlignVCenter, m_detail);
    }
    painter.setPen(QPen(t.secondText, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF tip(width() - 18, height() / 2.0 + 2);
    painter.drawPolyline(QPolygonF{{tip.x() - 4, tip.y() - 4}, tip, {tip.x() + 4, tip.y() - 4}});
}

/// Who works here, in the header: a field for the name while nobody has to sign in, else who has signed in;
/// and the menu for signing in and out, people and the audit trail.
class OperatorBox : public QWidget {
    Q_OBJECT
public:
    explicit OperatorBox(Workbench& workbench, QWidget* parent = nullptr);

private:
    void makeField();
    void refresh();
    void fillMenu();
    Workbench* m_workbench;
    QLabel* m_caption;
    QLineEdit* m_name;
    QPushButton* m_chip;
    QMenu* m_menu;
};

OperatorBox::OperatorBox(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_caption(makeLabel(tr("Operator"), "caption", this)),
      m_name(new QLineEdit(this)), m_chip(makeButton({}, u"user"_s, "", this)), m_menu(new QMenu(this))
{
    makeField();
    m_chip->setObjectName("operatorChip");
    m_menu->setObjectName("operatorMenu");
    m_menu->setAccessibleName(tr("People"));
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 8);
    row->addWidget(m_caption);
    row->addWidget(m_name);
    row->addWidget(m_chip);
    connect(m_chip, &QPushButton::clicked, this, [this] {
        m_workbench->signIn().reload(); // somebody may have been added elsewhere
        fillMenu();
        m_menu->popup(m_chip->mapToGlobal(QPoint(0, m_chip->height() + 4)));
    });
    connect(&workbench.signIn(), &SignIn::changed, this, &OperatorBox::refresh);
    refresh();
}

void OperatorBox::makeField()
{
    m_name->setObjectName("operatorField");
    m_name->setPlaceholderText(tr("name"));
    m_name->setAccessibleName(tr("Operator"));
    m_name->setToolTip(tr("Who works here: kept with every squeeze"));
    m_name->setMaxLength(80);
    m_name->setFixedWidth(120);
    m_name->setText(m_workbench->operatorName());
    m_caption->setBuddy(m_name);
    connect(m_name, &QLineEdit::textEdited, this,
            [this](const QString& text) { m_workbench->setOperatorName(text.trimmed()); });
    connect(m_workbench, &Workbench::operatorChanged, this, [this] {
        if (m_name->text().trimmed() != m_workbench->operatorName())
            m_name->setText(m_workbench->operatorName());
    });
}

void OperatorBox::refresh()
{
    const SignIn& signIn = m_workbench->signIn();
    const std::optional<Authority>& who = signIn.current();
    m_name->setVisible(!signIn.inForce());
    m_caption->setVisible(!signIn.inForce());
    // A long name gives way to the gripper beside it.
    constexpr int roomForName = 150;
    const QString name = who ? elided(m_chip->fontMetrics(), who->name(), roomForName) : tr("Sign in");
    m_chip->setText(signIn.inForce() ? name : QString());
    m_chip->setFixedWidth(signIn.inForce() ? QWIDGETSIZE_MAX : 56);
    m_chip->setMinimumWidth(signIn.inForce() ? 0 : 56);
    m_chip->setAccessibleName(!signIn.inForce() ? tr("People")
                              : who             ? tr("%1, %2").arg(who->name(), inWords(who->role()))
                                                : tr("Nobody has signed in"));
    m_chip->setToolTip(signIn.inForce() ? m_chip->accessibleName()
                                        : tr("People, the audit trail and the library"));
}

void OperatorBox::fillMenu()
{
    const SignIn& signIn = m_workbench->signIn();
    QWidget* over = window();
    m_menu->clear();
    const auto add = [this](const QString& text, const char* name, auto action) {
        QAction* entry = m_menu->addAction(text);
        entry->setObjectName(QString::fromLatin1(name));
        connect(entry, &QAction::triggered, this, action);
    };
    if (signIn.inForce()) {
        add(signIn.current() ? tr("Sign in as somebody else…") : tr("Sign in…"), "signInAction",
            [this, over] { (new SignInDialog(*m_workbench, std::nullopt, over))->open(); });
        if (signIn.current())
            add(tr("Sign out"), "signOutAction", [this] { m_workbench->signIn().signOut(); });
        m_menu->addSeparator();
    }
    add(tr("Library…"), "libraryAction", [this, over] { (new LibraryDialog(*m_workbench, over))->open(); });
    add(tr("People…"), "peopleAction", [this, over] { (new PeopleDialog(*m_workbench, over))->open(); });
    add(tr("Audit trail…"), "auditAction", [this, over] { (new AuditDialog(*m_workbench, over))->open(); });
}

namespace {

constexpr int holdingHeight = 6;

/// Fills from left to right along the lower edge of a button.
class HoldBar : public QWidget {
public:
    HoldBar(const ArmChord& chord, QWidget* button) : QWidget(button), m_chord(&chord)
    {
        setObjectName("armHolding");
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const double share = m_chord->progress().value_or(0);
        painter.fillRect(QRectF(0, 0, share * width(), height()), Theme::instance().tokens().accent);
    }

private:
    const ArmChord* m_chord;
};

} // namespace

HeaderBar::HeaderBar(Workbench& workbench, QWidget* parent) : QFrame(parent), m_workbench(&workbench)
{
    setRole(this, "bar");
    setFixedHeight(64);
    m_title = makeLabel({}, "title", this);
    m_stopped = makeLabel(tr("Stopped"), "stopped", this);
    m_stopped->setObjectName("stoppedLabel");
    m_chip = new DeviceChip(this);
    m_chip->setObjectName("deviceChip");
    m_menu = new ConnectMenu(workbench, this);
    connect(m_chip, &DeviceChip::clicked, this,
            [this] { m_menu->popup(m_chip->mapToGlobal(QPoint(0, m_chip->height() + 4))); });

    m_arm = makeButton(tr("Arm"), u"object-locked"_s, "", this);
    m_arm->setObjectName("armButton");
    m_arm->setCheckable(true);
    m_arm->setMinimumWidth(132);
    connect(m_arm, &QPushButton::clicked, this, [this] {
        if (m_workbench->connection().armed())
            m_workbench->connection().disarm();
        else
            m_workbench->arm();
        refreshArmed();
    });
    m_chord = new ArmChord(workbench, this);
    m_chord->setObjectName("armChord");
    m_holding = new HoldBar(*m_chord, m_arm);
    connect(m_chord, &ArmChord::changed, this, &HeaderBar::refreshHolding);

    auto* stop = new StopButton(workbench, 48, this);
    stop->setObjectName("stopButton");

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 16, 8);
    row->setSpacing(12);
    row->addWidget(m_title);
    row->addWidget(m_stopped);
    row->addStretch(1);
    row->addWidget(m_chip, 0);
    row->addWidget(new OperatorBox(workbench, this));
    row->addWidget(m_arm);
    row->addWidget(stop);

    const StopStanding& standing = StopStanding::of(workbench);
    const auto tellStopped = [this, &standing] { m_stopped->setVisible(standing.stopped()); };
    connect(&standing, &StopStanding::changed, this, tellStopped);
    tellStopped();
    const auto refresh = [this] {
        refreshLink();
        refreshArmed();
    };
    connect(&workbench, &Workbench::connectionChanged, this, refresh);
    connect(&Theme::instance(), &Theme::changed, this, [this] {
        m_arm->setToolTip({}); // its icon has the colours of the theme
        refreshArmed();
    });
    // Counts change without a signal; and a state that came and went between two polls is told by none.
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, refresh);
    timer->start(250);
    refresh();
}

void HeaderBar::setTitle(const QString& title)
{
    m_title->setText(title);
}

void HeaderBar::refreshLink()
{
    const ConnectSession& connection = m_workbench->connection();
    const ConnectionWords words = chipWords(connection);
    const LinkCounters counters = connection.counters();
    m_losses.look(counters, std::chrono::steady_clock::now());
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const bool losing = connected && m_losses.losing();
    m_chip->setLink(connection.state(), words.headline,
                    losing ? tr("loses %1").arg(formatPercent(100 * m_losses.share())) : words.detail,
                    losing || counters.stalled);
}

void HeaderBar::refreshHolding()
{
    m_holding->setGeometry(0, m_arm->height() - holdingHeight, m_arm->width(), holdingHeight);
    m_holding->setVisible(m_chord->progress().has_value());
    m_holding->update();
    refreshArmed();
}

void HeaderBar::refreshArmed()
{
    ConnectSession& connection = m_workbench->connection();
    const bool armed = connection.armed();
    const bool possible =
        connection.state() == ConnectSession::State::Connected && connection.identity().commandable;
    const QString text = armed ? tr("Armed") : m_chord->progress() ? tr("Hold…") : tr("Arm");
    if (armed == m_arm->isChecked() && possible == m_arm->isEnabled() && text == m_arm->text() &&
        !m_arm->toolTip().isEmpty())
        return;
    m_arm->setChecked(armed);
    m_arm->setEnabled(possible);
    m_arm->setText(text);
    m_arm->setAccessibleName(armed ? tr("Armed; press to disarm") : tr("Arm the gripper"));
    m_arm->setToolTip(
        armed ? tr("The gripper may move. Press to disarm it.")
        : possible
            ? tr("Let the gripper move when a squeeze is asked for. By keys: hold Ctrl+Shift+A for a second")
            : tr("No gripper that can be commanded is connected"));
    const ThemeTokens& tokens = Theme::instance().tokens();
    m_arm->setIcon(armed ? Theme::instance().icon(u"object-unlocked"_s, tokens.accent)
                         : Theme::instance().icon(u"object-locked"_s)); // locked is what cannot move
}

} // namespace gripscope

#include "header_bar.moc"
