/* A library that is no controller. */
int nothing(void) { return 0; }
