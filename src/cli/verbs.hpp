#pragma once

#include "program.hpp"

namespace ramify::cli {

// Each adds one verb to the program.
void add_list(Program& program);
void add_sample(Program& program);
void add_law(Program& program);
void add_measure(Program& program);
void add_test(Program& program);
void add_trie(Program& program);
void add_theory(Program& program);
void add_run(Program& program);
void add_reproduce(Program& program);
void add_fit(Program& program);
void add_horton(Program& program);
void add_design(Program& program);
void add_report(Program& program);
void add_draw(Program& program);
void add_describe(Program& program);

/// All of them, in the order of --help.
inline void add_verbs(Program& program) {
  for (const auto add : {add_list, add_sample, add_law, add_measure, add_test, add_trie, add_theory, add_run,
                         add_reproduce, add_fit, add_horton, add_design, add_report, add_draw, add_describe})
    add(program);
}

}  // namespace ramify::cli
