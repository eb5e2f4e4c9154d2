// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// Has the file of a LibraryService open as well, in the same program, and lets it go for what needs it
/// alone. Called on that service's thread.
class LibraryGuest {
public:
    virtual ~LibraryGuest() = default;
    virtual void leave() = 0; ///< until it has let go, or cannot
    virtual void comeBack() = 0;
};

} // namespace gripscope
