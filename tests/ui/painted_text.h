// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QTextItem>
#include <QTransform>
#include <QWidget>

#include <optional>
#include <vector>

namespace gripscope::test {

/// Letters that a widget painted, in the widget's own coordinates.
struct PaintedText {
    QString text;
    QRectF ink;                 ///< what the letters cover
    QRectF line;                ///< from the font's ascent to its descent
    std::optional<QRectF> clip; ///< nothing outside of it was painted
    QColor color;               ///< with the painter's opacity
};

/// Keeps the texts that reach it and paints nothing: whatever put them there, a label, a delegate or a chart.
class TextEngine : public QPaintEngine {
public:
    TextEngine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    [[nodiscard]] Type type() const override { return User; }

    void drawTextItem(const QPointF& at, const QTextItem& item) override
    {
        if (item.text().trimmed().isEmpty())
            return;
        const QTransform to = painter()->deviceTransform();
        const QRectF ink = QFontMetricsF(item.font()).tightBoundingRect(item.text()).translated(at);
        const QRectF line(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
        QColor color = painter()->pen().color();
        color.setAlphaF(color.alphaF() * static_cast<float>(painter()->opacity()));
        PaintedText one{item.text(), to.mapRect(ink), to.mapRect(line), {}, color};
        if (painter()->hasClipping())
            one.clip = to.mapRect(painter()->clipBoundingRect());
        const QPointF begin = to.map(at);
        if (!m_texts.empty() && (begin - m_end).manhattanLength() < 1 && m_texts.back().color == color)
            append(m_texts.back(), one); // a line comes in pieces where its letters are of several scripts
        else
            m_texts.push_back(one);
        m_end = to.map(at + QPointF(item.width(), 0));
    }
    [[nodiscard]] const std::vector<PaintedText>& texts() const { return m_texts; }

    void drawRects(const QRect*, int) override {}
    void drawRects(const QRectF*, int) override {}
    void drawLines(const QLine*, int) override {}
    void drawLines(const QLineF*, int) override {}
    void drawEllipse(const QRectF&) override {}
    void drawEllipse(const QRect&) override {}
    void drawPath(const QPainterPath&) override {}
    void drawPoints(const QPointF*, int) override {}
    void drawPoints(const QPoint*, int) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    void drawPolygon(const QPoint*, int, PolygonDrawMode) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawTiledPixmap(const QRectF&, const QPixmap&, const QPointF&) override {}
    void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}

private:
    static void append(PaintedText& text, const PaintedText& more)
    {
        text.text += more.text;
        text.ink |= more.ink;
        text.line |= more.line;
    }
    std::vector<PaintedText> m_texts;
    QPointF m_end; ///< of the text before
};

class TextRecorder : public QPaintDevice {
public:
    explicit TextRecorder(const QSize& size) : m_size(size) {}
    [[nodiscard]] QPaintEngine* paintEngine() const override { return &m_engine; }
    [[nodiscard]] const std::vector<PaintedText>& texts() const { return m_engine.texts(); }

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override
    {
        constexpr int perInch = 96;
        switch (metric) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmWidthMM:
            return m_size.width() * 254 / (10 * perInch);
        case PdmHeightMM:
            return m_size.height() * 254 / (10 * perInch);
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return perInch;
        case PdmDepth:
            return 32;
        case PdmNumColors:
            return 1 << 24;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        }
        return 0;
    }

private:
    QSize m_size;
    mutable TextEngine m_engine; // a device hands it out while it is const
};

/// What `widget` paints by itself, its children not included.
[[nodiscard]] inline std::vector<PaintedText> textsPaintedBy(QWidget& widget)
{
    TextRecorder recorder(widget.size());
    widget.render(&recorder, {}, {}, {});
    return recorder.texts();
}

} // namespace gripscope::test
