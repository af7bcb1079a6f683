#include "core/decimal.hpp"
#include "numeric/words/word.hpp"
#include "report/machines/results.hpp"
#include "report/machines/rows.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/record_json.hpp"

namespace stickslip::report::machines {

using namespace numeric;
using namespace numeric::machines;
using namespace tools;
using orbits::ball_text;

namespace {

// ---- parts

const char * const state_words = "x1, …, xn, x1', …, xn' of the n masses.";

std::vector<std::vector<Rational>> rows_of(const model::MatrixX<Rational>& A) {
  std::vector<std::vector<Rational>> rows;
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    rows.emplace_back(A.row(i).begin(), A.row(i).end());
  }
  return rows;
}

std::vector<BallText> ball_texts(const Vector& x, int digits) {
  std::vector<BallText> texts;
  for (const Ball& one : x) {
    texts.push_back(ball_text(one, digits));
  }
  return texts;
}

void write_law(Object& json, const model::FrictionLaw<Rational>& law) {
  json.has("at_rest", law.at_rest);
  json.list(
      "sliding", law.sliding,
      [](Object& to, const model::SlidingPiece<Rational>& piece) {
        to.has("from", piece.from);
        to.has("force", piece.force);
        to.has("slope", piece.slope);
      },
      "Pieces of the law, force + slope (v - from) for relative velocities v from there on; beside a smooth "
      "law those that motions are simulated on.");
  json.object_if(
      "smooth", law.smooth,
      [](Object& to, const model::SmoothFriction<Rational>& f) {
        to.has("falls", std::string(f.fall == model::Fall::exponential ? "exponentially" : "hyperbolically"),
               one_of({"exponentially", "hyperbolically"}));
        to.has("from", f.first);
        to.has("to", f.last);
        to.has("over", f.scale);
        to.has("viscous", f.viscous);
      },
      "The law, where it is a smooth one: to + (from - to) s(v/over) + viscous v, s(y) = exp(-y) or 1/(1 + "
      "y). What is proved is proved of it.");
}

void write_machine(Object& json, const Machine& machine, const Origin& origin) {
  const model::FrictionOscillator<Rational>& o = machine.oscillator;
  json.object("machine", [&](Object& to) {
    to.has("units", std::string(origin.in_SI ? "SI" : "none"), one_of({"SI", "none"}));
    to.has("masses", o.masses);
    to.has("stiffness", rows_of(o.stiffness), "K, by rows.");
    to.has("damping", rows_of(o.damping), "C, by rows.");
    to.object("belt", [&](Object& belt) {
      belt.has("mass", o.rubbing + 1, "The one on it, from 1.");
      belt.has("velocity", o.V);
    });
    to.object(
        "friction", [&](Object& law) { write_law(law, o.forward); }, "Where the belt is the faster one.");
    to.object(
        "friction_overshoot", [&](Object& law) { write_law(law, o.backward); },
        "Where the mass is the faster one.");
    to.list(
        "loads", o.loads,
        [](Object& one, const model::HarmonicForce<Rational>& load) {
          one.has("mass", load.mass + 1, "From 1.");
          one.has("multiple", load.k, with({{"minimum", 0}}, "Of the frequency; 0: a constant force."));
          one.has("cosine", load.cosine);
          one.has("sine", load.sine);
        },
        "Forces cosine cos(multiple theta) + sine sin(multiple theta).");
    const bool varies = !o.is_autonomous();
    to.has("frequency", varies && machine.in_turns ? std::optional(o.omega) : std::nullopt,
           "Of theta, in turns per time.");
    to.has("angular_frequency", varies && !machine.in_turns ? std::optional(o.omega) : std::nullopt,
           "Of theta, in radians per time.");
  });
}

// The verdict on that it exists, and what `write` has of it where that is proved.
template <class T, class Write>
void write_if_proved(Object& json, const Verdict& verdict, const char * on, const T& it, const Write& write) {
  json.has("verdict", verdict.truth, on);
  json.has("reason", orbits::if_any(verdict.reason));
  json.keys_if(verdict.truth == Truth::proved ? std::optional(it) : std::nullopt, write);
}

void write_orbit(Object& json, const MachineOrbit& o, int digits) {
  json.has("word", word_of(o.pieces), orbits::like_word());
  json.has("pieces", word_of(o.pieces, true),
           "Phases with the pieces of the friction law that they are on: S2 a slip on the second.");
  json.has("periods", o.periods, with({{"minimum", 1}}, "Of the load; 1 without one."));
  const auto write = [digits](Object& to, const MachineOrbit& proved) {
    to.has("period", ball_text(proved.period, digits), "A time.");
    to.has("theta", ball_text(proved.load, digits), "The load's phase when the first phase begins.");
    to.list("phases", proved.phases, [digits](Object& one, const MachinePhase& phase) {
      one.has("phase", phase.piece.kind, orbits::phase_names());
      one.has("piece", phase.piece.number + 1, with({{"minimum", 1}}, "Of the friction law; 1 for a stick."));
      one.has("begins", ball_text(phase.start, digits));
      one.has("lasts", ball_text(phase.duration, digits));
      one.has("state", ball_texts(phase.state, digits), state_words);
    });
    orbits::write_admissible(to, proved.admissible);
    orbits::write_stability(to, proved.stability, proved.conditions, digits);
    to.list("conditions", proved.conditions, orbits::write_condition);
    orbits::write_neighbourhood(to, proved.neighbourhood);
  };
  write_if_proved(json, o.existence, "On: exactly one such motion closes near here.", o, write);
}

void write_steady(Object& json, const SteadySliding& state, int digits) {
  write_if_proved(json, state.existence, "On: there is exactly one motion of the kind.", state,
                  [digits](Object& to, const SteadySliding& known) {
                    to.has("phase", known.piece.kind, orbits::phase_names());
                    to.has("piece", known.piece.number + 1, with({{"minimum", 1}}, "Of the friction law."));
                    to.has("x", ball_texts(known.x, digits), "x1, …, xn.");
                    to.has("friction", ball_text(known.friction, digits));
                    to.has("stability", known.stability, names_through(motion::StabilityKind::undecided));
                    to.has("stability_reason", orbits::if_any(known.reason));
                    to.list(
                        "eigenvalues", known.eigenvalues,
                        [digits](Object& one, const motion::ComplexBall& mu) {
                          one.has("re", ball_text(mu.re, digits));
                          one.has("im", ball_text(mu.im, digits));
                        },
                        "Per time.");
                  });
}

void write_rectangle(Object& json, const Rectangle& starts) {
  json.object("starts", [&](Object& to) {
    to.has("x", std::vector{starts.x_from, starts.x_to}, "From, to.");
    to.has("velocity", std::vector{starts.y_from, starts.y_to}, "From, to.");
  });
}

void write_basin(Object& json, const PlanarBasin& basin, int digits) {
  write_if_proved(
      json, basin.verdict,
      "On: steady sliding is stable, and what ends in it starts inside one closed motion below the belt.",
      basin, [digits](Object& to, const PlanarBasin& known) {
        to.has("share", ball_text(known.share, digits), "Of the starts: those inside.");
        to.has("others", known.others.truth, "On: what starts outside ends on one cycle that sticks.");
        to.has("others_reason", orbits::if_any(known.others.reason));
        to.has("x", ball_text(known.x, digits), "Of the closed motion, farthest behind.");
        to.has("period", ball_text(known.period, digits), "A time.");
        to.has("multiplier", ball_text(known.multiplier, digits));
        to.has("area", ball_text(known.area, digits), "Inside the closed motion.");
      });
}

// ---- results

void write_attractor(Object& json, const MachineAttractor& a, int digits) {
  json.has("kind", a.kind, names_through(attractors::Kind::unsettled));
  orbits::write_share(json, a);
  json.has("state", a.state, state_words);
  orbits::write_lyapunov(json, a);
  json.object_if(
      "orbit", a.orbit, [&](Object& one, const MachineOrbit& orbit) { write_orbit(one, orbit, digits); },
      "Of a periodic motion: what is proved.");
}

void write_most_periods(Object& json, const MachineStarts& q) {
  json.has("most_periods", q.most_periods,
           with({{"minimum", 1}}, "That a start is followed for; without a load, events."));
}

void write_starts(Object& json, const MachineStarts& q) {
  json.has("starts", q.starts, {{"minimum", 1}});
  json.has("seed", q.seed);
  write_most_periods(json, q);
}

void write(Object& json, const Attractors& result) {
  const MachineStarts& q = result.question;
  write_starts(json, q);
  json.has("interrupted", result.interrupted);
  json.has("followed", result.followed,
           with({{"minimum", 0}},
                "Starts that were followed, all unless it was interrupted. Shares are of these."));
  json.list("attractors", result.attractors,
            [&](Object& to, const MachineAttractor& a) { write_attractor(to, a, q.digits); });
  json.object_if(
      "steady_sliding", result.steady,
      [&](Object& to, const SteadySliding& state) { write_steady(to, state, q.digits); },
      "Without a load that varies.");
}

void write(Object& json, const Diagram& result) {
  const int digits = result.question.digits;
  json.has("along", result.parameter, "The path of a number in the file.");
  json.has("from", result.from);
  json.has("to", result.to);
  write_starts(json, result.question);
  json.has("interrupted", result.interrupted, "Fewer points than were asked for.");
  orbits::write_points(
      json, result.points,
      "States when the load's phase is 0, one period apart; without a load where a phase begins.",
      [digits](Object& one, const MachineAttractor& a, const auto&) { write_attractor(one, a, digits); });
}

void write(Object& json, const Basins& b) {
  json.has("plane", plane_of(b), "Two of x1, …, xn, x1', …, xn'.");
  orbits::write_pixels(json, b.pixels, b.starts);
  write_most_periods(json, b.question);
  json.has("interrupted", b.interrupted, "Fewer starts than were asked for.");
  json.list("attractors", b.attractors,
            [&](Object& to, const MachineAttractor& a) { write_attractor(to, a, b.question.digits); });
  orbits::write_ends(json, b.ends, b.pixels[0]);
  json.has("proved", b.prove ? std::optional(proved_share(b)) : std::nullopt,
           with({{"minimum", 0}, {"maximum", 1}},
                "The share of pixels all of whose starts are proved to converge to the orbit."));
  json.has("proved_at",
           b.prove ? std::optional(orbits::rows_of_pixels({b.proved.begin(), b.proved.end()}, b.pixels[0], 0))
                   : std::nullopt,
           "Rows of pixels: 1 where that is proved.");
}

void write_word(Object& json, const MachineWord& q) {
  json.has("word", q.word.letters(), orbits::like_word());
  json.has("periods", q.periods, with({{"minimum", 1}}, "Of the load, if they were given."));
}

// Of a search for the orbits of a word.
void write_seen(Object& json, const std::string& seen, bool interrupted) {
  json.has("seen", orbits::if_any(seen), "What was met in place of an orbit of the word.");
  json.has("interrupted", interrupted);
}

void write(Object& json, const WordOrbits& result) {
  write_word(json, result.question);
  json.list("orbits", result.orbits,
            [&](Object& to, const MachineOrbit& orbit) { write_orbit(to, orbit, result.question.digits); });
  write_seen(json, result.seen, result.interrupted);
}

void write_varied(Object& json, const Varied& varied) {
  json.has("parameter", varied.path, "The path of a number in the file.");
  json.has("from", varied.from);
  json.has("to", varied.to);
}

void write_end(Object& json, const MachineBranchEnd& end) {
  json.has("at", end.at);
  json.has("kind", end.kind, names_through(branches::End::stopped));
  json.has("words", end.words);
}

void write_branch(Object& json, const MachineBranch& branch, int digits) {
  json.object("first", [&](Object& to) { write_end(to, branch.first); });
  json.object("last", [&](Object& to) { write_end(to, branch.last); });
  json.list("changes", branch.changes, [](Object& to, const MachineChange& change) {
    to.has("kind", change.kind, names_through(branches::ChangeKind::resonance));
    to.has("from", change.first);
    to.has("to", change.last);
    to.has("words", change.words);
  });
  json.list(
      "samples", branch.samples,
      [digits](Object& to, const MachineSample& sample) {
        to.has("value", sample.value);
        to.has("state", sample.state, names_through(branches::State::undecided));
        to.object("orbit", [&](Object& one) { write_orbit(one, sample.orbit, digits); });
      },
      "By rising values; each is proved on its own.");
  json.list(
      "joints", branch.joints,
      [](Object& to, const Joint& joint) {
        to.has("existence", joint.existence.truth,
               "On: at each value between there is exactly one such motion near, on one curve.");
        to.has("state", joint.state.truth, "On: and each of them is in the state of both.");
        const bool exists = joint.existence.truth == Truth::proved;
        to.has("reason", orbits::if_any(exists ? joint.state.reason : joint.existence.reason),
               "Why one of the two is undecided.");
      },
      "Of each sample and the next, where --without-gaps asks for them.");
}

void write(Object& json, const Branches& result) {
  write_word(json, result.question);
  write_varied(json, result.varied);
  json.has("at", result.varied.start, "Where the orbits are looked for whose branches are followed.");
  json.list("branches", result.branches, [&](Object& to, const MachineBranch& branch) {
    write_branch(to, branch, result.question.digits);
  });
  write_seen(json, result.seen, result.interrupted);
}

void write(Object& json, const OverBox& result) {
  write_word(json, result.question);
  json.list("data", result.data, [](Object& to, const Varied& varied) {
    to.has("path", varied.path, "Of a number in the file.");
    to.has("from", varied.from);
    to.has("to", varied.to);
    to.has("at", varied.start, "Where the motions are looked for.");
  });
  json.has("parts", result.most_parts, "How many are looked at at most, of each motion.");
  json.list("motions", result.motions, [&](Object& to, const OverBox::Family& family) {
    to.object("orbit", [&](Object& one) { write_orbit(one, family.at_start, result.question.digits); });
    to.list(
        "parts", family.parts,
        [](Object& one, const PartOfBox& part) {
          one.has("from", part.low, "Of each number, in the order of `data`.");
          one.has("to", part.high);
          one.has("existence", part.existence.truth,
                  "On: at all data there is exactly one such motion near, of the orbit's family.");
          one.has("state", part.motions.state, names_through(branches::State::undecided));
          one.has("names", orbits::if_any(part.motions.names),
                  "Conditions that all motions violate or, where the state is not decided, that are open.");
          one.has("reason", orbits::if_any(part.existence.reason), "Why their existence is undecided.");
        },
        "They make up the box.");
  });
  write_seen(json, result.seen, result.interrupted);
}

void write(Object& json, const SetMotion& set) {
  const SetAfterQuestion& q = set.question;
  json.has("state", q.middle, "The middle of the starts: x1, …, xn, x1', …, xn' at time 0.");
  json.has("set", q.half, "Their half widths.");
  json.has("theta", q.theta, "The load's phase at time 0.");
  json.has("time", q.time);
  json.has("proved", set.proved(), with({{"minimum", 0}}, "The share of the starts in `parts`."));
  json.list("open", std::vector<std::pair<std::string, double>>(set.open.begin(), set.open.end()),
            [](Object& to, const auto& open) {
              to.has("reason", open.first);
              to.has("share", open.second);
            });
  json.has("interrupted", set.interrupted);
  json.list("parts", set.parts, [&](Object& to, const SetAfter::Part& part) {
    to.has("state", part.middle);
    to.has("set", part.half);
    to.has("phases", part.phases(), "S slip, O overshoot, T stick, in their order, of all of its motions.");
    to.has("then", ball_texts(part.states, 17),
           "Contains x1, …, xn, x1', …, xn' of all of its motions at `time`.");
  });
}

void write(Object& json, const Steady& result) {
  const int digits = result.question.digits;
  json.object("steady_sliding", [&](Object& to) { write_steady(to, result.state, digits); });
  json.object_if(
      "basin", result.basin,
      [&](Object& to, const SteadyBasin& one) {
        write_rectangle(to, one.starts);
        write_basin(to, one.basin, digits);
      },
      "With --basin: the share of the starts that end in it.");
}

void write(Object& json, const SteadyBranch& result) {
  const int digits = result.question.digits;
  write_varied(json, result.varied);
  json.list(
      "samples", result.along.samples,
      [&](Object& to, const SteadyAlong::Sample& sample) {
        to.has("value", sample.value);
        to.object("steady_sliding", [&](Object& one) { write_steady(one, sample.state, digits); });
      },
      "By rising values.");
  json.list("changes", result.along.changes, [&](Object& to, const SteadyAlong::Change& change) {
    to.has("from", change.first);
    to.has("to", change.last);
    to.has("lost", change.is_lost, "The stability; else it is gained.");
    to.has("corner", change.is_corner, "Two pieces of the friction law meet there.");
    to.has("frequency", ball_text(change.frequency, digits), "Of the pair of eigenvalues that crosses.");
  });
  json.object_if(
      "basins", result.basins,
      [&](Object& to, const SteadyBasins& all) {
        write_rectangle(to, all.starts);
        to.list(
            "samples", all.along.samples,
            [&](Object& one, const PlanarBasinAlong::Sample& sample) {
              one.has("value", sample.value);
              one.object("basin", [&](Object& basin) { write_basin(basin, sample.basin, digits); });
            },
            "By rising values.");
        to.list("ends", all.along.ends, [](Object& one, const PlanarBasinAlong::End& end) {
          one.has("from", end.first);
          one.has("to", end.last);
          one.has("gained", end.is_gained, "The basin; else it is lost.");
          one.has("at_belt", end.at_belt,
                  "The closed motion touches the belt; else steady sliding loses its stability.");
        });
      },
      "With --basin: the share of the starts that end in it.");
}

void write(Object& json, const Motion& result) {
  const auto& record = result.record;
  json.has("start", result.question.start, state_words);
  json.has("theta", result.question.theta, "Of the load at the start.");
  json.has("duration", result.question.duration, with({{"exclusiveMinimum", 0}}, "That was asked for."));
  json.has("done", record.done);
  json.has("interrupted", record.interrupted);
  orbits::write_end(json, record, state_words);
  orbits::write_events(json, record, state_words);
}

// What schemas are made with.
Machine sample_machine() {
  Machine machine;
  model::FrictionOscillator<Rational>& o = machine.oscillator;
  o.masses = {1};
  o.damping = o.stiffness = model::MatrixX<Rational>::Constant(1, 1, Rational(1));
  o.rubbing = 0;
  o.forward = o.backward = {Rational(2), {{Rational(0), Rational(1), Rational(0)}}};
  o.loads = {{0, 1, Rational(1), Rational(0)}};
  o.omega = 1;
  return machine;
}

// All of them say what gives them again and what machine they are about.
constexpr auto writer = [](Object& json, const auto& result) {
  write_provenance(json, command_of(result));
  write_machine(json, result.question.machine, result.origin);
  write(json, result);
};

}  // namespace

