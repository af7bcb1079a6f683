#include "tests/proofs/certificates/coq.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>

#include "proofs/pascal2012/paper.hpp"
#include "tests/cli/program.hpp"

namespace stickslip {

using namespace proofs;

void write_certificates(const std::filesystem::path& directory, const certificates::Certificates& all) {
  const std::filesystem::path prelude = STICKSLIP_PRELUDE;
  for (const certificates::File& file : all.files) {
    const std::filesystem::path name(file.name);
    std::ifstream there(prelude / name);
    const std::string text{std::istreambuf_iterator<char>(there), {}};
    if (text != file.text || !std::filesystem::exists(prelude / name.stem().concat(".vo"))) {
      std::ofstream(directory / name) << file.text;
      continue;
    }
    // With their times, by which make judges.
    const Run copied = run("/bin/sh", {"-c", fmt::format("cp -p '{}/{}'.* '{}'", prelude.string(),
                                                         name.stem().string(), directory.string())});
    CHECK(copied.code == 0);
  }
}

certificates::Certificates compiled(const std::filesystem::path& directory,
                                    const std::set<std::string>& claims) {
  certificates::Certificates all = certificates::certificates(pascal2012::paper().claims, claims);
  write_certificates(directory, all);
  for (const char * goal : {"all", "Final.vo"}) {
    const Run made =
        run("/usr/bin/make", {"--silent", "--jobs=2", "--directory=" + directory.string(), goal});
    CAPTURE(made.err);
    CAPTURE(made.out);
    CHECK(made.code == 0);
  }
  return all;
}

std::vector<bool> accepted(const std::filesystem::path& directory, const std::set<std::string>& imports,
                           const std::vector<Asked>& asked) {
  // What fails leaves a proof open, or a name unknown, and the next command is read all the same.
  std::string text = fmt::format(
      "From Stickslip Require Import Algebra Inverses Numbers Stability Calculus Definitions Auxiliary "
      "{}.\nOpen Scope "
      "R_scope.\n"
      "Set Default Timeout 60.\n",
      fmt::join(imports, " "));
  for (std::size_t i = 0; i < asked.size(); ++i) {
    text += fmt::format("Theorem asked_{0} :\n{1}.\nProof.\n{2}\nQed.\nAbort All.\nCheck asked_{0}.\n", i,
                        asked[i].statement, asked[i].proof);
  }
  std::ofstream(directory / "asked.v") << text;
  const Run answer = run(
      "/bin/sh", {"-c", fmt::format("coqtop -q -w none -Q '{0}' Stickslip < '{0}/asked.v' 2>'{0}/asked.err'",
                                    directory.string())});
  std::vector<bool> result;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::string name = fmt::format("asked_{}\n     : ", i);
    result.push_back(("\n" + answer.out).find("\n" + name) != std::string::npos);
  }
  return result;
}

}  // namespace stickslip
