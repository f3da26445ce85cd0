#include <auxfem/loads/expression_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    enum class Truth
    {
      no,
      yes,
      unknown
    };

    Truth truth(const bool holds)
    {
      return holds ? Truth::yes : Truth::no;
    }

    Truth less(const double a, const double b)
    {
      return truth(a < b);
    }

    Truth less(const Interval &a, const Interval &b)
    {
      if (a.upper() < b.lower())
        return Truth::yes;
      return a.lower() >= b.upper() ? Truth::no : Truth::unknown;
    }

    Truth equal(const double a, const double b)
    {
      return truth(a == b);
    }

    Truth equal(const Interval &a, const Interval &b)
    {
      if (a.upper() < b.lower() || b.upper() < a.lower())
        return Truth::no;
      return a.lower() == a.upper() && b.lower() == b.upper() ? Truth::yes
                                                              : Truth::unknown;
    }

    /** Numbers from the least to the greatest of @p a and @p b. */
    Interval span(const Interval &a, const Interval &b)
    {
      return hull(a, b);
    }

    /** At a single time the truth is known and there is nothing to span. */
    double span(const double, const double)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }

    Interval maximum(const Interval &a, const Interval &b)
    {
      return max(a, b);
    }

    double maximum(const double a, const double b)
    {
      return std::max(a, b);
    }

    template <typename Number>
    Number anything()
    {
      const double infinity = std::numeric_limits<double>::infinity();
      return span(Number(-infinity), Number(infinity));
    }

    /** A value that may jump, of which there are no derivatives. */
    template <typename Number>
    Jet<Number> jumping(const Number &value)
    {
      return {value, anything<Number>(), anything<Number>()};
    }

    template <typename Number>
    Jet<Number>
    choose(const Truth choice, const Jet<Number> &yes, const Jet<Number> &no)
    {
      if (choice == Truth::unknown)
        return jumping(span(yes.value, no.value));
      return choice == Truth::yes ? yes : no;
    }

    template <typename Number>
    Jet<Number> greater(const Truth        second_is_greater,
                        const Jet<Number> &a,
                        const Jet<Number> &b)
    {
      if (second_is_greater == Truth::unknown)
        return {maximum(a.value, b.value),
                span(a.first, b.first),
                anything<Number>()};
      return second_is_greater == Truth::yes ? b : a;
    }

    Jet<double> floor(const double x)
    {
      return {std::floor(x)};
    }

    Jet<Interval> floor(const Interval &x)
    {
      const Interval value(std::floor(x.lower()), std::floor(x.upper()));
      return value.lower() == value.upper() ? Jet<Interval>{value}
                                            : jumping(value);
    }

    /** The divisor of a limit: on the side of zero where @p beside is. */
    Jet<double> divisor(Jet<double> x, const Jet<double> &beside)
    {
      x.value = std::copysign(x.value, beside.value);
      return x;
    }

    Jet<Interval> divisor(const Jet<Interval> &x, const Jet<Interval> &)
    {
      return x;
    }
  } // namespace

  ExpressionTree::Index ExpressionTree::add(const Operation           operation,
                                            const std::vector<Index> &operands)
  {
    // Bounds would not tell that an operand is equal to itself.
    if (operands.size() == 2 && operands[0] == operands[1])
      switch (operation)
        {
          case Operation::subtract:
          case Operation::less:
            return constant(0);
          case Operation::equal:
            return constant(1);
          case Operation::maximum:
            return operands[0];
          default:
            break;
        }

    // Unused positions repeat the first operand.
    Node node{operation, 0, {}};
    if (!operands.empty())
      node.operands.fill(operands.front());
    std::copy(operands.begin(), operands.end(), node.operands.begin());

    const auto known =
      std::find_if(nodes.begin(), nodes.end(), [&node](const Node &other) {
        return other.operation == node.operation &&
          other.operands == node.operands;
      });
    if (known != nodes.end())
      return known - nodes.begin();

    const bool fixed = !operands.empty() &&
      std::all_of(operands.begin(), operands.end(), [this](const Index i) {
        return is_constant(i);
      });
    if (fixed)
      return constant(evaluate(node, 0., evaluate(0.), evaluate(0.)).value);
    nodes.push_back(node);
    note_switch(nodes.size() - 1);
    return nodes.size() - 1;
  }

  ExpressionTree::Index ExpressionTree::constant(const double value)
  {
    const auto known =
      std::find_if(nodes.begin(), nodes.end(), [value](const Node &node) {
        return node.operation == Operation::constant && node.constant == value;
      });
    if (known != nodes.end())
      return known - nodes.begin();
    nodes.push_back({Operation::constant, value, {}});
    return nodes.size() - 1;
  }

  void ExpressionTree::note_switch(const Index node)
  {
    const std::array<Index, 3> &operands = nodes[node].operands;
    switch (nodes[node].operation)
      {
        case Operation::less:
        case Operation::maximum:
          switching.push_back({node, false, false});
          break;
        case Operation::divide:
          if (!is_constant(operands[1]))
            switching.push_back({node, false, false});
          break;
        case Operation::floor:
          switching.push_back({node, true, false});
          break;
        case Operation::power:
          {
            const double exponent = nodes[operands[1]].constant;
            if (!is_constant(operands[1]) || exponent < 0 ||
                exponent != std::floor(exponent))
              switching.push_back({node, false, true});
            break;
          }
        case Operation::log:
        case Operation::asin:
        case Operation::acosh:
          switching.push_back({node, false, true});
          break;
        default:
          break;
      }
  }

  template <typename Number>
  Jet<Number> ExpressionTree::margin(const Index         node,
                                     const Jets<Number> &jets) const
  {
    const Jet<Number> &a = jets[nodes[node].operands[0]];
    const Jet<Number> &b = jets[nodes[node].operands[1]];
    switch (nodes[node].operation)
      {
        case Operation::less:
        case Operation::maximum:
          return a - b;
        case Operation::divide:
          return b;
        case Operation::asin:
          return Jet<Number>{Number(1)} - power(a, 2);
        case Operation::acosh:
          return a - Jet<Number>{Number(1)};
        default:
          return a;
      }
  }

  template <typename Number>
  Jet<Number> ExpressionTree::power_of(const Node         &node,
                                       const Jets<Number> &jets) const
  {
    const Jet<Number> &base     = jets[node.operands[0]];
    const Jet<Number> &exponent = jets[node.operands[1]];
    if (is_constant(node.operands[1]))
      return power(base, nodes[node.operands[1]].constant);
    return exp(exponent * log(base));
  }

  template <typename Number>
  Jet<Number> ExpressionTree::evaluate(const Node         &node,
                                       const Number       &t,
                                       const Jets<Number> &jets,
                                       const Jets<Number> &beside) const
  {
    const auto &[i, j, k] = node.operands;
    switch (node.operation)
      {
        case Operation::time:
          return {t, Number(1)};
        case Operation::constant:
          return {Number(node.constant)};
        case Operation::add:
          return jets[i] + jets[j];
        case Operation::subtract:
          return jets[i] - jets[j];
        case Operation::multiply:
          return jets[i] * jets[j];
        case Operation::divide:
          return jets[i] / divisor(jets[j], beside[j]);
        case Operation::power:
          return power_of(node, jets);
        case Operation::maximum:
          return greater(less(beside[i].value, beside[j].value),
                         jets[i],
                         jets[j]);
        case Operation::less:
          return choose(less(beside[i].value, beside[j].value),
                        Jet<Number>{Number(1)},
                        Jet<Number>{Number(0)});
        case Operation::equal:
          return choose(equal(beside[i].value, beside[j].value),
                        Jet<Number>{Number(1)},
                        Jet<Number>{Number(0)});
        case Operation::choose:
          return choose(equal(beside[i].value, Number(0)), jets[k], jets[j]);
        case Operation::floor:
          return floor(beside[i].value);
        case Operation::exp:
          return exp(jets[i]);
        case Operation::log:
          return log(jets[i]);
        case Operation::sin:
          return sin(jets[i]);
        case Operation::cos:
          return cos(jets[i]);
        case Operation::asin:
          return asin(jets[i]);
        case Operation::atan:
          return atan(jets[i]);
        case Operation::sinh:
          return sinh(jets[i]);
        case Operation::cosh:
          return cosh(jets[i]);
        case Operation::tanh:
          return tanh(jets[i]);
        case Operation::asinh:
          return asinh(jets[i]);
        case Operation::acosh:
          return acosh(jets[i]);
        case Operation::atanh:
          return atanh(jets[i]);
      }
    return {};
  }

  template <typename Number>
  ExpressionTree::Jets<Number> ExpressionTree::evaluate(const Number &t) const
  {
    Jets<Number> jets(nodes.size());
    for (Index i = 0; i < nodes.size(); ++i)
      jets[i] = evaluate(nodes[i], t, jets, jets);
    return jets;
  }

  ExpressionTree::Jets<double>
  ExpressionTree::evaluate(const double t, const Jets<double> &beside) const
  {
    Jets<double> jets(nodes.size());
    for (Index i = 0; i < nodes.size(); ++i)
      jets[i] = evaluate(nodes[i], t, jets, beside);
    return jets;
  }

  template ExpressionTree::Jets<double>
  ExpressionTree::evaluate(const double &) const;
  template ExpressionTree::Jets<Interval>
                         ExpressionTree::evaluate(const Interval &) const;
  template Jet<double>   ExpressionTree::margin(Index,
                                              const Jets<double> &) const;
  template Jet<Interval> ExpressionTree::margin(Index,
                                                const Jets<Interval> &) const;
} // namespace auxfem
