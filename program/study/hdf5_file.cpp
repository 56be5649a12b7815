// Writes columns of numbers to an HDF5 file, block by block.

#include "program/study/hdf5_file.h"

#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include "engine/output_file.h"
#include "models/error.h"
#include "models/file_watch.h"

namespace spoke::study {
namespace {

constexpr hsize_t kBlock = 65536;  // numbers that are written together
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The failure of a call of the library.
struct Hdf5Failure {};

/// An identifier of the library, closed at the end. Throws Hdf5Failure if it is invalid.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {
    if (id < 0) throw Hdf5Failure();
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  hid_t id() const { return id_; }
  /// Closes it now and writes buffered data.
  void close() {
    if (close_(std::exchange(id_, -1)) < 0) throw Hdf5Failure();
  }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t status) {
  if (status < 0) throw Hdf5Failure();
}

/// Makes properties of objects without creation times, so that equal studies have equal bytes.
Handle timeless(hid_t kind) {
  Handle properties(H5Pcreate(kind), H5Pclose);
  require(H5Pset_obj_track_times(properties.id(), false));
  return properties;
}

Handle make_group(hid_t parent, const std::string& name) {
  const Handle properties = timeless(H5P_GROUP_CREATE);
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose};
}

Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type.id(), std::max<std::size_t>(size, 1)));
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  return type;
}

void add_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type = text_type(text.size());
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  const std::string bytes = text.empty() ? std::string(1, '\0') : text;
  require(H5Awrite(attribute.id(), type.id(), bytes.data()));
}

/// A data set of rows of one width that are written one after the other. Rows left out, and the
/// ends of shorter rows, are filled with not-a-numbers.
class Rows {
 public:
  Rows(hid_t parent, const std::string& name, hsize_t rows, hsize_t width)
      : dataset_(make(parent, name, rows, width)), width_(width) {}
  hid_t id() const { return dataset_.id(); }

  void append(const std::vector<double>& row) {
    waiting_.insert(waiting_.end(), row.begin(), row.end());
    waiting_.resize(waiting_.size() + width_ - row.size(), kNoNumber);
    if (waiting_.size() >= std::max(kBlock, width_)) flush();
  }
  void flush() {
    if (waiting_.empty()) return;
    const std::array<hsize_t, 2> start = {written_, 0}, count = {waiting_.size() / width_, width_};
    const Handle memory(H5Screate_simple(2, count.data(), nullptr), H5Sclose);
    const Handle file(H5Dget_space(dataset_.id()), H5Sclose);
    require(H5Sselect_hyperslab(file.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                                nullptr));
    require(H5Dwrite(dataset_.id(), H5T_NATIVE_DOUBLE, memory.id(), file.id(), H5P_DEFAULT,
                     waiting_.data()));
    written_ += count[0];
    waiting_.clear();
  }

 private:
  static Handle make(hid_t parent, const std::string& name, hsize_t rows, hsize_t width) {
    const std::array<hsize_t, 2> size = {rows, width};
    const Handle space(H5Screate_simple(2, size.data(), nullptr), H5Sclose);
    const Handle properties = timeless(H5P_DATASET_CREATE);
    return {H5Dcreate2(parent, name.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT,
                       properties.id(), H5P_DEFAULT),
            H5Dclose};
  }

  Handle dataset_;
  hsize_t width_, written_ = 0;
  std::vector<double> waiting_;
};

/// Joins the names of columns, one per line.
template <class Item>
std::string joined(const std::vector<Item>& items, std::string Item::*field) {
  std::string text;
  for (const Item& item : items) text += (text.empty() ? "" : "\n") + item.*field;
  return text;
}

/// Finds the longest history of each response that is a history.
std::vector<std::size_t> find_lengths(const ForEachRun& for_each) {
  std::vector<std::size_t> lengths;
  for_each([&](const RunResult& result) {
    lengths.resize(std::max(lengths.size(), result.histories.size()), 1);
    for (std::size_t h = 0; h < result.histories.size(); ++h)
      lengths[h] = std::max(lengths[h], result.histories[h].times.size());
  });
  return lengths;
}

