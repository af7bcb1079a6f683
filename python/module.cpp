// The module stickslip._core: what python/stickslip builds its classes on. Results come as the JSON that the
// program prints (its schemas: doc/formats.md), samples as arrays.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "cli/answers/asked.hpp"
#include "cli/answers/latex_text.hpp"
#include "cli/answers/machine_answers.hpp"
#include "cli/arguments/arguments.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/atlas/work.hpp"
#include "numeric/simulation/record.hpp"
#include "proofs/methods/automatic.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/text/claims_file.hpp"
#include "report/atlas/archive.hpp"
#include "report/atlas/summary.hpp"
#include "report/audit/json.hpp"
#include "report/orbits/attractors/attractors.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/branches/branches.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/pure_word.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#include "report/tools/numbers.hpp"
#include "symbolic/objects/objects.hpp"

namespace py = pybind11;

namespace stickslip::python {
namespace {

using namespace numeric;
using cli::TypedParameters;
using proofs::methods::Paper;

// How a call is carried out: on how many threads, and whether Ctrl-C ends it, as it does in Python's own
// thread.
struct Conduct {
  std::optional<std::size_t> jobs;
  bool in_main_thread;
};

// An error about a datum of (2) that was taken for a machine in SI units names the machine's value, too.
[[noreturn]] void throw_domain_error(const std::string& words) {
  const py::object type = py::module_::import("stickslip._core").attr("DomainError");
  PyErr_SetString(type.ptr(), words.c_str());
  throw py::error_already_set();
}

// The work without Python's lock, one at a time: a wish to end it is the whole process's, and GiNaC's objects
// are for one thread. After Ctrl-C, KeyboardInterrupt.
template <class Work>
auto carried_out(const Conduct& conduct, const Work& work, const cli::GivenFile& file = {}) {
  static std::mutex one_at_a_time;
  bool stopped = false;
  std::optional<std::string> outside;
  auto result = [&] {
    const py::gil_scoped_release released;
    const std::lock_guard<std::mutex> alone(one_at_a_time);
    const std::optional<Jobs> limit =
        conduct.jobs ? std::optional<Jobs>(std::in_place, *conduct.jobs) : std::nullopt;
    std::optional<Interruptible> scope;
    if (conduct.in_main_thread) {
      scope.emplace();
    }
    std::optional<decltype(work())> done;
    try {
      done.emplace(work());
    } catch (const DomainError& error) {
      outside = cli::in_keys_of(file, error).what();
    }
    stopped = interrupted();
    return done;
  }();
  if (outside) {
    throw_domain_error(*outside);
  }
  if (stopped) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
  return std::move(*result);
}

// A question as it is typed behind the program's name, "orbits", "OTS", "--ur=0.2", …, and the values of a
// machine in SI units that stands in no file.
struct Asking {
  std::vector<std::string> words;
  std::optional<TypedParameters> machine;
};

template <class Options>
Options options_of(const Asking& asking) {
  std::vector<const char *> argv{"stickslip"};
  for (const std::string& word : asking.words) {
    argv.push_back(word.c_str());
  }
  auto o = std::get<Options>(cli::parse(static_cast<int>(argv.size()), argv.data(), {}));
  o.file.values = asking.machine;
  return o;
}

// The values of a machine in SI units, as they stand in its file.
TypedParameters machine_values(const std::string& file) {
  return cli::contents_of(file);
}

// A result, and how it is told.
template <class Answer>
struct Told {
  Answer answer;
  cli::ParameterFile file;
  report::orbits::Units units;
};

template <class Question, class Find>
auto answered(const cli::Asked<Question>& asked, const Find& find) {
  return Told<decltype(find(asked.question))>{find(asked.question), asked.file, asked.units};
}

// As the program prints it: in the units of the data.
template <class Answer>
std::string json(const Told<Answer>& t) {
  return cli::with_machine(report::orbits::to_json(t.answer), t.file).dump();
}

// What is in the units, which it says if they are SI.
std::string in_these(report::tools::Json json, const report::orbits::Units& units) {
  if (units.are_SI()) {
    json["units"] = "si";
  }
  return json.dump();
}

// The same in the units in which it is told.
template <class Answer>
std::string fields(const Told<Answer>& t) {
  return in_these(report::orbits::to_json(t.answer, t.units), t.units);
}

// Sentences for what was not taken of a machine, and for what else was noticed.
template <class Answer>
std::vector<std::string> left_out(const Told<Answer>& t) {
  return t.file.left_out;
}

// What `find` answers to the question that `ask` reads from the options.
template <class Options, auto ask, auto find>
auto found(const Asking& asking, const Conduct& conduct) {
  const auto o = options_of<Options>(asking);
  return carried_out(
      conduct, [&] { return answered(ask(o, proofs::pascal2012::printed_examples()), find); }, o.file);
}

// Of a list all but its orbits.
std::string without_orbits(const Told<OrbitList>& t) {
  const OrbitList& list = t.answer;
  return in_these(report::orbits::to_json(OrbitList{
                      list.question, {}, list.unresolved, list.remarks, list.cells, list.open_at_middle}),
                  t.units);
}

// A ball of an orbit, of which decimals are made when they are asked for: as many as are worth it.
struct Enclosure {
  Ball ball;
  int digits;
};

std::pair<std::string, std::string> decimals(const Enclosure& e) {
  BallText text = to_text(e.ball, report::tools::known_digits(e.ball, e.digits));
  return {std::move(text.mid), std::move(text.rad)};
}

// What is decided of an orbit but its conditions; its values by their names; its multipliers.
std::tuple<py::dict, py::dict, py::list> orbit(const Told<OrbitList>& t, std::size_t number) {
  const OrbitList& list = t.answer;
  const Orbit& o = list.orbits.at(number);
  const auto kept = [&](const Ball& ball) { return Enclosure{ball, list.question.digits}; };
  py::dict decided;
  py::dict values;
  py::list multipliers;
  decided["admissible"] = o.admissible.is_decided() ? std::optional(is_admissible(o)) : std::nullopt;
  if (!o.split.empty()) {
    decided["split"] = o.split;
  }
  for (const NamedBall& value : o.values) {
    values[value.name.c_str()] = kept(t.units.value(value, list.question.digits));
  }
  if (o.stability) {
    decided["stability"] = to_string(o.stability->kind);
    decided["stability_reason"] = plain(o.stability->reason);
    for (const motion::ComplexBall& mu : o.stability->multipliers) {
      multipliers.append(py::make_tuple(kept(mu.re), kept(mu.im)));
    }
  }
  return {decided, values, multipliers};
}

std::string conditions(const Told<OrbitList>& t, std::size_t number) {
  report::tools::Json json = report::tools::Json::array();
  for (const motion::Condition& condition : t.answer.orbits.at(number).conditions) {
    json.push_back(report::orbits::to_json(condition));
  }
  return json.dump();
}

// Of the orbit that number has in the list; an object without keys where there is none.
std::string neighbourhood(const Told<OrbitList>& t, std::size_t number) {
  const auto write = [&](report::tools::Object& to, const Orbit& o) {
    report::orbits::write_neighbourhood(to, t.answer.question, o, t.units);
  };
  return report::tools::written(t.answer.orbits.at(number), write).dump();
}

using report::orbits::PureWord;

Told<PureWord> pure_word(const Asking& asking, const Conduct& conduct) {
  const auto o = options_of<cli::OrbitsOptions>(asking);
  const auto word_of = [&](const words::WordQuestion& machine) {
    return PureWord{machine, words::kind_of(o.family).value()};
  };
  return carried_out(
      conduct,
      [&] { return answered(cli::asked_pure_word(o, proofs::pascal2012::printed_examples()), word_of); },
      o.file);
}

std::string fields_of_pure_word(const Told<PureWord>& t) {
  const WorkingPrecision precision(report::orbits::Units::bits_for(t.answer.machine.digits));
  return in_these(report::orbits::to_json(t.answer, t.units), t.units);
}

// Of a machine whose values vary: those that stay. Else what the program's JSON says.
std::optional<TypedParameters> staying(const Told<attractors::Diagram>& t) {
  if (!t.answer.question.taken) {
    return std::nullopt;
  }
  TypedParameters values = t.file.in_SI;
  values.erase(t.answer.question.parameter);
  return values;
}

// The starts, row by row from below.
py::array_t<double> starts(const Told<attractors::Basins>& t) {
  const auto& pixels = t.answer.question.pixels;
  py::array_t<double> all({pixels[1], pixels[0], 4L});
  double * next = all.mutable_data();
  for (const model::Vector4<double>& X : t.answer.starts) {
    const model::Vector4<double> told = t.units.state(X);
    next = std::copy(told.begin(), told.end(), next);
  }
  return all;
}

using Row = std::array<double, 8>;  // t, x1, x2, x1', x2', r, u, energy

struct Followed : report::orbits::Simulated {
  std::vector<Row> rows;
  std::vector<int> phases;
};

Told<Followed> simulate(const Asking& asking, bool settle, const Conduct& conduct) {
  const auto o = options_of<cli::SimulateOptions>(asking);
  return carried_out(
      conduct,
      [&] {
        auto asked = cli::asked_motion(o, proofs::pascal2012::printed_examples());
        if (!asked.question.from.leaves.empty()) {
          asked.file.left_out.push_back(asked.question.from.leaves);
        }
        return answered(asked, [&](const cli::MotionAsked& motion) {
          Followed followed;
          followed.periods = motion.periods;
          followed.every = motion.every;
          followed.record = simulation::record_motion(
              motion.from.start, {motion.periods * motion.period(), motion.every},
              [](double) { return !interrupted(); },
              [&](const simulation::Sample& in_data) {
                const simulation::Sample s = asked.units.sample(in_data);
                followed.rows.push_back({s.time, s.X(0), s.X(1), s.X(2), s.X(3), s.r, s.u, s.energy});
                followed.phases.push_back(static_cast<int>(s.phase));
              });
          if (settle) {
            followed.settles = cli::settles_on(followed.record, motion.from.machine);
          }
          return followed;
        });
      },
      o.file);
}

std::tuple<py::array_t<double>, py::array_t<int>> samples(const Told<Followed>& t) {
  const Followed& followed = t.answer;
  const auto count = static_cast<py::ssize_t>(followed.rows.size());
  py::array_t<double> rows({count, static_cast<py::ssize_t>(std::tuple_size_v<Row>)});
  for (py::ssize_t i = 0; i < count; ++i) {
    std::ranges::copy(followed.rows[static_cast<std::size_t>(i)], rows.mutable_data(i, 0));
  }
  return {std::move(rows), py::array_t<int>(count, followed.phases.data())};
}

// The claims of a paper that the words name, as JSON.
std::string checked(const Paper& paper, const std::vector<std::string>& words, const char * command) {
  const proofs::symbols::InVocabulary scope(paper.vocabulary);
  std::set<std::string> ids;
  for (const std::string& word : words) {
    ids.merge(proofs::methods::ids_named(paper.claims, word));
  }
  const proofs::methods::Audit audit =
      proofs::methods::audit(paper.claims, ids, [](const std::string&, std::size_t, std::size_t) {});
  return report::audit::to_json({paper, audit}, command).dump();
}

std::string check(const std::vector<std::string>& words, const std::string& file, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    const Paper& paper = proofs::pascal2012::paper();
    return file.empty() ? checked(paper, words, "stickslip.check")
                        : checked(proofs::text::read_claims(report::tools::read_file(file), file, paper),
                                  words, "stickslip.check");
  });
}

