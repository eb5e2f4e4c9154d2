// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_actors.h"

#include "ui/theme/theme.h"

#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkMatrix4x4.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <map>
#include <numbers>

namespace gripscope {

namespace {

void setColor(vtkProperty* property, const QColor& color)
{
    property->SetColor(color.redF(), color.greenF(), color.blueF());
}

/// A shape of about the same visual weight as a sphere of radius 1.
vtkSmartPointer<vtkPolyDataAlgorithm> glyphSource(int shape)
{
    switch (shape % 4) {
    case 0: {
        auto sphere = vtkSmartPointer<vtkSphereSource>::New();
        sphere->SetRadius(1);
        sphere->SetThetaResolution(20);
        sphere->SetPhiResolution(14);
        return sphere;
    }
    case 1: {
        auto cube = vtkSmartPointer<vtkCubeSource>::New();
        cube->SetXLength(1.6);
        cube->SetYLength(1.6);
        cube->SetZLength(1.6);
        return cube;
    }
    case 2: {
        auto cone = vtkSmartPointer<vtkConeSource>::New();
        cone->SetDirection(0, 0, 1);
        cone->SetHeight(2.1);
        cone->SetRadius(1.15);
        cone->SetResolution(20);
        return cone;
    }
    default: {
        auto octahedron = vtkSmartPointer<vtkPlatonicSolidSource>::New();
        octahedron->SetSolidTypeToOctahedron();
        return octahedron;
    }
    }
}

vtkSmartPointer<vtkPolyData> pointSet(const std::vector<Eigen::Vector3d>& positions, bool asVertices)
{
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto vertices = vtkSmartPointer<vtkCellArray>::New();
    for (const Eigen::Vector3d& at : positions) {
        const vtkIdType id = points->InsertNextPoint(at.x(), at.y(), at.z());
        if (asVertices)
            vertices->InsertNextCell(1, &id);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    if (asVertices)
        data->SetVerts(vertices);
    return data;
}

vtkSmartPointer<vtkGlyph3DMapper> glyphMapper(vtkPolyData* points, vtkPolyDataAlgorithm* source)
{
    auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
    mapper->SetInputData(points);
    mapper->SetSourceConnection(source->GetOutputPort());
    mapper->ScalingOn();
    mapper->SetScaleModeToNoDataScaling();
    mapper->OrientOff();
    mapper->ScalarVisibilityOff();
    return mapper;
}

PointActors glyphActors(const std::vector<Eigen::Vector3d>& positions, int shape, const QColor& color,
                        const QColor& outlineColor)
{
    const vtkSmartPointer<vtkPolyData> points = pointSet(positions, false);
    const vtkSmartPointer<vtkPolyDataAlgorithm> source = glyphSource(shape);
    PointActors actors;
    actors.glyphMapper = glyphMapper(points, source);
    actors.glyphs = vtkSmartPointer<vtkActor>::New();
    actors.glyphs->SetMapper(actors.glyphMapper);
    vtkProperty* property = actors.glyphs->GetProperty();
    setColor(property, color);
    property->SetAmbient(0.45);
    property->SetDiffuse(0.6);
    property->SetSpecular(0);
    if (shape % 4 == 3)
        property->SetInterpolationToFlat();

    actors.outlineMapper = glyphMapper(points, source);
    actors.outline = vtkSmartPointer<vtkActor>::New();
    actors.outline->SetMapper(actors.outlineMapper);
    setColor(actors.outline->GetProperty(), outlineColor);
    actors.outline->GetProperty()->LightingOff();
    actors.outline->GetProperty()->FrontfaceCullingOn();
    return actors;
}

PointActors dotActors(const std::vector<Eigen::Vector3d>& positions, const QColor& color, double ratio)
{
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(pointSet(positions, true));
    PointActors actors;
    actors.glyphs = vtkSmartPointer<vtkActor>::New();
    actors.glyphs->SetMapper(mapper);
    setColor(actors.glyphs->GetProperty(), color);
    actors.glyphs->GetProperty()->LightingOff();
    actors.glyphs->GetProperty()->SetPointSize(float(3 * ratio));
    return actors;
}

vtkSmartPointer<vtkActor> lineActor(const std::vector<std::vector<Eigen::Vector3d>>& lines,
                                    const QColor& color, double width)
{
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const std::vector<Eigen::Vector3d>& line : lines) {
        cells->InsertNextCell(int(line.size()));
        for (const Eigen::Vector3d& at : line)
            cells->InsertCellPoint(points->InsertNextPoint(at.x(), at.y(), at.z()));
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(cells);
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    setColor(actor->GetProperty(), color);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(float(width));
    return actor;
}

/// Meridians and parallels of the unit sphere.
std::vector<std::vector<Eigen::Vector3d>> sphereWire()
{
    constexpr int segments = 64;
    constexpr int meridians = 6;
    std::vector<std::vector<Eigen::Vector3d>> lines;
    const auto circle = [&](auto pointAt) {
        std::vector<Eigen::Vector3d> line;
        for (int i = 0; i <= segments; ++i)
            line.push_back(pointAt(2 * std::numbers::pi * i / segments));
        lines.push_back(std::move(line));
    };
    for (int n = 0; n < meridians; ++n) {
        const double turn = std::numbers::pi * n / meridians;
        circle([&](double a) {
            return Eigen::Vector3d(std::cos(a), std::sin(a) * std::cos(turn), std::sin(a) * std::sin(turn));
        });
    }
    for (const double height : {-0.5, 0.0, 0.5}) {
        const double radius = std::sqrt(1 - height * height);
        circle([&](double a) { return Eigen::Vector3d(height, radius * std::cos(a), radius * std::sin(a)); });
    }
    return lines;
}

/// Takes the unit sphere to the ellipsoid in the cube of the axes.
vtkSmartPointer<vtkMatrix4x4> ellipsoidMatrix(const SceneContent& content, const Ellipsoid& ellipsoid)
{
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    const Eigen::Matrix3d stretched = ellipsoid.axes * ellipsoid.radii.asDiagonal();
    const Eigen::Vector3d centre = cubePosition(content, ellipsoid.centre);
    for (int row = 0; row < 3; ++row) {
        const AxisScale& axis = content.axes[std::size_t(row)];
        for (int column = 0; column < 3; ++column)
            matrix->SetElement(row, column, stretched(row, column) / (axis.high - axis.low));
        matrix->SetElement(row, 3, centre[row]);
    }
    return matrix;
}

} // namespace

std::vector<PointActors> pointActors(const SceneContent& content, const SceneLook& look, double ratio)
{
    std::map<std::pair<int, int>, std::vector<Eigen::Vector3d>> groups;
    for (const ScenePoint& point : content.points)
        groups[{point.color, point.shape % 4}].push_back(cubePosition(content, point.at));
    std::vector<PointActors> actors;
    for (const auto& [key, positions] : groups) {
        const QColor color = Theme::typeColor(key.first);
        actors.push_back(content.points.size() > mostGlyphs
                             ? dotActors(positions, color, ratio)
                             : glyphActors(positions, key.second, color, look.outline));
    }
    if (content.highlight) {
        const ScenePoint& point = content.highlight->point;
        actors.push_back(
            glyphActors({cubePosition(content, point.at)}, point.shape, look.text, look.background));
    }
    return actors;
}

EllipsoidActors ellipsoidActors(const SceneContent& content, const Ellipsoid& ellipsoid, const QColor& color,
                                double opacity, double lineWidth)
{
    const vtkSmartPointer<vtkMatrix4x4> matrix = ellipsoidMatrix(content, ellipsoid);
    auto sphere = vtkSmartPointer<vtkSphereSource>::New();
    sphere->SetRadius(1);
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(32);
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(sphere->GetOutputPort());
    EllipsoidActors actors;
    actors.surface = vtkSmartPointer<vtkActor>::New();
    actors.surface->SetMapper(mapper);
    actors.surface->SetUserMatrix(matrix);
    setColor(actors.surface->GetProperty(), color);
    actors.surface->GetProperty()->SetOpacity(opacity);
    actors.surface->GetProperty()->SetAmbient(0.7);
    actors.surface->GetProperty()->SetDiffuse(0.3);
    actors.wire = lineActor(sphereWire(), color, lineWidth);
    actors.wire->SetUserMatrix(matrix);
    actors.wire->GetProperty()->SetOpacity(std::min(1.0, 2.5 * opacity));
    return actors;
}

std::vector<vtkSmartPointer<vtkActor>> errorActors(const SceneContent& content, double lineWidth)
{
    std::map<int, std::vector<std::vector<Eigen::Vector3d>>> lines;
    for (const SceneEllipsoid& error : content.errors)
        for (std::vector<Eigen::Vector3d>& ring : ellipsoidRings(error.shape)) {
            for (Eigen::Vector3d& at : ring)
                at = cubePosition(content, at);
            lines[error.color].push_back(std::move(ring));
        }
    std::vector<vtkSmartPointer<vtkActor>> actors;
    actors.reserve(lines.size());
    for (const auto& [color, rings] : lines)
        actors.push_back(lineActor(rings, Theme::typeColor(color), lineWidth));
    return actors;
}

std::vector<vtkSmartPointer<vtkActor>> gridActors(const SceneContent& content, const SceneLook& look,
                                                  const Eigen::Vector3i& farSide, double ratio)
{
    std::vector<std::vector<Eigen::Vector3d>> grid;
    std::vector<std::vector<Eigen::Vector3d>> frame;
    for (int wall = 0; wall < 3; ++wall) {
        for (int across = 0; across < 3; ++across) {
            if (across == wall)
                continue;
            const int along = 3 - wall - across;
            const AxisScale& axis = content.axes[std::size_t(across)];
            for (const double tick : axis.ticks) {
                Eigen::Vector3d from;
                from[wall] = 0.5 * farSide[wall];
                from[across] = axis.unitPosition(tick) - 0.5;
                from[along] = -0.5;
                Eigen::Vector3d to = from;
                to[along] = 0.5;
                const bool border = std::abs(std::abs(from[across]) - 0.5) < 1e-9;
                (border ? frame : grid).push_back({from, to});
            }
        }
    }
    return {lineActor(grid, look.grid, look.lineWidth * ratio),
            lineActor(frame, look.frame, look.lineWidth * ratio)};
}

} // namespace gripscope
