// SPDX-License-Identifier: GPL-3.0-or-later
// A key of [joint] that states one member of a law; the reader and its checks use it.
#pragma once

#include <functional>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace blockweir::scene {

/// `Law`: the law of a joint, or a base class of it.
template <class Law>
struct LawKey {
  using Of = Law;
  enum class Range { any, not_negative, angle };

  const char* name;
  std::variant<double Law::*, std::optional<double> Law::*, bool Law::*> member;
  Range range = Range::any;
  /// Whether the law's value of this key has no effect. Empty: every value has an effect.
  std::function<bool(const Law&)> is_idle;
  const char* without = "";              ///< what the joint lacks when the key has no effect
  std::vector<const char*> supplied_by;  ///< keys that would supply it

  /// The same key for a law that has this one as a base class.
  template <class Whole>
  [[nodiscard]] LawKey<Whole> of() const {
    const auto whole = [](auto of_part) -> decltype(LawKey<Whole>::member) {
      if constexpr (std::is_same_v<decltype(of_part), double Law::*>)
        return static_cast<double Whole::*>(of_part);
      else if constexpr (std::is_same_v<decltype(of_part), bool Law::*>)
        return static_cast<bool Whole::*>(of_part);
      else
        return static_cast<std::optional<double> Whole::*>(of_part);
    };
    return {name,       std::visit(whole, member), static_cast<typename LawKey<Whole>::Range>(range), is_idle, without,
            supplied_by};
  }
};

}  // namespace blockweir::scene
