#ifndef auxfem_parameters_parameter_h
#define auxfem_parameters_parameter_h

#include <limits>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * A parameter is one object: name, default, unit, range, sentence of the
 * reference, and the conversion of its text to a value. One declaration
 * therefore serves checks, conversion and reference. See parameter_values.h.
 * @code
 * const Quantity stiffness{"Stiffness", "20 kN/m", "N/m", Range::positive(),
 *                          "Stiffness of the spring."};
 * ... values[stiffness] ...   // 20000., always SI
 * @endcode
 */
namespace auxfem
{
  /** Numbers allowed for a parameter, in its declared unit. */
  struct Range
  {
    double minimum      = -std::numeric_limits<double>::infinity();
    double maximum      = std::numeric_limits<double>::infinity();
    bool   minimum_open = false; ///< the minimum itself is not allowed
    bool   maximum_open = false; ///< the maximum itself is not allowed

    /** All finite numbers. */
    static Range any()
    {
      return {};
    }

    /** > 0. */
    static Range positive();
    /** >= 0. */
    static Range non_negative();
    /** Both bounds allowed. */
    static Range closed(const double minimum, const double maximum)
    {
      return {minimum, maximum, false, false};
    }

    /** Neither bound allowed. */
    static Range open(const double minimum, const double maximum)
    {
      return {minimum, maximum, true, true};
    }

    bool contains(double value) const;

    /** The range as text, e.g. `> 0 and <= 90`; empty for any(). */
    std::string text() const;
  };

  /** Members common to all kinds of parameters. */
  struct Parameter
  {
    enum class Kind
    {
      quantity,
      quantity_list,
      integer,
      choice,
      text,
      time_expression
    };

    std::string name;
    /** Default as a user would write it, e.g. `70 GPa`. */
    std::string default_value;
    /** One sentence for the parameter reference. */
    std::string sentence;

    Kind kind = Kind::text;
    /** Unit of a number without unit word and of the range; `1` for none. */
    std::string unit  = "1";
    Range       range = {};
    /** Words allowed in place of numbers, or the choices. */
    std::vector<std::string> words = {};
    /** Whether the user must give a value; the default is then empty. */
    bool required = false;
    /** Least and greatest number of list items. */
    unsigned int minimum_length = 0, maximum_length = 0;

    /**
     * Clause of an error message that names the problem with @p text; empty if
     * it is valid. An empty text is a problem where there is a default: an
     * empty line does not select it.
     */
    std::string problem(const std::string &text) const;

    /**
     * The value @p text of a number or a list of numbers with the results in SI
     * in place of expressions of @p constants; items of a list that are
     * expressions are separated by commas. Unchanged where there are none and
     * where an expression is not understood.
     */
    std::string with_constants(
      const std::string                                 &text,
      const std::vector<std::pair<std::string, double>> &constants) const;

    /** Description of allowed values, e.g. `a number > 0 in m`. */
    std::string allowed() const;

    /** allowed() and the unit words that fit. */
    std::string allowed_with_units() const;

    bool is_word(const std::string &text) const;
  };

  using Parameters = std::vector<Parameter>;

  /** A number with a unit. */
  struct Quantity : Parameter
  {
    /**
     * Without a default the parameter is required. Words, e.g. `auto`, may
     * replace the number.
     */
    Quantity(const std::string              &name,
             const std::string              &default_value,
             const std::string              &unit,
             const Range                    &range,
             const std::string              &sentence,
             const std::vector<std::string> &words = {});

    /** Value in SI (angles in rad). Throws InputError for a word. */
    double value(const std::string &text) const;
  };

  /**
   * Several numbers of one unit: `1, 2 mm, 3`, or without commas `1 2 mm 3`.
   */
  struct QuantityList : Parameter
  {
    /**
     * An empty default means an empty list if @p minimum_length is 0, else a
     * required parameter. Words may replace the numbers.
     */
    QuantityList(const std::string              &name,
                 const std::string              &default_value,
                 const std::string              &unit,
                 const Range                    &range,
                 unsigned int                    minimum_length,
                 unsigned int                    maximum_length,
                 const std::string              &sentence,
                 const std::vector<std::string> &words = {});

    /** Value in SI (angles in rad). Throws InputError for a word. */
    std::vector<double> value(const std::string &text) const;
  };

  /** A whole number. */
  struct Integer : Parameter
  {
    /** Words, e.g. `auto`, may replace the number. */
    Integer(const std::string              &name,
            unsigned int                    default_value,
            unsigned int                    minimum,
            unsigned int                    maximum,
            const std::string              &sentence,
            const std::vector<std::string> &words = {});

    /** Integer whose default is a word. */
    Integer(const std::string              &name,
            const std::string              &default_word,
            unsigned int                    minimum,
            unsigned int                    maximum,
            const std::string              &sentence,
            const std::vector<std::string> &words);

    unsigned int value(const std::string &text) const;
  };

  /** `true` or `false`. */
  struct Boolean : Parameter
  {
    Boolean(const std::string &name,
            bool               default_value,
            const std::string &sentence);

    bool value(const std::string &text) const
    {
      return text == "true";
    }
  };

  /** One word out of several. */
  struct Choice : Parameter
  {
    /** Without a default the parameter is required. */
    Choice(const std::string              &name,
           const std::string              &default_value,
           const std::vector<std::string> &choices,
           const std::string              &sentence);

    std::string value(const std::string &text) const
    {
      return text;
    }
  };

  /** Free text, checked by its reader (names of sets, file names, ...). */
  struct Text : Parameter
  {
    Text(const std::string &name,
         const std::string &default_value,
         const std::string &sentence,
         bool               required = false);

    std::string value(const std::string &text) const
    {
      return text;
    }
  };

  /**
   * A function of time as text: an expression in `t`, a table, or a number with
   * a unit word. Expressions and tables use the SI unit that corresponds to the
   * declared one. See loads/time_function.h.
   */
  struct TimeExpression : Parameter
  {
    /**
     * Without a default the parameter is required. Words, e.g. `free`, may
     * replace the function.
     */
    TimeExpression(const std::string              &name,
                   const std::string              &default_value,
                   const std::string              &unit,
                   const std::string              &sentence,
                   const std::vector<std::string> &words = {});

    /** Text for TimeFunction; a number with a unit word is converted to SI. */
    std::string value(const std::string &text) const;
  };

  /** Items separated by `, `, cut after @p maximum of them with `, ...`. */
  std::string joined(const std::vector<std::string> &items,
                     std::size_t                     maximum = 1000);
} // namespace auxfem

#endif
