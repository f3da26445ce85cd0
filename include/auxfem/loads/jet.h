#ifndef auxfem_loads_jet_h
#define auxfem_loads_jet_h

#include <auxfem/loads/interval.h>

#include <cmath>

namespace auxfem
{
  /**
   * Value, first and second derivative with respect to time; Number is double,
   * or Interval for bounds of them over a span of time. Functions of jets are
   * exact (chain rule).
   */
  template <typename Number>
  struct Jet
  {
    Number value  = Number(0);
    Number first  = Number(0);
    Number second = Number(0);
  };

  namespace detail
  {
    /**
     * Product in the chain rule. Infinite derivatives of functions (the root
     * at zero) do not matter where the argument is constant.
     */
    inline double chain(const double a, const double b)
    {
      return a == 0 || b == 0 ? 0 : a * b;
    }

    inline Interval chain(const Interval &a, const Interval &b)
    {
      const auto is_zero = [](const Interval &x) {
        return x.lower() == 0 && x.upper() == 0;
      };
      return is_zero(a) || is_zero(b) ? Interval(0) : a * b;
    }
  } // namespace detail

  /** f(x) of which @p f, @p f1, @p f2 are value and derivatives at x. */
  template <typename Number>
  Jet<Number> compose(const Jet<Number> &x,
                      const Number      &f,
                      const Number      &f1,
                      const Number      &f2)
  {
    using detail::chain;
    return {f,
            chain(f1, x.first),
            chain(f2, power(x.first, 2)) + chain(f1, x.second)};
  }

  template <typename Number>
  Jet<Number> operator+(const Jet<Number> &a, const Jet<Number> &b)
  {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
  }

  template <typename Number>
  Jet<Number> operator-(const Jet<Number> &a, const Jet<Number> &b)
  {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
  }

  template <typename Number>
  Jet<Number> operator*(const Jet<Number> &a, const Jet<Number> &b)
  {
    using detail::chain;
    return {a.value * b.value,
            chain(a.first, b.value) + chain(a.value, b.first),
            chain(a.second, b.value) + 2. * chain(a.first, b.first) +
              chain(a.value, b.second)};
  }

  template <typename Number>
  Jet<Number> operator/(const Jet<Number> &a, const Jet<Number> &b)
  {
    using detail::chain;
    const Number value = a.value / b.value;
    const Number first = (a.first - chain(value, b.first)) / b.value;
    return {value,
            first,
            (a.second - 2. * chain(first, b.first) - chain(value, b.second)) /
              b.value};
  }

  /** x^p for a fixed exponent. */
  template <typename Number>
  Jet<Number> power(const Jet<Number> &x, const double p)
  {
    if (p == 0)
      return {Number(1)};
    if (p == 1)
      return x;
    return compose<Number>(x,
                           power(x.value, p),
                           p * power(x.value, p - 1),
                           p * (p - 1) * power(x.value, p - 2));
  }

  template <typename Number>
  Jet<Number> exp(const Jet<Number> &x)
  {
    using std::exp;
    const Number e = exp(x.value);
    return compose(x, e, e, e);
  }

  template <typename Number>
  Jet<Number> log(const Jet<Number> &x)
  {
    using std::log;
    return compose<Number>(x, log(x.value), 1. / x.value, -power(x.value, -2));
  }

  template <typename Number>
  Jet<Number> sin(const Jet<Number> &x)
  {
    using std::cos;
    using std::sin;
    const Number s = sin(x.value);
    return compose<Number>(x, s, cos(x.value), -s);
  }

  template <typename Number>
  Jet<Number> cos(const Jet<Number> &x)
  {
    using std::cos;
    using std::sin;
    const Number c = cos(x.value);
    return compose<Number>(x, c, -sin(x.value), -c);
  }

  template <typename Number>
  Jet<Number> asin(const Jet<Number> &x)
  {
    using std::asin;
    const Number r = 1. - power(x.value, 2);
    return compose<Number>(x,
                           asin(x.value),
                           power(r, -0.5),
                           x.value * power(r, -1.5));
  }

  template <typename Number>
  Jet<Number> atan(const Jet<Number> &x)
  {
    using std::atan;
    const Number f1 = 1. / (1. + power(x.value, 2));
    return compose<Number>(x, atan(x.value), f1, -2. * x.value * power(f1, 2));
  }

  template <typename Number>
  Jet<Number> sinh(const Jet<Number> &x)
  {
    using std::cosh;
    using std::sinh;
    const Number s = sinh(x.value);
    return compose<Number>(x, s, cosh(x.value), s);
  }

  template <typename Number>
  Jet<Number> cosh(const Jet<Number> &x)
  {
    using std::cosh;
    using std::sinh;
    const Number c = cosh(x.value);
    return compose<Number>(x, c, sinh(x.value), c);
  }

  template <typename Number>
  Jet<Number> tanh(const Jet<Number> &x)
  {
    using std::tanh;
    const Number t  = tanh(x.value);
    const Number f1 = 1. - power(t, 2);
    return compose<Number>(x, t, f1, -2. * t * f1);
  }

  template <typename Number>
  Jet<Number> asinh(const Jet<Number> &x)
  {
    using std::asinh;
    const Number r = 1. + power(x.value, 2);
    return compose<Number>(x,
                           asinh(x.value),
                           power(r, -0.5),
                           -x.value * power(r, -1.5));
  }

  template <typename Number>
  Jet<Number> acosh(const Jet<Number> &x)
  {
    using std::acosh;
    const Number r = power(x.value, 2) - 1.;
    return compose<Number>(x,
                           acosh(x.value),
                           power(r, -0.5),
                           -x.value * power(r, -1.5));
  }

  template <typename Number>
  Jet<Number> atanh(const Jet<Number> &x)
  {
    using std::atanh;
    const Number f1 = 1. / (1. - power(x.value, 2));
    return compose<Number>(x, atanh(x.value), f1, 2. * x.value * power(f1, 2));
  }
} // namespace auxfem

#endif
