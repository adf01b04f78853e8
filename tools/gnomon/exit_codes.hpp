// What the shell sees.

#pragma once

namespace gnomon {

enum ExitCode : int {
    kFine = 0,
    kCheckFailed = 1,
    kWrongUsage = 2,
    kBadFile = 3,
    kCannotDo = 4,
    kNoOpenGl = 77,
};

} // namespace gnomon
