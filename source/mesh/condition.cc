#include <auxfem/mesh/condition.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include <muParser.h>

namespace auxfem
{
  namespace
  {
    /** An `=` that assigns. muParser would set x and select nothing. */
    bool has_assignment(const std::string &text)
    {
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '=')
          {
            if (i + 1 < text.size() && text[i + 1] == '=')
              ++i;
            else if (i == 0 ||
                     std::string("<>!").find(text[i - 1]) == std::string::npos)
              return true;
          }
      return false;
    }
  } // namespace

  std::array<dealii::Point<3>, 2> bounding_box(const Lattice &lattice)
  {
    dealii::Point<3> low = lattice.joints.front(), high = low;
    for (const auto &joint : lattice.joints)
      for (unsigned int d = 0; d < 3; ++d)
        {
          low[d]  = std::min(low[d], joint[d]);
          high[d] = std::max(high[d], joint[d]);
        }
    return {{low, high}};
  }

  bool is_condition(const std::string &text)
  {
    return text.find_first_of("<>=!&|()?") != std::string::npos;
  }

  class Condition::Implementation
  {
  public:
    Implementation(const std::string  &text,
                   const Lattice      &lattice,
                   const SceneContext &context,
                   const std::string  &path)
      : text(text)
      , path(path)
    {
      if (has_assignment(text))
        fail("a single \"=\" does not compare; write \"==\", better "
             "\"abs(y - ymax) < 1e-6\" for places");
      try
        {
          define_names(bounding_box(lattice), context);
          parser.SetExpr(text);
          parser.Eval();
        }
      catch (const mu::ParserError &error)
        {
          std::string problem = error.GetMsg();
          if (!problem.empty() && problem.back() == '.')
            problem.pop_back();
          fail(problem);
        }
    }

    bool holds_at(const dealii::Point<3> &at)
    {
      place              = at;
      const double value = parser.Eval();
      if (std::isnan(value))
        fail("its value at (" + std::to_string(at[0]) + ", " +
             std::to_string(at[1]) + ", " + std::to_string(at[2]) +
             ") m is not a number");
      return value != 0.;
    }

  private:
    void define_names(const std::array<dealii::Point<3>, 2> &box,
                      const SceneContext                    &context)
    {
      parser.DefineConst("pi", dealii::numbers::PI);
      for (const auto &[name, value] : context.constants)
        parser.DefineConst(name, value);
      for (unsigned int d = 0; d < 3; ++d)
        {
          const std::string axis(1, "xyz"[d]);
          define_own(axis + "min", box[0][d], context);
          define_own(axis + "max", box[1][d], context);
          refuse_constant(axis, context);
          parser.DefineVar(axis, &place[d]);
        }
    }

    void define_own(const std::string  &name,
                    const double        value,
                    const SceneContext &context)
    {
      refuse_constant(name, context);
      parser.DefineConst(name, value);
    }

    void refuse_constant(const std::string  &name,
                         const SceneContext &context) const
    {
      for (const auto &constant : context.constants)
        if (constant.first == name)
          fail("the scene's constant \"" + name +
               "\" hides the place of that name; rename the constant");
    }

    [[noreturn]] void fail(const std::string &problem) const
    {
      throw InputError(path + ": the condition \"" + text +
                       "\" cannot be used: " + problem +
                       ".\nKnown in conditions are x, y, z (m), xmin, xmax, "
                       "ymin, ymax, zmin, zmax, pi and the scene's constants; "
                       "they are compared by <, <=, >, >=, ==, != and joined "
                       "by && and ||.");
    }

    const std::string text;
    const std::string path;
    dealii::Point<3>  place;
    mu::Parser        parser;
  };

  Condition::Condition(const std::string  &text,
                       const Lattice      &lattice,
                       const SceneContext &context,
                       const std::string  &path)
    : implementation(
        std::make_unique<Implementation>(text, lattice, context, path))
  {}

  Condition::~Condition() = default;

  bool Condition::holds_at(const dealii::Point<3> &place)
  {
    return implementation->holds_at(place);
  }
} // namespace auxfem
