// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part_picture_reader.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QImageReader>

namespace gripscope {

using namespace Qt::StringLiterals;

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

} // namespace gripscope
