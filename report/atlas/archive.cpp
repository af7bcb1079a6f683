#include "report/atlas/archive.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

#ifdef STICKSLIP_HAS_HDF5
#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/decimal.hpp"
#include "report/atlas/summary.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#endif

namespace stickslip::report::atlas {

using namespace numeric::atlas;
namespace fs = std::filesystem;

#ifndef STICKSLIP_HAS_HDF5

namespace {
[[noreturn]] void refuse() {
  throw InputOutputError(
      "this program was built without HDF5: install libhdf5-dev (script/bootstrap cluster) and build again");
}
}  // namespace

bool has_hdf5() {
  return false;
}
void write_archive(const fs::path&, const Question&, const std::vector<Leaf>&) {
  refuse();
}
Archive read_archive(const fs::path&) {
  refuse();
}

#else

namespace {

// An open object of the library.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) {
      throw InputOutputError("the library HDF5 reports a failure");
    }
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: what the library calls it

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t status) {
  if (status < 0) {
    throw InputOutputError("the library HDF5 reports a failure");
  }
}

// The reasons of failures are told by us.
void be_silent() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

// ---- attributes: texts, one or many, and whole numbers

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, H5T_VARIABLE));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  return Handle(H5Tcopy(type), H5Tclose);
}

void put(hid_t file, const char * name, const std::vector<std::string>& texts, bool single = false) {
  const Handle type = text_type();
  const hsize_t count = texts.size();
  const Handle space(single ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle attribute(H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  std::vector<const char *> raw;
  for (const std::string& text : texts) {
    raw.push_back(text.c_str());
  }
  require(H5Awrite(attribute, type, raw.data()));
}
void put(hid_t file, const char * name, const std::string& text) {
  put(file, name, std::vector<std::string>{text}, true);
}
void put(hid_t file, const char * name, int number) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, name, H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, H5T_NATIVE_INT, &number));
}

std::vector<std::string> texts(hid_t file, const char * name) {
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  const Handle type = text_type();
  const Handle stored(H5Aget_type(attribute), H5Tclose);
  if (H5Tis_variable_str(stored) <= 0) {
    throw InputOutputError(fmt::format("its attribute {} is not text", name));
  }
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  std::vector<char *> raw(static_cast<std::size_t>(std::max<hssize_t>(count, 0)), nullptr);
  require(H5Aread(attribute, type, raw.data()));
  std::vector<std::string> result;
  for (const char * text : raw) {
    result.emplace_back(text == nullptr ? "" : text);
  }
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, raw.data());
  return result;
}
std::string text(hid_t file, const char * name) {
  const std::vector<std::string> all = texts(file, name);
  return all.empty() ? "" : all.front();
}
int number(hid_t file, const char * name) {
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  int result = 0;
  require(H5Aread(attribute, H5T_NATIVE_INT, &result));
  return result;
}

// ---- datasets, one row for each leaf

