// The module stickslip._core: what python/stickslip builds its classes on. Results come as the JSON that the
// program prints (report/schema/), samples as arrays.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/attractors/word_search.hpp"
#include "numeric/simulation/record.hpp"
#include "proofs/methods/progress.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "report/atlas/archive.hpp"
#include "report/atlas/summary.hpp"
#include "report/audit/json.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/branches.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/orbits_plot.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/versions.hpp"
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

// The work without Python's lock, one at a time: a wish to end it is the whole process's, and GiNaC's objects
// are for one thread. After Ctrl-C, KeyboardInterrupt.
template <class Work>
auto carried_out(const Conduct& conduct, const Work& work) {
  static std::mutex one_at_a_time;
  bool stopped = false;
  auto result = [&] {
    const py::gil_scoped_release released;
    const std::lock_guard<std::mutex> alone(one_at_a_time);
    const std::optional<Jobs> limit =
        conduct.jobs ? std::optional<Jobs>(std::in_place, *conduct.jobs) : std::nullopt;
    std::optional<Interruptible> scope;
    if (conduct.in_main_thread) {
      scope.emplace();
    }
    auto done = work();
    stopped = interrupted();
    return done;
  }();
  if (stopped) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
  return result;
}

// The paper is looked at only where its examples are asked for.
const Paper& paper_for(const std::string& example) {
  static const Paper none{};
  return example.empty() ? none : proofs::pascal2012::paper();
}

OrbitList orbits(const std::string& family, const TypedParameters& parameters, const std::string& example,
                 int digits, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    return list_orbits(
        cli::question(paper_for(example), family_named(family), parameters, {}, example, digits));
  });
}

// Of a list all but its orbits.
std::string without_orbits(const OrbitList& list) {
  return report::orbits::to_json(
             OrbitList{list.question, {}, list.unresolved, list.remarks, list.cells, list.open_at_middle})
      .dump();
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
std::tuple<py::dict, py::dict, py::list> orbit(const OrbitList& list, std::size_t number) {
  const Orbit& o = list.orbits.at(number);
  const auto kept = [&](const Ball& ball) { return Enclosure{ball, list.question.digits}; };
  py::dict decided;
  py::dict values;
  py::list multipliers;
  const Truth admissible = o.admissible.truth;
  decided["admissible"] = admissible == Truth::proved || admissible == Truth::refuted
                              ? std::optional(admissible == Truth::proved)
                              : std::nullopt;
  if (!o.split.empty()) {
    decided["split"] = o.split;
  }
  for (const NamedBall& value : o.values) {
    values[value.name.c_str()] = kept(value.value);
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

std::string conditions(const OrbitList& list, std::size_t number) {
  report::tools::Json json = report::tools::Json::array();
  for (const motion::Condition& condition : list.orbits.at(number).conditions) {
    json.push_back(report::orbits::to_json(condition));
  }
  return json.dump();
}

branches::BranchList word_branch(const std::string& word, int periods, const TypedParameters& parameters,
                                 const std::string& example, const std::string& at, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    return list_branches(cli::word_branch_question(paper_for(example), words::Word::parse(word), periods,
                                                   parameters, {}, example, at));
  });
}

branches::BranchList branch(const std::string& family, const TypedParameters& parameters,
                            const std::string& example, const std::string& at, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    return list_branches(
        cli::branch_question(paper_for(example), family_named(family), parameters, {}, example, at));
  });
}

attractors::WordOrbits word_orbits(const std::string& word, long periods,
                                   const std::optional<std::string>& near, const TypedParameters& parameters,
                                   const std::string& example, int digits, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    attractors::WordSearch search{cli::machine(paper_for(example), parameters, {}, example, digits),
                                  words::Word::parse(word),
                                  periods,
                                  {}};
    if (near) {
      search.near = cli::four_numbers("near", *near);
    }
    return attractors::find_word_orbits(search);
  });
}

std::string find_attractors(const TypedParameters& parameters, const std::string& example, long starts,
                            std::uint64_t seed, long most_periods, int digits, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    const attractors::AttractorQuestion question{
        cli::machine(paper_for(example), parameters, {}, example, digits), starts, seed, most_periods};
    return report::orbits::to_json(attractors::find_attractors(question)).dump();
  });
}

using Row = std::array<double, 8>;  // t, x1, x2, x1', x2', r, u, energy

struct Followed {
  std::string json;
  std::vector<Row> rows;
  std::vector<int> phases;
};

Followed simulate(const TypedParameters& parameters, const std::string& state, const std::string& periods,
                  const std::string& every, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    const auto number = [&](const char * name) { return cli::number(name, parameters.at(name)); };
    const simulation::Start start{
        {number("chi"), number("eta"), number("us"), number("V"), number("omega"), number("p")},
        number("ur"),
        number("phi"),
        cli::four_numbers("state", state)};
    const double period = 2 * std::acos(-1.0) / start.data.omega;
    report::orbits::Simulated simulated;
    simulated.periods = cli::positive("periods", periods);
    simulated.every =
        every.empty() ? period / cli::SimulateOptions::samples_in_period : cli::positive("every", every);
    Followed followed;
    simulated.record = simulation::record_motion(
        start, {simulated.periods * period, simulated.every}, [](double) { return !interrupted(); },
        [&](const simulation::Sample& s) {
          followed.rows.push_back({s.time, s.X(0), s.X(1), s.X(2), s.X(3), s.r, s.u, s.energy});
          followed.phases.push_back(static_cast<int>(s.phase));
        });
    followed.json = report::orbits::to_json(simulated).dump();
    return followed;
  });
}

