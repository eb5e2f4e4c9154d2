// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/theme.h"

#include "ui/theme/style_sheet.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QStyleFactory>
#include <QSvgRenderer>

#include <algorithm>
#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString findIcon(const QString& name)
{
    static const QStringList folders{u"actions"_s, u"status"_s, u"devices"_s,
                                     u"emblems"_s, u"places"_s, u"preferences"_s};
    static const QStringList sizes{u"22"_s, u"32"_s, u"16"_s, u"symbolic"_s};
    for (const QString& root : QIcon::fallbackSearchPaths())
        for (const QString& folder : folders)
            for (const QString& size : sizes) {
                const QString file = u"%1/breeze/%2/%3/%4.svg"_s.arg(root, folder, size, name);
                if (QFile::exists(file))
                    return file;
            }
    return {};
}

class TintedIconEngine : public QIconEngine {
public:
    TintedIconEngine(QString file, std::optional<QColor> color) : m_file(std::move(file)), m_color(color) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override
    {
        const qreal ratio = painter->device()->devicePixelRatioF();
        QPixmap picture = pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state);
        picture.setDevicePixelRatio(ratio);
        painter->drawPixmap(rect, picture);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override
    {
        const ThemeTokens& tokens = Theme::instance().tokens();
        QColor color = m_color.value_or(tokens.text);
        if (mode == QIcon::Disabled)
            color = Theme::mix(tokens.disabled, tokens.surface, 0.3);
        const QString key =
            u"tint:%1:%2x%3:%4"_s.arg(m_file).arg(size.width()).arg(size.height()).arg(color.rgba());
        QPixmap picture;
        if (QPixmapCache::find(key, &picture))
            return picture;
        picture = QPixmap(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        QSvgRenderer renderer(m_file);
        renderer.setAspectRatioMode(Qt::KeepAspectRatio);
        renderer.render(&painter, QRectF(QPointF(), QSizeF(size)));
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        painter.fillRect(picture.rect(), color);
        painter.end();
        QPixmapCache::insert(key, picture);
        return picture;
    }

    [[nodiscard]] QIconEngine* clone() const override { return new TintedIconEngine(m_file, m_color); }

private:
    QString m_file;
    std::optional<QColor> m_color;
};

/// A monochrome SVG of the breeze icons as a stencil for one colour, drawn anew at the size asked for.
/// Without a colour it takes the theme's text colour at the moment it is painted, so it follows a change of
/// theme by itself. Empty when there is no such icon.
QIcon tintedIcon(const QString& name, std::optional<QColor> color)
{
    const QString file = findIcon(name);
    return file.isEmpty() ? QIcon() : QIcon(new TintedIconEngine(file, color));
}

} // namespace

std::optional<ThemeKind> themeKindFromString(const QString& text)
{
    if (text == "light"_L1)
        return ThemeKind::Light;
    if (text == "dark"_L1)
        return ThemeKind::Dark;
    if (text == "contrast"_L1)
        return ThemeKind::HighContrast;
    return std::nullopt;
}

