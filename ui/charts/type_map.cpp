// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/type_map.h"

#include "core/base/display_units.h"
#include "core/signal/recording/units.h"
#include "ui/charts/line_clipping.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <Eigen/Eigenvalues>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
/// Chi-square with two degrees of freedom is exponential: its 95 % quantile is -2 ln 0.05.
const double quantile95 = -2 * std::log(0.05);

/// A point (k, b) in SI where it is drawn.
QPointF drawn(QPointF si)
{
    return {si.x() * fieldUnit(MechanicalQuantity::Stiffness).factor,
            si.y() * fieldUnit(MechanicalQuantity::Damping).factor};
}

/// The edge of the ellipse that holds 95 %, about zero, each point as (k, b). Empty for no covariance.
std::vector<QPointF> edgeOf(const Eigen::Matrix2d& covariance)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(covariance);
    if (eigen.info() != Eigen::Success || !(eigen.eigenvalues().maxCoeff() > 0))
        return {};
    const Eigen::Vector2d radii = (eigen.eigenvalues().cwiseMax(0.0) * quantile95).cwiseSqrt();
    std::vector<QPointF> edge;
    constexpr int corners = 64;
    edge.reserve(corners);
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners;
        const Eigen::Vector2d unit(std::cos(angle), std::sin(angle));
        const Eigen::Vector2d point = eigen.eigenvectors() * radii.cwiseProduct(unit);
        edge.emplace_back(point[1], point[0]);
    }
    return edge;
}
} // namespace

