// Compiled by CMake, which looks for the text in the file: that works for a foreign machine, too.
#include <Eigen/Core>

#define DIGIT(number, place) static_cast<char>('0' + (number) / (place) % 10)
#define NUMBER(number) DIGIT(number, 100), DIGIT(number, 10), DIGIT(number, 1)

const char text[] = {
  'E', 'i', 'g', 'e', 'n', '(', NUMBER(EIGEN_MAX_ALIGN_BYTES), ',', NUMBER(EIGEN_MAX_STATIC_ALIGN_BYTES), ')', 0
};

int
main(int count, char **)
{
  return text[count];
}