template <class Result>
Json to_json(const Result& result) {
  return written(result, writer);
}
template Json to_json(const Attractors& result);
template Json to_json(const Diagram& result);
template Json to_json(const Basins& result);
template Json to_json(const WordOrbits& result);
template Json to_json(const Branches& result);
template Json to_json(const OverBox& result);
template Json to_json(const Steady& result);
template Json to_json(const SteadyBranch& result);
template Json to_json(const Motion& result);
template Json to_json(const SetMotion& result);

std::vector<File> schemas() {
  const Machine machine = sample_machine();
  const MachineWord word{machine, words::Word::parse("ST"), {}, {}};
  Attractors attractors;
  attractors.question.machine = machine;
  Diagram diagram;
  diagram.question.machine = machine;
  Basins basins;
  basins.question.machine = machine;
  basins.starts = {Eigen::VectorXd::Zero(2)};
  const WordOrbits of_word{{word, {}, {}}, {}};
  const Varied velocity{"belt.velocity", 0, 1, 0};
  const Branches branches{{word, {}}, velocity};
  const OverBox box{{word, {}}};
  SetMotion set;
  set.question = {machine, Eigen::VectorXd::Zero(2), Eigen::VectorXd::Ones(2), 0, 1};
  return {
      schema_file("machine_attractors",
                  "stickslip attractors of a machine in tables: what it does; with --along, with --plane",
                  one_of_schemas({schema_by(attractors, writer), schema_by(diagram, writer),
                                  schema_by(basins, writer)})),
      schema_file("machine_words", "stickslip orbits WORD of a machine in tables, each proved",
                  schema_by(of_word, writer)),
      schema_file("machine_branches",
                  "stickslip branch WORD of a machine in tables: orbits over one of its numbers, proved",
                  schema_by(branches, writer)),
      schema_file("machine_box",
                  "stickslip branch WORD of a machine in tables: orbits over a box of its numbers, proved",
                  schema_by(box, writer)),
      schema_file("machine_steady", "stickslip orbits S of a machine in tables: steady sliding, proved",
                  schema_by(Steady{{machine}, {}, {}}, writer)),
      schema_file("machine_steady_branch",
                  "stickslip branch S of a machine in tables: steady sliding over one of its numbers, proved",
                  schema_by(SteadyBranch{{machine}, velocity, {}, {}}, writer)),
      schema_file("machine_simulation", "stickslip simulate of a machine in tables: a motion, in double",
                  schema_by(Motion{{machine}, {}}, writer)),
      schema_file("machine_set",
                  "stickslip simulate --set of a machine in tables: where a box of starts is, proved",
                  schema_by(set, writer))};
}

}  // namespace stickslip::report::machines