TypeMap::TypeMap(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Stiffness and damping of the types and of this part"));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

std::vector<QPointF> TypeMap::ellipse(const TypeModels& models, const TypeModel& type)
{
    // Rows 1 and 2 of log(m, b, k) are b and k.
    const Eigen::Matrix2d covariance = models.covarianceLog.block<2, 2>(1, 1);
    std::vector<QPointF> edge = edgeOf(covariance);
    for (QPointF& p : edge)
        p = {std::exp(type.meanLog[2] + p.x()), std::exp(type.meanLog[1] + p.y())};
    return edge;
}

void TypeMap::setTypes(const TypeModels& models, bool elsewhere)
{
    m_elsewhere = elsewhere;
    m_shapes.clear();
    m_points.clear();
    for (const TypeModel& type : models.types) {
        Shape shape;
        shape.name = type.name;
        shape.sign = type.place;
        shape.centre = drawn({std::exp(type.meanLog[2]), std::exp(type.meanLog[1])});
        for (const QPointF& p : ellipse(models, type))
            shape.edge.push_back(drawn(p));
        m_shapes.push_back(std::move(shape));
    }
    update();
}

void TypeMap::setSqueezes(const std::vector<TypeSqueeze>& squeezes, const QString& own)
{
    m_points.clear();
    for (const TypeSqueeze& squeeze : squeezes) {
        const auto shape = std::find_if(m_shapes.begin(), m_shapes.end(),
                                        [&](const Shape& one) { return one.name == squeeze.type; });
        const QPointF at = drawn({squeeze.parameters.k, squeeze.parameters.b});
        if (shape != m_shapes.end() && at.x() > 0 && at.y() > 0) // what is not is in no type either
            m_points.push_back({at, std::size_t(shape - m_shapes.begin()), squeeze.type == own});
    }
    update();
}

void TypeMap::setPart(const std::optional<MassDampingStiffness>& parameters,
                      const std::optional<Eigen::Matrix3d>& covariance)
{
    m_part.reset();
    m_partEdge.clear();
    if (parameters && std::isfinite(parameters->k) && std::isfinite(parameters->b))
        m_part = drawn({parameters->k, parameters->b});
    if (m_part && covariance && covariance->allFinite())
        for (const QPointF& p : edgeOf(covariance->block<2, 2>(1, 1)))
            m_partEdge.push_back(*m_part + drawn(p));
    update();
}

QPointF TypeMap::View::map(QPointF value) const
{
    return {plot.left() + (value.x() - k.low) / k.span() * plot.width(),
            plot.bottom() - (value.y() - b.low) / b.span() * plot.height()};
}

TypeMap::View TypeMap::view() const
{
    View view;
    view.plot = QRectF(QPointF(), pictureSize()).adjusted(56, 10, -14, -38);
    double k0 = 1e300, k1 = -1e300, b0 = 1e300, b1 = -1e300;
    const auto include = [&](const QPointF& p) {
        k0 = std::min(k0, p.x());
        k1 = std::max(k1, p.x());
        b0 = std::min(b0, p.y());
        b1 = std::max(b1, p.y());
    };
    for (const Shape& shape : m_shapes) {
        include(shape.centre);
        for (const QPointF& p : shape.edge)
            include(p);
    }
    for (const Point& point : m_points)
        include(point.at);
    if (m_part)
        include(*m_part);
    if (k0 > k1)
        k0 = b0 = 0, k1 = b1 = 1;
    const auto padded = [](double low, double high) {
        const double air = std::max((high - low) * 0.06, std::abs(high) * 0.02);
        return AxisRange{low < 0 ? low - air : std::max(0.0, low - air), high + air};
    };
    view.k = padded(k0, k1);
    view.b = padded(b0, b1);
    return view;
}

void TypeMap::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paint(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(Theme::instance().tokens().accent, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void TypeMap::paint(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_shapes.empty() && !m_part) {
        painter.setPen(Theme::instance().tokens().secondText);
        painter.drawText(QRect(QPoint(), pictureSize()).adjusted(16, 8, -16, -8),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         m_elsewhere ? tr("No map: these types are told apart without m, b and k.")
                                     : tr("No types yet. Enroll one to see where it lies."));
        return;
    }
    const View v = view();
    paintAxes(painter, v);
    paintTypes(painter, v);
    paintPart(painter, v);
}

QString TypeMap::plotName() const
{
    return tr("Map of the types");
}

QString TypeMap::fileName() const
{
    return u"type-map"_s;
}

void TypeMap::paintPicture(QPainter& painter)
{
    painter.save();
    painter.fillRect(QRectF(QPointF(), pictureSize()), Theme::instance().tokens().surface);
    paint(painter);
    painter.restore();
}

PlotTable TypeMap::numbers() const
{
    auto what = std::make_shared<std::vector<QString>>(), type = std::make_shared<std::vector<QString>>();
    auto k = std::make_shared<std::vector<double>>(), b = std::make_shared<std::vector<double>>();
    const QPointF factors = drawn({1, 1});
    const auto add = [&](const QString& kind, const QString& name, QPointF at) {
        what->push_back(kind);
        type->push_back(name);
        k->push_back(at.x() / factors.x());
        b->push_back(at.y() / factors.y());
    };
    for (const Shape& shape : m_shapes) {
        add(tr("mean"), shape.name, shape.centre);
        for (const QPointF& corner : shape.edge)
            add(tr("edge of 95 %"), shape.name, corner);
    }
    for (const Point& point : m_points)
        add(tr("squeeze"), m_shapes[point.shape].name, point.at);
    if (m_part)
        add(tr("this part"), {}, *m_part);
    for (const QPointF& corner : m_partEdge)
        add(tr("edge of 95 %"), tr("this part"), corner);
    return {{tr("What"), {}, what},
            {tr("Type"), {}, type},
            {tr("stiffness (%1)").arg(siParameterUnits().k), k},
            {tr("damping (%1)").arg(siParameterUnits().b), b}};
}

void TypeMap::paintAxes(QPainter& painter, const View& v) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const QFont small = Theme::font(metrics::fontSmall);
    painter.setFont(small);
    const AxisTicks k =
        roundTicks(v.k.low, v.k.high, std::clamp(static_cast<int>(v.plot.width() / 64), 2, 8));
    const AxisTicks b =
        roundTicks(v.b.low, v.b.high, std::clamp(static_cast<int>(v.plot.height() / 24), 2, 9));
    const QColor grid = t.kind == ThemeKind::HighContrast ? Theme::mix(t.surface, t.line, 0.3) : t.line;
    for (const double value : k.values) {
        const double x = v.map({value, 0}).x();
        painter.setPen(grid);
        painter.drawLine(QPointF(x, v.plot.top()), QPointF(x, v.plot.bottom()));
        painter.setPen(t.secondText);
        painter.drawText(QRectF(x - 40, v.plot.bottom() + 3, 80, 16), Qt::AlignHCenter | Qt::AlignTop,
                         k.label(value));
    }
    for (const double value : b.values) {
        const double y = v.map({0, value}).y();
        painter.setPen(grid);
        painter.drawLine(QPointF(v.plot.left(), y), QPointF(v.plot.right(), y));
        painter.setPen(t.secondText);
        painter.drawText(QRectF(18, y - 9, v.plot.left() - 24, 18), Qt::AlignRight | Qt::AlignVCenter,
                         b.label(value));
    }
    const QRectF foot(v.plot.left(), v.plot.bottom() + 20, v.plot.width(), 16);
    const QFontMetricsF letters(small);
    const double ofPart = m_part ? letters.horizontalAdvance(tr("this part")) + 24 : 0;
    const QString unit = fieldUnit(MechanicalQuantity::Stiffness).unit;
    QString title = tr("stiffness (%1)").arg(unit);
    if (letters.horizontalAdvance(title) > foot.width() - ofPart)
        title = tr("k (%1)").arg(unit);
    // In the middle, or as near to it as what is at its right leaves room for.
    const double wide = letters.horizontalAdvance(title);
    const double left = std::max(0.0, std::min((foot.width() - wide) / 2, foot.width() - ofPart - wide));
    painter.drawText(QRectF(foot.left() + left, foot.top(), wide + 1, 16), Qt::AlignLeft | Qt::AlignVCenter,
                     title);
    if (m_part) {
        painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, tr("this part"));
        const QPointF ring(foot.right() - letters.horizontalAdvance(tr("this part")) - 10, foot.top() + 9);
        painter.setPen(QPen(t.text, 1.5));
        painter.drawEllipse(ring, 5, 5);
        painter.drawEllipse(ring, 1, 1);
        painter.setPen(t.secondText);
    }
    painter.save();
    painter.translate(9, v.plot.center().y());
    painter.rotate(-90);
    const QString damping = v.plot.height() < 110 ? tr("b (%1)") : tr("damping (%1)");
    painter.drawText(QRectF(-90, -9, 180, 18), Qt::AlignCenter,
                     damping.arg(fieldUnit(MechanicalQuantity::Damping).unit));
    painter.restore();
}

