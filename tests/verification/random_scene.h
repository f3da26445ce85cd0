#ifndef auxfem_tests_verification_random_scene_h
#define auxfem_tests_verification_random_scene_h

#include <deal.II/base/tensor.h>

#include <support/scene_text.h>

#include <optional>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** A small scene that combines features at random. */
    struct RandomScene
    {
      SceneText text;
      bool      is_static;
      /** Sum of loads and weight at the end (N); empty if the generator does
       * not know them. */
      std::optional<dealii::Tensor<1, 3>> final_load;
      /** Names of its features, for messages. */
      std::string features;
    };

    /**
     * The scene of number @p seed: a frame of 2 to 7 struts in the plane or in
     * space, with one of each of some of hinges, springs,
     * connectors, rigid parts, plates, masses and loads, by one of the schemes.
     * Equal numbers give equal scenes on all platforms.
     */
    RandomScene random_scene(unsigned int seed);
  } // namespace testing_support
} // namespace auxfem

#endif
