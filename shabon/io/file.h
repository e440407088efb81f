// Whole files: read with a bound, written so that a failure leaves nothing half-written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "shabon/base/result.h"

namespace shabon::io {

// All bytes of a regular file. Errors, with the path as source: Failure::file when it cannot be opened or read or is no
// regular file (a directory, a device; a FIFO is refused, never waited for), Failure::content when it holds more than
// `max_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

// The same without a leading UTF-8 byte order mark.
Result<std::string> read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

// Writes a temporary file beside `path` and renames it, so that `path` holds the old bytes or the new ones, never a
// part. A symbolic link stays and its target is replaced; an existing file keeps its permissions; a target that is
// neither a regular file nor a directory (/dev/stdout, a FIFO with a reader) is written directly. Nothing is flushed to
// the disk by force. Errors: Failure::file with the path and the system's reason; the temporary file is removed.
Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

// Whether write_file_atomically could begin: finds an unwritable folder before a long computation. Leaves nothing
// behind. Errors as there.
Status check_writable(const std::filesystem::path& path);

}  // namespace shabon::io
