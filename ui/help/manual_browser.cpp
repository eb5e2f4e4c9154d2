// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_browser.h"

#include "ui/help/manual_pages.h"

#include <QImage>
#include <QTextBlock>
#include <QTextTable>
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
    setSource(QUrl(u"qrc"_s + manualPath(file)), QTextDocument::MarkdownResource);
}

QString ManualBrowser::page() const
{
    return source().fileName();
}

void ManualBrowser::doSetSource(const QUrl& name, QTextDocument::ResourceType type)
{
    QTextBrowser::doSetSource(name, type);
    spaceOut();
    emit pageShown(page());
}

void ManualBrowser::spaceOut()
{
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        cursor.setPosition(block.position());
        if (cursor.currentTable())
            continue;
        QTextBlockFormat format = block.blockFormat();
        const bool isHeading = format.headingLevel() > 0;
        const bool isFirst = block == document()->begin();
        const bool isItem = block.textList() && block.next().textList();
        const bool isCode = format.hasProperty(QTextFormat::BlockCodeFence) || format.nonBreakableLines();
        format.setTopMargin(isHeading && !isFirst ? 16 : 0);
        format.setBottomMargin(isItem ? 4 : isCode ? 0 : 8);
        format.setLineHeight(120, QTextBlockFormat::ProportionalHeight);
        cursor.setBlockFormat(format);
    }
    cursor.endEditBlock();
    moveCursor(QTextCursor::Start);
}

QVariant ManualBrowser::loadResource(int type, const QUrl& name)
{
    if (type != QTextDocument::ImageResource)
        return QTextBrowser::loadResource(type, name);
    const QVariant found =
        QTextBrowser::loadResource(type, QUrl(u"qrc"_s + manualPath(u"pictures/"_s + name.fileName())));
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
