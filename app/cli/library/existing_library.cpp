// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/existing_library.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

Expected<QString> existingLibraryFile(const QString& file)
{
    ASSIGN_OR_RETURN(const bool isThere, Library::isThere(file));
    if (!isThere) // opening would make an empty one
        return failure(ErrorCode::StorageOpen, {file, u"there is no such file; enrol types first"_qs});
    return file;
}

Expected<std::unique_ptr<Library>> openExistingLibrary(const QString& file)
{
    return existingLibraryFile(file).and_then([](const QString& path) { return Library::open(path); });
}

} // namespace gripscope::cli
