/* A controller of Bladed's kind. Its first word in accINFILE says what it does:
   square K:     a generator's torque of K times the square of its speed, and no pitch;
   pitch A B W:  no torque, and pitch by the error of the rotor's speed from W, proportional A,
                 integral B;
   count:        a torque that is the number of its calls in this process;
   write:        a torque of 2 N m, and all records and its names to the file avcOUTNAME;
   warn, fail T: a message at each call; a failure from time T on;
   nan T, brake: demands that are not finite from time T on; the brake in full;
   each:         pitch angles 0.1, 0.2 and 0.3;
   yaw R:        a rate of yaw. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#define RECORD(number) swap[(number) - 1]

static int calls = 0;
static double integral = 0.0;

static void write_records(const float* swap, const char* input, const char* name) {
  FILE* file = fopen(name, calls == 1 ? "w" : "a");
  int k;
  if (!file) return;
  fprintf(file, "%s %s", input, name);
  for (k = 0; k < 1100; ++k) fprintf(file, " %.9g", swap[k]);
  fprintf(file, "\n");
  fclose(file);
}

void DISCON(float* swap, int* fail, const char* input, const char* name, char* message) {
  char what[32] = "none";
  double a = 0.0, b = 0.0, w = 0.0;
  FILE* file = fopen(input, "r");
  if (file) {
    if (fscanf(file, "%31s %lf %lf %lf", what, &a, &b, &w) < 1) strcpy(what, "none");
    fclose(file);
  }
  ++calls;
  *fail = 0;
  RECORD(47) = 0.0F;
  if (!strcmp(what, "square")) RECORD(47) = (float)(a * RECORD(20) * RECORD(20));
  if (!strcmp(what, "pitch")) {
    const double error = (double)RECORD(21) - w;
    integral += b * RECORD(3) * error;
    RECORD(45) = (float)(integral + a * error);
  }
  if (!strcmp(what, "count")) RECORD(47) = (float)calls;
  if (!strcmp(what, "write")) {
    RECORD(47) = 2.0F;
    write_records(swap, input, name);
  }
  if (!strcmp(what, "warn")) {
    strcpy(message, "a warning of the library");
    *fail = 1;
  }
  if (!strcmp(what, "fail") && RECORD(2) >= a - 1e-6) {
    strcpy(message, "a failure of the library");
    *fail = -1;
  }
  if (!strcmp(what, "nan") && RECORD(2) >= a - 1e-6) RECORD(47) = NAN;
  if (!strcmp(what, "brake")) RECORD(36) = 1.0F;
  if (!strcmp(what, "each")) {
    RECORD(42) = 0.1F;
    RECORD(43) = 0.2F;
    RECORD(44) = 0.3F;
  }
  if (!strcmp(what, "yaw")) RECORD(48) = (float)a;
}