namespace {

/// In each theme any two outcomes differ by 20 or more (CIE Delta E 2000), and by 10 to eyes without green
/// cones.
ThemeTokens lightTokens()
{
    ThemeTokens t;
    t.kind = ThemeKind::Light;
    t.page = QColor(QRgb{0xFFF6F7F9});
    t.surface = QColor(QRgb{0xFFFFFFFF});
    t.line = QColor(QRgb{0xFFD9DDE3});
    t.text = QColor(QRgb{0xFF1A1E24});
    t.secondText = QColor(QRgb{0xFF5B6470});
    t.disabled = t.secondText;
    t.accent = QColor(QRgb{0xFF1F5FD6});
    t.stop = QColor(QRgb{0xFFC22F2F});
    t.asExpected = QColor(QRgb{0xFF187A47});
    t.otherType = QColor(QRgb{0xFF952259});
    t.unknown = QColor(QRgb{0xFF5F3BC9});
    t.inconclusive = QColor(QRgb{0xFF383D44});
    t.notValid = QColor(QRgb{0xFF8F5500});
    t.doesNotConform = QColor(QRgb{0xFF540C00});
    t.suspect = QColor(QRgb{0xFF6E6600});
    t.force = QColor(QRgb{0xFF0B6E99});
    t.position = QColor(QRgb{0xFFA84A0A});
    t.model = QColor(QRgb{0xFF3D7A00});
    return t;
}

ThemeTokens darkTokens()
{
    ThemeTokens t;
    t.kind = ThemeKind::Dark;
    t.page = QColor(QRgb{0xFF13161A});
    t.surface = QColor(QRgb{0xFF1C2026});
    t.line = QColor(QRgb{0xFF333A44});
    t.text = QColor(QRgb{0xFFE7EAEE});
    t.secondText = QColor(QRgb{0xFF9AA4B1});
    t.disabled = t.secondText;
    t.accent = QColor(QRgb{0xFF6CA6FF});
    t.stop = QColor(QRgb{0xFFFF5A5A});
    t.asExpected = QColor(QRgb{0xFF4CC38A});
    t.otherType = QColor(QRgb{0xFFFF74B8});
    t.unknown = QColor(QRgb{0xFFA58CFF});
    t.inconclusive = QColor(QRgb{0xFFD8DDE3});
    t.notValid = QColor(QRgb{0xFFF0B04A});
    t.doesNotConform = QColor(QRgb{0xFFE47854});
    t.suspect = QColor(QRgb{0xFFE8E04A});
    t.force = QColor(QRgb{0xFF5CC0EA});
    t.position = QColor(QRgb{0xFFFF9F5A});
    t.model = QColor(QRgb{0xFFA5D66B});
    return t;
}

/// Black, white and one accent, and a bright colour for each outcome. Icons, words and patterns tell them
/// apart too. Stop stays red, as a safety colour is; grey is what cannot be used.
ThemeTokens highContrastTokens()
{
    ThemeTokens t;
    t.kind = ThemeKind::HighContrast;
    t.page = t.surface = QColor(Qt::black);
    t.line = t.text = t.secondText = QColor(QRgb{0xFFFFFFFF});
    t.disabled = QColor(QRgb{0xFFA0A0A0});
    t.accent = QColor(QRgb{0xFFFFE14D});
    t.stop = QColor(QRgb{0xFFFF5A5A});
    t.asExpected = QColor(QRgb{0xFF5CFF8F});
    t.otherType = QColor(QRgb{0xFFFF8FE0});
    t.unknown = QColor(QRgb{0xFF95AEFE});
    t.inconclusive = QColor(QRgb{0xFFFFFFFF});
    t.notValid = QColor(QRgb{0xFFFF9A3D});
    t.doesNotConform = QColor(QRgb{0xFFD88484});
    t.suspect = t.accent;
    t.force = QColor(QRgb{0xFFFFFFFF});
    t.position = QColor(QRgb{0xFFFFFFFF});
    t.model = QColor(QRgb{0xFFFFE14D});
    t.lineWidth = 2;
    t.curveWidth = 3;
    return t;
}

QPalette palette(const ThemeTokens& t)
{
    QPalette p;
    p.setColor(QPalette::Window, t.page);
    p.setColor(QPalette::WindowText, t.text);
    p.setColor(QPalette::Base, t.surface);
    p.setColor(QPalette::AlternateBase, t.page);
    p.setColor(QPalette::Text, t.text);
    p.setColor(QPalette::PlaceholderText, t.secondText);
    p.setColor(QPalette::Button, t.surface);
    p.setColor(QPalette::ButtonText, t.text);
    p.setColor(QPalette::BrightText, t.stop);
    p.setColor(QPalette::ToolTipBase, t.surface);
    p.setColor(QPalette::ToolTipText, t.text);
    p.setColor(QPalette::Highlight, t.accent);
    p.setColor(QPalette::HighlightedText, Theme::onColor(t.accent));
    p.setColor(QPalette::Link, t.accent);
    p.setColor(QPalette::LinkVisited, t.accent);
    p.setColor(QPalette::Light, t.surface);
    p.setColor(QPalette::Midlight, t.line);
    p.setColor(QPalette::Mid, t.line);
    p.setColor(QPalette::Dark, t.secondText);
    p.setColor(QPalette::Shadow, t.line);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, t.disabled);
    return p;
}

} // namespace

namespace {

ThemeTokens colorsOf(ThemeKind kind)
{
    switch (kind) {
    case ThemeKind::Light:
        return lightTokens();
    case ThemeKind::Dark:
        return darkTokens();
    case ThemeKind::HighContrast:
        return highContrastTokens();
    }
    return lightTokens();
}

} // namespace

ThemeTokens themeTokens(ThemeKind kind)
{
    ThemeTokens tokens = colorsOf(kind);
    const bool contrast = kind == ThemeKind::HighContrast; // a tint alone would be hard to see there
    tokens.selected = Theme::mix(tokens.surface, tokens.accent, contrast ? 0.2 : 0.12);
    tokens.selectedEdge = contrast ? tokens.accent : tokens.line;
    tokens.selectedEdgeWidth = contrast ? 2 : 1;
    return tokens;
}

