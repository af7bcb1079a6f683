#include "cli/arguments/arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

#include "cli/arguments/help.hpp"
#include "core/error.hpp"

namespace stickslip::cli {
namespace {

// What the texts of the help leave open: the paper's words, and what is taken by default.
Wording wording_of(const PaperInHelp& paper) {
  using Attracted = AttractorsOptions;
  const auto text = [](const auto& words) { return [words] { return fmt::format("{}", words); }; };
  const auto first = [](const PaperInHelp::Made& words_of, char end) {
    return [words_of, end] {
      const std::string words = words_of();
      return words.substr(0, words.find(end));
    };
  };
  return {{"examples", text(paper.examples)},
          {"family_names", text(paper.family_names)},
          {"judged_names", text(paper.judged_names)},
          {"families", text(paper.families)},
          {"part", paper.part},
          {"equation", first(paper.part, '.')},
          {"places", paper.places},
          {"first_place", first(paper.places, ',')},
          {"digits", text(OrbitsOptions::default_digits)},
          {"most_digits", text(OrbitsOptions::most_digits)},
          {"digits_of_latex", text(LatexOptions::default_digits)},
          {"starts", text(Attracted::default_starts)},
          {"starts_at_value", text(Attracted::default_starts_at_value)},
          {"most_periods", text(Attracted::default_most_periods)},
          {"values", text(Attracted::default_values)},
          {"pixels", text(Attracted::default_pixels)},
          {"resolution", text(AtlasOptions::default_resolution)},
          {"sample", text(AtlasOptions::default_sample)},
          {"periods", text(SimulateOptions::default_periods)},
          {"samples_in_period", text(SimulateOptions::samples_in_period)}};
}

// The names of the options that are given.
std::set<std::string> typed_of(const CLI::App& app) {
  std::set<std::string> typed;
  for (const CLI::Option * option : app.get_options([](const CLI::Option * o) { return o->count() > 0; })) {
    typed.insert(option->get_name());
  }
  return typed;
}

// A command and its options; parsing it fills these, `check` looks at them, and they are the request. What
// the help says of each stands in cli/help/.
template <class Options>
class Command {
  struct Kept {  // as long as the command
    Options options;
    std::function<void()> check = [] {};
  };
  CommandHelp help_;
  std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
  CLI::App& app_;

 public:
  Options& options = kept_->options;
  std::function<void()>& check = kept_->check;

  Command(CLI::App& program, Request& request, const Wording& wording, const std::string& name)
      : help_(help_of(name, wording)), app_(*program.add_subcommand(name, help_.words)) {
    app_.footer(help_.details);
    app_.callback([kept = kept_, &app = app_, &request] {
      const std::set<std::string> typed = typed_of(app);
      if constexpr (std::is_base_of_v<GivenMachine, Options>) {
        kept->options.typed = typed;
      }
      kept->check();
      request = kept->options;
    });
  }

  // An option or a place for a text, or for several; a flag.
  template <class T>
  CLI::Option * add(const std::string& name, T& value) {
    const auto& [type, words] = help_.entries.at(name);
    if constexpr (std::is_same_v<T, bool>) {
      return app_.add_flag(name, value, words);
    } else {
      return app_.add_option(name, value, words)->type_name(type);
    }
  }
  // An option whose value `take` is given, with the option's name without dashes; it throws UsageError.
  using Take = std::function<void(const std::string& bare, const std::string& text)>;
  CLI::Option * add_read(const std::string& name, const Take& take) {
    const auto& [type, words] = help_.entries.at(name);
    const auto take_it = [take, bare = name.substr(2)](const std::string& text) { take(bare, text); };
    return app_.add_option_function<std::string>(name, take_it, words)->type_name(type);
  }
  // One that may be left out, as `read` reads it: a number of a range, a state.
  template <class T, class Read>
  CLI::Option * add(const std::string& name, std::optional<T>& value, const Read& read) {
    return add_read(
        name, [&value, read](const std::string& bare, const std::string& text) { value = read(bare, text); });
  }
  CLI::Option * add(const std::string& name, std::optional<std::string>& text) {
    return add(name, text, [](const std::string&, const std::string& typed) { return typed; });
  }
  // A whole number from 1 to `most`.
  CLI::Option * add(const std::string& name, std::optional<int>& number, int most) {
    return add(name, number, [most](const std::string& bare, const std::string& text) {
      return whole_number(bare, text, most);
    });
  }
  void add_units() {
    add_read("--units",
             [&si = options.si](const std::string&, const std::string& text) { si = is_si(text); });
  }
  void add_jobs() { add("--jobs", options.jobs, most_jobs); }

