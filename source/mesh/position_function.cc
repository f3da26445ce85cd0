#include <auxfem/mesh/position_function.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  std::string position_text(const dealii::Point<3> &position,
                            const unsigned int      dimension)
  {
    std::ostringstream text;
    for (unsigned int d = 0; d < dimension; ++d)
      text << (d == 0 ? "(" : ", ") << position[d];
    text << ") m";
    return text.str();
  }

  std::array<dealii::Point<3>, 2> bounding_box(const Lattice &lattice)
  {
    dealii::Point<3> low = lattice.joints.front(), high = low;
    for (unsigned int i = 0; i < lattice.n_structural_joints(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        {
          low[d]  = std::min(low[d], lattice.joints[i][d]);
          high[d] = std::max(high[d], lattice.joints[i][d]);
        }
    return {{low, high}};
  }

  class PositionFunction::Implementation
  {
  public:
    Implementation(const std::string  &text,
                   const std::string  &noun,
                   const std::string  &hint,
                   const Lattice      &lattice,
                   const SceneContext &context,
                   const std::string  &path,
                   const Random        random)
      : is_random(random == Random::allowed &&
                  (text.find("random") != std::string::npos ||
                   text.find("normal") != std::string::npos))
      , text(text)
      , noun(noun)
      , hint(hint)
      , path(path)
      , expression(read(bounding_box(lattice), context))
    {}

    double value_at(const dealii::Point<3> &at, const unsigned int number)
    {
      position           = at;
      item               = number;
      const double value = expression.value();
      if (std::isnan(value))
        fail("its value at (" + std::to_string(at[0]) + ", " +
             std::to_string(at[1]) + ", " + std::to_string(at[2]) +
             ") m is not a number.");
      return value;
    }

    const bool is_random;

  private:
    Expression read(const std::array<dealii::Point<3>, 2> &box,
                    const SceneContext                    &context)
    {
      std::vector<Expression::Variable> coordinates;
      std::vector<Expression::Constant> bounds;
      for (unsigned int d = 0; d < 3; ++d)
        {
          const std::string axis(1, "xyz"[d]);
          coordinates.emplace_back(axis, &position[d]);
          bounds.emplace_back(axis + "min", box[0][d]);
          bounds.emplace_back(axis + "max", box[1][d]);
        }
      try
        {
          return Expression(text,
                            coordinates,
                            bounds,
                            context.constants,
                            is_random ? &item : nullptr);
        }
      catch (const ExpressionError &error)
        {
          fail(error.what() + ("\n" + error.allowed));
        }
    }

    [[noreturn]] void fail(const std::string &problem) const
    {
      throw InputError(path + ": the " + noun + " \"" + text +
                       "\" cannot be used: " + problem + "\nA " + noun +
                       " may also use x, y, z (m)." +
                       (hint.empty() ? "" : " ") + hint);
    }

    const std::string text, noun, hint, path;
    dealii::Point<3>  position;
    unsigned int      item = 0;
    Expression        expression;
  };

  PositionFunction::PositionFunction(const std::string  &text,
                                     const std::string  &noun,
                                     const std::string  &hint,
                                     const Lattice      &lattice,
                                     const SceneContext &context,
                                     const std::string  &path,
                                     const Random        random)
    : implementation(std::make_unique<Implementation>(text,
                                                      noun,
                                                      hint,
                                                      lattice,
                                                      context,
                                                      path,
                                                      random))
  {}

  PositionFunction::~PositionFunction() = default;

  double PositionFunction::value_at(const dealii::Point<3> &position,
                                    const unsigned int      item)
  {
    return implementation->value_at(position, item);
  }

  bool PositionFunction::is_random() const
  {
    return implementation->is_random;
  }

  bool is_condition(const std::string &text)
  {
    return text.find_first_of("<>=!&|()?") != std::string::npos;
  }

  Condition::Condition(const std::string  &text,
                       const Lattice      &lattice,
                       const SceneContext &context,
                       const std::string  &path)
    : function(text,
               "condition",
               "Positions are best compared by \"abs(y - ymax) < 1e-6\".",
               lattice,
               context,
               path)
  {}
} // namespace auxfem
