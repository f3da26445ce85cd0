#ifndef auxfem_parameters_declare_h
#define auxfem_parameters_declare_h

#include <deal.II/base/parameter_handler.h>

#include <limits>
#include <string>
#include <vector>

/**
 * @file
 * Parameters as plugin files declare and read them:
 * @code
 * const Quantity stiffness{"Stiffness", "20 kN/m", "N/m", Range::positive(),
 *                          "Stiffness of the spring."};
 * void declare_spring(ParameterHandler &prm) { declare(prm, stiffness); }
 * ... get(prm, stiffness) ...   // 20000., always SI
 * @endcode
 * Pattern, unit, range and sentence are one object, so what is checked, what
 * is converted and what the reference shows cannot part. Every get() reads
 * from the subsection @p prm is in, as every declare() writes to it.
 */
namespace auxfem
{
  /** Numbers allowed for a quantity, in its declared unit. */
  struct Range
  {
    double minimum      = -std::numeric_limits<double>::infinity();
    double maximum      = std::numeric_limits<double>::infinity();
    bool   minimum_open = false; ///< the minimum itself is not allowed
    bool   maximum_open = false; ///< the maximum itself is not allowed

    /** All finite numbers. */
    static Range any();
    /** > 0. */
    static Range positive();
    /** >= 0. */
    static Range non_negative();
    /** Both bounds allowed. */
    static Range closed(double minimum, double maximum);
    /** Neither bound allowed. */
    static Range open(double minimum, double maximum);

    bool contains(double value) const;

    /**
     * The range in words of mathematics, e.g. `> 0 and <= 90`; empty for
     * any().
     */
    std::string text() const;
  };

  /** A number with a unit. */
  struct Quantity
  {
    std::string name;
    /** As a user would write it, e.g. `70 GPa`; empty: the user must give it.
     */
    std::string default_value;
    /** Unit of a number without unit word and of the range; `1` for none. */
    std::string unit;
    Range       range;
    /** One sentence for the parameter reference. */
    std::string sentence;
    /** Words allowed in place of a number, e.g. `auto`; see is_word(). */
    std::vector<std::string> words = {};
  };

  /**
   * Several numbers of one unit: `1, 2 mm, 3` or, without commas, `1 2 mm 3`.
   * An empty default is an empty list if @p minimum_length is 0, else the user
   * must give it.
   */
  struct QuantityList
  {
    std::string  name;
    std::string  default_value;
    std::string  unit;
    Range        range;
    unsigned int minimum_length;
    unsigned int maximum_length;
    std::string  sentence;
    /** Words allowed in place of the numbers, e.g. `auto`; see is_word(). */
    std::vector<std::string> words = {};
  };

  /** A whole number. */
  struct Integer
  {
    std::string  name;
    unsigned int default_value;
    unsigned int minimum;
    unsigned int maximum;
    std::string  sentence;
  };

  /** `true` or `false`. */
  struct Boolean
  {
    std::string name;
    bool        default_value;
    std::string sentence;
  };

  /** One word out of several. */
  struct Choice
  {
    std::string name;
    /** Empty: the user must choose. */
    std::string              default_value;
    std::vector<std::string> choices;
    std::string              sentence;
  };

  /** Free text, checked by whoever uses it (names of sets, file names, ...). */
  struct Text
  {
    std::string name;
    std::string default_value;
    std::string sentence;
    /** The user must give it; @p default_value is then empty. */
    bool required = false;
  };

  /**
   * A function of time as text: an expression in `t`, a table, or a number with
   * a unit word. Expressions and tables are in the SI unit of @p unit. See
   * loads/time_function.h.
   */
  struct TimeExpression
  {
    std::string name;
    std::string default_value;
    std::string unit;
    std::string sentence;
    /** Words allowed in place of a function, e.g. `free`. */
    std::vector<std::string> words = {};
  };

  /** @name Declare an entry in the current subsection of @p prm. */
  ///@{
  void declare(dealii::ParameterHandler &prm, const Quantity &entry);
  void declare(dealii::ParameterHandler &prm, const QuantityList &entry);
  void declare(dealii::ParameterHandler &prm, const Integer &entry);
  void declare(dealii::ParameterHandler &prm, const Boolean &entry);
  void declare(dealii::ParameterHandler &prm, const Choice &entry);
  void declare(dealii::ParameterHandler &prm, const Text &entry);
  void declare(dealii::ParameterHandler &prm, const TimeExpression &entry);
  ///@}

  /**
   * @name Value of an entry in the current subsection of @p prm.
   * Quantities come in SI (angles in rad). A function of time comes as the text
   * for TimeFunction, a number with a unit word already converted to SI.
   * Throws InputError if the text does not match, which cannot happen after
   * @p prm itself has accepted it.
   */
  ///@{
  double              get(dealii::ParameterHandler &prm, const Quantity &entry);
  std::vector<double> get(dealii::ParameterHandler &prm,
                          const QuantityList       &entry);
  unsigned int        get(dealii::ParameterHandler &prm, const Integer &entry);
  bool                get(dealii::ParameterHandler &prm, const Boolean &entry);
  std::string         get(dealii::ParameterHandler &prm, const Choice &entry);
  std::string         get(dealii::ParameterHandler &prm, const Text &entry);
  std::string get(dealii::ParameterHandler &prm, const TimeExpression &entry);
  ///@}

  /** Whether the value of @p entry is one of its words instead of a number. */
  bool is_word(dealii::ParameterHandler &prm, const Quantity &entry);

  /** Whether the value of @p entry is one of its words instead of numbers. */
  bool is_word(dealii::ParameterHandler &prm, const QuantityList &entry);

  /** Whether the value of @p entry is one of its words instead of a function. */
  bool is_word(dealii::ParameterHandler &prm, const TimeExpression &entry);
} // namespace auxfem

#endif
