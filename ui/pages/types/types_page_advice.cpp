// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/heat_map.h"
#include "ui/models/cluster_models.h"
#include "ui/pages/fit/fit_page_table.h"
#include "ui/pages/types/types_page_clusters.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QProgressBar>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace gripscope {

MapPanel::MapPanel(QWidget* parent) : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(metrics::step);
    for (std::size_t i = 0; i < m_maps.size(); ++i) {
        m_maps[i] = new HeatMap;
        grid->addWidget(m_maps[i], int(i) / 2, int(i) % 2);
        connect(m_maps[i], &HeatMap::pointedAt, this, [this](int unit) {
            for (HeatMap* map : m_maps)
                map->setMarked(unit);
        });
    }
    auto* legend = makeLabel(tr("Dots: squeezes a unit. White lines: borders between clusters."), "caption");
    legend->setWordWrap(true);
    grid->addWidget(legend, 2, 0, 1, 2);
}

void MapPanel::setMap(const MapPlanes& map)
{
    for (std::size_t i = 0; i < m_maps.size(); ++i)
        m_maps[i]->setPlane(map, int(i), i == 0);
}

AdvicePanel::AdvicePanel(QWidget* parent)
    : QWidget(parent), m_model(new AdviceTableModel(this)),
      m_ask(makeButton(tr("How many clusters are there?"))), m_progress(new QProgressBar),
      m_cancel(makeButton(tr("Cancel"))), m_reason(makeLabel({})), m_table(makePanelTable(m_model)),
      m_use(makeButton({}))
{
    setObjectName(u"advice"_s);
    m_ask->setToolTip(tr("Compares 1 to 8 clusters by five criteria"));
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Advice on the number of clusters"));
    m_reason->setWordWrap(true);
    m_table->setAccessibleName(tr("Criteria for the number of clusters"));
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(20);
    m_table->verticalHeader()->setMinimumSectionSize(20);
    m_table->verticalHeader()->setDefaultSectionSize(24);
    m_table->setStyleSheet(u"QTableView::item { padding: 0; } QHeaderView::section { padding: 4px 0; }"_s);
    addCopyAction(m_table, [this] { return m_model->toTsv(); });
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    column->addWidget(m_ask);
    column->addWidget(m_progress);
    column->addWidget(m_cancel, 0, Qt::AlignLeft);
    column->addWidget(m_table);
    column->addWidget(m_reason);
    column->addWidget(m_use, 0, Qt::AlignLeft);
    m_poll.setInterval(100ms);
    connect(&m_poll, &QTimer::timeout, this, [this] {
        if (m_watch)
            m_progress->setValue(int(100 * m_watch->share()));
    });
    connect(m_ask, &QPushButton::clicked, this, &AdvicePanel::asked);
    connect(m_cancel, &QPushButton::clicked, this, &AdvicePanel::cancelled);
    connect(m_use, &QPushButton::clicked, this, [this] { emit chosen(m_advised); });
    refresh();
}

bool AdvicePanel::showsAdvice() const
{
    return m_model->rowCount() > 0;
}

void AdvicePanel::setRunning(const std::shared_ptr<WorkWatch>& watch)
{
    m_watch = watch;
    m_progress->setValue(0);
    m_poll.start();
    refresh();
}

void AdvicePanel::setAdvice(const ClusterAdvice& advice)
{
    m_watch.reset();
    m_model->setAdvice(advice);
    m_advised = advice.clusters;
    m_reason->setText(advice.reason.describe());
    m_use->setText(tr("Use %1").arg(advice.clusters));
    fitPanelTable(m_table);
    refresh();
}

void AdvicePanel::setFailure(const QString& words)
{
    clear();
    m_reason->setText(words);
    refresh();
}

void AdvicePanel::clear()
{
    m_watch.reset();
    m_model->clear();
    m_reason->clear();
    refresh();
}

void AdvicePanel::refresh()
{
    if (!running())
        m_poll.stop();
    m_ask->setVisible(!running() && !showsAdvice());
    m_progress->setVisible(running());
    m_cancel->setVisible(running());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_table, m_use})
        widget->setVisible(!running() && showsAdvice());
    m_reason->setVisible(!running() && !m_reason->text().isEmpty());
}

} // namespace gripscope
