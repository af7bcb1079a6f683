
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <mutex>
#include <set>
#include <sstream>
#include <thread>

#include "core/error.hpp"
#include "proofs/certificates/statement_files.hpp"
#include "proofs/certificates/statements.hpp"
#include "report/audit/certificate_record.hpp"
#include "report/tools/files.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::report::audit {

using namespace proofs;
using tools::Json;
namespace fs = std::filesystem;

namespace {

const char * const purpose = "have Coq check certificates";
const tools::Tool coqc{"coqc", "coq", purpose}, env{"env", "coreutils", purpose},
    timeout{"timeout", "coreutils", purpose};
// As in the Makefile of certificates.
const char * const heaps = "OCAMLRUNPARAM=s=8M,o=400";

std::string fingerprint_of(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error) ? certificates::fingerprint(tools::read_file(file)) : "";
}

bool is_newer(const fs::path& file, const fs::path& than) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return !error && time >= fs::last_write_time(than, error) && !error;
}

// The names of all that is stated there.
std::vector<std::string> stated_in(const fs::path& file) {
  std::error_code error;
  std::istringstream lines(fs::exists(file, error) ? tools::read_file(file) : "");
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Definition ") && line.ends_with(" : Prop :=")) {
      names.push_back(line.substr(11, line.size() - 21));
    }
  }
  return names;
}

class Questions {
 public:
  explicit Questions(const fs::path& directory)
      : directory_(directory), record_(read_record(directory / certificate_record)), workshop_(purpose) {
    if (!is_sealed(record_)) {
      throw InputOutputError(
          fmt::format("{} is not as it was made; 'stickslip certify ID --out {}' writes it again",
                      (directory / certificate_record).string(), directory.string()));
    }
    tools::require(coqc);
  }

  [[nodiscard]] Json answered() {
    for (const Json& one : record_.at("foundations")) {
      foundations_.emplace(fs::path(one.at("file").get<std::string>()).stem(), one.at("text"));
    }
    stated_ = stated_in(directory_ / certificates::statements_name);
    Json& claims = record_.at("claims");
    for (const Json& claim : claims) {
      ++claims_in_[name_of(claim)];
    }
    for (Json& claim : claims) {
      look_at(claim);
    }
    std::set<std::string> needed{"Matrices"};
    for (const Json& claim : claims) {
      if (claim.at("accepted") == true) {
        for (const std::string& name : required_by(tools::read_file(file_of(claim)))) {
          needed.insert(name);
        }
      }
    }
    if (any_accepted()) {
      compile(needed);
    }
    for (Json& claim : claims) {
      claim["compiled"] = claim.at("accepted") == true ? fingerprint_of(compiled_of(claim)) : "";
    }
    const std::vector<std::vector<std::string>> groups = for_coqchk(known_before());
    std::map<std::string, std::string> axioms;
    std::map<std::string, Answer> answers;
    std::mutex one_at_a_time;
    // Of all that is compiled this takes longest: coqchk, which is asked of it last, begins meanwhile.
    const std::shared_future<void> stated = std::async(std::launch::deferred, [&] {
      if (any_accepted()) {
        compile({"Statements"});
      }
    });
    std::vector<std::function<void()>> tasks{[&] {
      stated.get();
      while (any_accepted() && !asked_of_all(axioms)) {
      }
    }};
    for (const std::vector<std::string>& group : groups) {
      tasks.emplace_back([&, is_last = &group == &groups.back()] {
        if (is_last) {
          stated.get();
        }
        const Answer all = answer_of(group);
        for (const std::string& name : group) {
          const Answer one = all == Answer::accepted || group.size() == 1 ? all : answer_of({name});
          const std::lock_guard lock(one_at_a_time);
          answers.emplace(name, one);
        }
      });
    }
    side_by_side(tasks);
    take(answers);
    for (Json& claim : claims) {
      if (claim.at("accepted") != true) {
        claim["compiled"] = claim["again"] = "";
      }
    }
    for (Json& one : record_["foundations"]) {
      const auto made = compiled_.find(fs::path(one.at("file").get<std::string>()).stem());
      one["compiled"] = made == compiled_.end() ? "" : made->second;
    }
    record_["coq"] = {{"version", tools::version_in(tools::run(coqc, {"--version"}))}, {"axioms", axioms}};
    return sealed(record_);
  }

 private:
  [[nodiscard]] static std::string name_of(const Json& claim) {
    return fs::path(claim.at("file").get<std::string>()).stem();
  }
  [[nodiscard]] fs::path file_of(const Json& claim) const {
    return directory_ / claim.at("file").get<std::string>();
  }
  [[nodiscard]] fs::path compiled_of(const Json& claim) const {
    return directory_ / (name_of(claim) + ".vo");
  }