std::tuple<std::string, py::array_t<double>, py::array_t<int>> simulated(const TypedParameters& parameters,
                                                                         const std::string& state,
                                                                         const std::string& periods,
                                                                         const std::string& every,
                                                                         const Conduct& conduct) {
  const Followed followed = simulate(parameters, state, periods, every, conduct);
  const auto count = static_cast<py::ssize_t>(followed.rows.size());
  py::array_t<double> rows({count, static_cast<py::ssize_t>(std::tuple_size_v<Row>)});
  for (py::ssize_t i = 0; i < count; ++i) {
    std::ranges::copy(followed.rows[static_cast<std::size_t>(i)], rows.mutable_data(i, 0));
  }
  return {followed.json, std::move(rows), py::array_t<int>(count, followed.phases.data())};
}

std::string check(const std::vector<std::string>& words, const Conduct& conduct) {
  return carried_out(conduct, [&] {
    const Paper& paper = proofs::pascal2012::paper();
    std::set<std::string> ids;
    for (const std::string& word : words) {
      ids.merge(proofs::methods::ids_named(paper.claims, word));
    }
    const proofs::methods::Audit audit =
        proofs::methods::audit(paper.claims, ids, [](const std::string&, std::size_t, std::size_t) {});
    return report::audit::to_json(paper, audit, "stickslip.check").dump();
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

std::vector<std::tuple<std::string, std::string, std::string>> expressions() {
  std::vector<std::tuple<std::string, std::string, std::string>> result;
  for (const symbolic::objects::Object& object : symbolic::objects::objects()) {
    result.emplace_back(object.name, object.number, object.title);
  }
  return result;
}

using report::atlas::Archive;

Archive read_atlas(const std::string& file, const Conduct& conduct) {
  return carried_out(conduct, [&] { return report::atlas::read_archive(file); });
}

// The exact parameters of a box of the atlas: name, least and greatest value.
std::vector<std::tuple<std::string, std::string, std::string>> box(const Archive& a, std::size_t number) {
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
py::dict columns(const Archive& a) {
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
template <class List>
std::string script(const List& list) {
  return report::orbits::plot_script(list, report::tools::PlotFormat::svg);
}
std::string script_of(const Archive& a) {
  return report::atlas::plot_script(a.question, a.leaves, report::tools::PlotFormat::svg);
}

std::string gnuplot(const std::string& script) {
  const py::gil_scoped_release released;
  return report::tools::gnuplot(script);
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

  py::class_<Conduct>(m, "Conduct")
      .def(py::init<std::optional<std::size_t>, bool>(), py::arg("jobs"), py::arg("in_main_thread"));
  py::class_<Enclosure>(m, "Ball").def("decimals", &decimals);
  py::class_<numeric::OrbitList>(m, "OrbitList")
      .def("json", [](const numeric::OrbitList& list) { return report::orbits::to_json(list).dump(); })
      .def("without_orbits", &without_orbits)
      .def("__len__", [](const numeric::OrbitList& list) { return list.orbits.size(); })
      .def("orbit", &orbit, py::arg("number"))
      .def("conditions", &conditions, py::arg("number"))
      .def("script", &script<numeric::OrbitList>);
  py::class_<numeric::attractors::WordOrbits>(m, "WordOrbits")
      .def("json",
           [](const numeric::attractors::WordOrbits& list) { return report::orbits::to_json(list).dump(); });
  py::class_<numeric::branches::BranchList>(m, "BranchList")
      .def("json",
           [](const numeric::branches::BranchList& list) { return report::orbits::to_json(list).dump(); })
      .def("script", &script<numeric::branches::BranchList>);
  py::class_<Archive>(m, "Archive")
      .def("json", [](const Archive& a) { return report::atlas::to_json(a.question, a.leaves).dump(); })
      .def("script", &script_of)
      .def("columns", &columns)
      .def("box", &box, py::arg("number"));
  m.def("orbits", &orbits, py::arg("family"), py::arg("parameters"), py::arg("example"), py::arg("digits"),
        py::arg("conduct"));
  m.def("branch", &branch, py::arg("family"), py::arg("parameters"), py::arg("example"), py::arg("at"),
        py::arg("conduct"));
  m.def("word_branch", &word_branch, py::arg("word"), py::arg("periods"), py::arg("parameters"),
        py::arg("example"), py::arg("at"), py::arg("conduct"));
  m.def("atlas", &read_atlas, py::arg("file"), py::arg("conduct"));
  m.def("word_orbits", &word_orbits, py::arg("word"), py::arg("periods"), py::arg("near"),
        py::arg("parameters"), py::arg("example"), py::arg("digits"), py::arg("conduct"));
  m.def("attractors", &find_attractors, py::arg("parameters"), py::arg("example"), py::arg("starts"),
        py::arg("seed"), py::arg("most_periods"), py::arg("digits"), py::arg("conduct"));
  m.def("simulate", &simulated, py::arg("parameters"), py::arg("state"), py::arg("periods"), py::arg("every"),
        py::arg("conduct"));
  m.def("check", &check, py::arg("words"), py::arg("conduct"));
  m.def("latex", &latex, py::arg("name"), py::arg("in_frequencies"), py::arg("conduct"));
  m.def("gnuplot", &gnuplot, py::arg("script"));
  m.def("expressions", &expressions);
  m.def("version", [] { return report::tools::program_version(); });
}
