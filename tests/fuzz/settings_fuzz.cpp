// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/fuzzing.h"
#include "ui/settings/values/settings_exchange.h"

// Settings that are imported: what is taken is what the setting accepts, and nothing where anything is wrong.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Settings settings;
    const auto import = readSettings(bytesOf(data, size), QStringLiteral("x"), settings);
    if (!import)
        return 0;
    applyImport(settings, *import);
    for (const SettingChange& change : import->changes)
        require(settings.value(change.key) == (import->errors.isEmpty() ? change.after : change.before));
    require(readSettings(exportedSettings(settings), QStringLiteral("x"), settings)->errors.isEmpty());
    return 0;
}