  static void judge(Json& claim, const Json& accepted, const std::string& reason) {
    claim["accepted"] = accepted;
    claim["reason"] = reason;
  }
  [[nodiscard]] bool any_accepted() const {
    return std::ranges::any_of(record_.at("claims"),
                               [](const Json& claim) { return claim.at("accepted") == true; });
  }
  void refuse_all(const std::string& reason) {
    for (Json& claim : record_.at("claims")) {
      if (claim.at("accepted") == true) {
        judge(claim, false, reason);
      }
    }
  }

  // Whether there is something to ask Coq about: accepted, for the time being.
  void look_at(Json& claim) {
    before_.push_back({claim.at("compiled"), claim.at("again")});
    const fs::path file = file_of(claim), log = fs::path(file).replace_extension(".log");
    if (fingerprint_of(file) != claim.at("text")) {
      judge(claim, false, "its file is not the one that was written");
    } else if (claim.at("theorems") != stated_of(claim.at("claim"))) {
      judge(claim, false, "its theorems are not those that Statements.v has of it");
    } else if (claim.at("imports") != imported_by(file)) {
      judge(claim, false, "what it rests on is not what its file imports");
    } else if (!rests_on_refused(claim)) {
      std::error_code error;
      if (fs::exists(compiled_of(claim), error)) {
        claim["seconds"] = share_of(claim, seconds_in(log));
        judge(claim, true, "");
        if (const fs::path link = workshop_.path() / (name_of(claim) + ".vo"); !fs::is_symlink(link)) {
          fs::create_symlink(fs::absolute(compiled_of(claim)), link);
        }
      } else if (is_newer(log, file)) {
        const bool in_time = tools::read_file(log).find("no end within") == std::string::npos;
        judge(claim, false,
              fmt::format("{}: see {}",
                          in_time ? "Coq does not accept it" : "Coq did not come to an end in time",
                          log.filename().string()));
      } else {
        judge(claim, nullptr, "Coq was not asked");
      }
    }
    if (claim.at("accepted") != true) {
      roots_.emplace(name_of(claim), std::pair{claim.at("accepted"), name_of(claim)});
    }
  }
  // The names of the claim's theorems. That Statements.v is the one that was written is seen when it is
  // compiled.
  [[nodiscard]] std::vector<std::string> stated_of(const std::string& claim) const {
    const std::string ending = certificates::file_name(claim).substr(5) + "_";
    std::vector<std::string> names;
    for (const std::string& name : stated_) {
      const std::size_t number = name.find_last_not_of("0123456789") + 1;
      if (name.substr(0, number).ends_with(ending) && name.find('_') + ending.size() == number) {
        names.push_back(name);
      }
    }
    return names;
  }
  // The files of claims among what a claim's file requires.
  [[nodiscard]] static std::set<std::string> imported_by(const fs::path& file) {
    std::set<std::string> names;
    for (const std::string& name : required_by(tools::read_file(file))) {
      if (name.starts_with("Claim")) {
        names.insert(name);
      }
    }
    return names;
  }
  // Of what all claims of a file took, one's.
  [[nodiscard]] std::string share_of(const Json& claim, const std::string& seconds) const {
    const int together = claims_in_.at(name_of(claim));
    return together == 1 || seconds.empty()
               ? seconds
               : fmt::format("{:.3f}", std::strtod(seconds.c_str(), nullptr) / together);
  }
  // Then it is as little accepted as what it rests on.
  [[nodiscard]] bool rests_on_refused(Json& claim) {
    for (const std::string import : claim.at("imports")) {
      if (const auto root = roots_.find(import); root != roots_.end()) {
        const auto [accepted, name] = root->second;
        judge(claim, accepted,
              fmt::format("it rests on {}, {}", name,
                          accepted.is_null() ? "of which Coq was not asked" : "which is not accepted"));
        roots_.insert_or_assign(name_of(claim), root->second);
        return true;
      }
    }
    return false;
  }
  // Of a claim, and of all that rest on it.
  void refuse(const std::string& name, const std::string& reason) {
    for (Json& claim : record_.at("claims")) {
      if (name_of(claim) == name) {
        judge(claim, false, reason);
        roots_.insert_or_assign(name, std::pair{Json(false), name});
      } else if (claim.at("accepted") == true) {
        (void)rests_on_refused(claim);
      }
    }
  }

