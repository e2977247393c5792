#pragma once

#include <memory>

#include "ramify/law/graft_table.hpp"
#include "ramify/sample/folds.hpp"

namespace ramify {

/// The graft table of a fold, sizes 0..largest: from the statistic's own law where the fold is one statistic,
/// from the generic engine where it is a joint one. A second or so for the sizes of GraftRule.
template <class F>
std::shared_ptr<const GraftTableOf<F>> make_graft_table(const Model& model, Size largest);

extern template std::shared_ptr<const GraftTableOf<Strahler>> make_graft_table<Strahler>(const Model&, Size);
extern template std::shared_ptr<const GraftTableOf<Height>> make_graft_table<Height>(const Model&, Size);
extern template std::shared_ptr<const GraftTableOf<FillLevel>> make_graft_table<FillLevel>(const Model&,
                                                                                           Size);
extern template std::shared_ptr<const GraftTableOf<Balance>> make_graft_table<Balance>(const Model&, Size);
extern template std::shared_ptr<const GraftTableOf<LeanFold>> make_graft_table<LeanFold>(const Model&, Size);
extern template std::shared_ptr<const GraftTableOf<FullFold>> make_graft_table<FullFold>(const Model&, Size);

}  // namespace ramify