std::string prove(const proofs::methods::OwnStatement& own, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    Paper with_own = proofs::pascal2012::paper();
    with_own.claims.push_back(proofs::methods::own_claim(own));
    return checked(with_own, {proofs::methods::own_id}, "stickslip.prove");
  });
}

std::string latex(const std::string& name, bool in_frequencies, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    const symbolic::objects::Object * object = symbolic::objects::find_object(name);
    if (object == nullptr) {
      throw UsageError("there is no derived expression '" + name + "': stickslip.expressions() names them");
    }
    return symbolic::objects::displayed(
        *object, in_frequencies ? symbolic::objects::Unknowns::omega : symbolic::objects::Unknowns::chi);
  });
}

// A theorem, an orbit or errata, and sentences for what was left out of the parameters.
std::pair<std::string, std::vector<std::string>> latex_text(const Asking& asking, const Conduct& conduct) {
  const auto o = options_of<cli::LatexOptions>(asking);
  const cli::LatexText made = carried_out(
      conduct,
      [&] {
        return cli::latex_text(o, proofs::pascal2012::paper(), [](const auto& claims, const auto& ids) {
          return proofs::methods::audit(claims, ids, [](const std::string&, std::size_t, std::size_t) {});
        });
      },
      o.file);
  return {made.text, made.left_out};
}

