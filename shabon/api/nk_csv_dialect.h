// n-k tables as spreadsheets write them: ';' or tabs between the columns, perhaps with decimal commas. See nk_file.h.
#pragma once

#include <string>
#include <string_view>

#include "shabon/base/result.h"

namespace shabon::api {

// The text with ',' between the columns and decimal points, every line as long as before and every character in its
// place. ';' in the first line that is no comment separates the columns, and so does a tab that stands beside no ',';
// a ',' in a number is then its decimal point. Other texts come back as they are. Errors: a number with two such
// signs, a file that uses both.
Result<std::string> with_commas_and_points(std::string_view text, const std::string& source);

}  // namespace shabon::api
