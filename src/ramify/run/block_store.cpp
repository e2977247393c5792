#include "ramify/run/block_store.hpp"

#include <algorithm>
#include <span>
#include <system_error>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

constexpr int application = 0x524d4659;  // "RMFY", in the file's header
constexpr int layout = 1;                // of the tables below

constexpr const char* tables =
    "CREATE TABLE plan(line INTEGER PRIMARY KEY, text TEXT NOT NULL);"
    "CREATE TABLE cell(cell INTEGER PRIMARY KEY, bytes BLOB NOT NULL);"
    "CREATE TABLE block(cell INTEGER NOT NULL, place INTEGER NOT NULL, bytes BLOB NOT NULL,"
    " PRIMARY KEY(cell, place)) WITHOUT ROWID;";

std::span<const std::uint8_t> bytes_of(const SQLite::Column& column) {
  return {static_cast<const std::uint8_t*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())};
}

std::int64_t whole(std::size_t value) {
  return static_cast<std::int64_t>(value);
}

std::size_t rows_of(const SQLite::Database& connection, const char* table) {
  SQLite::Statement query(connection, fmt::format("SELECT count(*) FROM {}", table));
  query.executeStep();
  return static_cast<std::size_t>(query.getColumn(0).getInt64());
}

KeptWork kept_work(const SQLite::Database& connection) {
  return {rows_of(connection, "cell"), rows_of(connection, "block")};
}

std::string counted_work(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The first name beside a file that is free.
fs::path free_name(const fs::path& file) {
  fs::path name = file.string() + ".damaged";
  for (int i = 2; fs::exists(name); ++i) name = fmt::format("{}.damaged-{}", file.string(), i);
  return name;
}

Error refused(const fs::path& file, const SQLite::Exception& reason) {
  if (reason.getErrorCode() == SQLITE_BUSY || reason.getErrorCode() == SQLITE_LOCKED)
    return Error(fmt::format("another program uses '{}'", file.string()), "two would mix their blocks",
                 "wait for it, or choose another --out");
  return Error(fmt::format("cannot write '{}'", file.string()), reason.getErrorStr(),
               "make room, or choose another --out; what was kept stays, --resume goes on with it");
}

}  // namespace

std::string to_string(const KeptWork& kept) {
  return fmt::format("{} and {}", counted_work(kept.cells, "cell"), counted_work(kept.blocks, "block"));
}

/// The open file.
class BlockStore::Database {
 public:
  /// Throws SQLite::Exception.
  explicit Database(const fs::path& file)
      : connection(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) {
    // A commit is a write to the log: safe from the end of the process, if not from that of the power.
    connection.exec("PRAGMA locking_mode=EXCLUSIVE");
    connection.exec("PRAGMA journal_mode=WAL");
    connection.exec("PRAGMA synchronous=OFF");
  }

  bool is_empty() const { return rows_of(connection, "sqlite_master") == 0; }

  bool is_sound() const {
    return number("PRAGMA application_id") == application && number("PRAGMA user_version") == layout &&
           connection.execAndGet("PRAGMA quick_check(1)").getString() == "ok";
  }

  void make(const std::vector<std::string>& plan) {
    SQLite::Transaction all(connection);
    connection.exec(tables);
    connection.exec(fmt::format("PRAGMA application_id={}", application));
    connection.exec(fmt::format("PRAGMA user_version={}", layout));
    SQLite::Statement line(connection, "INSERT INTO plan VALUES(?, ?)");
    for (std::size_t i = 0; i < plan.size(); ++i) {
      line.reset();
      line.bind(1, whole(i));
      line.bind(2, plan[i]);
      line.exec();
    }
    all.commit();
  }

  std::vector<std::string> plan() const {
    std::vector<std::string> lines;
    SQLite::Statement query(connection, "SELECT text FROM plan ORDER BY line");
    while (query.executeStep()) lines.push_back(query.getColumn(0).getString());
    return lines;
  }

  mutable SQLite::Database connection;

 private:
  std::int64_t number(const std::string& query) const { return connection.execAndGet(query).getInt64(); }
};