void write_runs(hid_t file, const Study& study, const Sampling& sampling,
                const ForEachRun& for_each) {
  std::vector<Response> numbers;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < study.responses.size(); ++k)
    if (study.responses[k].kind != ResponseKind::history) {
      numbers.push_back(study.responses[k]);
      places.push_back(k);
    }
  const auto runs = static_cast<hsize_t>(study.design.runs);
  Rows status(file, "status", runs, 1);
  Rows parameters(file, "parameters", runs, study.parameters.size());
  add_attribute(status.id(), "names", "done\ndoubtful\ndiverged\nrefused");
  add_attribute(parameters.id(), "names", joined(study.parameters, &Parameter::name));
  std::optional<Rows> responses;
  if (!numbers.empty()) {
    responses.emplace(file, "responses", runs, numbers.size());
    add_attribute(responses->id(), "names", joined(numbers, &Response::name));
    add_attribute(responses->id(), "units", joined(numbers, &Response::unit));
  }
  for_each([&](const RunResult& result) {
    status.append({static_cast<double>(result.status)});
    parameters.append(sampling.values(result.run));
    std::vector<double> row;
    for (const std::size_t k : places) row.push_back(result.responses[k]);
    if (responses) responses->append(row);
  });
  status.flush();
  parameters.flush();
  if (responses) responses->flush();
}

void write_histories(hid_t file, const Study& study, const ForEachRun& for_each) {
  if (!study.has_histories()) return;
  std::vector<std::size_t> lengths = find_lengths(for_each);
  std::vector<Rows> times, values;
  const Handle group = make_group(file, "histories");
  for (const Response& response : study.responses) {
    if (response.kind != ResponseKind::history) continue;
    const std::size_t h = values.size();
    lengths.resize(std::max(lengths.size(), h + 1), 1);
    const Handle of_one = make_group(group.id(), response.name);
    const auto runs = static_cast<hsize_t>(study.design.runs);
    times.emplace_back(of_one.id(), "t", runs, lengths[h]);
    values.emplace_back(of_one.id(), "value", runs, lengths[h]);
    add_attribute(times.back().id(), "unit", "s");
    add_attribute(values.back().id(), "unit", response.unit);
  }
  for_each([&](const RunResult& result) {
    for (std::size_t h = 0; h < values.size(); ++h) {
      const bool has_one = h < result.histories.size();
      times[h].append(has_one ? result.histories[h].times : std::vector<double>());
      values[h].append(has_one ? result.histories[h].values : std::vector<double>());
    }
  });
  for (Rows& rows : times) rows.flush();
  for (Rows& rows : values) rows.flush();
}

void write_new(const std::string& file, const Study& study, const Sampling& sampling,
               const ForEachRun& for_each) {
  const Handle properties = timeless(H5P_FILE_CREATE);
  Handle output(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, properties.id(), H5P_DEFAULT), H5Fclose);
  add_attribute(output.id(), "title", study.title);
  add_attribute(output.id(), "scenario", study.scenario_file);
  write_runs(output.id(), study, sampling, for_each);
  write_histories(output.id(), study, for_each);
  output.close();
}

}  // namespace

bool has_hdf5() { return true; }

void write_hdf5(const std::string& file, const Study& study, const Sampling& sampling,
                const ForEachRun& for_each) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // silent, since faults are reported here
  const std::string temporary = file + ".tmp";
  announce_replacing(file);
  announce_replacing(temporary);
  const UnfinishedFile unfinished(temporary);
  const auto refuse = [&](const std::string& reason) {
    unlink(temporary.c_str());
    throw InputError(file + ": cannot be written: " + reason);
  };
  try {
    write_new(temporary, study, sampling, for_each);
  } catch (const Hdf5Failure&) {
    refuse("the HDF5 library refuses (disk full, no permission, or in use)");
  }
  if (std::rename(temporary.c_str(), file.c_str()) != 0) refuse("it cannot be replaced");
}

}  // namespace spoke::study