  // The files that all stand on, from the texts that were recorded, as far as they are needed, each once
  // those are done that it requires. In the workshop: what stands compiled beside their texts may come from
  // others.
  void compile(const std::set<std::string>& needed) {
    std::map<std::string, std::vector<std::string>> left;  // what each requires
    const auto add = [&](const auto& self, const std::string& name) -> void {
      const auto text = foundations_.find(name);
      if (text == foundations_.end() || left.contains(name) || compiled_.contains(name) || !any_accepted()) {
        return;
      }
      const std::string file = name + ".v";
      if (fingerprint_of(directory_ / file) != text->second) {
        refuse_all(file + " is not the one that was written");
        return;
      }
      const std::string content = tools::read_file(directory_ / file);
      tools::write_file(workshop_.path() / file, content);
      const std::vector<std::string> below = required_by(content);
      left.emplace(name, below);
      std::ranges::for_each(below, [&](const std::string& other) { self(self, other); });
    };
    std::ranges::for_each(needed, [&](const std::string& name) { add(add, name); });
    while (!left.empty() && any_accepted()) {
      std::map<std::string, tools::Ran> ran;
      std::vector<std::function<void()>> tasks;
      for (const auto& [name, below] : left) {
        if (std::ranges::none_of(below, [&](const std::string& other) { return left.contains(other); })) {
          tasks.emplace_back(
              [this, &answer = ran[name], file = name + ".v"] { answer = compiled_in_workshop(file); });
        }
      }
      if (tasks.empty()) {
        refuse_all("the files that all stand on require each other");
        return;
      }
      side_by_side(tasks);
      for (const auto& [name, answer] : ran) {
        left.erase(name);
        if (!answer.succeeded) {
          refuse_all(fmt::format("Coq does not accept {}.v: {}", name, error_in(answer.complaints)));
          return;
        }
        compiled_.emplace(name, fingerprint_of(workshop_.path() / (name + ".vo")));
      }
    }
  }
  [[nodiscard]] tools::Ran compiled_in_workshop(const std::string& file) const {
    return tools::attempt(env, {heaps, "coqc", "-w", "none", "-Q", ".", "Stickslip", file}, {},
                          workshop_.path());
  }

  // All theorems at once. Where Coq refuses a line it is its claim that is refused, and the rest has to be
  // asked again.
  [[nodiscard]] bool asked_of_all(std::map<std::string, std::string>& axioms) {
    std::vector<certificates::Proved> proved;
    for (const Json& claim : record_.at("claims")) {
      if (claim.at("accepted") == true) {
        proved.push_back({name_of(claim), claim.at("theorems").get<std::vector<std::string>>()});
      }
    }
    tools::write_file(workshop_.path() / certificates::final_name, certificates::final_file(proved));
    const tools::Ran ran = compiled_in_workshop(certificates::final_name);
    if (!ran.succeeded) {
      std::vector<std::string> lines{"", ""};  // they are counted from 1, and the first is of the foundations
      for (const certificates::Proved& one : proved) {
        lines.push_back(one.file);
      }
      for (const certificates::Proved& one : proved) {
        lines.insert(lines.end(), one.theorems.size(), one.file);
      }
      const std::size_t line = line_in(ran.complaints);
      const std::string which = line < lines.size() ? lines[line] : "";
      if (which.empty()) {
        refuse_all("Coq does not accept Final.v: " + error_in(ran.complaints));
      } else {
        refuse(which, "Coq says of what was compiled: " + error_in(ran.complaints));
      }
      return false;
    }
    axioms = axioms_in(ran.output);
    for (const auto& [name, says] : axioms) {
      if (!is_allowed(name, says)) {
        refuse_all(fmt::format("it, or another of those that were asked about, rests on {}{}{}", name,
                               says.empty() ? "" : " : ", says));
        axioms.clear();
        return true;
      }
    }
    return true;
  }

