// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/reports/pdf_document.h"

#include <QSizeF>

#include <memory>

class QFont;
class QPaintDevice;
class QTextDocument;

namespace gripscope {

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
