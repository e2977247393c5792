// ramify law: its tables, and what it takes in memory.
#include <cctype>
#include <initializer_list>
#include <sstream>

#include "program.hpp"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ramify/tabulate/law_request.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify::test {
namespace {

/// `list statistics` and `law` say the same of what has a law.
TEST(Law, AnswersForWhatTheListSaysIsKnownAndForNothingElse) {
  const CsvData list = CsvData::parse(ramify("list statistics").out, "list");
  for (std::size_t row = 0; row < list.rows(); ++row) {
    const std::string name(list.at(row, "name")), known(list.at(row, "known"));
    const std::string law = "law --model bst --n 10 --statistic " + name;
    EXPECT_EQ(ramify(law).code, known == "exact law" ? 0 : 2) << name;
    EXPECT_EQ(ramify(law + " --moments").code, known.starts_with("exact") ? 0 : 2) << name;
  }
}

TEST(Law, PrintsEveryValueThatHasAProbability) {
  EXPECT_EQ(ramify("law --model bst --n 0,1,3 --statistic strahler").out,
            "model,n,statistic,value,probability\n"
            "bst,0,strahler,0,1\n"
            "bst,1,strahler,1,1\n"
            "bst,3,strahler,1,0.6666666666666666\n"
            "bst,3,strahler,2,0.3333333333333333\n");
}

TEST(Law, PrintsTheMeanCountsOfOrders) {
  EXPECT_EQ(ramify("law --model 'split(0.25)' --n 15 --statistic orders").out,
            "model,n,leaf_order,order,mean_nodes,mean_streams\n"
            "split(0.25),15,0,0,16,16\n"
            "split(0.25),15,0,1,11,5\n"
            "split(0.25),15,0,2,4,1\n"
            "split(0.25),15,0,3,0,0\n"
            "split(0.25),15,0,4,0,0\n");  // catalogue A6
}

TEST(Law, OfATableOfOnesOwn) {
  const Scratch scratch;
  const std::string text = "n,left,probability\n2,0,0.5\n2,1,0.5\n3,0,0.25\n3,1,0.5\n3,2,0.25\n";
  std::filesystem::create_directory(scratch / "a, b");
  const std::string path = scratch.file("a, b/law (1).csv", text);
  EXPECT_EQ(ramify("law --model 'file(" + path + ")' --n 3 --statistic strahler").out,
            "model,n,statistic,value,probability\n"
            "\"file(" +
                path +
                ")\",3,strahler,1,0.5\n"
                "\"file(" +
                path + ")\",3,strahler,2,0.5\n");
  EXPECT_EQ(ramify("theory --model 'file(" + path + "),catalan'").out.find("file"), std::string::npos);
  EXPECT_EQ(ramify("theory --model 'file(" + path + "),catalan'").code, 0);
}

TEST(Law, OutputFileIsTheTable) {
  const Scratch scratch;
  const std::string what = "law --model 'beta(1,5)' --n 10:100:3 --statistic height --moments";
  const Ran ran = ramify(what + " -o " + (scratch / "law.csv").string());
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(read_file(scratch / "law.csv"), ramify(what).out);
}

/// Peak memory of the program, in bytes.
double peak_memory(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), RAMIFY_PROGRAM);
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  EXPECT_EQ(posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ), 0);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  rusage usage{};
  EXPECT_EQ(wait4(child, &status, 0, &usage), child);
  EXPECT_EQ(status, 0) << arguments[2];
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

struct Built {
  const char* model;
  const char* statistic;
  const char* table;  ///< an option, or ""
  Size n;

  LawQuantity quantity() const {
    if (std::string_view(table) == "--moments") return LawQuantity::moments;
    return *table == '\0' ? LawQuantity::law : LawQuantity::covariances;
  }

  friend std::ostream& operator<<(std::ostream& out, const Built& built) {
    return out << built.statistic << " of " << built.model;
  }
};

class LawMemory : public testing::TestWithParam<Built> {};