void TypeMap::paintTypes(QPainter& painter, const View& v) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const bool contrast = t.kind == ThemeKind::HighContrast;
    static constexpr Qt::PenStyle styles[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    std::vector<QRectF> bounds;
    for (const Shape& shape : m_shapes) {
        const QColor color = contrast ? t.text : Theme::typeColor(shape.sign);
        QPolygonF edge;
        for (const QPointF& p : shape.edge)
            edge << v.map(p);
        QColor tint = color;
        tint.setAlphaF(0.22F);
        const bool light = t.kind == ThemeKind::Light;
        // Without colours the line tells the types apart.
        painter.setPen(QPen(light || contrast ? color : Theme::mix(color, Qt::white, 0.45),
                            contrast ? 2 : 1.5, contrast ? styles[shape.sign % 4] : Qt::SolidLine));
        painter.setBrush(contrast ? QBrush(Qt::NoBrush) : QBrush(tint));
        const QPointF c = v.map(shape.centre);
        const QRectF box = edge.boundingRect();
        // An ellipse too small to see still shows where the type lies.
        if (box.width() < 9 && box.height() < 9)
            painter.drawEllipse(c, 4.5, 4.5);
        else
            painter.drawPolygon(edge);
        bounds.push_back(box.united(QRectF(c.x() - 5, c.y() - 5, 10, 10)));
    }
    paintSqueezes(painter, v);
    paintNames(painter, v, bounds);
}