std::vector<std::tuple<std::string, std::string, std::string>> expressions() {
  std::vector<std::tuple<std::string, std::string, std::string>> result;
  for (const symbolic::objects::Object& object : symbolic::objects::objects()) {
    result.emplace_back(object.name, object.number, object.title);
  }
  return result;
}

using report::atlas::Archive;

// Read, or made, and what did not count for it.
struct Atlas {
  Archive archive;
  std::vector<std::string> left_out;
};

Atlas make_atlas(const Asking& asking, const Conduct& conduct) {
  using namespace numeric::atlas;
  const auto o = options_of<cli::AtlasOptions>(asking);
  return carried_out(
      conduct,
      [&] {
        const auto asked = cli::asked_atlas(o, proofs::pascal2012::printed_examples());
        Archive archive{asked.question, report::tools::program_version(), {}};
        work_on_all(
            asked.question, gaps({}), [] { return interrupted(); },
            [&archive](const std::vector<Leaf>& leaves) {
              archive.leaves.insert(archive.leaves.end(), leaves.begin(), leaves.end());
            });
        put_in_order(archive.question, archive.leaves);
        return Atlas{std::move(archive), asked.file.left_out};
      },
      o.file);
}

Atlas read_atlas(const std::string& file, const Conduct& conduct) {
  return carried_out(conduct, [&] { return Atlas{report::atlas::read_archive(file), {}}; });
}