template <class T>
void put_rows(hid_t file, const char * name, hid_t stored, hid_t native, hsize_t columns,
              const std::vector<T>& values) {
  const std::array<hsize_t, 2> size{values.size() / columns, columns};
  const int rank = columns == 1 ? 1 : 2;
  const Handle space(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
  const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  require(H5Pset_obj_track_times(how, false));
  if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
    const std::array<hsize_t, 2> chunk{std::min<hsize_t>(size[0], 1 << 16), columns};
    require(H5Pset_chunk(how, rank, chunk.data()));
    require(H5Pset_shuffle(how));
    require(H5Pset_deflate(how, 6));
  }
  const Handle set(H5Dcreate2(file, name, stored, space, H5P_DEFAULT, how, H5P_DEFAULT), H5Dclose);
  require(H5Dwrite(set, native, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

template <class T>
std::vector<T> rows(hid_t file, const char * name, hid_t native) {
  const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(set), H5Sclose);
  std::vector<T> values(static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0)));
  require(H5Dread(set, native, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return values;
}

template <class T, class F>
std::vector<T> each(const std::vector<Leaf>& leaves, const F& f) {
  std::vector<T> values;
  values.reserve(leaves.size());
  for (const Leaf& leaf : leaves) {
    values.push_back(f(leaf));
  }
  return values;
}

// The attributes that the question and the boxes tell.
std::vector<std::pair<const char *, std::vector<std::string> > > told_by_boxes(
    const Question& q, const std::vector<Leaf>& leaves) {
  const Tally all = tally(q, leaves);
  return {{"program", {"stickslip atlas"}},
          {"command", {"stickslip atlas " + text_of(q)}},
          {"axes", axis_names(q)},
          {"decided", {share(all.decided).get_str()}},
          {"outside", {share(all.outside).get_str()}},
          {"open", {share(all.open).get_str()}},
          {"reasons", all_reasons(*q.family)}};
}

void put_attributes(hid_t file, const Question& q, const std::vector<Leaf>& leaves) {
  std::vector<std::string> names;
  std::vector<std::string> lower;
  std::vector<std::string> upper;
  for (std::size_t i = 0; i < q.region.size(); ++i) {
    names.push_back(names_of(q)[i]);
    lower.push_back(to_string(q.region[i].lower));
    upper.push_back(to_string(q.region[i].upper));
  }
  put(file, "version", tools::program_version());
  put(file, "libraries", tools::enumerated(tools::libraries(), [](const tools::Component& library) {
        return library.name + " " + library.version;
      }));
  put(file, "family", q.family->name);
  put(file, "parameters", names);
  put(file, "lower", lower);
  put(file, "upper", upper);
  put(file, "resolution", q.resolution);
  for (const auto& [name, values] : told_by_boxes(q, leaves)) {
    const bool many = std::string_view(name) == "axes" || std::string_view(name) == "reasons";
    put(file, name, values, !many);
  }
}

// Of the axes, box after box, rounded to doubles.
struct Bounds {
  std::vector<double> lower, upper;
};

Bounds bounds_of(const Question& q, const std::vector<Leaf>& leaves) {
  Bounds bounds;
  for (const Leaf& leaf : leaves) {
    const Box box = box_of(q, leaf.tile);
    for (const std::size_t axis : q.axes) {
      bounds.lower.push_back(box[axis].lower.get_d());
      bounds.upper.push_back(box[axis].upper.get_d());
    }
  }
  return bounds;
}

void put_datasets(hid_t file, const Question& q, const std::vector<Leaf>& leaves) {
  const auto [lower, upper] = bounds_of(q, leaves);
  put_rows(file, "tile", H5T_STD_U64LE, H5T_NATIVE_UINT64, 1,
           each<std::uint64_t>(leaves, [](const Leaf& leaf) { return leaf.tile; }));
  put_rows(file, "lower", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, q.axes.size(), lower);
  put_rows(file, "upper", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, q.axes.size(), upper);
  const auto put_counts = [&](const char * name, std::int8_t Finding::*member) {
    put_rows(file, name, H5T_STD_I8LE, H5T_NATIVE_INT8, 1,
             each<std::int8_t>(leaves, [&](const Leaf& leaf) { return leaf.finding.*member; }));
  };
  put_counts("orbits", &Finding::orbits);
  put_counts("admissible", &Finding::admissible);
  put_counts("stable", &Finding::stable);
  put_rows(file, "reason", H5T_STD_U8LE, H5T_NATIVE_UINT8, 1,
           each<std::uint8_t>(leaves, [](const Leaf& leaf) { return leaf.finding.reason; }));
}

// The file's bytes, made in memory: a disk that is full is met when they are written, and not within the
// library, which does not survive it.
std::string image_of(const Question& q, const std::vector<Leaf>& leaves) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_fapl_core(access, 1 << 20, false));
  const Handle out(H5Fcreate("atlas", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  put_attributes(out, q, leaves);
  put_datasets(out, q, leaves);
  require(H5Fflush(out, H5F_SCOPE_GLOBAL));
  std::string bytes(static_cast<std::size_t>(std::max<ssize_t>(H5Fget_file_image(out, nullptr, 0), 0)), '\0');
  require(H5Fget_file_image(out, bytes.data(), bytes.size()) > 0 ? 0 : -1);
  return bytes;
}

// That a file has its name there is on the disk.
void keep_names(const fs::path& directory) {
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_CLOEXEC);
  const bool kept = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
  ::close(descriptor);
  if (!kept) {
    throw InputOutputError(fmt::format("cannot write {}: the disk does not take it", directory.string()));
  }
}

Question question_of(hid_t file) {
  Question q;
  q.family = &numeric::families::family_named(text(file, "family"));
  const std::vector<std::string> names = texts(file, "parameters");
  const std::vector<std::string> lower = texts(file, "lower");
  const std::vector<std::string> upper = texts(file, "upper");
  const auto are_values = [&](Values values) {
    const std::vector<std::string>& known = names_of(*q.family, values);
    return names.size() + 1 >= known.size() && names.size() <= known.size() &&
           std::equal(names.begin(), names.end(), known.begin());
  };
  constexpr std::array kinds{Values::data, Values::coefficients, Values::forces};
  const auto * const kind = std::find_if(kinds.begin(), kinds.end(), are_values);
  if (kind == kinds.end() || lower.size() != names.size() || upper.size() != names.size()) {
    throw InputOutputError("its parameters are not those of an atlas");
  }
  q.values = *kind;
  for (std::size_t i = 0; i < names.size(); ++i) {
    q.region.push_back({parse_rational(lower[i]), parse_rational(upper[i])});
    if (!q.region.back().is_point()) {
      q.axes.push_back(i);
    }
  }
  q.resolution = number(file, "resolution");
  require_understood(q);
  return q;
}

Archive read_open(hid_t file) {
  Archive archive{question_of(file), text(file, "version"), {}};
  const auto tiles = rows<std::uint64_t>(file, "tile", H5T_NATIVE_UINT64);
  const auto orbits = rows<std::int8_t>(file, "orbits", H5T_NATIVE_INT8);
  const auto admissible = rows<std::int8_t>(file, "admissible", H5T_NATIVE_INT8);
  const auto stable = rows<std::int8_t>(file, "stable", H5T_NATIVE_INT8);
  const auto reason = rows<std::uint8_t>(file, "reason", H5T_NATIVE_UINT8);
  for (const std::size_t size : {orbits.size(), admissible.size(), stable.size(), reason.size()}) {
    if (size != tiles.size()) {
      throw InputOutputError("its columns are of different lengths");
    }
  }
  const std::size_t reasons = all_reasons(*archive.question.family).size();
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    archive.leaves.push_back({tiles[i], {orbits[i], admissible[i], stable[i], reason[i]}});
    if (reason[i] >= reasons) {
      throw InputOutputError(fmt::format("no reason has the number {}", reason[i]));
    }
  }
  const std::vector<Leaf> rows_in_file = archive.leaves;
  put_in_order(archive.question, archive.leaves);
  const Bounds bounds = bounds_of(archive.question, rows_in_file);
  const auto lower = rows<double>(file, "lower", H5T_NATIVE_DOUBLE);
  const auto upper = rows<double>(file, "upper", H5T_NATIVE_DOUBLE);
  if (lower.size() != bounds.lower.size() || upper.size() != bounds.upper.size()) {
    throw InputOutputError("its bounds are not those of its boxes");
  }
  const std::size_t axes = archive.question.axes.size();
  for (std::size_t i = 0; i < rows_in_file.size() * axes; ++i) {
    if (lower[i] != bounds.lower[i] || upper[i] != bounds.upper[i]) {
      archive.elsewhere.insert(rows_in_file[i / axes].tile);
    }
  }
  if (!gaps(archive.leaves).empty()) {
    throw InputOutputError("its boxes leave gaps");
  }
  for (const auto& [name, values] : told_by_boxes(archive.question, archive.leaves)) {
    if (texts(file, name) != values) {
      throw InputOutputError(fmt::format("its attribute {} is not what its boxes say", name));
    }
  }
  return archive;
}

}  // namespace

bool has_hdf5() {
  return true;
}

void write_archive(const fs::path& file, const Question& q, const std::vector<Leaf>& leaves) {
  be_silent();
  tools::write_file(file, image_of(q, leaves));
  keep_names(file.has_parent_path() ? file.parent_path() : fs::path("."));
}

Archive read_archive(const fs::path& file) {
  be_silent();
  if (!fs::is_regular_file(file)) {
    throw InputOutputError(fmt::format("{}: no such file", file.string()));
  }
  if (H5Fis_hdf5(file.c_str()) <= 0) {
    throw InputOutputError(fmt::format("{} is not an atlas: it is not an HDF5 file", file.string()));
  }
  try {
    const Handle in(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    return read_open(in);
  } catch (const Error& error) {
    throw InputOutputError(fmt::format("{} is not an atlas: {}", file.string(), error.what()));
  }
}

#endif

}  // namespace stickslip::report::atlas
