#pragma once

#include <concepts>
#include <type_traits>

namespace aoscore {

/// Of is Record, const or not. The member lists of records are written for such types.
template <class Record, class Of>
concept RecordOf = std::same_as<std::remove_const_t<Record>, Of>;

}  // namespace aoscore
