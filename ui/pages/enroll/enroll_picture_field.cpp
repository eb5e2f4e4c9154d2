// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll/enroll_picture_field.h"

#include "ui/context/workbench.h"
#include "ui/widgets/controls.h"
#include "ui/windows/file_dialog.h"

#include <QClipboard>
#include <QDragEnterEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The first file of what is dragged or copied; empty: there is none.
QString fileOf(const QMimeData& data)
{
    for (const QUrl& url : data.urls())
        if (url.isLocalFile())
            return url.toLocalFile();
    return {};
}

} // namespace

EnrollPictureField::EnrollPictureField(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench)
{
    setAcceptDrops(true);
    m_view = new PartPictureView(workbench, 104, PartPictureView::Empty::Frame, this);
    m_view->setObjectName("pictureView");
    m_words = makeLabel({}, "second", this);
    m_words->setObjectName("pictureWords");
    m_words->setWordWrap(true);
    m_words->setMinimumHeight(40);
    m_words->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_choose = makeButton(tr("Choose picture…"), u"insert-image"_s, "", this);
    m_choose->setObjectName("choosePicture");
    m_paste = makeButton(tr("Paste"), u"edit-paste"_s, "", this);
    m_paste->setObjectName("pastePicture");
    m_remove = makeButton(tr("Remove"), u"edit-delete"_s, "quiet", this);
    m_remove->setObjectName("removePicture");
    m_remove->setAccessibleName(tr("Remove the picture"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(m_choose);
    buttons->addWidget(m_paste);
    buttons->addWidget(m_remove);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout;
    setSpacing(column, 0, 8);
    column->addStretch(1);
    column->addWidget(m_words);
    column->addLayout(buttons);
    column->addStretch(1);
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 16);
    row->addWidget(m_view);
    row->addLayout(column, 1);
    connect(m_choose, &QPushButton::clicked, this, &EnrollPictureField::ask);
    connect(m_paste, &QPushButton::clicked, this, &EnrollPictureField::paste);
    connect(m_remove, &QPushButton::clicked, this, [this] {
        clear();
        emit chosen(std::nullopt);
    });
    showPicture(std::nullopt);
}

void EnrollPictureField::showPicture(const std::optional<PartPicture>& picture)
{
    if (m_shown == picture && !m_words->text().isEmpty())
        return; // what is said of a file that could not be read stays
    m_shown = picture;
    m_view->setPicture(picture);
    m_remove->setVisible(picture.has_value());
    m_words->setText(picture ? tr("Shown with the type, so that nobody takes one for another.")
                             : tr("A picture of the part, if you like: choose a PNG or JPEG file, drop it "
                                  "here, or paste it."));
    setRole(m_words, "second");
}

void EnrollPictureField::clear()
{
    ++m_reading; // one that is still being read no longer counts
    m_words->clear();
    showPicture(std::nullopt);
}

void EnrollPictureField::ask()
{
    auto* dialog = new FileDialog(this, tr("Picture of the part"), {},
                                  tr("Pictures (*.png *.jpg *.jpeg);;All files (*)"));
    dialog->setObjectName("pictureDialog");
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &EnrollPictureField::readFile);
    dialog->open();
}

void EnrollPictureField::readFile(const QString& file)
{
    read([file] { return readPartPicture(file); });
}

void EnrollPictureField::paste()
{
    const QMimeData* copied = QGuiApplication::clipboard()->mimeData();
    const QString file = copied ? fileOf(*copied) : QString();
    if (!file.isEmpty())
        return readFile(file);
    const QImage image = copied && copied->hasImage() ? qvariant_cast<QImage>(copied->imageData()) : QImage();
    read([image] { return toPartPicture(image); });
}

void EnrollPictureField::read(std::function<Expected<PartPicture>()> reading)
{
    m_words->setText(tr("Reading the picture…"));
    setRole(m_words, "second");
    m_workbench->background().compute<Expected<PartPicture>>(
        this, std::move(reading), [this, number = ++m_reading](const Expected<PartPicture>& picture) {
            if (number != m_reading)
                return;
            if (picture) {
                showPicture(*picture);
                emit chosen(*picture);
                return;
            }
            m_words->setText(picture.error().describe());
            setRole(m_words, "error");
        });
}

void EnrollPictureField::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasImage() || !fileOf(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void EnrollPictureField::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    const QString file = fileOf(*event->mimeData());
    if (!file.isEmpty())
        return readFile(file);
    read([image = qvariant_cast<QImage>(event->mimeData()->imageData())] { return toPartPicture(image); });
}

void EnrollPictureField::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Paste))
        return paste();
    QWidget::keyPressEvent(event);
}

} // namespace gripscope