// The exact parameters of a box of the atlas: name, least and greatest value.
std::vector<std::tuple<std::string, std::string, std::string>> box(const Atlas& made, std::size_t number) {
  const Archive& a = made.archive;
  const numeric::atlas::Box exact = numeric::atlas::box_of(a.question, a.leaves.at(number).tile);
  std::vector<std::tuple<std::string, std::string, std::string>> result;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    result.emplace_back(numeric::atlas::names_of(a.question)[i], to_string(exact[i].lower),
                        to_string(exact[i].upper));
  }
  return result;
}

// A row for each box: least and greatest values of the axes, in doubles; then orbits, admissible, stable, -1
// where unknown, and the reason's place in `reasons`.
py::dict columns(const Atlas& made) {
  const Archive& a = made.archive;
  const auto count = static_cast<py::ssize_t>(a.leaves.size());
  const auto& axes = a.question.axes;
  py::array_t<double> lower({count, static_cast<py::ssize_t>(axes.size())});
  py::array_t<double> upper({count, static_cast<py::ssize_t>(axes.size())});
  py::array_t<int> found({count, py::ssize_t{4}});
  for (py::ssize_t i = 0; i < count; ++i) {
    const numeric::atlas::Leaf& leaf = a.leaves[static_cast<std::size_t>(i)];
    const numeric::atlas::Box exact = numeric::atlas::box_of(a.question, leaf.tile);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      lower.mutable_at(i, k) = exact[axes[k]].lower.get_d();
      upper.mutable_at(i, k) = exact[axes[k]].upper.get_d();
    }
    const numeric::atlas::Finding& f = leaf.finding;
    std::ranges::copy(std::array<int, 4>{f.orbits, f.admissible, f.stable, f.reason},
                      found.mutable_data(i, 0));
  }
  return py::dict(py::arg("lower") = lower, py::arg("upper") = upper, py::arg("found") = found,
                  py::arg("reasons") = report::atlas::all_reasons(*a.question.family));
}

// For gnuplot; empty where there is nothing to draw.
template <class Answer>
std::string script(const Told<Answer>& t) {
  return report::orbits::plot_script(t.answer, report::tools::PlotFormat::svg, t.units);
}
std::string script_of_orbits(const Told<OrbitList>& t) {
  using namespace report;
  return orbits::plot_script(t.answer, tools::PlotFormat::svg, tools::PlotShape::wide, std::nullopt, t.units);
}
std::string script_of_branches(const Told<branches::BranchList>& t) {
  return report::orbits::plot_script(t.answer, report::tools::PlotFormat::svg);
}
std::string script_of(const Atlas& a) {
  return report::atlas::plot_script(a.archive.question, a.archive.leaves, report::tools::PlotFormat::svg);
}

