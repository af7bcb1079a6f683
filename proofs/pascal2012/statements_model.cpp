// What the title, the abstract and Sections 1 to 3 say, in our own words.
#include "proofs/pascal2012/statements.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

const char * const elsewhere = "about other works";

}  // namespace

std::vector<PrintedStatement> statements_of_model() {
  using enum Kind;
  return {
      {"S001",
       "title",
       words,
       "the periodic orbits found are limit cycles",
       {"7.cycles"},
       "they are isolated among the orbits of their families; of other periodic motions nothing is said",
       {"S.list", "O.list", "P.list", "S.stability", "O.stability", "P.stability"}},
      {"S002",
       "abstract",
       model,
       "two masses joined by linear springs; one of them touches a belt of constant velocity",
       {"2.newton"}},
      {"S003", "abstract", model, "mass and belt exchange dry friction of Coulomb's kind", {"4"}},
      {"S004", "abstract", model, "A harmonic force acts on that same mass", {"1", "2.newton"}},
      {"S005",
       "abstract",
       words,
       "there are several periodic orbits made of stick and slip phases",
       {"S.orbit", "O.orbit", "7.overshoot"}},
      {"S006",
       "abstract",
       theorem,
       "periodic orbits exist on which the mass overtakes the belt for a while; said to be proved",
       {"7.overshoot"}},
      {"S007", "abstract", words, "orbits without sticking exist when the belt is at rest", {"7.rest"}},
      {"S008",
       "abstract",
       theorem,
       "every such orbit has the symmetry in space and in time; said without exception",
       {"7.always"},
       "",
       {"33.even.orbits", "7.symmetric", "A5.symmetry"}},
      {"S009",
       "sec. 1",
       words,
       "under Coulomb's law the model is piecewise linear",
       {},
       "each phase is solved in closed form; that the equations are linear in each is used and not stated",
       {"5", "8", "10"}},
      {"S010",
       "sec. 1",
       words,
       "Literature: analytical results on existence and stability of stick-slip orbits are known, also for "
       "more degrees of freedom [5-7]",
       {},
       elsewhere},
      {"S011",
       "sec. 1",
       definition,
       "overshooting: the mass on the belt moves the same way as the belt, but faster",
       {"8", "7.overshoot"}},
      {"S012",
       "sec. 1",
       words,
       "Literature: overshooting was so far seen only with friction laws more complex than Coulomb's [9]",
       {},
       elsewhere},
      {"S013",
       "sec. 1",
       words,
       "Literature: [7] has periodic orbits with overshooting for the self-excited oscillator, found "
       "analytically",
       {},
       elsewhere},
      {"S014", "sec. 1", model, "here the same oscillator carries a harmonic load as well", {"2"}},
      {"S015",
       "sec. 1",
       words,
       "several periodic orbits of stick and slip phases are obtained (again)",
       {"S.orbit", "O.orbit", "7.overshoot"}},
      {"S016",
       "sec. 1",
       theorem,
       "that orbits with an overshooting part exist counts as proved (again)",
       {"7.overshoot"}},
      {"S017",
       "Fig. 1",
       figure,
       "the oscillator: wall, spring $k_1$, mass $m_1$, spring $k_2$, mass $m_2$ on the belt, with friction "
       "and load",
       {"2.newton"}},
      {"S018",
       "sec. 2",
       model,
       "masses $m_1$, $m_2$, springs $k_1$, $k_2$; the second mass lies on a belt of constant velocity $v_0$",
       {"2.newton"}},
      {"S019",
       "sec. 2",
       model,
       "friction acts between second mass and belt; the external force acts on the second mass too",
       {"2.newton"}},
      {"S020",
       "(1)",
       definition,
       "the external force is a cosine of time with constant amplitude, frequency and phase $phi$",
       {"1"},
       "",
       {"3.load"}},
      {"S021", "(2)", model, "equations of motion of both masses, without dimensions", {"2"}},
      {"S022",
       "after (2)",
       definition,
       "$x_1$ and $x_2$ measure how far each mass is displaced",
       {"2.newton", "3"}},
      {"S023",
       "(3)",
       definition,
       "dimensionless parameters $eta$, $chi$, $u$, $p$, time $t$, frequency scale $Omega$, load frequency "
       "$omega$; the prime is d/dt",
       {"3"},
       "",
       {"3.Omega", "3.rates", "3.load", "3.domain"}},
      {"S024",
       "(4)",
       model,
       "Coulomb's law: $u$ while slipping, while sticking, and when the friction needed for sticking exceeds "
       "$u_r$",
       {"4", "4.r"},
       "",
       {"4.defined", "4.unique"}},
      {"S025",
       "(4)",
       condition,
       "the slipping friction is positive and below the friction at rest",
       {},
       "a premise of the paper; that the examples obey it is checked",
       {"14.order", "S.if.us", "S.if.ur", "O.if.us", "O.if.ur", "P.if.us", "P.if.ur"}},
      {"S026", "(4)", definition, "$V$ is $v_0$ divided by $Omega$", {"4.V"}},
      {"S027",
       "after (4)",
       definition,
       "$u_r$ is called the friction force at rest, $u_s$ the slipping friction force",
       {},
       "a name; in (4) $u_r$ only bounds the friction at rest",
       {"4", "4.r"}},
      {"S028",
       "sec. 3",
       words,
       "the motion consists of phases in which the second mass slips or sticks",
       {},
       "that phases follow each other without end is not asked in general",
       {"4", "10.belt"}},
      {"S029", "sec. 3", words, "each kind of phase has a solution in closed form", {"5", "8", "10"}},
      {"S030",
       "(5)",
       step,
       "motion during slip below belt velocity: free part by $H$ from the initial state, plus forced "
       "response $F$",
       {"5", "5.F"}},
      {"S031",
       "(6)",
       definition,
       "state $Z$ from places $z$ shifted by $d_0$ and velocities; block form of $H$; components of $d_0$",
       {"6.H", "6.d0", "52.X"}},
      {"S032",
       "(7)",
       step,
       "components of the amplitude $Q$ of the forced response",
       {"7"},
       "",
       {"7.resonance"}},
      {"S033",
       "after (7)",
       words,
       "the blocks of $H$ and the natural frequencies are known in closed form",
       {"38", "39"}},
      {"S034", "(8)", step, "motion during overshooting: (5) with the term $2 L(t) d_0$ added", {"8", "8.L"}},
      {"S035", "(9)", model, "equations of motion during stick", {"9", "4.r"}},
      {"S036",
       "(10)",
       step,
       "motion during stick: $Gamma(t)$ applied to the initial state, in the shifted places",
       {"10", "10.Gamma", "9.z"}},
      {"S037",
       "(11)",
       condition,
       "as long as the mass sticks, the friction needed stays below $u_r$ in size",
       {"11"}},
  };
}

