#include <auxfem/loads/expression_tree.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <functional>
#include <map>
#include <string>

#include <muParser.h>

namespace auxfem
{
  namespace
  {
    using Operation = ExpressionTree::Operation;
    using Index     = ExpressionTree::Index;
    using Operands  = std::vector<Index>;

    /** Adds a function of muParser, or of ours, to a tree. */
    using Function = std::function<Index(ExpressionTree &, const Operands &)>;

    Function unary(const Operation operation)
    {
      return [operation](ExpressionTree &tree, const Operands &x) {
        return tree.add(operation, {x[0]});
      };
    }

    Index negative(ExpressionTree &tree, const Index x)
    {
      return tree.add(Operation::subtract, {tree.constant(0), x});
    }

    /** Whether the truth value @p x is zero. */
    Index opposite(ExpressionTree &tree, const Index x)
    {
      return tree.add(Operation::equal, {x, tree.constant(0)});
    }

    Index sum(ExpressionTree &tree, const Operands &x)
    {
      Index result = x[0];
      for (std::size_t i = 1; i < x.size(); ++i)
        result = tree.add(Operation::add, {result, x[i]});
      return result;
    }

    Index average(ExpressionTree &tree, const Operands &x)
    {
      return tree.add(Operation::divide,
                      {sum(tree, x), tree.constant(x.size())});
    }

    Index largest_of(ExpressionTree &tree, const Operands &x)
    {
      Index result = x[0];
      for (std::size_t i = 1; i < x.size(); ++i)
        result = tree.add(Operation::maximum, {result, x[i]});
      return result;
    }

    Index smallest_of(ExpressionTree &tree, Operands x)
    {
      for (Index &i : x)
        i = negative(tree, i);
      return negative(tree, largest_of(tree, x));
    }

    Index absolute(ExpressionTree &tree, const Operands &x)
    {
      return largest_of(tree, {x[0], negative(tree, x[0])});
    }

    Index sign(ExpressionTree &tree, const Operands &x)
    {
      const Index zero = tree.constant(0);
      return tree.add(Operation::subtract,
                      {tree.add(Operation::less, {zero, x[0]}),
                       tree.add(Operation::less, {x[0], zero})});
    }

    Index ceiling(ExpressionTree &tree, const Operands &x)
    {
      return negative(tree, tree.add(Operation::floor, {negative(tree, x[0])}));
    }

    Index nearest_integer(ExpressionTree &tree, const Operands &x)
    {
      return tree.add(Operation::floor,
                      {tree.add(Operation::add, {x[0], tree.constant(0.5)})});
    }

    Index square_root(ExpressionTree &tree, const Operands &x)
    {
      return tree.add(Operation::power, {x[0], tree.constant(0.5)});
    }

    Index logarithm(ExpressionTree &tree, const Index x, const double base)
    {
      return tree.add(Operation::divide,
                      {tree.add(Operation::log, {x}),
                       tree.constant(std::log(base))});
    }

    Index tangent(ExpressionTree &tree, const Operands &x)
    {
      return tree.add(Operation::divide,
                      {tree.add(Operation::sin, {x[0]}),
                       tree.add(Operation::cos, {x[0]})});
    }

    Index arc_cosine(ExpressionTree &tree, const Operands &x)
    {
      return tree.add(Operation::subtract,
                      {tree.constant(dealii::numbers::PI_2),
                       tree.add(Operation::asin, {x[0]})});
    }

    /** The angle of the point (x, y) for the operands y, x. */
    Index angle(ExpressionTree &tree, const Operands &operands)
    {
      const Index y = operands[0], x = operands[1], zero = tree.constant(0);
      const auto  arc_tangent = [&tree](const Index a, const Index b) {
        return tree.add(Operation::atan, {tree.add(Operation::divide, {a, b})});
      };
      const auto quarter_minus = [&](const double quarter) {
        return tree.add(Operation::subtract,
                        {tree.constant(quarter), arc_tangent(x, y)});
      };
      const Index left = tree.add(Operation::choose,
                                  {tree.add(Operation::less, {y, zero}),
                                   quarter_minus(-dealii::numbers::PI_2),
                                   quarter_minus(dealii::numbers::PI_2)});
      return tree.add(Operation::choose,
                      {tree.add(Operation::less, {zero, x}),
                       arc_tangent(y, x),
                       left});
    }

    /** Functions by the names under which the parser knows them. */
    const std::map<std::string, Function> &functions()
    {
      static const std::map<std::string, Function> map = {
        {"abs", &absolute},
        {"acos", &arc_cosine},
        {"acosh", unary(Operation::acosh)},
        {"asin", unary(Operation::asin)},
        {"asinh", unary(Operation::asinh)},
        {"atan", unary(Operation::atan)},
        {"atan2", &angle},
        {"atanh", unary(Operation::atanh)},
        {"avg", &average},
        {"ceil", &ceiling},
        {"cos", unary(Operation::cos)},
        {"cosh", unary(Operation::cosh)},
        {"exp", unary(Operation::exp)},
        {"floor", unary(Operation::floor)},
        {"if",
         [](ExpressionTree &tree, const Operands &x) {
           return tree.add(Operation::choose, x);
         }},
        {"ln", unary(Operation::log)},
        {"log", unary(Operation::log)},
        {"log10",
         [](ExpressionTree &tree, const Operands &x) {
           return logarithm(tree, x[0], 10);
         }},
        {"log2",
         [](ExpressionTree &tree, const Operands &x) {
           return logarithm(tree, x[0], 2);
         }},
        {"max", &largest_of},
        {"min", &smallest_of},
        {"pow",
         [](ExpressionTree &tree, const Operands &x) {
           return tree.add(Operation::power, x);
         }},
        {"rint", &nearest_integer},
        {"sign", &sign},
        {"sin", unary(Operation::sin)},
        {"sinh", unary(Operation::sinh)},
        {"sqrt", &square_root},
        {"sum", &sum},
        {"tan", &tangent},
        {"tanh", unary(Operation::tanh)}};
      return map;
    }

