#include "ramify/model/preset.hpp"

#include "ramify/core/find_named.hpp"

namespace ramify {

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all{
      {"symmetric", "split(1/2)", 15, "constant split 1/2: complete", "A6; Kruszewski 1996, Figure 2.12"},
      {"asymmetric", "split(1/4)", 15, "constant split 1/4", "A6; Kruszewski 1996, Figure 2.13"},
      {"beta_young", "beta(1,1)", 15, "beta tree of 15 nodes: a random search tree",
       "A8; Kruszewski 1996, Figures 2.14 and 2.15"},
      {"beta_lopsided", "beta(10,80)", 2000, "individuals of one family (n as in Table 2.1)",
       "A8; Kruszewski 1996, Table 2.5"},
      {"beta_large", "beta(10,10)", 10000, "a large tree", "A8; Kruszewski 1996, Figure 2.16"},
      {"depth_balanced", "node_beta(d,d)", 2000, "splits more even with depth (n is not given)",
       "A10; Kruszewski 1996, Table 2.6"},
      {"size_balanced", "node_beta(n/size,n/size)", 2000,
       "splits more even in smaller subtrees (label and n are not given)", "A10; Kruszewski 1996, Table 2.6"},
      {"depth_lopsided", "node_beta(d,1)", 2000, "splits more lopsided with depth (n is not given)",
       "A10; Kruszewski 1996, Table 2.6"},
      {"two_phases", "node_beta(size >= n/5 ? 1 : 10, size >= n/5 ? 1 : 10)", 2000,
       "uniform splits near the root, even ones beyond (n is not given)", "A10; Kruszewski 1996, Table 2.6"},
      {"apple_deterministic", "split(1/4.35)", 579, "apple, every split alike",
       "A6; Kruszewski 1996, Figure 3.4"},
      {"apple", "dst(0.23)", 579, "apple, Barker et al. 1973", "A11; Kruszewski 1996, Table 3.4"},
      {"white_fir", "ternary(1/4.8)", 1000, "white fir, Leopold 1971", "A22; Kruszewski 1996, Table 3.8"},
      {"maple_forest", "ternary(1/3.19)", 1000, "sugar maple grown in forest (n is not given)",
       "A23; Kruszewski 1996, Table 3.9"},
      {"maple_open", "ternary(1/7.05)", 1000, "sugar maple grown on open ground (n is not given)",
       "A23; Kruszewski 1996, Table 3.9"},
      {"maple_varying", "node_ternary(size > 100 ? 1/3.19 : 1/(3.19+log(d)))", 1000,
       "sugar maple, ratio by depth and size, Steingraeber 1982 (n is not given)",
       "A24; Kruszewski 1996, Figure 3.6"},
      {"search_tree", "bst", 500, "random binary search tree", "A14; Kruszewski 1996, Figure 4.20"},
      {"lightning", "node_beta(d/10,d/10)", 200,
       "a stem first, even forks near the ground (reconstruction: the thesis gives no formula)",
       "A33; Kruszewski 1996, Figure 5.1"},
      {"bronchial_tree", "dst(1/2.74)", 1000, "bronchial tree from the trachea down, Cumming et al. 1970",
       "A34; Kruszewski 1996, Figures 5.2 and 5.3"},
      {"pulmonary_artery", "dst(1/3.39)", 1000, "pulmonary artery from its stem down, Cumming et al. 1970",
       "A34; Kruszewski 1996, 5.1.6"},
  };
  return all;
}

const Preset& find_preset(std::string_view name) {
  return find_named(presets(), &Preset::name, name, "preset");
}

}  // namespace ramify
