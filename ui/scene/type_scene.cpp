// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/type_scene.h"

#include "core/math/normal_interval.h"
#include "ui/format/number_format.h"
#include "ui/scene/scene_marks.h"

#include <QCoreApplication>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString sceneWord(const char* text)
{
    return QCoreApplication::translate("gripscope::TypeScene", text);
}

std::array<AxisScale, 3> axesFor(const TypeSpace& space, const SceneContent& all)
{
    const auto bounds = contentBounds(all);
    const auto axis = [&](const char* name, const QString& unit, int row) {
        return axisScale(sceneWord(name), unit, bounds(row, 0), bounds(row, 1));
    };
    return {axis(QT_TRANSLATE_NOOP("gripscope::TypeScene", "Mass m"), space.units.m, 0),
            axis(QT_TRANSLATE_NOOP("gripscope::TypeScene", "Damping b"), space.units.b, 1),
            axis(QT_TRANSLATE_NOOP("gripscope::TypeScene", "Stiffness k"), space.units.k, 2)};
}

/// More errors than this hide each other and the points.
constexpr std::size_t mostErrors = 500;

int signOf(const TypeSpace& space, int type)
{
    return space.signs[std::size_t(type)];
}

SceneContent everything(const TypeSpace& space)
{
    SceneContent all;
    all.points.reserve(space.squeezes.size());
    for (const SpaceSqueeze& squeeze : space.squeezes) {
        const int sign = signOf(space, squeeze.type);
        all.points.push_back({squeeze.id, squeeze.parameters.vector(), sign, typeShape(sign)});
    }
    for (std::size_t i = 0; i < space.ellipsoids.size(); ++i)
        if (space.ellipsoids[i])
            all.ellipsoids.push_back({*space.ellipsoids[i], signOf(space, int(i))});
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

/// The map as it stands in a state, added to what is there.
void includeNet(SceneContent& content, const SpaceClustering& clustering, int state)
{
    const auto* map = std::get_if<SelfOrganizingMapResult>(&clustering.outcome.details);
    if (!map)
        return;
    const Eigen::MatrixXd weights = clustering.weights(state);
    if (!content.net)
        content.net.emplace();
    SceneNet& net = *content.net;
    for (Eigen::Index unit = 0; unit < weights.rows(); ++unit)
        net.nodes.emplace_back(weights.row(unit).transpose());
    net.colors = map->groupOfUnit;
    net.edges.clear();
    for (int unit = 0; unit < int(weights.rows()); ++unit) {
        if ((unit + 1) % map->columns != 0)
            net.edges.emplace_back(unit, unit + 1);
        if (unit + map->columns < int(weights.rows()))
            net.edges.emplace_back(unit, unit + map->columns);
    }
}

void addCentres(SceneContent& content, const SpaceClustering& clustering, int state)
{
    for (int n = 0; n <= state; ++n) {
        const Eigen::MatrixXd centres = clustering.centres(n);
        content.centroids.resize(std::size_t(centres.rows()));
        for (Eigen::Index cluster = 0; cluster < centres.rows(); ++cluster) {
            SceneCentroid& centroid = content.centroids[std::size_t(cluster)];
            centroid.color = int(cluster);
            centroid.trail.emplace_back(centres.row(cluster).transpose());
        }
    }
}

} // namespace

SceneContent typeScene(const TypeSpace& space, const TypeVisibility& visible,
                       const std::optional<SceneHighlight>& highlight)
{
    SceneContent content = everything(space);
    content.highlight = highlight;
    content.axes = axesFor(space, content);
    hidePoints(content, space, visible);
    content.ellipsoids.clear();
    for (std::size_t i = 0; i < space.ellipsoids.size(); ++i)
        if (space.ellipsoids[i] && visible[i])
            content.ellipsoids.push_back({*space.ellipsoids[i], signOf(space, int(i))});
    if (space.squeezes.size() <= mostErrors)
        for (const SpaceSqueeze& squeeze : space.squeezes)
            if (const auto error = ownEllipsoid(squeeze); error && visible[std::size_t(squeeze.type)])
                content.errors.push_back({*error, signOf(space, squeeze.type)});
    return content;
}

SceneContent clusterScene(const TypeSpace& space, const TypeVisibility& visible,
                          const SpaceClustering& clustering, int state)
{
    SceneContent content = everything(space);
    for (int n = 0; n < clustering.states(); ++n) // the net never leaves the axes
        includeNet(content, clustering, n);
    content.axes = axesFor(space, content); // as with the ellipsoids: changing the view moves nothing
    content.ellipsoids.clear();
    content.net.reset();
    const std::vector<int>& labels = clustering.labels(state);
    for (std::size_t i = 0; i < content.points.size(); ++i)
        content.points[i].color = labels[i];
    hidePoints(content, space, visible);
    addCentres(content, clustering, state);
    const auto ellipsoids = clustering.ellipsoids(state);
    for (std::size_t i = 0; i < ellipsoids.size(); ++i)
        if (ellipsoids[i])
            content.ellipsoids.push_back({*ellipsoids[i], int(i)});
    includeNet(content, clustering, state);
    return content;
}

QString squeezeName(const TypeSpace& space, const SpaceSqueeze& squeeze)
{
    return sceneWord(QT_TRANSLATE_NOOP("gripscope::TypeScene", "%1, squeeze %2"))
        .arg(space.types[squeeze.type])
        .arg(squeeze.number);
}

QString parametersText(const MassDampingStiffness& parameters, const ParameterUnits& units,
                       const std::optional<Eigen::Matrix3d>& covariance)
{
    const auto one = [&](const QString& name, int at, double value, const QString& unit) {
        const std::optional<double> error =
            covariance ? std::optional(normal95 * std::sqrt((*covariance)(at, at))) : std::nullopt;
        return u"%1 %2"_s.arg(name, formatNumber(value, error, unit == u"1" ? QString() : unit).text());
    };
    return QStringList{one(u"m"_s, 0, parameters.m, units.m), one(u"b"_s, 1, parameters.b, units.b),
                       one(u"k"_s, 2, parameters.k, units.k)}
        .join(covariance ? u"\n"_s : u", "_s);
}

} // namespace gripscope
