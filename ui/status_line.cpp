// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/status_line.h"

#include "ui/connection_words.h"
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
    refresh();
}

void StatusLine::refresh()
{
    ConnectSession& connection = m_workbench->connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    QStringList parts{chipWords(connection).headline};
    parts << tr("armed: %1").arg(connection.armed() ? tr("yes") : tr("no"));
    if (connected) {
        const LinkCounters counters = connection.counters();
        parts << tr("latency %1 ms").arg(counters.latency_ms, 0, 'f', 0);
        if (counters.stalled)
            parts << tr("silent");
    }
    const QFileInfo library(m_workbench->library().file());
    parts << tr("library %1").arg(library.completeBaseName());
    const auto types = static_cast<int>(m_workbench->inspection().types().size());
    parts << (types == 1 ? tr("1 type") : tr("%n types", nullptr, types));
    parts << tr("%1 inspected").arg(formatCount(m_workbench->inspection().counts().total));
    m_shown = parts.join(u"  ·  "_s);
    m_label->setFullText(m_shown);
}

} // namespace gripscope
