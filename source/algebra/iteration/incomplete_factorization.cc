#include <Ifpack2_Factory.hpp>

#include "tpetra_types.h"

namespace auxfem
{
  Teuchos::RCP<TpetraOperator>
  make_incomplete_factorization(const Teuchos::RCP<TpetraMatrix> &matrix)
  {
    const auto factorization =
      Ifpack2::Factory::create<Tpetra::RowMatrix<double>>("SCHWARZ", matrix);
    Teuchos::ParameterList list;
    list.set("schwarz: overlap level", 1);
    list.set("schwarz: use reordering", true);
    list.set("subdomain solver name", "RILUK");
    list.sublist("subdomain solver parameters")
      .set("fact: iluk level-of-fill", 1);
    factorization->setParameters(list);
    factorization->initialize();
    factorization->compute();
    return factorization;
  }
} // namespace auxfem
