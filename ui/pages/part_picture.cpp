// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/part_picture.h"

#include "ui/context/workbench.h"
#include "ui/theme/theme.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QImageReader>
#include <QPainter>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

/// No photograph of a part is larger; a file that says so is something else.
constexpr qint64 largestFile = 100'000'000;
/// Of the sides of what it holds, before it is made smaller.
constexpr int largestSide = 20'000;

class PictureWords {
    Q_DECLARE_TR_FUNCTIONS(PictureWords)
};

QSize shrunk(const QSize& size, int side)
{
    return size.width() > side || size.height() > side ? size.scaled(side, side, Qt::KeepAspectRatio) : size;
}

Expected<PartPicture> encoded(const QImage& image, const QString& format)
{
    PartPicture picture;
    picture.format = format;
    picture.width = image.width();
    picture.height = image.height();
    QBuffer buffer(&picture.bytes);
    const bool written = buffer.open(QIODevice::WriteOnly) &&
                         image.save(&buffer, format.toLatin1().constData(), format == "jpeg"_L1 ? 88 : -1);
    if (!written)
        return failure(ErrorCode::Usage,
                       {PictureWords::tr("The picture could not be kept as %1.").arg(format)});
    return picture;
}

} // namespace

Expected<PartPicture> readPartPicture(const QString& file)
{
    const auto unreadable = [&file](const QString& why) {
        return failure(ErrorCode::FileUnreadable, {file, why});
    };
    const QFileInfo info(file);
    if (!info.isFile())
        return unreadable(PictureWords::tr("there is no such file"));
    if (info.size() > largestFile)
        return unreadable(PictureWords::tr("it is larger than 100 MB"));
    QImageReader reader(file);
    reader.setDecideFormatFromContent(true);
    reader.setAutoTransform(true);
    const QByteArray format = reader.format();
    if (format != "png" && format != "jpeg")
        return unreadable(PictureWords::tr("it is neither a PNG nor a JPEG picture"));
    const QSize size = reader.size();
    if (size.width() > largestSide || size.height() > largestSide)
        return unreadable(PictureWords::tr("it is larger than %1 by %1 pixels").arg(largestSide));
    if (size.isValid())
        reader.setScaledSize(shrunk(size, largestPictureSide));
    const QImage image = reader.read();
    if (image.isNull())
        return unreadable(PictureWords::tr("it is damaged (%1)").arg(reader.errorString()));
    return encoded(image, QString::fromLatin1(format));
}

Expected<PartPicture> toPartPicture(const QImage& image)
{
    if (image.isNull())
        return failure(ErrorCode::Usage,
                       {PictureWords::tr("There is no picture to paste. Copy one first, or choose a file.")});
    return encoded(
        image.scaled(shrunk(image.size(), largestPictureSide), Qt::KeepAspectRatio, Qt::SmoothTransformation),
        u"png"_s);
}

QImage shownPicture(const PartPicture& picture, int side)
{
    QBuffer buffer;
    buffer.setData(picture.bytes);
    QImageReader reader(&buffer, picture.format.toLatin1());
    // Twice as large, so that what is left to scale is smooth: a JPEG is read at a coarser size quickly.
    if (const QSize size = reader.size(); size.isValid())
        reader.setScaledSize(shrunk(size, 2 * side));
    const QImage image = reader.read();
    return image.isNull()
               ? image
               : image.scaled(shrunk(image.size(), side), Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

PartPictureView::PartPictureView(Workbench& workbench, int side, Empty empty, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_side(side), m_empty(empty)
{
    setFixedSize(side, side);
    setAccessibleName(tr("Picture of the part: none"));
    setVisible(empty == Empty::Frame);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void PartPictureView::setPicture(const std::optional<PartPicture>& picture)
{
    if (m_picture == picture)
        return;
    m_picture = picture;
    m_pixmap = {};
    setVisible(m_empty == Empty::Frame || picture);
    setAccessibleName(picture ? tr("Picture of the part") : tr("Picture of the part: none"));
    update();
    if (!picture)
        return;
    const double ratio = devicePixelRatioF();
    const int pixels = static_cast<int>(m_side * ratio);
    m_workbench->background().compute<QImage>(
        this, [picture = *picture, pixels] { return shownPicture(picture, pixels); },
        [this, id = picture->id, ratio](const QImage& image) {
            if (!m_picture || m_picture->id != id)
                return;
            m_pixmap = QPixmap::fromImage(image);
            m_pixmap.setDevicePixelRatio(ratio);
            update();
        });
}

void PartPictureView::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    if (!m_pixmap.isNull()) {
        const QSizeF size = m_pixmap.deviceIndependentSize();
        painter.drawPixmap(QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), m_pixmap);
        return;
    }
    if (m_empty == Empty::Hidden)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(tokens.secondText, tokens.lineWidth, Qt::DashLine));
    painter.setBrush(tokens.page);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), metrics::radius, metrics::radius);
    const int icon = m_side / 3;
    Theme::instance()
        .icon(u"insert-image"_s, tokens.secondText)
        .paint(&painter, (width() - icon) / 2, (height() - icon) / 2, icon, icon);
}

} // namespace gripscope
