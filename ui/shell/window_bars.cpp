// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/window_bars.h"

#include "core/calibration/calibration_record.h"
#include "core/library/library.h"
#include "ui/context/connection_words.h"
#include "ui/context/workbench.h"
#include "ui/format/calibration_words.h"
#include "ui/format/number_format.h"
#include "ui/format/reference_words.h"
#include "ui/format/study_due_words.h"
#include "ui/line/line_station.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/windows/stop_controls.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QPainter>
#include <QTimer>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr int mostStudies = 200; // the newest: what is due rests on the last of each kind
}

RailButton::RailButton(const QString& text, const QString& icon, QWidget* parent)
    : QAbstractButton(parent), m_icon(icon)
{
    setText(text);
    setAccessibleName(text);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

QSize RailButton::sizeHint() const
{
    const int word = QFontMetrics(Theme::font(metrics::fontSmall, true)).horizontalAdvance(text());
    return {word + 2 * metrics::step, 64};
}

void RailButton::enterEvent(QEnterEvent* event)
{
    QAbstractButton::enterEvent(event);
    update();
}

void RailButton::leaveEvent(QEvent* event)
{
    QAbstractButton::leaveEvent(event);
    update();
}

void RailButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeTokens& t = Theme::instance().tokens();
    const QRectF box = QRectF(rect()).adjusted(6, 2, -6, -2);
    painter.setPen(Qt::NoPen);
    if (isChecked())
        painter.setBrush(Theme::mix(t.surface, t.accent, t.kind == ThemeKind::HighContrast ? 0.0 : 0.12));
    else if (underMouse() || isDown())
        painter.setBrush(Theme::mix(t.surface, t.text, isDown() ? 0.12 : 0.06));
    painter.drawRoundedRect(box, metrics::radius, metrics::radius);
    if (isChecked()) {
        painter.setBrush(t.accent);
        painter.drawRoundedRect(QRectF(0, box.top() + 8, 4, box.height() - 16), 2, 2);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(t.accent, 2));
        painter.drawRoundedRect(box.adjusted(1, 1, -1, -1), metrics::radius, metrics::radius);
    }
    const QColor color = isChecked() ? t.accent : t.text;
    const double middle = box.center().x();
    Theme::instance()
        .icon(m_icon, color)
        .paint(&painter, QRectF(middle - 12, box.top() + 8, 24, 24).toRect());
    painter.setPen(color);
    painter.setFont(Theme::font(metrics::fontSmall, isChecked()));
    painter.drawText(QRectF(box.left(), box.bottom() - 24, box.width(), 18), Qt::AlignCenter, text());
}

StatusLine::StatusLine(Workbench& workbench, QWidget* parent) : QFrame(parent), m_workbench(&workbench)
{
    setRole(this, "bar");
    setFixedHeight(32);
    m_label = new ElidedLabel({}, this);
    m_label->setObjectName("statusText");
    setRole(m_label, "caption");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 0, 16, 0);
    row->addWidget(m_label);
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, &StatusLine::refresh);
    timer->start(500);
    connect(&workbench, &Workbench::connectionChanged, this, &StatusLine::refresh);
    connect(&workbench, &Workbench::libraryChanged, this, &StatusLine::askVersion);
    connect(&workbench, &Workbench::studyChanged, this, &StatusLine::askStudies);
    askVersion();
    askStudies();
    refresh();
}

void StatusLine::askStudies()
{
    const bool ended = m_workbench->study().state() == StudySession::State::Ended;
    if (std::exchange(m_studyEnded, ended) == ended)
        return;
    using Studies = std::vector<StudyRecord>;
    m_workbench->background().ask<Studies>(
        this, [](Library& library) { return library.studies(mostStudies); },
        [this](Expected<Studies> studies) { m_studies = std::move(studies).value_or(Studies()); });
}

void StatusLine::askVersion()
{
    m_workbench->background().ask<qint64>(
        this, [](Library& library) { return library.version(); },
        [this](const Expected<qint64>& version) { m_version = version.value_or(0); });
}

QStringList StatusLine::standing() const
{
    const ConnectSession& connection = m_workbench->connection();
    const ChannelCalibration& calibration = connection.calibration();
    if (connection.identity().corrected) // what is played back is as it was calibrated then
        return {};
    const QDate today = QDate::currentDate();
    const CalibrationRecord* force = calibration.record(SensorChannel::Force);
    const CalibrationRecord* position = calibration.record(SensorChannel::Position);
    QStringList words{CalibrationWords::brief(SensorChannel::Force, force, today)};
    // The other channel where it comes first.
    if (position != nullptr && (force == nullptr || position->due < force->due))
        words << CalibrationWords::brief(SensorChannel::Position, position, today);
    words << ReferenceWords::brief(calibration.reference(), QDateTime::currentDateTimeUtc());
    words << StudyDueWords::brief(studyStandings(m_studies, connection.identity().serial), today);
    words.removeAll(QString());
    return words;
}

void StatusLine::refresh()
{
    ConnectSession& connection = m_workbench->connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const ConnectionWords chip = chipWords(connection);
    QStringList parts{connected ? chip.detail : chip.headline}; // the chip has no room for both everywhere
    parts << (StopStanding::of(*m_workbench).stopped()
                  ? tr("stopped: not armed")
                  : tr("armed: %1").arg(connection.armed() ? tr("yes") : tr("no")));
    if (connected) {
        const LinkCounters counters = connection.counters();
        parts << tr("latency %1 ms").arg(counters.latency_ms, 0, 'f', 0);
        if (counters.stalled)
            parts << tr("silent");
        parts << standing();
    }
    const auto tell = [&parts](const auto& station) {
        if (!station.on())
            return;
        const LineWords words = station.words();
        parts << words.headline.describe() << described(words.problems);
    };
    tell(LineStation::of(*m_workbench));
    tell(MqttStation::of(*m_workbench));
    tell(PlantStation::of(*m_workbench));
    const QString place = m_workbench->library().file();
    const QString library =
        Library::isOnServer(place) ? Library::shortName(place) : QFileInfo(place).completeBaseName();
    parts << (m_version > 0 ? tr("library %1 v%2").arg(library).arg(m_version)
                            : tr("library %1").arg(library));
    const auto types = static_cast<int>(m_workbench->inspection().types().size());
    parts << (types == 1 ? tr("1 type") : tr("%n types", nullptr, types));
    parts << tr("%1 inspected").arg(formatCount(m_workbench->inspection().counts().total));
    const QString separator = u"  ·  "_s;
    m_shown = parts.join(separator);
    m_label->setParts(parts, separator);
}

} // namespace gripscope
