# SPDX-License-Identifier: Apache-2.0
# Warnings of our own code, and the sanitizers of a build that asks for them.
add_library(myoface_warnings INTERFACE)
add_library(myoface::warnings ALIAS myoface_warnings)
target_compile_options(myoface_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  # GCC 12 sees ghosts of these kinds in its own inlined std::string and std::vector.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-free-nonheap-object;-Wno-array-bounds;-Wno-stringop-overflow>
  $<$<BOOL:${MYOFACE_WERROR}>:-Werror>)
if(MYOFACE_SANITIZE)
  target_compile_options(myoface_warnings INTERFACE -fsanitize=${MYOFACE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(myoface_warnings INTERFACE -fsanitize=${MYOFACE_SANITIZE})
endif()
