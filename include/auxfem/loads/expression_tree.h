#ifndef auxfem_loads_expression_tree_h
#define auxfem_loads_expression_tree_h

#include <auxfem/loads/jet.h>

#include <array>
#include <cstddef>
#include <vector>

namespace mu
{
  class Parser;
}

namespace auxfem
{
  /**
   * An expression of time as a tree of operations, which can be evaluated with
   * exact derivatives, over spans of time, and with the branches taken at
   * another time. It knows which of its operations switch, i.e. are smooth but
   * where a function of their operands, the margin, passes through zero.
   */
  class ExpressionTree
  {
  public:
    enum class Operation
    {
      time,
      constant,
      add,
      subtract,
      multiply,
      divide,
      power,
      maximum,
      less,   ///< 1 if the first operand is less, else 0
      equal,  ///< 1 or 0
      choose, ///< second operand if the first is not zero, else the third
      floor,
      exp,
      log,
      sin,
      cos,
      asin,
      atan,
      sinh,
      cosh,
      tanh,
      asinh,
      acosh,
      atanh
    };

    /** Position of a node in the tree; operands come before what uses them. */
    using Index = std::size_t;

    /** An operation that may switch. */
    struct Switch
    {
      Index node;
      bool  at_integers;  ///< margin passes an integer rather than zero
      bool  when_touched; ///< also where the margin only touches zero
    };

    /** Jets of all nodes at a time or over a span of time. */
    template <typename Number>
    using Jets = std::vector<Jet<Number>>;

    /**
     * The node of @p operation on @p operands, one to three except for time;
     * equal nodes are kept once and operations on constants carried out.
     */
    Index add(Operation operation, const std::vector<Index> &operands);

    /** The node of a constant. */
    Index constant(double value);

    /** Makes @p node the value of the expression. */
    void set_root(const Index node)
    {
      root = node;
    }

    /** All nodes at the time, or over the span of time, @p t. */
    template <typename Number>
    Jets<Number> evaluate(const Number &t) const;

    /**
     * All nodes at time @p t with the branches taken in @p beside: limits at t
     * from the side of another time, between which and t nothing switches.
     */
    Jets<double> evaluate(double t, const Jets<double> &beside) const;

    /** Of the jets of all nodes that of the expression. */
    template <typename Number>
    const Jet<Number> &result(const Jets<Number> &jets) const
    {
      return jets[root];
    }

    /** Operations that may switch. */
    const std::vector<Switch> &switches() const
    {
      return switching;
    }

    /** Margin of the switching operation @p node. */
    template <typename Number>
    Jet<Number> margin(Index node, const Jets<Number> &jets) const;

  private:
    struct Node
    {
      Operation            operation;
      double               constant;
      std::array<Index, 3> operands;
    };

    bool is_constant(const Index node) const
    {
      return nodes[node].operation == Operation::constant;
    }

    void note_switch(Index node);

    template <typename Number>
    Jet<Number> evaluate(const Node         &node,
                         const Number       &t,
                         const Jets<Number> &jets,
                         const Jets<Number> &beside) const;

    template <typename Number>
    Jet<Number> power_of(const Node &node, const Jets<Number> &jets) const;

    Index               root = 0;
    std::vector<Node>   nodes;
    std::vector<Switch> switching;
  };

  /**
   * The tree of an expression that @p parser has evaluated before, from its
   * compiled form. The only variable is time.
   */
  ExpressionTree read_expression(const mu::Parser &parser);
} // namespace auxfem

#endif