TEST_P(LawMemory, IsEstimatedToAFactorOfTwo) {
  const auto& [model, statistic, table, largest] = GetParam();
  const auto used = [&](Size n) {
    std::vector<std::string> arguments{"law",         "--model", model,    "--n", std::to_string(n),
                                       "--statistic", statistic, "--exact"};
    if (*table != '\0') arguments.emplace_back(table);
    return peak_memory(arguments);
  };
  const double taken = used(largest) - used(1);
  const LawRequest request{Model::parse(model),
                           LawSubject::parse(statistic),
                           GetParam().quantity(),
                           {static_cast<double>(largest)},
                           true};
  const double estimate = law_cost(request.model, request.work(), largest).bytes;
  EXPECT_GT(estimate, taken / 2);
  EXPECT_LT(estimate, taken * 2);
}

INSTANTIATE_TEST_SUITE_P(EveryLaw, LawMemory,
                         testing::Values(Built{"bst", "strahler", "--moments", 16384},
                                         Built{"patricia(0.5)", "balance", "--moments", 32768},
                                         Built{"beta(2,2)", "fill_level", "--moments", 8192},
                                         Built{"beta_multinomial(2,2)", "strahler", "--moments", 8192},
                                         Built{"bst", "height", "--moments", 8192},
                                         Built{"catalan", "height", "--moments", 4096},
                                         Built{"beta(0.01,0.01)", "height", "--moments", 2048},
                                         Built{"dst(0.02)", "height", "--moments", 16384},
                                         Built{"bst", "depth", "--moments", 8192},
                                         Built{"beta(0.1,0.1)", "depth", "--moments", 4096},
                                         Built{"patricia(0.23)", "depth", "--moments", 16384},
                                         Built{"split(0.01)", "depth", "--moments", 16384},
                                         Built{"dst(0.3)", "orders", "", 16384},
                                         Built{"split(0.25)", "orders", "--moments", 4096},
                                         Built{"catalan", "orders", "--covariances", 1024}),
                         [](const auto& test) {
                           return name_of({test.param.model, test.param.statistic, test.param.table,
                                           std::to_string(test.param.n)});
                         });

struct Value {
  const char* model;
  const char* n;
  const char* statistic;
  double mean;
  double digits;  ///< half a unit of the last one printed

  friend std::ostream& operator<<(std::ostream& out, const Value& value) {
    return out << value.statistic << " of " << value.model;
  }
};

class LargeLaw : public testing::TestWithParam<Value> {};

/// Fields of the last line of a CSV table.
std::vector<std::string> last_fields(const std::string& table) {
  const std::size_t end = table.find_last_not_of('\n'), begin = table.rfind('\n', end) + 1;
  std::istringstream line(table.substr(begin, end + 1 - begin));
  std::vector<std::string> fields;
  for (std::string field; std::getline(line, field, ',');) fields.push_back(field);
  return fields;
}

// Values that others computed size after size, far beyond what is exact here: one for each recurrence and
// kind of row. They lie within the error that is printed. Smaller ones, to all digits:
// tests/exact/known_values_test.cpp.
TEST_P(LargeLaw, HasTheKnownMeanWithinItsError) {
  const auto& [model, n, statistic, mean, digits] = GetParam();
  std::ostringstream command;
  command << "law --model '" << model << "' --n " << n << " --statistic " << statistic << " --moments";
  const Ran ran = ramify(command.str());
  ASSERT_EQ(ran.code, 0) << ran.err;
  ASSERT_TRUE(ran.out.starts_with("model,n,statistic,mean,variance,error,variance_error\n")) << ran.out;
  const auto fields = last_fields(ran.out);
  ASSERT_EQ(fields.size(), 7u) << ran.out;
  const double error = std::stod(fields[5]);
  EXPECT_NEAR(std::stod(fields[3]), mean, digits + error) << ran.out;
  EXPECT_LT(error, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Known, LargeLaw,
                         testing::Values(Value{"bst", "65536", "strahler", 10.062157766249, 5e-13},
                                         Value{"bst", "32768", "height", 36.0351294226 + 1, 5e-11},
                                         Value{"bst", "1e9", "strahler", 18.8167895030, 5e-11},
                                         Value{"bst", "1e9", "height", 79.0073971678 + 1, 5e-11},
                                         Value{"patricia(0.23)", "131072", "fill_level", 8.0735, 5e-5},
                                         Value{"patricia(0.23)", "131072", "strahler", 9.0003, 5e-5},
                                         Value{"patricia(1/2)", "131072", "fill_level", 13.9854, 5e-5}),
                         [](const auto& test) {
                           return name_of({test.param.model, test.param.statistic, test.param.n});
                         });

}  // namespace
}  // namespace ramify::test
