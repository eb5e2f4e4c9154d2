// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/work_watch.h"

#include <QImage>
#include <QSizeF>
#include <QString>

#include <memory>
#include <vector>

class QFont;
class QPaintDevice;
class QTextDocument;

namespace gripscope {

/// A picture that the text names, see pdfPicture().
struct PdfPicture {
    QString name;
    QImage image;
};

/// A report of the program on A4: `html` with its pictures, pages numbered. Written whole or not at all,
/// and not where `watch` stopped it.
/// FileUnwritable. On any thread.
[[nodiscard]] Expected<void> writePdf(const QString& title, const QString& html,
                                      const std::vector<PdfPicture>& pictures, const QString& file,
                                      const std::shared_ptr<WorkWatch>& watch = {});

/// Stands on the page of what follows it.
[[nodiscard]] QString pdfHeading(const QString& text);
/// A line of a table of facts: a name and a text.
[[nodiscard]] QString pdfRow(const QString& name, const QString& text);
/// The picture of this name, as wide as the text; `size` says its shape.
[[nodiscard]] QString pdfPicture(const QString& name, QSize size);

/// Of all text on paper: the program's own font is sized for the screen.
[[nodiscard]] QFont pdfFont(double points);

/// The document of a report as it stands on its pages, each as large as `page`, in points of `device`:
/// - A heading stands on the page of what follows it.
/// - A picture that would leave the rest of a page empty is made smaller, down to two thirds.
/// - What a cell of a table holds with no-break spaces, and no other ones, is one line; where a table is then
///   wider than the page, the letters of class "small" become smaller.
/// - A number and its unit, and the unit itself, are never parted.
/// Nothing outside `pictures` is loaded, whatever an address in the text names.
[[nodiscard]] std::unique_ptr<QTextDocument>
layOutPdf(const QString& html, const std::vector<PdfPicture>& pictures, QPaintDevice& device, QSizeF page);

} // namespace gripscope
