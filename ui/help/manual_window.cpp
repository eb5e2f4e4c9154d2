// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_windows.h"
#include "ui/widgets/controls.h"

#include <QEvent>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMap>
#include <QRegularExpression>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextTable>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const QString contents = u"index.md"_s;

ManualPage read(const QString& name)
{
    QFile file(manualPath(name));
    if (!file.open(QIODevice::ReadOnly))
        return {name, name, {}};
    const QString text = QString::fromUtf8(file.readAll());
    return {name, text.section(u'\n', 0, 0).mid(2).trimmed(), text}; // "# Title"
}

} // namespace

QString manualPath(const QString& file)
{
    const QString translated = u":/manual/%1/%2"_s.arg(QLocale().name().section(u'_', 0, 0), file);
    return QFile::exists(translated) ? translated : u":/manual/"_s + file;
}

std::vector<ManualPage> manualPages()
{
    std::vector<ManualPage> pages{read(contents)};
    static const QRegularExpression link(u"\\]\\((\\w+\\.md)\\)"_s);
    auto found = link.globalMatch(pages.front().text);
    while (found.hasNext()) {
        const QString name = found.next().captured(1);
        const auto isThis = [&name](const ManualPage& page) { return page.file == name; };
        if (std::none_of(pages.begin(), pages.end(), isThis))
            pages.push_back(read(name));
    }
    return pages;
}

bool speaksOf(const ManualPage& page, const QString& words)
{
    const QStringList wanted = words.split(u' ', Qt::SkipEmptyParts);
    return std::all_of(wanted.begin(), wanted.end(), [&page](const QString& word) {
        return page.text.contains(QRegularExpression(u"\\b"_s + QRegularExpression::escape(word),
                                                     QRegularExpression::CaseInsensitiveOption |
                                                         QRegularExpression::UseUnicodePropertiesOption));
    });
}

QString manualPageFor(const QString& screen)
{
    const QString page = screen + u".md"_s;
    return QFile::exists(manualPath(page)) ? page : contents;
}

namespace {
constexpr int mostWidth = 600;  ///< of a picture, logical pixels
constexpr int titleWidth = 216; ///< of a title in the list, beside its margins and a scroll bar
} // namespace

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

/// The colour of links is set in the document when it is read.
void ManualBrowser::changeEvent(QEvent* event)
{
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || source().isEmpty())
        return;
    const int place = verticalScrollBar()->value();
    reload();
    verticalScrollBar()->setValue(place);
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

namespace {
const RegisteredDialog<ManualWindow> manualWindowRow("manual", [](Workbench&, QWidget* over) {
    return new ManualWindow(over);
});
} // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : Dialog(parent, Conduct::Reads), m_pages(manualPages()), m_words(new QLineEdit(this)),
      m_list(new QListWidget(this)), m_browser(new ManualBrowser(this))
{
    setWindowTitle(tr("Manual"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_browser->setObjectName(u"manualPage"_s);
    m_browser->setAccessibleName(tr("Page of the manual"));
    auto* row = new QHBoxLayout;
    row->setSpacing(12);
    buildSide(row);
    row->addWidget(m_browser, 1);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 12, 12);
    column->addLayout(row, 1);
    buildButtons(column);
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, m_words,
            [this] { m_words->setFocus(); });
    connect(m_browser, &ManualBrowser::pageShown, this, &ManualWindow::followBrowser);
    filter();
    showPage(m_pages.front().file);
    resize(980, 620);
}

void ManualWindow::buildSide(QBoxLayout* row)
{
    m_words->setObjectName(u"manualWords"_s);
    m_words->setPlaceholderText(tr("Search (Ctrl+F)"));
    m_words->setAccessibleName(tr("Search the manual"));
    m_words->setClearButtonEnabled(true);
    m_list->setObjectName(u"manualPages"_s);
    m_list->setAccessibleName(tr("Pages of the manual"));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setWordWrap(true);
    auto* side = new QVBoxLayout;
    side->setSpacing(8);
    side->addWidget(m_words);
    side->addWidget(m_list, 1);
    row->addLayout(side);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_words, m_list})
        widget->setFixedWidth(264);
    connect(m_words, &QLineEdit::textChanged, this, &ManualWindow::filter);
    connect(m_words, &QLineEdit::returnPressed, m_list, [this] {
        m_list->setFocus();
        if (m_list->count() > 0)
            m_list->setCurrentRow(0);
    });
    connect(m_list, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item && item->data(Qt::UserRole).toString() != m_browser->page())
            showPage(item->data(Qt::UserRole).toString());
    });
}

void ManualWindow::buildButtons(QBoxLayout* column)
{
    auto* back = makeButton(tr("Back"), u"go-previous"_s, "", this);
    back->setEnabled(false);
    auto* keys = makeButton(tr("Keys and version…"), {}, "quiet", this);
    keys->setObjectName(u"keysButton"_s);
    auto* close = makeButton(tr("Close"), {}, "primary", this);
    for (QPushButton* button : {back, keys, close})
        button->setAutoDefault(false); // Enter belongs to the search
    auto* line = new QHBoxLayout;
    line->addWidget(back);
    line->addWidget(keys);
    line->addStretch(1);
    line->addWidget(close);
    column->addLayout(line);
    connect(back, &QPushButton::clicked, m_browser, &QTextBrowser::backward);
    connect(m_browser, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    connect(keys, &QPushButton::clicked, this, &ManualWindow::keysAsked);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
}

void ManualWindow::showPage(const QString& file)
{
    m_browser->showPage(file);
    const QString word = m_words->text().section(u' ', 0, 0, QString::SectionSkipEmpty);
    if (!word.isEmpty())
        m_browser->find(word);
}

void ManualWindow::filter()
{
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const ManualPage& page : m_pages) {
        if (!speaksOf(page, m_words->text()))
            continue;
        auto* item = new QListWidgetItem(page.title, m_list);
        item->setData(Qt::UserRole, page.file);
        item->setToolTip(page.title);
        const bool onOneLine = m_list->fontMetrics().horizontalAdvance(page.title) < titleWidth;
        item->setSizeHint({0, onOneLine ? 40 : 56});
    }
    if (m_list->count() == 0) {
        auto* none = new QListWidgetItem(tr("On no page. Try another word."), m_list);
        none->setFlags(Qt::NoItemFlags);
    }
    followBrowser();
}

void ManualWindow::followBrowser()
{
    const QSignalBlocker quiet(m_list);
    for (int row = 0; row < m_list->count(); ++row)
        if (m_list->item(row)->data(Qt::UserRole).toString() == m_browser->page())
            m_list->setCurrentRow(row);
}

} // namespace gripscope