namespace {

// The section that begins with this statement.
std::optional<std::string> begins(const std::string& id) {
  static const std::map<std::string, std::string> sections{
      {"S001", "Title and abstract"}, {"S009", "Section 1"},  {"S018", "Section 2"},  {"S028", "Section 3"},
      {"S038", "Section 4"},          {"S066", "Section 5"},  {"S090", "Section 6"},  {"S127", "Section 7"},
      {"S132", "Appendix 1"},         {"S138", "Appendix 2"}, {"S144", "Appendix 3"}, {"S151", "Appendix 4"},
      {"S154", "Appendix 5"},
  };
  const auto found = sections.find(id);
  return found == sections.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

const std::vector<PrintedStatement>& printed_statements() {
  static const std::vector<PrintedStatement> all = [] {
    std::vector<PrintedStatement> joined = statements_of_model();
    for (const std::vector<PrintedStatement>& more :
         {statements_of_orbits(), statements_of_nonsticking_orbits(), statements_of_appendices()}) {
      joined.insert(joined.end(), more.begin(), more.end());
    }
    std::string section;
    for (PrintedStatement& statement : joined) {
      section = begins(statement.id).value_or(section);
      statement.section = section;
    }
    return joined;
  }();
  return all;
}

bool is_stated(const std::string& claim) {
  return std::ranges::any_of(printed_statements(), [&](const PrintedStatement& statement) {
    return std::ranges::find(statement.claims, claim) != statement.claims.end();
  });
}

}  // namespace stickslip::proofs::pascal2012
