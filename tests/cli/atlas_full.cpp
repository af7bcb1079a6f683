// Atlases as HDF5 files, and made by several processes.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "report/atlas/archive.hpp"
#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;
using namespace report::atlas;

Words near_S(const std::string& out) {
  return {"atlas", "symmetric", "--example",    "S", "--omega", "0.55..0.57",
          "--p",   "0..0.1",    "--resolution", "5", "--out",   out};
}

void change_first(const std::string& file, const char * column) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t set = H5Dopen2(opened, column, H5P_DEFAULT);
  const hid_t space = H5Dget_space(set);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  CHECK(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
  values[0] *= 1.0001;
  CHECK(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(opened);
}

// Another text, or other texts, all alike.
void change_attribute(const std::string& file, const char * name) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(opened, name, H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  const hid_t space = H5Aget_space(attribute);
  const std::vector<const char *> texts(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)), "1/7");
  CHECK(H5Awrite(attribute, type, texts.data()) >= 0);
  H5Sclose(space);
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(opened);
}

TEST_CASE("An atlas that says what is false is found out") {
  const TemporaryDirectory directory;
  const std::string file = directory / "a.h5";
  REQUIRE(stickslip_program(near_S(file)).code == 0);
  const Run confirmed = stickslip_program({"atlas", "--verify", file, "--sample", "50"});
  CHECK((confirmed.code == 0 || confirmed.code == 2));
  CHECK(confirmed.out.find(" 0 contradicted") != std::string::npos);

  const Archive archive = read_archive(file);
  const std::string wrong = directory / "wrong.h5";
  for (auto member : {&numeric::atlas::Finding::orbits, &numeric::atlas::Finding::admissible,
                      &numeric::atlas::Finding::stable}) {
    std::vector<numeric::atlas::Leaf> leaves = archive.leaves;
    for (numeric::atlas::Leaf& leaf : leaves) {
      if (leaf.finding.is_decided()) {
        ++(leaf.finding.*member);
        break;
      }
    }
    write_archive(wrong, archive.question, leaves);
    const Run found = stickslip_program({"atlas", "--verify", wrong, "--sample", "1000000"});
    CHECK(found.code == 1);
    CHECK(found.out.find(" 1 contradicted") != std::string::npos);
  }
  // A reason that is another one.
  {
    std::vector<numeric::atlas::Leaf> leaves = archive.leaves;
    const auto open = std::find_if(leaves.begin(), leaves.end(), [](const numeric::atlas::Leaf& leaf) {
      return !leaf.finding.is_decided();
    });
    REQUIRE(open != leaves.end());
    open->finding.reason = open->finding.reason == 7 ? 8 : 7;
    write_archive(wrong, archive.question, leaves);
    const Run found = stickslip_program({"atlas", "--verify", wrong, "--sample", "1000000"});
    CHECK(found.code == 1);
    CHECK(found.out.find(" 1 contradicted") != std::string::npos);
    const Run in_json = stickslip_program({"atlas", "--verify", wrong, "--sample", "1000000", "--json"});
    CHECK(in_json.code == 1);
    const nlohmann::json json = nlohmann::json::parse(in_json.out);
    CHECK(json["boxes"] == archive.leaves.size());
    CHECK(json["proved_again"] == archive.leaves.size());
    REQUIRE(json["contradicted"].size() == 1);
    const nlohmann::json& box = json["contradicted"][0];
    CHECK(box["reason"] == numeric::atlas::sentence_of(*archive.question.family, open->finding.reason));
    const numeric::atlas::Box exact = numeric::atlas::box_of(archive.question, open->tile);
    CHECK(box["box"]["omega"][0] == to_string(exact[numeric::atlas::place_of_omega].lower));
  }
  // Bounds that are not those of the box, whether it is in the sample or not.
  for (const char * column : {"lower", "upper"}) {
    write_archive(wrong, archive.question, archive.leaves);
    change_first(wrong, column);
    const Run found = stickslip_program({"atlas", "--verify", wrong, "--sample", "1"});
    CHECK(found.code == 1);
    CHECK(found.out.find(" 1 contradicted") != std::string::npos);
  }
  // Attributes that others read and the boxes do not bear out.
  for (const char * name : {"program", "command", "axes", "decided", "outside", "open", "reasons"}) {
    write_archive(wrong, archive.question, archive.leaves);
    change_attribute(wrong, name);
    const Run found = stickslip_program({"atlas", "--verify", wrong, "--sample", "1"});
    CHECK(found.code == 74);
    CHECK(is_one_sentence(found.err, std::string("attribute ") + name));
  }
  // A box is missing.
  std::vector<numeric::atlas::Leaf> leaves = archive.leaves;
  leaves.erase(leaves.begin() + 3);
  write_archive(wrong, archive.question, leaves);
  CHECK(is_one_sentence(stickslip_program({"atlas", "--verify", wrong}).err, "gaps"));
}

#ifdef STICKSLIP_MPIRUN

// mpirun, without the pictures of its failures.
Words copies(int n, const Words& arguments) {
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  Words all{"--oversubscribe", "-n", std::to_string(n), STICKSLIP_PROGRAM};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

TEST_CASE("Processes make the same atlas together, also when one of them, or mpirun, is killed") {
  const TemporaryDirectory directory;
  const std::string alone = directory / "alone.h5";
  REQUIRE(stickslip_program(near_S(alone)).code == 0);
  for (const int n : {1, 3}) {
    const std::string out = directory / ("n" + std::to_string(n));
    const Run made = run(STICKSLIP_MPIRUN, copies(n, near_S(out)));
    INFO(made.err);
    CHECK(made.code == 0);
    CHECK(content(out) == content(alone));
  }
  std::mt19937_64 random(23);
  for (int k = 0; k < kills(); ++k) {
    const std::string out = directory / ("k" + std::to_string(k));
    // The shell kills mpirun, the first process or the last of those that it has started, after a while.
    const char * const which = k % 3 == 0 ? "$m" : k % 3 == 1 ? "${1:-$m}" : "${2:-$m}";
    std::string command = "exec 2>/dev/null; cd '" + (directory / ".") + "'; '" STICKSLIP_MPIRUN "'";
    for (const std::string& word : copies(2, near_S(out))) {
      command += " '" + word + "'";
    }
    // Then all that is left of them, started since or not: Open MPI may wait for ever for a process that was
    // killed.
    command += " >/dev/null & m=$!; sleep 0." + std::to_string(2 + random() % 8) +
               "; set -- $(cat /proc/$m/task/*/children); kill -9 " + which +
               "; sleep 0.5; kill -9 $m; wait $m; for c in /proc/[0-9]*; do if [ \"$(cat $c/comm)\" = "
               "stickslip ] && "
               "grep -qsF '" +
               out + "' $c/cmdline; then kill -9 ${c#/proc/}; fi; done; sleep 0.3; true";
    CHECK(std::system(command.c_str()) == 0);
    const bool begun = fs::exists(out + ".log/question") || fs::exists(out);
    const Words more = begun ? Words{"--resume"} : Words{};
    fs::remove_all(begun ? out + ".none" : out + ".log");
    const Run rest = run(STICKSLIP_MPIRUN, copies(1 + k % 2, with(near_S(out), more)));
    INFO(rest.err);
    CHECK(rest.code == 0);
    CHECK(content(out) == content(alone));
  }
}

#endif

}  // namespace
}  // namespace stickslip
