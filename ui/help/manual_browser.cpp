// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_browser.h"

#include <QImage>
#include <QUrl>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr int mostWidth = 600; ///< of a picture, logical pixels
}

ManualBrowser::ManualBrowser(QWidget* parent) : QTextBrowser(parent)
{
    setFrameShape(QFrame::NoFrame);
    setOpenExternalLinks(true);
    document()->setDocumentMargin(16);
}

void ManualBrowser::showPage(const QString& file)
{
    setSource(QUrl(u"qrc:/manual/"_s + file), QTextDocument::MarkdownResource);
}

QString ManualBrowser::page() const
{
    return source().fileName();
}

QVariant ManualBrowser::loadResource(int type, const QUrl& name)
{
    QVariant found = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource)
        return found;
    QImage picture;
    if (!picture.loadFromData(found.toByteArray()))
        return found;
    const qreal ratio = devicePixelRatioF();
    const int width = std::min(picture.width(), qRound(mostWidth * ratio));
    picture = picture.scaledToWidth(width, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(ratio);
    return picture;
}

} // namespace gripscope
