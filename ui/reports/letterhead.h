// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/reports/pdf_document.h"

#include <QImage>
#include <QStringList>

namespace gripscope {

class Settings;

/// Whose report it is, as it was set. A value: taken on the screen's thread, read on another.
struct LetterheadSource {
    QString company, address; ///< lines of the address are parted by semicolons
    QString logoFile;         ///< empty: none
};
[[nodiscard]] LetterheadSource letterheadSource(const Settings& settings);

struct Letterhead {
    QString company;
    QStringList address;
    QImage logo;
};

inline constexpr qint64 mostLogoBytes = 2'000'000;
inline constexpr int mostLogoSide = 4000; ///< pixels of a PNG

/// Reads the logo, PNG or SVG by what is in it. An SVG that names pictures, other files, entities or its own
/// parts is refused: a logo needs none of them, and they can read files or grow without end. FileUnreadable,
/// with what would do. On any thread.
[[nodiscard]] Expected<Letterhead> readLetterhead(const LetterheadSource& source);

/// The head of the first page, empty where nothing was set; its picture goes to writePdf().
[[nodiscard]] QString letterheadHtml(const Letterhead& letterhead);
[[nodiscard]] std::vector<PdfPicture> letterheadPictures(const Letterhead& letterhead);

} // namespace gripscope
