// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/map_planes.h"

#include "ui/models/space_clustering.h"
#include "ui/widgets/number_format.h"

#include <QCoreApplication>

#include <map>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString words(const char* text)
{
    return QCoreApplication::translate("gripscope::MapPlanes", text);
}

MapPlane plane(const QString& title, const QString& meaning, const QString& unit,
               const Eigen::MatrixXd& values)
{
    MapPlane result;
    result.title = title;
    result.meaning = meaning;
    result.scale = axisScale(title, unit, values.minCoeff(), values.maxCoeff());
    result.scale.low = values.minCoeff();
    result.scale.high = values.maxCoeff();
    result.values = values;
    return result;
}

/// "3 squeezes: 2 of A, 1 of B" for every unit.
std::vector<QString> squeezesOfUnits(const TypeSpace& space, const SelfOrganizingMapResult& map)
{
    std::vector<std::map<int, int>> counts(map.hits.size());
    for (std::size_t i = 0; i < map.unitOfItem.size(); ++i)
        ++counts[std::size_t(map.unitOfItem[i])][space.squeezes[i].type];
    std::vector<QString> texts;
    texts.reserve(counts.size());
    for (std::size_t unit = 0; unit < counts.size(); ++unit) {
        QStringList types;
        for (const auto& [type, count] : counts[unit])
            types << words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "%1 of %2"))
                         .arg(formatCount(count), space.types[type]);
        texts.push_back(
            types.isEmpty()
                ? words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "No squeezes here"))
                : words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Squeezes: %1")).arg(types.join(u", "_s)));
    }
    return texts;
}

} // namespace

QString MapPlanes::describe(int unit, int plane) const
{
    if (unit < 0 || unit >= rows * columns)
        return {};
    const MapPlane& one = planes[std::size_t(plane)];
    return u"%1: %2\n%3\n%4"_s.arg(
        one.title, one.scale.valueText(one.values(unit / columns, unit % columns)),
        squeezes[std::size_t(unit)],
        words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Row %1, column %2 of the map, cluster %3"))
            .arg(unit / columns + 1)
            .arg(unit % columns + 1)
            .arg(groups[std::size_t(unit)] + 1));
}

MapPlanes mapPlanes(const TypeSpace& space, const SpaceClustering& clustering)
{
    const auto* map = std::get_if<SelfOrganizingMapResult>(&clustering.outcome.details);
    if (!map || map->rows * map->columns == 0)
        return {};
    SelfOrganizingMapResult inUnits = *map;
    inUnits.weights = clustering.outcome.transform.undo(map->weights);
    MapPlanes result;
    result.rows = map->rows;
    result.columns = map->columns;
    result.hits = map->hits;
    result.groups = map->groupOfUnit;
    result.squeezes = squeezesOfUnits(space, *map);
    result.planes = {
        plane(words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "U-matrix")),
              words(QT_TRANSLATE_NOOP("gripscope::MapPlanes",
                                      "How far each unit is from its neighbours, in the scaled space. Bright "
                                      "ridges are borders between clusters.")),
              u"1"_s, map->uMatrix()),
        plane(words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Mass m")),
              words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "The mass that each unit stands for")),
              space.units.m, inUnits.componentPlane(0)),
        plane(words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Damping b")),
              words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "The damping that each unit stands for")),
              space.units.b, inUnits.componentPlane(1)),
        plane(words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Stiffness k")),
              words(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "The stiffness that each unit stands for")),
              space.units.k, inUnits.componentPlane(2))};
    return result;
}

} // namespace gripscope
