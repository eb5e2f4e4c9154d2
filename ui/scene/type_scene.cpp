// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/type_scene.h"

#include "ui/scene/scene_marks.h"
#include "ui/widgets/number_format.h"

#include <QCoreApplication>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString words(const char* text)
{
    return QCoreApplication::translate("gripscope::TypeScene", text);
}

std::array<AxisScale, 3> axesFor(const TypeSpace& space, const SceneContent& all)
{
    const auto bounds = contentBounds(all);
    const auto axis = [&](const char* name, const QString& unit, int row) {
        return axisScale(words(name), unit, bounds(row, 0), bounds(row, 1));
    };
    return {axis(QT_TRANSLATE_NOOP("gripscope::TypeScene", "Mass m"), space.units.m, 0),
            axis(QT_TRANSLATE_NOOP("gripscope::TypeScene", "Damping b"), space.units.b, 1),
            axis(QT_TRANSLATE_NOOP("gripscope::TypeScene", "Stiffness k"), space.units.k, 2)};
}

ScenePoint pointOf(const TypeSpace& space, const SpaceSqueeze& squeeze)
{
    const QString name = words(QT_TRANSLATE_NOOP("gripscope::TypeScene", "%1, squeeze %2"))
                             .arg(space.types[squeeze.type])
                             .arg(squeeze.number);
    return {squeeze.id, squeeze.parameters.vector(), squeeze.type, typeShape(squeeze.type),
            name + u'\n' + parametersText(squeeze.parameters, space.units)};
}

SceneContent everything(const TypeSpace& space)
{
    SceneContent all;
    for (const SpaceSqueeze& squeeze : space.squeezes)
        all.points.push_back(pointOf(space, squeeze));
    for (std::size_t i = 0; i < space.ellipsoids.size(); ++i)
        if (space.ellipsoids[i])
            all.ellipsoids.push_back({*space.ellipsoids[i], int(i)});
    return all;
}

/// Takes out the points (one a squeeze so far, in order) of hidden types.
void hidePoints(SceneContent& content, const TypeSpace& space, const TypeVisibility& visible)
{
    std::vector<ScenePoint> shown;
    for (std::size_t i = 0; i < content.points.size(); ++i)
        if (visible[std::size_t(space.squeezes[i].type)])
            shown.push_back(std::move(content.points[i]));
    content.points = std::move(shown);
}

} // namespace

SceneContent typeScene(const TypeSpace& space, const TypeVisibility& visible,
                       const std::optional<SceneHighlight>& highlight)
{
    SceneContent content = everything(space);
    content.highlight = highlight;
    content.axes = axesFor(space, content);
    hidePoints(content, space, visible);
    std::erase_if(content.ellipsoids,
                  [&](const SceneEllipsoid& e) { return !visible[std::size_t(e.color)]; });
    return content;
}

SceneContent clusterScene(const TypeSpace& space, const TypeVisibility& visible,
                          const SpaceClustering& clustering, int step)
{
    SceneContent content = everything(space);
    content.axes = axesFor(space, content); // as with the ellipsoids: changing the view moves nothing
    content.ellipsoids.clear();
    const std::vector<int>& labels = clustering.result.steps[std::size_t(step)].labels;
    for (std::size_t i = 0; i < content.points.size(); ++i)
        content.points[i].color = labels[i];
    hidePoints(content, space, visible);
    const Eigen::Index clusters = clustering.centroids[std::size_t(step)].rows();
    for (Eigen::Index cluster = 0; cluster < clusters; ++cluster) {
        SceneCentroid centroid;
        centroid.color = int(cluster);
        for (int n = 0; n <= step; ++n)
            centroid.trail.emplace_back(clustering.centroids[std::size_t(n)].row(cluster).transpose());
        content.centroids.push_back(std::move(centroid));
    }
    return content;
}

QString parametersText(const MassDampingStiffness& parameters, const ParameterUnits& units)
{
    const auto one = [](const QString& name, double value, const QString& unit) {
        return u"%1 %2"_s.arg(
            name, formatNumber(value, std::nullopt, unit == u"1" ? QString() : unit).valueWithUnit());
    };
    return u"%1, %2, %3"_s.arg(one(u"m"_s, parameters.m, units.m), one(u"b"_s, parameters.b, units.b),
                               one(u"k"_s, parameters.k, units.k));
}

} // namespace gripscope
