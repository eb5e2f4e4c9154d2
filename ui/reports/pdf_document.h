// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/work_watch.h"

#include <QImage>
#include <QString>

#include <memory>
#include <vector>

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

} // namespace gripscope
