#include "ramify/dossier/subject.hpp"

#include <utility>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/format/binary_trees.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/tree/contract_unary.hpp"
#include "ramify/tree/resolve_forks.hpp"

namespace ramify {
namespace {

Subject subject_of(OrderCounts counts, const std::string& file) {
  Subject subject{file,           counts.name, 0, 0, {}, {}, {}, {measure_orders(counts), std::nullopt},
                  counts.warnings};
  subject.counts = std::move(counts);
  return subject;
}

Subject subject_of(RecordedTree tree, const std::string& file) {
  Subject subject{file, tree.name, 0, 0, {}, {}, {}, measure_all(tree), {}};
  subject.tree = std::move(tree);
  return subject;
}

std::vector<Subject> read_table(const std::string& text, const std::string& file) {
  std::vector<Subject> subjects;
  for (OrderCounts& counts : read_order_counts(SourceText(text, file)))
    subjects.push_back(subject_of(std::move(counts), file));
  return subjects;
}

std::vector<Subject> read_tree_subjects(const std::string& text, const std::string& file,
                                        const ReportRequest& request) {
  Remarks remarks;
  auto trees = read_trees(text, file, std::nullopt, {request.root, 0}, remarks);
  std::vector<Subject> subjects;
  for (RecordedTree& tree : trees) tree = contract_unary(std::move(tree));
  const std::vector<RecordedTree> recorded = request.resolve.empty() ? std::vector<RecordedTree>() : trees;
  if (!request.resolve.empty())
    trees = binary_trees(std::move(trees), file, {request.resolve, request.seed, "they are to be resolved"});
  for (std::size_t i = 0; i < trees.size(); ++i) {
    subjects.push_back(subject_of(std::move(trees[i]), file));
    if (!recorded.empty() && wide_forks(recorded[i].tree) > 0) subjects.back().as_recorded = recorded[i];
  }
  subjects.front().remarks = remarks.lines(file);
  return subjects;
}

}  // namespace

std::vector<Subject> read_subjects(const ReportRequest& request) {
  std::vector<Subject> all;
  for (const std::string& file : request.files) {
    const std::string text = read_tree_file(file);
    auto subjects = is_order_table(text) ? read_table(text, file) : read_tree_subjects(text, file, request);
    if (all.size() + subjects.size() > most_subjects)
      throw Error(fmt::format("{}: {} trees up to here", file, all.size() + subjects.size()),
                  fmt::format("a report is about {} at most", most_subjects), "take files with fewer");
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      subjects[i].place = i + 1;
      subjects[i].of = subjects.size();
      all.push_back(std::move(subjects[i]));
    }
  }
  return all;
}

}  // namespace ramify
