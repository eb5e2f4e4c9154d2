// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types_page_map.h"

#include "ui/charts/heat_map.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>

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

} // namespace gripscope