void TypeMap::paintSqueezes(QPainter& painter, const View& v) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    for (const Point& point : m_points) {
        const QColor color =
            t.kind == ThemeKind::HighContrast ? t.text : Theme::typeColor(m_shapes[point.shape].sign);
        painter.setPen(QPen(Theme::mix(t.surface, color, point.own ? 1 : 0.6), 1));
        painter.setBrush(point.own ? QBrush(color) : QBrush(t.surface));
        painter.drawEllipse(v.map(point.at), 2.5, 2.5);
    }
}

void TypeMap::paintNames(QPainter& painter, const View& v, const std::vector<QRectF>& bounds) const
{
    painter.setPen(Theme::instance().tokens().text);
    painter.setFont(Theme::font(metrics::fontSmall, true));
    const QFontMetricsF letters(painter.font());
    std::vector<QRectF> taken;
    if (m_part) {
        const QPointF part = v.map(*m_part);
        taken.emplace_back(part.x() - 10, part.y() - 10, 20, 20);
    }
    for (std::size_t i = 0; i < m_shapes.size(); ++i) {
        const QString name = elided(letters, m_shapes[i].name, 110);
        const QSizeF size(letters.horizontalAdvance(name) + 2, letters.height());
        const QRectF& box = bounds[i];
        const double middle = box.center().y() - size.height() / 2;
        std::vector<QPointF> places;
        for (const double lift : {0.0, -16.0, 16.0, -32.0, 32.0}) {
            places.emplace_back(box.right() + 4, middle + lift);
            places.emplace_back(box.left() - 4 - size.width(), middle + lift);
        }
        places.emplace_back(box.center().x() - size.width() / 2, box.top() - size.height() - 1);
        places.emplace_back(box.center().x() - size.width() / 2, box.bottom() + 1);
        const auto free = [&](const QRectF& there, bool ofEllipses) {
            const auto hit = [&there](const QRectF& other) { return other.intersects(there); };
            return v.plot.contains(there) && std::none_of(taken.begin(), taken.end(), hit) &&
                   (!ofEllipses || std::none_of(bounds.begin(), bounds.end(), hit));
        };
        // The first place that is clear of ellipses and names, else of names; else the nearest that is; else
        // the first.
        QRectF chosen(places[0], size);
        bool found = false;
        for (const bool ofEllipses : {true, false})
            for (const QPointF& place : places)
                if (!found && free(QRectF(place, size), ofEllipses)) {
                    chosen = QRectF(place, size);
                    found = true;
                }
        double nearest = std::numeric_limits<double>::infinity();
        for (double y = v.plot.top(); !found && y + size.height() <= v.plot.bottom(); y += 4)
            for (double x = v.plot.left(); x + size.width() <= v.plot.right(); x += 4) {
                const QRectF there(QPointF(x, y), size);
                const double away = QLineF(there.center(), box.center()).length();
                if (away < nearest && free(there, false)) {
                    nearest = away;
                    chosen = there;
                }
            }
        // Nowhere is there room: within the plot at least.
        chosen.moveLeft(std::max(v.plot.left(), std::min(chosen.left(), v.plot.right() - chosen.width())));
        chosen.moveTop(std::max(v.plot.top(), std::min(chosen.top(), v.plot.bottom() - chosen.height())));
        taken.push_back(chosen);
        painter.drawText(chosen, Qt::AlignCenter, name);
    }
}

void TypeMap::paintPart(QPainter& painter, const View& v) const
{
    if (!m_part)
        return;
    const ThemeTokens& t = Theme::instance().tokens();
    const QPointF c = v.map(*m_part);
    QPolygonF edge;
    for (const QPointF& p : m_partEdge)
        edge << v.map(p);
    if (!edge.isEmpty())
        edge << edge.front();
    painter.setPen(QPen(t.text, 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    if (edge.boundingRect().width() > 6 || edge.boundingRect().height() > 6)
        drawLineInside(painter, edge, v.plot);
    painter.setBrush(t.text);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(c, 3, 3);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(t.text, 2));
    painter.drawEllipse(c, 8, 8);
}

} // namespace gripscope
