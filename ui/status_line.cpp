// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/status_line.h"

#include "core/calibration/calibration_record.h"
#include "ui/connection_words.h"
#include "ui/models/calibration_words.h"
#include "ui/models/reference_words.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/number_format.h"
#include "ui/workbench.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QTimer>

using namespace Qt::StringLiterals;

namespace gripscope {

StatusLine::StatusLine(Workbench& workbench, QWidget* parent) : QFrame(parent), m_workbench(&workbench)
{
    setRole(this, "bar");
    setFixedHeight(32);
    m_label = new ElidedLabel({}, this);
    setRole(m_label, "caption");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 0, 16, 0);
    row->addWidget(m_label);
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, &StatusLine::refresh);
    timer->start(500);
    connect(&workbench, &Workbench::connectionChanged, this, &StatusLine::refresh);
    connect(&workbench, &Workbench::libraryChanged, this, &StatusLine::askVersion);
    askVersion();
    refresh();
}

void StatusLine::askVersion()
{
    m_workbench->ask<qint64>(
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
    words.removeAll(QString());
    return words;
}

void StatusLine::refresh()
{
    ConnectSession& connection = m_workbench->connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const ConnectionWords chip = chipWords(connection);
    QStringList parts{connected ? chip.detail : chip.headline}; // the chip has no room for both everywhere
    parts << tr("armed: %1").arg(connection.armed() ? tr("yes") : tr("no"));
    if (connected) {
        const LinkCounters counters = connection.counters();
        parts << tr("latency %1 ms").arg(counters.latency_ms, 0, 'f', 0);
        if (counters.stalled)
            parts << tr("silent");
        parts << standing();
    }
    const QFileInfo library(m_workbench->library().file());
    parts << (m_version > 0 ? tr("library %1 v%2").arg(library.completeBaseName()).arg(m_version)
                            : tr("library %1").arg(library.completeBaseName()));
    const auto types = static_cast<int>(m_workbench->inspection().types().size());
    parts << (types == 1 ? tr("1 type") : tr("%n types", nullptr, types));
    parts << tr("%1 inspected").arg(formatCount(m_workbench->inspection().counts().total));
    const QString separator = u"  ·  "_s;
    m_shown = parts.join(separator);
    m_label->setParts(parts, separator);
}

} // namespace gripscope
