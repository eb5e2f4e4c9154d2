// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/tinted_icon.h"

#include "ui/theme/theme.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

using namespace Qt::StringLiterals;

namespace gripscope {

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
            color = Theme::mix(tokens.secondText, tokens.surface, 0.3);
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

} // namespace

QIcon tintedIcon(const QString& name, std::optional<QColor> color)
{
    const QString file = findIcon(name);
    return file.isEmpty() ? QIcon() : QIcon(new TintedIconEngine(file, color));
}

} // namespace gripscope