// ---- machines in tables: as JSON

using cli::GivenInTables;

template <class Options>
GivenInTables in_tables(const Options& o) {
  auto given = cli::given_in_tables(o);
  if (!given) {
    throw UsageError(o.file.name + " is no machine in tables: it has no [[mass]]");
  }
  return *std::move(given);
}

template <class Options>
std::string told_in_tables(const Asking& asking, const Conduct& conduct) {
  const auto o = options_of<Options>(asking);
  return carried_out(conduct, [&] {
    const GivenInTables given = in_tables(o);
    using report::machines::to_json;
    if constexpr (std::is_same_v<Options, cli::AttractorsOptions>) {
      if (o.plane) {
        return to_json(cli::basins_answer(given, o)).dump();
      }
      if (!o.along.empty()) {
        return to_json(cli::diagram_answer(given, o)).dump();
      }
    } else if (cli::is_steady(o.family)) {
      return to_json(cli::steady_answer(given, o)).dump();
    } else if constexpr (std::is_same_v<Options, cli::BranchOptions>) {
      if (o.along.size() > 1) {
        return to_json(cli::box_answer(given, o)).dump();
      }
    }
    return to_json(cli::answer(given, o)).dump();
  });
}

// The paper's oscillator over a box of its data.
std::string branch_over_box(const Asking& asking, const Conduct& conduct) {
  const auto o = options_of<cli::BranchOptions>(asking);
  return carried_out(
      conduct,
      [&] {
        const auto [given, rest] = cli::box_in_tables(o, proofs::pascal2012::printed_examples());
        return report::machines::to_json(cli::box_answer(given, rest)).dump();
      },
      o.file);
}

std::tuple<std::string, py::array_t<double>> simulate_in_tables(const Asking& asking,
                                                                const Conduct& conduct) {
  const auto o = options_of<cli::SimulateOptions>(asking);
  std::vector<double> numbers;
  std::size_t rows = 0;
  const std::string told = carried_out(conduct, [&] {
    const auto motion = cli::answer(
        in_tables(o), o, [](double) { return !interrupted(); },
        [&](const cli::SampleOfMachine& s) {
          ++rows;
          numbers.push_back(s.time);
          numbers.insert(numbers.end(), s.X.begin(), s.X.end());
          numbers.insert(numbers.end(), {s.r, s.u, s.energy});
        });
    return report::machines::to_json(motion).dump();
  });
  py::array_t<double> samples({rows, rows == 0 ? 0 : numbers.size() / rows});
  std::copy(numbers.begin(), numbers.end(), samples.mutable_data());
  return {told, samples};
}

std::string gnuplot(const std::string& script) {
  const py::gil_scoped_release released;
  return report::tools::gnuplot(script);
}

// A result as a class of Python.
template <class Answer>
py::class_<Told<Answer>> told(py::module_& m, const char * name) {
  return py::class_<Told<Answer>>(m, name).def("json", &json<Answer>).def("left_out", &left_out<Answer>);
}

}  // namespace
}  // namespace stickslip::python

