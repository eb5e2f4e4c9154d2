// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/history_charts.h"

#include "ui/charts/trend_view.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPainter>

namespace gripscope {

/// The signs of the types with their names, as many as there is room for.
class HistoryCharts::Legend : public QWidget {
public:
    Legend() { setFixedHeight(metrics::touchTarget); }
    const TrendContent* content = nullptr;

protected:
    void paintEvent(QPaintEvent*) override
    {
        if (!content || !content->points)
            return;
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        paintTypeLegend(painter, *content, rect(), Theme::instance().tokens());
    }
};

HistoryCharts::HistoryCharts(QWidget* parent)
    : QWidget(parent), m_view(new TrendView), m_legend(new Legend), m_byTime(makeButton(tr("Over time"))),
      m_byPlace(makeButton(tr("One after another")))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, metrics::step, metrics::insideControl);
    auto* line = new QHBoxLayout;
    line->setSpacing(metrics::step);
    line->addWidget(m_legend, 1);
    auto* group = new QButtonGroup(this);
    for (QPushButton* button : {m_byTime, m_byPlace}) {
        button->setCheckable(true);
        group->addButton(button);
        line->addWidget(button);
    }
    m_byTime->setChecked(true);
    m_byPlace->setObjectName("historyByPlace");
    column->addLayout(line);
    column->addWidget(m_view, 1);
    QLabel* note =
        makeLabel(tr("Bands: where 95 % of the squeezes of an enrolled type lie. Bars: 95 % intervals "
                     "of the squeeze. Drag to zoom, double click to see everything."),
                  "second");
    note->setWordWrap(true);
    column->addWidget(note);
    connect(m_byTime, &QPushButton::toggled, this, [this] { refresh(); });
    connect(m_view, &TrendView::pointChosen, this, [this](qsizetype place) {
        if (m_points && std::size_t(place) < m_points->keys.size())
            emit chosen(m_points->keys.at(std::size_t(place)));
    });
    connect(&Theme::instance(), &Theme::changed, m_legend, qOverload<>(&QWidget::update));
}

void HistoryCharts::setPoints(std::shared_ptr<const HistoryPoints> points, const TypeModels& models)
{
    m_points = std::move(points);
    m_models = models;
    refresh();
}

void HistoryCharts::refresh()
{
    if (!m_points)
        return;
    m_view->setContent(trendContent(m_points, m_models, m_byTime->isChecked()));
    m_legend->content = &m_view->content();
    m_legend->update();
}

void HistoryCharts::select(const QString& key)
{
    m_view->setSelected(m_points && !key.isEmpty() ? m_points->keys.find(key) : std::nullopt);
}

} // namespace gripscope
