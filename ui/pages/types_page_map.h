// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/map_planes.h"

#include <QWidget>

#include <array>

namespace gripscope {

class HeatMap;

/// The planes of a self-organizing map, two by two: U-matrix, m, b, k. Pointing at a unit in one frames it in
/// all.
class MapPanel : public QWidget {
    Q_OBJECT
public:
    explicit MapPanel(QWidget* parent = nullptr);

    void setMap(const MapPlanes& map);
    [[nodiscard]] HeatMap* plane(int number) const { return m_maps[std::size_t(number)]; }

private:
    std::array<HeatMap*, 4> m_maps;
};

} // namespace gripscope