PYBIND11_MODULE(_core, m) {
  using namespace stickslip;
  using namespace stickslip::python;
  m.doc() = "What the classes of stickslip are built on; not for direct use.";
  const auto error = py::register_exception<Error>(m, "Error");
  const auto with = [&](PyObject * base) { return py::make_tuple(error, py::handle(base)); };
  py::register_exception<UsageError>(m, "UsageError", with(PyExc_ValueError));
  py::register_exception<DomainError>(m, "DomainError", with(PyExc_ValueError));
  py::register_exception<InputOutputError>(m, "InputOutputError", with(PyExc_OSError));
  py::register_exception<InternalError>(m, "InternalError", with(PyExc_RuntimeError));

  py::class_<Conduct>(m, "Conduct").def(py::init<std::optional<std::size_t>, bool>());
  py::class_<Enclosure>(m, "Ball").def("decimals", &decimals);
  py::class_<Asking>(m, "Asking")
      .def(py::init<std::vector<std::string>, std::optional<cli::TypedParameters>>());
  told<numeric::OrbitList>(m, "OrbitList")
      .def("without_orbits", &without_orbits)
      .def("__len__", [](const Told<numeric::OrbitList>& t) { return t.answer.orbits.size(); })
      .def("orbit", &orbit)
      .def("conditions", &conditions)
      .def("neighbourhood", &neighbourhood)
      .def("script", &script_of_orbits);
  told<numeric::attractors::WordOrbits>(m, "WordOrbits")
      .def("fields", &fields<numeric::attractors::WordOrbits>);
  told<PureWord>(m, "PureWord").def("fields", &fields_of_pure_word);
  told<numeric::branches::BranchList>(m, "BranchList").def("script", &script_of_branches);
  told<numeric::attractors::AttractorList>(m, "AttractorList")
      .def("fields", &fields<numeric::attractors::AttractorList>);
  told<numeric::attractors::Diagram>(m, "Diagram")
      .def("fields", &fields<numeric::attractors::Diagram>)
      .def("staying", &staying)
      .def("script", &script<numeric::attractors::Diagram>);
  told<numeric::attractors::Basins>(m, "Basins")
      .def("fields", &fields<numeric::attractors::Basins>)
      .def("starts", &starts)
      .def("script", &script<numeric::attractors::Basins>);
  told<Followed>(m, "Motion").def("fields", &fields<Followed>).def("samples", &samples);
  py::class_<Atlas>(m, "Archive")
      .def("json",
           [](const Atlas& a) { return report::atlas::to_json(a.archive.question, a.archive.leaves).dump(); })
      .def("left_out", [](const Atlas& a) { return a.left_out; })
      .def("script", &script_of)
      .def("columns", &columns)
      .def("box", &box);
  using cli::AttractorsOptions;
  m.def("orbits", &found<cli::OrbitsOptions, cli::asked_orbits, numeric::list_orbits>);
  m.def("word_orbits", &found<cli::OrbitsOptions, cli::asked_word, numeric::attractors::find_word_orbits>);
  m.def("pure_word", &pure_word);
  m.def("branch", &found<cli::BranchOptions, cli::asked_branch, numeric::branches::list_branches>);
  m.def("atlas", &read_atlas);
  m.def("make_atlas", &make_atlas);
  m.def("attractors", &found<AttractorsOptions, cli::asked_attractors, numeric::attractors::find_attractors>);
  m.def("diagram", &found<AttractorsOptions, cli::asked_diagram, numeric::attractors::diagram_of>);
  m.def("basins", &found<AttractorsOptions, cli::asked_basins, numeric::attractors::basins_of>);
  m.def("simulate", &simulate);
  m.def("machine_values", &machine_values);
  m.def("require_tables",
        [](const Asking& asking) { (void)in_tables(options_of<cli::OrbitsOptions>(asking)); });
  m.def("attractors_in_tables", &told_in_tables<AttractorsOptions>);
  m.def("orbits_in_tables", &told_in_tables<cli::OrbitsOptions>);
  m.def("branch_over_box", &branch_over_box);
  m.def("branch_in_tables", &told_in_tables<cli::BranchOptions>);
  m.def("simulate_in_tables", &simulate_in_tables);
  m.def("set_in_tables", [](const Asking& asking, const Conduct& conduct) {
    const auto o = options_of<cli::SimulateOptions>(asking);
    return carried_out(conduct,
                       [&] { return report::machines::to_json(cli::set_answer(in_tables(o), o)).dump(); });
  });
  m.def("check", &check);
  m.def("prove", [](const std::string& statement, const std::vector<std::string>& assumptions,
                    const std::vector<std::string>& symbols, const Conduct& conduct) {
    return prove({statement, assumptions, symbols, "symbols="}, conduct);
  });
  m.def("latex", &latex);
  m.def("latex_text", &latex_text);
  m.def("gnuplot", &gnuplot);
  m.def("expressions", &expressions);
  m.def("families", [] {
    std::vector<std::string> names;
    for (const numeric::Family * family : numeric::all_families()) {
      names.push_back(family->name);
    }
    return names;
  });
  m.def("version", [] { return report::tools::program_version(); });
}
