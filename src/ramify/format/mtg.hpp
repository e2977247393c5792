#pragma once

#include <vector>

#include "ramify/format/read_options.hpp"
#include "ramify/text/remarks.hpp"
#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Reads a multiscale tree graph (OpenAlea's MTG, CODE FORM-A; Godin and Caraglio 1998).
///
/// A line of the MTG section holds entities such as `^/S1+A1<U2` in one of its first columns: `/` is a part
/// at a finer scale, `<` the successor and `+` a branch of what stands before; a line goes on from the last
/// entity one column to the left, or with `^` in its own column: there `<` and `+` join the last entity of
/// their scale. `<<` and `++` are read as `<` and `+`. A name in the first column without `^` is absolute,
/// and what it repeats is there once. `*` is the last entity of its column at a later date: the latest values
/// stand. An entity of no class at the beginning is the scene where there is a class `$`. Lines without a
/// code, earlier dates and features that are not read are remarked.
///
/// With scale 0 the nodes of the tree are the vertices that have no parts, whatever their scale: every part
/// of the plant at its finest description. With another scale they are the vertices of that scale. Lengths
/// are those of a feature `length`, else the distance between the points XX, YY, ZZ of a vertex and its
/// parent; radii those of `radius`, else half of `diameter`, `width` or `TopDia`.
///
/// Ids for --root are numbers in the order of the file; names are the labels of the entities. Throws Error
/// with line and column. O(size) time.
std::vector<RecordedTree> read_mtg(SourceText source, const ReadOptions& options, Remarks& remarks);

}  // namespace ramify