  // Of which claims coqchk has said before what it would say now.
  [[nodiscard]] std::set<std::string> known_before() const {
    std::set<std::string> known;
    if (!std::ranges::all_of(record_.at("foundations"), [&](const Json& one) {
          const auto made = compiled_.find(fs::path(one.at("file").get<std::string>()).stem());
          return made == compiled_.end() || made->second == one.at("compiled");
        })) {
      return known;
    }
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const Json& claim = record_.at("claims").at(i);
      if (claim.at("accepted") == true && claim.at("compiled") == before_[i].first &&
          before_[i].second != "" && std::ranges::all_of(claim.at("imports"), [&](const Json& import) {
            return known.contains(import.get<std::string>());
          })) {
        known.insert(name_of(claim));
      }
    }
    return known;
  }

  // What coqchk is to be asked about, some files at a time, for loading the libraries takes as long for one
  // as for many, the last time about Statements, too; of the other claims, what it said before, or why it is
  // not asked: it has no virtual machine, and much interval arithmetic takes it hours.
  [[nodiscard]] std::vector<std::vector<std::string>> for_coqchk(const std::set<std::string>& known) {
    std::set<std::string> files;
    for (std::size_t i = 0; i < before_.size(); ++i) {
      Json& claim = record_.at("claims").at(i);
      if (claim.at("accepted") != true) {
        claim["again"] = "";
      } else if (known.contains(name_of(claim))) {
        claim["again"] = before_[i].second;
      } else if (claim.at("intervals") != true) {
        files.insert(name_of(claim));
      } else {
        claim["again"] = "not asked: interval arithmetic";
      }
    }
    if (files.empty()) {
      return {};
    }
    for (const auto& [name, made] : compiled_) {
      if (name != "Numbers") {  // interval arithmetic, made for whole numbers: it takes coqchk many minutes
        files.insert(name);
      }
    }
    // Dealt out, so that all groups take about as long.
    constexpr std::size_t at_once = 12;
    std::vector<std::pair<std::uintmax_t, std::string>> by_size;
    for (const std::string& name : files) {
      by_size.emplace_back(fs::file_size(workshop_.path() / (name + ".vo")), name);
    }
    std::ranges::sort(by_size, std::greater{});
    std::vector<std::vector<std::string>> groups((files.size() + at_once - 1) / at_once);
    for (std::size_t i = 0; i < by_size.size(); ++i) {
      groups[i % groups.size()].push_back(by_size[i].second);
    }
    groups.back().push_back("Statements");
    return groups;
  }

  // All of these, as many at a time as there are processors.
  static void side_by_side(const std::vector<std::function<void()>>& tasks) {
    std::atomic<std::size_t> next = 0;
    std::vector<std::future<void>> lanes;
    for (unsigned lane = 0; lane < std::max(1U, std::thread::hardware_concurrency()); ++lane) {
      lanes.push_back(std::async(std::launch::async, [&] {
        for (std::size_t task = next++; task < tasks.size(); task = next++) {
          tasks[task]();
        }
      }));
    }
    std::ranges::for_each(lanes, [](std::future<void>& lane) { lane.get(); });
  }

  enum class Answer { accepted, refused, no_end };
  // A minute for each claim, or file of none: what is refused says why.
  [[nodiscard]] Answer answer_of(const std::vector<std::string>& names) const {
    int minutes = 0;
    for (const std::string& name : names) {
      minutes += claims_in_.contains(name) ? claims_in_.at(name) : 1;
    }
    std::vector<std::string> arguments{
        std::to_string(60 * minutes), "env", heaps, "coqchk", "-silent", "-Q", ".", "Stickslip"};
    for (const std::string& name : names) {
      arguments.insert(arguments.end(), {"-norec", "Stickslip." + name});
    }
    const tools::Ran ran = tools::attempt(timeout, arguments, {}, workshop_.path());
    return ran.succeeded                                  ? Answer::accepted
           : ran.output.empty() && ran.complaints.empty() ? Answer::no_end
                                                          : Answer::refused;
  }

  [[nodiscard]] bool is_accepted(const std::string& name) const {
    return std::ranges::any_of(record_.at("claims"), [&](const Json& claim) {
      return name_of(claim) == name && claim.at("accepted") == true;
    });
  }
  // What coqchk said; what Coq refuses is refused for what that says.
  void take(const std::map<std::string, Answer>& answers) {
    for (const auto& [name, answer] : answers) {
      if (answer == Answer::refused && foundations_.contains(name)) {
        refuse_all(fmt::format("coqchk does not accept {}.v", name));
      } else if (answer == Answer::refused && is_accepted(name)) {
        refuse(name, "coqchk does not accept it");
      }
    }
    for (Json& claim : record_.at("claims")) {
      if (const auto answer = answers.find(name_of(claim)); answer != answers.end()) {
        claim["again"] = answer->second == Answer::accepted ? "accepted" : "came to no end in a minute";
      }
    }
  }

  fs::path directory_;
  Json record_;
  tools::Workshop workshop_;
  std::map<std::string, std::string> foundations_,
      compiled_;                               // by names: the texts' fingerprints, those of .vo
  std::vector<std::string> stated_;            // the names of all statements
  std::map<std::string, int> claims_in_;       // how many each file holds
  std::vector<std::pair<Json, Json>> before_;  // of each claim: "compiled" and "again"
  // Of what is not accepted: whether it is refused, and the first that is of what it rests on.
  std::map<std::string, std::pair<Json, std::string>> roots_;
};

}  // namespace

Json checked(const fs::path& directory) {
  return Questions(directory).answered();
}

}  // namespace stickslip::report::audit
