#pragma once

#include "page/index/index_contents.h"

namespace aoscore::testing {

/// An index of made-up results without pictures: `scenes` scenes with `views` views, and `methods` methods on
/// each, of which the first errs least everywhere, and the last failed on the first view of each scene.
IndexBuilder synthetic_index(int scenes, int views, int methods);

}  // namespace aoscore::testing
