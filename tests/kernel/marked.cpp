// The headers of the pair law as a compiler for devices sees them, under names of their own so that
// both versions are in one program. CMakeLists.txt has the options.

#define Lubcontact_NS Marked_NS
#define Fluid_NS MarkedFluid_NS

#include "marked_case.h"

int put_all_marked(double *out)
{
  return put_all(out);
}