namespace {

/// Throws Error where the store is of another plan.
void require_same_plan(const fs::path& file, const std::vector<std::string>& kept,
                       const std::vector<std::string>& wanted) {
  const auto [there, here] = std::ranges::mismatch(kept, wanted);
  if (there == kept.end() && here == wanted.end()) return;
  throw Error(fmt::format("'{}' is of another run: it has \"{}\" where this one has \"{}\"", file.string(),
                          there == kept.end() ? "nothing more" : *there,
                          here == wanted.end() ? "nothing more" : *here),
              "blocks of different runs do not make a sample",
              "take the config and version it was made with, another --out, or --restart to drop it");
}

}  // namespace

BlockStore::BlockStore(fs::path file, const Plan& plan) : plan_(&plan), file_(std::move(file)) {
  const auto wanted = described(plan);
  try {
    try {
      auto database = std::make_unique<Database>(file_);
      const bool is_new = database->is_empty();
      if (is_new) database->make(wanted);
      if (database->is_sound()) database_ = std::move(database);
      if (database_ && !is_new) require_same_plan(file_, database_->plan(), wanted);
    } catch (const SQLite::Exception& reason) {
      if (reason.getErrorCode() != SQLITE_NOTADB && reason.getErrorCode() != SQLITE_CORRUPT) throw;
    }
    if (database_) return;
    set_aside_ = free_name(file_);
    fs::rename(file_, *set_aside_);
    for (const char* ending : {"-wal", "-shm", "-journal"})
      if (fs::exists(file_.string() + ending))
        fs::rename(file_.string() + ending, set_aside_->string() + ending);
    database_ = std::make_unique<Database>(file_);
    database_->make(wanted);
  } catch (const SQLite::Exception& reason) {
    throw refused(file_, reason);
  }
}

BlockStore::~BlockStore() = default;

KeptWork BlockStore::kept() const {
  return kept_work(database_->connection);
}

std::optional<CellSums> BlockStore::cell(std::size_t cell) const {
  SQLite::Statement query(database_->connection, "SELECT bytes FROM cell WHERE cell = ?");
  query.bind(1, whole(cell));
  if (!query.executeStep()) return std::nullopt;
  auto grown = decode_block(bytes_of(query.getColumn(0)), *plan_);
  return grown ? std::optional(std::move(grown->sums)) : std::nullopt;
}

std::vector<GrownBlock> BlockStore::blocks(std::size_t cell) const {
  std::vector<GrownBlock> found;
  SQLite::Statement query(database_->connection, "SELECT bytes FROM block WHERE cell = ? ORDER BY place");
  query.bind(1, whole(cell));
  while (query.executeStep())
    if (auto grown = decode_block(bytes_of(query.getColumn(0)), *plan_)) found.push_back(std::move(*grown));
  return found;
}

void BlockStore::save(const GrownBlock& grown) {
  const auto bytes = encode(grown);
  try {
    SQLite::Statement insert(database_->connection, "INSERT OR REPLACE INTO block VALUES(?, ?, ?)");
    insert.bind(1, whole(grown.block.job));
    insert.bind(2, whole(grown.block.index));
    insert.bind(3, bytes.data(), static_cast<int>(bytes.size()));
    insert.exec();
  } catch (const SQLite::Exception& reason) {
    throw refused(file_, reason);
  }
}

void BlockStore::complete(std::size_t cell, const CellSums& sums) {
  const auto bytes = encode({{cell, 0, plan_->cells[cell].replicates, 0}, sums});
  try {
    SQLite::Transaction both(database_->connection);
    SQLite::Statement insert(database_->connection, "INSERT OR REPLACE INTO cell VALUES(?, ?)");
    insert.bind(1, whole(cell));
    insert.bind(2, bytes.data(), static_cast<int>(bytes.size()));
    insert.exec();
    SQLite::Statement drop(database_->connection, "DELETE FROM block WHERE cell = ?");
    drop.bind(1, whole(cell));
    drop.exec();
    both.commit();
  } catch (const SQLite::Exception& reason) {
    throw refused(file_, reason);
  }
}

KeptWork BlockStore::kept_in(const fs::path& file) {
  try {
    return kept_work(SQLite::Database(file.string(), SQLite::OPEN_READONLY));
  } catch (const SQLite::Exception&) {
    return {};
  }
}

}  // namespace ramify
