#include <auxfem/start_up.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <iostream>
#include <set>
#include <string>

#include <stdlib.h>
#include <unistd.h>

namespace
{
  /**
   * Replaces GoogleTest's printer on all ranks but the first: silent, except
   * for failed assertions, which may well happen on one rank only.
   */
  class FailurePrinter : public testing::EmptyTestEventListener
  {
  public:
    explicit FailurePrinter(const unsigned int rank) : rank(rank)
    {}

    void OnTestPartResult(const testing::TestPartResult &result) override
    {
      if (result.failed())
        std::cerr << "rank " << rank << ": "
                  << (result.file_name() != nullptr ? result.file_name() : "")
                  << ':' << result.line_number() << ": " << result.message()
                  << std::endl;
    }

  private:
    const unsigned int rank;
  };

  std::set<std::string> environment_names()
  {
    std::set<std::string> names;
    for (char **entry = environ; *entry != nullptr; ++entry)
      {
        const std::string text = *entry;
        names.insert(text.substr(0, text.find('=')));
      }
    return names;
  }

  /**
   * Removes the environment variables that are not in @p names. Open MPI leaves
   * some behind when a program starts without mpirun, and an mpirun that a test
   * starts would take them for those of a run it belongs to, and refuse.
   */
  void restrict_environment(const std::set<std::string> &names)
  {
    for (const std::string &name : environment_names())
      if (names.count(name) == 0)
        unsetenv(name.c_str());
  }
} // namespace

int main(int argc, char **argv)
{
  testing::InitGoogleTest(&argc, argv);

  const std::set<std::string> names = environment_names();
  if (!auxfem::has_mpi_launcher())
    auxfem::prepare_mpi_for_one_process();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  restrict_environment(names);
  // As in the program.
  auxfem::flush_denormals_to_zero();

  // A violated assertion of deal.II then is a failed test, not the end of all.
  dealii::deal_II_exceptions::disable_abort_on_exception();

  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  if (rank != 0)
    {
      testing::TestEventListeners &listeners =
        testing::UnitTest::GetInstance()->listeners();
      delete listeners.Release(listeners.default_result_printer());
      listeners.Append(new FailurePrinter(rank));
    }

  const int result = RUN_ALL_TESTS();
  return dealii::Utilities::MPI::max(result, MPI_COMM_WORLD);
}