  // --chi, --eta, ... for those of a machine, whose load is cos(omega t); the same and --phi; --example and
  // --params.
  void add_machine() {
    for (const char * name : {"chi", "eta", "us", "V", "omega", "p", "ur"}) {
      add_parameter(name);
    }
  }
  void add_parameters() {
    add_machine();
    add_parameter("phi");
  }
  void add_sources() {
    add("--example", options.example);
    add("--params", options.file.name);
  }

 private:
  void add_parameter(const std::string& name) {
    add_read("--" + name, [&all = options.parameters](const std::string& bare, const std::string& text) {
      all[bare] = text;
    });
  }
};

// A file of claims among words that name claims: the first that ends so.
void take_file(std::vector<std::string>& words, std::string& file) {
  const auto found =
      std::ranges::find_if(words, [](const std::string& word) { return word.ends_with(".claims"); });
  if (found != words.end()) {
    file = *found;
    words.erase(found);
  }
}

void define(Command<AuditOptions>& c, AuditOptions& o) {
  c.check = [&o] {
    if (!o.claims.empty() && !o.claims.ends_with(".claims")) {
      throw UsageError("stickslip audit does not know what to do with '" + o.claims +
                       "': a file of claims is called NAME.claims");
    }
  };
  c.add("FILE", o.claims);
  c.add("--out", o.out);
  c.add_jobs();
  CLI::Option * json = c.add("--json", o.json);
  CLI::Option * mutants = c.add("--mutants", o.mutants);
  constexpr int most = AttractorsOptions::greatest_number;
  c.add("--one-in", o.one_in, most)->needs(mutants);
  c.add("--seed", o.seed, most)->needs(mutants);
  c.add("--certificates", o.certificates);
  c.add("--compare", o.compare)->excludes(json);
}

void define(Command<CheckOptions>& c, CheckOptions& o) {
  c.check = [&o] { take_file(o.words, o.claims); };
  c.add("ID", o.words);
  CLI::Option * list = c.add("--list", o.list);
  c.add("--explain", o.explain);
  c.add_jobs();
  list->excludes(c.add("--json", o.json));
}

void define(Command<ProveOptions>& c, ProveOptions& o) {
  c.add("STATEMENT", o.statement)->required();
  c.add("ASSUMPTION", o.assumptions);
  c.add("--symbols", o.symbols)->delimiter(',');
  CLI::Option * explain = c.add("--explain", o.explain);
  c.add("--certificate", o.certificate);
  explain->excludes(c.add("--json", o.json));
}

void define(Command<CertifyOptions>& c, CertifyOptions& o) {
  c.check = [&o] {
    take_file(o.words, o.claims);
    if (o.out.empty() && o.record.empty()) {
      throw UsageError("stickslip certify needs --out DIR, or --record DIR");
    }
  };
  CLI::Option * ids = c.add("ID", o.words);
  CLI::Option * out = c.add("--out", o.out);
  c.add("--record", o.record)->excludes(out)->excludes(ids);
}

void define(Command<LatexOptions>& c, LatexOptions& o) {
  c.check = [&o] {
    take_file(o.names, o.claims);  // a file goes with them, a name does not
    if (!o.names.empty() && (o.errata || !o.theorem.empty())) {
      throw UsageError(fmt::format("NAME and {} do not go together", o.errata ? "--errata" : "--theorem"));
    }
  };
  CLI::Option * names = c.add("NAME", o.names);
  CLI::Option * list = c.add("--list", o.list);
  CLI::Option * bare = c.add("--bare", o.bare);
  CLI::Option * errata = c.add("--errata", o.errata);
  CLI::Option * theorem = c.add("--theorem", o.theorem);
  CLI::Option * in = c.add_read("--in", [&o](const std::string&, const std::string& word) {
    if (word != "chi" && word != "omega") {
      throw UsageError("in: '" + word + "' is neither chi nor omega");
    }
    o.in_frequencies = word == "omega";
  });
  CLI::Option * orbit = c.add("--orbit", o.orbit);
  errata->excludes(list);
  theorem->excludes(list)->excludes(errata);
  orbit->excludes(list)->excludes(names)->excludes(errata)->excludes(theorem)->excludes(in);
  bare->excludes(list)->excludes(errata)->excludes(theorem)->excludes(orbit);
  c.add_parameters();
  c.add_sources();
  c.add("--digits", o.digits, OrbitsOptions::most_digits);
}

void define(Command<OrbitsOptions>& c, OrbitsOptions& o) {
  c.add("FAMILY", o.family);
  c.add_parameters();
  c.add("--period", o.period, OrbitsOptions::most_periods_of_word);
  c.add("--near", o.near, state);
  c.add("--basin", o.basin);
  c.add_sources();
  c.add("--digits", o.digits, OrbitsOptions::most_digits);
  c.add_units();
  c.add("--cells", o.cells, OrbitsOptions::most_cells);
  c.add("--time", o.time, positive);
  c.add_jobs();
  c.add("--all", o.all);
  c.add("--neighbourhood", o.neighbourhood);
  c.add("--json", o.json);
  c.add("--plot", o.plot);
  c.add("--out", o.out);
  c.add("--certify", o.certify);
}

void define(Command<BranchOptions>& c, BranchOptions& o) {
  c.add("FAMILY", o.family);
  c.add_parameters();
  c.add_sources();
  c.add("--along", o.along)->allow_extra_args(false);
  c.add_units();
  c.add("--at", o.at, exact_number);
  c.add("--period", o.period, OrbitsOptions::most_periods_of_word);
  CLI::Option * orbit = c.add("--orbit", o.orbit, OrbitsOptions::most_orbits);
  CLI::Option * near = c.add("--near", o.near, state);
  c.add("--all", o.all)->excludes(orbit)->excludes(near);
  orbit->excludes(near);
  c.add("--basin", o.basin);
  c.add("--without-gaps", o.without_gaps);
  c.add("--parts", o.parts, BranchOptions::most_parts);
  c.add("--csv", o.csv);
  c.add("--plot", o.plot);
  c.add("--out", o.out);
  c.add_jobs();
  c.add("--json", o.json);
}

void define(Command<AttractorsOptions>& c, AttractorsOptions& o) {
  using Attracted = AttractorsOptions;
  c.add_machine();
  c.add_sources();
  c.add("--starts", o.starts, Attracted::most_starts);
  c.add("--seed", o.seed, Attracted::greatest_number);
  c.add("--most-periods", o.most_periods, Attracted::greatest_number);
  c.add("--along", o.along)->allow_extra_args(false);
  c.add("--values", o.values, Attracted::most_values);
  c.add("--plane", o.plane);
  c.add("--pixels", o.pixels, Attracted::most_pixels);
  c.add("--through", o.through, state);
  c.add("--window", o.window, state);
  c.add("--neighbourhood", o.neighbourhood);
  c.add("--csv", o.csv);
  c.add("--plot", o.plot);
  c.add("--out", o.out);
  c.add("--digits", o.digits, OrbitsOptions::most_digits);
  c.add_units();
  c.add_jobs();
  c.add("--json", o.json);
}

void define(Command<AtlasOptions>& c, AtlasOptions& o) {
  c.add("FAMILY", o.family);
  c.add_parameters();
  c.add_sources();
  c.add("--along", o.along)->allow_extra_args(false);
  c.add_units();
  c.add("--resolution", o.resolution, AtlasOptions::most_resolution);
  c.add("--out", o.out);
  c.add("--resume", o.resume);
  c.add("--time-limit", o.time_limit, positive);
  c.add("--csv", o.csv);
  c.add("--plot", o.plot);
  c.add_jobs();
  c.add("--verify", o.verify);
  c.add("--sample", o.sample, std::numeric_limits<int>::max());
  c.add("--json", o.json);
}

void define(Command<SimulateOptions>& c, SimulateOptions& o) {
  c.add_parameters();
  c.add_sources();
  CLI::Option * orbit = c.add("--orbit", o.orbit);
  c.add("--state", o.state, state)->excludes(orbit);
  c.add("--perturb", o.perturb, state);
  c.add("--set", o.set, state);
  c.add("--periods", o.periods, positive);
  c.add("--time", o.duration, positive);
  c.add("--every", o.every, positive);
  c.add("--csv", o.csv);
  c.add("--plot", o.plot);
  c.add_units();
  c.add("--json", o.json);
}

template <class Options>
void add(CLI::App& program, Request& request, const Wording& wording, const char * name) {
  Command<Options> command(program, request, wording, name);
  define(command, command.options);
}

// A statement that begins with a minus sign is no option: it is typed for the parser's other minus sign.
std::string as_statement(const std::string& word) {
  const bool is_option =
      !word.starts_with('-') || word.starts_with("--") || word.find_first_of("=<>!") == std::string::npos;
  return is_option ? word : "\u2212" + word.substr(1);
}

}  // namespace

Request parse(int argc, const char * const * argv, const PaperInHelp& paper) {
  Request request;
  CLI::App program(paper.about, "stickslip");
  const CommandHelp help = help_of("stickslip");
  program.footer(help.details);
  program.set_version_flag(
      "--version", [] { return std::string(); }, help.entries.at("--version").words);
  std::string directory_of_manual;
  program.add_option("--manual", directory_of_manual)->group("");
  program.require_subcommand(0, 1);
  program.get_formatter()->column_width(16);
  const Wording wording = wording_of(paper);
  std::vector<std::string> words(argv + 1, argv + argc);
  using Add = void (*)(CLI::App&, Request&, const Wording&, const char *);
  const std::array<std::pair<const char *, Add>, 10> commands{{{"audit", add<AuditOptions>},
                                                               {"check", add<CheckOptions>},
                                                               {"prove", add<ProveOptions>},
                                                               {"certify", add<CertifyOptions>},
                                                               {"latex", add<LatexOptions>},
                                                               {"orbits", add<OrbitsOptions>},
                                                               {"branch", add<BranchOptions>},
                                                               {"attractors", add<AttractorsOptions>},
                                                               {"atlas", add<AtlasOptions>},
                                                               {"simulate", add<SimulateOptions>}}};
  const auto is_meant = [&](const char * name) { return !words.empty() && words.front() == name; };
  const bool one_is_meant =
      std::ranges::any_of(commands, is_meant, [](const auto& one) { return one.first; });
  for (const auto& [name, add] : commands) {
    if (one_is_meant && !is_meant(name)) {
      program.add_subcommand(name, help_of(name).words);
    } else {
      add(program, request, wording, name);
    }
  }
  program.allow_extras();
  if (is_meant("prove")) {
    std::ranges::transform(words, words.begin(), as_statement);
  }
  std::ranges::reverse(words);  // as CLI11 takes them
  try {
    program.parse(words);
  } catch (const CLI::CallForVersion&) {
    return VersionsWanted{};
  } catch (const CLI::Success&) {
    return HelpWanted{program.help()};
  } catch (const CLI::ParseError& error) {
    throw not_understood(program, error);
  }
  if (!directory_of_manual.empty()) {
    return ManualWanted{directory_of_manual, manual(program, paper.completions())};
  }
  require_command(program);
  return request;
}

}  // namespace stickslip::cli