Theme& Theme::instance()
{
    static Theme theme;
    return theme;
}

void Theme::apply(ThemeKind kind)
{
    if (m_sheet && kind == m_kind)
        return;
    m_kind = kind;
    m_tokens = themeTokens(kind);
    // Each of these styles every widget that there is anew: style and font are those of all themes.
    if (!m_sheet) {
        const QStringList paths{u"/usr/share/icons"_s, u"/usr/local/share/icons"_s};
        QIcon::setFallbackSearchPaths(paths);
        QApplication::setStyle(QStyleFactory::create(u"Fusion"_s));
        QApplication::setFont(font(metrics::fontBase));
        m_sheet = std::make_unique<StyleSheet>();
    }
    QIcon::setThemeName(kind == ThemeKind::Light ? u"breeze"_s : u"breeze-dark"_s);
    QIcon::setFallbackThemeName(u"breeze"_s);

    QApplication::setPalette(palette(m_tokens));
    // Exchanged for another, a sheet styles each widget once for each widget that it stands in; off and on
    // again, twice in all.
    qApp->setStyleSheet({});
    qApp->setStyleSheet(m_sheet->text(m_tokens));
    emit changed();
}

Theme::PlainStyle::PlainStyle()
{
    const QWidgetList windows = QApplication::topLevelWidgets();
    if (std::ranges::any_of(windows, &QWidget::isVisible))
        return;
    m_sheet = qApp->styleSheet();
    qApp->setStyleSheet({});
}

Theme::PlainStyle::~PlainStyle()
{
    if (!m_sheet.isEmpty())
        qApp->setStyleSheet(m_sheet);
}

Theme::Theme() = default;
Theme::~Theme() = default;

QColor Theme::outcomeColor(InspectionOutcome outcome) const
{
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        return m_tokens.asExpected;
    case InspectionOutcome::OtherType:
        return m_tokens.otherType;
    case InspectionOutcome::Unknown:
        return m_tokens.unknown;
    case InspectionOutcome::Inconclusive:
        return m_tokens.inconclusive;
    case InspectionOutcome::NotValid:
        return m_tokens.notValid;
    case InspectionOutcome::DoesNotConform:
        return m_tokens.doesNotConform;
    }
    return m_tokens.text;
}

QColor Theme::outcomeColor(InspectionOutcome outcome, bool suspect) const
{
    return suspect ? m_tokens.suspect : outcomeColor(outcome);
}

void Theme::paintRow(QPainter& painter, const QRect& row, bool selected)
{
    const ThemeTokens& t = instance().tokens();
    painter.fillRect(row, selected ? t.selected : t.surface);
    const int edge = selected ? t.selectedEdgeWidth : 1;
    painter.fillRect(QRect(row.left(), row.bottom() + 1 - edge, row.width(), edge),
                     selected ? t.selectedEdge : t.line);
}

QColor Theme::typeColor(int index)
{
    static constexpr std::array<QRgb, 8> colors{0xFF0072B2, 0xFFB07400, 0xFF00805C, 0xFFB5608F,
                                                0xFF2A86C0, 0xFFD55E00, 0xFF8C6D1F, 0xFF666666};
    const auto size = static_cast<int>(colors.size());
    return QColor(colors[static_cast<std::size_t>(((index % size) + size) % size)]);
}

double Theme::contrastRatio(const QColor& one, const QColor& other)
{
    const auto channel = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const auto luminance = [&channel](const QColor& c) {
        return 0.2126 * channel(c.redF()) + 0.7152 * channel(c.greenF()) + 0.0722 * channel(c.blueF());
    };
    const double a = luminance(one);
    const double b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

QColor Theme::onColor(const QColor& fill)
{
    const QColor white(Qt::white);
    const QColor ink(0x13161A);
    return contrastRatio(fill, white) >= contrastRatio(fill, ink) ? white : ink;
}

QColor Theme::mix(const QColor& one, const QColor& other, double share)
{
    const auto part = [share](float a, float b) { return a + (b - a) * static_cast<float>(share); };
    return QColor::fromRgbF(part(one.redF(), other.redF()), part(one.greenF(), other.greenF()),
                            part(one.blueF(), other.blueF()));
}

QIcon Theme::icon(const QString& name, std::optional<QColor> color) const
{
    return tintedIcon(name, color);
}

QFont Theme::font(int pixels, bool strong)
{
    QFont font(u"Noto Sans"_s);
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(pixels);
    font.setWeight(strong ? QFont::DemiBold : QFont::Normal);
    return font;
}

} // namespace gripscope