    void *address(const mu::SToken &token)
    {
      return reinterpret_cast<void *>(token.Fun.cb._pRawFun);
    }

    /** Address of the minus sign, of which parsers have no list. */
    void *address_of_minus()
    {
      double     x = 0;
      mu::Parser parser;
      parser.DefineVar("x", &x);
      parser.SetExpr("-x");
      parser.Eval();
      return address(parser.GetByteCode().GetBase()[1]);
    }

    /** Builds a tree from the reverse Polish notation of muParser. */
    class ByteCodeReader
    {
    public:
      explicit ByteCodeReader(const mu::Parser &parser)
        : code(parser.GetByteCode().GetBase())
      {
        for (const auto &[name, function] : parser.GetFunDef())
          names[function.GetAddr()] = name;
        minus = address_of_minus();
        time  = tree.add(Operation::time, {});

        std::size_t end = 0;
        while (code[end].Cmd != mu::cmEND)
          ++end;
        read(0, end);
        tree.set_root(pop());
      }

      ExpressionTree tree;

    private:
      void read(const std::size_t begin, const std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
          if (code[i].Cmd == mu::cmIF)
            i = read_choice(i);
          else
            stack.push_back(read_token(code[i]));
      }

      /** `condition ? a : b` with its `?` at @p begin; returns its end. */
      std::size_t read_choice(const std::size_t begin)
      {
        const std::size_t colon = begin + code[begin].Oprt.offset;
        const std::size_t end   = colon + code[colon].Oprt.offset;
        read(begin + 1, colon);
        read(colon + 1, end);
        stack.push_back(tree.add(Operation::choose, pop(3)));
        return end;
      }

      Index read_token(const mu::SToken &token)
      {
        switch (token.Cmd)
          {
            case mu::cmVAL:
              return tree.constant(token.Val.data2);
            case mu::cmVAR:
              return time;
            case mu::cmVARPOW2:
              return power_of_time(2);
            case mu::cmVARPOW3:
              return power_of_time(3);
            case mu::cmVARPOW4:
              return power_of_time(4);
            case mu::cmVARMUL:
              return tree.add(Operation::add,
                              {tree.add(Operation::multiply,
                                        {time, tree.constant(token.Val.data)}),
                               tree.constant(token.Val.data2)});
            case mu::cmFUNC:
              return read_function(token);
            default:
              return read_operator(token.Cmd);
          }
      }

      Index power_of_time(const int exponent)
      {
        return tree.add(Operation::power, {time, tree.constant(exponent)});
      }

      Index read_function(const mu::SToken &token)
      {
        // The number of arguments is negative where any is allowed.
        const Operands operands = pop(std::abs(token.Fun.argc));
        if (address(token) == minus)
          return negative(tree, operands[0]);
        const std::string name = names.at(address(token));
        AssertThrow(functions().count(name) != 0,
                    dealii::ExcMessage("This version of muParser has the "
                                       "function " +
                                       name + ", which auxfem does not know."));
        return functions().at(name)(tree, operands);
      }

      Index read_operator(const mu::ECmdCode code)
      {
        const Operands x = pop(2), reversed = {x[1], x[0]};
        switch (code)
          {
            case mu::cmADD:
              return tree.add(Operation::add, x);
            case mu::cmSUB:
              return tree.add(Operation::subtract, x);
            case mu::cmMUL:
              return tree.add(Operation::multiply, x);
            case mu::cmDIV:
              return tree.add(Operation::divide, x);
            case mu::cmPOW:
              return tree.add(Operation::power, x);
            case mu::cmLT:
              return tree.add(Operation::less, x);
            case mu::cmGT:
              return tree.add(Operation::less, reversed);
            case mu::cmLE:
              return opposite(tree, tree.add(Operation::less, reversed));
            case mu::cmGE:
              return opposite(tree, tree.add(Operation::less, x));
            case mu::cmEQ:
              return tree.add(Operation::equal, x);
            case mu::cmNEQ:
              return opposite(tree, tree.add(Operation::equal, x));
            case mu::cmLAND:
              return opposite(tree,
                              either(opposite(tree, x[0]),
                                     opposite(tree, x[1])));
            case mu::cmLOR:
              return either(opposite(tree, opposite(tree, x[0])),
                            opposite(tree, opposite(tree, x[1])));
            default:
              AssertThrow(false,
                          dealii::ExcMessage(
                            "The compiled form of an expression has the "
                            "unknown code " +
                            std::to_string(code) + "."));
          }
        return 0;
      }

      /** Whether one of two truth values, 0 or 1, is 1. */
      Index either(const Index a, const Index b)
      {
        return opposite(tree, opposite(tree, tree.add(Operation::add, {a, b})));
      }

      Operands pop(const std::size_t n)
      {
        const Operands top(stack.end() - n, stack.end());
        stack.resize(stack.size() - n);
        return top;
      }

      Index pop()
      {
        return pop(1).front();
      }

      const mu::SToken *const       code;
      std::map<void *, std::string> names;
      void                         *minus;
      Index                         time;
      Operands                      stack;
    };
  } // namespace

  ExpressionTree read_expression(const mu::Parser &parser)
  {
    return ByteCodeReader(parser).tree;
  }
} // namespace auxfem
